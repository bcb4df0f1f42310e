// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_notes.h"

#include "../core/settings/arguments.h"
#include "../core/settings/deck_variable_table.h"
#include "../core/settings/written.h"
#include "find_record_layout.h"
#include "fix_bearing_heat.h"
#include "fix_bearing_implicit.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "named_bearing.h"
#include "pair_bearing.h"

#include <algorithm>
#include <map>

using namespace LAMMPS_NS;

namespace bearing {

namespace {

typedef NetcdfHeader::Attributes Attributes;
typedef std::map<std::string, std::string> Words;

// Returns the name of the integrator: implicit, damping, vibration or verlet.
std::string integrator_of(LAMMPS *lmp)
{
  const auto fixes = fixes_of<FixBearingImplicit>(lmp);
  return fixes.empty() ? "verlet" : std::string(fixes.front()->style).substr(8);
}

// Returns the kind of cage of the first bearing of the deck: ring, chain or no.
std::string cage_of(LAMMPS *lmp)
{
  for (const NamedBearing *b : bearings_of(lmp))
    if (b->in_use) return b->has_cage_ring ? "ring" : b->has_cage ? "chain" : "no";
  return "no";
}

// Returns the values that are chosen by the run if the deck does not set them.
Words chosen(LAMMPS *lmp, double within)
{
  Words of = {{"within", digits(within)}, {"cage", cage_of(lmp)}};
  for (const FixBearingImplicit *f : fixes_of<FixBearingImplicit>(lmp)) {
    const FixBearingImplicit::Control control = f->control();
    of["tolerance"] = digits(control.tolerance);
    of["relative_tolerance"] = digits(control.relative);
    of["cage_tolerance"] = digits(control.cage);
    of["step_control"] = control.estimate ? "estimate" : "bound";
  }
  return of;
}

// Returns NAME=VALUE for every variable that is needed to repeat the run of the deck. Returns an
// empty string if any of the variables that determine the motion is not defined in the deck.
std::string variables_of(LAMMPS *lmp, double within)
{
  static const char *const head[] = {"bearing", "lubricant", "models", "integrator", "load", "rpm"};
  for (const char *name : head)
    if (!host_variable(lmp, name)) return "";
  // these variables concern the folder or the length of the run, or are stated elsewhere in the
  // record
  static const std::vector<std::string> others = {
      "out",   "inputs", "overwrite",  "resume",     "keep",      "record",
      "dumps", "passes", "flaw_inner", "flaw_outer", "flaw_ball", "flawed_ball"};
  const bool vibration = integrator_of(lmp) == "vibration";
  const auto heats = fixes_of<FixBearingHeat>(lmp);
  const bool cold =
      std::all_of(heats.begin(), heats.end(), [](const auto *f) { return f->idle(); });
  const Words own = chosen(lmp, within);
  std::string list;
  for (const DeckVariable &v : deck_variables()) {
    const std::string name = v.name;
    const bool of_sampling = name == "sampling" || name == "oversampling",
               angle = name == "contact_angle" || name == "four_point";
    const std::optional<std::string> given = host_variable(lmp, name);
    if (v.taken_by("bearing/cage/ring") && own.at("cage") != "ring") continue;
    if (cold && v.taken_by("bearing/heat")) continue;
    if (v.of_one_deck() || (v.of_data() && !angle) || (of_sampling && !vibration) ||
        (angle && !given))
      continue;
    if (std::find(others.begin(), others.end(), name) != others.end()) continue;
    const auto at = own.find(name);
    const std::string value = at != own.end() ? at->second : given.value_or(v.initial);
    if (!value.empty()) list += (list.empty() ? "" : ",") + name + "=" + value;
  }
  return list;
}

// Returns the data of a bearing, its oil and its heating as words KEY=VALUE.
std::string data_words(LAMMPS *lmp, const NamedBearing &b, const PairBearing &pair)
{
  const auto [oil, temperature] = pair.oil_of(b.name);
  std::string words = "bearing=" + b.word("bearing");
  if (!oil.empty()) words += " lubricant=" + oil;
  if (pair.coefficients().lubricated()) words += " temperature_C=" + digits(temperature);
  words += " contact_angle_deg=" + b.word("contact_angle");
  for (const char *side : {"inner", "outer"})
    words += std::string(" ") + side + "_shoulder_diameter_m=" +
             digits(b.number_or(std::string(side) + "_shoulder_diameter", 0.0));
  for (const FixBearingHeat *f : fixes_of<FixBearingHeat>(lmp))
    if (!f->idle() && f->covers_type(b.balls))
      words += " heat_ambient_C=" + digits(f->ambient()) +
               " ball_expansion_per_K=" + digits(f->ball_expansion());
  return words;
}

// The fix that states the loads of all inner rings of a record, null if there is none. Collective.
const FixBearingRing *loaded_by(LAMMPS *lmp, const RecordLayout &layout)
{
  for (const FixBearingRing *f : fixes_of<FixBearingRing>(lmp)) {
    if (!f->stated_loads().stated) continue;
    int moved = 0, all = 0;
    for (const RecordLayout::RecordRing &ring : layout.rings) {
      const int i = ring.raceway == 0 ? lmp->atom->map(static_cast<tag_t>(ring.tag)) : -1;
      moved += i >= 0 && i < lmp->atom->nlocal && f->moves(i);
    }
    MPI_Allreduce(&moved, &all, 1, MPI_INT, MPI_SUM, lmp->world);
    if (all == static_cast<int>(layout.bearings.size())) return f;
  }
  return nullptr;
}

// True if an outer ring of a record turns, or may turn. Collective.
bool outer_turns(LAMMPS *lmp, const RecordLayout &layout)
{
  int mine = 0, any = 0;
  for (const RecordLayout::RecordRing &ring : layout.rings) {
    const int i = ring.raceway == 1 ? lmp->atom->map(static_cast<tag_t>(ring.tag)) : -1;
    if (i < 0 || i >= lmp->atom->nlocal) continue;
    const double *w = lmp->atom->omega[i];
    if (w[0] != 0.0 || w[1] != 0.0 || w[2] != 0.0) mine = 1;
    for (const FixBearingRing *f : fixes_of<FixBearingRing>(lmp))
      if (f->moves(i) && f->turns()) mine = 1;
  }
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp->world);
  return any != 0;
}

}    // namespace

