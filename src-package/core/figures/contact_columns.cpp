// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_columns.h"

#include "../contact/part_table.h"

#include <algorithm>
#include <cstring>

using namespace raceway;

namespace bearing {

double azimuth(const Vec3 &u, int axis)
{
  const double c[3] = {u.x, u.y, u.z};
  return std::atan2(c[(axis + 2) % 3], c[(axis + 1) % 3]);
}

namespace {

using C = const ContactView &;

struct PlaceColumn {
  Column is;
  double (*value)(C);
  Needs needs = Needs::nothing;
  bool names_it = false, of_many_grooves = false;
};

const PlaceColumn place_columns[] = {
    {{"ball", "", "atom number of the ball", has_none, as_whole},
     [](C c) { return c.ball; },
     Needs::nothing,
     true},
    {{"ring", "", "atom number of the ring", has_none, as_whole},
     [](C c) { return c.ring; },
     Needs::nothing,
     true},
    {{"raceway", "", "0 inner, 1 outer", has_none, as_whole},
     [](C c) { return c.raceway.groove.side == Side::inner ? 0.0 : 1.0; },
     Needs::nothing,
     true},
    {{"groove", "", "0, or 1 for the second of two grooves along the axis", has_none, as_whole},
     [](C c) { return double(c.raceway.number); },
     Needs::nothing,
     true,
     true},
    {{"azimuth", "rad", "azimuth of the ball about the ring's axis, measured from the lab x axis"},
     [](C c) { return azimuth(c.state.u, c.axis); }},
    {{"h_c", "m", "central film thickness"},
     [](C c) { return c.capacitor.h_c; },
     Needs::capacitance},
    {{"capacitance", "F", "capacitance of the contact ellipse", vanishes},
     [](C c) { return c.capacitor.capacitance; },
     Needs::capacitance},
    {{"separation", "m", "distance between the surfaces (also defined when there is no contact)"},
     [](C c) { return c.capacitor.separation; },
     Needs::surroundings},
    {{"capacitance_outside", "F",
      "capacitance outside the contact ellipse (also defined when there is no contact)"},
     [](C c) { return c.capacitor.outside; },
     Needs::surroundings},
    {{"capacitance_total", "F",
      "capacitance between ball and raceway (also defined when there is no contact)"},
     [](C c) { return c.capacitor.total(); },
     Needs::surroundings},
};

// Outputs keep the column order used in versions in which parts did not define columns. All other
// columns follow in the order of the parts.
const char *const first[] = {
    "ball",       "ring",           "raceway",       "azimuth", "angle",    "overlap",
    "load",       "normal",         "stiffness",     "damping", "a",        "b",
    "pressure",   "entrainment",    "sliding",       "mu",      "friction", "friction_t",
    "friction_w", "friction_power", "damping_power", "h_min",   "h_c",      "lambda",
    "regime",     "capacitance"};

std::vector<ContactColumn> in_order()
{
  std::vector<ContactColumn> all;
  const auto add =
      [&all](const ContactColumn &c) {    // parts that exclude each other share columns
        for (const ContactColumn &known : all)
          if (strcmp(known.is.name, c.is.name) == 0) return;
        all.push_back(c);
      };
  for (const PlaceColumn &p : place_columns)
    add(ContactColumn(p.is, p.needs, p.value, p.names_it, p.of_many_grooves));
  for (const StateColumn &s : motion_columns()) add(ContactColumn(s));
  for (const PartEntry &part : part_table())
    for (const StateColumn &s : part.columns) add(ContactColumn(s));
  const auto rank = [](const ContactColumn &c) {
    return std::find_if(std::begin(first), std::end(first),
                        [&c](const char *name) { return strcmp(name, c.is.name) == 0; }) -
           std::begin(first);
  };
  std::stable_sort(all.begin(), all.end(), [&rank](const ContactColumn &a, const ContactColumn &b) {
    return rank(a) < rank(b);
  });
  return all;
}

}    // namespace

const std::vector<ContactColumn> &contact_columns()
{
  static const std::vector<ContactColumn> list = in_order();
  return list;
}

const ContactColumn *find_contact_column(const std::string &name)
{
  for (const ContactColumn &c : contact_columns())
    if (name == c.is.name) return &c;
  return nullptr;
}

std::string contact_column_names()
{
  std::string s;
  for (const ContactColumn &c : contact_columns())
    s += (s.empty() ? "" : ", ") + std::string(c.is.name);
  return s;
}

}    // namespace bearing
