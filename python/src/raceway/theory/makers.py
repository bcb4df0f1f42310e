# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction torque of a bearing from its makers' formulas, for comparison with the physical
losses.

Units are those of the catalogues: mm, N, rpm, mm^2/s, and N mm. SKF's model for deep groove and
single-row angular contact ball bearings is taken from Rolling bearings 10000 EN 2013 (pages 105 and
106). The constants for angular contact bearings are in the General Catalogue 6000, 2006 (page 92 of
the Russian edition, from the text layer in github.com/ArtemFilin1990/Mar).
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws

# {series: (R1, R2, S1, S2)}
CONSTANTS = {
    "60": (4.1e-7, 1.7, 3.73e-3, 14.6),
    "62": (3.9e-7, 1.7, 3.23e-3, 36.5),
    "63": (3.7e-7, 1.7, 2.84e-3, 92.8),
    "64": (3.6e-7, 1.7, 2.43e-3, 198.0),
    "160": (4.3e-7, 1.7, 4.63e-3, 4.25),
    "618": (4.7e-7, 1.7, 6.50e-3, 0.78),
    "619": (4.3e-7, 1.7, 4.75e-3, 3.6),
}
# (R1, R2, R3, S1, S2, S3) for single-row angular contact ball bearings, contact angle 40 degrees
ANGULAR = dict.fromkeys(("72", "73"), (5.03e-7, 1.97, 1.90e-12, 1.30e-2, 0.68, 1.91e-12))
# thrust that a radial load induces in them, divided by that load: R of the General Catalogue 6000
# (page 417) for bearings without an external thrust
INDUCED = 1.0
SAME = {"630": "60", "622": "62", "623": "63", "161": "160", "628": "618"}
SERIES = (*CONSTANTS, *SAME, *ANGULAR)
NO_SERIES = "the bearing's file states no series with known constants"
KEYS = ("torque_skf_N_m", "torque_palmgren_N_m")  # of the results of `torques`
FEW = 0.01  # fraction of the radial force below which `torques` neglects an axial force
BOUNDARY, MINERAL, SYNTHETIC = 0.12, 0.05, 0.04  # mu_bl, and mu_EHL for the two kinds of oil
OIL, GREASE = 3e-8, 6e-8  # K_rs for a low oil bath and oil jet, and for grease and oil-air
K_Z, K_Z_ANGULAR = 3.1, 4.4  # for deep groove and for single-row angular contact ball bearings
# values read from SKF's diagram: ratio of oil level to mean diameter, and V_M
LEVEL = np.array([0, 0.065, 0.109, 0.148, 0.193, 0.252, 0.365, 0.5, 0.66, 0.87, 1.07, 1.2])
CHURNING = 1e-5 * np.array([0, 2.9, 7.35, 13.8, 21.7, 31.6, 44.6, 56.6, 67.5, 83.6, 100.7, 124.6])


class Size(NamedTuple):
    """Bore and outside diameter in m, and K_Z of SKF's model."""

    bore: float
    outside: float
    slender: float = K_Z


@dataclass(frozen=True)
class Boundary:
    """Boundary dimensions (mm) and load rating (N) of a ball bearing, as in the maker's
    catalogue."""

    bore: float
    outside: float
    width: float
    series: str  # one of `SERIES`
    static_rating: float  # C0, N

    def __post_init__(self):
        if not 0 < self.bore < self.outside:
            raise ValueError(f"bore {self.bore} mm must lie between 0 and {self.outside} mm")
        if self.series not in SERIES:
            raise ValueError(f"series '{self.series}' is not one of {', '.join(SERIES)}")

    @property
    def mean(self) -> float:
        """Mean diameter d_m = (d + D)/2 in mm."""
        return (self.bore + self.outside) / 2

    @property
    def slender(self) -> float:
        """K_Z of SKF's model."""
        return K_Z_ANGULAR if self.series in ANGULAR else K_Z


class Torque(NamedTuple):
    """SKF's friction torque in N mm, and its components."""

    total: Numbers
    rolling: Numbers  # phi_ish phi_rs G_rr (nu n)^0.6
    sliding: Numbers  # G_sl mu_sl
    drag: Numbers
    shear: Numbers  # phi_ish
    starvation: Numbers  # phi_rs


def skf(
    bearing: Boundary,
    radial: Numbers,
    axial: Numbers,
    speed: Numbers,
    kinematic: Numbers,
    *,
    replenishment: float = OIL,
    boundary: float = BOUNDARY,
    film: float = MINERAL,
    level: float = 0.0,
    seal: float = 0.0,
) -> Torque:
    """Compute the `Torque` under a `radial` and an `axial` load in N at `speed` in rpm, with an oil
    of `kinematic` viscosity in mm^2/s. In angular contact bearings, `axial` includes the thrust
    that the radial load induces; SKF's formula requires the external part alone (General Catalogue
    6000, page 91).

    `replenishment` is K_rs, and `boundary` and `film` are mu_bl and mu_EHL. `level` is the height
    of the oil above the lowest point of the raceway in mm (0: no drag). Raises `ValueError` if it
    exceeds 1.2 d_m. `seal` is the torque of the seals in N mm (0 for an open bearing).
    """
    d, outside, mean = bearing.bore, bearing.outside, bearing.mean
    rolled, slid = _geometric(bearing, radial, np.abs(axial), speed)
    shear = 1 / (1 + 1.84e-9 * (speed * mean) ** 1.28 * kinematic**0.64)
    starvation = laws.skf_starvation(d, outside, kinematic, speed, replenishment, bearing.slender)
    rolling = shear * starvation * rolled * (kinematic * speed) ** 0.6
    share = np.exp(-2.6e-8 * (speed * kinematic) ** 1.4 * mean)
    sliding = slid * (share * boundary + (1 - share) * film)
    churned = drag(bearing, speed, kinematic, level)
    return Torque(rolling + sliding + churned + seal, rolling, sliding, churned, shear, starvation)


