# SPDX-License-Identifier: GPL-2.0-or-later
"""State of a bearing from readings: clearance, loads, oil temperature, cooling, each with its
uncertainty, and the combinations that the readings cannot separate.

Least squares over statics, friction and films within the ranges of the unknowns. A range is treated
as the only prior knowledge of an unknown. Where readings leave one direction open, as one line does
for clearance and thrust, the valley is traced and shown: all its points explain the readings.
"""

import math
from typing import NamedTuple

import numpy as np
from scipy import optimize
from scipy.stats import qmc

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.recordings.prediction import Model, residuals
from raceway.recordings.readings import Readings

TRIED = 8  # starting points for each unknown; the best are refined until one explains the readings
REFINED = 4
STEP = 1e-4  # share of a range, for derivatives
UNIFORM = 1 / math.sqrt(12)  # standard deviation of a range of 1
OPEN = 0.35  # share of it above which an unknown or direction counts as not determined
VALLEY = 7  # points traced
CHI = 3.84  # rise of the sum of squares at 95 %, one unknown
TWO_SIDED = 1.96
FAR = 1e3  # residual of a state that cannot carry the load
WIDE = 10.0  # ratio of its ends above which a range is searched logarithmically


class Value(NamedTuple):
    """An unknown."""

    best: float
    low: float  # of the 95 % interval, within the range given
    high: float
    determined: bool  # determined by the readings; otherwise it lies on the valley


class Found(NamedTuple):
    """Result of `identify`."""

    values: dict[str, Value]
    state: dict[str, float]  # best values and known values
    residuals: Floats  # (readings,), divided by their uncertainties
    predicted: Floats  # (readings,)
    # states that explain the readings equally well; empty: one point
    valley: list[dict[str, float]]
    idle: int  # largest number of unloaded balls at any point

    @property
    def chi(self) -> float:
        """Sum of the squares of the residuals: about the number of readings minus that of
        determined unknowns, unless a reading or the model is wrong."""
        return float(self.residuals @ self.residuals)


def identify(readings: Readings) -> Found:
    """`Found` from `readings`. Raises `NoEquilibrium` if no state within the ranges carries the
    loads."""
    search = _Search(readings)
    best = search.best()
    if search.idle(best).any():  # the play of the pockets matters there
        search.slip = search.lag(best)
        best = search.refine(best)
    names = list(readings.unknown)
    spread = search.spread(best)
    weak = spread > OPEN * UNIFORM
    valley = search.valley(best, int(np.argmax(spread))) if weak.any() else []
    values = {}
    for k, name in enumerate(names):
        low, high = best[k] - TWO_SIDED * spread[k], best[k] + TWO_SIDED * spread[k]
        if valley:
            # away from the valley the uncertainty is that across it
            across = TWO_SIDED * search.across(best)[k]
            low = min(one[k] for one in valley) - across
            high = max(one[k] for one in valley) + across
        span = [search.value(name, min(max(one, 0.0), 1.0)) for one in (low, best[k], high)]
        values[name] = Value(span[1], span[0], span[2], not weak[k])
    predicted = search.predicted(best)
    return Found(
        values,
        search.state(best),
        search.residuals(best),
        np.array([one.value for one in predicted]),
        [search.state(one) for one in valley],
        max(one.idle for one in predicted),
    )


def value_of(of: Readings, name: str, share: float) -> float:
    """The unknown `name` at a `share` of its range, 0 to 1."""
    low, high = of.unknown[name]
    if low > 0 and high / low >= WIDE:
        return float(low * (high / low) ** share)
    return float(low + (high - low) * share)


def share_of(of: Readings, name: str, value: float) -> float:
    """The inverse of `value_of`."""
    low, high = of.unknown[name]
    if low > 0 and high / low >= WIDE:
        return math.log(value / low) / math.log(high / low)
    return (value - low) / (high - low)


class _Search:
    """The unknowns as fractions, 0 to 1, of their ranges."""

    def __init__(self, readings):
        self.readings, self.model = readings, Model(readings)
        self.slip = np.zeros((len(readings.readings), 2))

    def value(self, name, share):
        return value_of(self.readings, name, share)

    def state(self, place):
        found = {name: float(self.value(name, x)) for name, x in zip(self.readings.unknown, place)}
        return {**self.readings.known, **found}

    def predicted(self, place):
        return self.model.predict(self.state(place))

    def residuals(self, place):
        try:
            return residuals(self.readings, self.predicted(place), self.slip)
        except NoEquilibrium:
            return np.full(len(self.readings.readings), FAR)

    def idle(self, place):
        return np.array([one.idle for one in self.predicted(place)])

    def lag(self, place):
        return np.array([one.lag for one in self.predicted(place)])

    def best(self):
        size = len(self.readings.unknown)
        tried = qmc.Sobol(size, scramble=False).random(1 << math.ceil(math.log2(TRIED * size)))
        costs = [float((self.residuals(one) ** 2).sum()) for one in tried]
        if min(costs) >= FAR**2:
            self.predicted(tried[int(np.argmin(costs))])  # says what is wrong
        found, least = tried[0], math.inf
        for k in np.argsort(costs)[:REFINED]:
            place = self.refine(tried[k])
            cost = float((self.residuals(place) ** 2).sum())
            if cost < least:
                found, least = place, cost
            if least < CHI * len(self.slip):
                break
        return found

    def refine(self, start, fixed=None):
        """Least squares from `start`, with the unknown of the number `fixed` held."""
        free = np.array([k != fixed for k in range(len(start))])

        def rest(x):
            place = np.array(start)
            place[free] = x
            return self.residuals(place)

        place = np.array(start)
        inside = np.clip(place[free], 1e-6, 1 - 1e-6)
        if len(inside):
            place[free] = optimize.least_squares(
                rest, inside, bounds=(0, 1), diff_step=STEP, xtol=1e-5, ftol=1e-6
            ).x
        return place

    def slopes(self, place):
        """(readings, unknowns) derivatives of the residuals."""
        columns = []
        for k in range(len(place)):
            ends = np.array([place, place])
            ends[0, k], ends[1, k] = max(place[k] - STEP, 0.0), min(place[k] + STEP, 1.0)
            low, high = (self.residuals(one) for one in ends)
            columns.append((high - low) / (ends[1, k] - ends[0, k]))
        return np.transpose(columns)

    def spread(self, place):
        """Standard deviations (unknowns,) as fractions of their ranges."""
        slopes = self.slopes(place)
        known = slopes.T @ slopes + np.eye(len(place)) / UNIFORM**2
        return np.sqrt(np.diag(np.linalg.inv(known)))

    def across(self, place):
        """The same without the weakest direction."""
        slopes = self.slopes(place)
        values, vectors = np.linalg.eigh(slopes.T @ slopes)
        strong = vectors[:, 1:] / np.sqrt(np.maximum(values[1:], 1e-300))
        return np.minimum(np.sqrt((strong**2).sum(1)), UNIFORM)

    def valley(self, best, along):
        """States that explain the readings as well as the best one, along the unknown with the
        number `along`."""
        limit = float((self.residuals(best) ** 2).sum()) + CHI
        side, places = np.linspace(0, 1, VALLEY), []
        near = int(np.argmin(np.abs(side - best[along])))
        for way in (range(near, len(side)), range(near - 1, -1, -1)):
            place = np.array(best)
            for k in way:
                place[along] = side[k]
                place = self.refine(place, along)
                if float((self.residuals(place) ** 2).sum()) <= limit:
                    places.append(np.array(place))
        return sorted([*places, np.array(best)], key=lambda one: one[along])
