// SPDX-License-Identifier: GPL-2.0-or-later
// Bending of a round shaft, described by elastic modes in addition to its rigid-body motion. The
// modes are the same in the planes of both radial axes (the bearing axis is the third). Modal
// coordinates are lengths; the modes do not rotate with the shaft. They are mass-orthogonal to the
// rigid-body motion, and
//   m a'' + c a' + k a + spin g b' = f_a,    m b'' + c b' + k b - spin g a' = f_b
// where a are the coordinates in the first plane and b those in the second. The gyroscopic matrix g
// also couples the modes to the slopes of the rigid shaft, which occupy its first row and column.
#pragma once

#include "shaft_ring.h"

#include <type_traits>
#include <vector>

namespace raceway {

struct ShaftModes {
  struct Station {
    double at;                            // m, relative to the centre of mass
    std::vector<double> moved, tilted;    // deflection (1) and slope (rad/m), indexed by mode
  };
  std::vector<double> mass, stiffness, damping;    // modal values in kg, N/m and N s/m
  std::vector<double> gyroscopic;                  // stored row by row, starting with the slope of
                                                   // the rigid shaft
  std::vector<Station> stations;                   // sorted by position

  int size() const { return static_cast<int>(mass.size()); }    // number of modes in a plane
  double g(int i, int k) const { return gyroscopic[i * (size() + 1) + k]; }
  const Station &station(double at) const    // returns the station nearest to `at`
  {
    const Station *best = &stations.front();
    for (const Station &s : stations)
      if (std::fabs(s.at - at) < std::fabs(best->at - at)) best = &s;
    return *best;
  }
};

// Coordinates of all modes, first those in the first plane, then those in the second plane.
struct BendState {
  std::vector<double> place, rate;    // m, m/s

  void resize(int modes)
  {
    place.assign(2 * modes, 0.0);
    rate.assign(2 * modes, 0.0);
  }
};

// Deflection at a position on the shaft, relative to the rigid shaft.
struct Deflection {
  double moved[2] = {}, slope[2] = {};    // of the shaft's axis in both radial directions, m and
                                          // rad
  double speed[2] = {}, rate[2] = {};     // m/s, rad/s

