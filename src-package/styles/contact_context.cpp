// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_context.h"

#include "fix_bearing_capacitance.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace bearing {

Offer offer_of(LAMMPS *lmp, const PairBearingHertz &pair)
{
  const std::vector<FixBearingCapacitance *> fixes = capacitances_of(lmp);
  return {pair.coefficients().lubricated(), !fixes.empty(),
          std::any_of(fixes.begin(), fixes.end(),
                      [](const FixBearingCapacitance *f) { return f->model().surrounded(); }),
          pair.coefficients().many_grooves()};
}

std::function<raceway::FilmCapacitorT<double>(const RacewayContact &)>
capacitor_of(LAMMPS *lmp, const std::string &asked_by, const std::string &wants)
{
  const std::vector<FixBearingCapacitance *> fixes = capacitances_of(lmp);
  if (fixes.empty()) BRG_ALL_OF(lmp, asked_by + ": " + wants + " needs a fix bearing/capacitance");
  return [fixes](const RacewayContact &c) -> raceway::FilmCapacitorT<double> {
    for (FixBearingCapacitance *f : fixes)
      if (f->covers(c.i_ball)) return f->capacitor(c);
    return {};
  };
}

void check_surroundings(LAMMPS *lmp, const PairBearingHertz &pair, const std::string &asked_by,
                        const std::string &wants)
{
  if (!offer_of(lmp, pair).surroundings)
    BRG_ALL_OF(lmp,
               asked_by + ": " + wants + " needs a fix bearing/capacitance with 'surroundings'");
}

ContactContext context_of(LAMMPS *lmp, const PairBearingHertz &pair, const ContactSelection &list,
                          const std::string &asked_by)
{
  ContactContext context;
  context.axis = pair.coefficients().axis_index();
  for (const ContactColumn *c : list) {
    const std::string wants = "attribute '" + std::string(c->is.name) + "'";
    if (c->needs_capacitance() && !context.capacitor)
      context.capacitor = capacitor_of(lmp, asked_by, wants);
    if (c->needs_surroundings()) check_surroundings(lmp, pair, asked_by, wants);
  }
  return context;
}

void send_velocities(LAMMPS *lmp)
{
  if (lmp->comm->nprocs > 1) lmp->comm->forward_comm();
}

double orbit_of(const Atom &atom, const PairBearingHertz &pair, const RacewayContact &c)
{
  using raceway::Vec3;
  return orbit(Vec3::from(atom.x[c.i_ball]) - Vec3::from(atom.x[c.i_ring]),
               Vec3::from(atom.v[c.i_ball]) - Vec3::from(atom.v[c.i_ring]),
               pair.state()->axis(c.i_ring), *c.raceway);
}

}    // namespace bearing
