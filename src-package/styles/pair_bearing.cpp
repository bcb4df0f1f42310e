// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_bearing.h"

#include "../core/settings/arguments.h"
#include "../core/settings/deck_variable_table.h"
#include "../core/settings/written.h"
#include "derive_data.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "named_bearing.h"
#include "print_line.h"

#include <algorithm>
#include <sstream>

using namespace LAMMPS_NS;
using bearing::Arguments;
using bearing::digits;
using bearing::NamedBearing;
using bearing::text;

// Returns the words of a file of keywords, without its comments.
static std::string keywords_of(const std::string &text)
{
  std::istringstream lines(text);
  std::string words;
  for (std::string line; std::getline(lines, line);) words += " " + line.substr(0, line.find('#'));
  return words;
}

// pair_style bearing oil NAME|dry [axis x|y|z] [overlap_limit F] [temperature T] [models M]
// [without PARTS] [gap_film L] [inlet_shear L] [spin_law L] [lubrication K] [oil_level H]
// [inputs FOLDER] [further keywords of bearing/ehd or bearing/hertz]
void PairBearing::settings(int narg, char **arg)
{
  if (replays_) return PairBearingHertz::settings(narg, arg);
  Arguments args(lmp, "pair_style bearing", narg, arg, 0);
  oil_name_.clear();
  own_model_.clear();
  more_.clear();
  coeffs_.clear();
  choice_ = {};
  temperature_ = bearing::usual_number("temperature");
  std::vector<std::string> of_style;    // words for the base class
  while (args.more()) {
    if (args.next() == "axis" || args.next() == "overlap_limit") {
      of_style.push_back(args.word("keyword"));
      of_style.push_back(args.word("value of " + of_style.back()));
    } else if (!(args.word("oil", oil_name_, "oil of inputs/lubricants, a file, or dry") ||
                 args.variable("temperature", temperature_) ||
                 args.word("models", choice_.models, "models") ||
                 args.word("without", choice_.without, "parts to leave out") ||
                 args.variable("gap_film", choice_.gap_film) ||
                 args.variable("inlet_shear", choice_.inlet_shear) ||
                 args.variable("spin_law", choice_.spin_law) ||
                 args.variable("lubrication", choice_.lubrication) ||
                 args.variable("oil_level", choice_.oil_level) ||
                 args.word("inputs", folder_, "folder of the data files"))) {
      more_ += " " + args.word("keyword");
    }
  }
  if (oil_name_.empty()) args.fail("'oil NAME' is missing; use 'oil dry' for dry contacts");
  const auto &names = bearing::model_names;
  if (std::find(names.begin(), names.end(), choice_.models) == names.end()) {
    const std::string file = folder_ + "/models/" + choice_.models;
    const std::optional<std::string> own = args.content(file);
    const std::optional<std::string> path = own ? own : args.content(choice_.models);
    if (!path)
      args.fail("there is no model '" + choice_.models + "'; there is: " + bearing::joined(names) +
                ", or a file of keywords");
    own_model_ = keywords_of(*path);
  }
  const bearing::OilWords oil = read_oil(args, oil_name_, temperature_);
  const bool film = oil.at("film") != "dry";
  set_film(film);
  try {
    const bearing::ContactModel model = contact_model(choice_, film ? &oil : nullptr, {});
    cage_share_ = model.cage_tolerance_share;
    estimate_ = model.estimate;
  } catch (const bearing::DataError &wrong) {
    args.fail("models " + choice_.models + ", oil " + oil_name_ + ": " + wrong.what());
  }
  bearing::pass_words(of_style,
                      [this](int n, char **words) { PairBearingHertz::settings(n, words); });
}

