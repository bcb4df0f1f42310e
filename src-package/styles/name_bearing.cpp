// SPDX-License-Identifier: GPL-2.0-or-later
#include "name_bearing.h"

#include "../core/geometry/cage_ring.h"
#include "../core/settings/data_table.h"
#include "../core/settings/usual_cage.h"
#include "../deck/given_variables.h"
#include "derive_data.h"
#include "named_bearing.h"
#include "print_line.h"

using namespace LAMMPS_NS;
using bearing::Arguments;
using bearing::DataValues;
using bearing::NamedBearing;

// Removes a setting that does not belong to the data of the bearing, and returns its value or its
// default.
static std::string setting(DataValues::Map &words, const char *variable)
{
  const auto word = words.extract(variable);
  return word.empty() ? bearing::usual_word(variable) : word.mapped();
}

void NameBearing::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing", narg, arg, 0);
  NamedBearing b;
  b.name = args.word("name");
  if (b.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") !=
      std::string::npos)
    args.fail("the name '" + b.name + "' must consist of letters, digits and '_'");
  const std::string data = args.word("bearing of the catalogue, or a file");
  DataValues::Map own;
  while (args.more()) {
    if (args.take("types")) {
      for (int *type : {&b.balls, &b.cage, &b.inner, &b.outer})
        *type = args.integer("atom type", 1, 1000);
    } else if (!args.variable_of("bearing", own)) {
      args.unknown();
    }
  }
  if (!b.balls) args.fail("'types BALLS CAGE INNER OUTER' is missing");
  const int types[] = {b.balls, b.cage, b.inner, b.outer};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      if (types[i] == types[j]) args.fail("types: balls, cage balls and both rings need their own");
  const std::string inputs = setting(own, "inputs");
  std::string cage = setting(own, "cage");
  refuse_unknown(args, inputs);
  b.data = bearing::read_data(lmp, args, inputs, "bearings", data);
  b.given = bearing::given_of(b.data, {"bearing data", "usual data"});
  const std::string balls = cage_ball_datum(b);
  if (cage == "auto") cage = usual_cage(!balls.empty());
  b.has_cage = cage == "yes" || cage == "chain";
  b.has_cage_ring = cage == "ring";
  if (b.has_cage_ring && !balls.empty())
    args.fail(balls + " belongs to a cage of balls, but the cage of bearing " + b.name +
              " is a ring: give it cage_play, or choose 'cage chain'");
  for (const auto &value : own) b.data.values[value.first] = value.second;
  b.data.values.emplace("bearing", data);
  if (const std::string note = bearing::note_of_deck(b.data); !note.empty())
    bearing::print_line(lmp, note);
  derive(args, b);
  set_variables(b);
  bearing::keep_bearing(lmp, b);
}

void NameBearing::refuse_unknown(const Arguments &args, const std::string &inputs)
{
  std::string complaint;
  if (comm->me == 0) {
    bearing::DeckNames deck;
    bearing::collect_deck(infile, deck);
    bearing::Names names = deck.settable;
    for (const bearing::DeckVariable &v : bearing::deck_variables())
      if (v.of_data()) names.insert(v.name);
    for (const char *sort : {"/bearings", "/lubricants"})
      bearing::collect_folder(inputs + sort, names);
    const bearing::Names given = bearing::words_after("-var", "-v");
    for (const std::string &set : given) {
      // the word after an option -v of another program, such as python, is not a variable
      const auto value = bearing::host_variable(lmp, set);
      if (deck.settable.empty() || !value) continue;
      const std::string wrong = names.count(set)
                                    ? bearing::wrong_with(*value)
                                    : ": the deck has no such variable, nearest is '" +
                                          bearing::near_first(set, names).front() + "'";
      if (!wrong.empty()) complaint += (complaint.empty() ? "-var " : "; -var ") + set + wrong;
    }
    // variables for later commands are also checked, so that wrong values are detected before the
    // run starts
    const std::string file = bearing::deck_name(infile);
    bool main = true;    // true for a complete main deck, which converts rpm by a formula
    for (const bearing::DeckVariable &v : bearing::variables_of("deck"))
      main = main && deck.settable.count(v.name);
    for (const bearing::DeckVariable &v : bearing::deck_variables()) {
      const bool ours = v.taken_by("deck") ? main : deck.passed.count(v.name) || v.taken_by(file);
      if (!ours || !complaint.empty()) continue;
      const auto value = bearing::host_variable(lmp, v.name);
      const std::string wrong = value ? bearing::wrong_value(v, *value) : "";
      if (wrong.empty()) continue;
      complaint = wrong;
      if (!given.count(v.name))
        complaint += ". It is variable " + std::string(v.name) +
                     " of the deck: rename it if it has another meaning";
    }
  }
  complaint = bearing::of_first_rank(lmp, complaint);
  if (!complaint.empty()) args.fail(complaint);
}

