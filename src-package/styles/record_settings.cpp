// SPDX-License-Identifier: GPL-2.0-or-later
#include "record_settings.h"

#include "../core/settings/raceway_version.h"
#include "../core/settings/written.h"
#include "fix_bearing_capacitance.h"
#include "fix_bearing_implicit.h"
#include "fix_bearing_profile.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <set>

using namespace LAMMPS_NS;
namespace fs = std::filesystem;

namespace bearing {

using Attributes = NetcdfHeader::Attributes;

// Adds the data of the bearing if the record contains only one. The names include units, as in the
// data files of the decks.
static void add_bearing(const RecordLayout &layout, Attributes &list)
{
  static const std::map<std::string, const char *> suffix = {
      {"", ""}, {"m", "_m"}, {"kg", "_kg"}, {"Pa", "_Pa"}, {"Pa s", "_Pa_s"}, {"1/Pa", "_per_Pa"}};
  const double *of = layout.bearings.front().of;
  const auto add = [&list](const std::string &name, double value) {
    if (!std::isnan(value)) NetcdfHeader::add_new(list, {name, value});
  };
  for (int k = 0; k < of_kind::N; ++k) {
    const raceway::Column &c = of_kind::list[k];
    // the outer radius is stored for zero clearance, because the clearance is a separate value
    const double outside = k == of_kind::OUTER_RADIUS ? 0.5 * of[of_kind::CLEARANCE] : 0.0;
    add(c.name + std::string(suffix.at(c.unit)), of[k] - outside);
  }
  add("roughness_m", std::hypot(of[of_kind::RING_ROUGHNESS], of[of_kind::BALL_ROUGHNESS]));
  const char *const ring[] = {"inner_ring", "outer_ring", "cage_ring"};
  for (const auto &r : layout.rings) add(ring[r.raceway], r.tag);
}

std::string flaws_of(LAMMPS *lmp, PairBearingHertz &pair, const RecordLayout &layout)
{
  std::map<double, std::string> of_rings;
  std::vector<std::pair<std::set<double>, const FixBearingProfile *>> of_balls;
  for (const FixBearingProfile *f : fixes_of<FixBearingProfile>(lmp)) {
    if (!f->departs()) continue;
    std::set<double> tags;
    for (const FixBearingProfile::Flawed &body : f->bodies(pair)) tags.insert(double(body.tag));
    if (f->of_balls()) of_balls.emplace_back(tags, f);
    else
      for (const double tag : tags) {
        std::string &text = of_rings[tag];
        text += (text.empty() ? "" : "; ") + digits(tag) + " " + f->said();
      }
  }
  std::vector<std::string> all;
  for (const RecordLayout::RecordRing &r : layout.rings)
    if (of_rings.count(r.tag)) all.push_back(of_rings[r.tag]);
  for (const auto &[tags, f] : of_balls)
    for (const RecordLayout::RecordBody &ball : layout.balls)
      if (tags.count(ball.tag)) all.push_back(digits(ball.tag) + " " + f->said());
  return joined(all, "; ");
}

Attributes record_settings(LAMMPS *lmp, PairBearingHertz &pair, const RecordLayout &layout,
                           const Attributes &notes, const RunTimes &times)
{
  Attributes list = notes;
  list.insert(list.begin(), {"title", "ball bearing run"});
  const bool implicit = !fixes_of<FixBearingImplicit>(lmp).empty();
  NetcdfHeader::add_new(list, {"integrator", implicit ? "implicit" : "verlet"});
  if (layout.bearings.size() == 1) add_bearing(layout, list);
  list.push_back({"source", "Raceway " RACEWAY_VERSION ", fix bearing/record"});
  list.push_back({"host", BRG_HOST_NAME});
  list.push_back({"axis", std::string(1, "xyz"[pair.coefficients().axis_index()])});
  list.push_back({"sample_s", times.sample});
  list.push_back({"start_s", times.start});
  std::string commands =
      std::string("pair_style bearing/") + (pair.coefficients().lubricated() ? "ehd" : "hertz");
  for (const std::vector<std::string> &words : pair.commands()) {
    if (&words != &pair.commands().front()) commands += "\npair_coeff";
    for (const std::string &w : words) commands += " " + w;
  }
  list.push_back({"pair_commands", commands});
  std::vector<std::string> surroundings;    // of contacts, as they are used in the columns
  for (const FixBearingCapacitance *f : capacitances_of(lmp))
    if (f->model().surrounded()) surroundings.push_back(f->said());
  if (!surroundings.empty()) list.push_back({"capacitance_commands", joined(surroundings, "\n")});
  const std::string flaws = flaws_of(lmp, pair, layout);
  if (!flaws.empty()) list.push_back({"flaws", flaws});
  return list;
}

// Returns text as a YAML scalar. It is quoted if a file name in it would make it ambiguous.
static std::string scalar(const std::string &words)
{
  if (words.find(": ") == std::string::npos && words.find(" #") == std::string::npos) return words;
  std::string quoted = "'";
  for (char c : words) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string write_run_yaml(const std::string &folder, const Attributes &about,
                           const Attributes &more)
{
  const fs::path file = fs::path(folder) / "run.yaml";
  std::ofstream to(file);
  to << std::setprecision(15);
  for (const Attributes *list : {&about, &more})
    for (const NetcdfHeader::Attribute &a : *list)
      if (a.type == NetcdfHeader::real) to << a.name << ": " << a.of[0] << "\n";
      else if (a.words.find('\n') == std::string::npos)
        to << a.name << ": " << scalar(a.words) << "\n";
  to << std::flush;
  return to ? "" : "cannot write " + file.string() + ": " + strerror(errno);
}

bool holds_finished_run(const std::string &folder)
{
  std::ifstream from(fs::path(folder) / "run.yaml");
  for (std::string line; std::getline(from, line);)
    if (line.compare(0, 7, "wall_s:") == 0) return true;
  return false;
}

}    // namespace bearing
