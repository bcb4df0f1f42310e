// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_circuit.h"

#include "../core/electric/film_figures.h"
#include "../core/figures/contact_columns.h"
#include "../core/figures/fix_columns.h"
#include "../core/numbers/number_list.h"
#include "../core/settings/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_capacitance.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "run_phase.h"

#include <algorithm>
#include <map>
#include <tuple>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace raceway;
using bearing::Arguments;
using bearing::CircuitSettings;
using bearing::tag_t;

namespace {
constexpr int per_cycle = 8;    // minimum number of circuit points per period of the voltage
constexpr double pi = 3.14159265358979323846;
}    // namespace

// fix ID group bearing/circuit N CAPACITANCE floating V | source R | motor C_WR C_RF [keywords]
FixBearingCircuit::FixBearingCircuit(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  nevery = args.integer("steps between samples", 1, 1000000000);
  cap_id_ = args.word("ID of a fix bearing/capacitance");
  settings_ = CircuitSettings::read(args);
  bearing::check_within(args, settings_.within, nevery);
  if (!settings_.events.empty()) {
    std::string names =
        "time discharge order ball raceway azimuth bearing_voltage bearing_voltage_after "
        "film_voltage local_thickness film_energy energy";
    if (settings_.arc > 0.0) names += " current duration current_density";
    events_.open(args, settings_.events, names.c_str(), world);
  }
  restart_global = 1;
  bearing::provide_values(*this, bearing::of_fix_circuit::N, nevery);
}

int FixBearingCircuit::setmask() { return END_OF_STEP; }

void FixBearingCircuit::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/circuit");
  const int k = modify->find_fix(cap_id_.c_str());
  cap_ = k < 0 ? nullptr : dynamic_cast<FixBearingCapacitance *>(modify->fix[k]);
  if (!cap_)
    BRG_ALL(bearing::name_of(*this) + ": there is no fix bearing/capacitance '" + cap_id_ + "'");
}

void FixBearingCircuit::setup(int)
{
  if (settings_.within > 1) find_integrators();
  if (restored_) {    // values that are not in the restart file are recomputed from those that are
    last_time_ = time_of(last_step_);
    static_cast<CircuitPoint &>(state_) = point(balls_, last_time_);
    restored_ = false;
  }
  if (update->ntimestep % nevery == 0) sample();
}

void FixBearingCircuit::end_of_step() { sample(); }

// Finds the integrators that provide the instants within host steps.
void FixBearingCircuit::find_integrators()
{
  const std::string who = bearing::name_of(*this);
  integrators_ = bearing::fixes_of<bearing::InstantSource>(lmp);
  if (integrators_.empty())
    BRG_ALL(who + ": 'within " + std::to_string(settings_.within) +
            "' needs fix bearing/implicit, which provides the states within a step; with other "
            "integrators sample every step");
  bearing::Instants wanted = cap_->instants(settings_.within);
  wanted.states = needs_states();
  for (bearing::InstantSource *f : integrators_) f->want_instants(wanted, who);
}

FixBearingCircuit::Film FixBearingCircuit::film_of(const RacewayPhysics &raceway, bool live,
                                                   const ContactState &state,
                                                   const FilmCapacitorT<double> &q) const
{
  Film film;
  if (settings_.metal > 0.0 && !raceway.facts().asperities)
    BRG_ONE(bearing::name_of(*this) +
            ": 'metal' needs 'friction mixed', which computes the load share of asperities");
  const bool whole = cap_->model().surrounded();
  if (!live && !whole) return film;
  film.capacitance = whole ? q.total() : q.capacitance;
  film.thickness = whole ? q.separation : q.h_c;
  film.rough = settings_.rough ? film_peaks * raceway.roughness : 0.0;
  if (settings_.metal > 0.0 && live && state.asperity_share > settings_.metal_share)
    film.metal = 1.0 / settings_.metal;
  if (settings_.arc > 0.0 && live) film.area = hertz_area(raceway, state);
  return film;
}

