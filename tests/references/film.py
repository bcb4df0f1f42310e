# SPDX-License-Identifier: GPL-2.0-or-later
"""Film thicknesses in 40-digit arithmetic, as printed in their sources. Some of the functions
return the film thickness as a function of the load."""

import mpmath
from mpmath import exp, log, mpf


def masjedi_khonsari(r_x, u, g, w, k, sign=1):
    """Return (h_min, h_c) from equations 6 and 9; sign -1 selects equation 9 as it was printed."""
    d = mpf
    h_min = d("1.637") * u ** (d("0.711") * k ** d("-0.023")) * g ** (d("0.65") * k ** d("-0.045"))
    h_min *= w ** (-d("0.09") * k ** d("-0.15")) * (1 - d("0.974") * exp(-d("0.676") * k))
    h_c = d("3.672") * u ** (d("0.663") * k ** (sign * d("0.025")))
    h_c *= g ** (d("0.502") * k ** (sign * d("0.064"))) * w ** (
        -d("0.045") * k ** (sign * d("0.18"))
    )
    return r_x * h_min, r_x * h_c * (1 - d("0.573") * exp(-d("0.74") * k))


def hamrock_dowson(r_x, u, g, w, k):
    """Return (h_min, h_c) according to Hamrock and Dowson (1977)."""
    d = mpf
    h_min = (
        d("3.63") * u ** d("0.68") * g ** d("0.49") * w ** d("-0.073") * (1 - exp(-d("0.68") * k))
    )
    h_c = d("2.69") * u ** d("0.67") * g ** d("0.53") * w ** d("-0.067")
    return r_x * h_min, r_x * h_c * (1 - d("0.61") * exp(-d("0.73") * k))


def groups(viscosity, xi, modulus, r_x, speed, load):
    """Return (U, G, W)."""
    return (
        mpf(viscosity) * speed / (mpf(modulus) * r_x),
        mpf(xi) * modulus,
        mpf(load) / (mpf(modulus) * mpf(r_x) ** 2),
    )


def power_law(viscosity, xi, modulus, r_x, kappa, speed, factor=1.0, cut=1.0):
    """Return h_c (m) as a function of the load, after Masjedi and Khonsari; constant below `cut`
    N."""

    def h(load):
        kept = max(mpf(load), mpf(cut))
        u, g, w = groups(viscosity, xi, modulus, mpf(r_x), mpf(speed), kept)
        return factor * masjedi_khonsari(mpf(r_x), u, g, w, mpf(kappa))[1]

    return h


@mpmath.workdps(30)
def all_regimes(viscosity, xi, modulus, r_x, r_y, speed, factor=1.0):
    """Return h_c (m) as a function of the load, after Nijenbanning, Venner and Moes (1994)."""
    u = 2 * mpf(viscosity) * speed / (mpf(modulus) * r_x)
    ratio, m = mpf(r_x) / r_y, mpf(1)
    deep = mpf(xi) * modulus * u ** (m / 4)
    wide = 1 + mpf("0.006") * log(ratio) + mpf("0.63") * ratio ** (m * 4 / 7)

    # at M = 1
    ri_1 = 145 * (1 + mpf("0.796") * ratio ** (m * 14 / 15)) ** (-m * 15 / 7) / ratio
    rp = mpf("1.29") * (1 + mpf("0.691") * ratio) ** (-m * 2 / 3) * deep ** (m * 2 / 3)
    ei_1 = mpf("3.18") * wide ** (-m * 14 / 25) * ratio ** (-m / 15)
    ep_1 = mpf("1.48") * wide ** (-m * 7 / 20) * ratio ** (-m / 24) * deep ** (m * 3 / 4)
    unit = mpf(modulus) * mpf(r_x) ** 2 * u ** (m * 3 / 4)

    def h(load):
        moes = mpf(load) / unit
        ri = ri_1 / moes**2
        ei, ep = ei_1 * moes ** (-m * 2 / 15), ep_1 * moes ** (-m / 12)
        s = (1 + exp(-mpf("1.2") * ei / ep)) * 3 / 2
        iso = ri ** (m * 3 / 2) + (ei**-4 + (mpf("1.8") / ratio) ** -4) ** (-m * 3 / 8)
        piezo = (rp**-8 + ep**-8) ** (-m / 8)
        return factor * mpf(r_x) * mpmath.sqrt(u) * (iso ** (2 * s / 3) + piezo**s) ** (1 / s)

    return h


def murch_wilson(loading):
    return mpf("3.94") / (mpf("3.94") + mpf(loading) ** mpf("0.62"))


def wilson(loading):
    return 1 / (1 + mpf("0.1") * mpf(loading) ** mpf("0.64"))


def gupta(loading, pressure, slide_roll=0.0):
    """Return the film factor of Gupta et al. (1992), in which the reduction by pressure is at most
    0.9."""
    lost = min(mpf("13.2") * pressure * mpf(loading) ** mpf("0.42"), mpf("0.9"))
    slid = 1 + mpf("2.23") * abs(mpf(slide_roll)) ** mpf("0.83")
    return (1 - lost) / (1 + mpf("0.213") * slid * mpf(loading) ** mpf("0.64"))


def heated(film, loading, peak, slide_roll, cut):
    """Return `film` multiplied by Gupta's factor; `peak` is p_max/E' at 1 N, and is constant below
    `cut` N."""
    return lambda load: (
        film(load) * gupta(loading, mpf(peak) * mpmath.cbrt(max(mpf(load), mpf(cut))), slide_roll)
    )


def in_gap(overlap, stiffness, film, share=1.0):
    """Return the load (N), h_c (m), the elastic approach (m) and dQ/d(overlap) (N/m) of a contact
    with film in the gap. The equation (Q/K)^(2/3) = overlap + share h_c(Q) is solved for ln Q,
    first by bisection and then by secants. The load is 0 if the film does not bridge the gap."""
    with mpmath.workdps(30):

        def gap(y):
            load = exp(y)
            return (load / stiffness) ** (mpf(2) / 3) - mpf(share) * film(load) - mpf(overlap)

        low, high = mpf(-120), mpf(25)
        if gap(low) >= 0:
            return 0.0, float(film(exp(low))), 0.0, 0.0
        for _ in range(9):
            middle = (low + high) / 2
            low, high = (middle, high) if gap(middle) < 0 else (low, middle)
        y = mpmath.findroot(gap, (low, high), solver="anderson", tol=1e-44)
        load = exp(y)
        slope = load / mpmath.diff(gap, y, h=mpf(10) ** -8)
        return tuple(map(float, (load, film(load), (load / stiffness) ** (mpf(2) / 3), slope)))
