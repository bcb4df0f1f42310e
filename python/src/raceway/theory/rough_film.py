# SPDX-License-Identifier: GPL-2.0-or-later
"""Mean of 1/gap for a rough film relative to a smooth film, as a function of L = h/sigma. Here h is
the mean gap, and sigma is the rms composite roughness. Functions accept numbers or arrays of equal
shape.

The sigma measured with a profilometer is an upper bound, because long wavelengths are flattened
under pressure.
"""

from typing import NamedTuple

import numpy as np
from scipy.special import ndtr

from raceway.arrays import Numbers
from raceway.core import laws

NODES, WEIGHTS = np.polynomial.legendre.leggauss(200)
HIGHEST = 8.0  # upper limit of the integral, in multiples of sigma above the mean


class Clipped(NamedTuple):
    """A film with a Gaussian gap, which is solid where the gap is thinner than a boundary film."""

    factor: Numbers  # `factor` for the open part
    closed: Numbers  # fraction of the area that is closed


def factor(ratio: Numbers) -> Numbers:
    """Return L^2/(L^2 - 1) for a film whose gap has a gamma distribution. The factor is constant
    below L = 2.5, where films are partly closed and the closed parts are not capacitors (see
    `clipped`).

    >>> [round(float(factor(L)), 4) for L in (3.0, 10.0)]
    [1.125, 1.0101]
    """
    return laws.rough_film_factor(1 / np.asarray(ratio))


def clipped(ratio: Numbers, boundary: Numbers) -> Clipped:
    """Compute `Clipped` for a Gaussian gap. The surfaces touch where the gap is below `boundary`
    sigmas, which represents a boundary film of 2 to 10 nm. Raises `ValueError` if `boundary` is not
    positive.
    """
    ratio, boundary = np.broadcast_arrays(np.asarray(ratio, float), np.asarray(boundary, float))
    if not np.all(boundary > 0):
        raise ValueError(f"boundary = {boundary} must be positive")
    # the gap grows exponentially from node to node, which makes 1/gap smooth
    low, high = np.log(boundary), np.log(np.maximum(ratio + HIGHEST, 2 * boundary))
    middle, half = (low + high) / 2, (high - low) / 2
    gap = np.exp(middle[..., None] + half[..., None] * NODES)
    density = np.exp(-((gap - ratio[..., None]) ** 2) / 2) / np.sqrt(2 * np.pi)
    mean = (WEIGHTS * density).sum(-1) * half  # mean of 1/gap
    return Clipped((ratio * mean)[()], ndtr(boundary - ratio)[()])
