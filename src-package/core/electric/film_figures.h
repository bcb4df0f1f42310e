// SPDX-License-Identifier: GPL-2.0-or-later
// Electrical quantities of a bearing at one instant: its leakage resistance, its impedance, the
// smallest voltage at which a film fails, and the energy of the resulting discharge (docs/electric,
// Breakdown and Impedance).
#pragma once

#include "film_breakdown.h"
#include "film_capacitor.h"
#include "impedance.h"

namespace raceway {

// Inputs for the requested quantities; 0: not requested.
struct FilmQuestions {
  double resistivity = 0.0;    // of the lubricant, ohm m
  double frequency = 0.0;      // Hz
  double strength = 0.0;       // dielectric strength of a film, V/m

  bool any() const { return resistivity > 0.0 || frequency > 0.0 || strength > 0.0; }
};

// A film at one sample of a run. A film without capacitance is open.
struct SampledFilm {
  double capacitance = 0.0;    // F
  double thickness = 0.0;      // m
  double roughness = 0.0;      // m, composite
  double paths = 0.0;          // resistivity of the oil divided by the resistance of the film, m

  // Adds another film between the same ball and ring. The thinner of the two is the one that fails.
  void add(const SampledFilm &beside)
  {
    if (!(beside.capacitance > 0.0)) return;
    if (!(capacitance > 0.0 && thickness <= beside.thickness)) {
      thickness = beside.thickness;
      roughness = beside.roughness;
    }
    capacitance += beside.capacitance;
    paths += beside.paths;
  }
};
struct SampledBall {
  SampledFilm film[2];    // inner, outer
};

// A value is 0 if it was not requested or is infinite.
struct FilmFigures {
  double leak = 0.0;                      // ohm, for direct current
  double impedance = 0.0, phase = 0.0;    // ohm, rad
  double threshold = 0.0, local = 0.0;    // V, breakdown voltage computed from the mean and from
                                          // the local film thickness
  double energy = 0.0;                    // J, energy stored at the voltage `threshold`
};

// Returns the area of a contact ellipse, m^2.
inline double hertz_area(const RacewayPhysics &p, const ContactState &c)
{
  const RacewayConstants k = p.law.at(c.cos_angle);
  return 3.14159265358979323846 * k.a * k.b * c.root * c.root;
}

// Returns the fraction of the gap outside the ellipse that is filled with oil.
inline double wet_share(Surroundings s)
{
  return s == Surroundings::flooded ? 1.0 : s == Surroundings::cavitated ? 0.5 : 0.0;
}

// Returns the sample for a capacitor with the given area of the contact ellipse (m^2) and composite
// roughness (m).
inline SampledFilm sampled_film(const CapacitorModel &m, const FilmCapacitorT<double> &c,
                                double area, double roughness)
{
  const bool all = m.surrounded();
  const double around = c.outside / (vacuum_permittivity * m.outside());
  SampledFilm f;
  f.capacitance = all ? c.total() : c.capacitance;
  f.thickness = all ? c.separation : c.h_c;
  f.roughness = roughness;
  f.paths = (c.h_c > 0.0 ? area / c.h_c : 0.0) + wet_share(m.surroundings) * around;
  return f;
}

// Computes the results for the films of all balls; `beside` (F) is a capacitance between the rings
// that is in parallel with the films.
inline FilmFigures film_figures(const FilmQuestions &ask, const std::vector<SampledBall> &balls,
                                double beside)
{
  const auto finite = [](double x) { return std::isfinite(x) ? x : 0.0; };
  FilmFigures out;
  BearingFilms films(balls.size());
  const auto fill = [&](double peaks) {
    for (size_t k = 0; k < balls.size(); ++k)
      for (int side = 0; side < 2; ++side) {
        const SampledFilm &s = balls[k].film[side];
        CircuitFilm &f = side ? films[k].outer : films[k].inner;
        f = {};
        if (!(s.capacitance > 0.0)) continue;
        f.capacitance = s.capacitance;
        if (ask.resistivity > 0.0) f.conductance = s.paths / ask.resistivity;
        if (ask.strength > 0.0)
          f.limit = film_limit(s.thickness, ask.strength, peaks * s.roughness, 0.0);
      }
  };
  fill(film_peaks);
  out.local = finite(threshold_voltage(films, 0.0));
  fill(0.0);
  out.threshold = finite(threshold_voltage(films, 0.0));
  const double capacitance = bearing_capacitance(films) + beside;
  out.energy = 0.5 * capacitance * out.threshold * out.threshold;
  if (ask.resistivity > 0.0) out.leak = finite(1.0 / admittance(films, 0.0).real());
  if (ask.frequency > 0.0) {
    const double omega = 2.0 * 3.14159265358979323846 * ask.frequency;
    const Complex y = admittance(films, omega) + Complex(0.0, omega * beside);
    if (y != 0.0) {
      out.impedance = std::abs(1.0 / y);
      out.phase = std::arg(1.0 / y);
    }
  }
  return out;
}

}    // namespace raceway
