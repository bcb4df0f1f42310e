# SPDX-License-Identifier: GPL-2.0-or-later
"""Slip, traction, rolling resistance and drag, by integration or in 40-digit arithmetic."""

import math

import mpmath
import numpy as np
from mpmath import mpf
from scipy.integrate import cumulative_trapezoid, quad

from references import hertz

# {Re: drag coefficient of a sphere}, for Re = 0.1 to 1e5
DRAG = {0.1: 275, 1.0: 30, 10.0: 4.2, 1e2: 1.2, 1e3: 0.48, 1e4: 0.40, 1e5: 0.45}


def heathcote(slip):
    """Return (F, C, power) for Coulomb's law, integrated over the strips of an ellipse that rolls
    with s_e = 1. F is in units of mu Q, C in units of mu Q a^2/(2 R_d), and the power in units of
    mu Q s_e. The strip at z carries the fraction 3/4 (1 - z^2) of the load and has the sliding
    speed slip - z^2.
    """
    with mpmath.workdps(30):
        slip = mpf(slip)
        turns = [mpmath.sqrt(slip)] if 0 < slip < 1 else []

        def over(f):
            def strip(z):
                return mpf(3) / 2 * (1 - z**2) * mpmath.sign(slip - z**2) * f(z)

            return mpmath.quad(strip, [0, *turns, 1])

        return [float(over(f)) for f in (lambda z: 1, lambda z: z**2, lambda z: slip - z**2)]


def free_rolling():
    """Return the slip at which F is zero, and the dissipated power and the slope of F at this slip,
    in units of s_e, mu Q s_e and mu Q/s_e."""
    with mpmath.workdps(30):
        t = mpmath.findroot(lambda t: 3 * t - t**3 - 1, mpf("0.35"))
        return float(t**2), heathcote(t**2)[2], float(3 * (1 - t**2) / (2 * t))


def roelands(viscosity, xi, pressure):
    """Return the viscosity in Pa s under `pressure` (Pa), in 40-digit arithmetic."""
    with mpmath.workdps(40):
        lift = mpmath.log(mpf(viscosity)) + mpf("9.67")
        z = mpf("1.96e8") * mpf(xi) / lift
        return viscosity * mpmath.exp(lift * ((1 + mpf(pressure) / mpf("1.96e8")) ** z - 1))


def aihara(loading):
    return 1 / (1 + mpf("0.29") * mpf(loading) ** mpf("0.78"))


def film_coefficient(viscosity, xi, pressure, rate, stress, limit, points=None):
    """Return the mean Eyring stress over the ellipse, limited to `limit` p, divided by the mean
    pressure. It is computed by adaptive quadrature, or with a given number of Gauss `points` in
    40-digit arithmetic."""

    def shear(t):
        p = mpf(t) * pressure
        x = roelands(viscosity, xi, p) * rate / stress
        return min(stress * mpmath.asinh(x), limit * p) * t

    if points:
        with mpmath.workdps(30):
            nodes, weights = np.polynomial.legendre.leggauss(points)
            total = sum(mpf(w) / 2 * shear((mpf(t) + 1) / 2) for t, w in zip(nodes, weights))
            return float(3 * total / pressure)
    return 3 / pressure * quad(lambda t: float(shear(t)), 0, 1, epsrel=1e-6, limit=200)[0]


def slip(law, slid, load, speed, a, b, r_d, r_x, points=400):
    """Return (force along rolling in N, couple about the rolling axis in N m, power in W) for a
    contact with a stress `law`(pressure in Pa, |s| in m/s) in Pa, where
    s = slid - (|u|/(2 R_d R_x)) z^2. The midpoint rule is used, with `points` across the groove and
    a quarter as many along rolling."""
    z = (np.arange(points) + 0.5) / points  # in units of a
    many = points // 4
    angle = (np.arange(many) + 0.5) * np.pi / many
    half = b * np.sqrt(1 - z**2)
    x = np.cos(angle) / np.ones((points, 1))  # in units of half the length of the strip
    width = half[:, None] * np.sin(angle) * np.pi / many
    peak = 1.5 * load / (np.pi * a * b)
    pressure = peak * np.sqrt(1 - z[:, None] ** 2) * np.sqrt(1 - x**2)
    s = slid - abs(speed) * (a * z) ** 2 / (2 * r_d * r_x)
    strip = np.sign(s) * (law(pressure, np.abs(s)[:, None]) * width).sum(1) * 2 * a / points
    lever = (z * a) ** 2 / (2 * r_d)
    return strip.sum(), (strip * lever).sum(), (strip * s).sum()


