// SPDX-License-Identifier: GPL-2.0-or-later
#include "create_bearing.h"

#include "../core/laws/rolling.h"
#include "../core/raceway/start_rotation.h"
#include "../core/settings/arguments.h"
#include "../core/settings/written.h"
#include "named_bearing.h"
#include "pair_bearing.h"
#include "print_line.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::Arguments;
using bearing::text;

// create_bearing BALL CAGE|none INNER OUTER balls Z diameter D [density RHO] [cage D_c]
//   [cage_density RHO] [seat none|plus|minus] [cage_ring TYPE]
//   [centre x y z] [phase PHI] [speed W_i W_o] [thrust F] [groups yes|no]
// or, for a named bearing: create_bearing NAME with the keywords of the last line
void CreateBearing::command(int narg, char **arg)
{
  Arguments args(lmp, "create_bearing", narg, arg, 0);
  if (args.more() && !args.next_is_number()) return command_named(args);
  check_host(args);
  create(args, parse(args));
}

// Creates a named bearing from its data.
void CreateBearing::command_named(Arguments &args)
{
  const bearing::NamedBearing &b = bearing::bearing_of(lmp, args, args.word("name of a bearing"));
  auto *pair = dynamic_cast<PairBearing *>(force->pair);
  if (!pair)
    args.fail("bearing " + b.name +
              " needs pair_style bearing before it, not below hybrid; particles beside bearings "
              "need 'pair_coeff I J grain' and fix bearing/grains");
  Plan p;
  p.groups = true;
  while (args.more())
    if (!take_motion(args, p)) args.unknown();
  p.thrust = bearing::written(p.thrust);
  pair->set_speed(b.name, p.inner_speed - p.outer_speed);
  const bool angle = b.number("contact_angle") > 0.0, four = b.number("four_point") > 0.0;
  p.seat = (angle || four) && p.thrust < 0.0 ? -1 : angle || (four && p.thrust > 0.0);
  p.ball_type = b.balls;
  p.inner_type = b.inner;
  p.outer_type = b.outer;
  p.balls = static_cast<int>(b.number("balls"));
  p.ball_radius = 0.5 * b.number("ball_diameter");
  p.ball_density = b.number("ball_density");
  if (b.has_cage) {
    p.cage_type = b.cage;
    p.cage_radius = 0.5 * b.number("cage_ball_diameter");
  }
  if (b.has_cage_ring) p.ring_cage = b.cage;
  Arguments own(lmp, "create_bearing " + b.name, {});
  check_host(own);
  const bool placed = create(own, p);
  if (b.has_cage_ring && placed) b.phases[next_tag_ - 1] = p.phase;
  if (!b.has_cage && p.groups) input->one(("group cage type " + std::to_string(b.cage)).c_str());
}

// True if there are atoms of a type on any rank. Collective.
bool CreateBearing::balls_of(int type) const
{
  const int mine = std::count(atom->type, atom->type + atom->nlocal, type) > 0;
  int any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any != 0;
}

void CreateBearing::check_host(const Arguments &args)
{
  if (!domain->box_exist)
    args.fail("the simulation box does not exist yet: create_box must come first");
  if (!atom->radius_flag || !atom->rmass_flag)
    args.fail("needs atom_style sphere (granular in LIGGGHTS)");
}

// Creates the atoms of a bearing and returns true, or false if they come from a restart file.
bool CreateBearing::create(const Arguments &args, Plan plan)
{
  PairBearingHertz &pair = *PairBearingHertz::find(lmp, "create_bearing");
  const bool resumed = bearing::host_variable(lmp, "b_resumed").value_or("0") == "1" ||
                       (modify->nfix_restart_peratom > 0 && balls_of(plan.ball_type));
  if (!resumed) {
    if (modify->nfix_restart_peratom)
      args.fail(
          "comes before read_restart, not after, because the restart file contains the bearing");
    check(args, pair, plan);
    place(plan, pair);
    if (plan.cage_type) pair.expect_sphere(plan.ball_type, plan.cage_type);
  } else if (atom->natoms == 0) {
    args.fail("b_resumed is 1, but there are no atoms: read_restart must come first");
  }
  if (plan.groups) make_groups(plan);
  return !resumed;
}

