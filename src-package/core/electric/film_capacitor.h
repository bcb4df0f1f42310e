// SPDX-License-Identifier: GPL-2.0-or-later
// Capacitor formed by a ball and a raceway: the contact ellipse, whose surfaces act as plates, and,
// on request, the surroundings of the ellipse, which also exist if there is no contact
// (docs/fix_bearing_capacitance).
#pragma once

#include "../geometry/groove_shoulder.h"
#include "../laws/film_gap.h"
#include "../raceway/raceway_physics.h"
#include "capacitance.h"
#include "gap_integral.h"

namespace raceway {

enum class PermittivityAt { maximum, mean, two_thirds };    // Hertz contact pressure at which the
                                                            // permittivity is evaluated
enum class Surroundings { none, flooded, dry, cavitated };

// Settings of the capacitor model.
struct CapacitorModel {
  double permittivity = 0.0;    // relative, of the lubricant at ambient pressure; 0: no capacitor
  double film_floor = 1e-9;     // m, lower limit of the film thickness; a thinner film would amount
                                // to a short circuit
  PermittivityAt at = PermittivityAt::maximum;
  bool rough = false;
  Surroundings surroundings = Surroundings::none;
  double permittivity_outlet = 1.0;    // relative, of the medium in the downstream half if
                                       // cavitated
  double inner_shoulder = 0.0, outer_shoulder = 0.0;    // shoulder diameters, m; 0: default groove
                                                        // depth

  bool surrounded() const { return surroundings != Surroundings::none; }
  // Returns the relative permittivity of the gap outside the ellipse; if cavitated, this is the
  // mean over the two halves, which are of equal size.
  double outside() const
  {
    return surroundings == Surroundings::flooded ? permittivity
           : surroundings == Surroundings::dry   ? 1.0
                                                 : 0.5 * (permittivity + permittivity_outlet);
  }
  double groove_depth(const Groove &g) const    // m
  {
    const bool inner = g.side == Side::inner;
    const double shoulder = inner ? inner_shoulder : outer_shoulder;
    if (shoulder == 0.0) return usual_groove_depth * 2.0 * g.ball_radius;
    return inner ? 0.5 * shoulder - g.raceway_radius : g.raceway_radius - 0.5 * shoulder;
  }
  bool operator==(const CapacitorModel &m) const
  {
    return permittivity == m.permittivity && film_floor == m.film_floor && at == m.at &&
           rough == m.rough && surroundings == m.surroundings &&
           permittivity_outlet == m.permittivity_outlet && inner_shoulder == m.inner_shoulder &&
           outer_shoulder == m.outer_shoulder;
  }
  bool operator!=(const CapacitorModel &m) const { return !(*this == m); }
};

// Central film thickness (eq 9) and capacitance of the ellipse; separation and capacitance of the
// surroundings, which are 0 unless requested.
template <class T> struct FilmCapacitorT {
  T h_c, capacitance;       // m and F; 0 if there is no contact
  T separation, outside;    // m, F
  T total() const { return capacitance + outside; }
};

template <class T>
RACEWAY_INLINE T film_permittivity(const CapacitorModel &m, const T &largest_pressure)
{
  if (m.at == PermittivityAt::mean) return mean_permittivity(m.permittivity, largest_pressure);
  if (m.at == PermittivityAt::two_thirds)
    return permittivity_at(m.permittivity, T(2.0 / 3 * largest_pressure));
  return permittivity_at(m.permittivity, largest_pressure);
}

// Returns the film thickness according to the power law at any load. The sliding speed is taken
// from c.
template <class T>
RACEWAY_INLINE T central_film(const RacewayPhysics &p, const RacewayConstantsT<T> &k,
                              const ContactStateT<T> &c, const FilmPointT<T> &at)
{
  T h = film_thickness(k.film.central, at);
  if (p.factors.any) h = h * film_factor(p, k, c, at);
  return h;
}

// Returns the capacitance of the plates of a lubricated contact.
template <class T>
RACEWAY_INLINE FilmCapacitorT<T> film_capacitor(const RacewayPhysics &p, const ContactStateT<T> &c,
                                                const CapacitorModel &m)
{
  const RacewayConstantsT<T> k = p.law.at(c.cos_angle);
  const T h = p.gap_film_of_all_regimes()
                  ? c.h_c
                  : central_film(p, k, c, film_point(c.entrainment, c.film_load));
  const T h_c = where(h > m.film_floor, h, m.film_floor);
  const T eps = film_permittivity(m, T(k.p * c.root));
  T C = contact_capacitance(eps, T(k.a * c.root), T(k.b * c.root), h_c);
  if (m.rough) C = C * rough_film_factor(T(p.roughness / h_c));
  return {h_c, C, T(), T()};
}

// A raceway and the surroundings of its contacts.
//
// The separation is the film thickness at the contact load, but at least at the larger of 0.1 N and
// Q_u = m_b r_pitch omega_c^2, the load of a ball that is guided by the outer raceway alone. It is
// therefore defined even if the contact load vanishes. If there is no contact, the separation is
// the gap, provided that the gap is larger. If the film is in the gap (part_film_gap), contacts
// begin at a gap. In this case the gap is used once it exceeds the film thickness, and the
// clearance is measured from the onset of contact, so that capacitances are continuous at the
// onset. If the film law defines a thickness at any load, that thickness is the separation.
class SurroundedRaceway {
 public:
  static constexpr double least_load = 0.1;    // N

