// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style bearing: contacts of named bearings, given by oil and models, with the laws of
// bearing/ehd or, if dry, bearing/hertz.
#ifdef PAIR_CLASS
PairStyle(bearing,PairBearing)
#else
#ifndef LMP_PAIR_BEARING_H
#define LMP_PAIR_BEARING_H

#include "../core/settings/model_words.h"
#include "pair_bearing_hertz.h"

namespace LAMMPS_NS {

class PairBearing : public PairBearingHertz {
 public:
  explicit PairBearing(class LAMMPS *lmp) : PairBearingHertz(lmp, false) {}
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void write_restart(FILE *) override;
  void read_restart BRG_READ_RESTART_SIG override;

  double relative_tolerance() const override { return 2e-4; }
  double cage_tolerance_share() const override { return cage_share_; }
  bool estimates_errors() const override { return estimate_; }
  double permittivity(int ball_type) const override;
  double shoulder(int ball_type, raceway::Side) const override;
  bool dry_by_choice() const override { return !coefficients().lubricated(); }

  // Relative speed of the rings of a named bearing (rad/s), for starvation of the oil.
  // The first speed counts.
  void set_speed(const std::string &bearing, double);
  // A datum of a bearing's oil at its temperature, as text; empty if it has none.
  std::string oil_datum(const std::string &bearing, const std::string &name) const;
  // Share of oil in the space around its balls; 0 without oil, or with models without drag.
  double oil_share(const std::string &bearing) const;
  std::string oil() const;    // oil of all bearings; empty if they have several oils
  // Oil of a named bearing, and its temperature (C); empty and NaN without a pair_coeff.
  std::pair<std::string, double> oil_of(const std::string &bearing) const;
  // True if the oil of a named bearing has data over temperature.
  bool oil_follows(const std::string &bearing) const;
  // Sets the temperature of its oil (C) during a run. Raceways then have the sizes of cold parts.
  void set_oil_temperature(const bearing::Arguments &, const std::string &bearing, double);
  const std::string &models() const { return choice_.models; }
  double temperature() const { return temperature_; }
  const std::vector<std::string> &given() const { return given_; }    // oil data, NAME=VALUE
  // Constants of the oil that the models use and its file does not have, NAME=VALUE,...
  const std::string &assumed() const { return assumed_; }

 private:
  struct Coeff {
    std::string bearing;
    std::string oil;           // name
    double temperature;        // C
    bearing::OilWords data;    // data of the oil
    std::string law;           // further keywords of the raceways
    bool printed = false;      // for balls and cage balls
    double speed = 0.0;        // rad/s
    size_t first = 0;          // first of its lines in commands()
    double oil_share = 0.0;    // share of the space around the balls
  };
  struct Kept {    // in restart files, before the commands
    double cage_share;
    int film, estimate;
  };
  bearing::OilWords read_oil(const bearing::Arguments &, const std::string &name, double t);
  void resolve(Coeff &);

  std::string oil_name_, more_;    // more_: further keywords
  std::string folder_ = "inputs";
  double temperature_ = 40.0, cage_share_ = 1.0;
  bool estimate_ = true;
  bearing::ModelChoice choice_;
  std::string own_model_;    // keywords of a file of models
  std::vector<std::string> given_;
  std::string noted_;    // printed note on data that the deck sets
  std::string assumed_;
  std::vector<Coeff> coeffs_;
  bool replays_ = false;    // commands of a restart file
};

}    // namespace LAMMPS_NS

#endif
#endif
