// SPDX-License-Identifier: GPL-2.0-or-later
// Set-up of the pair style: commands, coefficients, restart. The step itself is in
// pair_bearing_compute.cpp, the contact search in pair_bearing_contacts.cpp.
#include "pair_bearing_hertz.h"

#include "../core/contact/part_table.h"
#include "../core/settings/arguments.h"
#include "../core/settings/raceway_options.h"
#include "fixes.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::Arguments;
using bearing::text;

static constexpr double shortest_step = 1e-15;    // s

PairBearingHertz::PairBearingHertz(LAMMPS *lmp) : Pair(lmp), ring_sum_(lmp)
{
  single_enable = 0;
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
}

PairBearingHertz::~PairBearingHertz()
{
  // Modify may be gone already when the host shuts down
  if (modify && modify->nfix && modify->find_fix(FixBearingState::fixed_id) >= 0)
    modify->delete_fix(FixBearingState::fixed_id);
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

PairBearingHertz *PairBearingHertz::find(LAMMPS *lmp, const std::string &asked_by)
{
  PairBearingHertz *p = dynamic_cast<PairBearingHertz *>(lmp->force->pair);
  if (!p) BRG_ALL_OF(lmp, asked_by + " needs pair_style bearing/hertz or bearing/ehd before it");
  return p;
}

void PairBearingHertz::allocate()
{
  const int n = atom->ntypes + 1;
  allocated = 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  // types that no pair_coeff names do not interact: that is a complete statement, not a missing one
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      setflag[i][j] = 1;
      cutsq[i][j] = 0.0;
    }
  ring_type_.assign(n, 0);
  ball_type_.assign(n, 0);
  type_radius_.assign(n, 0.0);
}

// pair_style bearing/hertz [axis x|y|z] [overlap_limit F] [raceway keywords]
void PairBearingHertz::settings(int narg, char **arg)
{
  said_.assign(1, std::vector<std::string>(arg, arg + narg));
  defaults_ = RacewayPhysics();
  if (with_film_) defaults_.parts = initial_parts(true);
  raceways_.clear();
  spheres_.clear();
  axis_ = 2;
  overlap_limit_ = 0.05;
  std::fill(ring_type_.begin(), ring_type_.end(), 0);
  std::fill(ball_type_.begin(), ball_type_.end(), 0);
  Arguments args(lmp, std::string("pair_style ") + (with_film_ ? "bearing/ehd" : "bearing/hertz"),
                 narg, arg, 0);
  while (args.more()) {
    if (args.take("axis")) axis_ = args.choice("axis", {"x", "y", "z"});
    else if (args.take("overlap_limit")) overlap_limit_ = args.within("overlap_limit", 1e-4, 0.5);
    else if (!bearing::read_raceway_keyword(args, with_film_, defaults_))
      args.unknown("axis, overlap_limit, " + bearing::raceway_keywords(with_film_));
  }
}

// pair_coeff BALL RING inner|outer R r_c [gothic_arch G] [keywords]
// or pair_coeff I J sphere E1 nu1 E2 nu2 [printed]
void PairBearingHertz::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  said_.emplace_back(arg, arg + narg);
  std::string command = "pair_coeff";
  for (int k = 0; k < narg && k < 3; ++k) command += std::string(" ") + arg[k];
  Arguments args(lmp, command, narg, arg, 0);
  const int i = args.integer("first type", 1, atom->ntypes),
            j = args.integer("second type", 1, atom->ntypes);
  const int role = args.choice("role", {"inner", "outer", "sphere"});
  if (role == 2) {
    read_sphere(args, i, j);
    return;
  }
  if (i == j) args.fail("ball and ring need different atom types");
  if (raceway(j, i))
    args.fail("the ball type comes first, and an earlier pair_coeff has it second");
  RacewayPhysics p = defaults_;
  p.groove.side = role == 0 ? Side::inner : Side::outer;
  p.groove.raceway_radius = args.positive("raceway radius (m)");
  p.groove.groove_radius = args.positive("groove radius (m)");
  if (p.groove.groove_radius >= p.groove.raceway_radius)
    args.fail("groove radius " + text(p.groove.groove_radius) +
              " must be smaller than the raceway radius " + text(p.groove.raceway_radius));
  double arch = 0.0;
  while (args.more()) {
    if (args.take("gothic_arch"))
      arch = args.positive("distance of the groove centres from the ring's middle plane (m)");
    else if (!bearing::read_raceway_keyword(args, with_film_, p))
      args.unknown("gothic_arch, " + bearing::raceway_keywords(with_film_));
  }
  if (with_film_ && p.model.lubricant.viscosity == 0.0)
    args.fail("bearing/ehd needs 'lubricant VISCOSITY PRESSURE_VISCOSITY' here or in pair_style; "
              "without a "
              "lubricant use bearing/hertz");
  if (with_film_ && p.ring_roughness == 0.0)
    args.fail("bearing/ehd needs 'roughness RACEWAY BALL' (m) here or in pair_style: it sets the "
              "lambda ratio "
              "and the floor of the film damper");
  raceways_.erase({i, j, 1});
  p.groove.offset = -arch;
  raceways_[{i, j, 0}] = p;
  if (arch > 0.0) {
    p.number = 1;
    p.groove.offset = arch;
    raceways_[{i, j, 1}] = p;
  }
  ball_type_[i] = ring_type_[j] = 1;
  if (ball_type_[j] || ring_type_[i]) args.fail("a type cannot be both ball and ring");
}

