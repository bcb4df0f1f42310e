// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the physics headers through a C interface to the tests in this folder; physics_c.py calls
// the functions by name (see src-package/core/interface/exports.h). All numbers are doubles, even
// those that select an option.
#include "../../src-package/core/geometry/rail.h"
#include "../../src-package/core/geometry/ring_body.h"
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/laws/damped_hertz.h"
#include "../../src-package/core/laws/step_limit.h"
#include "../../src-package/core/raceway/start_rotation.h"
#include "any_parts.h"

#include <algorithm>

using namespace raceway;

EXPORTS

// Data for one raceway, in the form that the tests use.
RECORD(RacewayInput, double side, raceway_radius, groove_radius, ball_radius, ball_young,
       ball_poisson, ring_young, ring_poisson, ellipse, film, viscosity, pressure_viscosity,
       damper_full_axis, damper_rolling_radius, friction, mu, mu_boundary, mu_full, lambda_1,
       lambda_2, hysteresis, ring_roughness, ball_roughness, film_floor, tangential_ratio,
       tangential_zeta, pitch_radius, ball_mass, overlap_limit, offset;)

RECORD(Constants, double K, a, b, p, min_lnA, min_p, min_m, central_lnA, central_p, central_m,
       film_damper;)
RECORD(Derived, double centre_circle, slack, largest_overlap, roughness, inverse_roughness, floor,
       kt_ratio, ct_factor, modulus;)
RECORD(Place, double u[3], t[3], r, z, s, nu, ne;)
// lam stands for lambda, which is a reserved word in Python
RECORD(State, double u[3], t[3], r, z, nu, ne, overlap, root, cos_angle, overlap_rate, load,
       stiffness, damping, normal, entrainment, sliding_t, sliding_w, h_min, lam, mu, kt, ct,
       friction_t, friction_w;)
RECORD(Forces, double force[3], ball_torque[3], ring_torque[3];)
RECORD(BallMotion, double x[3], v[3], w[3];)
RECORD(RingMotion, double x[3], v[3], w[3], e[3];)
RECORD(SpringForce, double ft, fw;)
RECORD(CageContact, double stiffness, damping, growth, force;)
RECORD(RailSeat, double circle, tube, offset;)
RECORD(Start, double orbit, radial, axial, spin[2];)

static RacewayPhysics raceway_from(const RacewayInput &in)
{
  RacewayPhysics p;
  p.groove = {Side(int(in.side)), in.raceway_radius, in.groove_radius, in.ball_radius, in.offset};
  p.material = {in.ball_young, in.ball_poisson, in.ring_young, in.ring_poisson};
  p.model.ellipse = Ellipse(int(in.ellipse));
  p.model.film = FilmModel(int(in.film));
  p.model.lubricant = {in.viscosity, in.pressure_viscosity};
  p.model.damper_full_axis = in.damper_full_axis != 0.0;
  p.model.damper_rolling_radius = in.damper_rolling_radius != 0.0;
  if (in.friction == 1.0) p.choose<ConstantFrictionPart>();
  if (in.friction == 2.0) p.choose<StribeckFrictionPart>();
  p.of<ConstantFrictionPart>().mu = in.mu;
  p.of<StribeckFrictionPart>().curve = {in.mu_boundary, in.mu_full, 0.0, 0.0};
  p.lambda_1 = in.lambda_1;
  p.lambda_2 = in.lambda_2;
  p.of<HysteresisPart>().alpha_e = in.hysteresis;
  p.ring_roughness = in.ring_roughness;
  p.ball_roughness = in.ball_roughness;
  p.of<FilmDamperPart>().film_floor = in.film_floor;
  p.of<TangentialSpringPart>().ratio = in.tangential_ratio;
  p.of<TangentialSpringPart>().zeta = in.tangential_zeta;
  p.prepare(in.pitch_radius, in.ball_mass, in.overlap_limit);
  return p;
}

static void put(const RacewayConstants &c, Constants *out)
{
  const FilmPair &f = c.film;
  *out = {c.K,     c.a,           c.b,         c.p,         f.min.lnA,    f.min.p,
          f.min.m, f.central.lnA, f.central.p, f.central.m, c.film_damper};
}

