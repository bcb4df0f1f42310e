// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_cage_ring.h"

#include "../core/figures/fix_columns.h"
#include "../core/geometry/pocket_contact.h"
#include "../ranks/gather.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "named_cage.h"
#include "pair_bearing.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace raceway;
using bearing::Arguments;
using bearing::CagePockets;
using bearing::PocketRow;
using bearing::RingSum;
using bearing::tag_t;
using bearing::text;

// Overlap between a ball and its pocket above which the run stops with an error, as a fraction of
// the ball radius.
static constexpr double out_of_pocket = 0.1;

// fix ID group bearing/cage/ring BALL_TYPE pockets Z play J mass M inertia I_a I_t [across J]
// [shape cylinder|sphere] [phase PHI] [young E_ball E_cage] [poisson ...] [friction MU]
// [guide balls | inner|outer R C B N] [oil ETA X H] [churning X RHO ETA R] [planar yes|no]
// or: bearing/cage/ring NAME [cage_play J] ... of a named bearing (named_cage.h)
FixBearingCageRing::FixBearingCageRing(LAMMPS *lmp, int narg, char **arg) :
    FixBearingRing(lmp, narg, arg, Words::unread)
{
  size_vector += bearing::of_cage::N;
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  const bearing::NamedBearing *const b =
      args.more() ? bearing::find_bearing(lmp, args.next()) : nullptr;
  if (b) bearing_ = args.word("name of a bearing");
  if (b) only_type_ = b->cage;    // bearings with different names may share a group
  ball_type_ = b ? b->balls : args.integer("ball type", 1, atom->ntypes);
  if (!pair_->coefficients().is_ball(ball_type_))
    args.fail("type " + std::to_string(ball_type_) +
              " is not a ball: no pair_coeff gives it a raceway");
  if (b) cage_ = bearing::named_cage(lmp, args, *b);
  else cage_.read(args);
  settings_.program = cage_.program;
  settings_are_read();
}

int FixBearingCageRing::setmask() { return FixBearingRing::setmask() | PRE_NEIGHBOR | PRE_FORCE; }

// Returns true if no ring of the named bearing tilts or moves along its axis.
bool FixBearingCageRing::rings_stay_in_plane() const
{
  const bearing::NamedBearing &b = *bearing::find_bearing(lmp, bearing_);
  int leaves = 0;
  for (const FixBearingRing *ring : bearing::fixes_of<FixBearingRing>(lmp))
    if (ring->moves_axially() || ring->tilts())
      for (int i = 0; i < atom->nlocal; ++i)
        if (ring->moves(i) && (atom->type[i] == b.inner || atom->type[i] == b.outer)) leaves = 1;
  MPI_Allreduce(MPI_IN_PLACE, &leaves, 1, MPI_INT, MPI_MAX, world);
  return leaves == 0;
}

void FixBearingCageRing::init()
{
  if (!bearing_.empty()) {
    cage_.planar = rings_stay_in_plane();
    cage_.find_freedoms();
    settings_.program = cage_.program;
  }
  FixBearingRing::init();
  state_->follow_axes();    // the pockets rotate with the cage
  const std::string me = bearing::name_of(*this);
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i) && !pair_->coefficients().is_cage(atom->type[i]))
      BRG_ONE(me + ": atom " + std::to_string(atom->tag[i]) + " is of type " +
              std::to_string(atom->type[i]) + ", which no 'pair_coeff " +
              std::to_string(ball_type_) + " ... cage' names");
  const bearing::PairCoefficients &all = pair_->coefficients();
  double pitch = 0.0;
  for (int t = 1; t <= atom->ntypes; ++t)
    if (const RacewayPhysics *p = all.raceway(ball_type_, t)) {
      pitch = all.pitch_radius(t);
      ball_radius_ = p->groove.ball_radius;
    }
  Arguments args(lmp, me, std::vector<std::string>());
  cage_.prepare(args, ball_radius_, pitch);
  all_.of = cage_.of;
  take_oil();
  turn_to_balls();
}

