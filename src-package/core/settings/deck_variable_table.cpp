// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_variable_table.h"

#include "data_table.h"
#include "written.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace bearing {

static const char *const moves =
    "bearing/implicit|bearing/damping|bearing/vibration|bearing/verlet";

// Styles are named as in a deck: `bearing/ring` is fix bearing/ring. A variable that is set at the
// top of the main deck belongs to the style that has the corresponding keyword.
const std::vector<DeckVariable> &deck_variables()
{
  static const std::vector<DeckVariable> table = {
      {"bearing", "6208", "", "", "deck",
       "a bearing of inputs/bearings or its catalogue, or a file"},
      {"lubricant", "mineral", "", "", "deck",
       "an oil of inputs/lubricants, or a file; dry: no oil"},
      {"integrator", "implicit", "", "one_of implicit damping vibration verlet", "deck",
       "integrator of balls, cage and rings"},
      {"rpm", "477.5", "1/min", "1 1.0e5", "deck", "speed of the inner ring"},
      {"passes", "4", "", "1 1.0e6 whole", "run_bearing",
       "number of ball passes that are measured"},
      {"settle", "auto", "", "", "run_bearing",
       "number of ball passes before the measurement, 0 to 1e6; auto: until little change remains; "
       "orbit: until a ball pass repeats the previous one, which is accelerated by choosing the "
       "speeds of the balls"},
      {"settled", "1e-2", "", "1.0e-6 1", "run_bearing",
       "estimated remaining change of torque at which `settle auto` ends; `orbit` ends when the "
       "change in a ball pass is below a fiftieth of this value"},
      {"step", "0", "s", "1.0e-9 1.0e-3 or 0", "run_bearing", "time step; 0: automatic"},
      {"safety", "0.3", "", "1.0e-3 1", "run_bearing",
       "fraction of the stability limit with integrator verlet and step 0"},
      {"samples", "200", "", "1 1.0e5 whole", "bearing/record", "samples per ball pass"},
      {"within", "0", "", "0 1.0e5 whole", "bearing/record",
       "samples within a host step; 0: automatic"},
      {"record", "all", "", "one_of all summary none", "bearing/record", "contents of the record"},
      {"dumps", "no", "", "one_of yes no", "bearing/record|bearing/checkpoint",
       "yes: also write the host's text dumps"},
      {"out", "build/run/6208", "", "", "bearing/record", "folder for the results"},
      {"overwrite", "no", "", "one_of yes no", "bearing/record|bearing_resume",
       "yes: overwrite a finished run in the folder"},
      {"resume", "no", "", "one_of yes no", "bearing_resume",
       "yes: continue from the restart file, if there is one"},
      {"keep", "0", "", "0 1.0e6 whole", "bearing/checkpoint",
       "samples between restart files; 0: write one only when a signal stops the run"},
      {"inputs", "inputs", "", "", "bearing|pair_style bearing", "folder of the data files"},
      {"clearance", "0", "m", "-1.0e-3 1.0e-3", "bearing",
       "diametral clearance; negative is preload"},
      {"contact_angle", "0", "degrees", "0 60", "bearing",
       "nominal contact angle of a bearing with usual data, which determines the clearance"},
      {"four_point", "0", "degrees", "5 60 or 0", "bearing",
       "contact angle of a Gothic arch; 0: one groove per ring"},
      {"cage", "yes", "", "one_of auto yes no ring chain", "bearing",
       "yes or chain: small balls on two rails; ring: one rigid ring; no: no cage, so that balls "
       "may touch each other; auto: ring with the models full, implicit steps and a lubricant, "
       "unless data of cage balls are given, otherwise chain"},
      {"cage_play", "0", "m", "1.0e-6 0.1 or 0", "bearing/cage/ring",
       "total play of a ball in its pocket along the pitch circle; 0: estimated"},
      {"cage_across", "0", "m", "1.0e-6 0.1 or 0", "bearing/cage/ring",
       "total play of a ball in its pocket along the axis; 0: as along the circle"},
      {"cage_mass", "0", "kg", "1.0e-8 1.0e4 or 0", "bearing/cage/ring",
       "mass of the cage; 0: estimated"},
      {"cage_young", "3.3e9", "Pa", "1.0e8 1.0e13", "bearing/cage/ring",
       "Young's modulus of the cage: polyamide; brass 1.05e11, steel 2.08e11"},
      {"cage_poisson", "0.41", "", "0 0.5", "bearing/cage/ring", "Poisson's ratio of the cage"},
      {"cage_friction", "0.1", "", "0 1", "bearing/cage/ring",
       "friction coefficient between ball and cage, and between cage and land"},
      {"cage_filled", "0.3", "", "0 1", "bearing/cage/ring",
       "fraction of the gaps in pockets and at the land that is filled with oil"},
      {"cage_guide", "balls", "", "one_of balls inner outer", "bearing/cage/ring",
       "guidance of the cage by balls, or by lands of a ring"},
      {"cage_land", "0", "m", "1.0e-4 10 or 0", "bearing/cage/ring",
       "radius of the land that guides the cage"},
      {"cage_clearance", "0", "m", "1.0e-6 0.1 or 0", "bearing/cage/ring",
       "radial clearance between the cage and that land"},
      {"cage_width", "0", "m", "1.0e-5 1 or 0", "bearing/cage/ring",
       "width of each of the two lands"},
      {"cage_without", "none", "", "", "bearing/cage/ring",
       "parts to leave out, joined by +: friction, shear, film, land, churning"},
      {"temperature", "40", "C", "-40 200", "pair_style bearing", "temperature of the lubricant"},
      {"models", "full", "", "", "pair_style bearing",
       "models of the contacts: full, film, eyring, paper or none, or a file"},
      {"gap_film", "power", "", "one_of power moes", "pair_style bearing",
       "law for the film in the gap"},
      {"inlet_shear", "murch", "", "one_of murch wilson gupta", "pair_style bearing",
       "law for film thinning by inlet shear heating"},
      {"spin_law", "closed", "", "one_of closed slices", "pair_style bearing",
       "law for combined spin and slip"},
      {"lubrication", "bath", "", "one_of bath jet mist grease minimal", "pair_style bearing",
       "kind of lubrication, which sets the length of the inlets, starvation and the fraction of "
       "oil"},
      {"oil_level", "0.5", "", "0 100", "pair_style bearing",
       "level of an oil bath above the lowest raceway, as a fraction of the ball diameter"},
      {"without", "none", "", "", "pair_style bearing",
       "parts of the models to leave out, joined by +"},
      {"phase", "0", "rad", "-1.0e3 1.0e3", "create_bearing", "azimuth of the first ball"},
      {"load", "5000", "N", "1.0e-3 1.0e6", "bearing/ring", "radial load on the ring"},
      {"load_azimuth", "-1.5707963267948966", "rad", "-7 7", "bearing/ring",
       "direction of the radial load; -pi/2 is -y"},
      {"axial", "0", "N", "-1.0e6 1.0e6", "bearing/ring",
       "load along the axis; 0: the ring is held in the axial direction"},
      {"moment_x", "0", "N m", "-1.0e5 1.0e5", "bearing/ring",
       "moment on the ring about x; if neither moment is given, the ring cannot tilt"},
      {"moment_y", "0", "N m", "-1.0e5 1.0e5", "bearing/ring", "moment on the ring about y"},
      {"unbalance", "0", "kg m", "0 1.0e3", "bearing/ring",
       "mass times eccentricity of an unbalance that rotates with the ring"},
      {"ramp", "3.0e-3", "s", "0 1.0e3", "bearing/ring",
       "time in which loads and moments increase to their full values"},
      {"housing", "none", "", "one_of none springs", "bearing/ring",
       "support of the outer ring; none: the ring is fixed"},
      {"housing_mass", "2", "kg", "1.0e-4 1.0e4", "bearing/ring",
       "mass of the housing and the outer ring; the default is an estimate for the end shield of a "
       "small motor"},
      {"housing_frequency", "4000", "Hz", "1 1.0e6", "bearing/ring",
       "natural frequency of the housing on its springs alone; the default is an estimate"},
      {"housing_damping", "0.04", "", "0 1", "bearing/ring",
       "damping ratio of the housing; the default is an estimate"},
      {"flaw_inner", "none", "", "", "bearing/profile",
       "flaws of the inner raceway, as keywords of fix bearing/profile"},
      {"flaw_outer", "none", "", "", "bearing/profile", "flaws of the outer raceway"},
      {"flaw_ball", "none", "", "", "bearing/profile", "flaws of balls"},
      {"flawed_ball", "1", "", "", "bearing/profile",
       "numbers of the balls with flaws, as in the command group ID id"},
      {"surroundings", "none", "", "one_of none flooded dry cavitated", "bearing/capacitance",
       "medium in the gaps around the contacts"},
      {"outlet", "1", "", "1 10", "bearing/capacitance",
       "relative permittivity at the outlets of the contacts with surroundings cavitated"},
      {"heat", "no", "", "one_of yes no", "bearing/heat",
       "yes: temperatures follow the losses of the run"},
      {"ambient", "20", "C", "-40 150", "bearing/heat",
       "ambient temperature, at which the bearing has the given clearance"},
      {"cooling", "0", "W/K", "1.0e-4 1.0e5 or 0", "bearing/heat",
       "thermal conductance from the outer ring or housing to ambient; 0: from ISO 15312"},
      {"shaft_cooling", "0", "W/K", "0 1.0e5", "bearing/heat",
       "thermal conductance from the inner ring through the shaft to ambient"},
      {"seat", "0", "W/K", "1.0e-4 1.0e5 or 0", "bearing/heat",
       "thermal conductance from the outer ring to the housing; 0: no thermal resistance"},
      {"housing_capacity", "0", "J/K", "1.0e-2 1.0e9 or 0", "bearing/heat",
       "heat capacity of the housing, which requires a seat; 0: none"},
      {"oil_flow", "0", "m^3/s", "1.0e-12 1.0e-2 or 0", "bearing/heat",
       "volume flow, at 40 C, of oil that flows through the bearing and carries heat away; 0: "
       "none"},
      {"oil_inlet", "", "C", "-40 150", "bearing/heat",
       "inlet temperature of this oil; the default is ambient"},
      {"warm_start", "", "C", "-40 150", "bearing/heat",
       "initial temperature of rings and balls; the default is ambient"},
      {"warm_time", "0", "s", "0 1.0e9", "bearing/heat",
       "simulated thermal time; 0: until the temperatures are steady"},
      {"warm_change", "2", "K", "1.0e-2 20", "bearing/heat",
       "largest change of any temperature in a jump"},
      {"warm_error", "0.5", "K", "1.0e-3 20", "bearing/heat",
       "allowed error of the temperatures after a jump"},
      {"tolerance", "0", "m", "1.0e-13 1.0e-5 or 0", moves,
       "position error of a substep; 0: automatic"},
      {"relative_tolerance", "", "", "0 1.0e-2", moves,
       "position error relative to the largest overlap; the default is 2e-4 without a tolerance, "
       "otherwise 0"},
      {"cage_tolerance", "", "m", "1.0e-13 1.0e-3 or 0", moves,
       "position error of cage balls; the default is 1, 100 or 1000 times tolerance, depending on "
       "the models"},
      {"step_error", "1", "", "1 100", moves,
       "largest accepted error of a substep, as a multiple of the tolerance"},
      {"step_control", "", "", "one_of bound estimate", moves,
       "control of substeps and corrections by error bounds or error estimates; the default "
       "depends on the models"},
      {"sampling", "48000", "Hz", "1.0e3 1.0e6", "bearing/vibration",
       "sampling rate of the signal"},
      {"oversampling", "4", "", "1 100 whole", "bearing/vibration",
       "number of samples in the record per sample of the signal"},
      // bearings: complete data, and usual data, from which complete data are derived
      {"balls", "", "", "2 1000 whole", "bearing data", "number of balls"},
      {"ball_diameter", "", "m", "1.0e-4 0.3", "bearing data", "diameter of a ball"},
      {"inner_radius", "", "m", "1.0e-4 10", "bearing data",
       "radius of the inner raceway at the bottom of its groove"},
      {"outer_radius", "", "m", "1.0e-4 10", "bearing data",
       "radius of the outer raceway, without clearance"},
      {"inner_shoulder_diameter", "0", "m", "1.0e-4 10 or 0", "bearing data",
       "diameter of the inner shoulders; 0: unknown"},
      {"outer_shoulder_diameter", "0", "m", "1.0e-4 10 or 0", "bearing data",
       "diameter of the outer shoulders; 0: unknown"},
      {"inner_groove", "", "m", "5.0e-5 10", "bearing data", "radius of the inner groove"},
      {"outer_groove", "", "m", "5.0e-5 10", "bearing data", "radius of the outer groove"},
      {"cage_ball_diameter", "", "m", "1.0e-5 0.3", "bearing data", "diameter of a cage ball"},
      {"ball_material", "steel", "", "one_of steel silicon_nitride", "usual data|bearing data",
       "material of the balls; with silicon_nitride (a hybrid bearing), the Young's modulus, "
       "Poisson's ratio and density in the file are those of the rings"},
      {"ball_young", "210e9", "Pa", "1.0e8 1.0e13", "usual data|bearing data",
       "Young's modulus of the balls; the default is that of bearing steel", "", "bearing data"},
      {"ball_poisson", "0.3", "", "0 0.5", "usual data|bearing data",
       "Poisson's ratio of the balls; the default is that of bearing steel", "", "bearing data"},
      {"ball_density", "7800", "kg/m^3", "100 3.0e4", "usual data|bearing data",
       "density of the balls; the default is that of bearing steel", "", "bearing data"},
      {"ball_expansion", "0", "1/K", "1.0e-8 1.0e-4 or 0", "usual data|bearing data",
       "coefficient of thermal expansion of the balls; 0: that of their material"},
      {"ball_heat_capacity", "0", "J/(kg K)", "10 1.0e4 or 0", "usual data|bearing data",
       "specific heat capacity of the balls; 0: that of their material"},
      {"ball_conductivity", "0", "W/(m K)", "0.1 1.0e3 or 0", "usual data|bearing data",
       "thermal conductivity of the balls; 0: that of their material"},
      {"ring_young", "0", "Pa", "1.0e8 1.0e13 or 0", "usual data|bearing data",
       "Young's modulus of the rings; 0: that of the balls, if these are of steel"},
      {"ring_poisson", "0", "", "0 0.5", "usual data|bearing data",
       "Poisson's ratio of the rings; 0: that of the balls, if these are of steel"},
      {"ring_density", "0", "kg/m^3", "100 3.0e4 or 0", "usual data|bearing data",
       "density of the rings; 0: that of the balls, if these are of steel"},
      {"inner_mass", "", "kg", "1.0e-7 1.0e5", "bearing data", "mass of the inner ring"},
      {"inner_inertia", "", "kg m^2", "1.0e-15 1.0e6", "bearing data",
       "inertia of the inner ring about its axis"},
      {"inner_inertia_t", "", "kg m^2", "1.0e-15 1.0e6", "bearing data",
       "inertia of the inner ring across its axis"},
      {"pitch_diameter", "", "m", "1.0e-3 20", "usual data",
       "diameter of the circle through the balls' centres"},
      {"inner_conformity", "", "", "0.5 10", "usual data",
       "groove radius of the inner ring divided by the ball diameter"},
      {"outer_conformity", "", "", "0.5 10", "usual data",
       "groove radius of the outer ring divided by the ball diameter"},
      {"pocket_play", "", "m", "0 0.1", "usual data",
       "play of a ball in its pocket along the pitch circle; the default is 2.5 % of the ball's "
       "diameter"},
      {"bore_diameter", "", "m", "1.0e-4 20", "usual data", "bore of the inner ring"},
      {"bearing_width", "", "m", "1.0e-4 3", "usual data", "width of the rings"},
      {"outside_diameter", "", "m", "1.0e-4 40", "catalogue data",
       "outside diameter of the outer ring"},
      // Oils. The defaults are those of mineral oils. The effects were determined for a 6208 with
      // vg46 at 70 C, under loads of 1 to 5 kN at 100 to 6000 rpm.
      {"oil_conductivity", "0.14", "W/(m K)", "1.0e-3 100", "oil constant",
       "thermal conductivity; an increase by 20 % makes the film 0 to 1 % thicker and changes the "
       "torque less",
       "film full eyring file"},
      {"oil_heat_capacity", "1950", "J/(kg K)", "1 1.0e5", "oil constant",
       "heat capacity, used with oil_flow only; an increase by 20 % then cools the bearing by "
       "about 1 K",
       "-"},
      {"eyring_stress", "5.0e6", "Pa", "1.0e4 1.0e9", "oil constant",
       "Eyring stress for models eyring; an increase by 20 % raises the torque by 0.4 to 6 %",
       "eyring file"},
      {"limiting_traction", "0.047", "", "1.0e-4 1", "oil constant",
       "ratio of limiting shear stress to pressure for models eyring; no effect below that limit",
       "eyring file"},
      {"oil_density_40", "", "kg/m^3", "300 3000", "oil over temperature", "density at 40 C"},
      {"oil_density_slope", "0.6", "kg/(m^3 K)", "0 10", "oil over temperature",
       "decrease of density per K; an increase by 20 % makes the film 0.3 % thinner at 70 C"},
      {"pressure_viscosity_40", "22.5e-9", "1/Pa", "1.0e-10 1.0e-6", "oil over temperature",
       "pressure-viscosity coefficient at 40 C; 15.5e-9 for PAO. An increase of this and the value "
       "at 100 C by 20 % makes the film 11 % thicker and lowers the capacitance by 10 % and the "
       "torque by 1 to 2 %"},
      {"pressure_viscosity_100", "14.5e-9", "1/Pa", "1.0e-10 1.0e-6", "oil over temperature",
       "pressure-viscosity coefficient at 100 C; 12e-9 for PAO"},
      {"permittivity_40", "2.25", "", "1 10", "oil over temperature",
       "relative permittivity at 40 C; an increase by 0.1 raises the capacitance by 6 %"},
      // oils at the temperature of the run
      {"viscosity", "", "Pa s", "1.0e-5 100", "oil data",
       "viscosity at the temperature of the run and ambient pressure"},
      {"pressure_viscosity", "22.5e-9", "1/Pa", "1.0e-10 1.0e-6", "oil data",
       "pressure-viscosity coefficient; an increase by 20 % makes the film 11 % thicker and lowers "
       "the capacitance by 10 % and the torque by 1 to 2 %"},
      {"permittivity", "2.25", "", "1 10", "oil data",
       "relative permittivity; an increase by 0.1 raises the capacitance by 6 %"},
      {"roughness", "1.0e-7", "m", "1.0e-10 1.0e-5", "oil data",
       "rms roughness of honed raceways; lambda is inversely proportional to it"},
      {"ball_roughness", "0", "m", "0 1.0e-5", "oil data", "rms roughness of the balls"},
      // many bearings
      {"bearings", "24", "", "1 1.0e7 whole", "in.many", "number of bearings"},
      {"columns", "6", "", "1 1.0e7 whole", "in.many", "number of bearings in a row of the grid"},
      {"only", "0", "", "0 1.0e7 whole", "in.many",
       "number of the only bearing to be built; 0: build all"},
      {"fleet", "spread", "", "one_of spread alike", "in.many",
       "loads and speeds of the bearings, spread or all alike"},
      {"kinds", "0", "", "0 16 whole", "in.many", "number of lubricants; 0: count them"},
      {"time", "0.02", "s", "1.0e-9 1.0e6", "in.many", "simulated time"},
      {"sample", "1.0e-3", "s", "1.0e-12 1.0e3", "in.many", "time between rows of the table"},
  };
  return table;
}

