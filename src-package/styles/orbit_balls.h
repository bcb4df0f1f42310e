// SPDX-License-Identifier: GPL-2.0-or-later
// The balls of all bearings, arranged by slots, as used by `settle orbit`. All rows have the same
// number of balls, each of which is between an inner and an outer ring, and, around their rings, as
// many slots. In each ball pass, every ball moves to the next slot of its row.
#pragma once

#include "../core/numbers/lab_axes.h"
#include "../core/numbers/vec3.h"
#include "bearing_compat.h"

#include <vector>

namespace bearing {

class OrbitBalls {
 public:
  // Number of values per slot: azimuth of its ball (rad), orbital speed (rad/s), and the ball's
  // spin (rad/s) in the radial, tangential and axial directions at the position of the ball.
  static constexpr int numbers = 5;

  // Reads the current state of the balls. Must be called on all ranks; the result is the same on
  // each of them.
  explicit OrbitBalls(LAMMPS_NS::LAMMPS *);

  int size() const { return static_cast<int>(balls_.size()); }
  int balls_a_row() const { return size() / rows_; }
  double spacing() const { return 2.0 * M_PI / balls_a_row(); }    // rad
  // Returns the direction in which the balls orbit, +1 or -1.
  int sense() const;
  // Returns true if every ball transmits load between the rings, i.e. no ball leaves the load zone.
  bool all_loaded() const;
  // Returns the values of all slots after `passes` ball passes, starting with slot 0 of the
  // first row.
  std::vector<double> by_slot(double passes) const;
  // Returns the weight of each value. Orbital speed and spin are normalized by the values of all
  // balls and weighted by the ball's fraction of the total load; azimuths have no weight.
  std::vector<double> weights(double passes) const;
  // Sets the orbital speeds and spins of the balls of this rank from values by slot. Positions do
  // not change.
  void put(double passes, const std::vector<double> &by_slot) const;
  // Returns the mean advance (rad) of the balls of each row in a ball pass, from their values
  // before and after it.
  std::vector<double> advance(const std::vector<double> &before,
                              const std::vector<double> &now) const;

 private:
  struct Ball {
    double row;               // tag of the ball's outer ring
    double tag, load;         // load: N, total of both raceways
    double inner;             // N, load on the inner raceway
    raceway::Vec3 x, v, w;    // relative to the bearing's centre; the third component is along the
                              // axis
    double azimuth() const { return std::atan2(x.y, x.x); }
    double radius() const { return std::hypot(x.x, x.y); }
    raceway::Vec3 place(const raceway::Vec3 &) const;    // radial, tangential and axial components
    raceway::Vec3 lab(const raceway::Vec3 &) const;      // inverse of place()
  };
  int slot(int ball, double passes) const;

  LAMMPS_NS::LAMMPS *lmp_;
  raceway::LabAxes axes_;
  std::vector<Ball> balls_;    // sorted by row and azimuth; each row starts with its lowest tag
  int rows_ = 0;
};

}    // namespace bearing
