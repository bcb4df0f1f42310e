# SPDX-License-Identifier: GPL-2.0-or-later
"""Times of entry and impact when balls pass over a spall, from an acceleration or a contact load.

When a ball enters the spall, its load decreases by a term that is quadratic in the distance and,
due to damping, by a linear term (low frequencies). It hits the far edge half-way through the spall
or later (a sharp bend, high frequencies). `spall.length` and `kinematics.spall_length` convert the
time between entry and impact into a length (Sawalha and Randall, Mech. Syst. Signal Process. 25
(2011) 846).
"""

import warnings
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy import optimize, signal

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs import spectrum
from raceway.runs.source import Source
from raceway.theory import kinematics

QUIET = 0.25  # initial fraction of the time before an impact that is assumed to contain no entry
# An impact begins at bends above these multiples of the sharpest bend in this quiet time.
SHARP, ABOVE = 4.0, 1.5
ONSET = 0.2  # the first impact of a passage exceeds this fraction of its sharpest bend
STRONG = 0.7  # a passage with at least this fraction of the deepest dip is in the load zone
# A signal counts as disturbed above these fractions of the largest value before the impact and of
# the sharpest bend.
LEAST, FAINT = 0.02, 0.02
CALM = (0.3, 0.6)  # part of the time from entry to the strong bends that contains no impact
SMOOTH = 0.5  # ratio of largest bend to largest value in the quiet time; lower values mean ringing
# An impact begins at a jump above this multiple of the largest jump in the calm time and above this
# fraction of the largest jump of the passage.
JUMP, FAINTEST = 3.0, 0.12
RESTLESS = 0.04  # unrest before entries, as a fraction of the dip, above which some may be missed
REACH = 6.0  # search range for the entry, in multiples of the time from first sign to end of fit
FOLDS = 4  # samples in a bin of the folded record
FEWEST = 32  # minimum number of samples around an impact
# Hz, lowest sampling rate of a signal that has passed the filter of a sensor. In runs of a 6206
# under 800 N, the lengths found for spalls of 1 to 2.5 mm are up to 6 % too short at 64 kHz, and
# all about 1 mm at 48 kHz. In a 6205, the length found for a spall of 1 mm is 13 % too short at 64
# kHz (docs/tutorial_spall).
SLOWEST = 60e3


class Passages(NamedTuple):
    """Ball passages with an entry and an impact, as arrays (N,)."""

    entry: Floats  # s, time of entry from the first value
    blow: Floats  # s, time of impact
    dip: Floats  # first peak after the entry, in the unit of the signal
    unrest: Floats  # amplitude before the entry relative to the dip, due to ringing or noise

    @property
    def seconds(self) -> Floats:
        """Time from entry to impact in s."""
        return self.blow - self.entry

    @property
    def strong(self) -> "Passages":
        """Passages with at least 0.7 of the deepest dip. This matters for a spall on the inner
        raceway, which rotates through the load zone."""
        kept = self.dip >= STRONG * self.dip.max(initial=0.0)
        return Passages(*(values[kept] for values in self))


def find(
    values: ArrayLike,
    sample_s: float,
    period_s: float,
    reach_s: float | None = None,
    share: float = 0.5,
) -> Passages:
    """Return the `Passages` in evenly sampled `values` (N,) that are `sample_s` apart.

    A ball reaches the spall every `period_s`, which is 1/BPFO or 1/BPFI for the acceleration of a
    ring, and Z times this period for the contact load of one ball. A passage lasts from `reach_s`
    before to `reach_s` after an impact, by default half a period. In the first quarter of the time
    before the impact, the signal must be quiet, i.e. follow a straight line. The entry is the start
    of a linear and a quadratic term, which are fitted up to a fraction `share` of the first peak.
    The impact is the jump of the second derivative or, at a rounded edge, the start of the
    rounding. A contact load bends sooner than an acceleration: use a `share` of 0.1 and a reach of
    three times the time from entry to impact. Passages without a distinct impact, or whose entry is
    hidden by noise, are omitted.

    Raise `ValueError` for a reach below 16 samples or above half a period, for values shorter than
    a period, and for a share that is not between 0 and 1.

    In this example, a ball passes two edges every 50 ms, and the impact follows 2 ms after entry:

    >>> time = np.arange(20000) / 1e5
    >>> way = np.maximum(1 - np.abs((time - 0.03) % 0.05 - 0.02) / 2e-3, 0)
    >>> print((1e3 * find(-(way**2), 1e-5, 0.05).seconds).round(2))
    [2. 2. 2.]
    """
    values = np.asarray(values, float)
    reach_s = 0.5 * period_s if reach_s is None else reach_s
    if not 0.5 * FEWEST * sample_s <= reach_s <= 0.5 * period_s:
        raise ValueError(
            f"reach {reach_s:g} s must be from {FEWEST // 2} samples"
            f" ({0.5 * FEWEST * sample_s:g} s) to half a period ({0.5 * period_s:g} s)"
        )
    if len(values) * sample_s < period_s:
        raise ValueError(f"{len(values)} values must cover a period of {period_s:g} s")
    if not 0 < share < 1:
        raise ValueError(f"share is {share:g}, must lie between 0 and 1")
    turn = np.diff(values, 2, prepend=values[0], append=values[-1])
    count, reach = period_s / sample_s, reach_s / sample_s
    first, found = _phase(turn, count), []
    for middle in np.arange(first, len(values), count):
        start, stop = int(np.ceil(middle - reach)), int(middle + reach)
        if start >= 0 and stop <= len(values):
            one = _passage(values[start:stop], turn[start:stop], share)
            if one is not None:
                found.append((start + one[0], start + one[1], *one[2:]))
    entry, blow, dip, unrest = np.array(found).reshape(-1, 4).T
    return Passages(entry * sample_s, blow * sample_s, dip, unrest)


