// SPDX-License-Identifier: GPL-2.0-or-later
#include "raceway_options.h"

#include "../contact/part_table.h"

using namespace raceway;

namespace bearing {

namespace {

double read(Arguments &args, const ParameterEntry &p)
{
  if (!p.choices.empty()) return args.choice(p.meaning, p.choices);
  if (std::isfinite(p.most)) return args.within(p.meaning, p.least, p.most);
  return p.open ? args.positive(p.meaning) : args.non_negative(p.meaning);
}

void read_values(Arguments &args, const KeywordEntry &k, RacewayPhysics &p)
{
  std::vector<double> values;
  std::string said = k.name;
  for (const ParameterEntry &parameter : k.parameters) {
    values.push_back(read(args, parameter));
    said += " " + text(values.back());
  }
  if (const char *why = k.wrong ? k.wrong(values.data()) : nullptr) args.fail(said + ": " + why);
  k.set(p, values.data());
}

// Returns a form such as "constant MU".
std::string form_text(const KeywordEntry &k)
{
  std::string s = k.form;
  for (const ParameterEntry &p : k.parameters) s += " " + p.symbol;
  return s;
}

// Reads a keyword that is followed by one of several words, such as "friction none|constant
// MU|...".
void read_form(Arguments &args, const std::string &name, bool with_film, RacewayPhysics &p)
{
  if (args.take("none")) {    // leaves the slot of this keyword empty
    for (size_t k = 0; k < part_table().size(); ++k)
      if (part_table()[k].slot == name) p.parts &= ~(1u << k);
    return;
  }
  std::string allowed = "none", more;
  for (const PartEntry &part : part_table())
    for (const KeywordEntry &k : part.keywords) {
      if (k.name != name || k.form.empty()) continue;
      if (part.film && !with_film) {
        more += " (" + k.form + " needs pair_style bearing/ehd)";
        continue;
      }
      if (args.take(k.form.c_str())) {
        read_values(args, k, p);
        return;
      }
      allowed += ", " + form_text(k);
    }
  args.fail(name + " '" + args.word(name + " law") + "', must be one of: " + allowed + more);
}

}    // namespace

bool read_raceway_keyword(Arguments &args, bool with_film, RacewayPhysics &p)
{
  for (const PartEntry &part : part_table())
    for (const KeywordEntry &k : part.keywords) {
      if ((part.film && !with_film) || !args.take(k.name.c_str())) continue;
      if (k.form.empty()) read_values(args, k, p);
      else read_form(args, k.name, with_film, p);
      return true;
    }
  return false;
}

}    // namespace bearing