// Returns the data of an oil at the temperature t (C). For dry contacts, they contain only the word
// `film`.
bearing::OilWords PairBearing::read_oil(const Arguments &args, const std::string &name, double t)
{
  if (name == "dry") return {{"film", "dry"}};
  bearing::NamedData oil = bearing::read_data(lmp, args, folder_, "lubricants", name);
  oil.values.emplace("film", "film");
  if (oil.values["film"] == "dry") return oil.values;
  given_ = bearing::given_of(oil, {"oil data", "oil constant", "oil over temperature"});
  oil.values["temperature"] = digits(t);
  std::vector<std::string> assumed = check_data(args, oil, "oil constant");
  if (bearing::follows_temperature(oil.values)) {
    const std::vector<std::string> more = check_data(args, oil, "oil over temperature");
    assumed.insert(assumed.end(), more.begin(), more.end());
    bearing::DataValues values(args, oil.values, oil.label);
    bearing::derive_oil(values);
    const std::string wrong =
        bearing::wrong_value(*bearing::find_deck_variable("viscosity"), oil.values.at("viscosity"));
    if (!wrong.empty()) args.fail(oil.label + " at " + text(t) + " C: " + wrong);
  } else if (const auto at = oil.of_file.find("temperature");
             at != oil.of_file.end() && args.number_in(at->second, "temperature") != t)
    args.fail(oil.label + " has values for " + at->second + " C only, not for " + text(t) +
              " C: use a lubricant with physical data, for example vg46");
  const std::vector<std::string> more = check_data(args, oil, "oil data");
  assumed.insert(assumed.end(), more.begin(), more.end());
  assumed_.clear();
  const std::string models = own_model_.empty() ? choice_.models : "file";
  for (const std::string &constant : assumed)
    if (bearing::find_deck_variable(constant)->taken_by_models(models))
      assumed_ += (assumed_.empty() ? "" : ",") + constant + "=" + oil.values.at(constant);
  if (const std::string note = bearing::note_of_deck(oil); note != noted_) {
    noted_ = note;
    bearing::print_line(lmp, note);
  }
  return oil.values;
}

// pair_coeff * * NAME [oil NAME [temperature T]] [speed W] [spheres printed] [keywords of its
// raceways]
void PairBearing::coeff(int narg, char **arg)
{
  const bool named = narg > 2 && strcmp(arg[0], "*") == 0 && strcmp(arg[1], "*") == 0;
  if (replays_ || !named) return PairBearingHertz::coeff(narg, arg);
  Arguments args(lmp, "pair_coeff * *", narg, arg, 2);
  const NamedBearing &b = bearing::bearing_of(lmp, args, args.word("name of a bearing"));
  for (int type : {b.balls, b.cage, b.inner, b.outer})
    if (type > atom->ntypes)
      args.fail("bearing " + b.name + " has atom type " + std::to_string(type) +
                ", but the box has only " + std::to_string(atom->ntypes));
  b.in_use = true;
  Coeff own;
  own.bearing = b.name;
  own.oil = oil_name_;
  own.temperature = temperature_;
  while (args.more())
    if (args.take("spheres")) own.printed = args.choice("spheres", {"exact", "printed"}) == 1;
    else if (args.number("speed", own.speed, "speed of the rings (rad/s)")) own.speed_given = true;
    else if (!args.word("oil", own.oil, "oil of inputs/lubricants, or a file") &&
             !args.variable("temperature", own.temperature))
      own.law += " " + args.word("keyword");
  own.data = read_oil(args, own.oil, own.temperature);
  if (own.data.count("permittivity"))
    own.permittivity = std::atof(own.data.at("permittivity").c_str());
  if ((own.data.at("film") != "dry") != coefficients().lubricated())
    args.fail("oil " + own.oil + " of bearing " + b.name + " and oil " + oil_name_ +
              " of the pair style: all bearings of a run have films, or all are dry");
  const auto same = [&](const Coeff &c) { return c.bearing == b.name; };
  const auto before = std::find_if(coeffs_.begin(), coeffs_.end(), same);
  own.first = before == coeffs_.end() ? commands().size() : before->first;
  if (before != coeffs_.end()) coeffs_.erase(before);
  resolve(own);
  coeffs_.push_back(own);
}

