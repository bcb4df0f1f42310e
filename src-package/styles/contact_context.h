// SPDX-License-Identifier: GPL-2.0-or-later
// What contact columns need beside the contact, from the pair style and the fixes of a run.
#ifndef BEARING_CONTACT_CONTEXT_H
#define BEARING_CONTACT_CONTEXT_H

#include "../core/figures/contact_reader.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {
class PairBearingHertz;
}

namespace bearing {

// What the commands so far give: the film of the pair style, the capacitance of a fix.
Offer offer_of(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &);

// Capacitor of a contact by the fix bearing/capacitance with its ball in the group, else 0; without
// contact what surrounds it, if the fix gives that. Error
// naming `asked_by` and what it wants if there is no such fix.
std::function<raceway::FilmCapacitorT<double>(const RacewayContact &)>
capacitor_of(LAMMPS_NS::LAMMPS *, const std::string &asked_by, const std::string &wants);

// Error naming `asked_by` and what it wants if no fix bearing/capacitance gives surroundings.
void check_surroundings(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &,
                        const std::string &asked_by, const std::string &wants);

// For these columns; error naming `asked_by` where a fix they need is missing.
ContactContext context_of(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &,
                          const ContactSelection &, const std::string &asked_by);

// Orbital speed of a ball about the ring of a contact, rad/s; the surfaces need not touch.
double orbit_of(const LAMMPS_NS::Atom &, const LAMMPS_NS::PairBearingHertz &,
                const RacewayContact &);

}    // namespace bearing

#endif
