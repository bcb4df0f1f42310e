// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_attribute.h"

#include "../styles/fix_bearing_capacitance.h"
#include "../styles/fix_bearing_state.h"
#include "../styles/pair_bearing_hertz.h"

using namespace LAMMPS_NS;
using namespace raceway;

namespace bearing {

double azimuth(const Vec3 &u, int axis)
{
  const double c[3] = {u.x, u.y, u.z};
  return std::atan2(c[(axis + 2) % 3], c[(axis + 1) % 3]);
}

double orbit(const Atom &atom, const PairBearingHertz &pair, const RacewayContact &c)
{
  const Vec3 d = Vec3::from(atom.x[c.i_ball]) - Vec3::from(atom.x[c.i_ring]);
  const GroovePosition g = locate(d, pair.state()->axis(c.i_ring), c.raceway->centre_circle);
  return dot(Vec3::from(atom.v[c.i_ball]) - Vec3::from(atom.v[c.i_ring]), g.t) / g.r;
}

using Row = const RacewayContact &;
using Context = const AttributeContext &;

static const ContactAttribute attributes[] = {
    {"ball", [](Row c, Context) { return double(c.ball); }, false, false},
    {"ring", [](Row c, Context) { return double(c.ring); }, false, false},
    {"raceway", [](Row c, Context) { return c.side() == Side::inner ? 0.0 : 1.0; }, false, false},
    {"azimuth", [](Row c, Context x) { return azimuth(c.state.u, x.axis); }, false, false},
    // positive on both raceways where the inner ring is pushed along +axis
    {"angle",
     [](Row c, Context) {
       return std::atan2(c.side() == Side::inner ? -c.state.ne : c.state.ne, std::fabs(c.state.nu));
     },
     false, false},
    {"overlap", [](Row c, Context) { return c.state.overlap; }, false, false},
    {"load", [](Row c, Context) { return c.state.load; }, false, false},
    {"normal", [](Row c, Context) { return c.state.normal; }, false, false},
    {"stiffness", [](Row c, Context) { return c.state.stiffness; }, false, false},
    {"damping", [](Row c, Context) { return c.state.damping; }, false, false},
    {"a", [](Row c, Context) { return c.raceway->law.at(c.state.cos_angle).a * c.state.root; },
     false, false},
    {"b", [](Row c, Context) { return c.raceway->law.at(c.state.cos_angle).b * c.state.root; },
     false, false},
    {"pressure",
     [](Row c, Context) { return c.raceway->law.at(c.state.cos_angle).p * c.state.root; }, false,
     false},
    {"entrainment", [](Row c, Context) { return c.state.entrainment; }, false, false},
    {"sliding", [](Row c, Context) { return std::hypot(c.state.sliding_t, c.state.sliding_w); },
     false, false},
    {"h_min", [](Row c, Context) { return c.state.h_min; }, true, false},
    {"h_c", [](Row c, Context x) { return x.capacitor(c).h_c; }, true, true},
    {"lambda", [](Row c, Context) { return c.state.lambda; }, true, false},
    {"regime",
     [](Row c, Context) {
       return double(regime({0.0, 0.0, c.raceway->lambda_1, c.raceway->lambda_2}, c.state.lambda));
     },
     true, false},
    {"mu", [](Row c, Context) { return c.state.mu; }, false, false},
    {"friction", [](Row c, Context) { return std::hypot(c.state.friction_t, c.state.friction_w); },
     false, false},
    {"friction_t", [](Row c, Context) { return c.state.friction_t; }, false, false},
    {"friction_w", [](Row c, Context) { return c.state.friction_w; }, false, false},
    {"friction_power", [](Row c, Context) { return bearing::friction_power(c.state); }, false,
     false},
    {"damping_power", [](Row c, Context) { return bearing::damping_power(c.state); }, false, false},
    {"capacitance", [](Row c, Context x) { return x.capacitor(c).capacitance; }, true, true},
};

raceway::FilmCapacitorT<double> AttributeContext::capacitor(const RacewayContact &c) const
{
  for (const FixBearingCapacitance *f : capacitance)
    if (f->covers(c.i_ball)) return f->capacitor(c);
  return {};
}

std::vector<const FixBearingCapacitance *> capacitance_fixes(LAMMPS *lmp)
{
  std::vector<const FixBearingCapacitance *> list;
  for (int m = 0; m < lmp->modify->nfix; ++m)
    if (auto *f = dynamic_cast<FixBearingCapacitance *>(lmp->modify->fix[m])) list.push_back(f);
  return list;
}

const ContactAttribute *find_attribute(const std::string &name)
{
  for (const ContactAttribute &a : attributes)
    if (name == a.name) return &a;
  return nullptr;
}

std::string attribute_names()
{
  std::string s;
  for (const ContactAttribute &a : attributes) s += (s.empty() ? "" : ", ") + std::string(a.name);
  return s;
}

std::vector<const ContactAttribute *> read_attributes(Arguments &args, const PairBearingHertz &pair)
{
  std::vector<const ContactAttribute *> list;
  do {
    const std::string name = args.word("a contact attribute");
    const ContactAttribute *a = find_attribute(name);
    if (!a) args.fail("unknown attribute '" + name + "'; known: " + attribute_names());
    if (a->film && !pair.lubricated())
      args.fail("attribute '" + name + "' needs a lubricant: use pair_style bearing/ehd");
    list.push_back(a);
  } while (args.more());
  return list;
}

AttributeContext attribute_context(LAMMPS *lmp, const PairBearingHertz &pair,
                                   const std::vector<const ContactAttribute *> &list,
                                   const std::string &asked_by)
{
  AttributeContext context;
  context.axis = pair.axis_index();
  context.capacitance = capacitance_fixes(lmp);
  for (const ContactAttribute *a : list)
    if (a->capacitance && context.capacitance.empty())
      BRG_ALL_OF(lmp, asked_by + ": attribute '" + a->name + "' needs a fix bearing/capacitance");
  return context;
}

}    // namespace bearing
