// SPDX-License-Identifier: GPL-2.0-or-later
// The variables of decks as JSON, for Python and the pages.
#include "../settings/deck_variable_table.h"
#include "json_text.h"

static std::string written()
{
  JsonText json;
  json.add("[\n");
  const auto &table = bearing::deck_variables();
  for (const bearing::DeckVariable &v : table)
    json.add("  {\"name\": \"%s\", \"default\": \"%s\", \"unit\": \"%s\", \"range\": \"%s\",\n"
             "   \"of\": \"%s\", \"meaning\": \"%s\", \"models\": \"%s\"}%s\n",
             v.name, v.initial, v.unit, v.range, v.of, v.meaning, v.models,
             &v == &table.back() ? "" : ",");
  json.add("]\n");
  return json.text;
}

extern "C" const char *variables_json()
{
  static const std::string text = written();    // once, whatever the number of threads
  return text.c_str();
}
