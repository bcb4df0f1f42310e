// SPDX-License-Identifier: GPL-2.0-or-later
// Motion of four bodies in the implicit step, and the part of the linear system that belongs to
// them.
#pragma once

#include "../numbers/lane_frame.h"

namespace raceway {

// Structs with lanes are aligned for the widest vector instructions and declare their lanes first.
struct alignas(32) BodyGroup {
  Lane mass, inertia, radius;
  LaneMask used;
  LaneFrame from, base, now;
  Vec3L v_from, w_from, v_base, w_base, v, w, v_first;
  Lane turn = {};      // rad, rotation from `base` to `now`
  Lane turned = {};    // rad, rotation from `from` to `base`
  // the linear system: block, right-hand side, columns of the links (bearing_system.h)
  Lane A[36], rhs[6], link[2][6];
  Lane spring = {}, damper = {};    // sums over contacts, N/m and N s/m; set only with dampers_only
  Lane stiffness = {};              // N/m, stiffness of the stiffest contact with a raceway
  bool spins;
  bool coupled = false;    // is coupled to the border
  bool linked = false;
};

}    // namespace raceway