// The bearings created by all commands share these groups.
void CreateBearing::make_groups(const Plan &p)
{
  const auto add = [this](const char *name, int type) {
    if (type) input->one(("group " + std::string(name) + " type " + std::to_string(type)).c_str());
  };
  add("balls", p.ball_type);
  add("cage", p.cage_type);
  add("cage", p.ring_cage);
  add("inner", p.inner_type);
  add("outer", p.outer_type);
  add("moving", p.ball_type);
  add("moving", p.cage_type);
}

CreateBearing::Plan CreateBearing::parse(Arguments &args)
{
  Plan p;
  p.ball_type = args.integer("ball type", 1, atom->ntypes);
  p.cage_type = args.take("none") ? 0 : args.integer("cage ball type or 'none'", 1, atom->ntypes);
  p.inner_type = args.integer("inner ring type", 1, atom->ntypes);
  p.outer_type = args.integer("outer ring type", 1, atom->ntypes);
  double ball = 0.0, cage = 0.0;    // m, diameters
  while (args.more())
    if (args.take("seat")) {
      static const int way[] = {0, 1, -1};
      p.seat = way[args.choice("seat", {"none", "plus", "minus"})];
    } else if (!(args.integer("balls", p.balls, "number of balls", 1, 100000) ||
                 args.positive("diameter", ball, "ball diameter (m)") ||
                 args.positive("density", p.ball_density, "ball density (kg/m^3)") ||
                 args.positive("cage", cage, "cage ball diameter (m)") ||
                 args.positive("cage_density", p.cage_density, "cage ball density (kg/m^3)") ||
                 args.integer("cage_ring", p.ring_cage, "type of the cage ring", 1, atom->ntypes) ||
                 take_motion(args, p))) {
      args.unknown();
    }
  p.ball_radius = 0.5 * ball;
  p.cage_radius = 0.5 * cage;
  if (p.ring_cage && p.cage_type)
    args.fail("'cage_ring' is already a cage: give 'none' instead of a cage ball type");
  if (p.balls == 0) args.fail("'balls Z' is missing");
  if (p.ball_radius == 0.0) args.fail("'diameter D' is missing");
  if (p.cage_type && p.cage_radius == 0.0)
    args.fail("'cage D_c' is missing (or use 'none' as cage type)");
  return p;
}

// Reads a keyword that a named bearing also takes. Returns false if the next word is none of these.
bool CreateBearing::take_motion(Arguments &args, Plan &p)
{
  if (args.number("speed", p.inner_speed, "speed of the inner ring (rad/s)")) {
    p.outer_speed = args.number("speed of the outer ring (rad/s)");
  } else if (args.take("centre")) {
    for (double &c : p.centre) c = args.number("centre (m)");
  } else {
    return args.number("thrust", p.thrust, "thrust on the inner ring (N)") ||
           args.variable("phase", p.phase) || args.yes("groups", p.groups);
  }
  return true;
}