  Deflection(const ShaftModes::Station &s, const BendState &b)
  {
    const size_t n = s.moved.size();
    for (size_t plane = 0; plane < 2; ++plane)
      for (size_t k = 0; k < n; ++k) {
        const double q = b.place[plane * n + k], v = b.rate[plane * n + k];
        moved[plane] += s.moved[k] * q;
        slope[plane] += s.tilted[k] * q;
        speed[plane] += s.moved[k] * v;
        rate[plane] += s.tilted[k] * v;
      }
  }
};

// Return the axis that has the given slopes, and its rate of change.
inline Vec3 axis_of(double x, double y) { return {x, y, std::sqrt(1.0 - x * x - y * y)}; }
inline Vec3 axis_speed(const Vec3 &e, double x, double y)
{
  return {x, y, -(e.x * x + e.y * y) / e.z};
}

// Rotates the axis `from` of a station into e, and adds the two given rates to the rates of its
// slopes.
template <class Place>
void turn_axis(Place &r, const Vec3 &e, const Vec3 &from, double rate_1, double rate_2)
{
  const Vec3 was = cross(turning(r), from);
  const Vec3 W = cross(e, axis_speed(e, was.x + rate_1, was.y + rate_2));
  if constexpr (std::is_same_v<Place, RingAtom>) {
    r.w = W + e * dot(r.w, from);
  } else {
    r.rate[0] = W.x;
    r.rate[1] = W.y;
  }
  r.e = e;
  tilt_of(r.e, r.tilt);
}

// Returns the state of a ring on a flexible shaft.
template <class Place>
Place carried(const Place &shaft, double at, const Vec3 &origin, const Deflection &d)
{
  Place ring = carried(shaft, at, origin);
  ring.x += {d.moved[0], d.moved[1], 0.0};
  ring.v += {d.speed[0], d.speed[1], 0.0};
  turn_axis(ring, axis_of(shaft.e.x + d.slope[0], shaft.e.y + d.slope[1]), shaft.e, d.rate[0],
            d.rate[1]);
  return ring;
}

// Returns the state of the rigid shaft from that of a ring on it.
template <class Place> Place shaft_of(const Place &ring, double at, const Deflection &d)
{
  Place straight = ring;
  straight.x -= {d.moved[0], d.moved[1], 0.0};
  straight.v -= {d.speed[0], d.speed[1], 0.0};
  turn_axis(straight, axis_of(ring.e.x - d.slope[0], ring.e.y - d.slope[1]), ring.e, -d.rate[0],
            -d.rate[1]);
  return shaft_of(straight, at);
}

// Adds a force and a moment at a station to the modal forces (N); e is the axis there.
inline void add_to_modes(const ShaftModes::Station &s, const Vec3 &e, const Vec3 &force,
                         const Vec3 &moment, std::vector<double> &of)
{
  const size_t n = s.moved.size();
  const Vec3 across = moment - e * dot(moment, e);
  for (size_t k = 0; k < n; ++k) {
    of[k] += s.moved[k] * force.x + s.tilted[k] * across.y;
    of[n + k] += s.moved[k] * force.y - s.tilted[k] * across.x;
  }
}

// Adds the forces of the supports at a station to the modal forces. `there` is the pose of the
// station.
inline void add_supports(const ShaftModes::Station &s, const RingProgram &p, const RingPose &there,
                         std::vector<double> &of)
{
  add_to_modes(s, there.e, p.support_force(there),
               p.support_moment(there, there.rate[0], there.rate[1]), of);
}

// Returns the moment about the centre of the rigid shaft with the axis e, due to the force and the
// moment on a ring with the axis `own`. The moment component about the ring's axis acts about the
// shaft's axis.
inline Vec3 moment_about_centre(const Vec3 &e, double at, const Vec3 &own, const Vec3 &force,
                                const Vec3 &moment)
{
  const double torque = dot(moment, own);
  const Vec3 across = moment - own * torque;
  return moment_about_centre(e, at, force, across + e * (torque - dot(across, e)));
}

// Computes the modal forces (N) due to stiffness, damping and gyroscopic coupling of the modes of a
// shaft and writes them to `of`, which is reused without reallocation.
inline void own_forces(const ShaftModes &m, const BendState &b, const RingPose &shaft,
                       std::vector<double> &of)
{
  const int n = m.size();
  of.resize(2 * n);
  for (int k = 0; k < n; ++k) {
    double turn[2] = {-m.g(0, k + 1) * shaft.rate[0], m.g(0, k + 1) * shaft.rate[1]};
    for (int j = 0; j < n; ++j) {
      turn[0] += m.g(k + 1, j + 1) * b.rate[n + j];
      turn[1] += m.g(k + 1, j + 1) * b.rate[j];
    }
    of[k] = -m.stiffness[k] * b.place[k] - m.damping[k] * b.rate[k] - shaft.spin * turn[0];
    of[n + k] =
        -m.stiffness[k] * b.place[n + k] - m.damping[k] * b.rate[n + k] + shaft.spin * turn[1];
  }
}

// Returns the gyroscopic moment that the modes exert on the tilts of their shaft, N m.
inline Vec3 moment_of_modes(const ShaftModes &m, const BendState &b, double spin)
{
  Vec3 sum;
  for (int k = 0; k < m.size(); ++k) {
    sum.x -= spin * m.g(0, k + 1) * b.rate[k];
    sum.y -= spin * m.g(0, k + 1) * b.rate[m.size() + k];
  }
  return sum;
}

inline double strain_energy(const ShaftModes &m, const BendState &b)    // J
{
  double sum = 0.0;
  for (int k = 0; k < m.size(); ++k)
    for (int plane = 0; plane < 2; ++plane) {
      const double q = b.place[plane * m.size() + k];
      sum += 0.5 * m.stiffness[k] * q * q;
    }
  return sum;
}

// Returns the acceleration of a ring on a flexible shaft relative to the rigid shaft, m/s^2.
inline Vec3 bending_acceleration(const ShaftModes &m, const ShaftModes::Station &s,
                                 const std::vector<double> &forces)
{
  Vec3 a;
  for (int k = 0; k < m.size(); ++k) {
    a.x += s.moved[k] * forces[k] / m.mass[k];
    a.y += s.moved[k] * forces[m.size() + k] / m.mass[k];
  }
  return a;
}

}    // namespace raceway
