// SPDX-License-Identifier: GPL-2.0-or-later
// The contact columns requested by a command, and their values.
#ifndef BEARING_CONTACT_READER_H
#define BEARING_CONTACT_READER_H

#include "../settings/arguments.h"
#include "contact_columns.h"
#include "contact_table.h"

#include <functional>

namespace bearing {

using ContactSelection = std::vector<const ContactColumn *>;

// Data available from a pair style and its fixes.
struct Offer {
  bool film, capacitance, surroundings, many_grooves;
  bool gives(const ContactColumn &) const;
};

// Adds the column `name`, or the available columns of `all` or `usual`. Error for an unknown name,
// or in a dry bearing for a column that needs a lubricant.
void select_columns(const Arguments &, const std::string &name, const Offer &, ContactSelection &);

// Input for the columns in addition to the contact.
struct ContactContext {
  int axis = 2;
  std::function<raceway::FilmCapacitorT<double>(const RacewayContact &)> capacitor;    // or none
  bool surroundings = false;    // surfaces without contact have values, too

  ContactView view(const RacewayContact &c) const
  {
    return {double(c.ball), double(c.ring),
            *c.raceway,     c.state,
            axis,           capacitor ? capacitor(c) : raceway::FilmCapacitorT<double>{}};
  }
};

// Orbital speed of a ball about a ring, rad/s, from its position and velocity relative to the
// ring's centre, also without contact.
double orbit(const raceway::Vec3 &d, const raceway::Vec3 &dv, const raceway::Vec3 &axis,
             const raceway::RacewayPhysics &);

}    // namespace bearing

#endif
