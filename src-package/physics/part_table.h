// SPDX-License-Identifier: GPL-2.0-or-later
// All parts of the contact law as data: what readers of keywords, error messages and tables in the
// docs go through. Made from what the parts say of themselves (part.h).
#ifndef RACEWAY_PART_TABLE_H
#define RACEWAY_PART_TABLE_H

#include "contact.h"

#include <functional>
#include <string>
#include <vector>

namespace raceway {

struct KeywordEntry {
  std::string name, form;    // form "": none
  std::vector<Parameter> parameters;
  std::function<void(RacewayPhysics &, const double *)> set;    // and switches its part on
  const char *(*wrong)(const double *);                         // or null
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

template <class Part> PartEntry part_entry()
{
  PartEntry e = {Part::name,     Part::slot,
                 Part::when,     Part::when == When::with_film || NeedsFilm<Part>::value,
                 Part::states,   {},
                 Part::columns()};
  for (const auto &k : Part::keywords()) {
    const auto set = k.set;
    const bool chooses = k.chooses;
    e.keywords.push_back({k.name, k.form, k.parameters,
                          [set, chooses](RacewayPhysics &p, const double *values) {
                            set(p, p.of<Part>(), values);
                            if (chooses) p.choose<Part>();
                          },
                          k.wrong});
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
