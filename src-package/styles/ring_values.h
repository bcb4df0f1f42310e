// SPDX-License-Identifier: GPL-2.0-or-later
// Motion of a ring and the loads that the balls and the cage exert on it.
#pragma once

#include "../core/bodies/ring_program.h"
#include "../core/numbers/lab_axes.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {
class PairBearingHertz;
}

namespace bearing {

// A ring and its loads, with the bearing axis as the third component.
struct RingView {
  double tag;
  const raceway::RingPlace &place;
  double spin;    // rad/s, spin about the axis of the ring
  raceway::Vec3 force, moment, acceleration;
};

// Sets of[of_ring::RING] to of[of_ring::AZ] (core/figures/bearing_columns.h).
void ring_values(const RingView &, const raceway::LabAxes &, double *of);

// Stores accelerations at the start of a run. Must be called before ring_values().
void note_setup(LAMMPS_NS::LAMMPS *);

// Does the same for the n-th ring of this rank in the RingSum of the pair style.
void ring_values(const LAMMPS_NS::Atom &, LAMMPS_NS::PairBearingHertz &, int n, double *of);

}    // namespace bearing
