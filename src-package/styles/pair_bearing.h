// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style bearing: contacts in bearings that are specified by their names, an oil and models.
// The laws are those of bearing/ehd or, for dry contacts, of bearing/hertz.
#ifdef PAIR_CLASS
PairStyle(bearing,PairBearing)
#else
#ifndef LMP_PAIR_BEARING_H
#define LMP_PAIR_BEARING_H

#include "../core/settings/deck_variable_table.h"
#include "../core/settings/model_words.h"
#include "pair_bearing_hertz.h"

namespace LAMMPS_NS {

class PairBearing : public PairBearingHertz {
 public:
  explicit PairBearing(class LAMMPS *lmp) : PairBearingHertz(lmp, false) {}
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  void write_restart(FILE *) override;
  void read_restart BRG_READ_RESTART_SIG override;

  double relative_tolerance() const override { return 2e-4; }
  double cage_tolerance_share() const override { return cage_share_; }
  bool estimates_errors() const override { return estimate_; }
  double permittivity(int ball_type) const override;
  double shoulder(int ball_type, raceway::Side) const override;
  bool dry_by_choice() const override { return !coefficients().lubricated(); }

  // Sets the relative speed (rad/s) of the rings of a named bearing, which determines oil
  // starvation. Only the first speed that is set for a bearing is used. If pair_coeff does not give
  // the speed, it follows the rings from run to run.
  void set_speed(const std::string &bearing, double);
  // Returns a property of the oil of a bearing at its temperature as text, or an empty string if
  // the oil lacks this property.
  std::string oil_datum(const std::string &bearing, const std::string &name) const;
  // Returns the fraction of the space around the bearing's balls that is filled with oil. It is 0
  // if there is no oil or if the models do not include drag.
  double oil_share(const std::string &bearing) const;
  std::string oil() const;    // oil of all bearings; empty if their oils differ
  // Returns the oil of a named bearing and the oil's temperature (C), or an empty string and NaN if
  // the bearing has no pair_coeff.
  std::pair<std::string, double> oil_of(const std::string &bearing) const;
  // Returns true if the oil data of a named bearing depend on temperature.
  bool oil_follows(const std::string &bearing) const;
  // Sets the temperature (C) of a bearing's oil during a run. Afterwards, the raceways have the
  // dimensions of the cold parts.
  void set_oil_temperature(const bearing::Arguments &, const std::string &bearing, double);
  const std::string &models() const { return choice_.models; }
  double temperature() const { return temperature_; }
  const std::vector<std::string> &given() const { return given_; }    // oil data as NAME=VALUE
  // Returns those constants of the oil that are used by the models although they are missing in its
  // file, as NAME=VALUE,...
  const std::string &assumed() const { return assumed_; }

 private:
  struct Coeff {
    std::string bearing;
    std::string oil;           // name of the oil
    double temperature;        // C
    bool warm = false;         // true if a fix has set another temperature
    bearing::OilWords data;    // data of the oil
    std::string law;           // further keywords of the raceways
    bool printed = false;      // `spheres printed`, applied to balls and cage balls
    double speed = 0.0;        // rad/s
    bool speed_given = false;
    size_t first = 0;             // index of the first line of this pair_coeff in commands()
    double permittivity = 0.0;    // relative, at `temperature`; 0: unknown
    double oil_share = 0.0;       // fraction of the space around the balls that is filled with oil
  };
  struct Kept {    // stored in restart files before the commands
    double cage_share;
    int film, estimate;
  };
  bearing::OilWords read_oil(const bearing::Arguments &, const std::string &name, double t);
  void resolve(Coeff &);
  bool is_heated(const std::string &bearing) const;
  void cool();
  double ring_speed(int ring_type) const;

  std::string oil_name_, more_;    // more_: further keywords
  std::string folder_ = bearing::usual_word("inputs");
  double temperature_ = bearing::usual_number("temperature"), cage_share_ = 1.0;
  bool estimate_ = true;
  bearing::ModelChoice choice_;
  std::string own_model_;    // keywords from a file of models
  std::vector<std::string> given_;
  std::string noted_;    // note about data set by the deck that has been printed
  std::string assumed_;
  std::vector<Coeff> coeffs_;
  bool replays_ = false;    // true while the commands of a restart file are repeated
};

}    // namespace LAMMPS_NS

#endif
#endif