def _geometric(bearing, radial, axial, speed):
    """Return G_rr and G_sl of SKF's model; `axial` must not be negative."""
    mean = bearing.mean
    if bearing.series in ANGULAR:
        r1, r2, r3, s1, s2, s3 = ANGULAR[bearing.series]
        thrown, external = mean**4 * speed**2, np.maximum(axial - INDUCED * radial, 0.0)
        return (
            r1 * mean**1.97 * (radial + r3 * thrown + r2 * external) ** 0.54,
            s1 * mean**0.26 * ((radial + s3 * thrown) ** (4 / 3) + s2 * external ** (4 / 3)),
        )
    r1, r2, s1, s2 = CONSTANTS[SAME.get(bearing.series, bearing.series)]
    # if there is no axial load, the term with the angle is multiplied by zero
    angle = contact_angle(bearing.static_rating, np.where(axial > 0, axial, 1.0))
    sine = np.sin(np.radians(angle))
    slid = np.where(
        axial > 0,
        s1 * mean**-0.145 * (radial**5 + s2 * mean**1.5 * axial**4 / sine) ** (1 / 3),
        s1 * mean**-0.26 * radial ** (5 / 3),
    )[()]
    return r1 * mean**1.96 * (radial + r2 * axial / sine) ** 0.54, slid


def contact_angle(static_rating: float, axial: Numbers) -> Numbers:
    """Return alpha_F of SKF's model in degrees, the contact angle of a deep groove bearing with the
    `static_rating` C0 in N under an `axial` load in N."""
    return 24.6 * (axial / static_rating) ** 0.24


def drag(bearing: Boundary, speed: Numbers, kinematic: Numbers, level: float) -> Numbers:
    """Return SKF's M_drag in N mm for one row of balls in an oil bath; arguments are as in
    `skf`."""
    mean = bearing.mean
    if not 0 <= level <= 1.2 * mean:
        raise ValueError(f"oil level {level} mm must lie between 0 and {1.2 * mean:g} mm")
    if level == 0:
        return 0.0 * np.asarray(speed)[()]
    slender = bearing.slender * (bearing.bore + bearing.outside) / (bearing.outside - bearing.bore)
    t = 2 * np.arccos((0.6 * mean - level) / (0.6 * mean))
    wetted = np.sin(t / 2) if t <= np.pi else 1.0
    wall = 0.36 * mean**2 * (t - np.sin(t)) * 0.05 * slender
    churning = np.interp(level / mean, LEVEL, CHURNING)
    return 0.4 * churning * slender * 1e-12 * mean**5 * speed**2 + (
        # n^2 (n d_m^2 f_t/nu)^-1.379, which is 0 at rest
        1.093e-7 * speed**0.621 * mean**3 * (mean**2 * wetted / kinematic) ** -1.379 * wall
    )


def palmgren(
    bearing: Boundary,
    load: Numbers,
    speed: Numbers,
    kinematic: Numbers,
    *,
    bath: float = 2.0,
    static_load: Numbers | None = None,
) -> tuple[Numbers, Numbers]:
    """Return Palmgren's torques in N mm, (M0 due to speed, M1 due to load) (from memory,
    unchecked).

    `bath` is f0, which is about 2 in an oil bath and is not the f0 in SKF's product tables. f1 is
    0.0004 (F_s/C0)^0.55 with F_s = `static_load` in N, by default equal to `load`.
    """
    rate = np.asarray(kinematic * speed, float)
    moved = np.where(rate >= 2000, 1e-7 * np.maximum(rate, 1.0) ** (2 / 3), 160e-7)
    static = load if static_load is None else static_load
    f1 = 0.0004 * (static / bearing.static_rating) ** 0.55
    return (bath * moved * bearing.mean**3)[()], f1 * load * bearing.mean


def torques(
    bearing: Boundary | None,
    radial: float,
    axial: float,
    speed: float,
    kinematic: float,
    ball_diameter: float,
    *,
    one_groove: bool = True,
) -> dict[str, float | str]:
    """Return the torques (N m) in an oil bath up to the middle of the lowest ball with the keys
    `KEYS`, or the reason why a formula does not apply. `radial` and `axial` are the forces of the
    balls on a ring; an axial force that is small beside the radial one is neglected.
    `ball_diameter` is in m; the other arguments are as in `skf`. `one_groove` is False if a ring
    has several grooves.

    >>> torques(None, 1000.0, 0.0, 1500.0, 46.0, 12.6e-3)["torque_skf_N_m"]
    "the bearing's file states no series with known constants"
    """
    if not one_groove:
        return dict.fromkeys(KEYS, "the formula is for one groove per ring")
    if bearing is None:
        return dict.fromkeys(KEYS, NO_SERIES)
    level = 500 * ball_diameter  # mm above the lowest raceway
    axial = axial if abs(axial) > FEW * radial else 0.0
    whole = skf(bearing, radial, axial, speed, kinematic, level=level).total
    palmgrens: float | str = "the formula is for radial loads"
    if not axial:
        palmgrens = 1e-3 * float(sum(palmgren(bearing, radial, speed, kinematic)))
    return dict(zip(KEYS, (1e-3 * float(whole), palmgrens)))
