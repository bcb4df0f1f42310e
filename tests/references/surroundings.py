# SPDX-License-Identifier: GPL-2.0-or-later
"""The gap around a contact from the closed-form solutions in docs/electric, in 40-digit
arithmetic.
"""

import mpmath
from mpmath import mpf

from references.hertz import ellipse


def rigid(r_x, r_y, slack, separation, play, width):
    """Return I (m) for an unloaded ball: 4 pi sqrt(R_x R) asinh(S/sqrt(2 R g_0)), where R is
    kappa^2 E R_e/(ln 4 kappa - 1) divided by 1 - play/slack. If the play exceeds that of concentric
    circles, the inverse sine replaces asinh."""
    kappa, _, second, radius = ellipse(r_x, r_y)
    with mpmath.workdps(40):
        across = kappa**2 * second * radius / (mpmath.log(4 * kappa) - 1)
        curve = 1 - mpf(float(play)) / mpf(float(slack))
        size = max(abs(curve), mpf("1e-9")) / across
        reach = mpf(float(width)) * mpmath.sqrt(size / (2 * mpf(float(separation))))
        turn = mpmath.asinh(reach) if curve > 0 else mpmath.asin(min(reach, mpf(1)))
        return float(4 * mpmath.pi * mpmath.sqrt(mpf(float(r_x)) / size) * turn)


def loaded(r_x, r_y, modulus, load, separation, width):
    """Return I (m) outside a loaded contact: 4 kappa E R (G + pi P sqrt(2 R_x g_s)/b)."""
    kappa, first, second, radius = ellipse(r_x, r_y)
    with mpmath.workdps(40):
        d, pi = mpf, mpmath.pi
        r_x, modulus, load, h, width = map(d, map(float, (r_x, modulus, load, separation, width)))
        stiffness = pi * kappa * modulus * mpmath.sqrt(second * radius / (d("4.5") * first**3))
        a = mpmath.cbrt(6 * kappa**2 * second * load * radius / (pi * modulus))
        scale = (load / stiffness) ** (d(2) / 3) / first
        x, length = (h / scale) ** (d(1) / 6), mpmath.log(4 * kappa)
        bend = d("0.88494") * (1 - d("0.12025") * x) / (1 + x * (d("0.95409") + d("0.86606") * x))
        beside = pi / (x * x * (x + bend))
        fit = d("-1.254") + d("0.4523") * length
        fit += x * (d("4.773") + x * (d("-3.520") + d("3.690") * x))
        excess, s = length - 1, width / a
        start = x**3 + mpmath.sqrt(excess) - 1 / fit
        root = mpmath.sqrt(max(excess * s * s + x**6 - length + 2 / (3 * s), 0))
        beyond = max(mpmath.log((mpmath.sqrt(excess) * s + root) / start), 0) / mpmath.sqrt(excess)
        ends = pi * beyond * mpmath.sqrt(2 * r_x * scale) / (a / kappa)
        return float(4 * kappa * second * radius * (beside + ends))
