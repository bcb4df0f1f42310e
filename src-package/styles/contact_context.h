// SPDX-License-Identifier: GPL-2.0-or-later
// Input of contact columns in addition to the contact, from the pair style and the fixes of a run.
#ifndef BEARING_CONTACT_CONTEXT_H
#define BEARING_CONTACT_CONTEXT_H

#include "../core/figures/contact_reader.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {
class PairBearingHertz;
}

namespace bearing {

// Data available from the commands so far: the film of the pair style, the capacitance of a fix.
Offer offer_of(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &);

// Capacitor of a contact from the fix bearing/capacitance whose group has its ball, 0 if none;
// without contact the capacitance of the surroundings, if the fix computes it. Without such a fix:
// error naming `asked_by` and `wants`.
std::function<raceway::FilmCapacitorT<double>(const RacewayContact &)>
capacitor_of(LAMMPS_NS::LAMMPS *, const std::string &asked_by, const std::string &wants);

// Error naming `asked_by` and `wants` if no fix bearing/capacitance computes surroundings.
void check_surroundings(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &,
                        const std::string &asked_by, const std::string &wants);

// Context for these columns; error naming `asked_by` if a fix that they need is missing.
ContactContext context_of(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &,
                          const ContactSelection &, const std::string &asked_by);

// Orbital speed of a ball about the ring of a contact, rad/s; the surfaces need not touch.
double orbit_of(const LAMMPS_NS::Atom &, const LAMMPS_NS::PairBearingHertz &,
                const RacewayContact &);

}    // namespace bearing

#endif