  SurroundedRaceway() = default;
  SurroundedRaceway(const RacewayPhysics &p, const CapacitorModel &m) :
      p_(&p), m_(m), modulus_(p.material.Eprime()),
      shoulder_(p.groove, m.groove_depth(p.groove), p.pitch_radius),
      radial_(gap_shape(p.law.radial(), modulus_, p.rolling_radius(1.0))),
      upright_(shoulder_.reach(0.0, 1.0)), ln_floor_(std::log(m.film_floor))
  {
    any_load_ = p.gap_film_of_all_regimes();
    if (!p.facts().film_in_gap || any_load_) return;
    begins_ = p.gap_share();
    least_load_ = power_law_cut;
  }

  const RacewayPhysics *raceway() const { return p_; }
  GrooveReachT<double> reach(double sine, double cosine) const
  {
    return shoulder_.reach(sine, cosine);
  }

  // cage_speed is the orbital speed of the ball (rad/s). If there is no contact, the state contains
  // the position, the overlap and the entrainment speed.
  template <class T, class Mask>
  RACEWAY_INLINE FilmCapacitorT<T> capacitor(const ContactStateT<T> &c, const Mask &live,
                                             const T &cage_speed) const
  {
    const T none = T();
    const Films<T> f = films(c, live, cage_speed);
    FilmCapacitorT<T> to = {none, none, none, none};
    if (any(live)) {
      const T h_c = where(f.h > m_.film_floor, f.h, m_.film_floor);
      T C = contact_capacitance(film_permittivity(m_, T(f.law.p * c.root)), T(f.law.a * c.root),
                                T(f.law.b * c.root), h_c);
      if (m_.rough) C = C * rough_film_factor(T(p_->roughness / h_c));
      to.h_c = where(live, h_c, 0.0);
      to.capacitance = where(live, C, 0.0);
    }
    const auto open = !live;
    T play = none, apart = f.apart;
    if (any(open)) {
      T gap = play = -c.overlap;
      if (begins_ > 0.0) gap = gap - where(f.begins > apart, T(f.begins - apart), 0.0);
      play = play - f.begins;
      apart = where(open & (gap > apart), gap, apart);
      play = where(play > 0.0, play, 0.0);
    }
    const auto floored = !(apart > m_.film_floor);
    to.separation = where(floored, m_.film_floor, apart);
    const T I = integral(c, f, live, to.separation, T(where(floored, ln_floor_, f.ln_apart)), play);
    to.outside = vacuum_permittivity * m_.outside() * I;
    return to;
  }

 private:
  template <class T> struct Films {
    RacewayConstantsT<T> law;
    T h, apart, ln_apart;    // film thickness at the load and at the limited load, m; ln of `apart`
    T ln_load;               // logarithm of the load that determines the film thickness
    T begins;                // m, gap at the onset of contact
  };

