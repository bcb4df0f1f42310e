// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_derive.h"

#include "../deck/arguments.h"
#include "../physics/gothic_arch.h"
#include "../physics/oil_data.h"
#include "../physics/starvation.h"
#include "../physics/usual_data.h"

#include <map>

using namespace LAMMPS_NS;
using bearing::Arguments;

namespace {

constexpr double degree = M_PI / 180.0;

// As the host writes the value of a formula
std::string written(double value)
{
  char buf[32];
  snprintf(buf, sizeof buf, "%.15g", value);
  return buf;
}

// The variables of the deck.
class Deck : protected Pointers {
 public:
  Deck(LAMMPS *lmp, const Arguments &args) : Pointers(lmp), args_(args) {}

  std::string word(const std::string &name) const
  {
    const char *value = there(name) ? input->variable->retrieve(letters(name)) : nullptr;
    if (!value) args_.fail("the deck has no variable " + name + " that is one number");
    return value;
  }
  double number(const std::string &name) const { return args_.number_in(word(name), name); }
  // An index variable, unless there is a variable of that name.
  void suggest(const std::string &name, double value)
  {
    if (!there(name)) make(name, "index", written(value));
  }
  void set(const std::string &name, double value) { make(name, "equal", written(value)); }
  void set(const std::string &name, std::string words) { make(name, "string", words); }
  [[noreturn]] void fail(const std::string &why) const { args_.fail(why); }

 private:
  const Arguments &args_;

  static char *letters(const std::string &name) { return const_cast<char *>(name.c_str()); }
  bool there(const std::string &name) const { return input->variable->find(letters(name)) >= 0; }
  void make(const std::string &name, const std::string &style, const std::string &value)
  {
    char *words[] = {letters(name), letters(style), letters(value)};
    input->variable->set(3, words);
  }
};

void usual_data(Deck &deck)
{
  const double ball = deck.number("ball_diameter");
  const raceway::UsualData data = {deck.number("balls"), ball, deck.number("pitch_diameter"),
                                   deck.number("contact_angle") * degree};
  deck.suggest("inner_groove", deck.number("inner_conformity") * ball);
  deck.suggest("outer_groove", deck.number("outer_conformity") * ball);
  deck.suggest("inner_radius", data.inner_radius(deck.number("inner_conformity") * ball));
  deck.suggest("outer_radius", data.outer_radius(deck.number("outer_conformity") * ball));
  deck.suggest("cage_ball_diameter", data.cage_ball_diameter(deck.number("pocket_play")));
  const raceway::RingCylinder ring = {
      deck.number("bore_diameter"), deck.number("bearing_width"),
      raceway::RingCylinder::shoulder(deck.number("inner_radius"), ball)};
  deck.suggest("inner_mass", ring.mass(deck.number("ball_density")));
  deck.suggest("inner_inertia", ring.inertia(deck.number("inner_mass")));
  deck.suggest("inner_inertia_t", ring.inertia_t(deck.number("inner_mass")));
}

raceway::OilData oil_data(const Deck &deck)
{
  return {deck.number("oil_density_40"), deck.number("oil_density_slope"),
          deck.number("pressure_viscosity_40"), deck.number("pressure_viscosity_100"),
          deck.number("permittivity_40")};
}

void suggest_oil(Deck &deck, const raceway::OilAtTemperature &oil)
{
  deck.suggest("viscosity", oil.viscosity);
  deck.suggest("pressure_viscosity", oil.pressure_viscosity);
  deck.suggest("temperature_viscosity", oil.temperature_viscosity);
  deck.suggest("oil_density", oil.density);
  deck.suggest("permittivity", oil.permittivity);
}

void walther(Deck &deck)
{
  const double low = deck.number("kinematic_viscosity_40"),
               high = deck.number("kinematic_viscosity_100"), at = deck.number("temperature");
  if (!(low > high && high > 0.3))
    deck.fail("kinematic viscosity " + bearing::text(low) + " mm2/s at 40 C and " +
              bearing::text(high) + " at 100 C: must fall and stay above 0.3");
  suggest_oil(deck, at_temperature(oil_data(deck), raceway::walther(low, high, at), at));
}

void vogel(Deck &deck)
{
  const raceway::OilData oil = oil_data(deck);
  const double at = deck.number("temperature");
  suggest_oil(deck, at_temperature(oil,
                                   raceway::vogel(deck.number("vogel_viscosity"),
                                                  deck.number("vogel_slope"),
                                                  deck.number("vogel_temperature"), oil, at),
                                   at));
}

// 1 for a bearing whose file does not have its boundary dimensions
void starvation(Deck &deck)
{
  deck.suggest("bore_diameter", 0.0);
  deck.suggest("outside_diameter", 0.0);
  const double bore = 1.0e3 * deck.number("bore_diameter"),
               outside = 1.0e3 * deck.number("outside_diameter"),
               kinematic = 1.0e6 * deck.number("viscosity") / deck.number("oil_density");
  deck.set("b_phi_rs", outside > bore
                           ? raceway::skf_starvation(bore, outside, kinematic, deck.number("rpm"))
                           : 1.0);
}

// With `four_point` 0 one groove a ring.
void four_point(Deck &deck)
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
  deck.set("b_inner_raceway", written(deck.number("inner_radius") - inner.depth()));
  deck.set("b_inner_arch", "gothic_arch " + written(inner.offset()));
  deck.set("b_outer_raceway",
           deck.number("outer_radius") + 0.5 * deck.number("clearance") + outer.depth());
  deck.set("b_outer_arch", "gothic_arch " + written(outer.offset()));
}

// The time in which one ball moves to the position of the next, and that in which the run settles.
// The bits of a run depend on both, so the mean diameter is rounded as it is written.
void ball_pass(Deck &deck)
{
  deck.set("b_pitch", 0.5 * (deck.number("inner_radius") + deck.number("b_outer_raceway")));
  const double cosine = std::cos((deck.number("contact_angle") + deck.number("four_point")) * M_PI /
                                 180),
               share = 1 - 0.5 * deck.number("ball_diameter") * cosine / deck.number("b_pitch");
  deck.set("b_pass_time", 2 * M_PI / (deck.number("balls") * 0.5 * deck.number("b_omega") * share));
  deck.set("b_settle_time", deck.number("settle") * deck.number("b_pass_time") + 1.0e-2);
}

// Samples of a host step, unless the user says: ten, five, two or one, so that a ball pass is a
// whole number of steps and at least twenty. A step that is given has one.
void samples_within(Deck &deck)
{
  const double asked = deck.number("within"), samples = deck.number("samples");
  double chosen = 1.0;
  for (const double n : {2.0, 5.0, 10.0})
    if (samples >= 20.0 * n && std::fmod(samples, n) == 0.0) chosen = n;
  deck.set("b_within", asked != 0.0 ? asked : deck.number("step") == 0.0 ? chosen : 1.0);
}

}    // namespace

void BearingDerive::command(int narg, char **arg)
{
  static const std::map<std::string, void (*)(Deck &)> laws = {
      {"ball_pass", ball_pass},   {"samples_within", samples_within}, {"four_point", four_point},
      {"starvation", starvation}, {"usual_data", usual_data},         {"vogel", vogel},
      {"walther", walther}};
  Arguments args(lmp, "bearing_derive", narg, arg, 0);
  std::vector<std::string> names;
  for (const auto &law : laws) names.push_back(law.first);
  const auto law = laws.find(names[args.choice("law", names)]);
  if (args.more()) args.unknown("none, the command ends here");
  Deck deck(lmp, args);
  law->second(deck);
}
