// SPDX-License-Identifier: GPL-2.0-or-later
#include "named_cage.h"

#include "../core/settings/model_words.h"
#include "../core/settings/written.h"
#include "pair_bearing.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace bearing {

// Returns the contributions to the friction and drag of a cage that are to be left out.
static std::set<std::string> parts_left_out(Arguments &args, const std::string &names)
{
  try {
    return left_out(names, {"friction", "shear", "film", "land", "churning"});
  } catch (const DataError &wrong) {
    args.fail(std::string("cage_without: ") + wrong.what());
  }
}

CageSettings named_cage(LAMMPS *lmp, Arguments &args, const NamedBearing &b)
{
  std::map<std::string, std::string> words;
  for (const DeckVariable &v : variables_of("bearing/cage/ring")) words[v.name] = v.initial;
  while (args.more())
    if (!args.variable_of("bearing/cage/ring", words)) args.unknown();
  if (!b.has_cage_ring)
    args.fail("the cage of bearing " + b.name + " is not a ring: give it 'cage ring'");
  const auto given = [&words](const char *key) { return std::atof(words.at(key).c_str()); };
  const std::string &guide = words.at("cage_guide");
  if (guide != "balls")
    for (const char *key : {"cage_land", "cage_clearance", "cage_width"})
      if (given(key) == 0.0)
        args.fail("cage_guide " + guide + " needs " + key +
                  ": it describes the land and has no estimate");
  const std::set<std::string> out = parts_left_out(args, words.at("cage_without"));
  const auto unless_out = [&out](const char *part, double value) {
    return out.count(part) ? 0.0 : value;
  };
  // rounded in the same way as by formulas in a deck
  const auto or_estimate = [&given](const char *key, double estimate) {
    return written(given(key) != 0.0 ? given(key) : estimate);
  };
  const double ball = b.number("ball_diameter"),
               pitch = written(b.number("inner_radius") + b.number("outer_radius"));
  CageSettings cage;
  raceway::CageRing &of = cage.of;
  of.pockets = static_cast<int>(b.number("balls"));
  cage.play = or_estimate("cage_play", raceway::usual_play * ball);
  cage.across = or_estimate("cage_across", cage.play);
  of.mass = or_estimate("cage_mass", 4060.0 * ball * ball * pitch);
  const double inertia = written(0.25 * of.mass * pitch * pitch);
  cage.program.inertia = {inertia, written(0.5 * inertia + of.mass * ball * ball / 24.0)};
  cage.young[0] = b.number("ball_young");
  cage.young[1] = given("cage_young");
  cage.poisson[0] = b.number("ball_poisson");
  cage.poisson[1] = given("cage_poisson");
  of.friction = unless_out("friction", given("cage_friction"));
  if (guide != "balls") {
    of.guide = guide == "inner" ? raceway::CageRing::by_inner : raceway::CageRing::by_outer;
    of.land.radius = given("cage_land");
    of.land.clearance = given("cage_clearance");
    of.land.width = given("cage_width");
    of.land.lands = 2;
  }
  const auto *pair = dynamic_cast<const PairBearing *>(lmp->force->pair);
  const auto oil = [&](const char *datum) {
    return pair ? std::atof(pair->oil_datum(b.name, datum).c_str()) : 0.0;
  };
  if (cage.oil = oil("viscosity"); cage.oil > 0.0) {
    // the oil in a pocket covers the usual wrap angle
    const double band = written(raceway::usual_band * ball);
    cage.filled = given("cage_filled");
    cage.height = unless_out("shear", band);
    cage.film_height = unless_out("film", band);
    cage.land_filled = unless_out("land", cage.filled);
  }
  // the cage churns the same oil that causes drag on the balls
  of.oil_share = pair ? written(unless_out("churning", pair->oil_share(b.name))) : 0.0;
  if (of.oil_share > 0.0) {
    of.oil_density = oil("oil_density");
    of.oil_viscosity = cage.oil;
    of.outer_radius = written(0.5 * pitch + raceway::usual_reach * ball);
  }
  cage.finish(args);
  return cage;
}

}    // namespace bearing
