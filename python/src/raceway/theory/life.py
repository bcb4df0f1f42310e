# SPDX-License-Identifier: GPL-2.0-or-later
"""Rating life of a radial or angular contact ball bearing according to ISO 281:2007 and, from the
loads on its balls, according to ISO/TS 16281:2008. The lives are for a reliability of 90 %;
`RELIABILITY` lists factors for other values.

The reference life is computed from the ball loads in statics or in a run and therefore includes the
effects of clearance, tilt, moments and centrifugal loads. The life of ISO 281 itself depends only
on the load on the whole bearing.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.theory.bearing import Bearing
from raceway.theory.cleanliness import contamination

# a_1 of ISO 281:2007, table 12: reliability in percent
RELIABILITY: Mapping[float, float] = {90: 1, 95: 0.64, 96: 0.55, 97: 0.47, 98: 0.37, 99: 0.25}
LARGEST_FACTOR = 50.0  # upper limit of a_ISO
PERMITTED = 4.2e9  # Pa, largest contact pressure under the static load rating (ISO 76)
# largest kappa to which a row applies, then the two constants of the row (ISO 281:2007, eqs 31 to
# 33); the constants in the second row make a_ISO continuous at kappa = 0.4 and 1
_FACTOR = ((0.4, 2.2649, 0.054381), (1.0, 1.9987, 0.19087), (4.0, 1.9987, 0.071739))
# exponents of the mean loads for the ring that rotates relative to the load and for the other ring
# (ISO/TS 16281, eqs 20 and 21)
POWERS = (3.0, 10 / 3)
# largest ratios of groove radius to ball diameter (inner, outer) for which ISO 281 gives ratings
CONFORMITY = (0.52, 0.53)


class Ratings(NamedTuple):
    """Catalogue load ratings of a bearing in N."""

    dynamic: float  # dynamic load rating C
    static: float  # static load rating C_0
    fatigue: float  # fatigue load limit C_u


class Life(NamedTuple):
    """Rating life of a bearing under given ball loads."""

    reference: float  # reference life L_10r of ISO/TS 16281, in 1e6 revolutions
    equivalent: float  # N, radial load for which ISO 281 gives the same life
    factor: float  # life modification factor a_ISO; NaN if no viscosity is given
    modified: float  # modified life a_ISO L_10r, in 1e6 revolutions
    viscosity_ratio: float  # viscosity ratio kappa


def ratings(dynamic: float, static: float, pitch_diameter: float) -> Ratings:
    """Return the `Ratings` with an estimate of the fatigue load limit, which is C_0/22, multiplied
    by (0.1/D_pw)^0.5 if `pitch_diameter` exceeds 0.1 m (the simple estimate of ISO 281, annex B, as
    commonly quoted; not checked against the standard). Loads are in N and diameters in m."""
    large = max(pitch_diameter / 0.1, 1.0)
    return Ratings(dynamic, static, static / 22 / large**0.5)


def basic(dynamic: float, load: ArrayLike) -> np.ndarray:
    """Return the basic rating life L_10 = (C/P)^3 in 1e6 revolutions for loads in N (ISO 281:2007,
    eq 2).

    For the bearing of XJTU-SY, with C = 12.82 kN, under 12 kN at 2100 rpm, the life in hours is:

    >>> round(float(basic(12820.0, 12000.0)) * 1e6 / (60 * 2100), 3)
    9.677
    """
    return (dynamic / np.asarray(load, float)) ** 3


def wide_grooves(bearing: Bearing) -> np.ndarray:
    """Return the factors (2,) on the ball ratings of the inner and the outer groove. For a groove
    wider than `CONFORMITY`, the factor is (2 f/(2 f - 1))^0.41 divided by its value at
    `CONFORMITY`, where f is the ratio of groove radius to ball diameter (Lundberg and Palmgren
    1947). Otherwise it is 1, because ISO 281 does not give narrower grooves a higher rating."""
    groove, limit = (
        np.array([bearing.inner_groove, bearing.outer_groove]) / bearing.ball_diameter,
        np.array(CONFORMITY),
    )
    groove = np.maximum(groove, limit)
    return (groove / limit * (2 * limit - 1) / (2 * groove - 1)) ** 0.41


def ball_ratings(bearing: Bearing, dynamic: float, angle: float = 0.0) -> tuple[float, float]:
    """Return (Q_ci, Q_ce) in N, the ball loads for which the inner and the outer raceway last 1e6
    revolutions (ISO/TS 16281, eqs 16 to 19). `dynamic` is C in N of the bearing with grooves no
    wider than `CONFORMITY`; for wider grooves the factors of `wide_grooves` are applied. `angle` is
    the nominal contact angle in rad."""
    ball, wide = bearing.ball_diameter, wide_grooves(bearing)
    gamma = ball * np.cos(angle) / (2 * bearing.pitch_radius)
    inner, outer = (
        min(groove, limit * ball)
        for groove, limit in zip((bearing.inner_groove, bearing.outer_groove), CONFORMITY)
    )
    osculation = inner / outer * (2 * outer - ball) / (2 * inner - ball)
    ratio = 1.044 * ((1 - gamma) / (1 + gamma)) ** 1.72 * osculation**0.41
    share = dynamic / (bearing.balls * np.cos(angle) ** 0.7)
    return (
        float(wide[0] * share / 0.407 * (1 + ratio ** (10 / 3)) ** 0.3),
        float(wide[1] * share / 0.389 * (1 + ratio ** (-10 / 3)) ** 0.3),
    )


def reference(
    bearing: Bearing, dynamic: float, inner: ArrayLike, outer: ArrayLike, angle: float = 0.0
) -> float:
    """Return the reference life L_10r in 1e6 revolutions from the loads (N) of the `inner` and
    `outer` contacts (..., Z) at one or more positions of the balls, for a rotating inner ring
    (ISO/TS 16281, eqs 20 to 22).

    The loads of several rows and grooves are arranged as in `static.Equilibrium`. Two grooves per
    ring count as two rows: `dynamic` is the rating of all rows, and the contributions of the
    raceways of all rows are added. Makers rate four-point contact bearings in this way.

    Raises `ValueError` if a load is negative or if all loads are zero.

    >>> from raceway.theory import static
    >>> from raceway.theory.bearing import Bearing
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> rest = static.equilibrium(b, 3000.0)
    >>> round(reference(b, 32.5e3, rest.inner.load, rest.outer.load), 1)
    1255.9
    """
    loads = np.asarray(inner, float), np.asarray(outer, float)
    if any((one < 0).any() for one in loads) or not all(one.any() for one in loads):
        raise ValueError("ball loads must be 0 or more, and at least one must be above 0")
    raceways = [one.reshape(bearing.layout.tracks, -1) for one in loads]
    means = [np.mean(one**power, axis=1) for one, power in zip(raceways, POWERS)]
    return of_means(bearing, dynamic, *means, angle)


def of_means(
    bearing: Bearing, dynamic: float, inner: ArrayLike, outer: ArrayLike, angle: float = 0.0
) -> float:
    """Return the life of `reference` from power means: `inner` and `outer` are the means (T,), over
    balls and positions, of the loads (N) raised to `POWERS`, for the T grooves of each ring in all
    rows."""
    means = np.atleast_1d(np.asarray(inner, float)), np.atleast_1d(np.asarray(outer, float))
    rated = ball_ratings(bearing, dynamic / len(means[0]) ** 0.7, angle)
    risks = [
        ((mean ** (1 / power) / capacity) ** (10 / 3)).sum()
        for capacity, mean, power in zip(rated, means, POWERS)
    ]
    return float(sum(risks) ** (-9 / 10))


def of_duties(lives: ArrayLike, shares: ArrayLike) -> float:
    """Return the life under several operating points in succession, 1/sum(share/life), in the unit
    of `lives` (N,); `shares` (N,) are fractions of the revolutions (Palmgren-Miner; ISO/TS 16281,
    clause 5). If the lives are in hours, the shares are fractions of the time. Raises `ValueError`
    if the shares do not add up to 1.

    >>> round(of_duties([1000.0, 100.0], [0.9, 0.1]), 1)
    526.3
    """
    life, share = np.asarray(lives, float), np.asarray(shares, float)
    if (share < 0).any() or not np.isclose(share.sum(), 1.0) or not (life > 0).all():
        raise ValueError("shares must be 0 or more and add up to 1, and lives must be above 0")
    return float(1 / (share / life).sum())


def reference_viscosity(rpm: ArrayLike, pitch_diameter: float) -> np.ndarray:
    """Return nu_1 in mm2/s, the viscosity at which kappa is 1 (ISO 281:2007, eqs 28 and 29);
    `pitch_diameter` is in m. As in the standard, it jumps by 2 % at 1000 rpm."""
    speed = np.asarray(rpm, float)
    slow, fast = 45000 * speed**-0.83, 4500 * speed**-0.5
    return np.where(speed < 1000, slow, fast) * (1e3 * pitch_diameter) ** -0.5


def factor(viscosity_ratio: float, contamination: float) -> float:
    """Return a_ISO of a radial ball bearing, which is between 0.1 and 50 (ISO 281:2007, eqs 31 to
    33). `viscosity_ratio` is kappa, which is limited to 4; `contamination` is e_C C_u/P. The result
    is 0.1 below kappa = 0.1, where the standard gives no value.

    >>> round(factor(0.8, 0.3), 4)
    6.8198
    """
    if not (viscosity_ratio >= 0 and contamination >= 0):
        raise ValueError(f"kappa {viscosity_ratio} and e_C C_u/P {contamination} must be 0 or more")
    if viscosity_ratio < 0.1:
        return 0.1
    kappa = min(viscosity_ratio, 4.0)
    first, power = next(numbers for least, *numbers in _FACTOR if kappa <= least)
    bracket = 1 - (2.5671 - first / kappa**power) ** 0.83 * contamination ** (1 / 3)
    if bracket <= 0:
        return LARGEST_FACTOR
    return float(min(0.1 * bracket**-9.3, LARGEST_FACTOR))


def static_safety(pressure: float) -> float:
    """Return s_0, the factor on the load at which the pressure (Pa) at the most heavily loaded
    contact reaches `PERMITTED`. The pressure is proportional to the cube root of the load (ISO
    76:2006, clause 4, applied to the actual loads of the balls)."""
    return (PERMITTED / pressure) ** 3


def minimum_load(factor: float, viscosity: float, rpm: float, mean_diameter: float) -> float:
    """Return F_rm in N, the radial load below which the balls of a deep groove bearing may slide
    instead of rolling: 1000 k_r (nu n/1000)^(2/3) (d_m/100)^2 with nu in mm2/s and d_m in mm.

    `factor` is k_r from the maker's product table, `viscosity` is nu in mm2/s, and `mean_diameter`
    is the mean of bore and outside diameter in m. The symbols are those used on SKF's pages about
    loads on deep groove bearings. The formula is quoted from memory and is for information only.

    >>> round(minimum_load(0.025, 46.0, 1500.0, 0.060), 1)
    151.4
    """
    return 1e3 * factor * (viscosity * abs(rpm) / 1000) ** (2 / 3) * (10 * mean_diameter) ** 2


def of_loads(
    bearing: Bearing,
    rated: Ratings,
    inner: ArrayLike,
    outer: ArrayLike,
    *,
    angle: float = 0.0,
    rpm: float = 0.0,
    viscosity: float | None = None,
    cleanliness: str = "normal",
) -> Life:
    """Compute the `Life` under ball loads (..., Z) in N at `rpm` with an oil whose kinematic
    `viscosity` is in mm2/s; if it is None, a_ISO is not computed. Raises `ValueError` like
    `reference` and `contamination`."""
    life = reference(bearing, rated.dynamic, inner, outer, angle)
    load = rated.dynamic / life ** (1 / 3)
    if viscosity is None or not rpm:
        return Life(life, load, float("nan"), float("nan"), float("nan"))
    pitch = 2 * bearing.pitch_radius
    kappa = float(viscosity / reference_viscosity(abs(rpm), pitch))
    found = factor(kappa, contamination(cleanliness, pitch) * rated.fatigue / load)
    return Life(life, load, found, found * life, kappa)