  template <class T, class Mask>
  RACEWAY_INLINE Films<T> films(const ContactStateT<T> &c, const Mask &live,
                                const T &cage_speed) const
  {
    const T none = T();
    Films<T> f{p_->law.at(c.cos_angle), c.h_c, none, none, none, none + p_->reach};
    if (any_load_) {
      f.apart = where(live, f.h, 0.0);
      f.ln_apart = logarithm(f.apart);
      f.ln_load = logarithm(c.load);
      return f;
    }
    const T ln_u = logarithm(c.entrainment);
    const T Q_u = p_->ball_mass * p_->pitch_radius * cage_speed * cage_speed;
    const T least = where(Q_u > least_load_, Q_u, least_load_);
    const T Q = where(live, c.film_load, least);
    f.ln_load = logarithm(Q);
    f.ln_apart = film(c, f.law, {ln_u, f.ln_load}, f.h);
    f.apart = f.h;
    const auto light = !(Q >= least);
    if (any(light)) {
      T h;
      const T ln_h = film(c, f.law, {ln_u, logarithm(least)}, h);
      f.apart = where(light, h, f.apart);
      f.ln_apart = where(light, ln_h, f.ln_apart);
    }
    f.begins = none;
    if (begins_ > 0.0) {
      // the film thickness is evaluated at a load of at least least_load_
      const auto cut = live & (Q <= least_load_);
      if (any(cut)) f.ln_load = where(cut, logarithm(c.load), f.ln_load);
      if (any(!live))
        f.begins = begins_ *
                   central_film(*p_, f.law, c, FilmPointT<T>{ln_u, none + std::log(least_load_)});
    }
    return f;
  }

  // Computes the film thickness h and its logarithm.
  template <class T>
  RACEWAY_INLINE T film(const ContactStateT<T> &c, const RacewayConstantsT<T> &k,
                        const FilmPointT<T> &at, T &h) const
  {
    if (!p_->factors.any) {
      const T ln_h = ln_film_thickness(k.film.central, at);
      h = exponential(ln_h);
      return ln_h;
    }
    h = central_film(*p_, k, c, at);
    return logarithm(h);
  }

  template <class T, class Mask>
  RACEWAY_INLINE T integral(const ContactStateT<T> &c, const Films<T> &f, const Mask &live,
                            const T &h, const T &ln_film, const T &play) const
  {
    // at zero contact angle the reach is exact, as are the constants of the law
    const auto oblique = 1.0 - c.cos_angle >= 1e-12;
    const GapShapeT<T> s =
        any(oblique)
            ? gap_shape(f.law, modulus_, p_->rolling_radius(T(where(oblique, c.cos_angle, 1.0))))
            : of_radial<T>();
    const GrooveReachT<T> r = any(oblique)
                                  ? shoulder_.reach(T(where(oblique, magnitude(c.ne), 0.0)),
                                                    T(where(oblique, magnitude(c.nu), 1.0)))
                                  : of_upright<T>();
    const bool leans = any((r.near.reach < r.far.reach) | (r.far.reach < r.near.reach));
    T G = T(), near = T(), far = T(), wider = T() + 1.0;
    if (any(live)) {
      const LoadedGapT<T> loaded(s, T(where(live, c.root, 1e-4)), f.ln_load, h, ln_film);
      G = where(live, loaded.G, 0.0);
      const T a = s.a * loaded.root;
      far = loaded.stretch(shoulder_.around(r.far, c.cos_angle, a));
      if (leans) near = loaded.stretch(shoulder_.around(r.near, c.cos_angle, a));
    }
    if (any(!live)) {
      // flattening of the gap; the slack changes with the temperatures of ring and balls
      const OpenGapT<T> open(s, h, T(1.0 - play * (1.0 / p_->slack)));
      far = where(live, far, open.stretch(r.far.reach));
      if (leans) near = where(live, near, open.stretch(r.near.reach));
      wider = where(live, wider, open.wider);
    }
    return wider * gap_integral(s, G, leans ? near : far, far);
  }
  template <class T> RACEWAY_INLINE GrooveReachT<T> of_upright() const
  {
    const GrooveSideT<T> side = {T() + upright_.far.reach, T() + upright_.far.cotangent};
    return {side, side};
  }
  template <class T> RACEWAY_INLINE GapShapeT<T> of_radial() const
  {
    const T n = T();
    return {n + radial_.a,      n + radial_.Fbar,        n + radial_.scale,
            n + radial_.ends,   n + radial_.log_4_kappa, n + radial_.e,
            n + radial_.root_e, n + radial_.least_D,     n + radial_.log_H};
  }

  const RacewayPhysics *p_ = nullptr;
  CapacitorModel m_;
  double modulus_ = 0.0;    // Pa
  GrooveShoulder shoulder_;
  GapShape radial_;
  GrooveReachT<double> upright_;    // reach at zero contact angle
  double ln_floor_ = 0.0;
  double begins_ = 0.0;    // gap at the onset of contact divided by the film thickness
  double least_load_ = least_load;
  bool any_load_ = false;    // the film thickness is defined at any load
};

}    // namespace raceway
