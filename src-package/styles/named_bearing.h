// SPDX-License-Identifier: GPL-2.0-or-later
// Named bearings (command `bearing`), i.e. data to which later commands of the deck refer by name.
#pragma once

#include "../core/numbers/tag.h"
#include "../deck/named_data.h"

#include <map>

namespace bearing {

struct NamedBearing {
  std::string name;
  int balls = 0, cage = 0, inner = 0, outer = 0;    // atom types
  bool has_cage = true, has_cage_ring = false;      // cage of balls on rails; one-piece cage; both
                                                    // false: no cage
  // Complete data as text in SI units, with clearance (m, diametral), contact_angle and four_point
  // (degrees), b_inner_raceway and b_outer_raceway (m), and b_inner_arch and b_outer_arch (words of
  // pair_coeff).
  NamedData data;

  std::vector<std::string> given;            // data given by the user as NAME=VALUE
  mutable bool in_use = false;               // true if it is used in the current box
  mutable std::map<tag_t, double> phases;    // rad, initial azimuth of the first ball for each
                                             // one-piece cage

  double number_or(const std::string &key, double missing) const
  {
    return data.values.count(key) ? number(key) : missing;
  }
  // Returns the nominal contact angle in degrees: that of the arches of a four-point bearing, or
  // that of the grooves.
  double contact_angle() const { return number("contact_angle") + number("four_point"); }
  const std::string &word(const std::string &key) const { return data.values.at(key); }
  double number(const std::string &key) const { return std::atof(word(key).c_str()); }
};

// Stores a bearing for this instance of the host. It replaces any bearing with the same name.
void keep_bearing(const LAMMPS_NS::LAMMPS *, const NamedBearing &);
// Returns the bearing with this name, or null if there is none.
const NamedBearing *find_bearing(const LAMMPS_NS::LAMMPS *, const std::string &name);
// Returns the bearing with this name. If there is none, stops with an error that lists the existing
// names.
const NamedBearing &bearing_of(LAMMPS_NS::LAMMPS *, const Arguments &, const std::string &name);
// Returns the bearing whose balls or inner ring have this atom type, or null if there is none.
const NamedBearing *bearing_of_type(const LAMMPS_NS::LAMMPS *, int type);
// Returns all bearings of this instance, sorted by name.
std::vector<const NamedBearing *> bearings_of(const LAMMPS_NS::LAMMPS *);

}    // namespace bearing
