// SPDX-License-Identifier: GPL-2.0-or-later
// Prints the variables of decks as JSON, which `make columns` stores for Python and the pages.
// Needs no host.
#include "../core/settings/deck_variable_table.h"

#include <cstdio>

// The texts of the table contain no quotes, backslashes or control characters.
int main()
{
  printf("[\n");
  const auto &table = bearing::deck_variables();
  for (const bearing::DeckVariable &v : table)
    printf("  {\"name\": \"%s\", \"default\": \"%s\", \"unit\": \"%s\", \"range\": \"%s\",\n"
           "   \"of\": \"%s\", \"meaning\": \"%s\"}%s\n",
           v.name, v.initial, v.unit, v.range, v.of, v.meaning, &v == &table.back() ? "" : ",");
  printf("]\n");
  return 0;
}
