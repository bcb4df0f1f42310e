// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the heat transfer in a bearing (heat.h), the network of its nodes (heat_network.h) and
// the jumps of their temperatures (heat_jumps.h).
#include "../geometry/ball_material.h"
#include "../geometry/ring_capacity.h"
#include "../laws/heat_jumps.h"
#include "exports.h"

#include <cstring>

using namespace raceway;

RECORD(SteelOfBearings, double conductivity, density, heat, expansion;)
RECORD(MaterialOfBalls, double young, poisson, density, expansion, heat_capacity, conductivity;)
// The nodes are the inner ring, the balls, the outer ring and the housing. The first three are
// wetted by oil.
RECORD(HeatNetworkOf, double capacity[4];
       double inner, outer, shaft, seat, housing, ambient, flow, inlet, convection, wetted[3];)
RECORD(WettedSurfacesOf, double inner, balls, outer;)
RECORD(HeatControlOf, double change, error, until, steady, hottest, share, both_ends;)
RECORD(HeatStateOf, double time, at[4], law[4], length, start_heat[5], start_inner, start_outer,
       start_convection, jumps, booked, carried, correction, slope, gain, seen, oil_before,
       power_before, alarms, alarm, end;)
static_assert(sizeof(HeatStateOf) == sizeof(HeatState), "the record of HeatState");

namespace {
HeatNetwork network(const HeatNetworkOf &of)
{
  HeatNetwork net;
  std::copy_n(of.capacity, heat_nodes, net.capacity);
  net.inner = of.inner;
  net.outer = of.outer;
  net.shaft = of.shaft;
  net.seat = of.seat;
  net.housing = of.housing;
  net.ambient = of.ambient;
  net.oil.flow = of.flow;
  net.oil.inlet = of.inlet;
  net.oil.convection = of.convection;
  std::copy_n(of.wetted, OilFlow::surfaces, net.oil.wetted);
  return net;
}
}    // namespace

FORMULA(SteelOfBearings, steel_of_bearings, ())
{
  return {steel_conductivity, steel_density, steel_heat, steel_expansion};
}

FORMULA(MaterialOfBalls, silicon_nitride, ())
{
  const BallMaterial &of = raceway::silicon_nitride;
  return {of.young, of.poisson, of.density, of.expansion, of.heat_capacity, of.conductivity};
}

// Returns the effusivity of the balls divided by that of the rings.
FORMULA(double, effusivity_of_balls, (double conductivity, double density, double heat_capacity))
{
  return effusivity_of_balls(conductivity, density, heat_capacity);
}

// Returns the fraction of the heat generated in a contact that enters the ball.
FORMULA(double, heat_share_of_balls, (double effusivity)) { return BallHeat{effusivity}.share(); }

FORMULA(double, contact_conductance, (double a, double b, double speed, double effusivity))
{
  return contact_conductance(a, b, speed, {effusivity});
}

FORMULA(double, iso_15312_conductance, (double bore, double outside, double width))
{
  return iso_15312_conductance(bore, outside, width);
}

// Returns the heat capacity (J/K) of a ring, given the radii of raceway and groove, the diameters
// of seat and shoulder, and the width (all in m).
FORMULA(double, ring_capacity,
        (bool inner, double raceway_radius, double groove_radius, double seat, double shoulder,
         double width))
{
  Groove groove;
  groove.side = inner ? Side::inner : Side::outer;
  groove.raceway_radius = raceway_radius;
  groove.groove_radius = groove_radius;
  return ring_capacity(groove, seat, shoulder, width);
}

FORMULA(double, clearance_change,
        (double inner_radius, double outer_radius, double ball_radius, double inner, double balls,
         double outer, double ball_expansion))
{
  return clearance_change(inner_radius, outer_radius, ball_radius, inner, balls, outer,
                          {1.0, ball_expansion / steel_expansion});
}

// Returns the heat transfer coefficient of flowing oil in W/(m^2 K).
FORMULA(double, oil_convection,
        (double conductivity, double heat_capacity, double density, double viscosity, double orbit,
         double pitch_diameter))
{
  return oil_convection(conductivity, heat_capacity, density, viscosity, orbit, pitch_diameter);
}

FORMULA(WettedSurfacesOf, wetted_surfaces,
        (double inner_radius, double outer_radius, double ball_radius, double balls, double width))
{
  const WettedSurfaces of = wetted_surfaces(inner_radius, outer_radius, ball_radius, balls, width);
  return {of.inner, of.balls, of.outer};
}

// Returns the outlet temperature (C) of the oil if `heat` (W) is generated in the oil and the
// surfaces have the temperatures `surface` (C).
EXPORT(double, oil_outlet, (const HeatNetworkOf *net, const double surface[3], double heat))
{
  return network(*net).oil.outlet(surface, heat);
}

// Computes the heat flows (W) into the nodes and the oil from losses (W), see add_losses.
EXPORT(void, heat_of_losses,
       (double inner, double outer, double balls, double drag, double share, bool flows,
        double heat[5]))
{
  std::fill_n(heat, heat_inputs, 0.0);
  add_losses(heat, {inner, outer, balls, drag}, share, flows);
}

// Computes the temperatures (C) after `time` seconds. The heat (W) into each node and into the oil
// varies linearly from `heat` to `end`. Returns the heat (J) that is carried away.
EXPORT(double, heat_advance,
       (const HeatNetworkOf *net, const double heat[5], const double end[5], const double from[4],
        double time, double to[4]))
{
  return HeatFlow(network(*net), heat, end, time).advance(from, time, to);
}

// Computes the temperatures (C) of the steady state. Returns the slowest time constant (s).
EXPORT(double, heat_steady, (const HeatNetworkOf *net, const double heat[5], double to[4]))
{
  const HeatFlow flow(network(*net), heat);
  flow.steady(to);
  return flow.slowest();
}

// Completes the current jump and starts the next one. The arguments are the mean losses (W) in the
// nodes and the oil during a ball pass, the conductances of the contacts (W/K), and the heat
// transfer coefficient of the oil (W/(m^2 K)).
EXPORT(void, heat_jump,
       (HeatStateOf * state, const double heat[5], double inner, double outer, double convection,
        const HeatNetworkOf *net, const HeatControlOf *control))
{
  HeatState now;
  std::memcpy(static_cast<void *>(&now), state, sizeof now);
  HeatPass pass;
  std::copy_n(heat, heat_inputs, pass.heat);
  pass.inner = inner;
  pass.outer = outer;
  pass.convection = convection;
  HeatControl c;
  c.change = control->change;
  c.error = control->error;
  c.until = control->until;
  c.steady = control->steady;
  c.hottest = control->hottest;
  c.share = control->share;
  c.both_ends = control->both_ends != 0.0;
  heat_jump(now, pass, network(*net), c);
  std::memcpy(static_cast<void *>(state), &now, sizeof now);
}
