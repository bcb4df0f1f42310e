# SPDX-License-Identifier: GPL-2.0-or-later
"""Temperatures of a bearing: cooling, heat balance with one node or with separate nodes for rings
and balls, clearance as a function of temperature, and flash temperature. All values are in SI
units, except that temperatures are in degrees C.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq

from raceway.arrays import Floats, Numbers
from raceway.core import laws, library
from raceway.theory import makers
from raceway.theory.ball_material import STEEL as STEEL_BALLS
from raceway.theory.bearing import Bearing
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication
from raceway.theory.static import Equilibrium

RISE = 50.0  # K, temperature rise over ambient at the reference conditions of ISO 15312
REFERENCE_VISCOSITY = 12.0  # mm^2/s at 70 C, ISO 15312


def cooling(bore: float, outside: float, width: float) -> float:
    """Return W_s = q_r pi B (D + d)/50 K in W/K (ISO 15312), the conductance from a radial bearing
    with these dimensions (mm) to ambient, through its seats and the housing, at the reference
    conditions."""
    return float(laws.iso_15312_conductance(1e-3 * bore, 1e-3 * outside, 1e-3 * width))


def balance(
    power: Callable[[float], float],
    conductance: float,
    ambient: float = 20.0,
    hottest: float = 200.0,
    tolerance: float = 1e-6,
    coldest: float | None = None,
) -> float:
    """Find the temperature in degrees C, to within `tolerance`, at which `power`(T) in W equals
    `conductance` in W/K times T - T_a, between `coldest` (by default ambient) and `hottest`.

    Raises `ValueError` if the bearing is still warming up at `hottest`. There is exactly one such
    temperature if the power decreases with temperature, as it does with every oil.
    """

    def surplus(temperature):
        return power(temperature) - conductance * (temperature - ambient)

    if surplus(hottest) > 0:
        raise ValueError(
            f"power loss {power(hottest):g} W at {hottest:g} C exceeds the cooling by "
            f"{conductance:g} W/K to {ambient:g} C"
        )
    low = ambient if coldest is None else min(ambient, coldest)
    return float(brentq(surplus, low, hottest, xtol=tolerance))


class Nodes(NamedTuple):
    """Temperatures of the parts of a bearing in degrees C."""

    inner: float
    balls: float
    outer: float


class OilFlow(NamedTuple):
    """Oil that flows through a bearing and carries heat away."""

    flow: float  # W/K, mass flow times heat capacity
    inlet: float  # degrees C
    wetted: tuple[float, float, float]  # m^2, areas of inner ring, balls and outer ring
    convection: float  # W/(m^2 K)


STILL = OilFlow(0.0, 20.0, (0.0, 0.0, 0.0), 0.0)


def network(
    capacity: Sequence[float] = (1.0, 1.0, 1.0, 0.0),
    *,
    contacts: tuple[float, float],
    shaft: float = 0.0,
    seat: float = 0.0,
    housing: float = 0.0,
    ambient: float = 20.0,
    oil: OilFlow = STILL,
) -> dict[str, Any]:
    """Return the heat network of a bearing, to be passed to `steady` and `advance`. `capacity`
    contains the heat capacities in J/K of inner ring, balls, outer ring and housing (0: no
    housing). Conductances are in W/K: `contacts` from each ring to all balls (inner, outer),
    `shaft` from the inner ring to ambient, `seat` from the outer ring to the housing (0: no thermal
    resistance), and `housing` from the housing to ambient. `ambient` is in degrees C. `oil` flows
    between inner ring, balls and outer ring."""
    inner, outer = contacts
    return dict(
        capacity=capacity,
        inner=inner,
        outer=outer,
        shaft=shaft,
        seat=seat,
        housing=housing,
        ambient=ambient,
        **oil._asdict(),
    )


def advance(
    of: Mapping[str, Any],
    heat: ArrayLike,
    start: ArrayLike,
    time: float,
    end: ArrayLike | None = None,
) -> tuple[float, Floats]:
    """Return the heat in J carried away and the temperatures (4,) in degrees C of a `network` at
    `time` seconds after it had the temperatures `start`. The `heat` in W into the nodes and the oil
    (5,) is either constant or varies linearly to `end`. The solution is exact."""
    return library().call(
        "heat_advance",
        net=of,
        heat=heat,
        end=heat if end is None else end,
        **{"from": start},
        time=time,
    )


def steady(of: Mapping[str, Any], heat: ArrayLike) -> tuple[float, Floats]:
    """Return the slowest time constant in s and the steady temperatures (4,) in degrees C of a
    `network` with the `heat` in W into its nodes and the oil (5,)."""
    return library().call("heat_steady", net=of, heat=heat)


def outlet(of: Mapping[str, Any], surfaces: ArrayLike, heat: float = 0.0) -> float:
    """Return the temperature in degrees C of the oil that leaves a `network` in which inner ring,
    balls and outer ring are at the temperatures `surfaces` (3,), and in which `heat` in W is
    generated in the oil."""
    return library().call("oil_outlet", net=of, surface=surfaces, heat=heat)


def conductances(
    state: Equilibrium, films: Lubrication, effusivity: float = 1.0
) -> tuple[float, float]:
    """Return the conductances in W/K from the inner ring and from the outer ring to all balls
    through the moving contacts. Each contact contributes 0.874 2a sqrt(2 k rho c b u/pi) between
    balls and rings of steel; `effusivity` is that of the balls divided by that of the rings."""
    sides = ((state.inner, films.inner), (state.outer, films.outer))
    return tuple(
        float(laws.contact_conductance(at.a, at.b, film.entrainment, effusivity)[at.load > 0].sum())
        for at, film in sides
    )


def oil_flow(
    bearing: Bearing, width: float, fluid: Fluid, flow: float, inlet: float, orbit: float
) -> OilFlow:
    """Return the `OilFlow` through a bearing whose `width` over all rows is in m. `flow` is the
    mass flow times heat capacity in W/K, `inlet` is the temperature of the incoming oil in degrees
    C, and `orbit` is the speed of the balls around the bearing in rad/s."""
    radii = bearing.inner_radius, bearing.outer_radius, bearing.ball_radius
    balls = bearing.balls * len(bearing.layout.rows)
    wetted = laws.wetted_surfaces(*radii, balls, width)
    convection = laws.oil_convection(
        fluid.conductivity,
        fluid.heat_capacity,
        fluid.density,
        fluid.viscosity,
        orbit,
        bearing.inner_radius + bearing.outer_radius,
    )
    return OilFlow(flow, inlet, tuple(float(one) for one in wetted), float(convection))


def into_nodes(
    inner: float,
    outer: float,
    balls: float = 0.0,
    drag: float = 0.0,
    *,
    flows: bool = False,
    share: float = 0.5,
) -> Floats:
    """Return the heat in W into the nodes and the oil (5,) of a `network`. The fraction `share` of
    the power dissipated at each raceway heats the balls, and the rest heats the ring. Losses at the
    `balls` alone are added. The `drag` heats the oil if it `flows`; otherwise half of it heats the
    balls and a quarter each ring."""
    return library().call(
        "heat_of_losses",
        inner=inner, outer=outer, balls=balls, drag=drag, share=share, flows=flows,
    )  # fmt: skip


def three_nodes(
    inner: float,
    outer: float,
    *,
    shaft: float,
    housing: float,
    contact: float | tuple[float, float],
    ambient: float = 20.0,
    balls: float = 0.0,
    drag: float = 0.0,
    flow: OilFlow = STILL,
    share: float = 0.5,
) -> Nodes:
    """Return the `Nodes` in the steady state for the losses in W of `into_nodes` and the oil of a
    `flow`.

    Conductances are in W/K: `shaft` from the inner ring to ambient, `housing` from the outer ring
    to ambient, and `contact` from a ring to all balls, which may be a pair of values for the inner
    and the outer ring.
    """
    contacts = contact if isinstance(contact, tuple) else (contact, contact)
    of = network(contacts=contacts, shaft=shaft, housing=housing, ambient=ambient, oil=flow)
    losses = into_nodes(inner, outer, balls, drag, flows=flow.flow > 0, share=share)
    return Nodes(*steady(of, losses)[1][:3].tolist())


def clearance_change(
    bearing: Bearing,
    inner: Numbers,
    balls: Numbers,
    outer: Numbers,
    expansion: float = STEEL_BALLS.expansion,
) -> Numbers:
    """Return the change in the diametral clearance in m for temperature rises in K of inner ring,
    balls and outer ring, -12e-6 (D_i dT_i + 2 D_w dT_b - D_e dT_e) if the `expansion` of the balls
    (1/K) is that of steel."""
    radii = bearing.inner_radius, bearing.outer_radius, bearing.ball_radius
    return laws.clearance_change(*radii, inner, balls, outer, expansion)


def flash(flux: Numbers, b: Numbers, speed: Numbers) -> Numbers:
    """Return the temperature rise 1.128 q sqrt(2b/(k rho c u)) in K of a surface under a heat
    `flux` q in W/m^2, where b is the semi-axis along rolling in m and u = `speed` is in m/s (Blok,
    Jaeger)."""
    steel = laws.steel_of_bearings()
    conductor = float(steel.conductivity * steel.density * steel.heat)
    return 1.128 * flux * np.sqrt(2 * b / (conductor * speed))


def reference_speed(boundary: makers.Boundary, level: float = 0.0) -> float:
    """Return the thermal reference speed in rpm, at which the friction loss by SKF's formula under
    the conditions of ISO 15312 (F_r = 0.05 C0, 12 mm^2/s) equals the cooling at 50 K.

    `level` is the level of the oil bath in mm, 0 if there is none. ISO 15312 assumes oil up to the
    middle of the lowest ball (from memory, unchecked). Raises `ValueError` if there is no such
    speed.
    """

    def surplus(speed):
        torque = makers.skf(
            boundary, 0.05 * boundary.static_rating, 0.0, speed, REFERENCE_VISCOSITY, level=level
        )
        return 1e-3 * torque.total * speed * np.pi / 30 - carried

    carried = cooling(boundary.bore, boundary.outside, boundary.width) * RISE
    speeds = np.geomspace(100, 3e5, 200)
    above: Floats = np.flatnonzero([surplus(speed) > 0 for speed in speeds])
    if not len(above) or above[0] == 0:
        raise ValueError("no speed from 100 to 300000 rpm balances friction and cooling")
    return float(brentq(surplus, speeds[above[0] - 1], speeds[above[0]], xtol=1e-3))
