// SPDX-License-Identifier: GPL-2.0-or-later
// Input of contact columns besides the contact itself, from the pair style and the fixes of a run.
#ifndef BEARING_CONTACT_CONTEXT_H
#define BEARING_CONTACT_CONTEXT_H

#include "../core/figures/contact_reader.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {
class PairBearingHertz;
}

namespace bearing {

// Data available from the commands so far: the pair style's film, and a fix's capacitances.
Offer offer_of(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &);

// Capacitor of a contact, from the fix bearing/capacitance whose group contains the ball; 0 if no
// group does. An open contact has the capacitance of its surroundings if that fix computes it.
// Error naming `asked_by` and `wants` if there is no such fix.
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
