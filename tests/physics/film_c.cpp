// SPDX-License-Identifier: GPL-2.0-or-later
// Exports film factors, the film in the gap, and the film branch to test_physics_film_*.py.
#include "../../src-package/core/contact/contact.h"
#include "../../src-package/core/contact/contact_slopes.h"
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/laws/film_branch.h"
#include "../../src-package/core/laws/film_factors.h"
#include "../../src-package/core/laws/step_limit.h"

using namespace raceway;

RECORD(FilmContact, double load, compression, h_c, h_min, slope, stiffness, reach;)

// shear: 0 none, 1 Murch and Wilson, 2 Wilson, 3 Gupta. The pressure is a fraction of E', and the
// sliding speed is in m/s.
EXPORT(double, film_factor,
       (double shear, double beta, double viscosity, double conductivity, double starvation,
        double speed, double pressure, double sliding))
{
  FilmFactors f;
  f.inlet_shear = InletShear(int(shear));
  f.temperature_viscosity = beta;
  f.conductivity = conductivity;
  f.starvation = starvation;
  f.prepare(viscosity);
  return f.by_pressure ? f.gupta(logarithm(speed), sliding * sliding).of(pressure)
                       : f.of(logarithm(speed));
}

RECORD(FilmScene, double share, starvation, all_regimes, shear, sliding;)

namespace {
RacewayPhysics with_gap(const RacewayPhysics &p, const FilmScene &scene)
{
  RacewayPhysics q = p;
  q.of<FilmInGapPart>().share = scene.share;
  q.of<FilmInGapPart>().all_regimes = scene.all_regimes != 0.0;
  q.of<HysteresisPart>().alpha_e = 0.0;
  q.factors.inlet_shear = InletShear(int(scene.shear));
  q.factors.temperature_viscosity = 0.047;
  q.factors.conductivity = 0.134;
  q.factors.starvation = scene.starvation;
  q.factors.prepare(q.model.lubricant.viscosity);
  q.reach = q.of<FilmInGapPart>().reach(q);
  q.of<FilmInGapPart>().prepare(q);
  return q;
}

// Sets up a contact whose surfaces do not approach each other, so that the normal force is the
// load. Returns whether the contact is open.
template <class T, class Mask = decltype(T() < T())>
Mask squeeze(const RacewayPhysics &p, const T &overlap, const T &speed, double sliding,
             ContactStateT<T> &c, T &slope)
{
  using L = FullLaw<>;
  c.cos_angle = T() + 1.0;
  c.overlap = overlap;
  c.entrainment = speed;
  c.sliding_t = T() + sliding;
  const Mask open = L::misses(p, p.law.at(c.cos_angle), c);
  const T before = T();
  T after = T();
  ContactSlopesT<T, L::motions> slopes;
  act_with_slopes(L(), p, LawStates<T>{0.0, &before, &after}, 1.0, c, slopes);
  slope = slopes.of[0][0];
  return open;
}
}    // namespace

EXPORT(int, film_contact,
       (const RacewayPhysics *p, const FilmScene *scene, double overlap, double speed,
        FilmContact *out))
{
  const RacewayPhysics q = with_gap(*p, *scene);
  ContactState c;
  double slope = 0.0;
  const bool open = squeeze(q, overlap, speed, scene->sliding, c, slope);
  *out = {c.load, c.compression, c.h_c, c.h_min, slope, c.stiffness, q.reach};
  return open;
}

EXPORT(double, film_stored,
       (const RacewayPhysics *p, const FilmScene *scene, double overlap, double speed))
{
  const RacewayPhysics q = with_gap(*p, *scene);
  ContactState c;
  double slope = 0.0;
  squeeze(q, overlap, speed, scene->sliding, c, slope);
  return FullLaw<>::energy(q, c);
}

// Returns how many values are not bitwise identical between four contacts that are evaluated
// together and the same contacts evaluated one by one.
EXPORT(int, film_lanes,
       (const RacewayPhysics *p, const FilmScene *scene, const double overlap[4],
        const double speed[4]))
{
  const RacewayPhysics q = with_gap(*p, *scene);
  Lane d, u, slope;
  for (int i = 0; i < lanes; ++i) {
    d[i] = overlap[i];
    u[i] = speed[i];
  }
  ContactStateT<Lane> four;
  const LaneMask open = squeeze(q, d, u, scene->sliding, four, slope);
  const Lane energy = FullLaw<>::energy(q, four);
  int different = 0;
  for (int i = 0; i < lanes; ++i) {
    ContactState one;
    double alone;
    different += squeeze(q, overlap[i], speed[i], scene->sliding, one, alone) != (open[i] != 0);
    if (open[i]) continue;
    different += four.load[i] != one.load;
    different += four.h_c[i] != one.h_c;
    different += four.h_min[i] != one.h_min;
    different += slope[i] != alone;
    different += four.film_stiffness[i] != one.film_stiffness;
    different += energy[i] != FullLaw<>::energy(q, one);
  }
  return different;
}

// Returns the largest step for a contact with a film branch.
EXPORT(double, largest_step_with_branch, (double k, double c, double m, double k_m, double rate))
{
  FilmBranches film;
  film.add(k_m, rate);
  return verlet_step_limit(k, c, m, film);
}
