// SPDX-License-Identifier: GPL-2.0-or-later
#include "model_words.h"

#include "../laws/lubrication.h"
#include "../laws/starvation.h"
#include "written.h"

#include <algorithm>
#include <sstream>

namespace bearing {

const std::vector<std::string> model_names = {"paper", "film", "full", "eyring", "none"};

namespace {

typedef std::vector<std::string> Parts;

Parts parts_of(const std::string &models, bool film)
{
  const bool full = models == "full" || models == "eyring";
  if (full && film)
    return {"gap",     "film_branch", "inlet_shear",        "asperities", "differential_slip",
            "rolling", "starvation",  "rolling_hysteresis", "spin",       "drag"};
  if (full) return {"rolling_hysteresis", "spin"};
  if (models == "film" && film) return {"gap", "film_branch", "inlet_shear"};
  return {};
}

// Set of the parts of the models that have not been left out.
class Choice {
 public:
  Choice(const Parts &parts, const std::string &without) :
      parts_(parts), out_(left_out(without, parts))
  {
  }
  double has(const std::string &part) const
  {
    return std::find(parts_.begin(), parts_.end(), part) != parts_.end() && !out_.count(part);
  }
  std::string share(const std::string &part, double value = 1.0) const
  {
    return digits(value * has(part));
  }

 private:
  Parts parts_;
  std::set<std::string> out_;
};

// Returns the keywords for the film in the gap, its damping, and its thinning by inlet shear.
std::string gap_words(const ModelChoice &of, const Choice &with, const OilWords &oil)
{
  const std::string thins = oil.at("temperature_viscosity") + " " + oil.at("oil_conductivity");
  std::string words;
  if (with.has("gap")) words += " gap 1 gap_film " + of.gap_film;
  if (with.has("gap") && with.has("film_branch")) words += " film_damping branch";
  if (with.has("inlet_shear")) words += " inlet_shear " + of.inlet_shear + " " + thins;
  return words;
}

std::string full_words(const ModelChoice &of, const Choice &with, const OilWords *oil,
                       const LubricatedBearing &bearing)
{
  std::string slip = of.spin_law == "slices" ? "slices 1.0e-4 " + with.share("spin")
                                             : "heathcote 1.0e-4 spin " + with.share("spin");
  const std::string hysteresis = " rolling_hysteresis " + with.share("rolling_hysteresis", 0.016);
  if (of.spin_law == "slices" && oil && !with.has("differential_slip"))
    throw DataError("spin_law slices needs the part differential_slip: keep that part, or use "
                    "spin_law closed");
  if (!oil) return "friction constant 0.1 " + slip + hysteresis;
  if (!with.has("differential_slip")) slip = "smoothed 0.01";
  const LubricationWords kind = lubrication_words(of.lubrication, of.oil_level, bearing,
                                                  std::atof(oil->at("viscosity").c_str()),
                                                  std::atof(oil->at("oil_density").c_str()));
  const double starved = with.has("starvation"),
               rolling = with.has("rolling") * (starved * kind.starvation + (1.0 - starved));
  const std::string inlet = starved && kind.inlet ? " rolling_inlet " + digits(kind.inlet) : "";
  // with asperities, this is the friction coefficient of the asperity contacts
  const std::string boundary = digits(0.05 + 0.07 * with.has("asperities"));
  return "friction mixed " + boundary + " 0.05 asperity_law clarke " + slip + " rolling " +
         oil->at("temperature_viscosity") + " " + oil->at("oil_conductivity") + " " +
         digits(rolling) + hysteresis + " drag " + oil->at("oil_density") + " " +
         with.share("drag", kind.share) + inlet + gap_words(of, with, *oil);
}

// Throws an error if the lubricant lacks oil data that the models need.
void require(const OilWords &oil, const std::string &models)
{
  Parts needed = {"temperature_viscosity", "oil_conductivity"};
  if (models != "film") needed.push_back("oil_density");
  if (models == "eyring") needed.insert(needed.end(), {"eyring_stress", "limiting_traction"});
  Parts missing;
  for (const std::string &name : needed)
    if (!oil.count(name)) missing.push_back(name);
  if (!missing.empty()) throw DataError("the lubricant has no variable " + joined(missing));
}

}    // namespace

std::set<std::string> left_out(const std::string &without, const Parts &parts)
{
  std::set<std::string> out;
  std::istringstream names(without == "none" ? "" : without);
  for (std::string name; std::getline(names, name, '+');) {
    if (std::find(parts.begin(), parts.end(), name) == parts.end())
      throw DataError("there is no part '" + name + "' to leave out in '" + without +
                      "'; there is: " + (parts.empty() ? "none" : joined(parts, " ")) +
                      ". Names are joined by +, or the word is none");
    out.insert(name);
  }
  return out;
}

LubricationWords lubrication_words(const std::string &kind, double level,
                                   const LubricatedBearing &b, double viscosity, double density)
{
  int number = 0;
  std::istringstream names(raceway::lubrication_kinds);
  for (std::string name; names >> name && name != kind;) ++number;
  if (!names)
    throw DataError("there is no lubrication '" + kind +
                    "'; there is: " + raceway::lubrication_kinds);
  const raceway::Lubrication of =
      raceway::lubrication(static_cast<raceway::LubricationKind>(number), level,
                           b.pitch_radius / b.ball_radius, density);
  LubricationWords words = {1.0, of.inlet, written(of.share)};
  if (b.outside > b.bore)
    words.starvation = written(raceway::skf_starvation(
        1.0e3 * b.bore, 1.0e3 * b.outside, 1.0e6 * viscosity / density, b.rpm, of.replenishment,
        b.contact_angle != 0.0 ? raceway::angular_slender : raceway::deep_slender));
  return words;
}

ContactModel contact_model(const ModelChoice &of, const OilWords *oil,
                           const LubricatedBearing &bearing)
{
  const Choice with(parts_of(of.models, oil != nullptr), of.without);
  const bool full = of.models == "full" || of.models == "eyring", film = of.models == "film",
             paper = of.models == "paper";
  ContactModel model;
  // without this factor, the vibration of a cage that drives balls would limit the step; in the
  // contacts of a cage, 1 um corresponds to 0.4 N
  model.cage_tolerance_share = full ? 1000.0 : film ? 100.0 : 1.0;
  model.estimate = !paper;    // records with `models paper` must remain bitwise identical
  if (of.models == "none") return model;
  if (oil && !paper) require(*oil, of.models);
  if (full) {
    model.words = full_words(of, with, oil, bearing);
    if (of.models == "eyring" && oil)
      model.words += " traction " + oil->at("eyring_stress") + " " + oil->at("limiting_traction");
  } else {
    model.words = oil ? "friction stribeck 0.12 0.05" : "friction constant 0.1";
    if (oil && film) model.words += gap_words(of, with, *oil);
  }
  return model;
}

}    // namespace bearing
