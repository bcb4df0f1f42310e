// SPDX-License-Identifier: GPL-2.0-or-later
// The balls of one bearing by slot, as `settle orbit` uses them. A slot is one of as many positions
// around the ring as there are balls. In a ball pass every ball moves to the next slot.
#ifndef BEARING_ORBIT_BALLS_H
#define BEARING_ORBIT_BALLS_H

#include "../core/numbers/lab_axes.h"
#include "../core/numbers/vec3.h"
#include "bearing_compat.h"

#include <vector>

namespace bearing {

class OrbitBalls {
 public:
  // Numbers per slot: azimuth of its ball (rad), orbital speed (rad/s), and the ball's spin in the
  // radial, tangential and axial directions at the ball's place (rad/s).
  static constexpr int numbers = 5;

  // Reads the present state of the balls; collective, with the same result on all ranks.
  explicit OrbitBalls(LAMMPS_NS::LAMMPS *);

  int size() const { return static_cast<int>(balls_.size()); }
  double spacing() const { return 2.0 * M_PI / size(); }    // rad
  // Direction in which the balls orbit, +1 or -1.
  int sense() const;
  // Numbers of all slots after `passes` ball passes, slot 0 first.
  std::vector<double> by_slot(double passes) const;
  // Weight of each number: orbital speed and spin are relative to the values of all balls and
  // weighted by the ball's share of the total load; azimuths have no weight.
  std::vector<double> weights(double passes) const;
  // Sets orbital speeds and spins of this rank's balls from numbers by slot; positions do not
  // change.
  void put(double passes, const std::vector<double> &by_slot) const;
  // Mean advance (rad) of the balls in a ball pass, from the numbers before it and now
  double advance(const std::vector<double> &before, const std::vector<double> &now) const;

 private:
  struct Ball {
    double tag, load;         // N, on both raceways
    raceway::Vec3 x, v, w;    // relative to the bearing's centre, bearing axis third
    double azimuth() const { return std::atan2(x.y, x.x); }
    double radius() const { return std::hypot(x.x, x.y); }
    raceway::Vec3 place(const raceway::Vec3 &) const;    // in radial, tangential, axial directions
    raceway::Vec3 lab(const raceway::Vec3 &) const;      // inverse of place()
  };
  int slot(int ball, double passes) const;

  LAMMPS_NS::LAMMPS *lmp_;
  raceway::LabAxes axes_;
  std::vector<Ball> balls_;    // by azimuth, starting with the lowest tag
};

}    // namespace bearing

#endif
