// SPDX-License-Identifier: GPL-2.0-or-later
// All parts of the contact law as data: what readers of keywords, error messages and tables in the
// docs go through. Made from what the parts say of themselves (part.h).
#ifndef RACEWAY_PART_TABLE_H
#define RACEWAY_PART_TABLE_H

#include "loss_table.h"

#include <cstdio>
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
  bool film;    // needs a lubricant
  int states;
  std::vector<KeywordEntry> keywords;
  std::vector<StateColumn> columns;
};

namespace detail {
template <class Part, class = void> struct NeedsFilm : std::false_type {};
template <class Part>
struct NeedsFilm<Part, std::enable_if_t<Part::needs_film>> : std::true_type {};

inline std::vector<std::string> words(const char *text)
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
  PartEntry e = {Part::name,     Part::slot,
                 Part::when,     Part::when == When::with_film || NeedsFilm<Part>::value,
                 Part::states,   {},
                 Part::columns()};
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
template <class... L> std::vector<unsigned> law_parts(LawList<L...>) { return {L::parts...}; }
}    // namespace detail

inline const std::vector<PartEntry> &part_table()
{
  static const std::vector<PartEntry> table = detail::part_entries(Parts());
  return table;
}

// The sets of parts that are compiled.
inline const std::vector<unsigned> &compiled_laws()
{
  static const std::vector<unsigned> laws = detail::law_parts(Laws());
  return laws;
}

// "hertz + hysteresis + normal_force", for messages
inline std::string law_text(unsigned parts)
{
  std::string s;
  for (size_t k = 0; k < part_table().size(); ++k)
    if (parts & (1u << k)) s += (s.empty() ? "" : " + ") + part_table()[k].name;
  return s;
}

}    // namespace raceway

#endif
