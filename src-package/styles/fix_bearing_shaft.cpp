// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_shaft.h"

#include "../core/bodies/shaft_ring.h"
#include "../core/figures/fix_columns.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using bearing::text;
using raceway::Freedom;
using raceway::RingAtom;
using raceway::RingProgram;
using raceway::Vec3;

static constexpr double exact = 1e-9;    // m and m/s, allowed initial deviation from a rigid shaft

FixBearingShaft::FixBearingShaft(LAMMPS *lmp, int narg, char **arg) :
    FixBearingRing(lmp, narg, arg, Words::unread)
{
  bearing::Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  bearing::RingWords words(args, axes_, settings_, false);
  while (args.more())
    if (!shaft_.take(args) && !words.take()) args.unknown();
  if (!shaft_.file.empty()) {
    shaft_.read_file(args, settings_.program);
    bend_.resize(modes().size());
    size_array_cols += bearing::of_bend::N;
    size_vector += 1 + 2 * modes().size();
  }
  words.finish({});
  for (const bearing::ShaftSettings::Unbalance &u : shaft_.unbalances)
    if (u.of.moment > 0.0 && settings_.program.mode[RingProgram::SPIN] != Freedom::speed)
      args.fail("unbalance needs 'spin speed W': the eccentric mass turns with an imposed spin");
  settings_are_read();
}

void FixBearingShaft::init()
{
  FixBearingRing::init();
  for (bearing::ShaftSettings::Load &load : shaft_.loads)
    for (bearing::DrivenValue &f : load.force) f.check(lmp, bearing::name_of(*this));
  check_axis();
  if (!by_another_) check_gravity();
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const MountedRing &r : rings()) {
    least = std::min(least, r.now.origin.z);
    most = std::max(most, r.now.origin.z);
  }
  middle_ = 0.5 * (least + most);
  places_.clear();
  for (const MountedRing &r : rings()) places_.push_back(r.at);
  if (bending()) check_stations();
  shaft_.add_unbalances(centre(), settings_.program);
}

double FixBearingShaft::centre() const { return shaft_.centre_given ? shaft_.centre : middle_; }

double FixBearingShaft::place_on_shaft(int i) const
{
  return axes_.third(state_->ring(i).origin).z - centre();
}

double FixBearingShaft::mass_of_atom() const
{
  return settings_.program.mass / static_cast<double>(tags_.size());
}

// Stops with an error unless the rings initially have a common axis that is parallel to the axis of
// the bearings.
void FixBearingShaft::check_axis() const
{
  const std::vector<MountedRing> all = rings();
  for (const MountedRing &r : all) {
    const Vec3 d = r.now.origin - all.front().now.origin;
    const double off = std::hypot(d.x, d.y);
    if (off > exact)
      BRG_ALL(bearing::name_of(*this) + ": ring atom " + std::to_string(r.tag) + " is " +
              text(off) + " m off the axis of ring atom " + std::to_string(all.front().tag));
  }
}

// Stops with an error unless the positions and velocities of the rings match those of a rigid body
// at the start of a run.
void FixBearingShaft::check_places() const
{
  const std::vector<MountedRing> all = rings();
  const RingAtom shaft = straight(all.front().now, all.front().at);
  const std::string first = std::to_string(all.front().tag);
  for (const MountedRing &r : all) {
    const RingAtom seat = this->seat(shaft, r.at, r.now.origin);
    const std::string who = bearing::name_of(*this) + ": ring atom " + std::to_string(r.tag);
    const double off = norm(r.now.x - seat.x), fast = norm(r.now.v - seat.v),
                 turned = norm(r.now.e - seat.e), spun = norm(r.now.w - seat.w);
    if (off > exact)
      BRG_ALL(who + " is " + text(off) + " m off its position on the shaft of ring atom " + first);
    if (turned > exact)
      BRG_ALL(who + " is tilted " + text(turned) + " rad relative to ring atom " + first);
    if (fast > exact + 1e-9 * norm(seat.v))
      BRG_ALL(who + " is " + text(fast) + " m/s faster than the shaft of ring atom " + first);
    if (spun > 1e-9 * (1.0 + norm(seat.w)))
      BRG_ALL(who + " turns " + text(spun) + " rad/s faster than ring atom " + first);
  }
}

// Stops with an error if there is a fix gravity, because its force would act at the rings, whereas
// the centre of mass of the shaft may be elsewhere.
void FixBearingShaft::check_gravity() const
{
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix &f = *modify->fix[k];
    if (strcmp(f.style, "gravity") != 0) continue;
    for (int i = 0; i < atom->nlocal; ++i)
      if (moves(i) && (atom->mask[i] & f.groupbit))
        BRG_ONE(bearing::name_of(*this) + ": fix " + f.id +
                " (gravity) pulls its rings. Without fix bearing/implicit, specify the weight with "
                "'load Z FX FY FZ' at the centre of mass");
  }
}

void FixBearingShaft::setup(int vflag)
{
  FixBearingRing::setup(vflag);
  check_places();
}

// Converts loads that act along the shaft to loads at its centre.
void FixBearingShaft::evaluate(int first, int last)
{
  FixBearingRing::evaluate(first, last);
  if (last <= RingProgram::FORCE) return;
  now_.bending.assign(bend_.place.size(), 0.0);
  if (bending())
    load_modes(0.0, Vec3::from(now_.of + RingProgram::FORCE),
               Vec3::from(now_.of + RingProgram::MOMENT));
  now_.leverage = Vec3();
  for (const bearing::ShaftSettings::Load &load : shaft_.loads) {
    Vec3 lab;
    lab.x = load.force[0].now(lmp);
    lab.y = load.force[1].now(lmp);
    lab.z = load.force[2].now(lmp);
    const Vec3 force = axes_.third(lab);
    warn_if_idle(2, force.z, "load");    // a radial load also tilts the shaft
    now_.leverage += force * (load.at - centre());
    if (bending()) load_modes(load.at - centre(), force, Vec3());
    double all[3];
    (Vec3::from(now_.of + RingProgram::FORCE) + force).to(all);
    std::copy(all, all + 3, now_.of + RingProgram::FORCE);
  }
}
