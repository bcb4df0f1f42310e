// SPDX-License-Identifier: GPL-2.0-or-later
// One bearing of the host in the hands of an implicit step (implicit/bearing_step.h): names with
// the bearing axis third, a cyclic change when the axis is x or y, and back.
#ifndef BEARING_IMPLICIT_BEARING_H
#define BEARING_IMPLICIT_BEARING_H

#include "../implicit/bearing_step.h"
#include "../ranks/bearing_parts.h"

#include <memory>

namespace bearing {

class ImplicitBearing {
 public:
  ImplicitBearing(const LAMMPS_NS::PairBearingHertz &, const PartModel &);

  void load(const std::vector<BodyState> &, const std::vector<RingFullState> &);
  void store(std::vector<BodyState> &, std::vector<RingFullState> &) const;
  raceway::BearingStep &step() { return *step_; }
  const raceway::BearingStep &step() const { return *step_; }
  tag_t tag(int body) const { return tags_[body]; }

 private:
  using Vec3 = raceway::Vec3;
  Vec3 in(const Vec3 &v) const
  {
    return axis_ == 2 ? v : axis_ == 0 ? Vec3{v.y, v.z, v.x} : Vec3{v.z, v.x, v.y};
  }
  Vec3 out(const Vec3 &v) const
  {
    return axis_ == 2 ? v : axis_ == 0 ? Vec3{v.z, v.x, v.y} : Vec3{v.y, v.z, v.x};
  }

  int axis_;
  std::vector<tag_t> tags_;
  std::vector<const LAMMPS_NS::FixBearingRing *> fixes_;
  std::vector<std::vector<LAMMPS_NS::FixBearingRing::OwnValue>> own_;    // by ring
  std::unique_ptr<raceway::BearingStep> step_;
  mutable std::vector<raceway::BodyPose> bodies_;
  mutable std::vector<raceway::RingPose> rings_;
};

}    // namespace bearing

#endif
