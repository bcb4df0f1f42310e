// SPDX-License-Identifier: GPL-2.0-or-later
// All parts of the contact law as data: what readers of keywords, error messages and tables in the
// docs go through. Made from what the parts say of themselves (part.h).
#ifndef RACEWAY_PART_TABLE_H
#define RACEWAY_PART_TABLE_H

#include "../parts/part.h"
#include "../raceway/raceway_physics.h"

#include <functional>
#include <string>
#include <vector>

namespace raceway {

struct ParameterEntry {
  std::string symbol, meaning;
  double least, most;
  bool open;
  std::vector<std::string> choices;    // of a word; empty for a number
  std::string initial;                 // what holds without the keyword, as text
};

struct KeywordEntry {
  std::string name, form;    // form "": none
  std::vector<ParameterEntry> parameters;
  std::function<void(RacewayPhysics &, const double *)> set;    // and switches its part on
  const char *(*wrong)(const double *);                         // or null
  std::string note;
};

struct PartEntry {
  std::string name, slot;
  When when;
  bool film;            // needs a lubricant
  std::string needs;    // name of another part, or ""
  int states;
  std::vector<KeywordEntry> keywords;
  std::vector<StateColumn> columns;
};

const std::vector<PartEntry> &part_table();

// "hertz + hysteresis + normal_force", for messages
std::string law_text(unsigned parts);

// Why no contact can have these parts; "" if it can. Sets that keywords make have one part of a
// slot at most.
std::string contradiction(unsigned parts);

}    // namespace raceway

#endif
