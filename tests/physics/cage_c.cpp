// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the pockets and the land of a one-piece cage to test_physics_cage_ring.py and
// test_physics_pocket_film.py.
#include "../../src-package/core/geometry/pocket_contact.h"
#include "../../src-package/core/interface/exports.h"

using namespace raceway;

RECORD(Squeeze, double spring, damper, by_spring[3], by_damper[3];)
EXPORT(void, pocket_squeeze, (const double *film, const double *x, const double *v, Squeeze *out))
{
  CageRing cage;
  cage.spherical = film[4] != 0.0;
  cage.film = {film[0], film[1], film[2], film[3], cage.spherical};
  PocketGapT<double> gap;
  gap.apart = Vec3::from(x);
  gap.velocity = Vec3::from(v);
  const PocketOilT<double> s = pocket_oil(cage, gap, true);
  *out = {s.film.spring, s.film.damper, {}, {}};
  for (int k = 0; k < 3; ++k) {
    out->by_spring[k] = s.spring[k];
    out->by_damper[k] = s.damper[k];
  }
}

FORMULA(double, pocket_film_width,
        (double radius, double clearance, double height, double spherical, double e))
{
  return std::cbrt(film_width_cubed({radius, clearance, height, 1.0, spherical != 0.0}, e));
}

RECORD(Film, double x, y;)
FORMULA(Film, cage_land_film,
        (double viscosity, double radius, double width, double clearance, double x, double y,
         double vx, double vy, double sum))
{
  const LandForce<double> f =
      land_film<double>({radius, clearance, width, 1, viscosity, 1.0}, x, y, vx, vy, sum);
  return {f.x, f.y};
}

// A cage, a ball and a ring at positions that a test sets.
RECORD(CageScene, double pockets, spherical, pitch, phase, along, across, stiffness, mass, friction,
       creep, shear, film, guide, radius, clearance, width, viscosity, land_stiffness, wall, x[3],
       v[3], w[3], e[3], angle, ball_x[3], ball_v[3], ball_w[3], ball_radius, ball_mass, ring_x[3],
       ring_v[3], ring_w[3], ring_e[3];)
RECORD(PocketOutput, double pocket, overlap, force[3], ball_torque[3], cage_moment[3], normal[3],
       loss, energy, push, stiffness, damping;)
RECORD(LandOutput, double force[3], moment[3], share, loss, energy, push, displaced[4], moved[4];)

static CageRing cage_of(const CageScene &in)
{
  CageRing c;
  c.pockets = int(in.pockets);
  c.spherical = in.spherical != 0.0;
  c.pitch = in.pitch;
  c.phase = in.phase;
  c.along = in.along;
  c.across = in.across;
  c.stiffness = in.stiffness;
  c.mass = in.mass;
  c.friction = in.friction;
  c.creep = in.creep;
  c.shear = in.shear;
  if (in.film > 0.0)
    c.film = {in.ball_radius, c.least_play(in.ball_radius), in.film, in.viscosity, c.spherical};
  c.guide = CageRing::Guide(int(in.guide));
  c.land = {in.radius, in.clearance, in.width, 2, in.viscosity, 1.0};
  c.land_stiffness = in.land_stiffness;
  c.wall = in.wall;
  return c;
}

static CageMotion motion_of(const double *x, const double *v, const double *w, const double *e,
                            double angle)
{
  return {Vec3::from(x), Vec3::from(v), Vec3::from(e), Vec3::from(w), angle};
}

EXPORT(void, cage_pocket, (const CageScene *in, PocketOutput *out))
{
  const CageRing cage = cage_of(*in);
  const CageMotion m = motion_of(in->x, in->v, in->w, in->e, in->angle);
  const PocketBall ball = {Vec3::from(in->ball_x), Vec3::from(in->ball_v), Vec3::from(in->ball_w),
                           in->ball_radius, in->ball_mass};
  const int k = pocket_at(cage, m, ball.x - m.x);
  const PocketContact c = pocket_contact(cage, m, k, ball);
  *out = {};
  out->pocket = k;
  out->overlap = c.gap.overlap;
  c.force().to(out->force);
  c.ball_torque().to(out->ball_torque);
  c.cage_moment().to(out->cage_moment);
  c.wall.normal.to(out->normal);
  out->loss = c.loss();
  out->energy = c.wall.energy;
  out->push = c.push();
  out->stiffness = c.wall.h.stiffness;
  out->damping = c.wall.h.damping;
}

EXPORT(void, cage_land, (const CageScene *in, LandOutput *out))
{
  const LandContact l =
      land_contact(cage_of(*in), motion_of(in->x, in->v, in->w, in->e, in->angle),
                   motion_of(in->ring_x, in->ring_v, in->ring_w, in->ring_e, 0.0));
  *out = {};
  l.force.to(out->force);
  l.moment.to(out->moment);
  out->share = l.share;
  out->loss = l.loss;
  out->energy = l.energy;
  out->push = l.push;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      out->displaced[2 * i + k] = l.displaced[i][k];
      out->moved[2 * i + k] = l.moved[i][k];
    }
}
