# SPDX-License-Identifier: GPL-2.0-or-later
"""What surrounds the contact ellipse as a capacitor, in closed form: I = integral of dA/(h + g)
over the gap outside, m. The capacitance is eps_0 eps I.

Numbers or arrays of one shape, SI units. All formulas are derived on docs/electric;
`capacitance_exact` has the integrals that they stand for.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.theory import hertz
from raceway.theory.groove_width import HalfWidths

FILLS = ("flooded", "cavitated", "dry")
SMALLEST_KAPPA = 1.0  # the fits of beside and beyond are for ellipses across the groove


class Gap(NamedTuple):
    """The gap around a loaded contact in its own measures."""

    scale: Numbers  # g_s = overlap/F, m
    a: Numbers  # m, across the groove
    b: Numbers  # m, along rolling


def gap(ellipse: hertz.Ellipse, modulus: float, load: Numbers) -> Gap:
    """`Gap` of a contact under `load` in N with E' = `modulus` in Pa. Raises `ValueError` for a
    load that is not positive."""
    if not np.all(np.asarray(load) > 0):
        raise ValueError(f"load = {load} N must be positive: a contact without load is rigid")
    a, b = hertz.semi_axes(ellipse, modulus, load)
    overlap = (load / hertz.stiffness(ellipse, modulus)) ** (2 / 3)
    return Gap(overlap / ellipse.first, a, b)


def beside(ratio: Numbers) -> Numbers:
    """G(H), H = h/g_s: the gap before and behind the ellipse over 2 a b/g_s. Within 0.2 % of its
    integral (`capacitance_exact.beside`) for H from 1e-3 to 1e3.

    >>> [round(float(beside(h)), 3) for h in (1e-3, 1.0, 1e3)]
    [33.802, 2.462, 0.098]
    """
    x = np.asarray(ratio, float) ** (1 / 6)
    bend = 0.88494 * (1 - 0.12025 * x) / (1 + x * (0.95409 + 0.86606 * x))
    return np.pi / (x * x * (x + bend))


def beyond(ratio: Numbers, kappa: Numbers, reach: Numbers) -> Numbers:
    """P: the gap beyond one end of the ellipse, the integral of dy/sqrt(H + E(y)) in units of a
    from 1 to `reach` = S/a; zero where the ellipse fills the groove. H = h/g_s = `ratio`."""
    ratio, reach = np.asarray(ratio, float), np.asarray(reach, float)
    length = np.log(4 * kappa)
    excess = length - 1
    x = ratio ** (1 / 6)
    start = (
        np.sqrt(ratio)
        + np.sqrt(excess)
        - 1 / (-1.254 + 0.4523 * length + x * (4.773 + x * (-3.520 + 3.690 * x)))
    )
    room = reach > 0
    s = np.where(room, reach, 1.0)
    root = np.sqrt(np.maximum(excess * s * s + ratio - length + 2 / (3 * s), 0.0))
    value = np.log((np.sqrt(excess) * s + root) / start) / np.sqrt(excess)
    return np.where(room, np.maximum(value, 0.0), 0.0)[()]


def loaded(
    ellipse: hertz.Ellipse,
    modulus: float,
    r_x: Numbers,
    load: Numbers,
    separation: Numbers,
    widths: HalfWidths,
) -> Numbers:
    """I in m around a loaded contact: `modulus` E' in Pa, R_x in m, load in N, `separation` h_c in
    m, `widths` of the groove.

    I = 4 kappa E R (G + pi P sqrt(2 R_x g_s)/b), P the mean of both sides: E and R of the
    `Ellipse`. Raises `ValueError` for a load or separation that is not positive or an ellipse that
    is longer along rolling than across.

    >>> one = hertz.exact(4.990476e-3, 163.8e-3)
    >>> width = HalfWidths(4.2e-3, 4.2e-3)
    >>> round(1e3 * float(loaded(one, 210e9 / 0.91, 4.990476e-3, 120.0, 70e-9, width)))  # mm
    1995
    """
    _positive("separation", separation)
    if np.any(np.asarray(ellipse.kappa) < SMALLEST_KAPPA):
        raise ValueError(f"kappa = {ellipse.kappa} must be {SMALLEST_KAPPA:g} or more")
    around = gap(ellipse, modulus, load)
    ratio = separation / around.scale
    end = sum(beyond(ratio, ellipse.kappa, width / around.a) for width in widths) / 2
    factor = 4 * ellipse.kappa * ellipse.second * ellipse.radius
    return factor * (beside(ratio) + np.pi * end * np.sqrt(2 * r_x * around.scale) / around.b)


def rigid(
    ellipse: hertz.Ellipse,
    r_x: Numbers,
    ball_radius: float,
    groove: float,
    separation: Numbers,
    widths: HalfWidths,
    play: Numbers | None = None,
) -> Numbers:
    """I in m of a ball at `separation` g_0 (m) from the raceway's bottom, without load; R_x, ball
    and `groove` radius in m, `ellipse` of the loaded contact. Raises `ValueError` for a separation
    that is not positive.

    4 pi sqrt(R_x R) asinh(S/sqrt(2 R g_0)), the mean of both sides. R = kappa^2 E R/(ln 4 kappa -
    1), within 1 % of R_y, makes it the limit of `loaded` at no load; over 1 - play/(r_c - R_b),
    because the centres of ball and groove come closer with the `play` (m). That is the separation
    unless given; a film may hold less play farther apart. Past concentric circles the inverse sine
    takes over.

    >>> one, width = hertz.exact(4.990476e-3, 163.8e-3), HalfWidths(5.85e-3, 5.85e-3)
    >>> round(1e3 * float(rigid(one, 4.990476e-3, 6.3e-3, 6.552e-3, 12e-6, width)), 1)  # mm
    656.3
    """
    _positive("separation", separation)
    across = ellipse.kappa**2 * ellipse.second * ellipse.radius / (np.log(4 * ellipse.kappa) - 1)
    closer = np.asarray(separation if play is None else play, float)
    curve = 1 - closer / (groove - ball_radius)  # over 1/across
    size = np.maximum(np.abs(curve), 1e-9) / across  # the limit is straight
    mean = 0.0
    for width in widths:
        reach = np.maximum(width, 0.0) * np.sqrt(size / (2 * separation))
        turn = np.where(curve > 0, np.arcsinh(reach), np.arcsin(np.minimum(reach, 1.0)))
        mean = mean + turn / 2
    return (4 * np.pi * np.sqrt(r_x / size) * mean)[()]


def fill(permittivity: Numbers, kind: str = "flooded", outlet: float = 1.0) -> Numbers:
    """eps_s, the relative permittivity that fills the gap outside the ellipse.

    "flooded": the oil's; "cavitated": the mean of the oil's and of what is in the downstream half,
    `outlet` (1 air, between 1 and the oil's foam); "dry": 1. Raises `ValueError` for another kind
    or an outlet that is not from 1 to the oil's.
    """
    if kind not in FILLS:
        raise ValueError(f"fill '{kind}' is none of {', '.join(FILLS)}")
    if kind == "dry":
        return np.ones_like(np.asarray(permittivity, float))[()]
    if kind == "flooded":
        return permittivity
    if not np.all((np.asarray(outlet) >= 1) & (outlet <= np.asarray(permittivity))):
        raise ValueError(f"outlet = {outlet} must be from 1 to the oil's {permittivity}")
    return (permittivity + outlet) / 2


def _positive(name, value):
    if not np.all(np.asarray(value) > 0):
        raise ValueError(f"{name} = {value} m must be positive")
