// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_cage.h"

#include "../core/figures/fix_columns.h"
#include "../core/settings/arguments.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "named_bearing.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace raceway;
using bearing::Arguments;
using bearing::CageRails;

// fix ID cage-group bearing/cage RING_TYPE|NAME [rail R r z] ... [tube r] [gap g]
// [young E_ball E_rail] [poisson ...]
FixBearingCage::FixBearingCage(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/cage"))
{
  bearing::provide_values(*this, bearing::of_fix_cage::N);
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  const bearing::NamedBearing *const b =
      args.more() ? bearing::find_bearing(lmp, args.next()) : nullptr;
  if (b) args.word("name of a bearing");
  if (b && b->has_cage_ring)
    args.fail("the cage of bearing " + b->name +
              " is a ring: use fix bearing/${NAME_cage_style} for any cage, or give 'cage chain'");
  ring_type_ =
      b ? b->outer : args.integer("type of the ring that carries the rails", 1, atom->ntypes);
  if (!pair_->coefficients().is_ring(ring_type_))
    args.fail("type " + std::to_string(ring_type_) +
              " is not a ring: no pair_coeff names it inner or outer");
  while (args.more())
    if (args.take("rail")) {
      Rail r;
      r.circle = args.positive("radius of the rail's centre circle (m)");
      r.tube = args.positive("radius of the rail's tube (m)");
      r.offset = args.number("axial offset of the rail (m)");
      if (r.tube >= r.circle) args.fail("rail: tube radius must be smaller than the centre circle");
      cage_.rails.push_back(r);
      seats_ = false;
    } else if (args.within("young", young_[0], "Young's modulus of the cage balls (Pa)",
                           raceway::LEAST_YOUNG, raceway::LARGEST_YOUNG)) {
      young_[1] = args.within("Young's modulus of the rails (Pa)", raceway::LEAST_YOUNG,
                              raceway::LARGEST_YOUNG);
    } else if (args.within("poisson", poisson_[0], "Poisson's ratio of the cage balls", 0.0, 0.5)) {
      poisson_[1] = args.within("Poisson's ratio of the rails", 0.0, 0.5);
    } else if (!args.positive("tube", tube_, "tube radius (m)") &&
               !args.non_negative("gap", gap_, "gap between cage ball and rail (m)")) {
      args.unknown();
    }
}

// Returns the named bearing whose ring carries the rails, or null if there is none.
const bearing::NamedBearing *FixBearingCage::named() const
{
  for (const bearing::NamedBearing *b : bearing::bearings_of(lmp))
    if (b->in_use && (b->inner == ring_type_ || b->outer == ring_type_)) return b;
  return nullptr;
}

// Returns true if the atom is in the group and, in the case of named bearings, is a cage ball of
// the bearing to which that ring belongs.
bool FixBearingCage::holds(int i) const
{
  return (atom->mask[i] & groupbit) && (cage_type_ == 0 || atom->type[i] == cage_type_);
}

// Returns false for a bearing whose deck states that it has no cage.
bool FixBearingCage::expected() const
{
  const bearing::NamedBearing *const b = named();
  return !b || b->has_cage;
}

int FixBearingCage::setmask() { return PRE_NEIGHBOR | PRE_FORCE; }

void FixBearingCage::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/cage");
  const bearing::NamedBearing *const b = named();
  cage_type_ = b ? b->cage : 0;
  // all balls of a cage have the same radius and pitch circle, as in create_bearing
  double radius = 0.0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (holds(i)) radius = std::max(radius, atom->radius[i]);
  MPI_Allreduce(MPI_IN_PLACE, &radius, 1, MPI_DOUBLE, MPI_MAX, world);
  if (radius == 0.0 && !expected()) return;
  if (radius == 0.0) BRG_ALL(bearing::name_of(*this) + ": its group has no cage balls");
  for (const FixBearingCage *other : bearing::fixes_of<FixBearingCage>(lmp)) {
    if (other == this) break;    // only the later of two such fixes reports the error
    for (int i = 0; i < atom->nlocal; ++i)
      if (holds(i) && other->holds(i))
        BRG_ONE(bearing::name_of(*this) + " and " + bearing::name_of(*other) +
                " both hold cage ball " + std::to_string(atom->tag[i]));
  }
  pitch_ = pair_->coefficients().pitch_radius(ring_type_);
  if (seats_)
    cage_.rails = {seat_rail(pitch_, radius, tube_, gap_, 1.0),
                   seat_rail(pitch_, radius, tube_, gap_, -1.0)};
  cage_.stiffness.clear();
  const double E = reduced_modulus(young_[0], poisson_[0], young_[1], poisson_[1]);
  double play = 0.0;
  for (const Rail &r : cage_.rails) {
    cage_.stiffness.push_back(rail_stiffness(r, radius, pitch_, E));
    play = std::max(play, std::hypot(r.circle - pitch_, r.offset) - r.tube - radius);
  }
  pocket_ = 0.25 * radius + 2.0 * play;    // balls that are held by rails stay within 0.002 radii
}