// Returns the balls of the group and their current films, sorted by tag, on every rank.
std::vector<FixBearingCircuit::BallFilms> FixBearingCircuit::find_balls()
{
  std::vector<tag_t> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if ((atom->mask[i] & groupbit) && pair_->coefficients().is_ball(atom->type[i])) {
      if (!cap_->covers(i))
        BRG_ONE(bearing::name_of(*this) + ": ball " + std::to_string(atom->tag[i]) +
                " is not in the group of fix " + cap_id_);
      mine.push_back(atom->tag[i]);
    }
  std::vector<tag_t> tags = bearing::gather_all(mine, world);
  std::sort(tags.begin(), tags.end());
  std::vector<Row> rows;
  for (const bearing::RacewayContact &c : pair_->table().raceway)
    if (atom->mask[c.i_ball] & groupbit) {
      const Vec3 from_ring = Vec3::from(atom->x[c.i_ball]) - Vec3::from(atom->x[c.i_ring]);
      rows.push_back({c.ball, c.ring, c.side() == Side::outer,
                      bearing::azimuth(from_ring, pair_->coefficients().axis_index()),
                      film_of(*c.raceway, c.live, c.state, cap_->capacitor(c))});
    }
  return balls_of(tags, std::move(rows));
}

// Returns the balls of the last sample as they were at an instant within the last step. `instant`
// is counted from 1.
std::vector<FixBearingCircuit::BallFilms> FixBearingCircuit::balls_at(int instant)
{
  std::vector<tag_t> tags;
  for (const BallFilms &b : balls_) tags.push_back(static_cast<tag_t>(b.tag));
  std::vector<Row> rows;
  std::map<tag_t, Vec3> body, ring;
  const auto contact = [&](const bearing::InstantContact &c) {
    if (std::binary_search(tags.begin(), tags.end(), c.ball))
      rows.push_back({c.ball, c.ring, c.raceway.groove.side == Side::outer, 0.0,
                      film_of(c.raceway, c.live, c.state, c.capacitor)});
  };
  for (const bearing::InstantSource *f : integrators_)
    f->read_instant(instant, {contact, [&](const bearing::InstantBody &b) { body[b.tag] = b.x; },
                              [&](const bearing::InstantRing &r) {
                                using namespace bearing::of_ring;
                                ring[static_cast<tag_t>(r.of[RING])] = {r.of[X], r.of[Y], r.of[Z]};
                              }});
  for (Row &row : rows)
    row.azimuth =
        bearing::azimuth(body.at(row.ball) - ring.at(row.ring), pair_->coefficients().axis_index());
  return balls_of(tags, std::move(rows));
}

void FixBearingCircuit::Film::add(const Film &beside)
{
  if (!(beside.capacitance > 0.0)) return;
  if (!(capacitance > 0.0 && thickness - rough <= beside.thickness - beside.rough)) {
    thickness = beside.thickness;
    rough = beside.rough;
  }
  capacitance += beside.capacitance;
  metal += beside.metal;
  area += beside.area;
}

// Returns the balls sorted by tag, built from the films sampled on all ranks.
std::vector<FixBearingCircuit::BallFilms>
FixBearingCircuit::balls_of(const std::vector<tag_t> &tags, std::vector<Row> mine) const
{
  std::vector<Row> rows = bearing::gather_all(mine, world);
  std::sort(rows.begin(), rows.end(), [](const Row &a, const Row &b) {
    return std::make_tuple(a.ball, a.side, a.ring) < std::make_tuple(b.ball, b.side, b.ring);
  });
  std::vector<BallFilms> balls;
  for (tag_t tag : tags) {
    balls.push_back({});
    balls.back().tag = tag;
  }
  tag_t ring[2] = {-1, -1};
  for (const Row &row : rows) {
    if (ring[row.side] >= 0 && ring[row.side] != row.ring)
      BRG_ALL(bearing::name_of(*this) + ": group " + group->names[igroup] +
              " has balls on ring atoms " + std::to_string(ring[row.side]) + " and " +
              std::to_string(row.ring) + "; give each bearing a group and a fix");
    ring[row.side] = row.ring;
    const size_t k = std::lower_bound(tags.begin(), tags.end(), row.ball) - tags.begin();
    balls[k].azimuth = row.azimuth;    // measured about the axis of the outer ring, which comes
                                       // last
    balls[k].film[row.side].add(row.film);
  }
  return balls;
}

