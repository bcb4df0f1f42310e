// SPDX-License-Identifier: GPL-2.0-or-later
// Bending of a flexible shaft, i.e. its modes, their loads and their state.
#include "../core/figures/fix_columns.h"
#include "../core/numbers/number_list.h"
#include "fix_bearing_shaft.h"
#include "fix_bearing_state.h"
#include "fixes.h"

using namespace LAMMPS_NS;
using bearing::text;
using raceway::BendProgram;
using raceway::Deflection;
using raceway::RingAtom;
using raceway::RingPose;
using raceway::RingProgram;
using raceway::ShaftModes;
using raceway::Vec3;

static constexpr double near_enough = 1e-6;    // m, largest distance allowed from a station

Deflection FixBearingShaft::deflection(double at) const { return {modes().station(at), bend_}; }

RingAtom FixBearingShaft::straight(const RingAtom &ring, double at) const
{
  return shaft_.of_file ? shaft_of(ring, at, deflection(at)) : shaft_of(ring, at);
}

RingAtom FixBearingShaft::seat(const RingAtom &shaft, double at, const Vec3 &origin) const
{
  return shaft_.of_file ? raceway::carried(shaft, at, origin, deflection(at))
                        : raceway::carried(shaft, at, origin);
}

void FixBearingShaft::check_station(const std::string &what, double at) const
{
  const double nearest = modes().station(at - centre()).at + centre();
  if (!(std::fabs(nearest - at) <= near_enough))
    BRG_ALL(bearing::name_of(*this) + ": " + what + " is at " + text(at) + " m, and '" +
            shaft_.file + "' has no station there; the nearest is at " + text(nearest) +
            " m; 'raceway shaft --reduced FILE --places Z ...' writes stations");
}

void FixBearingShaft::check_stations() const
{
  if (!by_another_)
    BRG_ALL(bearing::name_of(*this) + ": a flexible shaft needs fix bearing/implicit");
  check_station("the centre of mass", centre());
  for (size_t k = 0; k < places_.size(); ++k)
    check_station("ring atom " + std::to_string(tags_[k]), places_[k] + centre());
  for (const bearing::ShaftSettings::Load &l : shaft_.loads) check_station("a load", l.at);
  for (const bearing::ShaftSettings::Unbalance &u : shaft_.unbalances)
    check_station("an unbalance", u.at);
}

// Adds the modal loads of a force and a moment that act at the position `at` (m, relative to the
// shaft's centre).
void FixBearingShaft::load_modes(double at, const Vec3 &force, const Vec3 &moment)
{
  add_to_modes(modes().station(at), {0.0, 0.0, 1.0}, force, moment, now_.bending);
}

BendProgram FixBearingShaft::bend_program() const
{
  return {
      {before_.bending, now_.bending}, shaft_.unbalances_of_modes(), modes().station(0.0).moved};
}

// Returns the forces (N) on the modes at the end of the step.
std::vector<double> FixBearingShaft::forces_on_modes(const std::vector<MountedRing> &all,
                                                     const RingPose &shaft) const
{
  std::vector<double> of, loads;
  own_forces(modes(), bend_, shaft, of);
  for (const MountedRing &r : all)
    add_to_modes(modes().station(r.at), r.now.e, r.contact[0], r.contact[1], of);
  bend_program().forces(at_end(now_), 1.0, shaft.angle, loads);
  for (size_t k = 0; k < of.size(); ++k) of[k] += loads[k];
  return of;
}

// Returns the strain energy for k = 0, and the coordinates of the modes, two per mode, for larger
// k.
double FixBearingShaft::bending_value(int k) const
{
  if (k == 0) return strain_energy(modes(), bend_);
  const int mode = (k - 1) / 2, plane = (k - 1) % 2;
  return bend_.place[plane * modes().size() + mode];
}

double FixBearingShaft::compute_array(int row, int k)
{
  namespace of = bearing::of_bend;
  if (k < bearing::of_fix_ring::N) return FixBearingRing::compute_array(row, k);
  if (static_cast<size_t>(row) >= places_.size()) return 0.0;
  const Deflection d = deflection(places_[row]);
  double values[of::N];
  axes_.lab({d.moved[0], d.moved[1], 0.0}).to(values + of::X);
  values[of::TILT1] = -d.slope[1];
  values[of::TILT2] = d.slope[0];
  return values[k - bearing::of_fix_ring::N];
}

// Stores the state of the fix in the same way as fix bearing/ring does, followed by the modes.
void FixBearingShaft::write_restart(FILE *fp)
{
  bearing::NumberWriter list;
  list(time_, imposed_, bend_.place.size(), bend_.place, bend_.rate);
  if (comm->me == 0) list.write(fp);
}

void FixBearingShaft::restart(char *buf)
{
  size_t modes;
  bearing::NumberReader list(buf);
  list(time_, imposed_, modes);
  if (modes != bend_.place.size())
    BRG_ALL(bearing::name_of(*this) + ": the restart file has " + std::to_string(modes / 2) +
            " modes of the shaft, but the deck has " + std::to_string(bend_.place.size() / 2) +
            (shaft_.of_file ? "" : ", a rigid shaft"));
  list(bend_.place, bend_.rate);
}