def _phase(turn, count):
    """Return the position (in samples) of the sharpest bend within a period of `count` samples,
    after all periods have been folded into one."""
    bins = int(count / FOLDS)
    place = (np.arange(len(turn)) % count * bins / count).astype(int) % bins
    sharp = np.bincount(place, turn**2, bins)
    return (np.argmax(sharp + np.roll(sharp, 1) + np.roll(sharp, -1)) + 0.5) * count / bins


def _passage(values, turn, share):
    """Return (entry, impact, dip, unrest) of the `values` around one impact, or None.

    Entry and impact are in samples; `turn` contains the second differences of the values.
    """
    bend = np.abs(turn)
    quiet = slice(0, int(0.5 * QUIET * len(values)))
    place = np.arange(len(values), dtype=float)
    away = values - np.polyval(np.polyfit(place[quiet], values[quiet], 1), place)
    floor = bend[quiet].max()
    if not bend.max() > SHARP * floor:
        return None
    blow = int(np.argmax(bend > max(ONSET * bend.max(), ABOVE * floor)))
    left = np.abs(away[quiet]).max()
    # The quadratic term bends uniformly, so it is visible even if ringing exceeds the dip.
    notices = [(bend, FAINT * bend.max())]
    if floor > SMOOTH * left or left < LEAST * np.abs(away[: blow + 1]).max():
        notices.append((np.abs(away), LEAST * np.abs(away[: blow + 1]).max()))
    else:  # earlier ringing, so there is no straight line to extrapolate
        away = values
    found = [
        np.flatnonzero(one[: blow + 1] > max(ABOVE * one[quiet].max(), least))
        for one, least in notices
    ]
    start = int(min((one[0] for one in found if len(one)), default=blow))
    size = np.abs(away - away[start])
    top = start
    while top < blow and size[top + 1] > size[top]:
        top += 1
    end = start + int(np.argmax(size[start : top + 1] >= share * size[top]))
    entry = _entry(values, start, end, _ringing(values[blow:]))
    if entry is None:
        return None
    just_before = slice(max(int(entry) - quiet.stop, 0), max(int(entry), 2))
    unrest = np.sqrt(2) * max(values[quiet].std(), values[just_before].std())
    return entry, _begin(turn, entry, blow), size[top], unrest / (size[top] or 1.0)


def _begin(turn, entry, blow):
    """Return the start of the impact whose strong bends begin at the index `blow`.

    It is the first jump of `turn` that exceeds the earlier jumps. A rounded edge first causes a
    weak bend; ringing causes bends without a jump.
    """
    jump = np.abs(np.diff(turn, prepend=turn[0]))
    first, last = (max(int(entry + part * (blow - entry)), 0) for part in CALM)
    after = int(2 * blow - entry)
    least = max(JUMP * jump[first : last + 1].max(), FAINTEST * jump[first : after + 1].max())
    sudden = np.flatnonzero(jump[last : blow + 1] > least)
    return (last + sudden[0] if len(sudden) else blow) + 0.5  # between two values