// Passes commands to the base class for both raceways and for the cage or, if there is none, for
// balls that may touch each other.
void PairBearing::resolve(Coeff &of)
{
  Arguments args(lmp, "pair_coeff * * " + of.bearing, {});
  const NamedBearing &b = bearing::bearing_of(lmp, args, of.bearing);
  const bool film = coefficients().lubricated();
  std::string law = " young " + b.word("ball_young") + " " + b.word("ring_young") + " poisson " +
                    b.word("ball_poisson") + " " + b.word("ring_poisson");
  if (film)
    law += " lubricant " + of.data.at("viscosity") + " " + of.data.at("pressure_viscosity") +
           " roughness " + of.data.at("roughness") + " " + of.data.at("ball_roughness");
  bearing::LubricatedBearing lubricated = {
      0.5 * (b.number("inner_radius") + b.number("outer_radius")), 0.5 * b.number("ball_diameter"),
      b.number_or("bore_diameter", 0.0), b.number_or("outside_diameter", 0.0),
      b.number_or("contact_angle", 0.0)};
  // twelve digits are the accuracy of a speed that the deck has converted from rpm to rad/s
  char rpm[32];
  snprintf(rpm, sizeof rpm, "%.12g", std::fabs(of.speed) * 30.0 / M_PI);
  lubricated.rpm = strtod(rpm, nullptr);
  try {
    law += " " +
           (own_model_.empty() ? contact_model(choice_, film ? &of.data : nullptr, lubricated).words
                               : own_model_) +
           more_ + of.law;
  } catch (const bearing::DataError &wrong) {
    args.fail("models " + choice_.models + ", oil " + of.oil + ": " + wrong.what());
  }
  const bool drags = choice_.models == "full" || choice_.models == "eyring";
  of.oil_share =
      drags && film ? bearing::lubrication_words(choice_.lubrication, choice_.oil_level, lubricated,
                                                 std::atof(of.data.at("viscosity").c_str()),
                                                 std::atof(of.data.at("oil_density").c_str()))
                          .share
                    : 0.0;
  const std::string ball = std::to_string(b.balls), young = b.word("ball_young"),
                    poisson = b.word("ball_poisson");
  const std::string lines[] = {
      ball + " " + std::to_string(b.inner) + " inner " + b.word("b_inner_raceway") + " " +
          b.word("inner_groove") + " " + b.word("b_inner_arch") + law,
      ball + " " + std::to_string(b.outer) + " outer " + b.word("b_outer_raceway") + " " +
          b.word("outer_groove") + " " + b.word("b_outer_arch") + law,
      b.has_cage_ring ? ball + " " + std::to_string(b.cage) + " cage"
      : b.has_cage    ? ball + " " + std::to_string(b.cage) + " sphere " + young + " " + poisson +
                            " 3.3e9 0.41" + (of.printed ? " printed" : "")
                      : ball + " " + ball + " sphere " + young + " " + poisson + " " + young + " " +
                            poisson + (of.printed ? " printed" : "")};
  for (size_t k = 0; k < 3; ++k) {
    bearing::pass_words(bearing::words_of(lines[k]),
                        [this](int n, char **words) { PairBearingHertz::coeff(n, words); });
    move_last_command(of.first + k);
  }
}

// The starvation of a bearing is that at the speed at which its rings turn in this run, which may
// differ from the speed with which they were created or turned before.
void PairBearing::init_style()
{
  cool();
  for (Coeff &c : coeffs_) {
    const NamedBearing *b = bearing::find_bearing(lmp, c.bearing);
    if (c.speed_given || !b) continue;
    const double speed = ring_speed(b->inner) - ring_speed(b->outer);
    if (std::isnan(speed) || std::fabs(speed) == std::fabs(c.speed)) continue;
    c.speed = speed;
    resolve(c);
  }
  PairBearingHertz::init_style();
}

// Returns true if balls of the bearing are in the group of a fix bearing/heat.
bool PairBearing::is_heated(const std::string &bearing) const
{
  const NamedBearing *b = bearing::find_bearing(lmp, bearing);
  int heated = 0;
  for (int k = 0; k < modify->nfix; ++k)
    for (int i = 0; i < atom->nlocal; ++i)
      heated |= strcmp(modify->fix[k]->style, "bearing/heat") == 0 && b &&
                atom->type[i] == b->balls && (atom->mask[i] & modify->fix[k]->groupbit);
  MPI_Allreduce(MPI_IN_PLACE, &heated, 1, MPI_INT, MPI_MAX, world);
  return heated;
}

// Sets the temperature of every oil to that given in the deck. Fixes that heat bearings set theirs
// afterwards; a fix may have been deleted since the last run.
void PairBearing::cool()
{
  for (Coeff &c : coeffs_) {
    if (!c.warm) continue;
    c.warm = false;
    if (!is_heated(c.bearing) && comm->me == 0)
      BRG_WARN("pair_style bearing: fix bearing/heat of bearing " + c.bearing +
               " is gone: the oil has its temperature of " + text(c.temperature) +
               " C again, and the parts have the dimensions of cold parts");
    c.data = read_oil(Arguments(lmp, "pair_coeff * * " + c.bearing, {}), c.oil, c.temperature);
    resolve(c);
  }
}