// Returns the name of data for cage balls that the user has set, or an empty string.
std::string NameBearing::cage_ball_datum(const NamedBearing &b)
{
  for (const std::string &given : b.given)
    for (const std::string name : {"cage_ball_diameter", "pocket_play"})
      if (given.compare(0, name.size() + 1, name + "=") == 0) return name;
  return "";
}

// Returns the kind of cage for `cage auto` with the variables of the deck.
std::string NameBearing::usual_cage(bool cage_balls)
{
  const auto given = [&](const char *variable) {
    return bearing::host_variable(lmp, variable).value_or("");
  };
  return bearing::usual_cage(given("models"), given("integrator"), given("lubricant"), cage_balls);
}

// Completes the data and derives the dimensions of the raceways, including their clearance or their
// arches.
void NameBearing::derive(const Arguments &args, NamedBearing &b)
{
  DataValues::Map &map = b.data.values;
  for (const char *key : {"clearance", "contact_angle", "four_point"}) {
    map.emplace(key, bearing::usual_word(key));
    bearing::check_datum(args, b.data, *bearing::find_deck_variable(key));
  }
  DataValues values(args, map, b.data.label);
  bearing::derive_materials(values, map, b.data.of_file);
  const bool usual = map.count("pitch_diameter") && !map.count("inner_radius");
  if (usual || map.count("inner_conformity")) {
    values.suggest("pocket_play", raceway::usual_play * values.number("ball_diameter"));
    bearing::check_data(args, b.data, "usual data");
    bearing::derive_usual_data(values);
  } else if (values.number("contact_angle") != 0.0) {
    args.fail("contact_angle is " + map["contact_angle"] +
              ", must be 0 (other angles need a bearing with usual data, such as 7208)");
  }
  bearing::check_data(args, b.data, "bearing data");
  // rounded to the same number of digits as by the formula of the host in earlier decks
  values.set("b_outer_raceway", values.number("outer_radius") + 0.5 * values.number("clearance"));
  values.set("b_box", 1.3 * values.number("b_outer_raceway"));
  bearing::derive_raceways(values);
}

// Sets the variables with numbers that a deck uses in formulas or prints.
void NameBearing::set_variables(const NamedBearing &b)
{
  const auto set = [&](const std::string &name, const std::string &value) {
    bearing::pass_words({b.name + "_" + name, "string", value},
                        [this](int n, char **words) { input->variable->set(n, words); });
  };
  const auto number = [&](const std::string &name, double value) {
    set(name, bearing::digits(value));
  };
  for (const bearing::DeckVariable &v : bearing::variables_of("bearing data"))
    set(v.name, b.word(v.name));
  set("inner_radius", b.word("b_inner_raceway"));
  set("outer_radius", b.word("b_outer_raceway"));
  set("clearance", b.word("clearance"));
  number("ball_radius", 0.5 * b.number("ball_diameter"));
  number("pitch_radius", 0.5 * (b.number("b_inner_raceway") + b.number("b_outer_raceway")));
  number("groove_distance",
         b.number("inner_groove") + b.number("outer_groove") - b.number("ball_diameter"));
  number("skin", 0.4 * b.number("ball_diameter"));
  set("box", b.word("b_box"));
  set("cage_style", b.has_cage_ring ? "cage/ring" : "cage");
  // numbered as in create_bearing: balls, cage balls, both rings, one-piece cage
  number("inner_atom", b.number("balls") * (b.has_cage ? 2.0 : 1.0) + 1.0);
}
