// SPDX-License-Identifier: GPL-2.0-or-later
#include "named_cage.h"

#include "../core/geometry/cage_ring.h"
#include "../core/settings/deck_variable_table.h"
#include "../core/settings/written.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "pair_bearing.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

using namespace LAMMPS_NS;

namespace bearing {

// Returns the contributions to the friction and drag of a cage that are to be left out. In `names`
// they are joined by +.
static std::set<std::string> left_out(Arguments &args, const std::string &names)
{
  const std::set<std::string> parts = {"friction", "shear", "film", "land", "churning"};
  std::set<std::string> out;
  std::istringstream list(names == "none" ? "" : names);
  for (std::string name; std::getline(list, name, '+');) {
    if (!parts.count(name))
      args.fail("cage_without '" + names + "': there is no part '" + name +
                "'; there is: friction, shear, film, land, churning, joined by +, or none");
    out.insert(name);
  }
  return out;
}

std::vector<std::string> cage_words(LAMMPS *lmp, Arguments &args, const NamedBearing &b)
{
  std::map<std::string, std::string> words;
  std::string known;
  for (const DeckVariable &v : deck_variables())
    if (v.taken_by("bearing/cage/ring")) {
      words[v.name] = v.initial;
      known += (known.empty() ? "" : ", ") + std::string(v.name);
    }
  while (args.more()) {
    if (!words.count(args.next())) args.unknown(known);
    const std::string key = args.word("keyword");
    words[key] = args.value_of(key.c_str());
  }
  if (!b.has_cage_ring)
    args.fail("the cage of bearing " + b.name + " is not a ring: give it 'cage ring'");
  if (words["cage_guide"] != "balls")
    for (const char *key : {"cage_land", "cage_clearance", "cage_width"})
      if (std::atof(words[key].c_str()) == 0.0)
        args.fail("cage_guide " + words["cage_guide"] + " needs " + key +
                  ": it describes the land and has no estimate");
  const std::set<std::string> out = left_out(args, words["cage_without"]);
  // rounded in the same way as by formulas in a deck
  const auto or_estimate = [&](const char *key, double estimate) {
    const double given = std::atof(words[key].c_str());
    return given != 0.0 ? given : written(estimate);
  };
  const double ball = b.number("ball_diameter"),
               pitch = written(b.number("inner_radius") + b.number("outer_radius")),
               play = or_estimate("cage_play", raceway::usual_play * ball),
               mass = or_estimate("cage_mass", 4060.0 * ball * ball * pitch),
               inertia = written(0.25 * mass * pitch * pitch);
  std::ostringstream line;
  line << "pockets " << b.word("balls") << " play " << digits(play) << " across "
       << digits(or_estimate("cage_across", play)) << " mass " << digits(mass) << " inertia "
       << digits(inertia) << " " << digits(0.5 * inertia + mass * ball * ball / 24.0) << " young "
       << b.word("ball_young") << " " << words["cage_young"] << " poisson "
       << b.word("ball_poisson") << " " << words["cage_poisson"] << " friction "
       << (out.count("friction") ? "0" : words["cage_friction"]) << " guide "
       << words["cage_guide"];
  if (words["cage_guide"] != "balls")
    line << " " << words["cage_land"] << " " << words["cage_clearance"] << " "
         << words["cage_width"] << " 2";
  const auto rings = fixes_of<FixBearingRing>(lmp);
  const bool plane = std::none_of(rings.begin(), rings.end(), [](const FixBearingRing *ring) {
    return ring->moves_axially() || ring->tilts();
  });
  line << " planar " << (plane ? "yes" : "no");
  // the oil in a pocket covers the usual wrap angle
  const auto *pair = dynamic_cast<const PairBearing *>(lmp->force->pair);
  const std::string viscosity = pair ? pair->oil_datum(b.name, "viscosity") : "";
  const std::string band = digits(raceway::usual_band * ball);
  if (!viscosity.empty())
    line << " oil " << viscosity << " " << words["cage_filled"] << " "
         << (out.count("shear") ? "0" : band) << " film " << (out.count("film") ? "0" : band)
         << " land_oil " << (out.count("land") ? "0" : words["cage_filled"]);
  // the cage churns the same oil that causes drag on the balls
  const double churned = pair && !out.count("churning") ? pair->oil_share(b.name) : 0.0;
  if (churned > 0.0)
    line << " churning " << digits(churned) << " " << pair->oil_datum(b.name, "oil_density") << " "
         << viscosity << " " << digits(written(0.5 * pitch + raceway::usual_reach * ball));
  std::istringstream in(line.str());
  return {std::istream_iterator<std::string>(in), {}};
}

}    // namespace bearing