void FixBearingCircuit::sample()
{
  if (begun_ && update->ntimestep == last_step_) return;
  const std::vector<BallFilms> now = find_balls();
  if (!begun_) {
    if (now.empty())
      BRG_ALL(bearing::name_of(*this) + ": group " + group->names[igroup] + " has no balls");
    check_group();
    first_step_ = update->ntimestep;
    dt_ = update->dt;
    last_time_ = 0.0;
    begin_circuit(state_, point(now, 0.0), settings_.start,
                  [&](const FilmFailure &f) { tell(f, now, 0.0); });
    require_films(now, 0.0);
    begun_ = true;
  } else {
    const auto same = [](const BallFilms &a, const BallFilms &b) { return a.tag == b.tag; };
    if (!std::equal(now.begin(), now.end(), balls_.begin(), balls_.end(), same))
      BRG_ALL(bearing::name_of(*this) + ": group " + group->names[igroup] +
              " no longer has the same balls as at the previous sample");
    if (update->ntimestep < last_step_ || update->dt != dt_)
      BRG_ALL(bearing::name_of(*this) +
              ": the step must not go back, nor the time step change: step " +
              std::to_string(last_step_) + " with " + bearing::text(dt_) + " s, then step " +
              std::to_string(update->ntimestep) + " with " + bearing::text(update->dt) + " s");
    for (int k = 1; k < settings_.within; ++k) {
      const double back = double(settings_.within - k) / settings_.within;
      const std::vector<BallFilms> then = balls_at(k);
      advance(then, time_of(update->ntimestep, back));
      balls_ = then;
    }
    advance(now, time_of(update->ntimestep));
  }
  balls_ = now;
  last_step_ = update->ntimestep;
  if (FILE *f = events_.file())
    if (update->ntimestep == update->laststep) fflush(f);
}

void FixBearingCircuit::advance(const std::vector<BallFilms> &to, double time)
{
  const double start = last_time_, sampled = time - start;
  const double shortest = settings_.voltage.shortest();
  const double least = per_cycle * sampled / shortest * (1.0 - 1e-9);
  if (settings_.points < least)
    BRG_ALL(bearing::name_of(*this) + ": a sample takes " + bearing::text(sampled) +
            " s, a period of the voltage " + bearing::text(shortest) +
            " s: 'points' must be at least " + bearing::text(std::ceil(least)) + ", not " +
            std::to_string(settings_.points));
  double before = start;
  for (int k = 1; k <= settings_.points; ++k) {
    const double share = double(k) / settings_.points;
    const double at = k == settings_.points ? time : start + share * sampled;
    double here = before;
    std::vector<BallFilms> there;
    const auto point_at = [&](double t) {
      here = t;
      there = t == time ? to : between(balls_, to, t == at ? share : (t - start) / sampled);
      return point(there, t);
    };
    advance_circuit(state_, before, at, settings_.voltage.edges(before, at), point_at,
                    [&](const FilmFailure &f) { tell(f, there, here); });
    require_films(there, at);
    before = at;
  }
  last_time_ = time;
}

CircuitPoint FixBearingCircuit::point(const std::vector<BallFilms> &at, double time) const
{
  const BearingFilms f = films(at);
  return {f, settings_.at(time, bearing_capacitance(f))};
}

// Stops with an error if a charged ball has no films.
void FixBearingCircuit::require_films(const std::vector<BallFilms> &at, double time) const
{
  const int lost = charged_without_film(state_);
  if (lost >= 0)
    BRG_ALL(bearing::name_of(*this) + ": ball " + std::to_string(int(at[lost].tag)) +
            " has a charge of " + bearing::text(state_.charge.ball[lost]) + " C and no film at " +
            bearing::text(time) + " s: specify a stray capacitance");
}

// Converts sampled films to films of the circuit model.
BearingFilms FixBearingCircuit::films(const std::vector<BallFilms> &balls) const
{
  const auto film = [this](const Film &f) {
    CircuitFilm made;
    made.capacitance = f.capacitance + settings_.stray;
    made.conductance = f.metal;
    if (settings_.resistivity > 0.0)
      made.conductance += f.capacitance / (settings_.resistivity * vacuum_permittivity *
                                           cap_->model().permittivity);
    if (settings_.breaks_down() && made.capacitance > 0.0)
      made.limit = film_limit(f.thickness, settings_.strength, f.rough, settings_.film_floor);
    return made;
  };
  BearingFilms all;
  for (const BallFilms &b : balls) all.push_back({film(b.film[0]), film(b.film[1])});
  return all;
}

