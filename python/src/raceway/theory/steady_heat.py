# SPDX-License-Identifier: GPL-2.0-or-later
"""Steady temperature of a bearing: statics, film and friction at the temperature where cooling
balances the friction heat.

One node: the whole bearing and its oil at one temperature. Three nodes: inner ring, balls and outer
ring at separate temperatures, the oil at their mean, and statics with the clearance of the warm
parts. In both cases, oil that flows through the bearing carries heat away.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from raceway import catalogue, inputs
from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.files import FilePath
from raceway.rows import Row, lines, several, warning_lines
from raceway.theory import cage_drag, friction_torque, heat, makers
from raceway.theory.bearing import INNER, Bearing, DoubleRow
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubricant import Fluid, Lubricant
from raceway.theory.lubrication import Lubrication, lubricate, turning
from raceway.theory.models import DEFAULT
from raceway.theory.oil_supply import BATH, Supply
from raceway.theory.static import STRAIGHT, Equilibrium
from raceway.theory.validity import of_statics

ENOUGH = 0.01  # K, tolerance
OF_NODES = ("sides", "cage", "contacts", "drag", "flow")  # of a `Scene`, for its heat balance
TOPICS = {
    "Operating point": (
        Row("bearing", "bearing", None),
        Row("lubricant", "lubricant", None),
        Row("load_N", "radial load", "N"),
        Row("axial_N", "axial load", "N"),
        Row("rpm", "inner ring speed", "rpm"),
        Row("clearance_m", "diametral clearance, cold", "m"),
        Row("ambient_C", "ambient temperature", "°C"),
        Row("conductance_W_K", "cooling", "W/K", "ISO 15312 unless given"),
        Row("oil_flow_m3_s", "oil flow", "m³/s"),
        Row("oil_inlet_C", "oil at the inlet", "°C"),
    ),
    "Runs": (
        Row("runs", "runs", ""),
        Row("run_temperature_C", "temperature of the last run", "°C"),
        Row("run_power_W", "power loss of the last run", "W"),
        Row("run_over_statics", "its power loss over that of statics", ""),
    ),
    "Steady state": (
        Row("temperature_C", "temperature of the lubricant", "°C"),
        Row("temperature_inner_C", "inner ring", "°C"),
        Row("temperature_balls_C", "balls", "°C"),
        Row("temperature_outer_C", "outer ring", "°C"),
        Row("temperature_outlet_C", "oil at the outlet", "°C"),
        Row("oil_carried_W", "carried away by the oil", "W"),
        Row("clearance_warm_m", "diametral clearance, warm", "m"),
        Row("viscosity_Pa_s", "viscosity", "Pa s"),
        Row("h_min_m", "minimum film thickness", "m", "largest inner load"),
        Row("h_c_m", "central film thickness", "m", "the same"),
        Row("lambda", "lambda", "", "the same"),
        Row("friction_torque_N_m", "friction torque", "N m"),
        Row("power_loss_W", "power loss", "W"),
    ),
    "Thermal reference speed": (
        Row("reference_speed_rpm", "oil to the middle of a ball", "rpm", "ISO 15312, SKF's torque"),
        Row("reference_speed_dry_rpm", "without drag", "rpm"),
        Row("reference_speed_catalogue_rpm", "of the catalogue", "rpm"),
    ),
}
COLUMNS = (  # of the table of several points: key, heading, scale
    ("load_N", "load N", 1),
    ("axial_N", "axial N", 1),
    ("rpm", "rpm", 1),
    ("clearance_m", "cold P_d µm", 1e6),
    ("temperature_C", "T °C", 1),
    ("viscosity_Pa_s", "eta mPa s", 1e3),
    ("clearance_warm_m", "P_d µm", 1e6),
    ("h_c_m", "h_c nm", 1e9),
    ("lambda", "lambda", 1),
    ("friction_torque_N_m", "torque N mm", 1e3),
    ("power_loss_W", "loss W", 1),
)


@dataclass(frozen=True)
class Nodes:
    """Conductances of `heat.three_nodes`, W/K. If `housing` is None, it follows from ISO 15312; if
    `contact` is None, from the moving contacts (`heat.conductances`)."""

    shaft: float = 0.0
    housing: float | None = None
    contact: float | None = None


@dataclass(frozen=True)
class CirculatingOil:
    """Oil that flows through a bearing of this `width` in m; `flow` is the volume flow at 40 C in
    m^3/s, `inlet` the inlet temperature in degrees C."""

    flow: float
    inlet: float
    width: float


class Rest(NamedTuple):
    """A bearing in equilibrium with its loads, and the films at its speed."""

    state: Equilibrium
    orbit: float | Floats  # rad/s, of the balls
    films: Lubrication
    fluid: Fluid


class Scene:
    """A bearing, its oil and load; the friction follows from temperature and clearance."""

    def __init__(
        self,
        bearing: Bearing,
        boundary: makers.Boundary | None,
        lubricant: Lubricant,
        roughness: float,
        load: float,
        axial: float,
        rpm: float,
        density: float = 7800.0,
        spin_law: str = "closed",
        models: str = DEFAULT,
        held: Mapping[str, float] = STRAIGHT,
        size: makers.Size | None = None,
        supply: Supply = BATH,
        cage: cage_drag.CageRing | None = None,
        oil_flow: CirculatingOil | None = None,
    ) -> None:
        """`roughness` is the composite roughness in m, `density` that of the balls in kg/m^3;
        `spin_law`, `models` and `cage` are as in `operating_point.figures`, `held` as in
        `static.equilibrium`, `size` and `supply` as in `friction_torque.surfaces`."""
        self.bearing, self.boundary, self.lubricant = bearing, boundary, lubricant
        self.roughness, self.load, self.axial = roughness, load, axial
        self.ring, self.density = rpm * math.pi / 30, density
        self.spin_law, self.models, self.held = spin_law, models, held
        self.size, self.supply, self.cage = size, supply, cage
        self.oil_flow = oil_flow
        self.share = 1.0  # factor on the friction of the laws, set by `by_runs`
        self.near: Equilibrium | None = None  # the last equilibrium, where the next search begins

    def rest(self, temperature: float, clearance: float) -> Rest:
        """Equilibrium and films with the oil at a temperature in degrees C and a clearance in m."""
        fluid, ring = self.lubricant.at(temperature), self.ring
        film = None if self.models == "paper" else FilmInGap(fluid, ring)
        state, orbit = turning(
            self.bearing,
            ring,
            self.load,
            self.axial,
            held=self.held,
            clearance=clearance,
            ball_density=self.density,
            film=film,
            near=self.near,
        )
        self.near = state
        oil = inputs.Oil(
            fluid.viscosity, fluid.pressure_viscosity, fluid.permittivity, self.roughness
        )
        films = lubricate(self.bearing, state, oil, ring, clearance, film and film.factor)
        return Rest(state, orbit, films, fluid)

    def at(self, temperature: float, clearance: float) -> dict[str, Any]:
        """Figures of the scene at a temperature in degrees C and a clearance in m. `sides` is the
        power in W at the inner and the outer raceway, each with half of the drag; `cage` is the
        power lost at the cage, `drag` the power lost by drag, `flow` the `heat.OilFlow`."""
        return self.figures(self.rest(temperature, clearance), clearance)

    def figures(self, rest: Rest, clearance: float) -> dict[str, Any]:
        """Like `at`, from a given `rest`."""
        state, orbit, films, fluid = rest
        ring = self.ring
        losses = friction_torque.losses(
            self.bearing,
            state,
            films,
            fluid,
            ring,
            orbit,
            clearance=clearance,
            surfaces=friction_torque.surfaces(
                self.bearing, self.size, fluid, ring, self.models, self.supply
            ),
            spin_law=self.spin_law,
            ball_density=self.density,
            cage=self.cage,
        )
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
            "flow": self.flow(fluid, float(np.mean(orbit))),
        }

    def flow(self, fluid: Fluid, orbit: float) -> heat.OilFlow:
        """The flow of oil, for balls that orbit at a speed in rad/s."""
        oil = self.oil_flow
        if oil is None:
            return heat.STILL
        carries = oil.flow * self.lubricant.density * self.lubricant.heat_capacity
        return heat.oil_flow(self.bearing, oil.width, fluid, carries, oil.inlet, orbit)


def one_node(scene: Scene, conductance: float, ambient: float, clearance: float) -> dict[str, Any]:
    """Steady figures with one temperature, `conductance` in W/K to `ambient` in degrees C. Raises
    `NoEquilibrium` if the bearing heats beyond 200 C."""

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


def _settings(oil):
    """Figures of the input of `CirculatingOil`."""
    return {} if oil is None else {"oil_flow_m3_s": oil.flow, "oil_inlet_C": oil.inlet}


def _carried(found, surfaces):
    """Figures of flowing oil, with inner ring, balls and outer ring at temperatures `surfaces`."""
    flow = found["flow"]
    if not flow.flow:
        return {}
    outlet = heat.outlet(heat.network(contacts=(1.0, 1.0), oil=flow), surfaces, found["drag"])
    return {"temperature_outlet_C": outlet, "oil_carried_W": flow.flow * (outlet - flow.inlet)}


def three_nodes(scene: Scene, nodes: Nodes, ambient: float, clearance: float) -> dict[str, Any]:
    """Steady figures with separate temperatures by `Nodes`; `clearance` is the clearance of the
    bearing at `ambient`. Raises `NoEquilibrium` if no steady state is found up to 200 C."""
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


@dataclass(frozen=True)
class Case:
    """Input of `figures`; SI units, degrees C.

    `bearing` and `lubricant` are names or paths of data files, looked up in the inputs `folder`
    (`catalogue.find`); the lubricant's file must have physical data. Cooling follows from `nodes`,
    or from `conductance` in W/K, or by default from ISO 15312.
    """

    bearing: str
    lubricant: str
    folder: FilePath | None = None
    load: float = 0.0
    axial: float = 0.0
    rpm: float = 0.0
    clearance: float = 0.0
    ambient: float = 20.0
    conductance: float | None = None
    nodes: Nodes | None = None
    four_point: float | None = None  # `four_point` and `double_row` as in `inputs.bearing`
    double_row: DoubleRow | None = None
    spin_law: str = "closed"  # `spin_law` and `models` as in `operating_point.figures`
    models: str = DEFAULT
    supply: Supply = BATH
    cage: cage_drag.CageRing | None = None
    oil_flow: float = 0.0  # m^3/s at 40 C; 0: oil does not carry heat away
    oil_inlet: float | None = None  # ambient unless given

    def files(self) -> tuple[Path, Path]:
        """Paths of the bearing and of the lubricant. Raises `RacewayError`."""
        path, oil = (
            catalogue.find("bearings", self.bearing, self.folder),
            catalogue.find("lubricants", self.lubricant, self.folder),
        )
        if not inputs.physical(oil):
            raise inputs.InputError(
                f"{oil} has no physical data to compute other temperatures from: take vg46 for"
                " example"
            )
        return path, oil

    def scene(self) -> Scene:
        """The `Scene`. Raises `RacewayError`."""
        path, oil = self.files()
        return Scene(
            inputs.bearing(path, four_point=self.four_point, double_row=self.double_row),
            inputs.boundary(path),
            inputs.lubricant(oil),
            inputs.oil(oil).roughness,
            self.load,
            self.axial,
            self.rpm,
            inputs.ball_density(path),
            self.spin_law,
            self.models,
            STRAIGHT | inputs.held(path, self.axial, self.clearance, self.double_row),
            inputs.size(path),
            self.supply,
            self.cage,
            self._oil_flow(path),
        )

    def _oil_flow(self, path):
        """The `CirculatingOil`, or None. Raises `RacewayError`."""
        if not self.oil_flow:
            return None
        if "bearing_width" not in inputs.values(path):
            raise inputs.InputError(f"{path} has no bearing_width, which the oil flow needs")
        inlet = self.ambient if self.oil_inlet is None else self.oil_inlet
        width = inputs.numbers(path, "bearing_width")["bearing_width"]
        return CirculatingOil(self.oil_flow, inlet, width)

    def cooling(self) -> float | None:
        """Conductance in W/K; None with nodes. Raises `RacewayError`."""
        if self.conductance is not None or self.nodes is not None:
            return self.conductance
        return self.usual_cooling()

    def usual_cooling(self) -> float:
        """Conductance in W/K of ISO 15312. Raises `RacewayError`."""
        path, _ = self.files()
        names = ("bore_diameter", "outside_diameter", "bearing_width")
        if missing := set(names) - set(inputs.values(path)):
            raise inputs.InputError(
                f"{path} has no {', '.join(sorted(missing))} for ISO 15312: give --conductance"
            )
        return heat.cooling(*(1e3 * size for size in inputs.numbers(path, *names).values()))

    def steady(self, scene: Scene) -> dict[str, Any]:
        """Steady figures of the `Scene`. Raises `NoEquilibrium`."""
        if self.nodes is not None:
            nodes = self.nodes
            if nodes.housing is None:
                nodes = replace(nodes, housing=self.usual_cooling())
            return three_nodes(scene, nodes, self.ambient, self.clearance)
        return one_node(scene, self.cooling(), self.ambient, self.clearance)

    def report(self, scene: Scene, found: Mapping[str, Any]) -> dict[str, Any]:
        """The result of `figures` with the steady figures `found`."""
        path, oil = self.files()
        level = 500 * scene.bearing.ball_diameter  # mm: the middle of the lowest ball
        known = "reference_speed" in inputs.values(path)
        boundary, play = scene.boundary, scene.bearing.play(inputs.nominal_angle(path))
        rest = scene.rest(found["temperature_C"], found["clearance_warm_m"])
        return dict(
            bearing=path.name,
            lubricant=oil.name,
            load_N=self.load,
            axial_N=self.axial,
            rpm=self.rpm,
            clearance_m=self.clearance + play,
            ambient_C=self.ambient,
            conductance_W_K=self.cooling(),
            **_settings(scene.oil_flow),
            **{key: value for key, value in found.items() if key not in OF_NODES}
            | {"clearance_warm_m": found["clearance_warm_m"] + play},
            reference_speed_rpm=boundary and heat.reference_speed(boundary, level),
            reference_speed_dry_rpm=boundary and heat.reference_speed(boundary),
            reference_speed_catalogue_rpm=(
                inputs.numbers(path, "reference_speed")["reference_speed"] if known else None
            ),
            warnings=of_statics(
                scene.bearing,
                inputs.shoulders(path),
                rest.state,
                rest.films,
                load=self.load,
                axial=self.axial,
                four_point=(
                    inputs.four_point_angle(path) if self.four_point is None else self.four_point
                ),
            ),
        )


def figures(*names: Any, **point: Any) -> dict[str, Any]:
    """Steady figures by name in SI units, temperatures in degrees C, of the `Case` with these
    arguments. Raises `RacewayError`."""
    case = Case(*names, **point)
    case.files()
    case.cooling()
    scene = case.scene()
    return case.report(scene, case.steady(scene))


def table(result: Mapping[str, Any]) -> str:
    """The result of `figures` as text."""
    rows = (row for topic in TOPICS.values() for row in topic)
    shown = {**dict.fromkeys(row.key for row in rows), **result}
    for key in ("reference_speed_rpm", "reference_speed_dry_rpm"):
        shown[key] = shown[key] and round(shown[key])
    parts = "\n".join(f"  {name:<32}{power:>12.4g} W" for name, power in result["losses_W"].items())
    text = [*lines(shown, TOPICS), "", "Losses", parts, *warning_lines(result["warnings"])]
    return "\n".join(text)


def curves(results: list[dict[str, Any]]) -> str:
    """Several results of `figures` as text, one line each."""
    return several(results, COLUMNS, optional=("axial_N", "clearance_m"))