// Returns the speed (rad/s) of all rings of this type in the next run. It is NAN if they turn at
// different speeds, or at a speed that changes.
double PairBearing::ring_speed(int ring_type) const
{
  const std::vector<FixBearingRing *> fixes = bearing::fixes_of<FixBearingRing>(lmp);
  const raceway::LabAxes axes{coefficients().axis_index()};
  double range[2] = {HUGE_VAL, HUGE_VAL};    // the least speed, and minus the largest
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->type[i] != ring_type) continue;
    const auto mover = std::find_if(fixes.begin(), fixes.end(),
                                    [i](const FixBearingRing *f) { return f->moves(i); });
    double speed = axes.third(raceway::Vec3::from(atom->omega[i])).z;
    if (mover != fixes.end()) speed = (*mover)->constant_spin();
    range[0] = std::min(range[0], std::isnan(speed) ? -HUGE_VAL : speed);
    range[1] = std::min(range[1], std::isnan(speed) ? -HUGE_VAL : -speed);
  }
  MPI_Allreduce(MPI_IN_PLACE, range, 2, MPI_DOUBLE, MPI_MIN, world);
  return std::isfinite(range[0]) && range[0] == -range[1] ? range[0] : NAN;
}

void PairBearing::set_speed(const std::string &name, double speed)
{
  for (Coeff &c : coeffs_)
    if (c.bearing == name && c.speed == 0.0 && speed != 0.0) {
      c.speed = speed;
      resolve(c);
    }
}

std::string PairBearing::oil_datum(const std::string &bearing, const std::string &name) const
{
  for (const Coeff &c : coeffs_)
    if (c.bearing == bearing && c.data.count(name)) return c.data.at(name);
  return "";
}

double PairBearing::oil_share(const std::string &bearing) const
{
  for (const Coeff &c : coeffs_)
    if (c.bearing == bearing) return c.oil_share;
  return 0.0;
}

std::string PairBearing::oil() const
{
  const std::string &first = coeffs_.empty() ? oil_name_ : coeffs_.front().oil;
  const bool one =
      std::all_of(coeffs_.begin(), coeffs_.end(), [&](const Coeff &c) { return c.oil == first; });
  return one ? first : "";
}

std::pair<std::string, double> PairBearing::oil_of(const std::string &bearing) const
{
  for (const Coeff &c : coeffs_)
    if (c.bearing == bearing) return {c.oil, c.temperature};
  return {"", NAN};
}

bool PairBearing::oil_follows(const std::string &name) const
{
  return std::any_of(coeffs_.begin(), coeffs_.end(), [&](const Coeff &c) {
    return c.bearing == name && bearing::follows_temperature(c.data);
  });
}

void PairBearing::set_oil_temperature(const Arguments &args, const std::string &name, double t)
{
  for (Coeff &c : coeffs_) {
    if (c.bearing == name) {
      c.data = read_oil(args, c.oil, t);
      c.warm = true;
    }
    resolve(c);
  }
  const std::string wrong = coefficients().prepare_again();
  if (!wrong.empty()) args.fail(wrong);
}

double PairBearing::permittivity(int ball_type) const
{
  const NamedBearing *b = bearing::bearing_of_type(lmp, ball_type);
  for (const Coeff &c : coeffs_)
    if (b && c.bearing == b->name) return c.permittivity;
  return 0.0;
}

double PairBearing::shoulder(int ball_type, raceway::Side side) const
{
  const NamedBearing *b = bearing::bearing_of_type(lmp, ball_type);
  const bool inner = side == raceway::Side::inner;
  return b ? b->number_or(inner ? "inner_shoulder_diameter" : "outer_shoulder_diameter", 0.0) : 0.0;
}

// The commands are stored in the restart file with the numbers from the data files, because these
// files may change.
void PairBearing::write_restart(FILE *fp)
{
  const Kept kept = {cage_share_, coefficients().lubricated(), estimate_};
  fwrite(&kept, sizeof kept, 1, fp);
  PairBearingHertz::write_restart(fp);
}

void PairBearing::read_restart BRG_READ_RESTART_SIG
{
  Kept kept = {1.0, 0, 0};
  if (comm->me == 0 && fread(&kept, sizeof kept, 1, fp) != 1) kept = {1.0, 0, 0};
  MPI_Bcast(&kept, sizeof kept, MPI_BYTE, 0, world);
  set_film(kept.film != 0);
  cage_share_ = kept.cage_share;
  estimate_ = kept.estimate != 0;
  replays_ = true;
  PairBearingHertz::read_restart BRG_READ_RESTART_ARGS;
  replays_ = false;
}
