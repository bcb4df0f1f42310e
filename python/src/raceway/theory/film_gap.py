# SPDX-License-Identifier: GPL-2.0-or-later
"""The film in the gap: it adds to the overlap that Hertz's law sees.

Q = K delta_H^1.5 with delta_H = delta + zeta h_c(Q), delta the overlap of the rigid bodies,
negative in a gap. The left side grows with Q and h_c falls, so there is one root for any delta.
zeta is 1.04 to 1.09 for a line contact by a transient EHL solver; 1 is the default.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Numbers
from raceway.theory import film, film_factors, film_regimes

# load in N -> (h_c in m, m = -d(ln h_c)/d(ln Q)); arrays of one shape
Law = Callable[[Numbers], tuple[Numbers, Numbers]]
LEAST = -200.0  # ln of a load in N, below any
CUT = 1.0  # N: below it a power law keeps its thickness, unless told otherwise


class Squeeze(NamedTuple):
    """A contact with its film, arrays of one shape."""

    load: Numbers  # Q, N
    h_c: Numbers  # m; below the load that a cut begins at, the thickness there
    elastic: Numbers  # delta_H, m; zero without load
    slope: Numbers  # dQ/d(delta), N/m


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
    """`Law` of Masjedi and Khonsari (`film.h_c`) times `factor`; below the load `cut` in N the
    thickness is that at `cut`. 0 leaves the power law uncut, which grows without bound."""

    def law(load):
        kept = np.maximum(load, cut)
        g = film.group(viscosity, pressure_viscosity, modulus, r_x, kappa, speed, kept)
        slope = np.where(load < cut, 0.0, film.load_exponent(kappa))
        return factor * film.h_c(r_x, g), slope[()]

    return law


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
    """`Law` of Nijenbanning, Venner and Moes (`film_regimes.h_c`) times `factor`; its slope is
    exact, by a complex step. No film at rest."""
    turning = np.abs(speed) > 0
    u = np.where(turning, speed, 1.0)

    def law(load):
        tilted = load * np.exp(1e-30j)
        g = film_regimes.group(viscosity, pressure_viscosity, modulus, r_x, r_y, u, tilted)
        h = film_regimes.h_c(g)
        return (
            np.where(turning, factor * h.real, 0.0)[()],
            np.where(turning, -h.imag / h.real / 1e-30, 0.0)[()],
        )

    return law


def heated(
    law: Law, loading: Numbers, peak: Numbers, slide_roll: Numbers = 0.0, *, cut: float = CUT
) -> Law:
    """`law` times Gupta's factor (`film_factors.gupta`), which falls with the pressure of the load.

    `loading` is L; `peak` is p_max/E' under 1 N, p_max growing with Q^(1/3). Below the load `cut`
    in N the factor is that at `cut`. Beyond the range of Gupta's factor the pressure takes
    `GUPTA_MOST` of it.
    """

    def with_factor(load):
        h, m = law(load)
        pressure = peak * np.maximum(load, cut) ** (1 / 3)
        unpressed, lost = film_factors.gupta_parts(loading, pressure, slide_roll)
        most = film_factors.GUPTA_MOST
        follows = (load >= cut) & (lost < most)
        lost = np.minimum(lost, most)
        return h * unpressed * (1 - lost), m + np.where(follows, lost / (3 * (1 - lost)), 0.0)

    return with_factor


def solve(overlap: ArrayLike, stiffness: Numbers, law: Law, share: float = 1.0) -> Squeeze:
    """`Squeeze` of contacts of K in N/m^1.5 at an `overlap` in m of any sign; `share` is zeta.

    Newton's method for ln Q inside a bracket. dQ/d(delta) = 1.5 Q/(delta_H + 1.5 m zeta h_c).
    No load where the gap is wider than a film that is cut.
    """
    overlap, stiffness = np.broadcast_arrays(np.asarray(overlap, float), stiffness)
    shape = overlap.shape
    thick, _ = law(np.ones(shape))
    most = stiffness * (np.maximum(overlap, 0) + share * thick) ** 1.5
    low, high = np.full(shape, LEAST), np.log(np.maximum(most, 1.0))

    gap, squeezed = np.maximum(-overlap, 0), np.maximum(overlap, 0)

    def sides(y):
        h, m = law(np.exp(y))
        return (np.exp(y) / stiffness) ** (2 / 3), share * h, m

    # ln(delta_H + gap) = ln(zeta h_c + overlap): nearly straight in y = ln Q on both sides
    elastic, thick, _ = sides(low)
    none = elastic + gap >= thick + squeezed
    y = np.where(none, low, high)
    for _ in range(200):
        elastic, thick, m = sides(y)
        left, right = elastic + gap, np.where(none, 1.0, thick + squeezed)
        value, slope = np.log(left / right), 2 / 3 * elastic / left + m * thick / right
        low, high = np.where(value < 0, y, low), np.where(value < 0, high, y)
        trial = y - value / np.where(none, 1.0, slope)
        trial = np.where((trial > low) & (trial < high), trial, (low + high) / 2)
        following = np.where(none | (np.abs(value) <= 1e-15), y, trial)  # or rounding moves it
        if np.all(np.abs(following - y) <= 1e-15 * (1 + np.abs(y))):
            break
        y = following
    load = np.where(none, 0.0, np.exp(y))
    h, m = law(np.maximum(load, np.exp(LEAST)))
    elastic = (load / stiffness) ** (2 / 3)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.where(load > 0, 1.5 * load / (elastic + 1.5 * m * share * h), 0.0)
    return Squeeze(load[()], h, elastic[()], slope[()])


def energy(squeeze: Squeeze, exponent: Numbers, share: float = 1.0) -> Numbers:
    """Energy in J of a contact at a fixed speed: 0.4 Q delta_H + zeta m h_c Q/(1 - m), where the
    film is a power law of the load with m = `exponent`."""
    stored = share * exponent * squeeze.h_c * squeeze.load / (1 - exponent)
    return 0.4 * squeeze.load * squeeze.elastic + stored