def hydrodynamic_rolling(viscosity, modulus, r_x, r_y, speed, load, limit=False):
    """Return the rolling force f (N) of Biboulet and Houpert (2010, part 2, eq 32), or, if `limit`
    is set, its elastic limit M -> infinity (eq 33)."""
    found = hertz.contact(r_x, r_y, modulus, load)
    kappa, unit = found["kappa"], modulus * r_x**2
    double = 2 * viscosity * speed / (modulus * r_x)
    beta = 4 / np.pi * found["second"] / (1 + r_x / r_y)
    elastic = 1.8 * beta**-0.25
    rigid = 0.77 * beta ** (-1 / 3) * kappa**-0.12 * double ** (-1 / 12)
    mean = beta**0.25 * load / unit * double**-0.75 / kappa
    both = elastic if limit else (rigid - elastic) / (1 + mean / 6.6) + elastic
    return unit * 2 * found["a"] / r_x * both * double**0.75


def rolling_powers(viscosity, modulus, r_x, r_y, speed, load):
    """Return the rolling force f (N) according to Balan et al. (2015), in 40-digit arithmetic."""
    with mpmath.workdps(40):
        u = mpf(viscosity) * speed / (mpf(modulus) * r_x)
        w, ratio = mpf(load) / (mpf(modulus) * mpf(r_x) ** 2), mpf(r_y) / r_x
        third, d = mpf(1) / 3, mpf
        rigid = d("2.9766") * ratio ** d("0.3316") * w**third * u ** (2 * third)
        elastic = d("7.5826") * ratio ** d("0.4055") * w**third * u ** d("0.75")
        mean = d("0.5549") * ratio ** -d("0.6029") * w * u ** -d("0.75")
        force = (rigid - elastic) / (1 + mean / d("6.6")) + elastic
        return float(mpf(modulus) * mpf(r_x) ** 2 * force)


def drag_coefficient(reynolds):
    """Return C_D of a sphere, from linear interpolation in the logarithms of `DRAG`."""
    table = list(DRAG.items())
    if reynolds <= table[0][0]:
        return table[0][1] * table[0][0] / reynolds
    for (low, first), (high, last) in zip(table, table[1:]):
        if reynolds <= high:
            part = math.log(reynolds / low) / math.log(high / low)
            return first * (last / first) ** part
    return table[-1][1]


def inlet_share(length, thickness):
    """Return the fraction of the rolling resistance that remains if the inlet has the length
    `length` b and the film is h_c = thickness b^2/(2 R_x), by adaptive quadrature of Reynolds's
    equation in the inlet of a Hertzian contact."""

    def slope(s):
        x = 1 + math.exp(s)
        near = 4 / 3 * math.sqrt(2) * (x - 1) ** 1.5
        gap = x * math.sqrt(x * x - 1) - math.acosh(x) if s > -9 else near
        return gap / (thickness + gap) ** 2 * (x - 1)

    def up_to(end):
        turns = [-9, *range(-8, int(end) + 1, 2), end]
        return sum(quad(slope, a, b, epsabs=0, epsrel=1e-11)[0] for a, b in zip(turns, turns[1:]))

    far = 16.0
    return up_to(math.log(length - 1)) / (up_to(far) + math.exp(-far))


def dissipated_inlet_share(length, thickness):
    """Return the same fraction for the power that the pressure flow dissipates in Grubin's inlet,
    where Barus' viscosity tends to infinity at the contact: the integral of (h - h_c) dp with
    p = -ln(1 - xi q)/xi and dq/dX proportional to (h - h_c)/h^3."""

    def power(length):
        over = np.exp(np.linspace(-16, math.log(length - 1), 40001))  # X - 1, to the meniscus
        x = 1 + over
        gap = np.where(
            over < 1e-4,
            4 / 3 * math.sqrt(2) * over**1.5,
            x * np.sqrt(x * x - 1) - np.arccosh(x),
        )
        slope = gap / (thickness + gap) ** 3
        reduced = cumulative_trapezoid(slope, over, initial=0)
        left = reduced / reduced[-1]  # 1 - xi q
        return np.trapezoid(gap * slope / np.where(left > 0, left, 1.0), over)

    return power(length) / power(1e4)


def immersed(level, pitch):
    """Return the fraction of the volume of the balls that is below the oil level, averaged over the
    path of the balls. The balls are divided into slices."""
    azimuth, node = np.meshgrid((np.arange(2000) + 0.5) * np.pi / 2000, np.linspace(-1, 1, 2001))
    height = -pitch * np.cos(azimuth) + node  # height of a slice, in units of the ball radius
    below = height <= -pitch - 1 + 2 * level
    return float(np.average(below, weights=1 - node**2))