void PairBearingHertz::read_sphere(Arguments &args, int i, int j)
{
  Sphere s;
  s.E1 = args.positive("Young's modulus of the first type (Pa)");
  s.nu1 = args.within("Poisson's ratio of the first type", 0.0, 0.5);
  s.E2 = args.positive("Young's modulus of the second type (Pa)");
  s.nu2 = args.within("Poisson's ratio of the second type", 0.0, 0.5);
  // eq 3 as printed has an extra 1/(1 - nu), nu of the rolling ball: the first type given
  s.factor = args.take("printed") ? 1.0 / (1.0 - s.nu1) : 1.0;
  if (args.more()) args.unknown("printed");
  spheres_[{std::min(i, j), std::max(i, j)}] = s;
}

Vec3 PairBearingHertz::axis() const
{
  return {axis_ == 0 ? 1.0 : 0.0, axis_ == 1 ? 1.0 : 0.0, axis_ == 2 ? 1.0 : 0.0};
}

double PairBearingHertz::pitch_radius(int ring_type) const
{
  for (const auto &own : raceways_) {
    if (own.first.ring != ring_type) continue;
    for (const auto &other : raceways_)
      if (other.first.ball == own.first.ball && other.second.groove.side != own.second.groove.side)
        return 0.5 * (own.second.groove.raceway_radius + other.second.groove.raceway_radius);
    const double sign = own.second.groove.side == Side::inner ? 1.0 : -1.0;
    return own.second.groove.raceway_radius + sign * own.second.groove.ball_radius;
  }
  return 0.0;
}

const RacewayPhysics *PairBearingHertz::raceway(int ball_type, int ring_type, int groove) const
{
  auto it = raceways_.find({ball_type, ring_type, groove});
  return it == raceways_.end() ? nullptr : &it->second;
}

bool PairBearingHertz::many_grooves() const
{
  return std::any_of(raceways_.begin(), raceways_.end(),
                     [](const auto &entry) { return entry.first.number > 0; });
}

std::vector<const RacewayPhysics *> PairBearingHertz::raceways_of(int ring_type) const
{
  std::vector<const RacewayPhysics *> list;
  for (const auto &r : raceways_)
    if (r.first.ring == ring_type) list.push_back(&r.second);
  return list;
}

std::vector<const RacewayPhysics *> PairBearingHertz::raceways_under(int ball_type) const
{
  std::vector<const RacewayPhysics *> list;
  for (const auto &r : raceways_)
    if (r.first.ball == ball_type) list.push_back(&r.second);
  return list;
}

void PairBearingHertz::add_profile(bearing::tag_t ring, const RacewayPhysics &p,
                                   const ProfileShape &shape)
{
  profiles_.emplace(
      std::make_pair(ring, &p),
      RacewayProfile(shape, p.groove.raceway_radius, p.rolling_radius(1.0), p.law.radial().a));
}

const RacewayProfile *PairBearingHertz::profile(bearing::tag_t ring, const RacewayPhysics *p) const
{
  const auto it = profiles_.find({ring, p});
  return it == profiles_.end() ? nullptr : &it->second;
}

void PairBearingHertz::add_profile(bearing::tag_t ball, const RacewayPhysics &p,
                                   const BallShape &shape)
{
  ball_profiles_.emplace(std::make_pair(ball, &p),
                         BallProfile(shape, p.groove.ball_radius, p.rolling_radius(1.0),
                                     p.law.radial().a, p.law.radial().K));
}