std::string DeckVariable::label() const
{
  return *unit ? std::string(name) + " (" + unit + ")" : name;
}

// Returns true if `list`, whose items are joined by |, contains an item.
static bool contains(std::string_view list, const std::string &item)
{
  while (!list.empty()) {
    const size_t end = list.find('|');
    if (list.substr(0, end) == item) return true;
    list.remove_prefix(end == list.npos ? list.size() : end + 1);
  }
  return false;
}

bool DeckVariable::taken_by(const std::string &command) const { return contains(of, command); }

bool DeckVariable::needed_by(const std::string &kind) const
{
  return !*initial || contains(without_default, kind);
}

bool DeckVariable::of_data() const
{
  for (const char *kind : {"bearing data", "usual data", "catalogue data", "oil data",
                           "oil constant", "oil over temperature"})
    if (taken_by(kind)) return true;
  return false;
}

bool DeckVariable::taken_by_models(const std::string &name) const
{
  return !*models || (" " + std::string(models) + " ").find(" " + name + " ") != std::string::npos;
}

bool DeckVariable::of_one_deck() const { return std::string(of).compare(0, 3, "in.") == 0; }

std::vector<DeckVariable> variables_of(const std::string &of)
{
  std::vector<DeckVariable> found;
  for (const DeckVariable &v : deck_variables())
    if (v.taken_by(of)) found.push_back(v);
  return found;
}