static void put(const ContactState &c, State *out)
{
  *out = {{},          {},          c.r,          c.z,         c.nu,
          c.ne,        c.overlap,   c.root,       c.cos_angle, c.overlap_rate,
          c.load,      c.stiffness, c.damping,    c.normal,    c.entrainment,
          c.sliding_t, c.sliding_w, c.h_min,      c.lambda,    c.mu,
          c.kt,        c.ct,        c.friction_t, c.friction_w};
  c.u.to(out->u);
  c.t.to(out->t);
}

// Applies one of the functions in exp_log.h and arctangent.h to n numbers, both one by one and four
// at a time.
template <class T> static T elementary_of(int which, const T &x)
{
  return which == 0   ? exponential(x)
         : which == 1 ? logarithm(x)
         : which == 2 ? rough_exponential(x)
         : which == 3 ? rough_logarithm(x)
                      : arctangent(x);
}
EXPORT(void, elementary, (double which, double n, const double *x, double *one, double *four))
{
  const int count = int(n);
  for (int i = 0; i < count; ++i) one[i] = elementary_of(int(which), x[i]);
  for (int i = 0; i < count; i += lanes) {
    Lane v = all_lanes(1.0);
    for (int k = 0; k < lanes && i + k < count; ++k) v[k] = x[i + k];
    v = elementary_of(int(which), v);
    for (int k = 0; k < lanes && i + k < count; ++k) four[i + k] = v[k];
  }
}

// ---- vec3.h
EXPORT(void, vec3_rotate, (const double a[3], const double w[3], double out[3]))
{
  rotate(Vec3::from(a), Vec3::from(w)).to(out);
}

// ---- friction.h
// xi is updated.
EXPORT(void, friction_spring,
       (double k, double c, double cap, double vt, double vw, double xi[2], SpringForce *out))
{
  tangential_force(TangentialSpring{k, c}, cap, vt, vw, xi, out->ft, out->fw);
}

// ---- groove.h
EXPORT(double, groove_circle, (double side, double raceway_radius, double groove, double ball))
{
  return Groove{Side(int(side)), raceway_radius, groove, ball}.centre_circle();
}
EXPORT(double, groove_slack, (double groove, double ball))
{
  return Groove{Side::inner, 0.0, groove, ball}.slack();
}
EXPORT(void, groove_locate,
       (const double d[3], const double e[3], double centre_circle, Place *out))
{
  const GroovePosition g = locate(Vec3::from(d), Vec3::from(e), centre_circle);
  *out = {{}, {}, g.r, g.z, g.s, g.nu, g.ne};
  g.u.to(out->u);
  g.t.to(out->t);
}

// ---- damped_hertz.h
EXPORT(void, cage_contact, (double K, double overlap, double rate, double m, CageContact *out))
{
  const DampedHertz h = damped_hertz(K, overlap, rate, m);
  *out = {h.stiffness, h.damping, h.growth, h.force};
}

// ---- rail.h
EXPORT(void, rail_seat,
       (double pitch, double ball, double tube, double gap, double sign, RailSeat *out))
{
  const Rail r = seat_rail(pitch, ball, tube, gap, sign);
  *out = {r.circle, r.tube, r.offset};
}
EXPORT(double, rail_spring, (const RailSeat *rail, double ball, double pitch, double Eprime))
{
  return rail_stiffness({rail->circle, rail->tube, rail->offset}, ball, pitch, Eprime);
}
EXPORT(double, rail_may_touch,
       (const RailSeat *rail, double r, double z, double ball, double margin))
{
  return may_touch({rail->circle, rail->tube, rail->offset}, r, z, ball, margin);
}

