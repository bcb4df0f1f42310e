// SPDX-License-Identifier: GPL-2.0-or-later
// Power dissipated at the contacts of cage balls and one-piece cages, and between balls that touch
// each other. Each contact is counted on exactly one rank.
#pragma once

#include "fix_bearing_cage.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

namespace bearing {

// Calls `take` for each contact. The arguments are the tags of both bodies (0 for a rail or for the
// land of a one-piece cage), the local index of the first body, the dissipated power (W), and the
// force (N; 0 for a rail or land).
template <class Take>
void each_cage_loss(LAMMPS_NS::LAMMPS *lmp, const LAMMPS_NS::PairBearingHertz &pair,
                    const Take &take)
{
  for (const SphereContact &s : pair.table().sphere)
    if (s.i < lmp->atom->nlocal)    // otherwise the rank that owns s.i counts the contact
      take(s.tag_i, s.tag_j, s.i, s.loss, s.force);
  for (const LAMMPS_NS::FixBearingCage *f : fixes_of<LAMMPS_NS::FixBearingCage>(lmp))
    for (const CageRails::CageBall &b : f->rails().balls) take(b.tag, tag_t(0), b.i, b.loss, 0.0);
  for (const PocketRow &p : pair.table().pocket)
    if (p.ball != 0) take(p.ball, p.cage, lmp->atom->map(p.ball), p.loss, p.force);
    else take(p.cage, tag_t(0), lmp->atom->map(p.cage), p.loss, p.force);
}

}    // namespace bearing
