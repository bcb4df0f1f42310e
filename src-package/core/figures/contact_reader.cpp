// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_reader.h"

using namespace raceway;

namespace bearing {

bool Offer::gives(const ContactColumn &c) const
{
  return (film || !c.needs_film()) && (capacitance || !c.needs_capacitance()) &&
         (surroundings || !c.needs_surroundings()) && (many_grooves || !c.of_many_grooves);
}

void select_columns(const Arguments &args, const std::string &name, const Offer &offer,
                    ContactSelection &list)
{
  if (name == "all" || name == "usual") {
    for (const ContactColumn &c : contact_columns())
      if (offer.gives(c) && (c.usual || name == "all")) list.push_back(&c);
    return;
  }
  const ContactColumn *c = find_contact_column(name);
  if (!c)
    args.fail("unknown attribute '" + name + "'; known: all, usual, " + contact_column_names());
  if (c->needs_film() && !offer.film) args.fail("attribute '" + name + "' " + needs_lubricant);
  list.push_back(c);
}

double orbit(const Vec3 &d, const Vec3 &dv, const Vec3 &axis, const RacewayPhysics &raceway)
{
  const GroovePosition g = locate(d, axis, raceway.centre_circle);
  return dot(dv, g.t) / g.r;
}

}    // namespace bearing
