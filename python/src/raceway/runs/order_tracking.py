# SPDX-License-Identifier: GPL-2.0-or-later
"""Order tracking: resample a signal at equal increments of the angle of the inner ring relative to
the outer ring.

Lines at multiples of the shaft speed then keep their order while the speed changes.
"""

import math

import numpy as np
from numpy.typing import ArrayLike
from scipy import interpolate

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.source import Signal, Source
from raceway.runs.turning import changes

MOST = 50  # largest number of resampled values per sample of the signal


def at_even_angles(values: ArrayLike, angle: ArrayLike) -> tuple[Floats, float]:
    """Resample `values` (N,) at `angle` (N,) in rad at evenly spaced angles, using cubic splines.

    Return (values (M,), spacing), where the spacing of the angles is in turns. Raise `ValueError`
    if the angle is not strictly monotonic or if the shaft nearly stops.
    """
    turns = np.asarray(angle, float) / (2 * math.pi)
    turns = np.abs(turns - turns[0])
    steps = np.diff(turns)
    if not (steps > 0).all():
        raise ValueError("the shaft must rotate in one direction for an order axis")
    # The spacing is as fine as that of the samples at the lowest speed, so no frequency is lost.
    count = int(turns[-1] / steps.min()) + 1
    if count > MOST * len(turns):
        raise ValueError("the shaft nearly stops: choose samples during which it rotates")
    even = np.linspace(0.0, turns[-1], count)
    return interpolate.CubicSpline(turns, np.asarray(values, float))(even), even[1]


def changes_speed(of: Source, samples: int) -> bool:
    """Return True if the shaft speed of a run or recording changes by more than 1 % of its mean
    during the `samples` of a signal."""
    return changes(of.shaft_speed(samples))


def tracked(of: Source, signal: Signal, orders: bool | None = None) -> tuple[Floats, float, bool]:
    """Return (values (M,), spacing, True for orders) for a `signal` of a run or recording `of`.

    If the speed changes or if `orders` is true, the signal is resampled at evenly spaced angles and
    the spacing is in turns. Otherwise the signal is unchanged and the spacing is in s. Raise
    `RunError` if the shaft reverses or nearly stops.
    """
    values = signal.values
    if not (changes_speed(of, len(values)) if orders is None else orders):
        return values, signal.sample_s, False
    try:
        return *at_even_angles(values, of.shaft_angle(len(values))), True
    except ValueError as error:
        raise RunError(f"{of.where}: {error}") from None
