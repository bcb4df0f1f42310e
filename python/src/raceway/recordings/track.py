# SPDX-License-Identifier: GPL-2.0-or-later
"""Track the state of a bearing over hours with an unscented Kalman filter.

The unknowns drift as random walks, and each row of readings corrects them with the steady-state
model of `prediction`. Sigma points that represent the mean and the covariance are propagated
through the model, so no derivatives are needed (Julier and Uhlmann, Proc. IEEE 92 (2004) 401).

The error of the model for the speed of the cage, including the unknown lag of a cage with play, is
the same in all rows, so repeated readings do not average it out: it is one more unknown, in
standard deviations.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.recordings.identify import UNIFORM, share_of, value_of
from raceway.recordings.prediction import Model, errors
from raceway.recordings.readings import Reading, Readings

HOUR = 3600.0  # s
# n + kappa of the sigma points; 3 matches the fourth moment of a normal distribution. It is n for
# n > 3, because negative weights could make a covariance negative
KAPPA = 3.0
EDGE = 1e-3  # margin that points keep from the ends of a range, as a fraction of the range


class Row(NamedTuple):
    """Readings taken at the same time."""

    time: float  # s
    readings: list[Reading]


class Track(NamedTuple):
    """State of a bearing as a function of time."""

    time: Floats  # (N,), s
    names: list[str]
    best: Floats  # (N, unknowns)
    low: Floats  # (N, unknowns), two standard deviations below `best`, within the range
    high: Floats
    surprise: Floats  # (N,), squared innovation divided by its expected value; normally near 1


def track(of: Readings, rows: Sequence[Row], drift: Mapping[str, float]) -> Track:
    """Return the `Track` of the unknowns of `of` through `rows`; readings in `of` are not used.

    `drift` contains the standard deviation of each unknown after an hour, in its unit; the default
    is 0. Initially, an unknown may be anywhere in its range. Raise `ValueError` if the times do not
    increase or if a drift does not belong to an unknown, and `NoEquilibrium` if no state near the
    initial one carries the loads.
    """
    if strange := sorted(set(drift) - set(of.unknown)):
        raise ValueError(f"drift: {strange[0]} is not an unknown")
    times = np.array([row.time for row in rows])
    if not len(rows) or not (np.diff(times) > 0).all():
        raise ValueError("the times of the rows of a series must increase")
    names, model = list(of.unknown), Model(of)
    mean = np.append(np.full(len(names), 0.5), 0.0)
    covariance = np.diag(np.append(np.full(len(names), UNIFORM**2), 1.0))
    found = []
    for k, row in enumerate(rows):
        hours = (times[k] - times[k - 1]) / HOUR if k else 0.0
        walk = [_walk(of, name, x, drift.get(name, 0.0)) for name, x in zip(names, mean)]
        covariance = covariance + np.diag(np.square([*walk, 0.0])) * hours
        mean, covariance, surprise = _correct(of, model, row, names, mean, covariance)
        best, spread = mean[:-1], 2 * np.sqrt(np.diag(covariance)[:-1])
        found.append((best, np.maximum(best - spread, 0), np.minimum(best + spread, 1), surprise))
    shares = [np.array([one[k] for one in found]) for k in range(3)]
    best, low, high = (
        np.array([[value_of(of, name, x) for name, x in zip(names, row)] for row in one])
        for one in shares
    )
    return Track(times, names, best, low, high, np.array([one[3] for one in found]))


def unscented(
    mean: Floats, covariance: Floats, see: Callable[[Floats], Floats], read: Floats, noise: Floats
) -> tuple[Floats, Floats, float]:
    """Return (mean (n,), covariance (n, n), surprise) after one correction step.

    `see` predicts the readings (k, m) for states (k, n). `read` (m,) contains the readings and
    `noise` (m,) their variances.

    If `see` is linear, this is the ordinary Kalman filter:

    >>> see = lambda x: x[:, :1] + x[:, 1:]
    >>> found = unscented(np.zeros(2), np.eye(2), see, np.array([3.0]), np.array([1.0]))
    >>> found[0].round(6), float(found[1][0, 0].round(6))
    (array([1., 1.]), 0.666667)
    """
    size = len(mean)
    kappa = max(KAPPA, size)
    root = np.linalg.cholesky(kappa * covariance).T
    points = np.array([mean, *(mean + root), *(mean - root)])
    weights = np.array([1 - size / kappa, *np.full(2 * size, 0.5 / kappa)])
    shown = see(points)
    centre = weights @ shown
    away, off = shown - centre, points - mean
    expected = (weights[:, None] * away).T @ away + np.diag(noise)
    gain = np.linalg.solve(expected, (weights[:, None] * away).T @ off).T
    rest = read - centre
    surprise = float(rest @ np.linalg.solve(expected, rest)) / len(read)
    left = covariance - gain @ expected @ gain.T
    return mean + gain @ rest, (left + left.T) / 2, surprise


def _correct(of, model, row, names, mean, covariance):
    """Apply `unscented` to the readings of a row, keeping the points inside the ranges. The last
    unknown is the error of the cage speed."""
    centre = model.predict(_state(of, names, mean), row.readings)
    # readings of different units are divided by their own deviations
    unit = errors(row.readings, centre, np.zeros((len(centre), 2))).alone

    def predicted(place):
        if np.array_equal(place[:-1], mean[:-1]):
            return centre
        try:
            return model.predict(_state(of, names, place), row.readings)
        except NoEquilibrium:  # the central point adds no information
            return centre

    def see(points):
        shown = [predicted(place) for place in points]
        # the range of the lag at all points, so that it does not tell the points apart
        lags = np.array([[one.lag for one in own] for own in shown])
        lags = np.stack([lags[..., 0].min(axis=0), lags[..., 1].max(axis=0)], axis=1)
        shift, cage, _ = errors(row.readings, centre, lags)
        values = np.array([[one.value for one in own] for own in shown])
        return (values + shift + np.outer(points[:, -1], cage)) / unit

    read = np.array([one.value for one in row.readings]) / unit
    mean, covariance, surprise = unscented(mean, covariance, see, read, np.ones(len(read)))
    mean[:-1] = np.clip(mean[:-1], EDGE, 1 - EDGE)
    return mean, covariance, surprise


def _state(of, names, place):
    inside = np.clip(place[: len(names)], EDGE, 1 - EDGE)
    return {**of.known, **{name: value_of(of, name, x) for name, x in zip(names, inside)}}


def _walk(of, name, share, drift):
    """Return the standard deviation of the drift after one hour, evaluated at the current value, as
    a fraction of the range."""
    if not drift:
        return 0.0
    return abs(share_of(of, name, value_of(of, name, share) + drift) - share)
