// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_words.h"

#include "../numbers/checksum.h"

#include <cstdio>
#include <map>
#include <set>
#include <utility>

namespace bearing {

using Key = std::pair<const LAMMPS_NS::LAMMPS *, std::string>;

static std::map<Key, std::string> &noted()
{
  static std::map<Key, std::string> words;
  return words;
}

static std::string sum_of(const std::string &text)
{
  char digits[9];
  snprintf(digits, sizeof digits, "%08x", checksum(text.data(), text.size()));
  return digits;
}

static bool is_fix(const std::string &command) { return command.compare(0, 4, "fix ") == 0; }

void note_words(const LAMMPS_NS::LAMMPS *lmp, const std::string &command,
                const std::vector<std::string> &words)
{
  static const std::set<std::string> of_continuing = {"resumed", "append", "overwrite"};
  if (!is_fix(command) && command != "create_bearing") return;
  std::string line = command;
  for (size_t k = 0; k < words.size(); ++k)
    if (of_continuing.count(words[k])) ++k;
    else if (words[k].find('/') == std::string::npos) line += " " + words[k];
  std::string &kept = noted()[{lmp, command}];
  kept = is_fix(command) || kept.empty() ? line : command + ": " + sum_of(kept + line);
}

void note_file(const LAMMPS_NS::LAMMPS *lmp, const std::string &command, const std::string &content)
{
  const auto at = noted().find({lmp, command});
  if (at != noted().end()) at->second += " (a file, checksum " + sum_of(content) + ")";
}

std::string noted_words(const LAMMPS_NS::LAMMPS *lmp, const std::string &command)
{
  const auto at = noted().find({lmp, command});
  return at == noted().end() ? "" : at->second;
}

}    // namespace bearing
