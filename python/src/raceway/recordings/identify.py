# SPDX-License-Identifier: GPL-2.0-or-later
"""Identify the state of a bearing from readings: clearance, loads, oil temperature and cooling,
each with its uncertainty, and the combinations of these that the readings cannot separate.

Statics, friction and films are fitted by least squares within the ranges of the unknowns, from
several starting points. The range is the only prior knowledge of an unknown. Different states can
have the same lines, such as a small clearance under a large thrust and a large clearance under a
small thrust. Therefore every fit whose deviance (-2 log of the likelihood) is within `CHI` of the
best fit is kept, and the intervals contain all of these fits. If the readings leave one direction
undetermined, as a single line does for clearance and thrust, points along this valley are traced,
all of which explain the readings.
"""

import math
from typing import NamedTuple

import numpy as np
from scipy import optimize
from scipy.stats import qmc

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.recordings.prediction import Misfit, Model, misfit
from raceway.recordings.readings import Readings
from raceway.theory import kinematics

TRIED = 8  # number of points tried for each unknown
REFINED = 4  # number of these points, the best ones, from which a fit starts
STEP = 1e-4  # step size for numerical derivatives, as a fraction of a range
UNIFORM = 1 / math.sqrt(12)  # standard deviation of a uniform distribution over a range of 1
OPEN = 0.35  # fraction of UNIFORM above which an unknown or direction counts as not determined
VALLEY = 7  # number of points traced along a valley
SAME = 1e-4  # change of the sum of squares below which a fit stops
CHI = 3.84  # increase of the deviance at the 95 % limit of one unknown
TWO_SIDED = 1.96
DETERMINED = 2 * TWO_SIDED * OPEN * UNIFORM  # widest interval of an unknown that is determined
FAR = 1e3  # residual assigned to a state that cannot carry the load
WIDE = 10.0  # ratio of upper to lower limit above which a range is searched logarithmically


class Value(NamedTuple):
    """Value of an unknown."""

    best: float
    low: float  # lower limit of the 95 % interval, within the given range
    high: float
    determined: bool  # True if the readings determine it; otherwise it varies along the valley


class Found(NamedTuple):
    """Result of `identify`."""

    values: dict[str, Value]
    state: dict[str, float]  # best values of the unknowns, and the known values
    residuals: Floats  # (readings,), divided by their uncertainties
    predicted: Floats  # (readings,)
    # states that explain the readings equally well; empty if there is only one point
    valley: list[dict[str, float]]
    idle: int  # largest number of unloaded balls at any point
    # rad, load-weighted mean contact angle at the first reading for which statics is solved; None
    # if only temperatures of the oil were read
    angle: Value | None
    # cage slip at that reading relative to rolling at that angle; None if there is no cage line
    slip: Value | None
    # sum of squares of independent combinations of the residuals, which is roughly the number of
    # readings minus the number of determined unknowns unless a reading or the model is wrong
    chi: float


def identify(readings: Readings) -> Found:
    """Return the state `Found` from `readings`.

    Raise `NoEquilibrium` if no state within the ranges carries the loads.
    """
    search = _Search(readings)
    modes = search.modes()
    best, places = modes[0].place, [one for mode in modes for one in mode.places]
    names, interval, valley = list(readings.unknown), _Interval(best, places), []
    if len(places) > 1:
        valley = sorted((place for place, _ in places), key=lambda one: one[modes[0].along])
    values = {}
    for k, name in enumerate(names):
        one = interval.of(lambda place, k=k: float(place[k]))
        span = [search.value(name, min(max(share, 0.0), 1.0)) for share in one]
        values[name] = Value(*span, one[2] - one[1] <= DETERMINED)
    predicted, rest = search.predicted(best), search.misfit(best)
    return Found(
        values,
        search.state(best),
        rest.relative,
        np.array([one.value for one in predicted]),
        [search.state(one) for one in valley],
        max(one.idle for one in predicted),
        None if search.first is None else _angle(search, interval, not valley),
        None if search.first is None else _slip(search, interval, not valley),
        float(rest.independent @ rest.independent),
    )


def _along(names, variances, weak):
    """Return the number of the unknown along which the valley is traced.

    It is the more uncertain of clearance and thrust if one of them is not determined, and otherwise
    the most uncertain unknown.
    """
    first = [k for k, name in enumerate(names) if weak[k] and name in ("clearance", "axial")]
    return max(first or range(len(names)), key=lambda k: variances[k])