// ---- ring_body.h
EXPORT(void, ring_momentum,
       (double axial, double transverse, const double w[3], const double e[3], double out[3]))
{
  angular_momentum({axial, transverse}, Vec3::from(w), Vec3::from(e)).to(out);
}
EXPORT(void, ring_velocity,
       (double axial, double transverse, const double L[3], const double e[3], double out[3]))
{
  angular_velocity({axial, transverse}, Vec3::from(L), Vec3::from(e)).to(out);
}
EXPORT(void, ring_drift,
       (double axial, double transverse, const double L[3], const double e[3], double h,
        double out[3]))
{
  drift_axis({axial, transverse}, Vec3::from(L), Vec3::from(e), h).to(out);
}

// ---- step_limit.h
EXPORT(double, largest_step, (double k, double c, double m)) { return verlet_step_limit(k, c, m); }

// ---- raceway_law.h and contact.h
EXPORT(RacewayPhysics *, raceway_new, (const RacewayInput *in))
{
  return new RacewayPhysics(raceway_from(*in));
}
EXPORT(void, raceway_delete, (RacewayPhysics * p)) { delete p; }

EXPORT(void, start_rotation,
       (const RacewayPhysics *inner, const RacewayPhysics *outer, double radius, double mass,
        double path, double orbit, double inner_speed, double outer_speed, double thrust,
        double angle, Start *out))
{
  const BallRotation r = start_rotation(
      *inner, *outer, {radius, mass, path, orbit, inner_speed, outer_speed, thrust, angle});
  *out = {r.orbit, r.radial, r.axial, {r.spin[0], r.spin[1]}};
}

EXPORT(void, raceway_derived, (const RacewayPhysics *p, Derived *out))
{
  const auto &spring = p->of<TangentialSpringPart>();
  *out = {p->centre_circle,     p->slack,
          p->largest_overlap,   p->roughness,
          p->inverse_roughness, p->of<FilmDamperPart>().floor,
          spring.kt_ratio,      spring.ct_factor,
          p->material.Eprime()};
}
EXPORT(void, raceway_exact,
       (const RacewayPhysics *p, double pitch_radius, double cos_angle, Constants *out))
{
  put(raceway_constants(p->groove, pitch_radius, p->material, p->model, cos_angle), out);
}
EXPORT(void, raceway_table, (const RacewayPhysics *p, double cos_angle, Constants *out))
{
  put(p->law.at(cos_angle), out);
}
EXPORT(void, raceway_radial, (const RacewayPhysics *p, Constants *out))
{
  put(p->law.radial(), out);
}

// If there is no contact (overlap <= 0), touch() does not set the frame, so it is set here.
EXPORT(double, contact_touch,
       (const RacewayPhysics *p, const double d[3], const double e[3], State *state))
{
  ContactState c;
  const bool touching = touch(*p, Vec3::from(d), Vec3::from(e), c);
  if (!touching) {
    static_cast<GroovePosition &>(c) = locate(Vec3::from(d), Vec3::from(e), p->centre_circle);
    c.overlap = c.s - p->slack;
  }
  put(c, state);
  return touching;
}

// xi is updated.
EXPORT(void, contact,
       (const RacewayPhysics *p, double with_film, const BallMotion *ball, const RingMotion *ring,
        double dt, double xi[2], State *state, Forces *forces))
{
  const BallState b{Vec3::from(ball->x), Vec3::from(ball->v), Vec3::from(ball->w)};
  const RingState r{Vec3::from(ring->x), Vec3::from(ring->v), Vec3::from(ring->w),
                    Vec3::from(ring->e)};
  ContactState c;
  touch(*p, b.x - r.x, r.e, c);
  const unsigned film = initial_parts(true) & ~initial_parts(false);
  const unsigned parts = with_film != 0.0 ? p->parts | film : p->parts & ~film;
  ContactForces f;
  with_parts(parts, [&](const auto &law) {
    double after[most_states] = {xi[0], xi[1]};
    approach(law, *p, b, r, c);
    law.act(*p, p->law.at(c.cos_angle), LawStates<double>{dt, xi, after}, c);
    f = assemble<std::decay_t<decltype(law)>::couples>(*p, r.e, c);
    std::copy(after, after + 2, xi);
  });
  put(c, state);
  f.force.to(forces->force);
  f.ball_torque.to(forces->ball_torque);
  f.ring_torque.to(forces->ring_torque);
}