void FixBearingCageRing::take_oil()
{
  const auto *pair = dynamic_cast<const PairBearing *>(force->pair);
  if (!pair || cage_.oil == 0.0) return;
  const double viscosity = std::atof(pair->oil_datum(bearing_, "viscosity").c_str()),
               density = std::atof(pair->oil_datum(bearing_, "oil_density").c_str());
  if (!(viscosity > 0.0)) return;    // the cage has no name, or the oil is that of a restart file
  const double share = viscosity / cage_.oil;
  all_.of.shear = share * cage_.of.shear;
  all_.of.film.viscosity = share * cage_.of.film.viscosity;
  all_.of.land.viscosity = viscosity;
  if (cage_.of.oil_share == 0.0) return;
  all_.of.oil_viscosity = viscosity;
  all_.of.oil_density = density;
}

// Rotates the cages of a named bearing so that a pocket is initially at the first ball. The state
// in a restart file contains the angles by which the cages have rotated since the start.
void FixBearingCageRing::turn_to_balls()
{
  const bearing::NamedBearing *const b = bearing::find_bearing(lmp, bearing_);
  if (!b) return;
  for (int i = 0; i < atom->nlocal; ++i) {
    const auto phase = b->phases.find(atom->tag[i]);
    if (moves(i) && phase != b->phases.end() && state_->angle(i) == 0.0)
      state_->ring(i).angle = phase->second;
  }
}

CageMotion FixBearingCageRing::motion(int i) const
{
  return {axes_.third(Vec3::from(atom->x[i])), axes_.third(Vec3::from(atom->v[i])),
          axes_.third(state_->axis(i)), axes_.third(Vec3::from(atom->omega[i])), state_->angle(i)};
}

// The local indices are valid until the next neighbour build.
void FixBearingCageRing::pre_neighbor()
{
  find_cells();
  find_lands();
  std::vector<PocketRow> &rows = pair_->pocket_rows();
  if (bearing::fixes_of<FixBearingCageRing>(lmp).front() == this) rows.clear();
  first_row_ = rows.size();
  for (const CagePockets::Cell &c : all_.cells) {
    rows.emplace_back();
    rows.back().ball = c.ball;
    rows.back().cage = c.cage;
    const double m = atom->rmass[c.i];
    rows.back().mass = m * all_.of.mass / (m + all_.of.mass);
  }
  for (const CagePockets::Land &l : all_.lands) {
    rows.emplace_back();
    rows.back().cage = l.cage;
    rows.back().mass = all_.of.mass;
  }
}

// Returns the local indices of the atoms, including ghosts, for which `fits` is true.
template <class Fits> static std::vector<int> atoms_that(const Atom &atom, const Fits &fits)
{
  std::vector<int> found;
  for (int j = 0; j < atom.nlocal + atom.nghost; ++j)
    if (fits(j)) found.push_back(j);
  return found;
}

// Returns the atom of `others` that is nearest to atom i and at most `reach` (m) away, or -1 if
// there is none. If two atoms are equally near, the one with the lower tag is returned.
static int nearest(const Atom &atom, int i, double reach, const std::vector<int> &others)
{
  int found = -1;
  double best = reach * reach;
  for (const int j : others) {
    if (j == i) continue;
    const Vec3 d = Vec3::from(atom.x[i]) - Vec3::from(atom.x[j]);
    const double r2 = dot(d, d);
    if (r2 < best || (r2 == best && found >= 0 && atom.tag[j] < atom.tag[found])) {
      best = r2;
      found = j;
    }
  }
  return found;
}

void FixBearingCageRing::find_cells()
{
  all_.cells.clear();
  const std::vector<int> cages = atoms_that(*atom, [this](int j) { return moves(j); });
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->type[i] != ball_type_) continue;
    // a ball is nearer to the centre of its own cage than to the centre of any other cage
    const int cage = nearest(*atom, i, 2.0 * all_.of.pitch, cages);
    if (cage < 0)
      BRG_ONE(bearing::name_of(*this) + ": ball " + std::to_string(atom->tag[i]) +
              " has no cage within two pitch radii at step " + std::to_string(update->ntimestep));
    all_.cells.push_back({i, cage, atom->tag[i], atom->tag[cage], -1});
  }
  std::sort(all_.cells.begin(), all_.cells.end(),
            [](const auto &a, const auto &b) { return a.ball < b.ball; });
}

