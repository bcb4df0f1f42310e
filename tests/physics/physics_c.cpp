// SPDX-License-Identifier: GPL-2.0-or-later
// The physics headers behind a C interface, for the tests in this folder (called through
// physics_c.py). Every number, choices included, is a double; out arrays are filled in the order
// written beside them.
#include "../../src-package/physics/capacitance.h"
#include "../../src-package/physics/contact.h"
#include "../../src-package/physics/damped_hertz.h"
#include "../../src-package/physics/rail.h"
#include "../../src-package/physics/ring_body.h"
#include "../../src-package/physics/rolling.h"
#include "../../src-package/physics/step_limit.h"

#include <algorithm>

using namespace raceway;

// One raceway as the tests describe it; physics_c.py names the same fields in the same order.
struct RacewayInput {
  double side, raceway_radius, groove_radius, ball_radius;
  double ball_young, ball_poisson, ring_young, ring_poisson;
  double ellipse, film, viscosity, pressure_viscosity, damper_full_axis, damper_rolling_radius;
  double friction, mu, mu_boundary, mu_full, lambda_1, lambda_2;
  double hysteresis, ring_roughness, ball_roughness, film_floor, tangential_ratio, tangential_zeta;
  double pitch_radius, ball_mass, overlap_limit;
};

static RacewayPhysics raceway_from(const RacewayInput &in)
{
  RacewayPhysics p;
  p.groove = {Side(int(in.side)), in.raceway_radius, in.groove_radius, in.ball_radius};
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

// K a b p, minimum and central lnA p m, film_damper
static void put(const RacewayConstants &c, double *out)
{
  const double values[] = {c.K,
                           c.a,
                           c.b,
                           c.p,
                           c.film.min.lnA,
                           c.film.min.p,
                           c.film.min.m,
                           c.film.central.lnA,
                           c.film.central.p,
                           c.film.central.m,
                           c.film_damper};
  for (double v : values) *out++ = v;
}

// u t r z nu ne overlap root cos_angle overlap_rate load stiffness damping normal entrainment
// sliding_t sliding_w h_min lambda mu kt ct friction_t friction_w
static void put(const ContactState &c, double *out)
{
  c.u.to(out);
  c.t.to(out + 3);
  const double values[] = {c.r,          c.z,         c.nu,           c.ne,        c.overlap,
                           c.root,       c.cos_angle, c.overlap_rate, c.load,      c.stiffness,
                           c.damping,    c.normal,    c.entrainment,  c.sliding_t, c.sliding_w,
                           c.h_min,      c.lambda,    c.mu,           c.kt,        c.ct,
                           c.friction_t, c.friction_w};
  out += 6;
  for (double v : values) *out++ = v;
}

extern "C" {

// logarithm or exponential of n numbers, one by one and four side by side
void elementary(double exponential_wanted, double n, const double *x, double *one, double *four)
{
  const int count = int(n);
  for (int i = 0; i < count; ++i)
    one[i] = exponential_wanted != 0.0 ? exponential(x[i]) : logarithm(x[i]);
  for (int i = 0; i < count; i += lanes) {
    Lane v = all_lanes(1.0);
    for (int k = 0; k < lanes && i + k < count; ++k) v[k] = x[i + k];
    v = exponential_wanted != 0.0 ? exponential(v) : logarithm(v);
    for (int k = 0; k < lanes && i + k < count; ++k) four[i + k] = v[k];
  }
}

// ---- vec3.h
// -----------------------------------------------------------------------------------------
void vec3_cross(const double *a, const double *b, double *out)
{
  cross(Vec3::from(a), Vec3::from(b)).to(out);
}
double vec3_dot(const double *a, const double *b) { return dot(Vec3::from(a), Vec3::from(b)); }
double vec3_norm(const double *a) { return norm(Vec3::from(a)); }
void vec3_rotate(const double *a, const double *w, double *out)
{
  rotate(Vec3::from(a), Vec3::from(w)).to(out);
}

// a + b, a - b, s a, a s, -a, a += b, a -= b, and b added to the numbers of a
void vec3_algebra(const double *pa, const double *pb, double s, double *out)
{
  const Vec3 a = Vec3::from(pa), b = Vec3::from(pb);
  Vec3 plus = a, minus = a;
  plus += b;
  minus -= b;
  const Vec3 results[] = {a + b, a - b, s * a, a * s, -a, plus, minus};
  for (const Vec3 &r : results) {
    r.to(out);
    out += 3;
  }
  a.to(out);
  b.add_to(out);
}

// ---- elliptic.h: K E D
// -------------------------------------------------------------------------------
void elliptic(double m1, double *out)
{
  const EllipticIntegrals v = complete_elliptic(m1);
  out[0] = v.K;
  out[1] = v.E;
  out[2] = v.D;
}

// ---- hertz.h
// ----------------------------------------------------------------------------------------- kappa
// Ebar Fbar R K a b p
void hertz(double Rx, double Ry, double Eprime, double form, double *out)
{
  const HertzContact h = hertz_contact(Rx, Ry, Eprime, Ellipse(int(form)));
  const double values[] = {
      h.ellipse.kappa, h.ellipse.Ebar, h.ellipse.Fbar, h.R, h.K, h.a, h.b, h.p};
  for (double v : values) *out++ = v;
}
double modulus(double E1, double nu1, double E2, double nu2)
{
  return reduced_modulus(E1, nu1, E2, nu2);
}
void radii(double ball, double groove, double pitch, double inner, double cos_angle, double *out)
{
  const EffectiveRadii r = groove_radii(ball, groove, pitch, inner != 0.0, cos_angle);
  out[0] = r.x;
  out[1] = r.y;
}
double sphere(double R1, double R2, double Eprime) { return sphere_stiffness(R1, R2, Eprime); }
double mindlin(double E1, double nu1, double E2, double nu2)
{
  return raceway::tangential_ratio(E1, nu1, E2, nu2);
}

// ---- film.h
// ------------------------------------------------------------------------------------------
// minimum lnA p m, central lnA p m
void film(double model, double kappa, double viscosity, double xi, double Eprime, double Rx,
          double *out)
{
  const FilmPair f = film_laws(FilmModel(int(model)), kappa, {viscosity, xi}, Eprime, Rx);
  const double values[] = {f.min.lnA, f.min.p, f.min.m, f.central.lnA, f.central.p, f.central.m};
  for (double v : values) *out++ = v;
}
double thickness(double lnA, double p, double m, double speed, double load)
{
  return film_thickness({lnA, p, m}, film_point(speed, load));
}
double roughness(double s1, double s2) { return composite_roughness(s1, s2); }

// ---- damping.h
// ---------------------------------------------------------------------------------------
double damper_prefactor(double viscosity, double radius, double length_factor)
{
  return film_damping_prefactor(viscosity, radius, length_factor);
}
double film_damper(double prefactor, double a, double h, double floor)
{
  return film_damping(prefactor, a, h, floor);
}
double hysteretic(double alpha_e, double load) { return hysteretic_damping(alpha_e, load); }

// ---- friction.h
// --------------------------------------------------------------------------------------
double friction_coefficient(double mu_boundary, double mu_full, double lambda_1, double lambda_2,
                            double lambda)
{
  return stribeck({mu_boundary, mu_full, lambda_1, lambda_2}, lambda);
}
double friction_regime(double lambda_1, double lambda_2, double lambda)
{
  return regime({0.0, 0.0, lambda_1, lambda_2}, lambda);
}
// xi is updated; out: ft fw
void friction_spring(double k, double c, double cap, double vt, double vw, double *xi, double *out)
{
  tangential_force({k, c}, cap, vt, vw, xi, out[0], out[1]);
}

// ---- groove.h
// ----------------------------------------------------------------------------------------
double groove_circle(double side, double raceway_radius, double groove, double ball)
{
  return Groove{Side(int(side)), raceway_radius, groove, ball}.centre_circle();
}
double groove_slack(double groove, double ball)
{
  return Groove{Side::inner, 0.0, groove, ball}.slack();
}
// u t r z s nu ne
void groove_locate(const double *d, const double *e, double centre_circle, double *out)
{
  const GroovePosition g = locate(Vec3::from(d), Vec3::from(e), centre_circle);
  g.u.to(out);
  g.t.to(out + 3);
  const double values[] = {g.r, g.z, g.s, g.nu, g.ne};
  out += 6;
  for (double v : values) *out++ = v;
}

// ---- capacitance.h
// -----------------------------------------------------------------------------------
double oil_density(double p) { return density_ratio(p); }
double permittivity(double ambient, double p) { return permittivity_at(ambient, p); }
double plate_capacitance(double eps_r, double a, double b, double h)
{
  return contact_capacitance(eps_r, a, b, h);
}
double ball_capacitance(double inner, double outer) { return series_capacitance(inner, outer); }

// ---- damped_hertz.h: stiffness damping force
// ---------------------------------------------------------
void cage_contact(double K, double overlap, double rate, double m, double *out)
{
  const DampedHertz h = damped_hertz(K, overlap, rate, m);
  out[0] = h.stiffness;
  out[1] = h.damping;
  out[2] = h.force;
}

// ---- rail.h: circle tube offset
// ----------------------------------------------------------------------
void rail_seat(double pitch, double ball, double tube, double gap, double sign, double *out)
{
  const Rail r = seat_rail(pitch, ball, tube, gap, sign);
  out[0] = r.circle;
  out[1] = r.tube;
  out[2] = r.offset;
}
double rail_spring(const double *rail, double ball, double pitch, double Eprime)
{
  return rail_stiffness({rail[0], rail[1], rail[2]}, ball, pitch, Eprime);
}

// ---- ring_body.h
// -------------------------------------------------------------------------------------
void ring_momentum(double axial, double transverse, const double *w, const double *e, double *out)
{
  angular_momentum({axial, transverse}, Vec3::from(w), Vec3::from(e)).to(out);
}
void ring_velocity(double axial, double transverse, const double *L, const double *e, double *out)
{
  angular_velocity({axial, transverse}, Vec3::from(L), Vec3::from(e)).to(out);
}
void ring_drift(double axial, double transverse, const double *L, const double *e, double h,
                double *out)
{
  drift_axis({axial, transverse}, Vec3::from(L), Vec3::from(e), h).to(out);
}

// ---- rolling.h: orbit spin
// ---------------------------------------------------------------------------
void rolling(double ball, double pitch, double inner_speed, double outer_speed, double *out)
{
  const Rolling r = pure_rolling(ball, pitch, inner_speed, outer_speed);
  out[0] = r.orbit;
  out[1] = r.spin;
}

// ---- step_limit.h
// ------------------------------------------------------------------------------------
double largest_step(double k, double c, double m) { return verlet_step_limit(k, c, m); }

// ---- raceway_law.h and contact.h
// ---------------------------------------------------------------------
double raceway_input_size() { return sizeof(RacewayInput) / sizeof(double); }
RacewayPhysics *raceway_new(const RacewayInput *in)
{
  return new RacewayPhysics(raceway_from(*in));
}
void raceway_delete(RacewayPhysics *p) { delete p; }

// centre_circle slack largest_overlap roughness inverse_roughness floor kt_ratio ct_factor Eprime
void raceway_derived(const RacewayPhysics *p, double *out)
{
  const double values[] = {p->centre_circle,
                           p->slack,
                           p->largest_overlap,
                           p->roughness,
                           p->inverse_roughness,
                           p->of<FilmDamperPart>().floor,
                           p->of<TangentialSpringPart>().kt_ratio,
                           p->of<TangentialSpringPart>().ct_factor,
                           p->material.Eprime()};
  for (double v : values) *out++ = v;
}
void raceway_exact(const RacewayPhysics *p, double pitch_radius, double cos_angle, double *out)
{
  put(raceway_constants(p->groove, pitch_radius, p->material, p->model, cos_angle), out);
}
void raceway_table(const RacewayPhysics *p, double cos_angle, double *out)
{
  put(p->law.at(cos_angle), out);
}
void raceway_radial(const RacewayPhysics *p, double *out) { put(p->law.radial(), out); }

// Where there is no contact touch() leaves the frame unset; then it is filled in here, overlap <=
// 0.
double contact_touch(const RacewayPhysics *p, const double *d, const double *e, double *state)
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

// ball: x v w; ring: x v w e; xi (2) is updated; state as put() above; forces: force, ball and ring
// torque.
void contact(const RacewayPhysics *p, double with_film, const double *ball, const double *ring,
             double dt, double *xi, double *state, double *forces)
{
  const BallState b{Vec3::from(ball), Vec3::from(ball + 3), Vec3::from(ball + 6)};
  const RingState r{Vec3::from(ring), Vec3::from(ring + 3), Vec3::from(ring + 6),
                    Vec3::from(ring + 9)};
  ContactState c;
  touch(*p, b.x - r.x, r.e, c);
  const unsigned film = lubricated_parts & ~dry_parts;
  const unsigned parts = with_film != 0.0 ? p->parts | film : p->parts & ~film;
  ContactForces f;
  with_law(parts, [&](auto law) {
    using L = decltype(law);
    double after[most_states] = {xi[0], xi[1]};
    f = contact_forces<L>(*p, b, r, LawStates<double>{dt, xi, after}, c);
    std::copy(after, after + 2, xi);
  });
  put(c, state);
  f.force.to(forces);
  f.ball_torque.to(forces + 3);
  f.ring_torque.to(forces + 6);
}

}    // extern "C"