class _Mode(NamedTuple):
    """A fit that explains the readings, with its valley if the readings leave one direction
    undetermined."""

    place: Floats
    along: int  # number of the unknown along which the valley is traced
    places: list[tuple[Floats, Floats]]  # the fit or points on its valley, each with a covariance

    def adds(self, other: Floats) -> bool:
        """Return True if `other` lies outside the 95 % interval of a determined unknown."""
        middles = np.array([place for place, _ in self.places])
        spans = TWO_SIDED * np.sqrt([np.diag(around) for _, around in self.places])
        low, high = (middles - spans).min(0), (middles + spans).max(0)
        outside = (other < low) | (other > high)
        return bool((outside & (high - low <= DETERMINED)).any())


class _Interval(NamedTuple):
    """95 % intervals of functions of a place, i.e. of the unknowns as fractions of their ranges."""

    best: Floats
    places: list[tuple[Floats, Floats]]  # places that explain the readings, with covariances

    def of(self, function, own=0.0):
        """Return (best, low, high) of `function`, which has a standard deviation `own` in addition
        to the uncertainty of the place."""
        ends = []
        for place, covariance in self.places:
            slope = _gradient(function, place)
            spread = math.sqrt(own**2 + float(slope @ covariance @ slope))
            value, reach = function(place), TWO_SIDED * spread
            ends += [value - reach, value + reach]
        return function(self.best), min(ends), max(ends)


def _gradient(function, place):
    """Return one-sided derivatives of `function`, with steps towards the middle of the ranges."""
    steps, here = np.where(place > 0.5, -STEP, STEP), function(place)
    return np.array([(function(place + step) - here) / step.sum() for step in np.diag(steps)])


def _angle(search, interval, determined):
    """`Found.angle`; a mean contact angle is not negative."""
    return Value(*(max(one, 0.0) for one in interval.of(search.angle)), determined)


def _slip(search, interval, determined):
    """Compute `Found.slip`."""
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
    """Return the value of the unknown `name` at the fraction `share` of its range, from 0 to 1."""
    low, high = of.unknown[name]
    if low > 0 and high / low >= WIDE:
        return float(low * (high / low) ** share)
    return float(low + (high - low) * share)


def share_of(of: Readings, name: str, value: float) -> float:
    """Return the fraction of its range at which the unknown `name` has this `value`.

    This is the inverse of `value_of`.
    """
    low, high = of.unknown[name]
    if low > 0 and high / low >= WIDE:
        return math.log(value / low) / math.log(high / low)
    return (value - low) / (high - low)


