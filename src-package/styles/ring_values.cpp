// SPDX-License-Identifier: GPL-2.0-or-later
#include "ring_values.h"

#include "../contacts/bearing_columns.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

#include "../implicit/ring_program.h"

using namespace LAMMPS_NS;
using raceway::Vec3;

namespace bearing {

void ring_values(const Atom &atom, PairBearingHertz &pair, int n, double *of)
{
  const RingSum &rings = pair.ring_sum();
  const int i = rings.ring(n);
  const raceway::LabAxes axes = {pair.axis_index()};
  const RingMotion &ring = pair.state()->ring(i);
  of[of_ring::RING] = static_cast<double>(atom.tag[i]);
  (Vec3::from(atom.x[i]) - ring.origin).to(of + of_ring::X);
  Vec3::from(atom.v[i]).to(of + of_ring::VX);
  of[of_ring::SPIN] = dot(Vec3::from(atom.omega[i]), ring.axis);
  of[of_ring::ANGLE] = ring.angle;
  raceway::tilt_of(axes.third(ring.axis), of + of_ring::TILT_1);
  rings.force(n).to(of + of_ring::FX);
  rings.torque(n).to(of + of_ring::MX);
  of[of_ring::TORQUE] = dot(rings.torque(n), ring.axis);
}

}    // namespace bearing
