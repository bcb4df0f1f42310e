# SPDX-License-Identifier: GPL-2.0-or-later
"""Track the state of a bearing over hours with an unscented Kalman filter.

The unknowns drift as random walks, and each row of readings corrects them with the steady-state
model of `prediction`. Sigma points that represent the mean and the covariance are propagated
through the model, so no derivatives are needed (Julier and Uhlmann, Proc. IEEE 92 (2004) 401).
"""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.recordings.identify import UNIFORM, share_of, value_of
from raceway.recordings.prediction import Model, misfit
from raceway.recordings.readings import Reading, Readings

HOUR = 3600.0  # s
KAPPA = 3.0  # n + kappa of the sigma points; 3 matches the fourth moment of a normal distribution
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
    mean, covariance = np.full(len(names), 0.5), np.eye(len(names)) * UNIFORM**2
    found = []
    for k, row in enumerate(rows):
        hours = (times[k] - times[k - 1]) / HOUR if k else 0.0
        walk = [_walk(of, name, x, drift.get(name, 0.0)) for name, x in zip(names, mean)]
        covariance = covariance + np.diag(np.square(walk)) * hours
        mean, covariance, surprise = _correct(of, model, row, names, mean, covariance)
        spread = 2 * np.sqrt(np.diag(covariance))
        found.append((mean, np.maximum(mean - spread, 0), np.minimum(mean + spread, 1), surprise))
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

    `see` predicts the readings (m,) for a state (n,). `read` (m,) contains the readings and `noise`
    (m,) their variances.

    If `see` is linear, this is the ordinary Kalman filter:

    >>> see = lambda x: np.array([x[0] + x[1]])
    >>> found = unscented(np.zeros(2), np.eye(2), see, np.array([3.0]), np.array([1.0]))
    >>> found[0].round(6), float(found[1][0, 0].round(6))
    (array([1., 1.]), 0.666667)
    """
    size = len(mean)
    root = np.linalg.cholesky(KAPPA * covariance).T
    points = np.array([mean, *(mean + root), *(mean - root)])
    weights = np.array([1 - size / KAPPA, *np.full(2 * size, 0.5 / KAPPA)])
    shown = np.array([see(one) for one in points])
    centre = weights @ shown
    away, off = shown - centre, points - mean
    expected = (weights[:, None] * away).T @ away + np.diag(noise)
    gain = np.linalg.solve(expected, (weights[:, None] * away).T @ off).T
    rest = read - centre
    surprise = float(rest @ np.linalg.solve(expected, rest)) / len(read)
    left = covariance - gain @ expected @ gain.T
    return mean + gain @ rest, (left + left.T) / 2, surprise


def _correct(of, model, row, names, mean, covariance):
    """Apply `unscented` to the readings of a row, keeping the points inside the ranges."""
    centre = model.predict(_state(of, names, mean), row.readings)
    rigid = np.zeros((len(centre), 2))
    root = np.linalg.cholesky(misfit(row.readings, centre, rigid).covariance)

    def see(place):
        try:
            shown = model.predict(_state(of, names, place), row.readings)
        except NoEquilibrium:  # use the central point, so that this one adds no information
            shown = centre
        return np.linalg.solve(root, [one.value for one in shown])

    read = np.linalg.solve(root, [one.value for one in row.readings])
    mean, covariance, surprise = unscented(mean, covariance, see, read, np.ones(len(read)))
    return np.clip(mean, EDGE, 1 - EDGE), covariance, surprise


def _state(of, names, place):
    inside = np.clip(place, EDGE, 1 - EDGE)
    return {**of.known, **{name: value_of(of, name, x) for name, x in zip(names, inside)}}


def _walk(of, name, share, drift):
    """Return the standard deviation of the drift after one hour, evaluated at the current value, as
    a fraction of the range."""
    if not drift:
        return 0.0
    return abs(share_of(of, name, value_of(of, name, share) + drift) - share)
