# SPDX-License-Identifier: GPL-2.0-or-later
"""Steady temperature of a bearing, i.e. the temperature at which cooling balances the friction heat
computed from statics, film and friction at that temperature.

With one node, the whole bearing and its oil are at one temperature. With three nodes, the inner
ring, the balls and the outer ring have separate temperatures, the oil is at the mean of these, and
statics uses the clearance of the warm parts. In both cases, oil that flows through the bearing
carries heat away.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from raceway import inputs
from raceway.core import laws
from raceway.errors import NoEquilibrium
from raceway.theory import ball_pass, cage_drag, contact_friction, heat, makers, running
from raceway.theory.ball_material import STEEL, BallMaterial
from raceway.theory.bearing import INNER, Bearing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubricant import Fluid, Lubricant
from raceway.theory.models import DEFAULT
from raceway.theory.oil_supply import BATH, Supply
from raceway.theory.running import Friction, Running
from raceway.theory.static import STRAIGHT

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
    balls: BallMaterial = STEEL
    spin_law: str = "closed"
    models: str = DEFAULT
    held: Mapping[str, float] = field(default_factory=STRAIGHT.copy)
    size: makers.Size | None = None
    supply: Supply = BATH
    cage: cage_drag.CageRing | None = None
    oil_flow: CirculatingOil | None = None
    share: float = 1.0  # factor on the computed friction, set by `by_runs`
    # {azimuth of the first ball: last result}, where the next search begins
    near: dict[float, Running] = field(default_factory=dict)

    @property
    def ring(self) -> float:
        """Speed of the inner ring in rad/s."""
        return self.rpm * math.pi / 30

    def grown(self, inner: float, balls: float, outer: float) -> "Scene":
        """Return the scene with parts that have expanded under these temperature rises in K."""
        steel = float(laws.steel_of_bearings().expansion)
        strains = steel * inner, self.balls.expansion * balls, steel * outer
        return replace(self, bearing=self.bearing.grown(*strains))

    def over_pass(self, temperature: float, clearance: float) -> list[tuple[float, Running]]:
        """Return [(share of the ball pass, result of `rest`)] for the positions of the balls that
        `ball_pass.over` selects. The loads must be symmetric to the plane of x and z."""
        return ball_pass.over(
            lambda phase: self.rest(temperature, clearance, phase),
            self.bearing.balls,
            lambda rest: rest.state.inner.load,
        )

    def rest(self, temperature: float, clearance: float, phase: float = 0.0) -> Running:
        """Compute the equilibrium and the films for oil at a temperature in degrees C and for a
        clearance in m, with the first ball at the azimuth `phase` in rad."""
        found = self.near[phase] = self._rest(
            temperature, clearance, phase, self.near.get(phase) or self.near.get(0.0)
        )
        return found

    def _rest(self, temperature, clearance, phase, near):
        fluid, ring = self.lubricant.at(temperature), self.ring
        surfaces = contact_friction.surfaces(
            self.bearing, self.size, fluid, ring, self.models, self.supply
        )
        return running.find(
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
            density=self.balls.density,
            near_motion=near and near.motion,
            held=self.held,
            phase=phase,
            near=near and near.rolling,
        )

    def at(self, temperature: float, clearance: float) -> dict[str, Any]:
        """Return the results of the scene at a temperature in degrees C and a clearance in m, as
        means over a ball pass; films are those at the largest inner load. `sides` is the power in W
        at the inner and the outer raceway, each including half of the drag; `cage` is the power
        dissipated at the cage, `drag` the power dissipated by drag, and `flow` the
        `heat.OilFlow`."""
        return self.figures(self.over_pass(temperature, clearance))

    def figures(self, over: Sequence[tuple[float, Running]]) -> dict[str, Any]:
        """Return the same results as `at`, computed from a given result of `over_pass`."""
        shares, rests = zip(*over)
        lost = [rest.losses() for rest in rests]

        def mean(values):
            return np.average(values, axis=0, weights=shares)

        def own(values):
            return self.share * mean(values)

        contacts = [one.rolling + one.slip + one.spin + one.hysteresis for one in lost]
        inner = self.bearing.raceways.count(INNER)
        sides = own([(one[:inner].sum(), one[inner:].sum()) for one in contacts])
        power, drag = (float(own([of(one) for one in lost])) for of in (_power, _drag))
        heaviest = max(rests, key=lambda rest: rest.state.inner.load.max())
        top, film = int(np.argmax(heaviest.state.inner.load)), heaviest.films.inner
        fluid = heaviest.fluid
        return {
            "viscosity_Pa_s": float(fluid.viscosity),
            "h_min_m": float(film.h_min.flat[top]),
            "h_c_m": float(film.h_c.flat[top]),
            "lambda": float(film.ratio.flat[top]),
            "friction_torque_N_m": power / abs(self.ring),
            "power_loss_W": power,
            "losses_W": {
                name: float(own([one.parts[name] for one in lost])) for name in lost[0].parts
            },
            "sides": tuple((sides + drag / 2).tolist()),
            "cage": float(own([one.cage or 0.0 for one in lost])),
            "contacts": tuple(
                mean(
                    [
                        heat.conductances(rest.state, rest.films, self.balls.effusivity)
                        for rest in rests
                    ]
                ).tolist()
            ),
            "drag": drag,
            "flow": self.flow(fluid, float(mean([np.mean(rest.orbit) for rest in rests]))),
        }

    def flow(self, fluid: Fluid, orbit: float) -> heat.OilFlow:
        """Return the oil flow for balls that orbit at `orbit` rad/s."""
        oil = self.oil_flow
        if oil is None:
            return heat.STILL
        carries = oil.flow * self.lubricant.density * self.lubricant.heat_capacity
        return heat.oil_flow(self.bearing, oil.width, fluid, carries, oil.inlet, orbit)


def _power(losses):
    return losses.power


def _drag(losses):
    return float(losses.drag.sum())


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
        warm=scene,
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
    to 200 C. `warm` is the `Scene` with the warm parts, which has the cold `clearance`."""
    now = np.full(3, ambient + 20.0)  # degrees C, temperatures with which the losses are computed
    part = 0.6  # under-relaxation: friction decreases as the oil warms, so full steps overshoot

    def change(temperatures):
        rises = np.asarray(temperatures) - ambient
        return float(heat.clearance_change(scene.bearing, *rises, scene.balls.expansion))

    for _ in range(80):
        oil, warm = float(now.mean()), scene.grown(*(now - ambient))
        found = warm.at(oil, clearance)
        flow = found["flow"]
        drag = found["drag"]
        inner, outer = (side - drag / 2 for side in found["sides"])
        of = vars(nodes) | {"contact": nodes.contact or found["contacts"]}
        at = heat.three_nodes(
            inner,
            outer,
            balls=found["cage"],
            ambient=ambient,
            drag=drag,
            flow=flow,
            share=scene.balls.heat_share,
            **of,
        )
        if abs(sum(at) / 3 - oil) < ENOUGH and abs(change(at) - change(now)) < 1e-9:
            return dict(
                found,
                temperature_C=oil,
                temperature_inner_C=at.inner,
                temperature_balls_C=at.balls,
                temperature_outer_C=at.outer,
                **_carried(found, at),
                clearance_warm_m=clearance + change(now),
                warm=warm,
            )
        now = now + part * (np.asarray(at) - now)
        if not now.mean() <= 200:  # it is NaN if conductances are too small for their reciprocals
            break
    raise NoEquilibrium(f"no steady temperature up to 200 C: the oil is at {now.mean():.4g} C")
