# SPDX-License-Identifier: GPL-2.0-or-later
"""Balls that pass a spall, in an acceleration or a contact load: entry and blow of each.

A ball loses load from the entry on, as the square of the way (low frequencies). It strikes half-way
or later (a sharp bend, high frequencies). The time between is what `spall.length` and
`kinematics.spall_length` make a length of (Sawalha and Randall, Mech. Syst. Signal Process. 25
(2011) 846).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy import optimize

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs import spectrum
from raceway.runs.run import Run

QUIET = 0.25  # of the time around a blow, at its start: before any entry
SHARP, ABOVE = 4.0, 1.5  # times the sharpest bend of that quiet time: a blow, its begin
ONSET = 0.2  # of the sharpest bend of a passage: its first blow
STRONG = 0.5  # of the sharpest blow of all: those under the load
NOISE = 5.0  # standard deviations of the quiet time: no longer at rest
LEAST = 0.02  # of the largest value before the blow: no longer at rest
REACH = 6.0  # times the time from first notice to there: where the entry is looked for
FOLDS = 4  # samples in a bin of the folded record
FEWEST = 32  # samples around a blow


class Passages(NamedTuple):
    """Ball passages with an entry and a blow; arrays (N,)."""

    entry: Floats  # s from the first value
    blow: Floats  # s
    sharpness: Floats  # of the blow, second difference in the signal's unit

    @property
    def seconds(self) -> Floats:
        """From entry to blow, s."""
        return self.blow - self.entry

    @property
    def strong(self) -> "Passages":
        """Those with at least half the sharpest blow: a spall of the inner raceway turns through
        the load."""
        kept = self.sharpness >= STRONG * self.sharpness.max(initial=0.0)
        return Passages(*(values[kept] for values in self))


def find(
    values: ArrayLike,
    sample_s: float,
    period_s: float,
    reach_s: float | None = None,
    share: float = 0.5,
) -> Passages:
    """`Passages` in evenly sampled `values` (N,), `sample_s` apart, where a ball comes to the spall
    every `period_s`: 1/BPFO or 1/BPFI for a ring's acceleration, Z times that for the contact load
    of one ball.

    A passage is the time `reach_s` before to `reach_s` after a blow, half a period unless given.
    Its first quarter must be quiet, along a straight line. The entry is where a square begins that
    is fitted up to a `share` of the first peak. A contact load bends sooner than an acceleration:
    take a `share` of 0.1, and a reach of three times the time from entry to blow. Passages without
    a blow that stands out, or whose entry is lost in noise, are left out.

    Raises `ValueError` for a reach below 16 samples or above half a period, values shorter than a
    period, and a share outside 0 to 1.

    A ball on two edges, 2 ms from entry to blow, every 50 ms:

    >>> time = np.arange(20000) / 1e5
    >>> way = np.maximum(1 - np.abs((time - 0.03) % 0.05 - 0.02) / 2e-3, 0)
    >>> print((1e3 * find(-(way**2), 1e-5, 0.05).seconds).round(2))
    [2. 2. 2.]
    """
    values = np.asarray(values, float)
    reach_s = 0.5 * period_s if reach_s is None else reach_s
    if not 0.5 * FEWEST * sample_s <= reach_s <= 0.5 * period_s:
        raise ValueError(
            f"reach {reach_s:g} s must be {FEWEST // 2} samples, {0.5 * FEWEST * sample_s:g} s, to"
            f" half a period, {0.5 * period_s:g} s"
        )
    if len(values) * sample_s < period_s:
        raise ValueError(f"{len(values)} values must last a period of {period_s:g} s")
    if not 0 < share < 1:
        raise ValueError(f"share is {share:g}, must lie between 0 and 1")
    bend = np.abs(np.diff(values, 2, prepend=values[0], append=values[-1]))
    count, reach = period_s / sample_s, reach_s / sample_s
    first, found = _phase(bend, count), []
    for middle in np.arange(first, len(values), count):
        start, stop = int(np.ceil(middle - reach)), int(middle + reach)
        if start >= 0 and stop <= len(values):
            one = _passage(values[start:stop], bend[start:stop], share)
            if one is not None:
                found.append((start + one[0], start + one[1], one[2]))
    entry, blow, sharpness = np.array(found).reshape(-1, 3).T
    return Passages(entry * sample_s, blow * sample_s, sharpness)


def _phase(bend, count):
    """Where in a period of `count` samples the record bends most, all periods together; samples."""
    bins = int(count / FOLDS)
    place = (np.arange(len(bend)) % count * bins / count).astype(int) % bins
    sharp = np.bincount(place, bend**2, bins)
    return (np.argmax(sharp + np.roll(sharp, 1) + np.roll(sharp, -1)) + 0.5) * count / bins


def _passage(values, bend, share):
    """(entry, blow, sharpness) in samples of the `values` around one blow, or None."""
    quiet = slice(0, int(QUIET * len(values)))
    place = np.arange(len(values), dtype=float)
    away = values - np.polyval(np.polyfit(place[quiet], values[quiet], 1), place)
    floor = bend[quiet].max()
    if not bend.max() > SHARP * floor:
        return None
    blow = int(np.argmax(bend > max(ONSET * bend.max(), ABOVE * floor)))
    while blow + 1 < len(bend) and bend[blow + 1] > bend[blow]:
        blow += 1
    size = np.abs(away[: blow + 1])
    start = int(np.argmax(size > max(NOISE * np.std(away[quiet]), LEAST * size.max())))
    top = start
    while top < blow and size[top + 1] > size[top]:
        top += 1
    end = start + int(np.argmax(size[start : top + 1] >= share * size[top]))
    entry = _entry(place[: end + 1], away[: end + 1], start)
    return None if entry is None else (entry, float(blow), bend[blow])


def _entry(place, away, start):
    """Where `away` leaves zero as a square, least squares up to its last value; or None."""
    last = place[-1]
    if last - start < 1:
        return None
    first = max(last - REACH * (last - start), 0.0)
    place, away = place[place >= first], away[place >= first]

    def miss(entry):
        shape = np.maximum(place - entry, 0.0) ** 2
        return -((shape @ away) ** 2) / (shape @ shape)  # what the square explains

    found = optimize.minimize_scalar(miss, bounds=(first, last - 1), method="bounded")
    return float(found.x) if found.x > first + 1 else None


def of_run(run: Run, raceway: str, name: str = "ay", ring: str = "outer") -> Passages:
    """`find` in a column of a `ring` of `run`, for a spall of the "inner" or "outer" `raceway`; the
    period is that of the run's own cage speed.

    Raises `RunError` as `spectrum.signal_of` does, for a run that does not say its cage speed, and
    where the samples are too few.
    """
    values, cage = spectrum.signal_of(run, name, ring), spectrum.cage_order(run)
    if cage is None:
        raise RunError(f"{run.tables.folder} does not say the cage speed: it needs a record")
    if raceway not in ("inner", "outer"):
        raise ValueError(f"raceway is '{raceway}', must be inner or outer")
    lines = spectrum.expected(
        run.tables.geometry, abs(run.settings["rpm"]) / 60, harmonics=1, cage=cage
    )
    passing = lines["BPFI" if raceway == "inner" else "BPFO", 1][1]
    try:
        return find(values, run.settings["sample_s"], 1 / passing)
    except ValueError as error:
        raise RunError(f"{run.tables.folder}: {error}") from None
