// SPDX-License-Identifier: GPL-2.0-or-later
#include "different_lines.h"

#include "../core/settings/written.h"

#include <algorithm>

namespace bearing {

namespace {

constexpr size_t longest_difference = 8;    // words

std::string missing_line(const std::vector<std::string> &list,
                         const std::vector<std::string> &other)
{
  for (const std::string &line : list)
    if (!line.empty() && std::find(other.begin(), other.end(), line) == other.end()) return line;
  return "";
}

// Shortens two command lines to the name of the command and the words from the first difference to
// the last.
void leave_difference(std::string &one, std::string &other)
{
  const std::vector<std::string> words[2] = {words_of(one), words_of(other)};
  std::string *const lines[2] = {&one, &other};
  const size_t shorter = std::min(words[0].size(), words[1].size());
  size_t first = 0, last = 0;    // numbers of equal words at the start and at the end
  while (first < shorter && words[0][first] == words[1][first]) ++first;
  while (last < shorter - first && words[0].end()[-1 - last] == words[1].end()[-1 - last]) ++last;
  for (int k = 0; k < 2; ++k) {
    // start a few words before the first difference, unless that would include the command itself
    const size_t from = first > 6 ? first - 3 : 0;
    const size_t end = words[k].size() - last, to = std::min(end, from + longest_difference);
    *lines[k] = (from ? words[k][0] + " ... " : "") +
                joined({words[k].begin() + from, words[k].begin() + to}, " ") +
                (to < words[k].size() ? " ..." : "");
  }
}

}    // namespace

std::pair<std::string, std::string> different_lines(const std::vector<std::string> &one,
                                                    const std::vector<std::string> &other)
{
  std::pair<std::string, std::string> lines = {missing_line(one, other), missing_line(other, one)};
  if (!lines.first.empty() && !lines.second.empty()) leave_difference(lines.first, lines.second);
  return lines;
}

}    // namespace bearing
