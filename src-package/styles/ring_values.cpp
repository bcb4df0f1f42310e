// SPDX-License-Identifier: GPL-2.0-or-later
#include "ring_values.h"

#include "../core/figures/bearing_columns.h"
#include "fix_bearing_ring.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

using namespace LAMMPS_NS;
using raceway::Vec3;

namespace bearing {

void ring_values(const RingView &r, const raceway::LabAxes &axes, double *of)
{
  of[of_ring::RING] = r.tag;
  axes.lab(r.place.x - r.place.origin).to(of + of_ring::X);
  axes.lab(r.place.v).to(of + of_ring::VX);
  of[of_ring::SPIN] = r.spin;
  of[of_ring::ANGLE] = r.place.angle;
  raceway::tilt_of(r.place.e, of + of_ring::TILT_1);
  axes.lab(r.force).to(of + of_ring::FX);
  const Vec3 moment = axes.lab(r.moment);
  moment.to(of + of_ring::MX);
  of[of_ring::TORQUE] = dot(moment, axes.lab(r.place.e));
  axes.lab(r.acceleration).to(of + of_ring::AX);
}

void note_setup(LAMMPS *lmp)
{
  for (FixBearingRing *f : fixes_of<FixBearingRing>(lmp)) f->note_setup();
}

void ring_values(const Atom &atom, PairBearingHertz &pair, int n, double *of)
{
  const RingSum &rings = pair.ring_sum();
  const int i = rings.ring(n);
  const raceway::LabAxes axes = {pair.coefficients().axis_index()};
  const RingMotion &ring = pair.state()->ring(i);
  raceway::RingPlace place;
  read_place(atom, i, ring, axes, place);
  ring_values({static_cast<double>(atom.tag[i]), place, dot(Vec3::from(atom.omega[i]), ring.axis),
               axes.third(rings.force(n)), axes.third(rings.torque(n)),
               axes.third(ring.acceleration)},
              axes, of);
}

}    // namespace bearing
