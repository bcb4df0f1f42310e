// SPDX-License-Identifier: GPL-2.0-or-later
// The part of the state of a ring that is stored from step to step in addition to the position,
// velocity and spin of its atom.
#pragma once

#include "../core/bodies/ring_program.h"
#include "../core/numbers/lab_axes.h"
#include "bearing_compat.h"

namespace bearing {

struct RingMotion {
  raceway::Vec3 axis;
  raceway::Vec3 origin;           // m, initial position of the ring
  double angle = 0.0;             // rad, rotation about its axis
  double tilt[2] = {0.0, 0.0};    // rad, imposed tilts about the two transverse axes
  raceway::Vec3 acceleration;     // m/s^2, in the last step
  double step = 0.0;    // s, next substep requested by fix bearing/implicit (first ring only), or 0
};

// Read the RingPlace of ring atom i from the atom and its motion, which refer to the lab frame, and
// write it back.
inline void read_place(const LAMMPS_NS::Atom &atom, int i, const RingMotion &m,
                       const raceway::LabAxes &axes, raceway::RingPlace &p)
{
  p.x = axes.third(raceway::Vec3::from(atom.x[i]));
  p.v = axes.third(raceway::Vec3::from(atom.v[i]));
  p.e = axes.third(m.axis);
  p.origin = axes.third(m.origin);
  p.angle = m.angle;
  for (int k = 0; k < 2; ++k) p.tilt[k] = m.tilt[k];
}

inline void write_place(const raceway::RingPlace &p, const raceway::LabAxes &axes,
                        LAMMPS_NS::Atom &atom, int i, RingMotion &m)
{
  axes.lab(p.x).to(atom.x[i]);
  axes.lab(p.v).to(atom.v[i]);
  m.axis = axes.lab(p.e);
  m.angle = p.angle;
  for (int k = 0; k < 2; ++k) m.tilt[k] = p.tilt[k];
}

}    // namespace bearing
