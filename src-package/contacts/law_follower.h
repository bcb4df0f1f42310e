// SPDX-License-Identifier: GPL-2.0-or-later
// An object that changes the contact law between steps, such as a fix that computes temperatures.
#pragma once

namespace bearing {

class LawFollower {
 public:
  // Called before the bodies move in a step. It has an effect only once per step, regardless of how
  // often it is called.
  virtual void begin_step() = 0;

 protected:
  ~LawFollower() = default;
};

}    // namespace bearing
