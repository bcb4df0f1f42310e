# SPDX-License-Identifier: GPL-2.0-or-later
"""Film thickness read from a bearing's capacitance as if it were the capacitance of the plates
alone: a curve for correcting measured film thicknesses."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.theory.electric_point import Point

FACTORS = np.geomspace(0.1, 10.0, 61)


class Reading(NamedTuple):
    """Arrays (N,) with one value for each film thickness: `h_c` is the thickness at the largest
    inner load; the other films are scaled in proportion."""

    h_c: Floats  # m
    capacitance: Floats  # F, of the whole bearing
    by_plates: Floats  # m: h_c if the plates were the whole capacitance
    less_constant: Floats  # m: h_c after subtracting all but the plates' share at factor one


def curve(point: Point, factors: ArrayLike = FACTORS) -> Reading:
    """`Reading` of a bearing at one operating point with its films `factors` times as thick.

    The plates are inversely proportional to the film, at constant permittivity. `less_constant` is
    the reading of a bridge zeroed with the surroundings at the model's film thickness; NaN where
    nothing remains. Raises `ValueError` if no ball is loaded on both raceways.
    """
    whole = point.capacitors()
    plates = whole.plates
    if not plates > 0:
        raise ValueError("no ball is loaded on both raceways: there are no plates to read")
    h_c = float(whole.inner.separation[np.argmax(whole.inner.load)])
    factors = np.asarray(factors, float)
    total = np.array([point.capacitors(factor).total for factor in factors])
    left = total - (whole.total - plates)
    with np.errstate(divide="ignore"):
        less = np.where(left > 0, h_c * plates / left, np.nan)
    return Reading(h_c * factors, total, h_c * plates / total, less)


def corrected(reading: Reading, by_plates: ArrayLike) -> Floats:
    """Film thickness in m for readings `by_plates` (m), along the curve; NaN beyond its ends.

    >>> curve = Reading(*(np.array(one) for one in ([1., 2.], [3., 2.], [.5, .8], [1., 2.])))
    >>> corrected(curve, [.5, .8, .9]).round(3).tolist()
    [1.0, 2.0, nan]
    """
    logs = np.log(reading.by_plates), np.log(reading.h_c)
    found = np.interp(np.log(np.asarray(by_plates, float)), *logs, left=np.nan, right=np.nan)
    return np.exp(found)
