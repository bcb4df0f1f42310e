# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed-form capacitance of the gap around the contact patch, expressed in terms of I = integral
of dA/(h + g) in m over the gap outside the patch. The capacitance is eps_0 eps I.

Functions accept numbers or arrays of equal shape in SI units. All formulas are derived in
docs/electric; tests compare them with the integrals, which they evaluate numerically.
"""

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws
from raceway.theory import hertz
from raceway.theory.groove_width import HalfWidths

FILLS = ("flooded", "cavitated", "dry")
SMALLEST_KAPPA = 1.0  # the fits in G and P hold if a is at least b


def loaded(
    ellipse: hertz.Ellipse,
    modulus: float,
    r_x: Numbers,
    load: Numbers,
    separation: Numbers,
    widths: HalfWidths,
) -> Numbers:
    """Return I in m around a loaded contact, for E' = `modulus` in Pa, R_x in m, a load in N, the
    `separation` h_c in m and the `widths` of the groove.

    I = 4 kappa E R (G + pi P sqrt(2 R_x g_s)/b), where P is the mean over both sides, and E and R
    are those of the `Ellipse`. Raises `ValueError` if the load or the separation is not positive,
    or if the ellipse is longer in the rolling direction than across the groove.

    >>> one = hertz.exact(4.990476e-3, 163.8e-3)
    >>> width = HalfWidths(4.2e-3, 4.2e-3)
    >>> round(1e3 * float(loaded(one, 210e9 / 0.91, 4.990476e-3, 120.0, 70e-9, width)))  # mm
    1995
    """
    _positive("separation", separation)
    if np.any(np.asarray(ellipse.kappa) < SMALLEST_KAPPA):
        raise ValueError(f"kappa = {ellipse.kappa} must be {SMALLEST_KAPPA:g} or more")
    if not np.all(np.asarray(load) > 0):
        raise ValueError(f"load = {load} N must be positive: a contact without load is rigid")
    return laws.gap_loaded(*ellipse, modulus, r_x, load, separation, *widths)


def rigid(
    ellipse: hertz.Ellipse,
    r_x: Numbers,
    ball_radius: float,
    groove: float,
    separation: Numbers,
    widths: HalfWidths,
    play: Numbers | None = None,
) -> Numbers:
    """Return I in m for an unloaded ball at `separation` g_0 (m) from the bottom of the groove. R_x
    and the radii of ball and `groove` are in m; `ellipse` describes the loaded contact. Raises
    `ValueError` if the separation is not positive.

    I is 4 pi sqrt(R_x R) asinh(S/sqrt(2 R g_0)), averaged over both sides. With R = kappa^2 E R/(ln
    4 kappa - 1), which is within 1 % of R_y, this is the limit of `loaded` for zero load. R is
    divided by 1 - play/(r_c - R_b), because the centres of ball and groove approach each other with
    the `play` (m). By default the play equals the separation; it is smaller if a film separates the
    surfaces. If the play exceeds that of concentric circles, asinh becomes asin.

    >>> one, width = hertz.exact(4.990476e-3, 163.8e-3), HalfWidths(5.85e-3, 5.85e-3)
    >>> round(1e3 * float(rigid(one, 4.990476e-3, 6.3e-3, 6.552e-3, 12e-6, width)), 1)  # mm
    656.3
    """
    _positive("separation", separation)
    closer = np.asarray(separation if play is None else play, float)
    flatness = 1 - closer / (groove - ball_radius)
    return laws.gap_open(*ellipse, r_x, separation, flatness, *widths)


def fill(permittivity: Numbers, kind: str = "flooded", outlet: float = 1.0) -> Numbers:
    """Return eps_s, the relative permittivity in the gap outside the contact patch.

    For "flooded" it is the value of the oil; for "cavitated" it is the mean of the value of the oil
    and `outlet`, the value of the medium in the downstream half (1 for air, more for foam); for
    "dry" it is 1. Raises `ValueError` for an unknown kind, or if `outlet` is not between 1 and the
    value of the oil.
    """
    if kind not in FILLS:
        raise ValueError(f"fill '{kind}' is not one of {', '.join(FILLS)}")
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
