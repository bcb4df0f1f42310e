// SPDX-License-Identifier: GPL-2.0-or-later
// Models of contacts by name: the keywords of pair_style bearing/ehd or bearing/hertz for them.
// docs/pair_bearing has what each is made of. Independent of the host.
#ifndef BEARING_MODEL_WORDS_H
#define BEARING_MODEL_WORDS_H

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace bearing {

// Wrong or missing data; the message names the datum.
struct DataError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

typedef std::map<std::string, std::string> OilWords;    // data by name, as text

struct ModelChoice {
  std::string models = "full";     // paper, film, full, eyring or none
  std::string without = "none";    // parts to leave out, joined by +
  std::string gap_film = "power", inlet_shear = "murch", spin_law = "closed";
};

extern const std::vector<std::string> model_names;

struct ContactModel {
  std::string words;                    // keywords of the pair style
  double cage_tolerance_share = 1.0;    // tolerance of cage balls over that of the others
};

// `oil`: null for dry contacts. phi_rs: factor of starvation on rolling resistance. Throws
// DataError for a part that the models do not have, or data that the oil lacks.
ContactModel contact_model(const ModelChoice &, const OilWords *oil, double phi_rs);

}    // namespace bearing

#endif