void CreateBearing::check(const Arguments &args, const PairBearingHertz &pair, Plan &p)
{
  const RacewayPhysics *in = pair.coefficients().raceway(p.ball_type, p.inner_type),
                       *out = pair.coefficients().raceway(p.ball_type, p.outer_type);
  if (!in || in->groove.side != Side::inner)
    args.fail("missing ring: no pair_coeff " + std::to_string(p.ball_type) + " " +
              std::to_string(p.inner_type) + " inner ... before this command");
  if (!out || out->groove.side != Side::outer)
    args.fail("missing ring: no pair_coeff " + std::to_string(p.ball_type) + " " +
              std::to_string(p.outer_type) + " outer ... before this command");
  if (p.ring_cage && !pair.coefficients().is_cage(p.ring_cage))
    args.fail("missing cage: no pair_coeff " + std::to_string(p.ball_type) + " " +
              std::to_string(p.ring_cage) + " cage before this command");
  const double R = p.ball_radius;
  Groove inner = in->groove, outer = out->groove;
  inner.ball_radius = outer.ball_radius = R;
  for (const Groove &groove : {inner, outer})
    if (const std::string wrong = bearing::wrong_groove(groove); !wrong.empty()) args.fail(wrong);
  const double Ri = inner.middle_radius(), Re = outer.middle_radius();
  p.cosine = 0.5 * (inner.middle_cosine() + outer.middle_cosine());
  if (Ri >= Re)
    args.fail("two rings at odds: inner raceway radius " + text(Ri) +
              " m is not smaller than the outer one, " + text(Re) + " m");
  p.pitch = p.middle = 0.5 * (Ri + Re);
  // with interference, the two contacts of a ball share the overlap -P_d/2
  const double clearance = 2.0 * (Re - Ri - 2.0 * R), squeeze = -0.25 * clearance;
  const double allowed = 0.02 * R;
  if (squeeze > allowed)
    args.fail("clearance " + text(clearance) +
              " m (2 (R_e - R_i - 2 R_b)) leaves no room for balls of diameter " + text(2.0 * R) +
              " m: it may not be below " + text(-4.0 * allowed) + " m");
  if (clearance > 2.0 * (in->groove.groove_radius - R + out->groove.groove_radius - R))
    args.fail("clearance " + text(clearance) +
              " m is so large that the grooves do not hold the balls: do the rings match?");
  if (p.seat) seat(args, inner, outer, clearance, p);
  if (p.balls > 1) {
    const double apart = 2.0 * p.pitch * std::sin(M_PI / p.balls);
    if (apart < 2.0 * R)
      args.fail("overlapping balls: " + std::to_string(p.balls) + " balls of diameter " +
                text(2.0 * R) + " m on a pitch circle of radius " + text(p.pitch) + " m are " +
                text(apart) + " m apart");
  }
  if (p.cage_type) {
    const double half = 2.0 * p.pitch * (p.balls > 1 ? std::sin(0.5 * M_PI / p.balls) : 1.0);
    if (half < R + p.cage_radius)
      args.fail(
          "cage ball of diameter " + text(2.0 * p.cage_radius) +
          " m is too large for the gap between two balls; the largest diameter that fits is " +
          text(2.0 * (half - R)) + " m");
  }
  const double reach = Re + R;
  const double *lo = domain->boxlo, *hi = domain->boxhi;
  for (int k = 0; k < 3; ++k)
    if (p.centre[k] - (k == pair.coefficients().axis_index() ? R : reach) < lo[k] ||
        p.centre[k] + (k == pair.coefficients().axis_index() ? R : reach) > hi[k])
      args.fail("the bearing (radius " + text(reach) +
                " m) does not fit into the box in direction " + "xyz"[k] + ": " + text(lo[k]) +
                " to " + text(hi[k]) + " m");
}

// Moves the inner ring along the axis until the load-carrying grooves, one in each ring, are in
// contact with the balls. If a ring has two grooves, the load-carrying one is the groove whose
// centre lies forward on the inner ring and backward on the outer ring. If there is preload, all
// grooves are already in contact, and the ring does not move.
void CreateBearing::seat(const Arguments &args, const Groove &inner, const Groove &outer,
                         double clearance, Plan &p)
{
  const double in_gap = inner.slack(), out_gap = outer.slack(), gaps = in_gap + out_gap;
  const double in_offset = std::fabs(inner.offset), out_offset = std::fabs(outer.offset);
  // the line through both centres of curvature is inclined by the contact angle (see docs/theory)
  const double arches =
      (in_gap * (1.0 - inner.middle_cosine()) + out_gap * (1.0 - outer.middle_cosine())) / gaps;
  const double cosine = std::min(1.0, 1.0 - arches - 0.5 * clearance / gaps);
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double way = gaps * sine - (in_offset + out_offset);
  if (way < 0.0) return;
  const double room = 1.0 + 1e-9;    // if there is no clearance, the angles are equal up to
                                     // rounding errors
  if (in_gap * sine * room < in_offset || out_gap * sine * room < out_offset)
    args.fail("'seat': a ball would lie in both grooves of one ring and one of the other; their "
              "contact angles are " +
              text(std::acos(inner.middle_cosine())) + " and " +
              text(std::acos(outer.middle_cosine())) +
              " rad: make them equal, or make the clearance larger than " + text(clearance) + " m");
  p.cosine = cosine;
  p.pitch = outer.centre_circle() + out_gap * cosine;
  p.ball_z = p.seat * (out_gap * sine - out_offset);
  p.inner_z = p.seat * way;
}

static double mass(double R, double rho) { return 4.0 / 3.0 * M_PI * R * R * R * rho; }

