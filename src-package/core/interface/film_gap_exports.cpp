// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the model of the film in the gap (film_gap.h, gap_film.h) for a contact that is defined
// by its parameters.
#include "../raceway/gap_film.h"
#include "exports.h"

using namespace raceway;

RECORD(FilmAtLoad, double thickness, fall;)
RECORD(FilmInGap, double load, h_c, elastic, slope;)

namespace {
// The thickness of one film as a function of the load. `shape` is R_y (m) for the law for all
// regimes, and kappa otherwise. If there is a thermal loading, Gupta's factor is included; `peak`
// is p_max/E' at 1 N. Below the load `cut` (N), the film thickness of a power law is constant, and
// so is Gupta's factor for any film.
struct FilmOverLoad {
  bool all;
  double viscosity, pressure_viscosity, modulus, r_x, shape, speed, factor, loading, peak,
      slide_roll, cut;

  bool rests() const { return speed == 0.0; }
  bool heated() const { return loading > 0.0; }

  PowerFilmT<double> power(double more = 1.0) const
  {
    const FilmLaw law =
        film_laws(FilmModel::masjedi_khonsari, shape, {viscosity, pressure_viscosity}, modulus, r_x)
            .central;
    return {law.lnA + law.p * logarithm(std::fabs(speed)) + logarithm(factor * more), -law.m};
  }
  MoesFilmT<double> moes(double more = 1.0) const
  {
    const MoesRaceway raceway({viscosity, pressure_viscosity}, modulus, r_x, shape);
    return {raceway, raceway.radial, logarithm(std::fabs(speed)), logarithm(factor * more)};
  }
  GuptaFactorT<double> gupta() const
  {
    FilmFactors f;
    f.ln_loading = logarithm(loading);
    return f.gupta(0.0, slide_roll * slide_roll);
  }

  FilmAtLoadT<double> at(double load) const
  {
    if (rests()) return {0.0, all || load < cut ? 0.0 : power().fall};
    const double kept = load > cut ? load : cut;
    FilmAtLoadT<double> f = all ? moes().at(logarithm(load)) : power().at(logarithm(kept));
    if (!all && load < cut) f.fall = 0.0;
    if (!heated()) return f;
    const GuptaFactorT<double> g = gupta();
    const double lost = g.loss(peak * std::cbrt(kept));
    f.thickness *= g.unpressed * (1.0 - lost);
    if (load >= cut && lost < g.most) f.fall += lost / (3.0 * (1.0 - lost));
    return f;
  }
};

template <class Film, bool all>
FilmRootT<double> root(const Film &film, const GuptaFactorT<double> *steep, double overlap,
                       double K, double share, double least)
{
  const GapFilmT<double, all> law(film, steep, K);
  return squeeze(law, overlap, share, law.start(overlap, least));
}

FilmInGap in_gap(const FilmOverLoad &film, double overlap, double K, double share)
{
  const auto loaded = [K](double x, double h, double slope) -> FilmInGap {
    return {hertz_load(K, x), h, x, 1.5 * K * std::sqrt(x) * slope};
  };
  if (film.rests() || share == 0.0) {
    const double x = overlap > 0.0 ? overlap : 0.0;
    return loaded(x, film.at(hertz_load(K, x)).thickness, 1.0);
  }
  GuptaFactorT<double> g = film.heated() ? film.gupta() : GuptaFactorT<double>{1.0, 0.0};
  const double below = g.unpressed * (1.0 - g.loss(film.peak * std::cbrt(film.cut)));
  const double kept = std::pow(film.cut / K, 2.0 / 3.0);    // compression at the load `cut`
  if (!film.all && film.cut > 0.0) {
    const PowerFilmT<double> law = film.power(below);
    const double edge = law.at(logarithm(film.cut)).thickness, least = overlap + share * edge;
    if (least <= 0.0) return {0.0, edge, 0.0, 0.0};
    if (!film.heated()) {
      const FilmGapT<double> found = compress(overlap, share * edge, kept, law.fall);
      return loaded(found.compression, edge * found.thinning, found.slope);
    }
    if (least <= kept) return loaded(least, edge, 1.0);
  }
  constexpr double none = 1e-100;    // m, below any compression
  const auto solve = [&](double more, const GuptaFactorT<double> *steep, double from) {
    return film.all
               ? root<MoesFilmT<double>, true>(film.moes(more), steep, overlap, K, share, from)
               : root<PowerFilmT<double>, false>(film.power(more), steep, overlap, K, share, from);
  };
  FilmRootT<double> found = solve(below, nullptr, none);
  if (film.heated() && found.compression > kept) {
    const double unpressed = g.unpressed;
    g = {1.0, g.per_pressure * film.peak * std::cbrt(K)};    // per square root of the compression
    found = solve(unpressed, &g, kept > none ? kept : none);
  }
  return loaded(found.compression, found.thickness, found.slope);
}
}    // namespace

FORMULA(FilmAtLoad, film_at_load,
        (double load, bool all_regimes, double viscosity, double pressure_viscosity, double modulus,
         double r_x, double shape, double speed, double factor, double loading, double peak,
         double slide_roll, double cut))
{
  const FilmAtLoadT<double> f =
      FilmOverLoad{all_regimes, viscosity, pressure_viscosity, modulus, r_x, shape, speed, factor,
                   loading,     peak,      slide_roll,         cut}
          .at(load);
  return {f.thickness, f.fall};
}

FORMULA(FilmInGap, film_in_gap,
        (double overlap, double stiffness, double share, bool all_regimes, double viscosity,
         double pressure_viscosity, double modulus, double r_x, double shape, double speed,
         double factor, double loading, double peak, double slide_roll, double cut))
{
  return in_gap({all_regimes, viscosity, pressure_viscosity, modulus, r_x, shape, speed, factor,
                 loading, peak, slide_roll, cut},
                overlap, stiffness, share);
}

FORMULA(double, thinning_work,
        (double share, double exponent, double load, double h_c, double cut, double edge))
{
  return thinning_work(share, exponent, load, h_c, cut, edge);
}

FORMULA(double, power_law_cut, ()) { return raceway::power_law_cut; }

FORMULA(double, film_gap_reach, ()) { return raceway::film_gap_reach; }

FORMULA(double, hertz_energy, (double load, double elastic)) { return 0.4 * load * elastic; }