void FixBearingCage::setup_pre_neighbor() { find_balls(); }
void FixBearingCage::pre_neighbor() { find_balls(); }

// A cage ball is carried by the ring whose pitch circle is nearest and whose centre is within two
// pitch radii; the nearest centre may be that of a housing. The local indices that are found remain
// valid until the next neighbour build. Only rings in a slab about the ball are searched; the slab
// is normal to the direction in which the rings are spread furthest.
void FixBearingCage::find_balls()
{
  cage_.balls.clear();
  double **x = atom->x;
  std::vector<int> rings;
  double lo[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, hi[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    if (atom->type[i] != ring_type_) continue;
    rings.push_back(i);
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], x[i][k]);
      hi[k] = std::max(hi[k], x[i][k]);
    }
  }
  int along = 0;
  for (int k = 1; k < 3; ++k)
    if (hi[k] - lo[k] > hi[along] - lo[along]) along = k;
  std::sort(rings.begin(), rings.end(), [&](int a, int b) { return x[a][along] < x[b][along]; });
  const double reach = 2.0 * pitch_;
  const int axis = pair_->coefficients().axis_index();
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!holds(i)) continue;
    int nearest = -1;
    double best = HUGE_VAL;
    auto j = std::lower_bound(rings.begin(), rings.end(), x[i][along] - reach,
                              [&](int ring, double value) { return x[ring][along] < value; });
    for (; j != rings.end() && x[*j][along] < x[i][along] + reach; ++j) {
      const Vec3 d = Vec3::from(x[i]) - Vec3::from(x[*j]);
      const double r2 = dot(d, d), axial = x[i][axis] - x[*j][axis];
      if (!(r2 < reach * reach)) continue;
      const double off = std::hypot(std::sqrt(std::fmax(0.0, r2 - axial * axial)) - pitch_, axial);
      if (off < best || (off == best && atom->tag[*j] < atom->tag[nearest])) {
        best = off;
        nearest = *j;
      }
    }
    if (nearest < 0)
      BRG_ONE(bearing::name_of(*this) + ": lost cage ball " + std::to_string(atom->tag[i]) +
              " at step " + std::to_string(update->ntimestep) + ": no ring of type " +
              std::to_string(ring_type_) + " within two pitch radii");
    cage_.balls.push_back({i, nearest, atom->tag[i], atom->tag[nearest], -1, 0.0});
  }
  std::sort(
      cage_.balls.begin(), cage_.balls.end(),
      [](const CageRails::CageBall &a, const CageRails::CageBall &b) { return a.tag < b.tag; });
}

void FixBearingCage::setup_pre_force(int vflag) { pre_force(vflag); }

