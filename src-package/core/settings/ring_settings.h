// SPDX-License-Identifier: GPL-2.0-or-later
// Ring motion as set in a deck: degrees of freedom, inertia, loads and supports.
#ifndef BEARING_RING_SETTINGS_H
#define BEARING_RING_SETTINGS_H

#include "../bodies/ring_program.h"
#include "../numbers/lab_axes.h"
#include "driven_value.h"

namespace bearing {

struct RingSettings {
  raceway::RingProgram program;    // of all rings, without targets and loads
  DrivenValue value[raceway::RingProgram::N_VALUE];
  std::string holder;    // group of the ring that the supports hold to; empty: the ground
};

// Reads them, keyword by keyword.
class RingWords {
 public:
  // each: values may differ from ring to ring
  RingWords(Arguments &args, const raceway::LabAxes &axes, RingSettings &to, bool each);
  bool take();                  // a keyword and its values; false: the next word is not one of
                                // these
  void check() const;           // after all words: checks words that depend on one another
  std::string known() const;    // all keywords, for messages

 private:
  using RingProgram = raceway::RingProgram;
  void read_freedom(const std::string &name, int dof);
  bool take_freedom();
  void read_vector(int first, const std::string &what);
  void read_inertia();
  void read_support();
  const char *name_of(int dof) const;    // of a displacement or a tilt

  Arguments &args_;
  raceway::LabAxes axes_;
  RingSettings &to_;
  bool each_;
  int number_[3];    // of a lab axis; the bearing axis is the third
};

}    // namespace bearing

#endif
