# SPDX-License-Identifier: GPL-2.0-or-later
"""State of a bearing from readings: clearance, loads, oil temperature, cooling, each with its
uncertainty, and the combinations that the readings cannot separate.

Statics, friction and films are fitted by least squares within the ranges of the unknowns. A range
is the only prior knowledge of an unknown. If the readings leave one direction open, as a single
line does for clearance and thrust, the valley is traced: all its points explain the readings.
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
from raceway.theory import kinematics

TRIED = 8  # starting points for each unknown; the best are refined until one explains the readings
REFINED = 4
STEP = 1e-4  # share of a range, for derivatives
UNIFORM = 1 / math.sqrt(12)  # standard deviation of a range of 1
OPEN = 0.35  # fraction of UNIFORM above which an unknown or direction counts as not determined
VALLEY = 7  # points traced
CHI = 3.84  # increase of the sum of squares at the 95 % limit of one unknown
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
    # rad, mean contact angle weighted by load, at the first reading for which statics is solved;
    # None if only temperatures of the oil were read
    angle: Value | None
    # cage slip there relative to rolling at that angle; None without a line of the cage
    slip: Value | None

    @property
    def chi(self) -> float:
        """Sum of the squared residuals: roughly the number of readings minus the number of
        determined unknowns, unless a reading or the model is wrong."""
        return float(self.residuals @ self.residuals)


def identify(readings: Readings) -> Found:
    """`Found` from `readings`. Raises `NoEquilibrium` if no state within the ranges carries the
    loads."""
    search = _Search(readings)
    best = search.best()
    if search.idle(best).any():  # the pocket play matters there
        search.slip = search.lag(best)
        best = search.refine(best)
    names = list(readings.unknown)
    around = search.covariance(best)
    weak = np.sqrt(np.diag(around)) > OPEN * UNIFORM
    valley = search.valley(best, _along(names, np.diag(around), weak)) if weak.any() else []
    # away from the valley the uncertainty is that across it
    interval = _Interval(
        best,
        [(place, search.covariance(place, weakest=False)) for place in valley] or [(best, around)],
    )
    values = {}
    for k, name in enumerate(names):
        one = interval.of(lambda place, k=k: float(place[k]))
        span = [search.value(name, min(max(share, 0.0), 1.0)) for share in one]
        values[name] = Value(*span, one[2] - one[1] <= 2 * TWO_SIDED * OPEN * UNIFORM)
    predicted = search.predicted(best)
    return Found(
        values,
        search.state(best),
        search.residuals(best),
        np.array([one.value for one in predicted]),
        [search.state(one) for one in valley],
        max(one.idle for one in predicted),
        None if search.first is None else Value(*interval.of(search.angle), not valley),
        None if search.first is None else _slip(search, interval, not valley),
    )


def _along(names, variances, weak):
    """Number of the unknown along which the valley is traced: the more uncertain of clearance and
    thrust if there is one, otherwise the most uncertain unknown."""
    first = [k for k, name in enumerate(names) if weak[k] and name in ("clearance", "axial")]
    return max(first or range(len(names)), key=lambda k: variances[k])


class _Interval(NamedTuple):
    """95 % intervals of functions of the place."""

    best: Floats
    places: list[tuple[Floats, Floats]]  # that explain the readings, each with its covariance

    def of(self, function, own=0.0):
        """(best, low, high) of `function`, which has a standard deviation `own` besides that of
        the place."""
        ends = []
        for place, covariance in self.places:
            slope = _gradient(function, place)
            spread = math.sqrt(own**2 + float(slope @ covariance @ slope))
            value, reach = function(place), TWO_SIDED * spread
            ends += [value - reach, value + reach]
        return function(self.best), min(ends), max(ends)


def _gradient(function, place):
    """Derivatives of `function`, inside the ranges."""
    found = []
    for k in range(len(place)):
        ends = np.array([place, place])
        ends[0, k], ends[1, k] = max(place[k] - STEP, 0.0), min(place[k] + STEP, 1.0)
        low, high = (function(one) for one in ends)
        found.append((high - low) / (ends[1, k] - ends[0, k]))
    return np.array(found)


def _slip(search, interval, determined):
    """`Found.slip`."""
    point = search.readings.readings[search.first].point
    read = [
        (one.value, one.within)
        for one in map(search.cage, search.readings.readings)
        if one and one.point == point
    ]
    if not read:
        return None
    orders, within = np.transpose(read)
    weights = within**-2 / (within**-2).sum()
    order, own = float(orders @ weights), float((within**-2).sum() ** -0.5)

    def slip(place):
        return 1 - order / search.kinematic(place)

    return Value(*interval.of(slip, own / order), determined)


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
        self._predicted = {}
        # number of the first reading that is not just the oil's temperature
        heats = "conductance" in {*readings.known, *readings.unknown}
        solved = [heats or one.quantity != "temperature" for one in readings.readings]
        self.first = solved.index(True) if any(solved) else None

    def value(self, name, share):
        return value_of(self.readings, name, share)

    def state(self, place):
        found = {name: float(self.value(name, x)) for name, x in zip(self.readings.unknown, place)}
        return {**self.readings.known, **found}

    def predicted(self, place):
        key = np.asarray(place).tobytes()
        if key not in self._predicted:
            self._predicted[key] = self.model.predict(self.state(place))
        return self._predicted[key]

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
            self.predicted(tried[int(np.argmin(costs))])  # raises with the reason
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
        """Least-squares fit from `start`, with unknown number `fixed` held."""
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

    def angle(self, place):
        """Contact angle at the `first` reading, rad."""
        return self.predicted(place)[self.first].angle

    def kinematic(self, place):
        """FTF at that angle in orders of the shaft, without slip."""
        return float(kinematics.frequencies(self.model.bearing, self.angle(place)).cage)

    def cage(self, reading):
        """FTF from the reading of a line of the cage; None for other readings."""
        balls = self.model.bearing.balls
        order = {
            "FTF": reading.value,
            "BPFO": reading.value / balls,
            "BPFI": 1 - reading.value / balls,
        }.get(reading.quantity)
        share = 1 if reading.quantity == "FTF" else balls
        if order is None:
            return None
        return reading._replace(value=order, within=reading.within / share)

    def slopes(self, place):
        """(readings, unknowns) derivatives of the residuals."""
        return np.transpose(_gradient(self.residuals, place))

    def covariance(self, place, weakest=True):
        """Covariance (unknowns, unknowns) at `place`, with the ranges as prior knowledge; with or
        without the `weakest` direction."""
        slopes = self.slopes(place)
        values, vectors = np.linalg.eigh(slopes.T @ slopes + np.eye(len(place)) / UNIFORM**2)
        kept = vectors[:, 0 if weakest else 1 :] / np.sqrt(values[0 if weakest else 1 :])
        return kept @ kept.T

    def valley(self, best, along):
        """States that explain the readings as well as the best one, along unknown number
        `along`."""
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
