// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the laws of damping, mixed friction, slip, spin, rolling resistance and drag for a single
// contact.
#include "../laws/asperities.h"
#include "../laws/ball_drag.h"
#include "../laws/damping.h"
#include "../laws/differential_slip.h"
#include "../laws/film_traction.h"
#include "../laws/friction.h"
#include "../laws/lubrication.h"
#include "../laws/rolling_inlet.h"
#include "../laws/rolling_resistance.h"
#include "../laws/slip_slices.h"
#include "../laws/spin.h"
#include "../laws/start_attitude.h"
#include "exports.h"

using namespace raceway;

// ---- damping
FORMULA(double, hysteretic_damping, (double alpha, double load))
{
  return hysteretic_damping(alpha, load);
}

FORMULA(double, film_damping,
        (double viscosity, double length, double radius, double h, double floor))
{
  return film_damping(film_damping_prefactor(viscosity, radius, 1.0), length, h, floor);
}

// ---- mixed friction
FORMULA(double, asperity_share, (double ratio, double b, double c))
{
  return asperity_share(Asperities{b, c}, logarithm(ratio));
}

FORMULA(double, complementary_error, (double x)) { return complementary_error(x); }

FORMULA(double, mixed_friction, (double boundary, double film, double share))
{
  return mixed_friction(boundary, film, share);
}

FORMULA(double, stribeck,
        (double mu_boundary, double mu_full, double lambda_1, double lambda_2, double ratio))
{
  return stribeck({mu_boundary, mu_full, lambda_1, lambda_2}, ratio);
}

FORMULA(double, film_regime, (double lambda_1, double lambda_2, double ratio))
{
  return regime({0.0, 0.0, lambda_1, lambda_2}, ratio);
}

// `rate` is s/h in 1/s and must not be negative.
FORMULA(double, eyring_shear, (double viscosity, double rate, double stress, double limit))
{
  return eyring_shear(stress, viscosity * rate / stress, limit);
}

FORMULA(double, roelands, (double viscosity, double pressure_viscosity, double pressure))
{
  return viscosity * exponential(Roelands({viscosity, pressure_viscosity}).ln_rise(pressure));
}

FORMULA(double, film_coefficient,
        (double viscosity, double pressure_viscosity, double stress, double limit, double pressure,
         double rate))
{
  FilmTraction f;
  f.stress = stress;
  f.limit = limit;
  f.prepare({viscosity, pressure_viscosity});
  return f.coefficient(pressure, logarithm(rate));
}

// ---- differential slip
RECORD(SlipConstants, double free_root, free_speed, free_lean;)
FORMULA(SlipConstants, slip_constants, ()) { return {free_root, free_speed, free_lean}; }

FORMULA(double, deformed_radius, (double groove, double ball))
{
  return deformed_radius(groove, ball);
}

FORMULA(double, edge_slip, (double speed, double a, double r_d, double r_x))
{
  return edge_slip(speed, a, r_d, r_x);
}

// Returns the forces divided by mu Q, and the couple divided by mu Q a^2/(2 R_d). `off` is the slip
// relative to free rolling, divided by s_e.
RECORD(SlipLaw, double root, secant, force, couple;)
FORMULA(SlipLaw, differential_slip, (double off))
{
  const double root = slip_root(off);
  return {root, slip_secant(off), slip_force(off), slip_couple(root)};
}

// Returns the forces divided by mu Q, and the couple divided by mu Q a^2/(2 R_d), for sliding in
// both directions. `along` is relative to free rolling; both are divided by s_e.
RECORD(SlipOfBoth, double along, across, couple;)
FORMULA(SlipOfBoth, slip_both_ways, (double along, double across))
{
  const SlipBothWays<double> law = slip_both_ways(along, across, 1.0);
  const double f = along / law.speed_along, g = across / law.speed_across, size2 = f * f + g * g;
  const double share = size2 > 1.0 ? 1.0 / std::sqrt(size2) : 1.0;
  return {f * share, g * share, slip_couple(force_root(f * share * law.sharing))};
}

// Returns t0 for a force divided by mu Q.
FORMULA(double, slip_root_of_force, (double force)) { return force_root(force); }

// Returns the factors by which the couples of pure spin and of differential slip are multiplied if
// both act, as functions of the speed omega a, the width s_e and the sliding speed (m/s).
RECORD(SpinShares, double spin, slip;)
FORMULA(SpinShares, spin_shares, (double speed, double width, double slide))
{
  return {speed / spin_growth(speed, width, slide), slip_beside_spin(speed, width)};
}

FORMULA(double, pure_spin_couple, (double limit, double a, double second))
{
  return pure_spin_couple(limit, a, second);
}

RECORD(SlidingForces, double along, across, moment, couple, slope_along, slope_across, slope_moment,
       slope_couple;)
FORMULA(SlidingForces, slip_slices,
        (double along, double across, double spin, double edge, double aspect, double least))
{
  const SlipMotionT<double> motion = {along, across, spin, edge, aspect, least};
  const auto f = SlipSlices::forces<true>(motion);
  return {f.along,       f.across,       f.moment,       f.couple,
          f.slope_along, f.slope_across, f.slope_moment, f.slope_couple};
}

// Returns the motion of a ball that rolls on both raceways, given the contact angles (rad), the
// speed `ring` of the inner ring (rad/s), the radii `ball` and `pitch` (m) and the radial component
// of the ball's rotation (rad/s). All results are in rad/s.
RECORD(RollingBall, double orbit, axial, spin_inner, spin_outer;)
FORMULA(RollingBall, rolling_on_both,
        (double inner, double outer, double ring, double ball, double pitch, double radial))
{
  const BallRotation m = rolling_on_both({inner, ring}, {outer, 0.0}, ball, pitch, radial);
  return {m.orbit, m.axial, m.spin[0], m.spin[1]};
}

// ---- rolling resistance
FORMULA(double, rolling_force,
        (double viscosity, double modulus, double r_x, double r_y, double speed, double load))
{
  const RollingConstants k(viscosity, modulus, r_y);
  return rolling_force(rolling_shape(k, r_x), logarithm(std::fabs(speed)), load, std::cbrt(load));
}

FORMULA(double, rolling_inlet_shear, (double loading))
{
  return rolling_inlet_shear(logarithm(loading));
}

// These two functions return the fraction of the flooded resistance, computed by quadrature (which
// is exact) and by the interpolation that is used in contacts.
FORMULA(double, inlet_share, (double length, double thickness))
{
  return inlet_share(length, thickness);
}

FORMULA(double, rolling_inlet, (double length, double h_c, double b, double r_x))
{
  thread_local RollingInlet of;    // prepared again whenever the length changes
  thread_local double prepared = -1.0;
  if (length != prepared) of.prepare(prepared = length);
  return of.short_inlet ? of.share(h_c, b, r_x) : 1.0;
}

FORMULA(double, hysteresis_couple, (double alpha, double load, double b))
{
  return hysteresis_couple(alpha, load, b);
}

// ---- kinds of lubrication
FORMULA(double, immersed_share, (double level, double pitch))
{
  return immersed_share(level, pitch);
}

RECORD(LubricationNumbers, double inlet, replenishment, share;)
FORMULA(LubricationNumbers, lubrication, (int kind, double level, double pitch, double density))
{
  const Lubrication of = lubrication(static_cast<LubricationKind>(kind), level, pitch, density);
  return {of.inlet, of.replenishment, of.share};
}

// ---- drag
FORMULA(double, drag_coefficient, (double reynolds))
{
  return drag_coefficient(drag_table(), reynolds);
}
