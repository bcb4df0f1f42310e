# SPDX-License-Identifier: GPL-2.0-or-later
"""Film in the gap: its thickness is added to the overlap in Hertz's law.

The load is Q = K delta_H^1.5 with delta_H = delta + zeta h_c(Q), where delta is the overlap of the
rigid bodies, which is negative if there is a gap. As Q grows, delta_H grows and h_c decreases, so
there is exactly one root for any delta. According to a transient EHL solver, zeta is 1.04 to 1.09
for a line contact; the default is 1.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

from numpy.typing import ArrayLike

from raceway.arrays import Numbers
from raceway.core import laws

CUT = float(laws.power_law_cut())  # N, default load below which a power law becomes constant
REACH = float(laws.film_gap_reach())  # largest film, as a fraction of the ball's radius


class Squeeze(NamedTuple):
    """Contacts with their films, in arrays of equal shape."""

    load: Numbers  # Q, N
    h_c: Numbers  # m, film thickness; below the cut load, its value at the cut load
    elastic: Numbers  # delta_H, m; zero if there is no load
    slope: Numbers  # dQ/d(delta), N/m


@dataclass(frozen=True)
class Law:
    """A film as a function of the load. `law(load in N)` returns (h_c in m, m = -d(ln h_c)/d(ln
    Q)). Use `power_law`, `all_regimes` or `heated` to create one."""

    all_regimes: bool
    viscosity: Numbers  # Pa s
    pressure_viscosity: Numbers  # 1/Pa
    modulus: float  # E', Pa
    r_x: Numbers  # m
    shape: Numbers  # R_y in m if `all_regimes` is true, otherwise kappa
    speed: Numbers  # m/s
    factor: Numbers
    loading: Numbers = 0.0  # L of Gupta's factor; 0 if the factor is not applied
    peak: Numbers = 0.0  # p_max/E' at a load of 1 N
    slide_roll: Numbers = 0.0
    cut: float = 0.0  # N

    def __call__(self, load: Numbers) -> tuple[Numbers, Numbers]:
        """Return h_c in m and the exponent m under a `load` in N."""
        return tuple(laws.film_at_load(load, **vars(self)))


def power_law(
    viscosity: Numbers,
    pressure_viscosity: Numbers,
    modulus: float,
    r_x: Numbers,
    kappa: Numbers,
    speed: Numbers,
    *,
    factor: Numbers = 1.0,
    cut: float = CUT,
) -> Law:
    """Return the `Law` of Masjedi and Khonsari (`film.h_c`) times `factor`. Below the load `cut` in
    N, the thickness keeps its value at `cut`. If `cut` is 0, the thickness grows without bound as
    the load tends to zero."""
    return Law(False, viscosity, pressure_viscosity, modulus, r_x, kappa, speed, factor, cut=cut)


def all_regimes(
    viscosity: Numbers,
    pressure_viscosity: Numbers,
    modulus: float,
    r_x: Numbers,
    r_y: Numbers,
    speed: Numbers,
    *,
    factor: Numbers = 1.0,
) -> Law:
    """Return the `Law` of Nijenbanning, Venner and Moes (`film_regimes.h_c`) times `factor`. There
    is no film at zero speed."""
    return Law(True, viscosity, pressure_viscosity, modulus, r_x, r_y, speed, factor)


def heated(
    law: Law, loading: Numbers, peak: Numbers, slide_roll: Numbers = 0.0, *, cut: float = CUT
) -> Law:
    """Return `law` times Gupta's factor (`film_factors.gupta`), which decreases with pressure and
    therefore with load.

    `loading` is L, and `peak` is p_max/E' at a load of 1 N; p_max grows with Q^(1/3). Below the
    load `cut` in N the factor keeps its value at `cut`. Beyond the range of Gupta's factor, the
    reduction by pressure is limited to `GUPTA_MOST`. Raises `ValueError` if `law` is a power law
    whose cut is at a different load.
    """
    if not law.all_regimes and law.cut != cut:
        raise ValueError(f"cut = {cut} N must equal the cut of the power law, {law.cut} N")
    return replace(law, loading=loading, peak=peak, slide_roll=slide_roll, cut=cut)


def solve(overlap: ArrayLike, stiffness: Numbers, law: Law, share: float = 1.0) -> Squeeze:
    """Find the `Squeeze` of contacts with the stiffness K in N/m^1.5 at an `overlap` in m of either
    sign; `share` is zeta.

    dQ/d(delta) is 1.5 Q/(delta_H + 1.5 m zeta h_c). There is no load if the film has a cut and the
    gap exceeds its thickness.
    """
    return Squeeze(*laws.film_in_gap(overlap, stiffness, share, **vars(law)))


def energy(
    squeeze: Squeeze, exponent: Numbers, share: float = 1.0, cut: float = 0.0, edge: Numbers = 0.0
) -> Numbers:
    """Return the energy in J of a contact at constant speed, 0.4 Q delta_H + zeta m/(1 - m) (h_c Q
    - edge cut). Above the load `cut` in N, the film thickness is a power law with m = `exponent`;
    at that load it is `edge` (m)."""
    thinned = laws.thinning_work(share, exponent, squeeze.load, squeeze.h_c, cut, edge)
    return laws.hertz_energy(squeeze.load, squeeze.elastic) + thinned
