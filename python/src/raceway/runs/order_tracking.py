# SPDX-License-Identifier: GPL-2.0-or-later
"""Order tracking: a signal resampled at even angles of the inner against the outer ring.

Lines at multiples of the shaft's speed then stay at their order while the speed changes.
"""

import math

import numpy as np
from numpy.typing import ArrayLike
from scipy import interpolate

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.run import Run
from raceway.runs.turning import changes

MOST = 50  # times the samples of the signal


def at_even_angles(values: ArrayLike, angle: ArrayLike) -> tuple[Floats, float]:
    """(`values` (M,) at even angles, their spacing in turns) from `values` (N,) at `angle` (N,) in
    rad, by cubic splines.

    Raises `ValueError` for an angle that is not strictly monotonic.
    """
    turns = np.asarray(angle, float) / (2 * math.pi)
    turns = np.abs(turns - turns[0])
    steps = np.diff(turns)
    if not (steps > 0).all():
        raise ValueError("the shaft must turn one way for an order axis")
    # as fine as the samples at the lowest speed, so that no frequency is lost
    count = int(turns[-1] / steps.min()) + 1
    if count > MOST * len(turns):
        raise ValueError("the shaft nearly stops: choose samples during which it turns")
    even = np.linspace(0.0, turns[-1], count)
    return interpolate.CubicSpline(turns, np.asarray(values, float))(even), even[1]


def changes_speed(run: Run) -> bool:
    """True if the speed of the shaft of `run` changes: by more than 1 % of its mean."""
    return changes(run.tables.turning.shaft_speed(run.tables.first, run.tables.last))


def tracked(run: Run, values: Floats, orders: bool | None = None) -> tuple[Floats, float, bool]:
    """(`values` (M,), their spacing, True for orders) of the samples `values` (N,) of `run`: as
    they are, in s, or at even angles, in turns, where the speed changes or `orders` is true.

    Raises `RunError` for a shaft that reverses or nearly stops.
    """
    if not (changes_speed(run) if orders is None else orders):
        return values, run.settings["sample_s"], False
    angle = run.tables.turning.shaft(run.tables.first, run.tables.last)
    try:
        return *at_even_angles(values, angle), True
    except ValueError as error:
        raise RunError(f"{run.tables.record.path}: {error}") from None
