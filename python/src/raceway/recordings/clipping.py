# SPDX-License-Identifier: GPL-2.0-or-later
"""Detect that a signal exceeded the range of its recorder, which cuts off its peaks.

A clipped signal has many samples at exactly its largest value, and few just below it. An unclipped
signal does not, however coarsely it is quantised: the tails of noise fall off, and at the peak of a
sine, where a sine stays longest, the highest level has at most 1/(sqrt(2) - 1) = 2.4 times as many
samples as the next one. The largest value therefore counts as a limit if it has `EXCESS` times as
many samples as the next level, in `VISITS` separate places, since a slow signal may come to rest at
its largest value. Levels are at least a `FINE`-th of the range of the values apart, so that neither
the digits of a number nor rounding matter. Signals of fewer than `LEVELS` levels, such as pulses of
a tachometer, are not judged. The smallest value is treated in the same way.
"""

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats

EXCESS, VISITS, FINE, LEVELS = 6, 5, 4096, 8


def share(values: ArrayLike) -> float:
    """Return the fraction of the `values` (N,) that lie at a limit of the recorder; 0 if the signal
    is not clipped.

    >>> wave = 1.2 * np.sin(np.arange(100000))
    >>> share(wave), round(share(np.clip(wave, -1, 1)), 3), round(share(np.minimum(wave, 1)), 3)
    (0.0, 0.373, 0.186)
    """
    row = np.asarray(values, float)
    low, high = float(row.min()), float(row.max())
    if not high > low:
        return 0.0
    scale = FINE / (high - low)
    return (_at_limit((high - row) * scale) + _at_limit((row - low) * scale)) / len(row)


def _at_limit(depth: Floats) -> int:
    """Return the number of samples at a `depth` (N,) of exactly 0 below a limit, in units of the
    smallest distance of levels; 0 if this is not a limit."""
    cut = depth == 0
    count, visits = int(cut.sum()), int((cut[1:] & ~cut[:-1]).sum() + cut[0])
    levels = np.bincount(depth[~cut].astype(int))
    levels = levels[levels > 0]
    clipped = count >= EXCESS * levels[:2].max() and visits >= VISITS
    return count if clipped and len(levels) >= LEVELS else 0