// Returns the rotation of a ball. If the law includes friction that opposes spin, this is the
// rotation that dissipates the least power. Otherwise the ball rotates about an axis parallel to
// the bearing's axis.
BallRotation CreateBearing::rotation(const Plan &p, const PairBearingHertz &pair)
{
  // distance of a contact from the ball's spin axis: ball radius times the cosine of the contact
  // angle
  const Rolling roll =
      pure_rolling(p.ball_radius * p.cosine, p.pitch, p.inner_speed, p.outer_speed);
  const bool seated = p.inner_z != 0.0;
  const RacewayPhysics &inner = *pair.coefficients().raceway(p.ball_type, p.inner_type),
                       &outer = *pair.coefficients().raceway(p.ball_type, p.outer_type);
  if (!inner.facts().spin || (p.thrust == 0.0 && !seated)) return {roll.orbit, 0.0, roll.spin, {}};
  return start_rotation(inner, outer,
                        {p.ball_radius, mass(p.ball_radius, p.ball_density), p.pitch, roll.orbit,
                         p.inner_speed, p.outer_speed, p.thrust / p.balls,
                         seated ? p.seat * std::acos(p.cosine) : 0.0});
}

void CreateBearing::place(const Plan &p, const PairBearingHertz &pair)
{
  const int first = atom->nlocal;
  bearing::tag_t top = 0;
  const bearing::tag_t *const tag = atom->tag;
  for (int i = 0; i < first; ++i) top = std::max(top, tag[i]);
  double most = static_cast<double>(top);
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, world);
  next_tag_ = static_cast<bearing::tag_t>(most) + 1;

  const Vec3 e = pair.axis(), centre = Vec3::from(p.centre);
  const Vec3 a = {e.z, e.x, e.y}, b = {e.y, e.z, e.x};    // azimuths 0 and 90 degrees
  const BallRotation roll = rotation(p, pair);
  for (int cage = 0; cage < (p.cage_type ? 2 : 1); ++cage)
    for (int k = 0; k < p.balls; ++k) {
      const double phi = p.phase + 2.0 * M_PI * (k + 0.5 * cage) / p.balls;
      const Vec3 u = a * std::cos(phi) + b * std::sin(phi);
      // cage balls start between the rails, midway between the raceways
      const Vec3 at = centre + (cage ? u * p.middle : u * p.pitch + e * p.ball_z);
      const Vec3 v = cross(e, u) * (roll.orbit * (cage ? p.middle : p.pitch));
      if (cage) add(p.cage_type, at, p.cage_radius, mass(p.cage_radius, p.cage_density), v, Vec3());
      else
        add(p.ball_type, at, p.ball_radius, mass(p.ball_radius, p.ball_density), v,
            u * roll.radial + e * roll.axial);
    }
  // a ring is one small atom at its centre; fix bearing/ring assigns its mass and inertia
  add(p.inner_type, centre + e * p.inner_z, 1e-4, 1.0, Vec3(), e * p.inner_speed);
  add(p.outer_type, centre, 1e-4, 1.0, Vec3(), e * p.outer_speed);
  if (p.ring_cage) add(p.ring_cage, centre + e * p.ball_z, 1e-4, 1.0, Vec3(), e * roll.orbit);
  bearing::make_atoms(lmp, atoms_);

  for (int m = 0; m < modify->nfix; ++m)
    if (modify->fix[m]->create_attribute)
      for (int i = first; i < atom->nlocal; ++i) modify->fix[m]->set_arrays(i);
  const double before = static_cast<double>(atom->natoms);
  bigint n = atom->nlocal;
  MPI_Allreduce(&n, &atom->natoms, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (atom->map_style) bearing::map_atoms(lmp, first, before, next_tag_ - 1);
  bearing::print_line(lmp, "Created a bearing: " + std::to_string(p.balls) + " balls" +
                               (p.cage_type ? ", as many cage balls" : "") +
                               (p.ring_cage ? ", a cage" : "") + ", two rings");
}

void CreateBearing::add(int type, const Vec3 &x, double radius, double mass, const Vec3 &v,
                        const Vec3 &w)
{
  bearing::NewAtom a;
  a.tag = next_tag_++;
  a.type = type;
  x.to(a.x);
  v.to(a.v);
  w.to(a.omega);
  a.radius = radius;
  a.mass = mass;
  atoms_.push_back(a);
}