const BallProfile *PairBearingHertz::ball_profile(bearing::tag_t ball,
                                                  const RacewayPhysics *p) const
{
  const auto it = ball_profiles_.find({ball, p});
  return it == ball_profiles_.end() ? nullptr : &it->second;
}

bool PairBearingHertz::smooth_friction(double creep)
{
  bool changed = false;
  for (auto &entry : raceways_) {
    RacewayPhysics &p = entry.second;
    if (!p.facts().tangential_spring) continue;
    p.smooth_friction(creep);
    law_ = p.parts;
    facts_ = law_facts(law_);
    changed = true;
  }
  return changed;
}

void PairBearingHertz::init_style()
{
  if (strcmp(update->unit_style, "si") != 0)
    BRG_ALL(std::string("pair_style bearing needs 'units si', not 'units ") + update->unit_style +
            "'");
  if (!atom->radius_flag || !atom->rmass_flag || !atom->torque_flag || !atom->omega_flag)
    BRG_ALL("pair_style bearing needs atom_style sphere (granular in LIGGGHTS): balls turn");
  if (force->newton_pair)
    BRG_ALL("pair_style bearing needs 'newton off': the owner of a ball computes its contacts");
  if (domain->xperiodic || domain->yperiodic || domain->zperiodic)
    BRG_ALL("pair_style bearing needs 'boundary f f f' (or m, s): a bearing is not periodic");
  if (raceways_.empty())
    BRG_ALL("pair_style bearing: no raceway; give pair_coeff BALL RING inner|outer ...");
  if (!(update->dt >= shortest_step))
    BRG_ALL("timestep is " + text(update->dt) + " s, must be at least " + text(shortest_step) +
            " s: time would not go on");
  time_.go_on(*update);
  comm->ghost_velocity = 1;
  BRG_REQUEST_HALF();
  prepare_raceways();
  implicit_bits_ = 0;
  for (int k = 0; k < modify->nfix; ++k)
    if (strcmp(modify->fix[k]->style, "bearing/implicit") == 0)
      implicit_bits_ |= modify->fix[k]->groupbit;
  capacitors_ = gaps_ = false;    // fixes bearing/capacitance are counted anew
  validity_.forget_shoulders();
  check_rings();
  check_ghosts();
  check_cages();
  profiles_.clear();    // set again by fixes bearing/profile
  ball_profiles_.clear();
  atoms_ = count_atoms();
  put_state_last();
  rebuild_ = true;
}

// The state fix puts back the forces of the step before after the set-up of every other fix, so it
// must be the last one. If fixes were defined since the run before, it is moved to the end again,
// with its state.
void PairBearingHertz::put_state_last()
{
  const int at = modify->find_fix(FixBearingState::fixed_id);
  if (at < 0 || at != modify->nfix - 1) {
    std::vector<FixBearingState::PerAtom> kept;
    if (at >= 0) {
      kept = dynamic_cast<FixBearingState *>(modify->fix[at])->per_atom();
      modify->delete_fix(FixBearingState::fixed_id);
    }
    const char *words[3] = {FixBearingState::fixed_id, "all", "bearing/state"};
    modify->add_fix(3, const_cast<char **>(words));
    if (at >= 0) dynamic_cast<FixBearingState *>(modify->fix[modify->nfix - 1])->per_atom() = kept;
  }
  state_ = dynamic_cast<FixBearingState *>(modify->fix[modify->nfix - 1]);
  state_->keep_axes();
}

