// SPDX-License-Identifier: GPL-2.0-or-later
// Breakdown of films and the subsequent discharge (docs/electric_circuit, Breakdown).
#pragma once

#include "film_network.h"

namespace raceway {

// A film that has failed.
struct FilmFailure {
  size_t ball;
  bool at_outer;
  int order;                                                // position in the sequence of failures
                                                            // of its discharge, counted from 1
  double film_voltage, ring_voltage, ring_voltage_after;    // V
  double film_energy, energy;                               // J
};

// Amount by which the local film thickness is reduced, in standard deviations of the roughness.
constexpr double film_peaks = 3.0;

// Returns the local thickness of a film, m: `thickness` minus `less` (m), which accounts for the
// roughness of the surfaces, but at least `floor` (m).
inline double local_thickness(double thickness, double less, double floor)
{
  return std::fmax(thickness - less, floor);
}

// Current (A) at a failure through the resistance `arc` (ohm), and the time (s) in which the
// current falls to 1/e. The capacitance C behind the film follows from energy = C film_voltage^2/2.
struct ArcCurrent {
  double peak, duration;

  ArcCurrent(const FilmFailure &f, double arc) :
      peak(std::abs(f.film_voltage) / arc),
      duration(arc * 2.0 * f.energy / (f.film_voltage * f.film_voltage))
  {
  }
};

// Returns the breakdown voltage (V) of a film, i.e. its local_thickness() times `strength` (V/m).
// It is infinite if there is no film.
inline double film_limit(double thickness, double strength, double less, double floor)
{
  if (!(thickness > 0.0)) return std::numeric_limits<double>::infinity();
  return strength * local_thickness(thickness, less, floor);
}

// Returns the smallest voltage (V) between the rings at which a film fails if the balls are
// uncharged; It is 0 if this film is bridged, i.e. if its limit is at most `bridged` (V), which is
// the limit of a film at the film floor.
inline double threshold_voltage(const BearingFilms &films, double bridged)
{
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](double limit, double whole, double other) {
    least = std::fmin(least, limit > bridged ? limit * whole / other : 0.0);
  };
  for (const BallFilms &f : films) {
    const double in = f.inner.capacitance, out = f.outer.capacitance;
    if (out > 0.0) take(f.inner.limit, in + out, out);
    if (in > 0.0) take(f.outer.limit, in + out, in);
  }
  return least;
}

// Returns the energy stored in films, parallel capacitances and the coupling, J.
inline double stored_energy(const BearingFilms &films, const OuterPoint &outer, const NodeValues &v)
{
  const double across = v.ring - outer.driving;
  double twice = outer.beside * v.ring * v.ring + outer.coupling * across * across;
  for (size_t k = 0; k < films.size(); ++k) {
    const double in = v.ring - v.ball[k], out = v.ball[k];
    twice += films[k].inner.capacitance * in * in + films[k].outer.capacitance * out * out;
  }
  return 0.5 * twice;
}

// Indicates which films of a ball conduct.
struct Broken {
  bool inner = false, outer = false;
};

// Computes the voltages after a failure from the charges before it. The failed films are treated as
// conductors.
inline void redistribute(const BearingFilms &films, const OuterPoint &outer,
                         const NodeValues &charge, const std::vector<Broken> &broken,
                         NodeValues &voltage)
{
  double on_ring = charge.ring + outer.coupling * outer.driving;
  double capacitance = outer.beside + outer.coupling;
  bool grounded = false;
  for (size_t k = 0; k < films.size(); ++k) {
    const double in = films[k].inner.capacitance, out = films[k].outer.capacitance;
    if (broken[k].inner && broken[k].outer) {
      grounded = true;
    } else if (broken[k].inner) {    // the ball forms one conductor with the inner ring
      on_ring += charge.ball[k];
      capacitance += out;
    } else if (broken[k].outer) {    // the ball is connected to the frame
      capacitance += in;
    } else {
      const double share = in * inverse_or_zero(in + out);
      on_ring += share * charge.ball[k];
      capacitance += share * out;
    }
  }
  voltage.ring = grounded ? 0.0 : on_ring / capacitance;
  for (size_t k = 0; k < films.size(); ++k) {
    const double in = films[k].inner.capacitance, out = films[k].outer.capacitance;
    voltage.ball[k] = broken[k].outer ? 0.0
                      : broken[k].inner
                          ? voltage.ring
                          : (charge.ball[k] + in * voltage.ring) * inverse_or_zero(in + out);
  }
}

// As long as the voltage of any film exceeds its limit, lets the most overloaded film fail.
// `failed` is called for each failure. Failed films conduct until the end of the discharge and are
// intact afterwards. Returns the work (J) done by the driving voltage while charges move.
template <class Failed>
double discharge(const BearingFilms &films, const OuterPoint &outer, NodeValues &charge,
                 NodeValues &voltage, Failed &&failed)
{
  std::vector<Broken> broken;
  double work = 0.0;
  for (int order = 1;; ++order) {
    FilmFailure f = {};
    f.order = order;
    double most = 1.0;
    bool found = false;
    for (int side = 0; side < 2; ++side)
      for (size_t k = 0; k < films.size(); ++k) {
        if (!broken.empty() && (side ? broken[k].outer : broken[k].inner)) continue;
        const double v = side ? voltage.ball[k] : voltage.ring - voltage.ball[k];
        const CircuitFilm &film = side ? films[k].outer : films[k].inner;
        const double load = std::abs(v) / film.limit;
        if (!(load > most)) continue;
        most = load;
        found = true;
        f.ball = k;
        f.at_outer = side;
        f.film_voltage = v;
        f.film_energy = 0.5 * film.capacitance * v * v;
      }
    if (!found) break;
    broken.resize(films.size());
    (f.at_outer ? broken[f.ball].outer : broken[f.ball].inner) = true;
    const double before = stored_energy(films, outer, voltage);
    f.ring_voltage = voltage.ring;
    redistribute(films, outer, charge, broken, voltage);
    f.ring_voltage_after = voltage.ring;
    const double given = outer.coupling * outer.driving * (f.ring_voltage - f.ring_voltage_after);
    f.energy = before - stored_energy(films, outer, voltage) + given;
    work += given;
    failed(f);
  }
  if (broken.empty()) return 0.0;
  bool grounded = false;
  for (size_t k = 0; k < films.size(); ++k) {
    if (!broken[k].inner && !broken[k].outer) continue;
    const double after = films[k].outer.capacitance * voltage.ball[k] -
                         films[k].inner.capacitance * (voltage.ring - voltage.ball[k]);
    if (broken[k].inner) charge.ring += charge.ball[k] - after;
    grounded = grounded || (broken[k].inner && broken[k].outer);
    charge.ball[k] = after;
  }
  if (grounded) charge.ring = ring_charge(films, outer, voltage);
  return work;
}

}    // namespace raceway
