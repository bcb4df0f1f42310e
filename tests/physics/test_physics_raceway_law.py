# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of raceway_law.h: the constants of a raceway, and their table over the contact angle."""

import numpy as np
import pytest
from physics_c import (
    BALL,
    EXACT,
    HAMROCK,
    HAMROCK_DOWSON,
    INNER,
    MASJEDI,
    MASJEDI_PRINTED,
    OIL,
    OUTER,
    PRINTED,
    film_pair,
    groove_radii,
    hertz_contact,
)
from raceway.core import laws

STEEL = 210e9 / (1 - 0.09)


def compare(one, other, rel, ln_abs):
    for name in vars(one):
        # for ln A, the absolute error equals the relative error of h
        bound = dict(abs=ln_abs) if name.endswith("lnA") else dict(rel=rel)
        assert getattr(one, name) == pytest.approx(getattr(other, name), **bound), name


def films(constants, speed, load):
    """Return (h_min, h_c) in m."""
    c, ln_at = vars(constants), (1, np.log(speed), np.log(load))
    names = ("lnA", "p", "m")
    return [
        np.exp(sum(c[f"{which}_{name}"] * x for name, x in zip(names, ln_at)))
        for which in ("min", "central")
    ]


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize("ellipse", [EXACT, HAMROCK, PRINTED])
@pytest.mark.parametrize("film", [MASJEDI, MASJEDI_PRINTED, HAMROCK_DOWSON])
def test_table_against_the_exact_constants(physics, side, ellipse, film):
    ring = physics.raceway_6208(side, ellipse=ellipse, film=film, damper_rolling_radius=1, **OIL)
    # test between nodes, where the error of a four-point cubic is largest, and at both ends
    for cosine in [
        0.0,
        1e-9,
        0.5 / 64,
        *(np.arange(0.37, 64, 1.33) / 64),
        63.5 / 64,
        1 - 1e-11,
        1.0,
    ]:
        found, exact = ring.table(cosine), ring.exact(cosine)
        compare(found, exact, rel=1e-9, ln_abs=1e-9)  # the bound stated in the header
        # ln u and ln Q amplify the error by ten
        assert films(found, 1e-3, 5e3) == pytest.approx(films(exact, 1e-3, 5e3), rel=1e-8)


def test_nodes_are_exact(physics):
    ring = physics.raceway_6208(INNER, **OIL)
    for node in (
        1,
        16,
        32,
        63,
    ):  # at nodes, the error is at most a rounding error (for ln A, that of numbers near 30)
        compare(ring.table(node / 64), ring.exact(node / 64), rel=1e-14, ln_abs=1e-14 * 30)


def test_radial_constants_are_those_at_angle_zero(physics):
    ring = physics.raceway_6208(OUTER, **OIL)
    assert ring.radial() == ring.exact(1.0) == ring.table(1.0) == ring.table(1 - 1e-13)
    assert ring.table(1 - 1e-11) != ring.radial()


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize("angle", [0.0, 0.7, np.pi / 2])
def test_constants_are_those_of_the_parts(physics, side, angle):
    cosine = np.cos(angle)
    ring = physics.raceway_6208(
        side, film=MASJEDI_PRINTED, ball_young=300e9, ball_poisson=0.26, **OIL
    )
    modulus = laws.reduced_modulus(300e9, 0.26, 210e9, 0.3)
    r_x, r_y = groove_radii(side, cosine)
    h = hertz_contact(r_x, r_y, modulus)
    c = ring.exact(cosine)
    damper = laws.film_damping(OIL["viscosity"], 1.0, BALL, 1.0, 0.0)
    assert [c.K, c.a, c.b, c.film_damper] == [h.K, h.a, h.b, damper]
    assert c.p == pytest.approx(h.p, rel=1e-14)
    oil = OIL["viscosity"], OIL["pressure_viscosity"]
    for at in ((0.3, 20.0), (2.0, 3000.0)):  # m/s, N
        expected = film_pair(MASJEDI_PRINTED, h.kappa, *oil, modulus, r_x, *at)
        assert films(c, *at) == pytest.approx(expected, rel=1e-13)
    assert ring.derived().modulus == modulus


def test_options_of_the_film_damper(physics):
    r_x, _ = groove_radii(INNER)
    plain, full, rolling = (
        physics.raceway_6208(INNER, **OIL, **options).radial().film_damper
        for options in ({}, dict(damper_full_axis=1), dict(damper_rolling_radius=1))
    )
    assert [full / plain, rolling / plain] == pytest.approx([2, (r_x / BALL) ** 1.5], rel=1e-14)


def test_a_dry_raceway_has_no_film(physics):
    c = physics.raceway_6208(INNER).radial()
    assert [c.min_lnA, c.min_p, c.central_lnA, c.film_damper] == [0] * 4
    assert c.K > 0


def test_a_flat_outer_groove_swaps_the_axes(physics):
    # R_y < R_x if r_c > R_b (1 + gamma)/gamma; the ellipse is then longer in the rolling direction
    ring = physics.raceway_6208(OUTER, groove_radius=60e-3, raceway_radius=36.6e-3)
    c = ring.radial()
    gamma = BALL / 30.3e-3
    assert 60e-3 > BALL * (1 + gamma) / gamma
    assert c.a < c.b


def test_prepared_constants(physics):
    ring = physics.raceway_6208(INNER, **OIL, overlap_limit=0.05)
    d = ring.derived()
    sigma = np.hypot(40e-9, 30e-9)
    # the overlap at which the ellipse is as wide as the groove
    widest = (6.552e-3 / ring.radial().a) ** 2
    assert widest < 0.05 * BALL
    assert [
        d.centre_circle,
        d.slack,
        d.largest_overlap,
        d.roughness,
        d.inverse_roughness,
        d.floor,
    ] == pytest.approx([30.552e-3, 0.252e-3, widest, sigma, 1 / sigma, sigma], rel=1e-13)
    assert d.kt_ratio == pytest.approx(2 * (1 - 0.3) / (2 - 0.3), rel=1e-15)
    # the compliance of a rolling solid sphere is 1/m + R^2/(2/5 m R^2) = 7/(2 m)
    mass = ring.data["ball_mass"]
    assert d.ct_factor == pytest.approx(
        2 * 0.3 * np.sqrt(1 / (1 / mass + 1 / (0.4 * mass))), rel=1e-14
    )
    given = physics.raceway_6208(INNER, **OIL, film_floor=1e-8, tangential_ratio=0.7).derived()
    assert [given.floor, given.kt_ratio] == [1e-8, 0.7]
    assert physics.raceway_6208(INNER).derived().inverse_roughness == 0