std::vector<std::string> data_lines(LAMMPS *lmp)
{
  const auto *pair = dynamic_cast<const PairBearing *>(lmp->force->pair);
  std::vector<std::string> lines;
  for (const NamedBearing *b : bearings_of(lmp)) {
    if (!b->in_use) continue;
    lines.push_back("bearing " + b->name);
    for (const auto &value : b->data.values)
      if (value.second.find('/') == std::string::npos)
        lines.back() += " " + value.first + "=" + value.second;
    if (pair) lines.back() += " permittivity=" + digits(pair->permittivity(b->balls));
  }
  return lines;
}

void add_deck_notes(LAMMPS *lmp, const PairBearingHertz &pair, const RecordLayout &layout,
                    double within, Attributes &to)
{
  const auto *named = dynamic_cast<const PairBearing *>(&pair);
  std::vector<const NamedBearing *> list;
  for (const NamedBearing *b : bearings_of(lmp))
    if (b->in_use) list.push_back(b);
  if (!named || list.empty()) return;
  const auto add = [&to](const std::string &name, const auto &value) {
    NetcdfHeader::add_new(to, {name, value});
  };
  if (const std::string again = variables_of(lmp, within); !again.empty())
    add("deck_variables", again);
  if (const std::string oil = named->oil(); !oil.empty()) add("lubricant", oil);
  add("integrator", integrator_of(lmp));
  add("models", named->models());
  const NamedBearing &b = *list.front();
  if (std::all_of(list.begin(), list.end(), [&](const NamedBearing *one) {
        return one->word("bearing") == b.word("bearing");
      }))
    add("bearing", b.word("bearing"));
  if (list.size() > 1) {
    std::string lines, numbers;    // one line per name, and the index of the line for each bearing
                                   // in the record
    for (const NamedBearing *one : list)
      lines += (lines.empty() ? "" : "\n") + data_words(lmp, *one, *named);
    for (const int type : ball_types(lmp, layout)) {
      const auto at = std::find(list.begin(), list.end(), bearing_of_type(lmp, type));
      numbers += (numbers.empty() ? "" : " ") + std::to_string(at - list.begin());
    }
    add("named_bearings", lines);
    add("bearing_names", numbers);
    return;
  }
  if (named->coefficients().lubricated()) add("temperature_C", named->oil_of(b.name).second);
  std::vector<std::string> given = b.given;
  given.insert(given.end(), named->given().begin(), named->given().end());
  if (const std::string assumed = named->assumed(); !assumed.empty()) add("assumed_data", assumed);
  add("given_data", given.empty() ? std::string("none") : joined(given, ","));
  add("contact_angle_deg", b.number("contact_angle"));
  add("inner_shoulder_diameter_m", b.number_or("inner_shoulder_diameter", 0.0));
  add("outer_shoulder_diameter_m", b.number_or("outer_shoulder_diameter", 0.0));
  const bool outer = outer_turns(lmp, layout);
  if (const FixBearingRing *f = loaded_by(lmp, layout)) {
    const StatedLoads &loads = f->stated_loads();
    add("load_N", loads.load);
    add("load_azimuth_rad", loads.azimuth);
    add("axial_N", loads.axial);
    add("moment_x_N_m", loads.moment[0]);
    add("moment_y_N_m", loads.moment[1]);
    add("unbalance_kg_m", loads.unbalance);
    // twelve digits are the accuracy of a speed that the deck has converted from rpm to rad/s
    char rpm[32];
    snprintf(rpm, sizeof rpm, "%.12g", loads.speed * 30.0 / M_PI);
    if (!std::isnan(loads.speed) && !outer) add("rpm", strtod(rpm, nullptr));
  }
}

}    // namespace bearing
