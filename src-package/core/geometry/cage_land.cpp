// SPDX-License-Identifier: GPL-2.0-or-later
#include "../numbers/dual.h"
#include "cage_ring.h"

namespace raceway {

// Computes the force along both axes of the land's plane, which is due to the oil film and, beyond
// the clearance, to contact between the surfaces.
template <class T>
static LandForce<T> in_plane(const CageRing &c, const T &x, const T &y, const T &vx, const T &vy,
                             double sum, double mass, LandContact &keep)
{
  LandForce<T> f = {T(0.0), T(0.0)};
  if (c.land.viscosity > 0.0) f = land_film(c.land, x, y, vx, vy, sum);
  const T off = square_root(T(x * x + y * y + 1e-30));
  const double over = held(off) - c.land.clearance;
  if (over <= 0.0) return f;
  const T ux = x / off, uy = y / off, overlap = off - c.land.clearance;
  const T root = square_root(overlap), spring = c.land_stiffness * overlap * root,
          damping = 2.0 * square_root(T(1.5 * c.land_stiffness * root * mass));
  T push = spring + damping * (vx * ux + vy * uy);
  push = where(push > 0.0, push, 0.0);
  keep.energy = 0.4 * held(spring) * over;
  keep.stiffness = 1.5 * c.land_stiffness * held(root);
  keep.push = held(push);
  return {f.x - push * ux, f.y - push * uy};
}

LandContact land_contact(const CageRing &c, const CageMotion &cage, const CageMotion &ring)
{
  LandContact l;
  const Vec3 d = cage.x - ring.x, &e = ring.e;
  l.lever = d;
  l.axis[0] = carried_across(e, 1.0, 0.0);
  l.axis[1] = carried_across(e, 0.0, 1.0);
  const Vec3 dv = cage.v - ring.v - cross(ring.w, d);
  // velocity relative to the axes of the land, which do not spin with the ring
  const Vec3 seen = dv + cross(e, d) * dot(ring.w, e);
  const double speed[] = {dot(cage.w, e), dot(ring.w, e)};
  const double at[] = {dot(d, l.axis[0]), dot(d, l.axis[1])},
               v[] = {dot(seen, l.axis[0]), dot(seen, l.axis[1])};
  l.share = std::sqrt(at[0] * at[0] + at[1] * at[1]) / c.land.clearance;
  using D = Dual<double, 4>;
  D x[4] = {at[0], at[1], v[0], v[1]};
  for (int k = 0; k < 4; ++k) x[k].d[k] = 1.0;
  const LandForce<D> f = in_plane(c, x[0], x[1], x[2], x[3], speed[0] + speed[1], c.mass, l);
  const D *const of[] = {&f.x, &f.y};
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      l.displaced[i][k] = -of[i]->d[k];
      l.moved[i][k] = -of[i]->d[2 + k];
    }
  l.force = l.axis[0] * f.x.value + l.axis[1] * f.y.value;
  if (c.land.viscosity > 0.0)
    l.moment = e * (-land_couple(c.land, l.share) * (speed[0] - speed[1]));
  if (l.push > 0.0 && c.friction > 0.0) {
    // the cage touches an inner land on the side opposite to its displacement
    const Vec3 out = (l.axis[0] * at[0] + l.axis[1] * at[1]) * (1.0 / (l.share * c.land.clearance)),
               point = out * (c.guide == CageRing::by_inner ? -c.land.radius : c.land.radius);
    const Vec3 along = cross(e, out);
    const double slide = dot(dv + cross(cage.w - ring.w, point - d), along);
    const Vec3 brake =
        along * (-c.friction * l.push * slide / std::sqrt(slide * slide + c.creep * c.creep));
    l.force += brake;
    l.moment += cross(point - d, brake);
  }
  // power that the contact extracts from both bodies; the part that is not stored in the spring is
  // dissipated
  const double taken = -dot(l.force, cage.v) + dot(l.force, ring.v + cross(ring.w, d)) -
                       dot(l.moment, cage.w - ring.w);
  double stored = 0.0;
  if (l.energy > 0.0) {
    const double off = l.share * c.land.clearance, over = off - c.land.clearance;
    stored = c.land_stiffness * over * std::sqrt(over) * (at[0] * v[0] + at[1] * v[1]) / off;
  }
  l.loss = taken - stored;
  return l;
}

}    // namespace raceway
