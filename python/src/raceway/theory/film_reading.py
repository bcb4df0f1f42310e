# SPDX-License-Identifier: GPL-2.0-or-later
"""Film thickness read from the capacitance of a bearing as if the plates were its only capacitance.
The resulting curve is used to correct measured film thicknesses."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.theory.electric_point import Point

FACTORS = np.geomspace(0.1, 10.0, 61)


class Reading(NamedTuple):
    """Readings as arrays (N,) with one value for each film thickness. `h_c` is the thickness at the
    largest inner load; the other films are scaled in proportion."""

    h_c: Floats  # m
    capacitance: Floats  # F, capacitance of the whole bearing
    by_plates: Floats  # m, the h_c that results if all capacitance is attributed to the plates
    # m, the h_c that results after subtracting all other capacitance at factor one
    less_constant: Floats


def curve(point: Point, factors: ArrayLike = FACTORS) -> Reading:
    """Return the `Reading` of a bearing at one operating point for films that are `factors` times
    as thick as computed.

    The capacitance of the plates is inversely proportional to the film thickness; the permittivity
    is constant. `less_constant` is the reading of a bridge that was zeroed with the surroundings at
    the model's film thickness; it is NaN if nothing remains after the subtraction. Raises
    `ValueError` if no ball is loaded on both raceways.
    """
    every = point.every()
    plates = float(point.mean([one.plates for one in every]))
    if not plates > 0:
        raise ValueError("no ball is loaded on both raceways: there are no plates")
    inner = every[point.heaviest].inner
    h_c = float(inner.separation[np.argmax(inner.load)])
    factors = np.asarray(factors, float)
    total = np.array([point.total(factor) for factor in factors])
    left = total - (point.total() - plates)
    with np.errstate(divide="ignore"):
        less = np.where(left > 0, h_c * plates / left, np.nan)
    return Reading(h_c * factors, total, h_c * plates / total, less)


def corrected(reading: Reading, by_plates: ArrayLike) -> Floats:
    """Return the film thickness in m for readings `by_plates` (m), interpolated along the curve;
    NaN beyond its ends.

    >>> curve = Reading(*(np.array(one) for one in ([1., 2.], [3., 2.], [.5, .8], [1., 2.])))
    >>> corrected(curve, [.5, .8, .9]).round(3).tolist()
    [1.0, 2.0, nan]
    """
    logs = np.log(reading.by_plates), np.log(reading.h_c)
    found = np.interp(np.log(np.asarray(by_plates, float)), *logs, left=np.nan, right=np.nan)
    return np.exp(found)