// Interpolates the films between two samples at the fraction `share`. A film that is missing in
// either sample has no thickness in the result.
std::vector<FixBearingCircuit::BallFilms>
FixBearingCircuit::between(const std::vector<BallFilms> &from, const std::vector<BallFilms> &to,
                           double share)
{
  const auto mix = [share](double a, double b) { return a + share * (b - a); };
  std::vector<BallFilms> all = to;
  for (size_t k = 0; k < all.size(); ++k) {
    const double turn = to[k].azimuth - from[k].azimuth;
    const double azimuth =
        from[k].azimuth + share * (turn - 2.0 * pi * std::round(turn / (2.0 * pi)));
    all[k].azimuth = azimuth - 2.0 * pi * std::round(azimuth / (2.0 * pi));
    for (int side = 0; side < 2; ++side) {
      const Film &a = from[k].film[side], &b = to[k].film[side];
      all[k].film[side] = {mix(a.capacitance, b.capacitance), mix(a.thickness, b.thickness),
                           std::fmax(a.rough, b.rough), mix(a.metal, b.metal), mix(a.area, b.area)};
    }
  }
  return all;
}

void FixBearingCircuit::tell(const FilmFailure &f, const std::vector<BallFilms> &at, double time)
{
  FILE *file = events_.file();
  if (!file) return;
  const BallFilms &ball = at[f.ball];
  const Film &film = ball.film[f.at_outer];
  const double local = local_thickness(film.thickness, film.rough, settings_.film_floor);
  fprintf(file, "%.12g %.0f %d %.0f %d %.12g %.12g %.12g %.12g %.12g %.12g %.12g", time,
          state_.account.discharges + 1.0, f.order, ball.tag, static_cast<int>(f.at_outer),
          ball.azimuth, f.ring_voltage, f.ring_voltage_after, f.film_voltage, local, f.film_energy,
          f.energy);
  if (settings_.arc > 0.0) {
    double area = 0.0;
    for (const BallFilms &b : at) area += b.film[0].area + b.film[1].area;
    const ArcCurrent arc(f, settings_.arc);
    fprintf(file, " %.12g %.12g %.12g", arc.peak, arc.duration, arc.peak / area);
  }
  fputc('\n', file);
}

double FixBearingCircuit::compute_scalar()
{
  return compute_vector(bearing::of_fix_circuit::VOLTAGE);
}

double FixBearingCircuit::compute_vector(int k)
{
  using namespace bearing::of_fix_circuit;
  if (!begun_) return 0.0;
  const CircuitAccount &a = state_.account;
  switch (k) {
    case VOLTAGE: return state_.voltage.ring;
    case DRIVING: return state_.outer.driving;
    case CAPACITANCE: return bearing_capacitance(state_.films);
    case RATIO: return settings_.voltage_ratio(state_.outer, bearing_capacitance(state_.films));
    case THRESHOLD: {
      const double v = threshold_voltage(state_.films, settings_.bridged());
      return std::isinf(v) ? 0.0 : v;
    }
    case DISCHARGES: return a.discharges;
    case FAILURES: return a.failures;
    case DISCHARGE_ENERGY: return a.discharge_energy;
    case SOURCE_WORK: return a.source_work;
    case MECHANICAL_WORK: return a.mechanical_work;
    case LEAK_HEAT: return a.leak_heat;
    case RESISTOR_HEAT: return a.resistor_heat;
    case STORED: return stored_energy(state_.films, state_.outer, state_.voltage);
    case CHARGE_ERROR: return a.charge_error;
    case ENERGY_ERROR: return a.energy_error;
    case CURRENT: return a.current;
  }
  return 0.0;
}

// Names the last sample and the state of the circuit at that sample. The films and the outer
// circuit follow from these.
template <class List> void FixBearingCircuit::keep(List &list)
{
  size_t n = balls_.size();
  list(begun_, n, first_step_, last_step_, dt_, state_.charge.ring, state_.voltage.ring,
       state_.account);
  balls_.resize(n);
  state_.charge.ball.resize(n);
  state_.voltage.ball.resize(n);
  for (size_t k = 0; k < n; ++k) list(balls_[k], state_.charge.ball[k], state_.voltage.ball[k]);
}

void FixBearingCircuit::write_restart(FILE *fp)
{
  bearing::NumberWriter list;
  keep(list);
  if (comm->me == 0) list.write(fp);
}

void FixBearingCircuit::restart(char *buf)
{
  bearing::NumberReader list(buf);
  keep(list);
  restored_ = begun_;
}