void FixBearingCageRing::find_lands()
{
  all_.lands.clear();
  const Side side = all_.of.guide == CageRing::by_inner ? Side::inner : Side::outer;
  const std::vector<int> guides = atoms_that(*atom, [&](int j) {
    const RacewayPhysics *p = pair_->coefficients().raceway(ball_type_, atom->type[j]);
    return p && p->groove.side == side;
  });
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i)) continue;
    CagePockets::Land l = {i, -1, atom->tag[i], 0, -1, -1};
    if (all_.of.guide != CageRing::by_balls) {
      l.i_ring = nearest(*atom, i, all_.of.pitch, guides);
      if (l.i_ring < 0)
        BRG_ONE(bearing::name_of(*this) + ": cage " + std::to_string(l.cage) +
                " has no ring with a guiding land within a pitch radius");
      l.ring = atom->tag[l.i_ring];
    }
    all_.lands.push_back(l);
  }
  std::sort(all_.lands.begin(), all_.lands.end(),
            [](const auto &a, const auto &b) { return a.cage < b.cage; });
}

// Stops with an error unless every pocket contains exactly one ball.
void FixBearingCageRing::check_cells() const
{
  struct Taken {
    tag_t cage;
    int pocket;
    tag_t ball;
  };
  std::vector<Taken> taken;
  for (const CagePockets::Cell &c : all_.cells) {
    const CageMotion m = motion(c.i_cage);
    const Vec3 d = axes_.third(Vec3::from(atom->x[c.i])) - m.x;
    taken.push_back({c.cage, pocket_at(all_.of, m, d), c.ball});
  }
  taken = bearing::gather_all(taken, world);
  std::sort(taken.begin(), taken.end(), [](const Taken &a, const Taken &b) {
    return a.cage != b.cage       ? a.cage < b.cage
           : a.pocket != b.pocket ? a.pocket < b.pocket
                                  : a.ball < b.ball;
  });
  const std::string me = bearing::name_of(*this) + ": ";
  for (size_t k = 1; k < taken.size(); ++k)
    if (taken[k].cage == taken[k - 1].cage && taken[k].pocket == taken[k - 1].pocket)
      BRG_ALL(me + "balls " + std::to_string(taken[k - 1].ball) + " and " +
              std::to_string(taken[k].ball) + " are both in pocket " +
              std::to_string(taken[k].pocket + 1) + " of cage " + std::to_string(taken[k].cage));
  for (size_t first = 0; first < taken.size();) {
    size_t end = first;
    while (end < taken.size() && taken[end].cage == taken[first].cage) ++end;
    if (static_cast<int>(end - first) != all_.of.pockets)
      BRG_ALL(me + "cage " + std::to_string(taken[first].cage) + " has " +
              std::to_string(all_.of.pockets) + " pockets, but its bearing " +
              std::to_string(end - first) + " balls");
    first = end;
  }
}

void FixBearingCageRing::setup_pre_force(int vflag)
{
  pair_->state()->forward_axes();
  check_cells();
  pre_force(vflag);
}

void FixBearingCageRing::pre_force(int)
{
  pair_->state()->forward_axes();
  pocket_forces();
  land_forces();
}