class _Search:
    """Search for the unknowns, expressed as fractions (0 to 1) of their ranges."""

    def __init__(self, readings):
        self.readings, self.model = readings, Model(readings)
        self._predicted = {}
        # number of the first reading that is more than a temperature of the oil
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

    def lags(self, place):
        """Return the smallest and the largest lag of the cage due to pocket play (readings, 2)."""
        return np.array([one.lag for one in self.predicted(place)])

    def misfit(self, place, lags=None) -> Misfit:
        """Return `prediction.misfit` with the lags of the cage at `place`, or with given `lags`."""
        lags = self.lags(place) if lags is None else lags
        return misfit(self.readings.readings, self.predicted(place), lags)

    def residuals(self, place, lags):
        """Return the independent residuals (readings,), or `FAR` if the state cannot carry the
        load."""
        try:
            return self.misfit(place, lags).independent
        except NoEquilibrium:
            return np.full(len(self.readings.readings), FAR)

    def cost(self, place):
        """Return the deviance of the fit at `place`."""
        try:
            return self.misfit(place).deviance
        except NoEquilibrium:
            return math.inf

    def modes(self):
        """Return a `_Mode` for every fit that explains the readings as well as the best one does,
        with the best one first."""
        size, rigid = len(self.readings.unknown), np.zeros((len(self.readings.readings), 2))
        tried = qmc.Sobol(size, scramble=False).random(1 << math.ceil(math.log2(TRIED * size)))
        sums = [float((self.residuals(one, rigid) ** 2).sum()) for one in tried]
        starts = [one for one in tried[np.argsort(sums)[:REFINED]] if math.isfinite(self.cost(one))]
        if not starts:
            self.predicted(tried[int(np.argmin(sums))])  # raises an error that states the reason
        fits = [self.refine(one, rigid) for one in starts]
        limit = min(map(self.cost, fits)) + CHI
        fits = sorted((self.renew(one, rigid, limit) for one in fits), key=self.cost)
        limit, modes = self.cost(fits[0]) + CHI, []
        for place in fits:
            if self.cost(place) <= limit and all(one.adds(place) for one in modes):
                modes.append(self.mode(place, limit))
        return modes

    def mode(self, place, limit):
        """Return the `_Mode` of the fit `place`.

        Its valley is traced as far as the deviance stays below `limit`.
        """
        around = self.covariance(place)
        weak = np.sqrt(np.diag(around)) > OPEN * UNIFORM
        along = _along([*self.readings.unknown], np.diag(around), weak)
        places = [(place, around)]
        if weak.any():
            # The points give the uncertainty along the valley, the covariance only that across it.
            places = [
                (one, self.covariance(one, weakest=False))
                for one in self.valley(place, along, limit)
            ]
        return _Mode(place, along, places)

    def renew(self, place, lags, limit, fixed=None):
        """Return the fit `place`, repeated if necessary with the lags of the cage at `place`.

        It is repeated if it was made with different `lags` and its deviance can be below `limit`.
        """
        if not math.isfinite(self.cost(place)):
            return place
        own = self.lags(place)
        if np.array_equal(own, lags) or self.misfit(place).width > limit:
            return place
        return self.refine(place, own, fixed)

    def refine(self, start, lags, fixed=None):
        """Return the least-squares fit from `start` with the given `lags` of the cage.

        The unknown with the number `fixed` is not varied.
        """
        free = np.array([k != fixed for k in range(len(start))])

        def rest(x):
            place = np.array(start)
            place[free] = x
            # Due to this 1, `ftol` limits the absolute change of the sum of squares.
            return np.append(self.residuals(place, lags), 1.0)

        place = np.array(start)
        inside = np.clip(place[free], 1e-6, 1 - 1e-6)
        if len(inside):
            place[free] = optimize.least_squares(
                rest, inside, bounds=(0, 1), diff_step=STEP, xtol=1e-5, ftol=SAME
            ).x
        return place

    def angle(self, place):
        """Return the contact angle at the `first` reading in rad."""
        return self.predicted(place)[self.first].angle

    def kinematic(self, place):
        """Return FTF in orders of the shaft speed, without slip, at the contact angle of the
        `first` reading."""
        return float(kinematics.frequencies(self.model.bearing, self.angle(place)).cage)

    def cage(self, reading):
        """Return FTF computed from a reading of a cage line, or None for other readings."""
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
        """Return the derivatives (readings, unknowns) of the independent residuals."""
        lags = self.lags(place)
        return np.transpose(_gradient(lambda one: self.residuals(one, lags), place))

    def covariance(self, place, weakest=True):
        """Return the covariance (unknowns, unknowns) at `place`, with the ranges as prior
        knowledge, and with or without the `weakest` direction."""
        slopes = self.slopes(place)
        values, vectors = np.linalg.eigh(slopes.T @ slopes + np.eye(len(place)) / UNIFORM**2)
        kept = vectors[:, 0 if weakest else 1 :] / np.sqrt(values[0 if weakest else 1 :])
        return kept @ kept.T

    def valley(self, best, along, limit):
        """Return places along the unknown with the number `along` at which the deviance stays below
        `limit`."""
        side, places = np.linspace(0, 1, VALLEY), [best]
        near = int(np.argmin(np.abs(side - best[along])))
        for way in (range(near, len(side)), range(near - 1, -1, -1)):
            last = best
            for k in way:
                place = self.along(last, along, side[k], limit)
                if self.cost(place) > limit:
                    places += self.end(last, place, along, limit)
                    break
                places.append(place)
                last = place
        return sorted(places, key=lambda one: one[along])

    def along(self, place, along, share, limit):
        """Return the best place near `place` at which the unknown with the number `along` is at
        `share`."""
        start, lags = np.array(place), self.lags(place)
        start[along] = share
        return self.renew(self.refine(start, lags, along), lags, limit, along)

    def end(self, inside, outside, along, limit):
        """Return a list with the place at which the deviance reaches the limit, between `inside`
        (below the limit) and `outside` (above it). The list is empty if there is no such place."""
        low, high = self.cost(inside), self.cost(outside)
        if not math.isfinite(high):
            return []
        share = inside[along] + (outside - inside)[along] * (limit - low) / (high - low)
        return [self.along(inside, along, share, limit)]
