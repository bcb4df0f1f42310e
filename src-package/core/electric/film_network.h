// SPDX-License-Identifier: GPL-2.0-or-later
// The electrical network of a bearing: balls that float between two films, the inner ring, and the
// outer ring, which is the frame (docs/electric_circuit, Network). The unknowns are charges. The
// cost per point in time is proportional to the number of balls.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace raceway {

// A film at one point in time. A film with capacitance 0 is open and carries no displacement
// current.
struct CircuitFilm {
  double capacitance = 0.0;                                  // F
  double conductance = 0.0;                                  // S
  double limit = std::numeric_limits<double>::infinity();    // V, voltage at which the film fails
};
struct BallFilms {
  CircuitFilm inner, outer;
};
using BearingFilms = std::vector<BallFilms>;    // indexed by ball

// Elements between the rings at one point in time.
struct OuterPoint {
  double beside = 0.0;         // F, from the inner ring to the frame
  double coupling = 0.0;       // F, from the inner ring to the driving voltage
  double conductance = 0.0;    // S, in parallel with `coupling`; infinite: the ring is at the
                               // driving voltage
  double driving = 0.0;        // V

  bool stiff() const { return std::isinf(conductance); }
};

// Charges (C) of the balls and of the inner ring, or their voltages (V).
struct NodeValues {
  std::vector<double> ball;
  double ring = 0.0;
};

// Charges (C) that flow through resistances in a step: through the films of each ball towards the
// outer ring, and from the driving voltage.
struct StepCharges {
  std::vector<double> inner, outer;
  double supplied = 0.0;
};

inline double inverse_or_zero(double x) { return x != 0.0 ? 1.0 / x : 0.0; }

// Computes the voltages (V) that belong to `charge`. Conductances times `length` (s) are added to
// the capacitances.
inline void find_voltages(const BearingFilms &films, const OuterPoint &outer, double length,
                          const NodeValues &charge, NodeValues &voltage)
{
  const size_t n = films.size();
  voltage.ball.resize(n);
  double ring = outer.driving;
  if (!outer.stiff()) {
    const double source = outer.coupling + outer.conductance * length;
    double on_ring = charge.ring + source * outer.driving, capacitance = outer.beside + source;
    for (size_t k = 0; k < n; ++k) {
      const double in = films[k].inner.capacitance + films[k].inner.conductance * length;
      const double out = films[k].outer.capacitance + films[k].outer.conductance * length;
      const double share = in * inverse_or_zero(in + out);
      on_ring += share * charge.ball[k];
      capacitance += share * out;
    }
    ring = on_ring * inverse_or_zero(capacitance);
  }
  for (size_t k = 0; k < n; ++k) {
    const double in = films[k].inner.capacitance + films[k].inner.conductance * length;
    const double out = films[k].outer.capacitance + films[k].outer.conductance * length;
    voltage.ball[k] = (charge.ball[k] + in * ring) * inverse_or_zero(in + out);
  }
  voltage.ring = ring;
}

// Returns the capacitance of both films in series, summed over the balls, F.
inline double bearing_capacitance(const BearingFilms &films)
{
  double sum = 0.0;
  for (const BallFilms &f : films)
    sum += f.inner.capacitance * f.outer.capacitance *
           inverse_or_zero(f.inner.capacitance + f.outer.capacitance);
  return sum;
}

// Returns the charge of an inner ring at these voltages, C.
inline double ring_charge(const BearingFilms &films, const OuterPoint &outer, const NodeValues &v)
{
  double sum = outer.beside * v.ring + outer.coupling * (v.ring - outer.driving);
  for (size_t k = 0; k < films.size(); ++k)
    sum += films[k].inner.capacitance * (v.ring - v.ball[k]);
  return sum;
}

inline bool has_resistance(const BearingFilms &films, const OuterPoint &outer)
{
  if (outer.conductance > 0.0 && !outer.stiff()) return true;
  for (const BallFilms &f : films)
    if (f.inner.conductance > 0.0 || f.outer.conductance > 0.0) return true;
  return false;
}

// Interpolates the films at the fraction `share` of the interval between two points; the result has
// no breakdown limits.
inline BallFilms between(const BallFilms &from, const BallFilms &to, double share)
{
  const auto film = [share](const CircuitFilm &a, const CircuitFilm &b) {
    CircuitFilm c;
    c.capacitance = a.capacitance + share * (b.capacitance - a.capacitance);
    c.conductance = a.conductance + share * (b.conductance - a.conductance);
    return c;
  };
  return {film(from.inner, to.inner), film(from.outer, to.outer)};
}

inline BearingFilms between(const BearingFilms &from, const BearingFilms &to, double share)
{
  BearingFilms films(to.size());
  for (size_t k = 0; k < to.size(); ++k) films[k] = between(from[k], to[k], share);
  return films;
}

inline OuterPoint between(const OuterPoint &from, const OuterPoint &to, double share)
{
  OuterPoint p = to;
  p.beside = from.beside + share * (to.beside - from.beside);
  p.driving = from.driving + share * (to.driving - from.driving);
  return p;
}

// Performs one step of `length` (s), at the end of which the films and the outer circuit are those
// given. The method is a two-stage SDIRK method that is L-stable and of second order.
inline void network_step(const BearingFilms &from, const BearingFilms &to,
                         const OuterPoint &outer_from, const OuterPoint &outer_to, double length,
                         NodeValues &charge, NodeValues &voltage, StepCharges &moved)
{
  const size_t n = to.size();
  moved.inner.assign(n, 0.0);
  moved.outer.assign(n, 0.0);
  moved.supplied = 0.0;
  if (!has_resistance(from, outer_from) && !has_resistance(to, outer_to)) {
    find_voltages(to, outer_to, 0.0, charge, voltage);
    return;
  }
  const double stage = 1.0 - std::sqrt(0.5);
  const BearingFilms middle = between(from, to, stage);
  const OuterPoint outer_middle = between(outer_from, outer_to, stage);
  for (int s = 0; s < 2; ++s) {
    const BearingFilms &films = s ? to : middle;
    const OuterPoint &outer = s ? outer_to : outer_middle;
    const double weight = (s ? stage : 1.0 - stage) * length;
    find_voltages(films, outer, stage * length, charge, voltage);
    double leaves = 0.0;
    for (size_t k = 0; k < n; ++k) {
      const double in = films[k].inner.conductance * weight * (voltage.ring - voltage.ball[k]);
      const double out = films[k].outer.conductance * weight * voltage.ball[k];
      moved.inner[k] += in;
      moved.outer[k] += out;
      charge.ball[k] += in - out;
      leaves += in;
    }
    const double given =
        outer.stiff() ? 0.0 : outer.conductance * weight * (outer.driving - voltage.ring);
    moved.supplied += given;
    charge.ring += given - leaves;
  }
}

}    // namespace raceway