def _entry(values, start, end, ringing):
    """Return the start of a linear and a quadratic term of the same sign on top of a line and a
    decaying `ringing` (rad per sample), or None.

    The start is found near the index `start` by a least-squares fit up to the index `end`.
    """
    if end - start < 1:
        return None
    place = np.arange(end + 1) - float(end)
    place = place[max(0, end - int(4 * np.pi / ringing + REACH * (end - start))) :]
    rest = [np.ones_like(place), place, *_waves(place, ringing)]
    values = values[-len(place) + end + 1 : end + 1]
    # `miss` is the residual of the values and of the two terms after the fit of line and ringing,
    # as a function of the start of the terms.
    base = np.linalg.qr(np.transpose(rest))[0]
    left = values - base @ (base.T @ values)

    def miss(entry):
        on = np.maximum(place - entry, 0.0)
        line, square = (one - base @ (base.T @ one) for one in (on, on**2))
        ll, ls, ss, lv, sv = line @ line, line @ square, square @ square, line @ left, square @ left
        a, b = ss * lv - ls * sv, ll * sv - ls * lv
        if a * b > 0:  # damping has the same sign as the spring term
            return -(a * lv + b * sv) / (ll * ss - ls**2)
        return -(sv**2) / ss

    first = -int(REACH * (end - start))
    tried = np.arange(first, 0)
    best = tried[np.argmin([miss(one) for one in tried])]
    if best == first:
        return None
    found = optimize.minimize_scalar(miss, bounds=(best - 1, min(best + 1, -1)), method="bounded")
    return float(end + found.x)


def _waves(place, ringing):
    turn = ringing * place
    return np.cos(turn), np.sin(turn), place * np.cos(turn), place * np.sin(turn)


def _ringing(values):
    """Return the strongest frequency of `values` after an impact, in rad per sample."""
    heard = signal.detrend(values) * np.hanning(len(values))
    lines = np.abs(np.fft.rfft(heard, 8 * len(heard)))
    return 2 * np.pi * max(int(np.argmax(lines)), 1) / (8 * len(heard))


def of_run(
    run: Source, raceway: str, name: str = "ay", ring: str = "outer", longest: float = 3e-3
) -> Passages:
    """Return the `Passages` in a column of a `ring` of `run`, or in a channel of a recording.

    The spall is on the "inner" or "outer" `raceway` and is at most `longest` (m) long; earlier
    ringing must have decayed when the ball is still this distance away from the impact. The period
    follows from the cage speed of the run or, for a recording, from kinematics.

    Warn if the sampling rate is below 60 kHz, because the filter of a sensor then hides entry and
    impact. Also warn if the signal before the entries varies by more than 4 % of the depth of the
    dips. Of 31 lengths estimated from runs of the 6205 and 6208 at 1000 to 6000 rpm, 15 had this
    warning, and nine of these were 7 % to 150 % off; the other 16 were within 3.1 %.

    Raise `RunError` in the same cases as `spectrum.signal_of`, for a run without a cage speed, and
    for too few samples; raise `ValueError` for any other raceway.
    """
    if raceway not in ("inner", "outer"):
        raise ValueError(f"raceway is '{raceway}', must be inner or outer")
    values, sample_s, _ = run.signal(name, ring)
    bearing, spin = run.geometry, abs(run.motion.shaft)
    rate = spectrum.places(run, harmonics=1)["BPFI" if raceway == "inner" else "BPFO", 1][1]
    if not (spin and rate):
        raise RunError(f"{run.where}: there are no ball passages, because the shaft is at rest")
    period = 1 / rate
    # A ball hits the far edge before it leaves the spall.
    reach = longest / float(kinematics.entrainment(bearing, spin)) / (1 - QUIET)
    try:
        found = find(values, sample_s, period, min(reach, 0.5 * period))
    except ValueError as error:
        raise RunError(f"{run.where}: {error}") from None
    if sample_s * SLOWEST > 1:
        warnings.warn(
            f"{run.where}: a rate of {1e-3 / sample_s:.5g} kHz is below {1e-3 * SLOWEST:g} kHz:"
            " lengths from a filtered signal can be wrong by half or more",
            stacklevel=2,
        )
    unrest = np.median(found.strong.unrest) if len(found.entry) else 0.0
    if unrest > RESTLESS:
        warnings.warn(
            f"{run.where}: before a ball enters the spall, the signal varies by {unrest:.0%} of the"
            f" depth of the dip (more than {RESTLESS:.0%}): lengths can be wrong by half or more",
            stacklevel=2,
        )
    return found
