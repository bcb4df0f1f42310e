// SPDX-License-Identifier: GPL-2.0-or-later
#include "shaft_lift.h"

#include "bearing_bodies.h"

#include <algorithm>

namespace raceway {

void ShaftLift::find(const BearingBodies &all)
{
  entries_.clear();
  coupled_ = &all.columns_of_column;
  for (int k = 0; k < all.straight; ++k) entries_.push_back({k, k, 1.0});
  for (const ShaftBend &b : all.bends) {
    const RingBody &shaft = all.rings[b.shaft];
    const Vec3 &e = shaft.now.e;
    const int n = b.modes->size(), tilt = RingProgram::TILT;
    for (const ShaftBend::Seat &seat : b.seats) {
      const auto add = [&](int dof, int unknown, double factor) {
        if (unknown >= 0) entries_.push_back({seat.column + dof, unknown, factor});
      };
      for (int dof = 0; dof < RingProgram::N_DOF; ++dof) add(dof, shaft.coordinate[dof], 1.0);
      // axial velocity, due to tilts of the shaft, of a point that is not at the shaft's centre
      add(0, shaft.coordinate[tilt + 1], seat.at * e.z);
      add(1, shaft.coordinate[tilt], -seat.at * e.z);
      add(2, shaft.coordinate[tilt], seat.at * e.y);
      add(2, shaft.coordinate[tilt + 1], -seat.at * e.x);
      for (int k = 0; k < n; ++k) {
        add(0, b.mode + k, seat.station->moved[k]);
        add(tilt + 1, b.mode + k, seat.station->tilted[k]);
        add(1, b.mode + n + k, seat.station->moved[k]);
        add(tilt, b.mode + n + k, -seat.station->tilted[k]);
      }
    }
  }
}

void ShaftLift::add_matrix(const std::vector<double> &columns, std::vector<double> &unknowns)
{
  const size_t c = static_cast<size_t>(std::lround(std::sqrt(double(columns.size())))),
               n = static_cast<size_t>(std::lround(std::sqrt(double(unknowns.size()))));
  half_.assign(c * n, 0.0);
  for (const Entry &t : entries_)
    for (int row : (*coupled_)[t.column])
      half_[row * n + t.unknown] += columns[row * c + t.column] * t.factor;
  for (const Entry &t : entries_)
    for (size_t k = 0; k < n; ++k)
      unknowns[t.unknown * n + k] += t.factor * half_[t.column * n + k];
}

void ShaftLift::add_forces(const std::vector<double> &columns, std::vector<double> &unknowns) const
{
  for (const Entry &t : entries_) unknowns[t.unknown] += t.factor * columns[t.column];
}

void ShaftLift::find_motions(const std::vector<double> &unknowns,
                             std::vector<double> &columns) const
{
  std::fill(columns.begin(), columns.end(), 0.0);
  for (const Entry &t : entries_) columns[t.column] += t.factor * unknowns[t.unknown];
}

}    // namespace raceway
