// SPDX-License-Identifier: GPL-2.0-or-later
// Named bearings (command `bearing`): data to which later commands of the deck refer by name.
#ifndef BEARING_NAMED_BEARING_H
#define BEARING_NAMED_BEARING_H

#include "../core/numbers/tag.h"
#include "../deck/named_data.h"

#include <map>

namespace bearing {

struct NamedBearing {
  std::string name;
  int balls = 0, cage = 0, inner = 0, outer = 0;    // atom types
  bool has_cage = true, has_cage_ring = false;      // balls on rails, one piece, or no cage
  // Complete data in SI units as text, with clearance (m, diametral), contact_angle and four_point
  // (degrees), b_inner_raceway, b_outer_raceway (m) and b_inner_arch, b_outer_arch (words of
  // pair_coeff).
  NamedData data;

  std::vector<std::string> given;            // data given by the user, NAME=VALUE
  mutable bool in_use = false;               // used by the present box
  mutable std::map<tag_t, double> phases;    // rad, initial phase of the first ball, by cage ring

  double number_or(const std::string &key, double missing) const
  {
    return data.values.count(key) ? number(key) : missing;
  }
  const std::string &word(const std::string &key) const { return data.values.at(key); }
  double number(const std::string &key) const { return std::atof(word(key).c_str()); }
};

// Stores a bearing for this instance of the host; a bearing of the same name is replaced.
void keep_bearing(const LAMMPS_NS::LAMMPS *, const NamedBearing &);
// The bearing with this name; null if there is none.
const NamedBearing *find_bearing(const LAMMPS_NS::LAMMPS *, const std::string &name);
// The bearing with this name; if there is none, an error that lists the existing names.
const NamedBearing &bearing_of(LAMMPS_NS::LAMMPS *, const Arguments &, const std::string &name);
// The bearing whose balls or inner ring have this atom type; null if there is none.
const NamedBearing *bearing_of_type(const LAMMPS_NS::LAMMPS *, int type);
// All bearings of this instance, by name.
std::vector<const NamedBearing *> bearings_of(const LAMMPS_NS::LAMMPS *);

}    // namespace bearing

#endif
