// SPDX-License-Identifier: GPL-2.0-or-later
#include "formulas.h"

#include "bearing_compat.h"

#include <cctype>
#include <set>

using namespace LAMMPS_NS;

namespace bearing {

// The hosts evaluate formulas, but have no function that returns the text of a formula or the style
// of a variable. The private members are therefore accessed through an explicit instantiation,
// which is allowed to name them.
typedef char ***Variable::*Texts;
typedef int *Variable::*Styles;
Texts texts_of_variables();
Styles styles_of_variables();

template <Texts texts, Styles styles> struct Opened {
  friend Texts texts_of_variables() { return texts; }
  friend Styles styles_of_variables() { return styles; }
};
template struct Opened<&Variable::data, &Variable::style>;

constexpr int INDEX_STYLE = 0, STRING_STYLE = 5;    // as in variable.cpp or variable.h of all hosts

static bool in_name(char c) { return isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Returns the text of a variable, or an empty string if no variable has that name.
static std::string text_of(LAMMPS *lmp, const std::string &name)
{
  Variable &all = *lmp->input->variable;
  char *own = const_cast<char *>(name.c_str());
  const int k = all.find(own);
  if (k < 0) return "";
  if (all.equalstyle(k) || all.atomstyle(k)) return (all.*texts_of_variables())[k][0];
  const int style = (all.*styles_of_variables())[k];
  return style == INDEX_STYLE || style == STRING_STYLE ? all.retrieve(own) : "";
}

static void add(LAMMPS *lmp, const std::string &text, std::set<std::string> &seen,
                std::vector<std::string> &lines)
{
  for (size_t at = text.find("v_"); at != std::string::npos; at = text.find("v_", at + 2)) {
    if (at > 0 && in_name(text[at - 1])) continue;
    size_t end = at + 2;
    while (end < text.size() && in_name(text[end])) ++end;
    const std::string name = text.substr(at + 2, end - at - 2);
    if (!seen.insert(name).second) continue;
    const std::string own = text_of(lmp, name);
    if (own.empty()) continue;
    lines.push_back("variable " + name + " = " + own);
    add(lmp, own, seen, lines);
  }
}

std::vector<std::string> formulas(LAMMPS *lmp, const std::vector<std::string> &commands)
{
  std::set<std::string> seen;
  std::vector<std::string> lines;
  for (const std::string &command : commands) add(lmp, command, seen, lines);
  return lines;
}

}    // namespace bearing
