// SPDX-License-Identifier: GPL-2.0-or-later
// Output of fix bearing/ring: the values f_ID[k] and f_ID[row][k].
#include "../contacts/ring_motion.h"
#include "../core/figures/fix_columns.h"
#include "fix_bearing_ring.h"
#include "fix_bearing_state.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::RingProgram;
using raceway::Vec3;

// Collects the values of all rings. Each ring is owned by exactly one rank, so it is sufficient to
// sum over the ranks.
void FixBearingRing::make_report()
{
  report_.assign(tags_.size() * bearing::of_fix_ring::N, 0.0);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i)) continue;
    const auto known = std::lower_bound(tags_.begin(), tags_.end(), atom->tag[i]);
    if (known == tags_.end() || *known != atom->tag[i])
      continue;    // a ring that has joined the group since the last run is added in the next run
    using namespace bearing::of_fix_ring;
    double *r = &report_[(known - tags_.begin()) * N];
    const bearing::RingMotion &ring = state_->ring(i);
    const Vec3 w = Vec3::from(atom->omega[i]);
    (Vec3::from(atom->x[i]) - ring.origin).to(r + X);
    Vec3::from(atom->v[i]).to(r + VX);
    raceway::tilt_of(axes_.third(ring.axis), r + TILT1);
    r[SPIN] = dot(w, ring.axis);
    r[ANGLE] = ring.angle;
    report_loads(i, r);
    ring.acceleration.to(r + AX);
    const auto contact =
        std::lower_bound(contacts_.begin(), contacts_.end(), atom->tag[i],
                         [](const ContactLoad &c, bearing::tag_t tag) { return c.ring < tag; });
    if (contact == contacts_.end() || contact->ring != atom->tag[i]) continue;    // no load yet
    contact->force.to(r + FX);
    contact->moment.to(r + MX);
    r[TORQUE] = dot(contact->moment, ring.axis);
  }
  MPI_Allreduce(MPI_IN_PLACE, report_.data(), static_cast<int>(report_.size()), MPI_DOUBLE, MPI_SUM,
                world);
}

void FixBearingRing::report_loads(int i, double *row) const
{
  using namespace bearing::of_fix_ring;
  const RingProgram p = at_end(i);
  axes_.lab(load_of(p, i)).to(row + LOAD_X);
  Vec3 support;
  if (p.supported && holder_ == 0) support = p.support_force(read(i));
  if (const auto on = between_.find(atom->tag[i]); on != between_.end()) support += on->second;
  axes_.lab(support).to(row + SUPPORT_X);
}

double FixBearingRing::compute_vector(int k) { return reported(0, k); }

double FixBearingRing::compute_array(int row, int k)
{
  // the rows of rings that have joined the group appear in the next run
  return static_cast<size_t>(row) < tags_.size() ? reported(row, k) : 0.0;
}

double FixBearingRing::reported(int row, int k)
{
  if (!state_) return 0.0;    // there is no output before the first run
  if (reported_ != update->ntimestep) {
    note_setup();
    make_report();
  }
  reported_ = update->ntimestep;
  return report_[row * bearing::of_fix_ring::N + k];
}

FixBearingRing::Balance FixBearingRing::balance()
{
  using namespace bearing::of_fix_ring;
  const auto along_free = [this](int first) {
    const Vec3 all =
        axes_.third({reported(0, first), reported(0, first + 1), reported(0, first + 2)});
    const auto free = [this](int k) { return settings_.program.free(k) ? 1.0 : 0.0; };
    return Vec3{free(0) * all.x, free(1) * all.y, free(2) * all.z};
  };
  const Vec3 load = along_free(LOAD_X);
  return {load, load + along_free(FX)};
}

std::vector<bearing::ColumnList::Item> FixBearingRing::columns() const
{
  // the motion of the ring and the forces on it are listed; the load is known from the deck
  std::vector<Item> list;
  for (int k = 0; k < bearing::of_fix_ring::LOAD_X; ++k)
    list.push_back({bearing::of_fix_ring::list[k].name, bearing::of_fix_ring::list[k].format});
  return list;
}
