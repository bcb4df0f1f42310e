# SPDX-License-Identifier: GPL-2.0-or-later
"""Prediction of readings from the state of a bearing by means of statics."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from raceway import inputs
from raceway.arrays import Floats
from raceway.recordings.readings import Point, Reading, Readings
from raceway.theory import cage_speed
from raceway.theory.heat_scene import Scene
from raceway.theory.running import Running
from raceway.theory.static import STRAIGHT

NO_LAG = 0.0, 0.0


class Predicted(NamedTuple):
    """A predicted reading."""

    value: float
    error: float  # standard deviation of the model, in the unit of the reading
    lag: tuple[float, float]  # smallest and largest slip due to pocket play, relative to cage speed
    idle: int  # number of unloaded balls
    angle: float  # rad, load-weighted mean contact angle; NaN where it is not needed


class Model:
    """Predicts `readings`. Each operating point is solved once for all its readings."""

    def __init__(self, readings: Readings) -> None:
        self.readings = readings
        path, oil = readings.bearing, readings.lubricant
        self.bearing = inputs.bearing(path, one_groove="lines need one groove per ring")
        self._balls, self._size = inputs.ball_material(path), inputs.size(path)
        self._near: dict[Point, dict[float, Running]] = {}  # results for the last state
        self._lubricant, self._roughness = inputs.lubricant(oil), inputs.oil(oil).roughness

    def predict(
        self, state: Mapping[str, float], rows: Sequence[Reading] | None = None
    ) -> list[Predicted]:
        """Return the `Predicted` value of each reading, or of the readings `rows`, in a `state`.

        The state maps names of `readings.STATE` to values. Raise `NoEquilibrium` if the bearing
        cannot carry the load.
        """
        solved: dict[Point, tuple] = {}
        rows = self.readings.readings if rows is None else rows
        return [self._one(one, state, solved) for one in rows]

    def _oil(self, point, state):
        """Return the oil temperature in C, or NaN if the oil temperature itself is the reading."""
        return point.at if point.at is not None else state.get("temperature", math.nan)

    def _one(self, reading: Reading, state, solved) -> Predicted:
        point = reading.point
        oil = self._oil(point, state)
        if reading.quantity == "temperature" and "conductance" not in state:
            return Predicted(oil, 0.0, NO_LAG, 0, math.nan)
        if math.isnan(oil):  # use the friction at the measured temperature
            oil = reading.value
        key = point._replace(at=oil)
        if key not in solved:
            scene = self._scene(point, state)
            scene.near = self._near.setdefault(point, {})
            solved[key] = scene, scene.over_pass(oil, state["clearance"])
        scene, over = solved[key]
        shares, rests = zip(*over)

        def mean(of):
            return np.average([of(rest) for rest in rests], axis=0, weights=shares)

        idle = max(int((rest.state.inner.load <= 0).sum()) for rest in rests)
        angle = float(mean(lambda rest: _contact_angle(rest.state)))
        if reading.quantity == "temperature":
            lost = scene.figures(over)["power_loss_W"]
            steady = self.readings.ambient + lost / state["conductance"]
            return Predicted(steady, 0.0, NO_LAG, idle, angle)
        if reading.quantity == "capacitance":
            whole = float(mean(lambda rest: rest.films.total))
            return Predicted(whole, 0.0, NO_LAG, idle, angle)

        def of_cage(of):
            return float(mean(lambda rest: of(self.bearing, rest.state, self.readings.models)))

        if reading.quantity == "BSF":
            spin = of_cage(cage_speed.ball_order)
            return Predicted(spin, cage_speed.ERROR * spin, NO_LAG, idle, angle)
        lag = NO_LAG
        if self.readings.models != "paper":
            lag = tuple(mean(lambda rest: cage_speed.lags(self.bearing, rest.state)).tolist())
        return self._line(reading.quantity, of_cage(cage_speed.order), angle, lag, idle)

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
            self._lubricant,
            self._roughness,
            load + point.load_more,
            axial,
            point.rpm,
            self._balls,
            models=self.readings.models,
            held=held,
            size=self._size,
        )


def _contact_angle(state):
    load = np.concatenate([state.inner.load, state.outer.load])
    angles = np.concatenate([state.inner.angle, state.outer.angle])
    return math.acos(np.average(np.cos(angles), weights=load))


class Misfit(NamedTuple):
    """Differences between predicted and measured values."""

    off: Floats  # (N,), differences in the units of the readings
    covariance: Floats  # (N, N), covariance of the combined errors of readings and model
    within: Floats  # (N,), standard deviations of the readings alone

    @property
    def relative(self) -> Floats:
        """Differences (N,) divided by their standard deviations."""
        return self.off / np.sqrt(np.diag(self.covariance))

    @property
    def independent(self) -> Floats:
        """Combinations (N,) of the differences that are independent and have a standard deviation
        of 1."""
        return np.linalg.solve(np.linalg.cholesky(self.covariance), self.off)

    @property
    def width(self) -> float:
        """Deviance of a perfect fit. It makes a state that predicts wide ranges less likely than a
        state that fits equally well with narrow ranges."""
        scaled = self.covariance / np.outer(self.within, self.within)
        return float(np.linalg.slogdet(scaled)[1])

    @property
    def deviance(self) -> float:
        """-2 log of the likelihood, up to a constant."""
        return float(self.independent @ self.independent) + self.width


class Errors(NamedTuple):
    """Errors of predictions, in the units of the readings."""

    shift: Floats  # (N,), mean change due to the lag of the cage
    cage: Floats  # (N,), standard deviation due to the cage speed, with the sign of its effect
    alone: Floats  # (N,), standard deviation of the other errors, which are independent


def errors(rows: Sequence[Reading], found: Sequence[Predicted], lags: Floats) -> Errors:
    """Return the `Errors` of the predictions `found` of the readings `rows`, including the errors
    of the readings themselves.

    `lags` (N, 2) contains the smallest and the largest lag of the cage for each reading. The mean
    of both shifts a line, and the range between them counts as an error.
    """
    # change of a line per relative change of the cage speed; 0 for other readings
    size = np.array([_of_cage(one.quantity) * own.error for one, own in zip(rows, found)])
    size /= cage_speed.ERROR
    spread = np.ptp(lags, axis=1) * math.sqrt(1 / 12)
    own = [0.0 if along else one.error for along, one in zip(size, found)]
    within = [one.within for one in rows]
    cage = size * np.hypot(cage_speed.ERROR, spread)
    return Errors(-size * np.mean(lags, axis=1), cage, np.hypot(own, within))


def misfit(rows: Sequence[Reading], found: Sequence[Predicted], lags: Floats) -> Misfit:
    """Return the `Misfit` between the predictions `found` and the readings `rows`, with `lags` as
    in `errors`. The error of the cage speed is common to all cage lines at the same operating
    point."""
    shift, cage, alone = errors(rows, found, lags)
    off = [own.value - one.value for one, own in zip(rows, found)] + shift
    same = [[one.point == other.point for one in rows] for other in rows]
    within = np.array([one.within for one in rows])
    return Misfit(off, np.outer(cage, cage) * same + np.diag(alone**2), within)


def _of_cage(quantity):
    """Return the sign with which a reading changes with the cage speed."""
    return {"FTF": 1, "BPFO": 1, "BPFI": -1}.get(quantity, 0)