// Ball radius and mass come from the atoms: one size per ball type.
void PairBearingHertz::prepare_raceways()
{
  const int n = atom->ntypes + 1;
  std::vector<double> lo(n, -HUGE_VAL), hi(n, 0.0),
      mass(n, 0.0);    // lo holds -radius: one MAX for all
  for (int i = 0; i < atom->nlocal; ++i) {
    const int t = atom->type[i];
    lo[t] = std::max(lo[t], -atom->radius[i]);
    hi[t] = std::max(hi[t], atom->radius[i]);
    mass[t] = std::max(mass[t], atom->rmass[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, lo.data(), n, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, hi.data(), n, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, mass.data(), n, MPI_DOUBLE, MPI_MAX, world);
  type_radius_ = hi;
  bool first = true;
  for (auto &entry : raceways_) {
    const int ball = entry.first.ball, ring = entry.first.ring;
    RacewayPhysics &p = entry.second;
    const std::string who = "pair_coeff " + std::to_string(ball) + " " + std::to_string(ring);
    if (hi[ball] == 0.0) BRG_ALL(who + ": there is no ball of type " + std::to_string(ball));
    if (hi[ball] + lo[ball] > 1e-12 * hi[ball])
      BRG_ALL(who + ": balls of type " + std::to_string(ball) + " have radii from " +
              text(-lo[ball]) + " to " + text(hi[ball]) + " m; give each size its own type");
    p.groove.ball_radius = hi[ball];
    if (!(p.groove.groove_radius > hi[ball] * (1.0 + 1e-9)))
      BRG_ALL(who + ": groove radius " + text(p.groove.groove_radius) +
              " m must be larger than the ball radius " + text(hi[ball]) +
              " m (a conformal groove is no Hertz point contact)");
    if (std::fabs(p.groove.offset) >= p.groove.slack())
      BRG_ALL(who + ": gothic_arch " + text(std::fabs(p.groove.offset)) +
              " m must be smaller than the groove radius less that of the ball, " +
              text(p.groove.slack()) + " m: beyond that a ball cannot be between both grooves");
    const double pitch = p.groove.side == Side::inner ? p.groove.raceway_radius + hi[ball]
                                                      : p.groove.raceway_radius - hi[ball];
    if (!(pitch > hi[ball]))
      BRG_ALL(who + ": raceway radius " + text(p.groove.raceway_radius) +
              " m leaves no pitch circle for balls of " + "radius " + text(hi[ball]) + " m");
    p.prepare(pitch, mass[ball], overlap_limit_);
    if (!first && p.parts != law_)
      BRG_ALL(who +
              ": all raceways of a run share one contact law (its numbers may differ); here " +
              law_text(p.parts) + ", before " + law_text(law_));
    law_ = p.parts;
    facts_ = law_facts(law_);
    const std::string wrong = contradiction(law_);
    if (!wrong.empty()) BRG_ALL(who + ": " + wrong);
    first = false;
  }
}

// A ball type has at most one inner and one outer ring type, and the ball fits between them.
void PairBearingHertz::check_rings()
{
  std::vector<int> rings(atom->ntypes + 1, 0);
  for (int i = 0; i < atom->nlocal; ++i) ++rings[atom->type[i]];
  MPI_Allreduce(MPI_IN_PLACE, rings.data(), atom->ntypes + 1, MPI_INT, MPI_SUM, world);
  for (const auto &a : raceways_) {
    const int ball = a.first.ball, ring = a.first.ring;
    if (rings[ring] == 0)
      BRG_ALL("missing ring: pair_coeff " + std::to_string(ball) + " " + std::to_string(ring) +
              " names ring type " + std::to_string(ring) + ", but no atom has that type");
    for (const auto &b : raceways_) {
      if (b.first.ball != ball || b.first.ring == ring) continue;
      if (a.second.groove.side == Side::inner && b.second.groove.side == Side::outer &&
          a.second.groove.raceway_radius >= b.second.groove.raceway_radius)
        BRG_ALL("two rings at odds: inner raceway radius " + text(a.second.groove.raceway_radius) +
                " m (type " + std::to_string(ring) + ") is not smaller than the outer one, " +
                text(b.second.groove.raceway_radius) + " m (type " + std::to_string(b.first.ring) +
                ")");
    }
  }
}

// The hosts take the larger of the ghost cutoff in the deck and that of the pairs; a smaller one in
// the deck is probably a mistake.
void PairBearingHertz::check_ghosts()
{
  double reach = 0.0;
  for (const auto &r : raceways_)
    reach = std::max(reach, r.second.groove.raceway_radius + r.second.groove.groove_radius);
  if (comm->cutghostuser > 0.0 && comm->cutghostuser < reach)
    BRG_ALL("pair_style bearing: the ghost cutoff " + text(comm->cutghostuser) +
            " m (" BRG_GHOST_COMMAND
            " cutoff) is too small: a ball must see the centre of its ring, up to " +
            text(reach) + " m away; leave the cutoff out");
}

void PairBearingHertz::expect_sphere(int ball_type, int cage_type)
{
  cages_.insert({std::min(ball_type, cage_type), std::max(ball_type, cage_type)});
}

// Types that no pair_coeff names do not interact. For a cage that was created this is hardly
// intended.
void PairBearingHertz::check_cages()
{
  for (const TypePair &c : cages_)
    if (!spheres_.count(c) && comm->me == 0)
      BRG_WARN("cage balls pass through the balls: there is no 'pair_coeff " +
               std::to_string(c.first) + " " + std::to_string(c.second) + " sphere ...'");
  cages_.clear();    // warn once
}

bigint PairBearingHertz::count_atoms() const
{
  std::vector<char> named(atom->ntypes + 1, 0);
  for (int t = 1; t <= atom->ntypes; ++t) named[t] = ring_type_[t] || ball_type_[t];
  for (const auto &s : spheres_) named[s.first.first] = named[s.first.second] = 1;
  bigint mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) mine += named[atom->type[i]];
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

// The hosts delete an atom that leaves the box; LIGGGHTS does so silently.
void PairBearingHertz::check_atoms() const
{
  const bigint now = count_atoms();
  if (now != atoms_)
    BRG_ALL("lost " + std::to_string(atoms_ - now) + " of " + std::to_string(atoms_) +
            " balls, cage balls and rings at step " + std::to_string(update->ntimestep) +
            ": they have left the box. Speed or step too large, a cage without rails "
            "(fix bearing/cage), or a ring without a fix");
}

double PairBearingHertz::init_one(int i, int j)
{
  // A ball that touches its groove, or is as far outside as the overlap limit and half a radius, is
  // a neighbour: ghosts come from no farther than that. Spheres touch at the sum of their radii.
  double cut = 0.0;
  for (const TypePair &key : {TypePair(i, j), TypePair(j, i)}) {
    const RacewayPhysics *p = raceway(key.first, key.second);
    if (!p) continue;
    const double R = p->groove.ball_radius;
    cut = p->centre_circle + p->groove.groove_radius - R + std::max(0.5, overlap_limit_) * R;
  }
  if (spheres_.count({std::min(i, j), std::max(i, j)})) cut = type_radius_[i] + type_radius_[j];
  // balls of one type are listed as neighbours so that overlapping ones can be refused at the start
  if (i == j && ball_type_[i]) cut = 2.0 * type_radius_[i];
  state_->ghost_reach(cut);
  return cut;
}

// A restart file stores the commands themselves, which are executed again, and the simulated time.
static void write_words(FILE *fp, const std::vector<std::string> &words)
{
  const int n = static_cast<int>(words.size());
  fwrite(&n, sizeof(int), 1, fp);
  for (const std::string &w : words) {
    const int len = static_cast<int>(w.size());
    fwrite(&len, sizeof(int), 1, fp);
    fwrite(w.data(), 1, len, fp);
  }
}

void PairBearingHertz::write_restart(FILE *fp)
{
  const int n = static_cast<int>(said_.size());
  fwrite(&n, sizeof(int), 1, fp);
  for (const auto &words : said_) write_words(fp, words);
  const bearing::SimulatedTime::State time = bearing::SimulatedTime::of(*update);
  fwrite(&time, sizeof time, 1, fp);
}

void PairBearingHertz::read_restart BRG_READ_RESTART_SIG
{
  BRG_UNUSED_RESTART_ARGS;
  auto read_int = [&]() {
    int v = 0;
    if (comm->me == 0 && fread(&v, sizeof(int), 1, fp) != 1)
      BRG_ONE("pair_style bearing: restart file ends early");
    MPI_Bcast(&v, 1, MPI_INT, 0, world);
    return v;
  };
  const int n = read_int();
  for (int k = 0; k < n; ++k) {
    std::vector<std::string> words(read_int());
    for (std::string &w : words) {
      w.resize(read_int());
      if (comm->me == 0 && fread(&w[0], 1, w.size(), fp) != w.size())
        BRG_ONE("pair_style bearing: restart file ends early");
      MPI_Bcast(&w[0], static_cast<int>(w.size()), MPI_CHAR, 0, world);
    }
    std::vector<char *> arg;
    for (std::string &w : words) arg.push_back(&w[0]);
    if (k == 0) settings(static_cast<int>(arg.size()), arg.data());
    else coeff(static_cast<int>(arg.size()), arg.data());
  }
  bearing::SimulatedTime::State time;
  if (comm->me == 0 && fread(&time, sizeof time, 1, fp) != 1)
    BRG_ONE("pair_style bearing: restart file ends early");
  MPI_Bcast(&time, sizeof time, MPI_BYTE, 0, world);
  time_.read(*update, time);
}

double PairBearingHertz::memory_usage()
{
  return table_.raceway.capacity() * sizeof(bearing::RacewayContact) +
         table_.sphere.capacity() * sizeof(bearing::SphereContact);
}
