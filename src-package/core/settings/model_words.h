// SPDX-License-Identifier: GPL-2.0-or-later
// Converts the name of a contact model to the keywords of pair_style bearing/ehd or bearing/hertz
// that select it. The parts of each model are listed in docs/pair_bearing. This does not depend on
// the host.
#pragma once

#include "deck_variable_table.h"

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace bearing {

// Thrown if data are wrong or missing. The message names the datum.
struct DataError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Returns the parts that `without` leaves out, joined by + or none. Throws DataError for a part
// that does not exist.
std::set<std::string> left_out(const std::string &without, const std::vector<std::string> &parts);

typedef std::map<std::string, std::string> OilWords;    // maps the name of each datum to its value
                                                        // as text

struct ModelChoice {
  std::string models = usual_word("models");      // paper, film, full, eyring or none
  std::string without = usual_word("without");    // parts to leave out, joined by +
  std::string gap_film = usual_word("gap_film"), inlet_shear = usual_word("inlet_shear"),
              spin_law = usual_word("spin_law");
  std::string lubrication = usual_word("lubrication");    // kind (core/laws/lubrication.h)
  double oil_level = usual_number("oil_level");    // level of an oil bath above the lowest raceway,
                                                   // in ball diameters
};

// Bearing to which a ModelChoice is applied: the radii of the pitch circle and the balls (m), the
// bore and outside diameters (m, 0 if unknown), the nominal contact angle, and the speed (rpm).
struct LubricatedBearing {
  double pitch_radius = 1.0, ball_radius = 1.0, bore = 0.0, outside = 0.0, contact_angle = 0.0;
  double rpm = 0.0;
};

// Parameters of rolling resistance and drag for a kind of lubrication.
struct LubricationWords {
  double starvation = 1.0, inlet = 0.0, share = 0.0;    // phi_rs; inlet length in semi-axes b; X
};
// The viscosity of the oil is in Pa s and its density in kg/m^3. Throws DataError for an unknown
// kind of lubrication.
LubricationWords lubrication_words(const std::string &kind, double level, const LubricatedBearing &,
                                   double viscosity, double density);

extern const std::vector<std::string> model_names;

struct ContactModel {
  std::string words;                    // keywords of the pair style
  double cage_tolerance_share = 1.0;    // tolerance of cage balls relative to that of other bodies
  bool estimate = true;                 // control implicit steps by error estimates instead of
                                        // bounds
};

// `oil` is null for dry contacts. Throws DataError if a part is not in the models or if data for
// the oil are missing.
ContactModel contact_model(const ModelChoice &, const OilWords *oil, const LubricatedBearing &);

}    // namespace bearing
