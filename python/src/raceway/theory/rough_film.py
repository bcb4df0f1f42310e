# SPDX-License-Identifier: GPL-2.0-or-later
"""Mean of 1/gap of a rough film relative to a smooth film, as a function of L = h/sigma, where h is
the mean gap and sigma the rms composite roughness. Numbers or arrays of one shape.

The sigma of a profilometer is an upper bound, because long waves are flattened under pressure.
"""

from typing import NamedTuple

import numpy as np
from scipy.special import ndtr

from raceway.arrays import Numbers
from raceway.core import laws

NODES, WEIGHTS = np.polynomial.legendre.leggauss(200)
HIGHEST = 8.0  # upper end of the integral, in sigmas above the mean


class Clipped(NamedTuple):
    """A film with a Gaussian gap that is solid where it is thinner than a boundary film."""

    factor: Numbers  # `factor` of the open part
    closed: Numbers  # share of the area


def factor(ratio: Numbers) -> Numbers:
    """L^2/(L^2 - 1) for a gamma-distributed film, constant below L = 2.5, where films are partly
    closed and the closed parts are not capacitors (`clipped`).

    >>> [round(float(factor(L)), 4) for L in (3.0, 10.0)]
    [1.125, 1.0101]
    """
    return laws.rough_film_factor(1 / np.asarray(ratio))


def gauss_cut(ratio: Numbers, cut: float = 3.0) -> Numbers:
    """`factor` for a Gaussian height that is cut at `cut` sigmas and renormalised, as a reference
    for the gamma film. Raises `ValueError` unless L > `cut`; without the cut the mean is infinite.

    >>> [round(float(gauss_cut(L)), 4) for L in (4.0, 5.0, 6.0, 10.0)]
    [1.0755, 1.0441, 1.0294, 1.01]
    """
    ratio = np.asarray(ratio, float)
    if not np.all(ratio > cut):
        raise ValueError(f"h/sigma = {ratio} must be above the cut, {cut}")
    z = cut * NODES
    weight = WEIGHTS * np.exp(-z * z / 2)
    return (weight / weight.sum() * ratio[..., None] / (ratio[..., None] + z)).sum(-1)[()]


def clipped(ratio: Numbers, boundary: Numbers) -> Clipped:
    """`Clipped` for a Gaussian gap; the surfaces touch where the gap is below `boundary` sigmas, a
    boundary film of 2 to 10 nm. Raises `ValueError` for a boundary that is not positive.
    """
    ratio, boundary = np.broadcast_arrays(np.asarray(ratio, float), np.asarray(boundary, float))
    if not np.all(boundary > 0):
        raise ValueError(f"boundary = {boundary} must be positive")
    # the gap grows exponentially from step to step, which makes 1/gap smooth
    low, high = np.log(boundary), np.log(np.maximum(ratio + HIGHEST, 2 * boundary))
    middle, half = (low + high) / 2, (high - low) / 2
    gap = np.exp(middle[..., None] + half[..., None] * NODES)
    density = np.exp(-((gap - ratio[..., None]) ** 2) / 2) / np.sqrt(2 * np.pi)
    mean = (WEIGHTS * density).sum(-1) * half  # mean of 1/gap
    return Clipped((ratio * mean)[()], ndtr(boundary - ratio)[()])
