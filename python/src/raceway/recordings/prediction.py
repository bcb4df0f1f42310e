# SPDX-License-Identifier: GPL-2.0-or-later
"""Readings predicted by statics from the state of a bearing."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from raceway import inputs
from raceway.arrays import Floats
from raceway.recordings.readings import Point, Reading, Readings
from raceway.theory import cage_speed
from raceway.theory.static import STRAIGHT, Equilibrium
from raceway.theory.steady_heat import Scene

NO_LAG = 0.0, 0.0


class Predicted(NamedTuple):
    """A reading as predicted."""

    value: float
    error: float  # standard deviation of the model, in the unit of the reading
    lag: tuple[float, float]  # least and largest slip by pocket play, fractions of the cage's speed
    idle: int  # unloaded balls
    angle: float  # rad, mean contact angle weighted by load; NaN where it is not needed


class Model:
    """Predictions for `readings`. A point is solved once for all its readings."""

    def __init__(self, readings: Readings) -> None:
        self.readings = readings
        path, oil = readings.bearing, readings.lubricant
        self.bearing = inputs.bearing(path, one_groove="its lines are those of one groove per ring")
        self._boundary, self._density = inputs.boundary(path), inputs.ball_density(path)
        self._size = inputs.size(path)
        self._near: dict[Point, Equilibrium | None] = {}  # of the last state
        self._lubricant, self._roughness = inputs.lubricant(oil), inputs.oil(oil).roughness

    def predict(
        self, state: Mapping[str, float], rows: Sequence[Reading] | None = None
    ) -> list[Predicted]:
        """`Predicted` of each reading, or of the readings `rows`, in a `state`, {name of
        `readings.STATE`: value}. Raises `NoEquilibrium` where the bearing cannot carry the load."""
        solved: dict[Point, tuple] = {}
        rows = self.readings.readings if rows is None else rows
        return [self._one(one, state, solved) for one in rows]

    def _oil(self, point, state):
        """C; NaN if it is the temperature read."""
        return point.at if point.at is not None else state.get("temperature", math.nan)

    def _one(self, reading: Reading, state, solved) -> Predicted:
        point = reading.point
        oil = self._oil(point, state)
        if reading.quantity == "temperature" and "conductance" not in state:
            return Predicted(oil, 0.0, NO_LAG, 0, math.nan)
        if math.isnan(oil):  # friction at the temperature read
            oil = reading.value
        key = point._replace(at=oil)
        if key not in solved:
            scene = self._scene(point, state)
            scene.near = self._near.get(point)
            solved[key] = scene, scene.rest(oil, state["clearance"])
            self._near[point] = scene.near
        scene, rest = solved[key]
        idle, angle = int((rest.state.inner.load <= 0).sum()), _contact_angle(rest.state)
        if reading.quantity == "temperature":
            lost = scene.figures(rest, state["clearance"])["power_loss_W"]
            steady = self.readings.ambient + lost / state["conductance"]
            return Predicted(steady, 0.0, NO_LAG, idle, angle)
        if reading.quantity == "capacitance":
            return Predicted(rest.films.total, 0.0, NO_LAG, idle, angle)
        of = self.bearing, rest.state, self.readings.models
        if reading.quantity == "BSF":
            spin = cage_speed.ball_order(*of)
            return Predicted(spin, cage_speed.ERROR * spin, NO_LAG, idle, angle)
        cage = cage_speed.order(*of)
        plays = self.readings.models != "paper"
        lag = cage_speed.lags(self.bearing, rest.state) if plays else NO_LAG
        return self._line(reading.quantity, cage, angle, lag, idle)

    def _line(self, name, cage, angle, lag, idle):
        balls = self.bearing.balls
        value = {"FTF": cage, "BPFO": balls * cage, "BPFI": balls * (1 - cage)}[name]
        slope = {"FTF": 1.0, "BPFO": balls, "BPFI": balls}[name] * cage
        return Predicted(value, cage_speed.ERROR * slope, lag, idle, angle)

    def _scene(self, point: Point, state) -> Scene:
        load = state["load"] if point.load is None else point.load
        axial = state["axial"] if point.axial is None else point.axial
        axial += point.axial_more
        held = STRAIGHT | inputs.held(self.readings.bearing, axial, state["clearance"])
        return Scene(
            self.bearing,
            self._boundary,
            self._lubricant,
            self._roughness,
            load + point.load_more,
            axial,
            point.rpm,
            self._density,
            models=self.readings.models,
            held=held,
            size=self._size,
        )


def _contact_angle(state):
    load = np.concatenate([state.inner.load, state.outer.load])
    angles = np.concatenate([state.inner.angle, state.outer.angle])
    return math.acos(np.average(np.cos(angles), weights=load))


def residuals(readings: Readings, found: list[Predicted], slip: Floats) -> Floats:
    """(predicted - read)/uncertainty of each reading (N,), including the model's error in the
    uncertainty. `slip` (N, 2) is the least and the largest lag of the cage for each reading: their
    mean is subtracted, and their range counts as error."""
    rest = []
    for one, own, (least, most) in zip(readings.readings, found, slip):
        slope = {"BPFI": -1.0}.get(one.quantity, 1.0)
        # change of the line per unit relative change of the cage's speed
        size = own.error / cage_speed.ERROR
        shift = -slope * size * (least + most) / 2
        spread = size * (most - least) / math.sqrt(12)
        rest.append((own.value + shift - one.value) / math.hypot(one.within, own.error, spread))
    return np.array(rest)
