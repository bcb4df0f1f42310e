// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_columns.h"

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
  const char *before;    // the column of the state that follows in an output; null: the end
  Needs needs = Needs::nothing;
};

const PlaceColumn place_columns[] = {
    {{"ball", "", "atom number of the ball", has_none, as_whole},
     [](C c) { return c.ball; },
     "angle"},
    {{"ring", "", "atom number of the ring", has_none, as_whole},
     [](C c) { return c.ring; },
     "angle"},
    {{"raceway", "", "0 inner, 1 outer", has_none, as_whole},
     [](C c) { return c.raceway.groove.side == Side::inner ? 0.0 : 1.0; },
     "angle"},
    {{"azimuth", "rad", "azimuth of the ball about the ring's axis, from the lab's x"},
     [](C c) { return azimuth(c.state.u, c.axis); },
     "angle"},
    {{"h_c", "m", "central film thickness"},
     [](C c) { return c.capacitor.h_c; },
     "lambda",
     Needs::capacitance},
    {{"capacitance", "F", "capacitance of the Hertz area", vanishes},
     [](C c) { return c.capacitor.capacitance; },
     nullptr,
     Needs::capacitance},
};

std::vector<ContactColumn> merged()
{
  std::vector<ContactColumn> list;
  const auto add_those_before = [&list](const char *name) {
    for (const PlaceColumn &p : place_columns)
      if (name && p.before ? strcmp(name, p.before) == 0 : name == p.before)
        list.emplace_back(p.is, p.needs, p.value);
  };
  for (const StateColumn &s : state_columns::list) {
    add_those_before(s.is.name);
    list.emplace_back(s);
  }
  add_those_before(nullptr);
  return list;
}

}    // namespace

const std::vector<ContactColumn> &contact_columns()
{
  static const std::vector<ContactColumn> list = merged();
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
