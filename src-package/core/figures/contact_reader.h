// SPDX-License-Identifier: GPL-2.0-or-later
// The contact columns that a command requests, and their values.
#pragma once

#include "../settings/arguments.h"
#include "contact_columns.h"
#include "contact_table.h"

#include <functional>

namespace bearing {

using ContactSelection = std::vector<const ContactColumn *>;

// Data that are provided by a pair style and its fixes.
struct Offer {
  bool film, capacitance, surroundings, many_grooves;
  bool gives(const ContactColumn &) const;
};

constexpr const char *needs_lubricant =
    "needs a lubricant: use pair_style bearing with an oil, or bearing/ehd";

// Adds the column `name`, or the available columns from the set `all` or `usual`. Stops with an
// error if the name is unknown, or if the bearing is dry and the column needs a lubricant.
void select_columns(const Arguments &, const std::string &name, const Offer &, ContactSelection &);

// Input that columns need in addition to the contact.
struct ContactContext {
  int axis = 2;
  std::function<raceway::FilmCapacitorT<double>(const RacewayContact &)> capacitor;    // optional
  bool surroundings = false;    // true if surfaces that do not touch also have values

  ContactView view(const RacewayContact &c) const
  {
    return {double(c.ball), double(c.ring),
            *c.raceway,     c.state,
            axis,           capacitor ? capacitor(c) : raceway::FilmCapacitorT<double>{}};
  }
};

// Returns the speed (rad/s) at which a ball orbits about a ring, from its position and velocity
// relative to the ring's centre. It is also defined if the ball does not touch the ring.
double orbit(const raceway::Vec3 &d, const raceway::Vec3 &dv, const raceway::Vec3 &axis,
             const raceway::RacewayPhysics &);

}    // namespace bearing
