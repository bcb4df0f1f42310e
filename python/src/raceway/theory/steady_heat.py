# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of `raceway heat`: a bearing with its oil and cooling at its steady temperature, computed
with `heat_scene`, and its thermal reference speed."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from raceway import catalogue, inputs
from raceway.files import FilePath
from raceway.rows import GROOVES, Row, lines, row, several, warning_lines
from raceway.theory import cage_drag, heat, operating_warnings
from raceway.theory.bearing import DoubleRow, Layout, grooves
from raceway.theory.heat_scene import CirculatingOil, Nodes, Scene, one_node, three_nodes
from raceway.theory.models import DEFAULT
from raceway.theory.oil_supply import BATH, Supply
from raceway.theory.operating_table import LOSSES
from raceway.theory.running import Running
from raceway.theory.static import STRAIGHT
from raceway.theory.validity import of_statics

# results of a `Scene` for its heat balance
OF_NODES = ("sides", "cage", "contacts", "drag", "flow", "warm")
TOPICS = {
    "Operating point": (
        row("bearing"),
        row("lubricant"),
        row("load_N", "along x"),
        Row("axial_N", "axial load", "N", "along z"),
        row("rpm"),
        Row("clearance_m", "diametral clearance, cold", "m"),
        *GROOVES,
        Row("ambient_C", "ambient temperature", "°C"),
        Row("conductance_W_K", "cooling", "W/K", "ISO 15312 unless given"),
        Row("oil_flow_m3_s", "oil flow", "m³/s"),
        Row("oil_inlet_C", "oil at the inlet", "°C"),
    ),
    "Runs": (
        Row("runs", "runs", ""),
        Row("run_temperature_C", "temperature of the last run", "°C"),
        Row("run_power_W", "power loss of the last run", "W"),
        Row("run_over_statics", "ratio to power loss by statics", ""),
    ),
    "Steady state": (
        Row("temperature_C", "temperature of the lubricant", "°C"),
        Row("temperature_inner_C", "inner ring", "°C"),
        Row("temperature_balls_C", "balls", "°C"),
        Row("temperature_outer_C", "outer ring", "°C"),
        Row("temperature_outlet_C", "oil at the outlet", "°C"),
        Row("oil_carried_W", "carried away by the oil", "W"),
        Row("clearance_warm_m", "diametral clearance, warm", "m"),
        row("viscosity_Pa_s"),
        row("h_min_m", "largest inner load"),
        row("h_c_m", "largest inner load"),
        row("lambda", "largest inner load"),
        Row("friction_torque_N_m", "friction torque", "N m"),
        Row("power_loss_W", "power loss", "W"),
    ),
    "Thermal reference speed": (
        Row("reference_speed_rpm", "oil to the middle of a ball", "rpm", "ISO 15312, SKF's torque"),
        Row("reference_speed_dry_rpm", "without drag", "rpm"),
        Row("reference_speed_catalogue_rpm", "of the catalogue", "rpm"),
    ),
}
COLUMNS = (  # columns of the table for several points: key, heading, scale
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


def _settings(oil):
    """Return the results that describe the input `CirculatingOil`."""
    return {} if oil is None else {"oil_flow_m3_s": oil.flow, "oil_inlet_C": oil.inlet}


@dataclass(frozen=True)
class Case:
    """Input of `figures`, in SI units and degrees C.

    `bearing` and `lubricant` are names or paths of data files, which are searched for in the inputs
    `folder` (`catalogue.find`); the lubricant's file must contain physical data. Cooling is
    determined by `nodes` or by `conductance` in W/K or, if neither is given, by ISO 15312.
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
    four_point: float | None = None  # this and `double_row` are as in `inputs.bearing`
    double_row: DoubleRow | None = None
    spin_law: str = "closed"  # this and `models` are as in `operating_point.figures`
    models: str = DEFAULT
    supply: Supply = BATH
    cage: cage_drag.CageRing | None = None
    oil_flow: float = 0.0  # m^3/s at 40 C; 0 if no oil carries heat away
    oil_inlet: float | None = None  # degrees C; by default the ambient temperature

    def files(self) -> tuple[Path, Path]:
        """Return the paths of the bearing and of the lubricant. Raises `RacewayError`."""
        path, oil = (
            catalogue.find("bearings", self.bearing, self.folder),
            catalogue.find("lubricants", self.lubricant, self.folder),
        )
        if not inputs.physical(oil):
            raise inputs.InputError(
                f"{oil} has no physical data from which to compute other temperatures: use vg46,"
                " for example"
            )
        return path, oil

    def scene(self) -> Scene:
        """Return the `Scene`. Raises `RacewayError`."""
        path, oil = self.files()
        return Scene(
            inputs.bearing(path, four_point=self.four_point, double_row=self.double_row),
            inputs.lubricant(oil),
            inputs.oil(oil).roughness,
            self.load,
            self.axial,
            self.rpm,
            inputs.ball_material(path),
            self.spin_law,
            self.models,
            STRAIGHT | inputs.held(path, self.axial, self.clearance, self.double_row),
            inputs.size(path),
            self.supply,
            self.cage,
            self._oil_flow(path),
        )

    def _oil_flow(self, path):
        """Return the `CirculatingOil`, or None if there is none. Raises `RacewayError`."""
        if not self.oil_flow:
            return None
        if "bearing_width" not in inputs.values(path):
            raise inputs.InputError(f"{path} has no bearing_width, which the oil flow needs")
        inlet = self.ambient if self.oil_inlet is None else self.oil_inlet
        return CirculatingOil(self.oil_flow, inlet, self._width(path))

    def _width(self, path):
        """Return the width in m over all rows. Its file states that of one row, from whose planes
        of balls the sides of the bearing are half that width away. Raises `RacewayError`."""
        one = inputs.numbers(path, "bearing_width")["bearing_width"]
        return one if self.double_row is None else one + self.double_row.spacing

    def cooling(self) -> float | None:
        """Return the conductance in W/K, or None if `nodes` are given. Raises `RacewayError`."""
        if self.conductance is not None or self.nodes is not None:
            return self.conductance
        return self.usual_cooling()

    def usual_cooling(self) -> float:
        """Return the conductance in W/K by ISO 15312. Raises `RacewayError`."""
        path, _ = self.files()
        names = ("bore_diameter", "outside_diameter", "bearing_width")
        if missing := set(names) - set(inputs.values(path)):
            raise inputs.InputError(
                f"{path} has no {', '.join(sorted(missing))} for ISO 15312: give --conductance"
            )
        bore, outside = inputs.numbers(path, *names[:2]).values()
        return heat.cooling(1e3 * bore, 1e3 * outside, 1e3 * self._width(path))

    def steady(self, scene: Scene) -> dict[str, Any]:
        """Return the steady-state results of the `Scene`. Raises `NoEquilibrium`."""
        if self.nodes is not None:
            nodes = self.nodes
            if nodes.housing is None:
                nodes = replace(nodes, housing=self.usual_cooling())
            return three_nodes(scene, nodes, self.ambient, self.clearance)
        return one_node(scene, self.cooling(), self.ambient, self.clearance)

    def report(self, scene: Scene, found: Mapping[str, Any], rest: Running) -> dict[str, Any]:
        """Return the result of `figures`, without the warnings about friction, from the
        steady-state results `found` and the equilibrium `rest` at their temperature."""
        path, oil = self.files()
        level = 500 * scene.bearing.ball_diameter  # mm, at the middle of the lowest ball
        stated = inputs.four_point_angle(path)
        as_in_catalogue = self.double_row is None and self.four_point in (None, stated)
        known = "reference_speed" in inputs.values(path) and as_in_catalogue
        # the formulas for the friction apply to one row with one groove per ring
        boundary = inputs.boundary(path) if scene.bearing.layout == Layout() else None
        play = scene.bearing.play(inputs.nominal_angle(path))
        arch = stated if self.four_point is None else self.four_point
        return dict(
            bearing=path.name,
            lubricant=oil.name,
            load_N=self.load,
            axial_N=self.axial,
            rpm=self.rpm,
            clearance_m=self.clearance + play,
            **grooves(arch, self.double_row),
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
                four_point=arch,
            ),
        )


def figures(*names: Any, **point: Any) -> dict[str, Any]:
    """Return the steady-state results for the `Case` with these arguments as a dict, in SI units
    with temperatures in degrees C. Raises `RacewayError`."""
    case = Case(*names, **point)
    case.files()
    case.cooling()
    scene = case.scene()
    steady = case.steady(scene)
    # with a ball on the load line, as in `raceway static`
    rest = steady["warm"].rest(steady["temperature_C"], case.clearance)
    result = case.report(scene, steady, rest)
    lost = rest.losses()
    ahead = operating_warnings.advance(rest, lost, case.cage)
    doubts = operating_warnings.of_friction(rest, lost, ahead)
    result["warnings"] += doubts.warnings + operating_warnings.restrained(ahead)
    return result


def table(result: Mapping[str, Any]) -> str:
    """Format the result of `figures` as text."""
    losses = {f"loss_{part}_W": loss for part, loss in result["losses_W"].items()}
    parts = LOSSES
    if result.get("runs"):  # in a run, slip is the loss by all tangential forces
        parts = tuple(Row(f"loss_{part}_W", part, "W") for part in result["losses_W"])
    topics = TOPICS | {"Losses": parts}
    shown = dict.fromkeys(one.key for topic in topics.values() for one in topic) | result | losses
    for key in ("reference_speed_rpm", "reference_speed_dry_rpm"):
        shown[key] = shown[key] and round(shown[key])
    return "\n".join([*lines(shown, topics), *warning_lines(result["warnings"])])


def curves(results: list[dict[str, Any]]) -> str:
    """Format several results of `figures` as text, with one line per result."""
    return several(results, COLUMNS, optional=("axial_N", "clearance_m"))
