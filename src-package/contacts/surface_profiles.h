// SPDX-License-Identifier: GPL-2.0-or-later
// Profiles of the raceways of each ring and of balls, i.e. deviations of the surfaces from a torus
// or a sphere.
#pragma once

#include "../core/numbers/tag.h"
#include "../core/raceway/profiled_contact.h"
#include "../core/raceway/raceway_physics.h"

#include <map>

namespace bearing {

class SurfaceProfiles {
 public:
  using Raceway = const raceway::RacewayPhysics *;

  void clear()
  {
    of_rings_.clear();
    of_balls_.clear();
  }
  void add(tag_t ring, Raceway p, const raceway::ProfileShape &shape)
  {
    of_rings_.try_emplace({ring, p}, shape, p->groove.raceway_radius, p->rolling_radius(1.0),
                          p->law.radial().a);
  }
  void add(tag_t ball, Raceway p, const raceway::BallShape &shape)
  {
    of_balls_.try_emplace({ball, p}, shape, p->groove.ball_radius, p->rolling_radius(1.0),
                          p->law.radial().a, p->law.radial().K);
  }
  // Returns the profile of a ring's raceway, or null if there is none.
  const raceway::RacewayProfile *of_ring(tag_t ring, Raceway p) const
  {
    return get(of_rings_, ring, p);
  }
  const raceway::BallProfile *of_ball(tag_t ball, Raceway p) const
  {
    return get(of_balls_, ball, p);
  }
  bool any_ball() const { return !of_balls_.empty(); }
  bool any() const { return any_ball() || !of_rings_.empty(); }

 private:
  template <class Profile> using Table = std::map<std::pair<tag_t, Raceway>, Profile>;
  template <class Profile> static const Profile *get(const Table<Profile> &in, tag_t of, Raceway p)
  {
    const auto it = in.find({of, p});
    return it == in.end() ? nullptr : &it->second;
  }

  Table<raceway::RacewayProfile> of_rings_;
  Table<raceway::BallProfile> of_balls_;
};

}    // namespace bearing
