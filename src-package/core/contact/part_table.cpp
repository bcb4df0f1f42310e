// SPDX-License-Identifier: GPL-2.0-or-later
#include "part_table.h"

#include "contact.h"
#include "loss_table.h"

#include <cstdio>

namespace raceway {

namespace {
std::vector<std::string> words(const char *text)
{
  std::vector<std::string> list;
  for (const char *c = text; c && *c; ++c) {
    if (list.empty() || *c == '|') list.emplace_back();
    if (*c != '|') list.back() += *c;
  }
  return list;
}

template <class Part> ParameterEntry parameter_entry(const Parameter<typename Part::Parameters> &p)
{
  ParameterEntry e = {p.symbol, p.meaning, p.least, p.most, p.open, words(p.choices), ""};
  RacewayPhysics initial;
  if (p.unset) {
    e.initial = p.unset;
  } else if (p.choices) {
    e.initial = e.choices.front();
  } else {
    char number[32];
    snprintf(number, sizeof number, "%g", p.number(initial, initial.of<Part>()));
    e.initial = number;
  }
  return e;
}

template <class Part> PartEntry part_entry()
{
  PartEntry e = {
      Part::name,  Part::slot,   Part::when, Part::when == When::with_film || Part::needs_film,
      Part::needs, Part::states, {},         Part::columns()};
  for (const LossEntry &loss : loss_table())
    if (loss.parts & Parts::bit<Part>()) e.columns.push_back(loss.column());
  for (const auto &k : Part::keywords()) {
    std::vector<ParameterEntry> parameters;
    for (const auto &p : k.parameters) parameters.push_back(parameter_entry<Part>(p));
    e.keywords.push_back({k.name, k.form, parameters,
                          [k](RacewayPhysics &p, const double *values) {
                            for (const auto &parameter : k.parameters) {
                              if (parameter.choose) parameter.choose(p, p.of<Part>(), int(*values));
                              else parameter.number(p, p.of<Part>()) = *values;
                              ++values;
                            }
                            if (k.chooses) p.choose<Part>();
                          },
                          k.wrong, k.note});
  }
  return e;
}
template <class... P> std::vector<PartEntry> part_entries(PartList<P...>)
{
  return {part_entry<P>()...};
}
}    // namespace

const std::vector<PartEntry> &part_table()
{
  static const std::vector<PartEntry> table = part_entries(Parts());
  return table;
}

std::string law_text(unsigned parts)
{
  std::string s;
  for (size_t k = 0; k < part_table().size(); ++k)
    if (parts & (1u << k)) s += (s.empty() ? "" : " + ") + part_table()[k].name;
  return s;
}

std::string contradiction(unsigned parts)
{
  const std::vector<PartEntry> &table = part_table();
  const auto has = [parts](size_t k) { return (parts & (1u << k)) != 0; };
  for (size_t k = 0; k < table.size(); ++k) {
    if (!has(k)) continue;
    const PartEntry &part = table[k];
    const std::string law = "the contact law " + law_text(parts) + " has " + part.name;
    if (part.film && !law_facts(parts).film) return law + ", which requires a film";
    bool found = part.needs.empty();
    for (size_t i = 0; i < table.size(); ++i) {
      found |= has(i) && table[i].name == part.needs;
      if (i > k && has(i) && !part.slot.empty() && table[i].slot == part.slot)
        return law + " and " + table[i].name + ", which exclude each other";
    }
    if (!found) return law + " but not " + part.needs + ", which it requires";
  }
  return "";
}

}    // namespace raceway
