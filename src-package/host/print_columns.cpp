// SPDX-License-Identifier: GPL-2.0-or-later
// Prints every output column as JSON: `make columns` keeps it for Python and the pages. No host.
#include "../contacts/bearing_columns.h"
#include "../contacts/contact_columns.h"

#include <cstdio>

using raceway::Column;

// The texts of the tables hold neither quotes nor backslashes nor control characters.
static void print(const Column &c, const char *more, bool last)
{
  printf("    {\"name\": \"%s\", \"unit\": \"%s\", \"meaning\": \"%s\", \"absent\": ", c.name,
         c.unit, c.meaning);
  printf(std::isnan(c.absent) ? "null" : "%.17g", c.absent);
  printf(", \"format\": \"%s\"%s}%s\n", c.format, more, last ? "" : ",");
}

template <size_t n> static void section(const char *name, const Column (&list)[n])
{
  printf("  ],\n  \"%s\": [\n", name);
  for (size_t k = 0; k < n; ++k) print(list[k], "", k + 1 == n);
}

int main()
{
  printf("{\n  \"contact\": [\n");
  const auto &contacts = bearing::contact_columns();
  const char *const needs[] = {"nothing", "film", "capacitance"};
  for (const bearing::ContactColumn &c : contacts)
    print(c.is,
          (std::string(", \"needs\": \"") + needs[static_cast<int>(c.needs)] +
           "\", \"usual\": " + (c.usual ? "true" : "false"))
              .c_str(),
          &c == &contacts.back());
  section("ball", bearing::of_ball::list);
  section("ring", bearing::of_ring::list);
  section("total", bearing::of_total::list);
  section("atom", bearing::of_atom::list);
  printf("  ]\n}\n");
  return 0;
}
