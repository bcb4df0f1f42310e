// SPDX-License-Identifier: GPL-2.0-or-later
// What the loops over contacts of balls on raceways share: that over smooth raceways
// (pair_bearing_compute.cpp) and that over raceways with profiles (pair_bearing_flawed.cpp).
#ifndef LMP_PAIR_BEARING_FORCES_H
#define LMP_PAIR_BEARING_FORCES_H

#include "pair_bearing_hertz.h"

#include "fix_bearing_state.h"

namespace LAMMPS_NS {

template <class L>
inline void PairBearingHertz::add_forces(const bearing::RacewayContact &c,
                                         const raceway::ContactForces &forces,
                                         double energy_of_profile)
{
  if (!std::isfinite(c.state.normal)) lost(c);
  forces.force.add_to(atom->f[c.i_ball]);
  forces.ball_torque.add_to(atom->torque[c.i_ball]);
  ring_sum_.add(c.claim, -forces.force, forces.ring_torque);
  if (evflag) tally(c, forces, L::energy(*c.raceway, c.state) + energy_of_profile);
}

inline double PairBearingHertz::orbit_of(const bearing::RacewayContact &c) const
{
  using raceway::Vec3;
  return dot(Vec3::from(atom->v[c.i_ball]) - Vec3::from(atom->v[c.i_ring]), c.state.t) / c.state.r;
}

}    // namespace LAMMPS_NS

#endif
