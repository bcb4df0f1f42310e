// SPDX-License-Identifier: GPL-2.0-or-later
// Names and values of what can be read from a contact: one list for all computes.
#ifndef BEARING_CONTACT_ATTRIBUTE_H
#define BEARING_CONTACT_ATTRIBUTE_H

#include "../deck/arguments.h"
#include "../physics/capacitance.h"
#include "contact_table.h"

namespace LAMMPS_NS {
class FixBearingCapacitance;
class PairBearingHertz;
}

namespace bearing {

// What an attribute may need besides the contact.
struct AttributeContext {
  int axis = 2;    // of the bearing: 0 x, 1 y, 2 z
  std::vector<const LAMMPS_NS::FixBearingCapacitance *> capacitance;    // empty: not asked for
  raceway::FilmCapacitorT<double>
  capacitor(const RacewayContact &) const;    // by the fix with its ball in the group, else 0
};

// Every fix bearing/capacitance; each has a permittivity for the balls of its group.
std::vector<const LAMMPS_NS::FixBearingCapacitance *> capacitance_fixes(LAMMPS_NS::LAMMPS *);

struct ContactAttribute {
  const char *name;
  double (*value)(const RacewayContact &, const AttributeContext &);
  bool film;           // needs bearing/ehd
  bool capacitance;    // needs fix bearing/capacitance
};

// The attribute of that name, or null.
const ContactAttribute *find_attribute(const std::string &name);
std::string attribute_names();

// Reads attribute names to the end of the command; checks that the pair style can give them.
std::vector<const ContactAttribute *> read_attributes(Arguments &,
                                                      const LAMMPS_NS::PairBearingHertz &);

// Finds the fix bearing/capacitance if one of the attributes needs it; error naming `asked_by` if
// missing.
AttributeContext attribute_context(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &,
                                   const std::vector<const ContactAttribute *> &,
                                   const std::string &asked_by);

// Orbital speed of a ball about the ring of a contact, rad/s; the surfaces need not touch.
double orbit(const LAMMPS_NS::Atom &, const LAMMPS_NS::PairBearingHertz &, const RacewayContact &);

// Azimuth of a direction about the bearing axis, rad in (-pi, pi], from the next lab axis (x for
// axis z).
double azimuth(const raceway::Vec3 &u, int axis);

// Power lost in a contact, W: what its springs store on the way counts as lost until they give it
// back.
inline double friction_power(const raceway::ContactState &s)
{
  return s.friction_t * s.sliding_t + s.friction_w * s.sliding_w;
}
inline double damping_power(const raceway::ContactState &s)
{
  return (s.normal - s.load) * s.overlap_rate;
}

}    // namespace bearing

#endif
