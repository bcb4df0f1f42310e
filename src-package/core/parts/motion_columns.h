// SPDX-License-Identifier: GPL-2.0-or-later
// Output columns for the motions of a contact; the columns for its forces are defined by the parts
// of the law.
#pragma once

#include "part.h"

namespace raceway {

inline std::vector<StateColumn> motion_columns()
{
  return {{{"angle", "rad",
            "contact angle, positive if the inner ring is pushed along the positive axis"},
           [](const Raceway &p, const ContactState &s) {
             return std::atan2(p.groove.side == Side::inner ? -s.ne : s.ne, std::fabs(s.nu));
           }},
          {{"overlap", "m", "elastic approach"}, &ContactState::overlap},
          {{"entrainment", "m/s", "entrainment speed along rolling"}, &ContactState::entrainment},
          {{"sliding", "m/s", "speed of the ball's surface relative to that of the ring"},
           [](const Raceway &, const ContactState &s) {
             return std::hypot(s.sliding_t, s.sliding_w);
           }}};
}

}    // namespace raceway
