# SPDX-License-Identifier: GPL-2.0-or-later
"""Hertz's elliptical contact (Johnson, Contact Mechanics, 4.25-4.28), in 40-digit arithmetic."""

import functools

import mpmath
from mpmath import mpf


@functools.cache
def ellipse(r_x, r_y):
    """Return (kappa, F, E, R) for effective radii in m, from (kappa^2 E - F)/(F - E) = R_y/R_x,
    where the squared modulus of F and E is 1 - 1/kappa^2."""
    with mpmath.workdps(40):
        r_x, r_y = mpf(float(r_x)), mpf(float(r_y))

        def miss(log_kappa):
            m = 1 - mpmath.exp(-2 * log_kappa)
            first, second = mpmath.ellipk(m), mpmath.ellipe(m)
            ratio = (mpmath.exp(2 * log_kappa) * second - first) / (first - second)
            return mpmath.log(ratio) - mpmath.log(r_y / r_x)

        start = 2 / mpmath.pi * mpmath.log(r_y / r_x)
        kappa = mpmath.exp(mpmath.findroot(miss, (start, start * mpf("1.0001"))))
        m = 1 - kappa**-2
        return kappa, mpmath.ellipk(m), mpmath.ellipe(m), 1 / (1 / r_x + 1 / r_y)


def contact(r_x, r_y, modulus, load):
    """Return a dict of the results, as floats, for a contact under `load` (N) with E' = `modulus`
    (Pa)."""
    with mpmath.workdps(40):
        kappa, first, second, radius = ellipse(r_x, r_y)
        modulus, load = mpf(modulus), mpf(load)
        stiffness = (
            mpmath.pi * kappa * modulus * mpmath.sqrt(second * radius / (mpf("4.5") * first**3))
        )
        a = mpmath.cbrt(6 * kappa**2 * second * load * radius / (mpmath.pi * modulus))
        figures = dict(
            kappa=kappa,
            first=first,
            second=second,
            radius=radius,
            stiffness=stiffness,
            a=a,
            b=a / kappa,
            pressure=mpf("1.5") * load / (mpmath.pi * a * a / kappa),
        )
        return {name: float(value) for name, value in figures.items()}
