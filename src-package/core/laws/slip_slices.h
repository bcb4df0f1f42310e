// SPDX-License-Identifier: GPL-2.0-or-later
// Combined differential slip, spin and sliding of one contact under Coulomb's law, summed over
// slices of the contact ellipse across its major axis (docs/tribology, Slip and spin in slices).
//
// At the point (x, z), with x along rolling and z across it, both divided by a, the sliding
// velocity of the ball on the ring is
//   v_t = s_t - q z - e z^2,  v_w = s_w + q x,
// where q = omega_n a is due to spin and e = Omega a^2/(2 R_d) to differential slip, both in m/s.
// The stress is mu p along v. A slice carries the load that results from the Hertz pressure on it,
// half of it at each of the two Gauss points of its chord. Within a slice, v is assumed to vary
// linearly, and its mean direction is
//   mean(v/|v|) = 2 mean(v)/(|v| at one end + |v| at the other),
// which is exact if the direction of v is constant. Forces therefore remain continuous when the
// sliding direction at a point reverses. All sums use the same weight for each point, so the
// dissipated power is positive for any motion.
#pragma once

#include "../numbers/lane.h"

#include <cstring>

namespace raceway {

// Velocities at the centre of the ellipse, and the speed below which friction is proportional to
// the sliding speed, m/s.
template <class T> struct SlipMotionT {
  T along, across, spin, edge;    // s_t, s_w, q, e
  T aspect;                       // b/a
  T least;
};
// Forces divided by mu Q and the moment divided by mu Q a; each of them opposes its motion.
// `couple`, divided by mu Q, is conjugate to e. The slopes (s/m) are used in implicit steps. The
// slopes of the forces are tangents that are blended into secants the more the contact slides as a
// whole; those of moment and couple are secants, which are positive.
template <class T> struct SlipForcesT {
  T along, across, moment, couple;
  T slope_along, slope_across, slope_moment, slope_couple;
};

class SlipSlices {
 public:
  // The slices are evaluated in lanes, in a function that is compiled once rather than inlined into
  // every law. The slopes are 0 unless they are requested.
  template <bool slopes>
  __attribute__((noinline)) static SlipForcesT<double> forces(const SlipMotionT<double> &m)
  {
    const Table &t = table();
    Lane along = {}, across = {}, moment = {}, couple = {};
    Lane all = {}, tangent_t = {}, tangent_w = {}, turned = {}, bent = {};
    for (int half = -1; half < 2; half += 2) {
      const double spin = m.spin, lever = half * m.aspect;
      double size[borders], part_t[borders], part_w[borders];
      for (int k = 0; k < borders; k += lanes) {
        const Lane v_t = m.along - spin * load(t.z + k) - m.edge * load(t.z2 + k);
        const Lane v_w = m.across + spin * lever * load(t.chord + k);
        const Lane v = square_root(Lane(v_t * v_t + v_w * v_w + m.least * m.least));
        store(v, size + k);
        if constexpr (slopes) {
          const Lane over = 1.0 / v;
          store(Lane(v_t * over), part_t + k);
          store(Lane(v_w * over), part_w + k);
        }
      }
      for (int k = 0; k < slices; k += lanes) {
        const Lane z = mean(t.z + k), z2 = mean(t.z2 + k), x = lever * mean(t.chord + k);
        const Lane over = 1.0 / mean(size + k), weight = 0.5 * load(t.load + k) * over;
        const Lane f_t = weight * (m.along - spin * z - m.edge * z2);
        const Lane f_w = weight * (m.across + spin * x);
        along += f_t;
        across += f_w;
        moment += x * f_w - z * f_t;
        couple -= z2 * f_t;
        if constexpr (slopes) {
          all += weight;
          tangent_t += weight - f_t * mean(part_t + k) * over;
          tangent_w += weight - f_w * mean(part_w + k) * over;
          turned += weight * (z * z + x * x);
          bent += weight * z2 * z2;
        }
      }
    }
    SlipForcesT<double> f = {};
    f.along = sum(along);
    f.across = sum(across);
    f.moment = sum(moment);
    f.couple = sum(couple);
    if constexpr (slopes) {
      const double whole = (f.along * f.along + f.across * f.across) * sum(all);
      f.slope_along = sum(tangent_t) + whole;
      f.slope_across = sum(tangent_w) + whole;
      const bool turns = std::fabs(m.spin) > m.least, rolls = std::fabs(m.edge) > m.least;
      f.slope_moment = turns ? std::fabs(f.moment / m.spin) : sum(turned);
      f.slope_couple = rolls ? std::fabs(f.couple / m.edge) : sum(bent);
    }
    return f;
  }

  template <bool slopes> RACEWAY_INLINE static SlipForcesT<Lane> forces(const SlipMotionT<Lane> &m)
  {
    SlipForcesT<Lane> f;
    for (int i = 0; i < lanes; ++i) {
      const SlipForcesT<double> one = forces<slopes>(SlipMotionT<double>{
          m.along[i], m.across[i], m.spin[i], m.edge[i], m.aspect[i], m.least[i]});
      f.along[i] = one.along;
      f.across[i] = one.across;
      f.moment[i] = one.moment;
      f.couple[i] = one.couple;
      f.slope_along[i] = one.slope_along;
      f.slope_across[i] = one.slope_across;
      f.slope_moment[i] = one.slope_moment;
      f.slope_couple[i] = one.slope_couple;
    }
    return f;
  }

 private:
  static constexpr int slices = 24, borders = slices + lanes;    // three borders are unused

  // Values at the borders of the slices: z; z^2, corrected so that the average of its values at
  // both ends of a slice is the mean within the slice; and the position of the Gauss point on the
  // chord, divided by b. The only value for each slice is the load.
  struct Table {
    double z[borders], z2[borders], chord[borders], load[slices];
  };

  static const Table &table()
  {
    static const Table made = [] {
      constexpr double width = 2.0 / slices;
      // integral over z of the load carried by a chord, 3/4 (1 - z^2)
      auto up_to = [](double z) { return 0.75 * (z - z * z * z / 3.0); };
      Table t = {};
      for (int k = 0; k < borders; ++k) {
        t.z[k] = std::fmin(width * k - 1.0, 1.0);
        t.z2[k] = t.z[k] * t.z[k] - width * width / 6.0;
        t.chord[k] = 0.5 * std::sqrt(1.0 - t.z[k] * t.z[k]);
      }
      for (int k = 0; k < slices; ++k) t.load[k] = up_to(t.z[k + 1]) - up_to(t.z[k]);
      return t;
    }();
    return made;
  }

  RACEWAY_INLINE static Lane load(const double *from)
  {
    Lane a;
    std::memcpy(&a, from, sizeof a);
    return a;
  }
  RACEWAY_INLINE static void store(const Lane &a, double *to) { std::memcpy(to, &a, sizeof a); }
  RACEWAY_INLINE static Lane mean(const double *ends)
  {
    return 0.5 * (load(ends) + load(ends + 1));
  }
};

}    // namespace raceway
