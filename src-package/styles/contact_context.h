// SPDX-License-Identifier: GPL-2.0-or-later
// Provides the data that contact columns need in addition to the contact itself. They come from the
// pair style and the fixes of a run.
#pragma once

#include "../core/figures/contact_reader.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {
class PairBearingHertz;
}

namespace bearing {

// Returns the data that are available from the commands read so far: the film of the pair style and
// the capacitances of a fix.
Offer offer_of(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &);

// Returns a function that computes the capacitor of a contact according to the fix
// bearing/capacitance whose group contains the ball; the result is 0 if no group does. For an open
// contact, it is the capacitance of the surroundings if that fix computes it. Stops with an error
// that names `asked_by` and `wants` if there is no such fix.
std::function<raceway::FilmCapacitorT<double>(const RacewayContact &)>
capacitor_of(LAMMPS_NS::LAMMPS *, const std::string &asked_by, const std::string &wants);

// Stops with an error that names `asked_by` and `wants` if no fix bearing/capacitance computes
// surroundings.
void check_surroundings(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &,
                        const std::string &asked_by, const std::string &wants);

// Returns the context for the given columns. Stops with an error that names `asked_by` if a fix
// that the columns require is missing.
ContactContext context_of(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &,
                          const ContactSelection &, const std::string &asked_by);

// Gives ghosts the velocities that their owners have now; those received in a step of velocity
// Verlet are half a step old. Must be called on all ranks, before orbit_of.
void send_velocities(LAMMPS_NS::LAMMPS *);

// Returns the speed (rad/s) at which a ball orbits about the ring of a contact; the surfaces do not
// have to touch.
double orbit_of(const LAMMPS_NS::Atom &, const LAMMPS_NS::PairBearingHertz &,
                const RacewayContact &);

}    // namespace bearing
