// SPDX-License-Identifier: GPL-2.0-or-later
// The columns of contacts that a command asks for, and their values.
#ifndef BEARING_CONTACT_READER_H
#define BEARING_CONTACT_READER_H

#include "../settings/arguments.h"
#include "contact_columns.h"
#include "contact_table.h"

#include <functional>

namespace bearing {

using ContactSelection = std::vector<const ContactColumn *>;

// What a pair style and its fixes can give.
struct Offer {
  bool film, capacitance, surroundings, many_grooves;
  bool gives(const ContactColumn &) const;
};

// `name`, or `all` or `usual` columns that are offered. Error for a name that is unknown or needs a
// lubricant that is not there.
void select_columns(const Arguments &, const std::string &name, const Offer &, ContactSelection &);

// What columns need beside the contact.
struct ContactContext {
  int axis = 2;
  std::function<raceway::FilmCapacitorT<double>(const RacewayContact &)> capacitor;    // or none
  bool surroundings = false;    // it has values for surfaces that do not touch

  ContactView view(const RacewayContact &c) const
  {
    return {double(c.ball), double(c.ring),
            *c.raceway,     c.state,
            axis,           capacitor ? capacitor(c) : raceway::FilmCapacitorT<double>{}};
  }
};

// Orbital speed of a ball about a ring, rad/s, from its place and velocity relative to the ring's
// centre; the surfaces need not touch.
double orbit(const raceway::Vec3 &d, const raceway::Vec3 &dv, const raceway::Vec3 &axis,
             const raceway::RacewayPhysics &);

}    // namespace bearing

#endif