// Evaluates all cage balls, one rail after another, in lanes of four. Four balls that touch no rail
// require only one comparison.
void FixBearingCage::pre_force(int)
{
  pair_->state()->forward_axes();
  double **x = atom->x, **v = atom->v, **f = atom->f;
  const size_t n = cage_.balls.size();
  fours_.resize((n + lanes - 1) / lanes);
  for (size_t i = 0; i < n; ++i) {
    CageRails::CageBall &ball = cage_.balls[i];
    if (ball.claim < 0)
      ball.claim = pair_->ring_sum().claim(ball.ring, pair_->state()->owner(ball.i_ring),
                                           bearing::RingSum::rail, ball.tag);
    const Vec3 e = pair_->state()->axis(ball.i_ring);
    const Vec3 d = Vec3::from(x[ball.i]) - Vec3::from(x[ball.i_ring]);
    // radial and axial velocity of the ball relative to the ring; a frictionless contact needs no
    // other components
    const Vec3 dv = Vec3::from(v[ball.i]) - Vec3::from(v[ball.i_ring]) -
                    cross(Vec3::from(atom->omega[ball.i_ring]), d);
    Four &four = fours_[i / lanes];
    const size_t k = i % lanes;
    const double z = dot(d, e), ve = dot(dv, e);
    four.z[k] = z;
    four.r[k] = dot(d, d) - z * z;
    four.ve[k] = ve;
    four.vr[k] = dot(dv, d) - ve * z;
    four.mass[k] = atom->rmass[ball.i];
    four.radius[k] = atom->radius[ball.i];
  }
  if (n % lanes > 0) fours_.back().spare(static_cast<int>(n % lanes));
  force_sum_ = force_max_ = 0.0;
  find_forces();
  for (size_t i = 0; i < n; ++i) {
    const Four &four = fours_[i / lanes];
    const size_t k = i % lanes;
    CageRails::CageBall &ball = cage_.balls[i];
    ball.loss = four.loss[k];
    const double off = std::hypot(four.r[k] - pitch_, four.z[k]);
    if (off > pocket_) left_pocket(ball, off);
    if (four.fr[k] == 0.0 && four.fe[k] == 0.0) continue;
    const Vec3 e = pair_->state()->axis(ball.i_ring);
    const Vec3 d = Vec3::from(x[ball.i]) - Vec3::from(x[ball.i_ring]);
    const Vec3 force = (d - e * four.z[k]) * (four.fr[k] / four.r[k]) + e * four.fe[k];
    force.add_to(f[ball.i]);
    pair_->ring_sum().add(ball.claim, -force, -cross(d, force));
  }
}

void FixBearingCage::left_pocket(const CageRails::CageBall &ball, double off) const
{
  BRG_ONE(bearing::name_of(*this) + ": cage ball " + std::to_string(ball.tag) + " is " +
          bearing::text(off) + " m from the pitch circle at step " +
          std::to_string(update->ntimestep) + ", more than " + bearing::text(pocket_) +
          " m: it has left its pocket. Rails hold cage balls from outside only, so they fall "
          "inwards under gravity or vibration at low speed");
}

// The lanes from `first` onwards hold no ball: they copy the previous lane, but are placed far from
// any rail.
void FixBearingCage::Four::spare(int first)
{
  constexpr double far = 1.0e30;    // m^2, because r holds the squared radius here
  for (int k = first; k < lanes; ++k) {
    for (Lane *a : {&z, &vr, &ve, &mass, &radius}) (*a)[k] = (*a)[first - 1];
    r[k] = far;
  }
}

RACEWAY_LANES void FixBearingCage::find_forces()
{
  for (Four &four : fours_) {
    four.r = square_root(four.r);
    four.vr /= four.r;
    four.fr = four.fe = four.loss = Lane{};
  }
  for (size_t k = 0; k < cage_.rails.size(); ++k)
    for (Four &four : fours_) {
      if (!any(may_touch(cage_.rails[k], four.r, four.z, four.radius, 0.0))) continue;
      const RailContactT<Lane> c = rail_contact(cage_.rails[k], cage_.stiffness[k], four.r, four.z,
                                                four.vr, four.ve, four.radius, four.mass);
      const Lane force = c.h.force;
      four.fr += force * c.nr;
      four.fe += force * c.ne;
      four.loss += damping_loss(c.h, c.overlap, Lane(-(four.vr * c.nr + four.ve * c.ne)));
      for (int i = 0; i < lanes; ++i) {
        force_sum_ += force[i];
        force_max_ = force[i] > force_max_ ? force[i] : force_max_;
      }
    }
}

double FixBearingCage::compute_scalar() { return compute_vector(bearing::of_fix_cage::SUM); }

double FixBearingCage::compute_vector(int k)
{
  const bool sum = k == bearing::of_fix_cage::SUM;
  double mine = sum ? force_sum_ : force_max_, all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, sum ? MPI_SUM : MPI_MAX, world);
  return all;
}
