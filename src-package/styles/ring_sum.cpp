// SPDX-License-Identifier: GPL-2.0-or-later
#include "ring_sum.h"

#include "gather.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::Vec3;

namespace bearing {

void RingSum::reset_rings()
{
  rings_.clear();
  slot_.clear();
}

int RingSum::slot(int i_ring, tag_t tag)
{
  const auto found = slot_.emplace(tag, static_cast<int>(rings_.size()));
  if (found.second) rings_.push_back({i_ring, tag, Vec3(), Vec3()});
  return found.first->second;
}

void RingSum::keep(int slot, Source source, tag_t partner, const Vec3 &force, const Vec3 &torque)
{
  Part p;
  p.ring = rings_[slot].tag;
  p.partner = partner;
  p.source = source;
  force.to(p.force);
  torque.to(p.torque);
  parts_.push_back(p);
}

void RingSum::flush()
{
  if (!serial_) {
    std::vector<Part> all = gather_all(parts_, world);
    parts_.clear();
    std::sort(all.begin(), all.end());
    for (Ring &r : rings_) {
      if (r.i >= atom->nlocal) continue;
      Part first = Part();
      first.ring = r.tag;
      first.source = rail;
      for (auto p = std::lower_bound(all.begin(), all.end(), first); p != all.end() && p->ring == r.tag; ++p) {
        r.force += Vec3::from(p->force);
        r.torque += Vec3::from(p->torque);
      }
    }
  }
  for (Ring &r : rings_) {
    if (r.i < atom->nlocal) {
      r.force.add_to(atom->f[r.i]);
      r.torque.add_to(atom->torque[r.i]);
    }
    r.force = r.torque = Vec3();
  }
}

}    // namespace bearing