void FixBearingCageRing::pocket_forces()
{
  PocketRow *row = pair_->pocket_rows().data() + first_row_;
  for (CagePockets::Cell &c : all_.cells) {
    if (c.claim < 0)
      c.claim = pair_->ring_sum().claim(c.cage, state_->owner(c.i_cage), RingSum::pocket, c.ball);
    const CageMotion m = motion(c.i_cage);
    const PocketBall ball = {
        axes_.third(Vec3::from(atom->x[c.i])), axes_.third(Vec3::from(atom->v[c.i])),
        axes_.third(Vec3::from(atom->omega[c.i])), ball_radius_, atom->rmass[c.i]};
    const int pocket = pocket_at(all_.of, m, ball.x - m.x);
    const PocketContact p = pocket_contact(all_.of, m, pocket, ball);
    const double overlap = p.gap.overlap;
    if (!(overlap < out_of_pocket * ball_radius_)) left_pocket(c, pocket, overlap);
    const bool touches = p.wall.h.force > 0.0;
    axes_.lab(p.force()).add_to(atom->f[c.i]);
    axes_.lab(p.ball_torque()).add_to(atom->torque[c.i]);
    pair_->ring_sum().add(c.claim, axes_.lab(-p.force()), axes_.lab(p.cage_moment()));
    row->stiffness = touches ? p.wall.h.stiffness : 0.0;
    row->damping = (touches ? p.wall.h.damping : 0.0) + p.oil.resistance();
    row->force = p.push();
    row->loss = p.loss();
    ++row;
  }
}

void FixBearingCageRing::land_forces()
{
  PocketRow *row = pair_->pocket_rows().data() + first_row_ + all_.cells.size();
  RingSum &sums = pair_->ring_sum();
  eccentricity_ = 0.0;
  for (CagePockets::Land &l : all_.lands) {
    if (l.claim < 0) {
      l.claim = sums.claim(l.cage, comm->me, RingSum::land, l.ring);
      if (l.i_ring >= 0)
        l.ring_claim = sums.claim(l.ring, state_->owner(l.i_ring), RingSum::land, l.cage);
    }
    const CageMotion m = motion(l.i_cage);
    const double spin = dot(m.w, m.e), churning = all_.of.churning(spin);
    LandContact c;
    if (l.i_ring >= 0) {
      c = land_contact(all_.of, m, motion(l.i_ring));
      sums.add(l.ring_claim, axes_.lab(-c.force), axes_.lab(-c.moment - cross(c.lever, c.force)));
    }
    sums.add(l.claim, axes_.lab(c.force), axes_.lab(c.moment - m.e * churning));
    row->stiffness = c.stiffness;
    row->loss = c.loss + churning * spin;
    eccentricity_ = std::max(eccentricity_, c.share);
    ++row;
  }
}

void FixBearingCageRing::left_pocket(const CagePockets::Cell &c, int pocket, double overlap) const
{
  BRG_ONE(bearing::name_of(*this) + ": ball " + std::to_string(c.ball) + " is " + text(overlap) +
          " m beyond the wall of pocket " + std::to_string(pocket + 1) + " of cage " +
          std::to_string(c.cage) + " at step " + std::to_string(update->ntimestep) +
          ", more than a tenth of its radius: it has left its pocket. The balls' excursions "
          "exceed the play, or the step is too large");
  std::abort();
}

double FixBearingCageRing::compute_vector(int k)
{
  if (k < bearing::of_fix_ring::N) return FixBearingRing::compute_vector(k);
  using namespace bearing::of_cage;
  const int which = k - bearing::of_fix_ring::N;
  const std::vector<PocketRow> &rows = pair_->table().pocket;
  const size_t end = first_row_ + all_.cells.size() + all_.lands.size();
  struct One {
    tag_t ball, cage;
    double value;
  };
  std::vector<One> of;
  for (size_t r = first_row_; r < std::min(end, rows.size()); ++r)
    of.push_back({rows[r].ball, rows[r].cage, which == LOSS ? rows[r].loss : rows[r].force});
  if (which == ECCENTRICITY) of = {{0, 0, eccentricity_}};
  of = bearing::gather_all(of, world);
  // sorted so that the sum is bitwise identical on any number of ranks
  std::sort(of.begin(), of.end(), [](const One &a, const One &b) {
    return a.ball != b.ball ? a.ball < b.ball : a.cage < b.cage;
  });
  double sum = 0.0, most = 0.0;
  for (const One &one : of) {
    sum += one.value;
    most = std::max(most, one.value);
  }
  return which == LOSS || which == SUM ? sum : most;
}
