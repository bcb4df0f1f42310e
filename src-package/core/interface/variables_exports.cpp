// SPDX-License-Identifier: GPL-2.0-or-later
// Writes the deck variables as JSON, for Python and the documentation, checks names in data files
// and values of variables, and chooses the usual cage.
#include "../settings/deck_variable_table.h"
#include "../settings/usual_cage.h"
#include "../settings/written.h"
#include "json_text.h"

static std::string variables_text()
{
  JsonText json;
  json.add("[\n");
  const auto &table = bearing::deck_variables();
  for (const bearing::DeckVariable &v : table)
    json.add("  {\"name\": \"%s\", \"default\": \"%s\", \"unit\": \"%s\", \"range\": \"%s\",\n"
             "   \"of\": \"%s\", \"meaning\": \"%s\", \"models\": \"%s\",\n"
             "   \"without_default\": \"%s\"}%s\n",
             v.name, v.initial, v.unit, v.range, v.of, v.meaning, v.models, v.without_default,
             &v == &table.back() ? "" : ",");
  json.add("]\n");
  return json.text;
}

extern "C" const char *variables_json()
{
  static const std::string text = variables_text();    // created once
  return text.c_str();
}

// Returns a message about the space-separated `names`. It is valid until the next call from this
// thread.
extern "C" const char *mistyped_name(const char *names)
{
  static thread_local std::string message;
  const std::vector<std::string> all = bearing::words_of(names);
  message = bearing::mistyped({all.begin(), all.end()});
  return message.c_str();
}

// Returns the reason why a variable cannot have a value, or "" if it can or is unknown. It is valid
// until the next call from this thread.
extern "C" const char *wrong_value(const char *name, const char *value)
{
  static thread_local std::string message;
  const bearing::DeckVariable *const of = bearing::find_deck_variable(name);
  message = of ? bearing::wrong_value(*of, value) : "";
  return message.c_str();
}

extern "C" const char *usual_cage(const char *models, const char *integrator, const char *lubricant,
                                  const char *cage_balls)
{
  return bearing::usual_cage(models, integrator, lubricant, *cage_balls != '\0');
}
