# SPDX-License-Identifier: GPL-2.0-or-later
"""Steady temperature of a bearing, i.e. the temperature at which cooling balances the friction heat
computed from statics, film and friction at that temperature.

With one node, the whole bearing and its oil are at one temperature. With three nodes, the inner
ring, the balls and the outer ring have separate temperatures, the oil is at the mean of these, and
statics uses the clearance of the warm parts. In both cases, oil that flows through the bearing
carries heat away.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from raceway import inputs
from raceway.errors import NoEquilibrium
from raceway.theory import cage_drag, contact_friction, heat, makers, running
from raceway.theory.bearing import INNER, Bearing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubricant import Fluid, Lubricant
from raceway.theory.models import DEFAULT
from raceway.theory.oil_supply import BATH, Supply
from raceway.theory.running import Friction, Running
from raceway.theory.static import STRAIGHT, Equilibrium
from raceway.theory.steel import STEEL
from raceway.theory.thrust_motion import Motion

ENOUGH = 0.01  # K, tolerance of the temperature


@dataclass(frozen=True)
class Nodes:
    """Conductances for `heat.three_nodes` in W/K. If `housing` is None, it is computed by ISO
    15312, and if `contact` is None, from the moving contacts (`heat.conductances`)."""

    shaft: float = 0.0
    housing: float | None = None
    contact: float | None = None


@dataclass(frozen=True)
class CirculatingOil:
    """Oil that flows through a bearing of the given `width` in m. `flow` is the volume flow at 40 C
    in m^3/s, and `inlet` is the inlet temperature in degrees C."""

    flow: float
    inlet: float
    width: float


@dataclass
class Scene:
    """A bearing with its oil and load, for which friction is computed from temperature and
    clearance. `spin_law`, `models` and `cage` are as in `operating_point.figures`, `held` is as in
    `static.equilibrium`, and `size` and `supply` are as in `contact_friction.surfaces`."""

    bearing: Bearing
    lubricant: Lubricant
    roughness: float  # m, composite roughness
    load: float
    axial: float
    rpm: float
    density: float = STEEL.density  # kg/m^3, of the balls
    spin_law: str = "closed"
    models: str = DEFAULT
    held: Mapping[str, float] = field(default_factory=STRAIGHT.copy)
    size: makers.Size | None = None
    supply: Supply = BATH
    cage: cage_drag.CageRing | None = None
    oil_flow: CirculatingOil | None = None
    phase: float = 0.0  # rad, azimuth of the first ball
    share: float = 1.0  # factor on the computed friction, set by `by_runs`
    # the last equilibrium and the last motion under thrust, where the next search begins
    near: Equilibrium | None = None
    near_motion: Motion | None = None

    @property
    def ring(self) -> float:
        """Speed of the inner ring in rad/s."""
        return self.rpm * math.pi / 30

    def rest(self, temperature: float, clearance: float) -> Running:
        """Compute the equilibrium and the films for oil at a temperature in degrees C and for a
        clearance in m."""
        fluid, ring = self.lubricant.at(temperature), self.ring
        surfaces = contact_friction.surfaces(
            self.bearing, self.size, fluid, ring, self.models, self.supply
        )
        found = running.find(
            self.bearing,
            ring,
            self.load,
            self.axial,
            oil=inputs.Oil(
                fluid.viscosity, fluid.pressure_viscosity, fluid.permittivity, self.roughness
            ),
            fluid=fluid,
            film=None if self.models == "paper" else FilmInGap(fluid, ring),
            friction=Friction(surfaces, self.spin_law, self.cage),
            clearance=clearance,
            density=self.density,
            near_motion=self.near_motion,
            held=self.held,
            phase=self.phase,
            near=self.near,
        )
        self.near, self.near_motion = found.rolling, found.motion or self.near_motion
        return found

    def at(self, temperature: float, clearance: float) -> dict[str, Any]:
        """Return the results of the scene at a temperature in degrees C and a clearance in m.
        `sides` is the power in W at the inner and the outer raceway, each including half of the
        drag; `cage` is the power dissipated at the cage, `drag` the power dissipated by drag, and
        `flow` the `heat.OilFlow`."""
        return self.figures(self.rest(temperature, clearance))

    def figures(self, rest: Running) -> dict[str, Any]:
        """Return the same results as `at`, computed from a given `rest`."""
        state, films, fluid, ring = rest.state, rest.films, rest.fluid, self.ring
        losses = rest.losses()
        contacts = losses.rolling + losses.slip + losses.spin + losses.hysteresis
        inner = self.bearing.raceways.count(INNER)
        sides = np.array([contacts[:inner].sum(), contacts[inner:].sum()])
        top = int(np.argmax(state.inner.load))
        return {
            "viscosity_Pa_s": float(fluid.viscosity),
            "h_min_m": float(films.inner.h_min.flat[top]),
            "h_c_m": float(films.inner.h_c.flat[top]),
            "lambda": float(films.inner.ratio.flat[top]),
            "friction_torque_N_m": self.share * losses.power / abs(ring),
            "power_loss_W": self.share * losses.power,
            "losses_W": {name: self.share * power for name, power in losses.parts.items()},
            "sides": tuple((self.share * (sides + losses.drag.sum() / 2)).tolist()),
            "cage": self.share * (losses.cage or 0.0),
            "contacts": heat.conductances(state, films),
            "drag": self.share * float(losses.drag.sum()),
            "flow": self.flow(fluid, float(np.mean(rest.orbit))),
        }

    def flow(self, fluid: Fluid, orbit: float) -> heat.OilFlow:
        """Return the oil flow for balls that orbit at `orbit` rad/s."""
        oil = self.oil_flow
        if oil is None:
            return heat.STILL
        carries = oil.flow * self.lubricant.density * self.lubricant.heat_capacity
        return heat.oil_flow(self.bearing, oil.width, fluid, carries, oil.inlet, orbit)


def one_node(scene: Scene, conductance: float, ambient: float, clearance: float) -> dict[str, Any]:
    """Return the steady-state results with a single temperature, for a `conductance` in W/K to
    `ambient` in degrees C. Raises `NoEquilibrium` if the bearing heats beyond 200 C."""

    def left(temperature):
        found = scene.at(temperature, clearance)
        return found["power_loss_W"] - _carried(found, [temperature] * 3).get("oil_carried_W", 0.0)

    coldest = scene.oil_flow and scene.oil_flow.inlet
    try:
        temperature = heat.balance(left, conductance, ambient, tolerance=ENOUGH, coldest=coldest)
    except ValueError as error:
        raise NoEquilibrium(f"no steady temperature: {error}") from None
    found = dict.fromkeys(
        ("temperature_inner_C", "temperature_balls_C", "temperature_outer_C"), temperature
    )
    at = scene.at(temperature, clearance)
    return dict(
        at,
        **found,
        **_carried(at, [temperature] * 3),
        temperature_C=temperature,
        clearance_warm_m=clearance,
    )


def _carried(found, surfaces):
    """Return the results for flowing oil if the inner ring, the balls and the outer ring have the
    temperatures `surfaces`."""
    flow = found["flow"]
    if not flow.flow:
        return {}
    outlet = heat.outlet(heat.network(contacts=(1.0, 1.0), oil=flow), surfaces, found["drag"])
    return {"temperature_outlet_C": outlet, "oil_carried_W": flow.flow * (outlet - flow.inlet)}


def three_nodes(scene: Scene, nodes: Nodes, ambient: float, clearance: float) -> dict[str, Any]:
    """Return the steady-state results with separate temperatures for the `Nodes`; `clearance` is
    the clearance of the bearing at `ambient`. Raises `NoEquilibrium` if no steady state is found up
    to 200 C."""
    warm, oil = clearance, ambient + 20.0
    part = 0.6  # under-relaxation: friction decreases as the oil warms, so full steps overshoot
    for _ in range(80):
        found = scene.at(oil, warm)
        flow = found["flow"]
        drag = found["drag"] if flow.flow else 0.0
        inner, outer = (side - drag / 2 for side in found["sides"])
        of = vars(nodes) | {"contact": nodes.contact or found["contacts"]}
        at = heat.three_nodes(
            inner, outer, balls=found["cage"], ambient=ambient, oil=drag, flow=flow, **of
        )
        rises = (value - ambient for value in at)
        target = clearance + float(heat.clearance_change(scene.bearing, *rises))
        mean = sum(at) / 3
        if abs(mean - oil) < ENOUGH and abs(target - warm) < 1e-9:
            return dict(
                found,
                temperature_C=oil,
                temperature_inner_C=at.inner,
                temperature_balls_C=at.balls,
                temperature_outer_C=at.outer,
                **_carried(found, at),
                clearance_warm_m=warm,
            )
        oil, warm = oil + part * (mean - oil), warm + part * (target - warm)
        if oil > 200:
            break
    raise NoEquilibrium(f"no steady temperature up to 200 C: the oil is at {oil:.4g} C")
