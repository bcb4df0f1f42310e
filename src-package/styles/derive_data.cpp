// SPDX-License-Identifier: GPL-2.0-or-later
// Derives variables from the given data of a bearing or an oil.
#include "derive_data.h"

#include "../core/geometry/ball_material.h"
#include "../core/geometry/gothic_arch.h"
#include "../core/geometry/usual_data.h"
#include "../core/laws/oil_data.h"
#include "../core/settings/deck_variable_table.h"

namespace bearing {

static constexpr double degree = M_PI / 180.0;

void derive_materials(DataValues &deck, const DataValues::Map &values,
                      const DataValues::Map &of_file)
{
  const auto is_zero = [&](const std::string &name) {
    return !deck.has(name) || deck.number(name) == 0.0;
  };
  const bool ceramic = deck.has("ball_material") && deck.word("ball_material") == "silicon_nitride";
  const raceway::BallMaterial &material = raceway::silicon_nitride;
  const std::pair<std::string, double> elastic[] = {
      {"young", material.young}, {"poisson", material.poisson}, {"density", material.density}};
  for (const auto &[name, value] : elastic) {
    const std::string ball = "ball_" + name, ring = "ring_" + name;
    const auto stated = of_file.find(ball);
    const bool by_deck =
        deck.has(ball) && (stated == of_file.end() || stated->second != deck.word(ball));
    const bool apart = !is_zero(ring);    // the file states the data of the rings, too
    const DataValues::Map &source = ceramic ? of_file : values;
    if (!apart) deck.set(ring, source.count(ball) ? source.at(ball) : usual_word(ball));
    if (ceramic && !by_deck && (!apart || !deck.has(ball))) deck.set(ball, value);
  }
  if (!ceramic) return;
  const std::pair<const char *, double> thermal[] = {{"ball_expansion", material.expansion},
                                                     {"ball_heat_capacity", material.heat_capacity},
                                                     {"ball_conductivity", material.conductivity}};
  for (const auto &[name, value] : thermal)
    if (is_zero(name)) deck.set(name, value);
}

void derive_usual_data(DataValues &deck)
{
  const double ball = deck.number("ball_diameter");
  const raceway::UsualData data = {deck.number("balls"), ball, deck.number("pitch_diameter"),
                                   deck.number("contact_angle") * degree};
  if (!(data.pitch_diameter * std::sin(M_PI / data.balls) > ball))
    deck.fail(text(data.balls) + " balls of " + text(ball) + " m overlap on a pitch circle of " +
              text(data.pitch_diameter) + " m");
  if (deck.number("contact_angle") != 0.0)
    deck.zero("clearance", "it follows from the contact angle");
  deck.suggest("inner_groove", deck.number("inner_conformity") * ball);
  deck.suggest("outer_groove", deck.number("outer_conformity") * ball);
  deck.suggest("inner_radius", data.inner_radius(deck.number("inner_conformity") * ball));
  deck.suggest("outer_radius", data.outer_radius(deck.number("outer_conformity") * ball));
  deck.suggest("cage_ball_diameter", data.cage_ball_diameter(deck.number("pocket_play")));
  const raceway::RingCylinder ring = {
      deck.number("bore_diameter"), deck.number("bearing_width"),
      raceway::RingCylinder::shoulder(deck.number("inner_radius"), ball)};
  deck.suggest("inner_mass", ring.mass(deck.number("ring_density")));
  deck.suggest("inner_inertia", ring.inertia(deck.number("inner_mass")));
  deck.suggest("inner_inertia_t", ring.inertia_t(deck.number("inner_mass")));
}

static raceway::KinematicViscosity walther(const DataValues &deck, double at)
{
  const double low = deck.number("kinematic_viscosity_40"),
               high = deck.number("kinematic_viscosity_100");
  if (!(low > high && high > 0.3))
    deck.fail("kinematic viscosity " + text(low) + " mm2/s at 40 C and " + text(high) +
              " at 100 C: must fall and stay above 0.3");
  return raceway::walther(low, high, at);
}

bool follows_temperature(const DataValues::Map &oil)
{
  return oil.count("vogel_viscosity") || oil.count("kinematic_viscosity_40");
}

void derive_oil(DataValues &deck)
{
  const raceway::OilData data = {deck.number("oil_density_40"), deck.number("oil_density_slope"),
                                 deck.number("pressure_viscosity_40"),
                                 deck.number("pressure_viscosity_100"),
                                 deck.number("permittivity_40")};
  const double at = deck.number("temperature");
  const raceway::KinematicViscosity kinematic =
      deck.has("vogel_viscosity")
          ? raceway::vogel(deck.number("vogel_viscosity"), deck.number("vogel_slope"),
                           deck.number("vogel_temperature"), data, at)
          : walther(deck, at);
  const raceway::OilAtTemperature oil = at_temperature(data, kinematic, at);
  deck.suggest("viscosity", oil.viscosity);
  deck.suggest("pressure_viscosity", oil.pressure_viscosity);
  deck.suggest("temperature_viscosity", oil.temperature_viscosity);
  deck.suggest("oil_density", oil.density);
  deck.suggest("permittivity", oil.permittivity);
}

void derive_raceways(DataValues &deck)
{
  const double angle = deck.number("four_point") * degree,
               ball_radius = 0.5 * deck.number("ball_diameter");
  const raceway::GothicArch inner = {deck.number("inner_groove") - ball_radius, angle},
                            outer = {deck.number("outer_groove") - ball_radius, angle};
  if (angle == 0.0) {
    deck.set("b_inner_raceway", deck.word("inner_radius"));
    deck.set("b_inner_arch", "");
    deck.set("b_outer_arch", "");
    return;
  }
  deck.zero("contact_angle", "four_point sets the contact angle");
  deck.set("b_inner_raceway", digits(deck.number("inner_radius") - inner.depth()));
  deck.set("b_inner_arch", "gothic_arch " + digits(inner.offset()));
  deck.set("b_outer_raceway",
           deck.number("outer_radius") + 0.5 * deck.number("clearance") + outer.depth());
  deck.set("b_outer_arch", "gothic_arch " + digits(outer.offset()));
}

}    // namespace bearing
