// SPDX-License-Identifier: GPL-2.0-or-later
// All columns of a contact: columns for its motions, columns defined by the parts of the law, and
// columns that need more than the contact's state (ContactView). This file does not depend on the
// host.
#pragma once

#include "../electric/film_capacitor.h"
#include "../parts/motion_columns.h"

#include <string>
#include <vector>

namespace bearing {

// A contact as it is passed to a column.
struct ContactView {
  double ball, ring;    // atom numbers
  const raceway::RacewayPhysics &raceway;
  const raceway::ContactState &state;
  int axis;                                     // axis of the bearing: 0 for x, 1 for y, 2 for z
  raceway::FilmCapacitorT<double> capacitor;    // 0 if no column uses it
};

// Returns the azimuth (rad) of a direction about the bearing axis, in (-pi, pi], measured from the
// axis of the lab frame that follows the bearing axis in cyclic order (x for axis z).
double azimuth(const raceway::Vec3 &u, int axis);

class ContactColumn {
 public:
  using OfView = double (*)(const ContactView &);

  explicit ContactColumn(const raceway::StateColumn &c) :
      is(c.is), needs(c.needs), usual(c.usual), of_state_(c.value)
  {
  }
  ContactColumn(const raceway::Column &c, raceway::Needs what, OfView value, bool name,
                bool grooves) :
      is(c), needs(what), usual(true), names_it(name), of_many_grooves(grooves), of_view_(value)
  {
  }
  double value(const ContactView &c) const
  {
    return of_view_ ? of_view_(c) : of_state_(c.raceway, c.state);
  }
  bool needs_film() const { return needs != raceway::Needs::nothing; }
  bool needs_capacitance() const { return needs >= raceway::Needs::capacitance; }
  // Returns true if the column also has a value for surfaces that do not touch.
  bool needs_surroundings() const { return needs == raceway::Needs::surroundings; }

  raceway::Column is;
  raceway::Needs needs;
  bool usual;                      // whether records include it by default
  bool names_it = false;           // identifies the contact, so it is the same in all samples
  bool of_many_grooves = false;    // not part of `all` if every ring has only one groove

 private:
  raceway::StateValue of_state_;
  OfView of_view_ = nullptr;    // used instead of of_state_ if it is not null
};

const std::vector<ContactColumn> &contact_columns();                  // in the order of all outputs
const ContactColumn *find_contact_column(const std::string &name);    // null if there is none
std::string contact_column_names();

}    // namespace bearing
