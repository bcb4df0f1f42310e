# SPDX-License-Identifier: GPL-2.0-or-later
"""Rotation angles of rings, cage and balls of a bearing during a run, and its ball passes.

Speeds may change during a run. The order of a line is therefore a ratio of angles, and a ball pass
is an angle of the cage.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.record import Record
from raceway.theory.bearing import INNER, OUTER

STEADY = 0.01  # fraction of the mean speed; smaller changes are ignored
SPINS = ("x", "y", "z")


class Motion(NamedTuple):
    """Mean speeds in rad/s, computed from angles and positive about the axis."""

    inner: float
    outer: float
    cage: float
    spin: float  # magnitude of the speed of a ball relative to the cage; NaN if not recorded
    angle: float  # contact angle in rad, never negative; NaN if not recorded

    @property
    def shaft(self) -> float:
        """Speed of the inner ring relative to the outer ring, which is the unit of orders."""
        return self.inner - self.outer


class Turning:
    """Angles and speeds of the selected bearing of `record`."""

    def __init__(self, record: Record) -> None:
        self.record = record
        self._balls = int(record.fixed("balls")[0])
        self._passes: Floats = np.zeros(0)

    def ring(self, side: int, start: int = 0, stop: int | None = None) -> Floats:
        """Return the angle (N,) in rad of the ring on one `side` at the samples `start` to `stop`.

        It is measured from the first of these samples, and is 0 for a bearing without that ring.
        """
        return self._ring("ring_angle", side, start, stop, from_start=True)

    def speed(self, side: int, start: int = 0, stop: int | None = None) -> Floats:
        """Return the speed (N,) in rad/s of the ring on one `side` at samples `start` to `stop`."""
        return self._ring("ring_spin", side, start, stop)

    def _ring(self, name, side, start, stop, from_start=False):
        found = self.record.read([name], start, stop)[name]
        here = np.flatnonzero(self.record.fixed("ring_raceway") == side)
        values = found[:, here[0]] if len(here) else np.zeros(len(found))
        return values - values[:1] if from_start else values

    def shaft(self, start: int = 0, stop: int | None = None) -> Floats:
        """Return the angle (N,) in rad of the inner ring relative to the outer ring."""
        return self.ring(INNER, start, stop) - self.ring(OUTER, start, stop)

    def shaft_speed(self, start: int = 0, stop: int | None = None) -> Floats:
        """Return the speed (N,) in rad/s of the inner ring relative to the outer ring."""
        return self.speed(INNER, start, stop) - self.speed(OUTER, start, stop)

    def cage(self, start: int = 0, stop: int | None = None) -> Floats:
        """Return the mean speed (N,) in rad/s of the balls about the axis."""
        return np.nan_to_num(self.record.read(["bearing_cage_speed"], start, stop)[
            "bearing_cage_speed"
        ][:, 0])  # fmt: skip

    def passes(self, sample: ArrayLike) -> Floats:
        """Return the number of ball passes from the first sample of the record to the samples with
        the numbers `sample`, i.e. the cage angle divided by the angle between two balls."""
        sample = np.asarray(sample)
        if not sample.size:
            return sample.astype(float)
        if len(self._passes) <= sample.max():
            parts = [np.abs(self.cage(*part)) for part in self.record.blocks(0, None)]
            angle = _sum(np.concatenate(parts), self.record.attrs["sample_s"])
            self._passes = self._balls / (2 * math.pi) * angle
        return np.interp(sample, np.arange(len(self._passes)), self._passes)

    def motion(self, start: int, stop: int) -> Motion:
        """Return the `Motion` between the samples `start` and `stop`.

        Raise `RunError` for fewer than two samples.
        """
        count = stop - start
        if count < 2:
            raise RunError(f"{self.record.path}: speeds need at least two samples, not {count}")
        time = (count - 1) * self.record.attrs["sample_s"]
        cage = self.cage(start, stop)
        return Motion(
            float(self.ring(INNER, start, stop)[-1]) / time,
            float(self.ring(OUTER, start, stop)[-1]) / time,
            _sum(cage, 1.0)[-1] / (count - 1),
            self._spin(start, stop),
            self._angle(start, stop),
        )

    def _spin(self, start, stop):
        if "ball_omegax" not in self.record.variables:
            return math.nan
        total = 0.0
        for first, last in self.record.blocks(start, stop):
            found = self.record.read([f"ball_omega{x}" for x in SPINS], first, last)
            x, y, z = found.values()
            cage = self.cage(first, last)[:, None]
            total += np.sqrt(x**2 + y**2 + (z - cage) ** 2).mean(axis=1).sum()
        return float(total / (stop - start))

    def _angle(self, start, stop):
        """Return the contact angle whose cosine is the load-weighted mean over all contacts."""
        if not {"angle", "load"} <= set(self.record.contact_columns):
            return math.nan
        cosine = weight = 0.0
        for first, last in self.record.blocks(start, stop):
            found = self.record.read(["angle", "load"], first, last)
            live = found["load"] > 0
            load = found["load"][live]
            cosine += float((load * np.cos(found["angle"][live])).sum())
            weight += float(load.sum())
        return math.acos(min(cosine / weight, 1.0)) if weight else math.nan


def _sum(speed, step):
    """Return the angle (N,), starting at 0, by trapezoidal integration of the speeds (N,)."""
    return step * np.concatenate([[0.0], np.cumsum((speed[1:] + speed[:-1]) / 2)])


def changes(speed: ArrayLike) -> bool:
    """Return True if a speed (N,) changes by more than 1 % of its mean.

    >>> changes([100.0, 100.5]), changes([100.0, 102.0]), changes([0.0, 0.0])
    (False, True, False)
    """
    return bool(np.ptp(speed) > STEADY * abs(np.mean(speed)))
