// SPDX-License-Identifier: GPL-2.0-or-later
// Writes all output columns, the parts of the contact law and the rules of validity as JSON, for
// Python and the documentation.
#include "../contact/part_table.h"
#include "../figures/bearing_columns.h"
#include "../figures/bearing_figures.h"
#include "../figures/contact_columns.h"
#include "../figures/fix_columns.h"
#include "../raceway/validity.h"
#include "json_text.h"

using raceway::Column;

static JsonText json;

// Nothing is escaped, because the texts of the tables contain no quotes, backslashes or control
// characters.
static void print(const Column &c, const char *more, bool last)
{
  json.add("    {\"name\": \"%s\", \"unit\": \"%s\", \"meaning\": \"%s\", \"absent\": ", c.name,
           c.unit, c.meaning);
  json.add(std::isnan(c.absent) ? "null" : "%.17g", c.absent);
  json.add(", \"format\": \"%s\"%s}%s\n", c.format, more, last ? "" : ",");
}

static void print(const raceway::ParameterEntry &p, bool last)
{
  std::string choices;
  for (const std::string &c : p.choices) choices += (choices.empty() ? "\"" : ", \"") + c + "\"";
  json.add("\n        {\"symbol\": \"%s\", \"meaning\": \"%s\", \"least\": %g, \"most\": ",
           p.symbol.c_str(), p.meaning.c_str(), p.least);
  json.add(std::isfinite(p.most) ? "%g" : "null", p.most);
  json.add(", \"open\": %s, \"choices\": [%s], \"initial\": \"%s\"}%s", p.open ? "true" : "false",
           choices.c_str(), p.initial.c_str(), last ? "" : ",");
}

template <size_t n> static void section(const char *name, const Column (&list)[n])
{
  json.add("  ],\n  \"%s\": [\n", name);
  for (size_t k = 0; k < n; ++k) print(list[k], "", k + 1 == n);
}

static void section(const char *name, const std::vector<bearing::Figure> &list,
                    const std::vector<Column> &before = {})
{
  json.add("  ],\n  \"%s\": [\n", name);
  for (const Column &c : before) print(c, "", false);
  for (const bearing::Figure &f : list) {
    const std::string key = *f.key ? ", \"loss\": \"" + std::string(f.key) + "\"" : "";
    print(f.is, key.c_str(), &f == &list.back());
  }
}

// Writes the parts of the contact law with their names, conditions of use, numbers of state
// variables per contact, and keywords.
static void print_law()
{
  const char *const when[] = {"always", "with a lubricant", "on request"};
  json.add("  \"law\": [\n");
  for (const raceway::PartEntry &part : raceway::part_table()) {
    const bool last = &part == &raceway::part_table().back();
    json.add(
        "    {\"name\": \"%s\", \"when\": \"%s\", \"slot\": \"%s\", \"film\": %s, \"states\": %d,\n"
        "     \"columns\": [",
        part.name.c_str(), when[static_cast<int>(part.when)], part.slot.c_str(),
        part.film ? "true" : "false", part.states);
    for (const raceway::StateColumn &c : part.columns)
      json.add("%s\"%s\"", &c == &part.columns.front() ? "" : ", ", c.is.name);
    json.add("],\n     \"keywords\": [");
    for (const raceway::KeywordEntry &k : part.keywords) {
      json.add("%s\n      {\"name\": \"%s\", \"form\": \"%s\", \"parameters\": [",
               &k == &part.keywords.front() ? "" : ",", k.name.c_str(), k.form.c_str());
      for (const raceway::ParameterEntry &p : k.parameters) print(p, &p == &k.parameters.back());
      json.add("], \"note\": \"%s\"}", k.note.c_str());
    }
    json.add("]}%s\n", last ? "" : ",");
  }
  json.add("  ]\n");
}

static void print_validity()
{
  json.add("  \"validity\": [\n");
  for (int k = 0; k < raceway::Validity::N; ++k) {
    const raceway::Validity::Rule &r = raceway::Validity::rule(k);
    json.add("    {\"name\": \"%s\", \"value\": \"%s\", \"unit\": \"%s\", \"limit\": \"%s\", "
             "\"bound\": %.17g, \"below\": %s}%s\n",
             r.name, r.value, r.unit, r.limit, r.bound, r.below ? "true" : "false",
             k + 1 == raceway::Validity::N ? "" : ",");
  }
  json.add("  ],\n");
}

static std::string table_text()
{
  json.add("{\n  \"contact\": [\n");
  const auto &contacts = bearing::contact_columns();
  const char *const needs[] = {"nothing", "film", "capacitance", "surroundings"};
  for (const bearing::ContactColumn &c : contacts)
    print(c.is,
          (std::string(", \"needs\": \"") + needs[static_cast<int>(c.needs)] +
           "\", \"usual\": " + (c.usual ? "true" : "false"))
              .c_str(),
          &c == &contacts.back());
  section("ball", bearing::of_ball::list);
  section("ring", bearing::ring_figures(),
          {std::begin(bearing::of_ring::list), std::end(bearing::of_ring::list)});
  section("total", bearing::total_figures());
  section("bearing", bearing::record_figures());
  section("kind", bearing::of_kind::list);
  section("atom", bearing::of_atom::list);
  section("fix_ring", bearing::of_fix_ring::list);
  section("bend", bearing::of_bend::list);
  section("cage", bearing::of_cage::list);
  section("fix_implicit", bearing::of_fix_implicit::list);
  section("fix_cage", bearing::of_fix_cage::list);
  section("fix_capacitance", bearing::of_fix_capacitance::list);
  section("fix_circuit", bearing::of_fix_circuit::list);
  section("fix_grains", bearing::of_fix_grains::list);
  section("fix_heat", bearing::of_fix_heat::list);
  section("fix_timestep", bearing::of_fix_timestep::list);
  json.add("  ],\n");
  print_validity();
  print_law();
  json.add("}\n");
  return json.text;
}

extern "C" const char *columns_json()
{
  static const std::string text = table_text();    // created only once, even if there are several
                                                   // threads
  return text.c_str();
}
