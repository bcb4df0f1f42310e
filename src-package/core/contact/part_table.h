// SPDX-License-Identifier: GPL-2.0-or-later
// All parts of the contact law as data. This table is used to read keywords and to generate error
// messages and the tables in the docs. It is generated from the declarations of the parts (part.h).
#pragma once

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
  std::vector<std::string> choices;    // words that the keyword accepts; empty for a number
  std::string initial;                 // default value, as text
};

struct KeywordEntry {
  std::string name, form;    // form is "" if there is none
  std::vector<ParameterEntry> parameters;
  std::function<void(RacewayPhysics &, const double *)> set;    // also enables the keyword's part
  const char *(*wrong)(const double *);                         // or null
  std::string note;
};

struct PartEntry {
  std::string name, slot;
  When when;
  bool film;            // needs a lubricant
  std::string needs;    // name of another part that this part requires, or ""
  int states;
  std::vector<KeywordEntry> keywords;
  std::vector<StateColumn> columns;
};

const std::vector<PartEntry> &part_table();

// Returns for example "hertz + hysteresis + normal_force", for use in messages.
std::string law_text(unsigned parts);

// Returns the reason why a contact cannot have this set of parts, or "" if it can. A set that
// results from keywords has at most one part per slot.
std::string contradiction(unsigned parts);

}    // namespace raceway
