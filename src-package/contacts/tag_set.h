// SPDX-License-Identifier: GPL-2.0-or-later
// A set of atom tags whose lookup is fast enough to be done for every contact.
#pragma once

#include "../core/numbers/tag.h"

#include <algorithm>
#include <vector>

namespace bearing {

class TagSet {
 public:
  TagSet() = default;
  explicit TagSet(const std::vector<tag_t> &tags)
  {
    if (tags.empty()) return;
    const auto ends = std::minmax_element(tags.begin(), tags.end());
    first_ = *ends.first;
    in_.assign(static_cast<size_t>(*ends.second - first_) + 1, 0);
    for (tag_t t : tags) in_[static_cast<size_t>(t - first_)] = 1;
  }
  bool has(tag_t t) const
  {
    const size_t at = static_cast<size_t>(t - first_);    // very large if t is below first_
    return at < in_.size() && in_[at];
  }

 private:
  tag_t first_ = 0;
  std::vector<char> in_;    // one entry per tag, from the first to the last
};

}    // namespace bearing