std::string usual_word(const std::string &name) { return find_deck_variable(name)->initial; }

double usual_number(const std::string &name) { return std::stod(usual_word(name)); }

const DeckVariable *find_deck_variable(const std::string &name)
{
  for (const DeckVariable &v : deck_variables())
    if (v.name == name) return &v;
  return nullptr;
}

std::string mistyped(const std::set<std::string> &names)
{
  constexpr size_t slips = 2, shortest = 5;    // in shorter names, this would be half of the
                                               // letters
  for (const std::string &name : names) {
    if (find_deck_variable(name) || name.size() < shortest) continue;
    for (const DeckVariable &v : deck_variables())
      if (!names.count(v.name) && v.of_data() && distance(name, v.name) <= slips)
        return "there is no variable '" + name + "', nearest is '" + v.name + "'";
  }
  return "";
}

std::string wrong_value(const DeckVariable &v, const std::string &value)
{
  std::vector<std::string> words = words_of(v.range);
  if (words.empty()) return "";
  if (words[0] == "one_of") {
    words.erase(words.begin());
    const bool found = std::find(words.begin(), words.end(), value) != words.end();
    return found ? "" : v.label() + " is '" + value + "', must be one of " + joined(words);
  }
  words.resize(4);
  const std::string &more = words[2], &other = words[3];
  const bool whole = more == "whole", also = more == "or";
  char *end = nullptr;
  const double is = strtod(value.c_str(), &end);
  // the formulas of the hosts do not accept the other number formats of C (hex, inf, nan)
  if (value.empty() || *end || value.find_first_not_of("0123456789.eE+-") != std::string::npos ||
      value[0] == '+')
    return v.label() + " must be a number like 5000 or 5.0e3, not '" + value + "'";
  if (also && is == strtod(other.c_str(), nullptr)) return "";
  const double lo = strtod(words[0].c_str(), nullptr), hi = strtod(words[1].c_str(), nullptr);
  if (is >= lo && is <= hi && !(whole && is != std::floor(is))) return "";
  char text[160];
  snprintf(text, sizeof text, " is %.6g, must be %sfrom %.6g to %.6g", is,
           whole ? "a whole number " : "", lo, hi);
  return v.label() + text + (also ? ", or " + other : "");
}

}    // namespace bearing
