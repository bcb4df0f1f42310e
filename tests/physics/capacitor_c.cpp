// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the capacitance of a contact and its surroundings to test_physics_surroundings.py.
#include "../../src-package/core/contact/contact.h"
#include "../../src-package/core/electric/film_capacitor.h"
#include "../../src-package/core/interface/exports.h"

using namespace raceway;

RECORD(CapacitorInput, double permittivity, film_floor, at, rough, surroundings, outlet,
       inner_shoulder, outer_shoulder, gap;)

namespace {
constexpr int columns = 4;    // h_c, capacitance, separation, outside

CapacitorModel model_from(const CapacitorInput &in)
{
  CapacitorModel m;
  m.permittivity = in.permittivity;
  m.film_floor = in.film_floor;
  m.at = PermittivityAt(int(in.at));
  m.rough = in.rough != 0.0;
  m.surroundings = Surroundings(int(in.surroundings));
  m.permittivity_outlet = in.outlet;
  m.inner_shoulder = in.inner_shoulder;
  m.outer_shoulder = in.outer_shoulder;
  return m;
}

RacewayPhysics with_gap(const RacewayPhysics &p, double share)
{
  RacewayPhysics q = p;
  if (share == 0.0) return q;
  q.choose<FilmInGapPart>();
  q.of<FilmInGapPart>().share = share;
  q.prepare(q.pitch_radius, q.ball_mass, q.overlap_limit);
  return q;
}

// Sets up a contact whose surfaces do not approach each other; returns whether it is closed.
template <class T, class Mask = decltype(T() < T())>
Mask meet(const RacewayPhysics &p, const T &overlap, const T &cos_angle, const T &speed,
          ContactStateT<T> &c)
{
  c.cos_angle = c.nu = cos_angle;
  c.ne = square_root(T(1.0 - cos_angle * cos_angle));
  c.overlap = overlap;
  c.entrainment = speed;
  c.compression = overlap;
  const RacewayConstantsT<T> k = p.law.at(c.cos_angle);
  if (!p.has<FilmInGapPart>()) {
    HertzContactPart::act({}, p, k, LawStates<T>(), c);
    return overlap > 0.0;
  }
  const FilmInGapPart::Parameters &own = p.of<FilmInGapPart>();
  const Mask open = FilmInGapPart::misses(own, p, k, c);
  FilmInGapPart::act(own, p, k, LawStates<T>(), c);
  return !open;
}

template <class T> void put(const FilmCapacitorT<T> &c, T *out)
{
  out[0] = c.h_c;
  out[1] = c.capacitance;
  out[2] = c.separation;
  out[3] = c.outside;
}
}    // namespace

// Computes how far the gap extends (m) on the near and the far side of an ellipse with the given
// semi-axis (m).
EXPORT(void, groove_reach,
       (const RacewayPhysics *p, double depth, double sine, double cosine, double semi_axis,
        double out[2]))
{
  const GrooveShoulder s(p->groove, depth, p->pitch_radius);
  const GrooveReachT<double> r = s.reach(sine, cosine);
  out[0] = semi_axis > 0.0 ? s.around(r.near, cosine, semi_axis) : r.near.reach;
  out[1] = semi_axis > 0.0 ? s.around(r.far, cosine, semi_axis) : r.far.reach;
}

// Evaluates n balls on a raceway, both one by one and four at a time; `columns` values are stored
// for each ball. n must be a multiple of 4.
EXPORT(void, capacitors,
       (const RacewayPhysics *raceway, const CapacitorInput *in, double n, const double *overlap,
        const double *cos_angle, const double *speed, const double *cage_speed, double *one,
        double *four))
{
  const RacewayPhysics p = with_gap(*raceway, in->gap);
  const CapacitorModel m = model_from(*in);
  const SurroundedRaceway s(p, m);
  for (int i = 0; i < int(n); ++i) {
    ContactState c;
    const bool live = meet(p, overlap[i], cos_angle[i], speed[i], c);
    if (m.surrounded()) put(s.capacitor(c, live, cage_speed[i]), one + columns * i);
    else put(live ? film_capacitor(p, c, m) : FilmCapacitorT<double>{}, one + columns * i);
  }
  for (int i = 0; i < int(n); i += lanes) {
    Lane x[4];
    for (int k = 0; k < lanes; ++k) {
      x[0][k] = overlap[i + k];
      x[1][k] = cos_angle[i + k];
      x[2][k] = speed[i + k];
      x[3][k] = cage_speed[i + k];
    }
    ContactStateT<Lane> c;
    const LaneMask live = meet(p, x[0], x[1], x[2], c);
    Lane out[columns];
    if (m.surrounded()) {
      put(s.capacitor(c, live, x[3]), out);
    } else {
      put(film_capacitor(p, c, m), out);
      for (Lane &v : out) v = where(live, v, 0.0);
    }
    for (int k = 0; k < lanes; ++k)
      for (int q = 0; q < columns; ++q) four[columns * (i + k) + q] = out[q][k];
  }
}
