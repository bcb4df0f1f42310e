# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of film_capacitor.h: the capacitance of a contact with its surroundings has no jumps, and
agrees with published values and with integrals over the gap."""

import numpy as np
import pytest
from physics_c import BALL, INNER, MASJEDI, OIL, OUTER, PITCH, film_pair, groove_radii
from raceway import capacitance_outside, hertz
from raceway.core import laws
from raceway.theory.groove_width import HalfWidths
from scipy.constants import epsilon_0
from scipy.integrate import quad
from scipy.optimize import brentq

ALL, DRY, CAVITATED = 1, 2, 3  # Surroundings
MODEL = dict(
    permittivity=2.2,
    film_floor=1e-9,
    at=0,
    rough=0,
    surroundings=ALL,
    outlet=1.0,
    inner_shoulder=52.6e-3,
    outer_shoulder=68.6e-3,  # a groove that is 2.3 mm deep, like the inner groove
    gap=0.0,
)


def capacitors(physics, raceway, overlap, speed=1.5, cage_speed=62.0, cos_angle=1.0, **changes):
    """Return h_c, capacitance, separation, and capacitance outside the contact, for each overlap.
    Also assert that evaluating the contacts one by one and four at a time gives equal results."""
    columns = np.broadcast_arrays(np.asarray(overlap, float), cos_angle, speed, cage_speed)
    n = columns[0].size
    padded = [np.pad(np.ravel(c), (0, -n % 4), mode="edge") for c in columns]
    one, four = (np.full(4 * padded[0].size, np.nan) for _ in range(2))
    named = zip(("overlap", "cos_angle", "speed", "cage_speed"), padded, strict=True)
    physics.call(
        "capacitors",
        raceway=raceway._handle,
        n=padded[0].size,
        one=one,
        four=four,
        **{"in": MODEL | changes},
        **dict(named),
    )
    np.testing.assert_array_equal(one, four)
    return one.reshape(-1, 4)[:n].T


def test_t5_plates_dominate_thin_films(physics):
    raceway = physics.raceway(**OIL)
    _, plates, separation, outside = capacitors(
        physics, raceway, [20e-6, 20e-6], speed=[1.5, 1e-6], film_floor=1e-12
    )
    assert separation[1] < 1e-9
    assert outside[0] / plates[0] > 0.2 and outside[1] / plates[1] < 0.02


def test_t5_what_fills_the_gap(physics):
    raceway = physics.raceway(**OIL)
    overlap = [15e-6, 1e-7, -4e-6]
    fill = {
        kind: capacitors(physics, raceway, overlap, surroundings=kind)[3]
        for kind in (ALL, DRY, CAVITATED)
    }
    foam = capacitors(physics, raceway, overlap, surroundings=CAVITATED, outlet=1.6)[3]
    np.testing.assert_allclose(fill[CAVITATED], (fill[ALL] + fill[DRY]) / 2, rtol=1e-14)
    np.testing.assert_allclose(fill[ALL], 2.2 * fill[DRY], rtol=1e-14)
    np.testing.assert_allclose(foam, 1.9 * fill[DRY], rtol=1e-14)
    derived = raceway.reach(2.3e-3)[0]
    h = capacitors(physics, raceway, overlap)[2][2]
    assert h == 4e-6
    r_x, r_y = groove_radii(INNER)
    widths = HalfWidths(derived, derived)
    exact = capacitance_outside.rigid(hertz.exact(r_x, r_y), r_x, BALL, 6.552e-3, h, widths)
    assert fill[DRY][2] == pytest.approx(epsilon_0 * exact, rel=1e-9)


@pytest.mark.parametrize("gap", [0.0, 0.5, 1.0, 1.5])
@pytest.mark.parametrize("cage_speed", [0.0, 62.0, 250.0])
def test_t7_through_loss_of_contact(physics, gap, cage_speed):
    """No value jumps between steps of 1 nm, or of 1e-12 m near the overlap at which contact begins,
    both with and without a film in the gap."""
    raceway = physics.raceway(**OIL)
    overlap = np.arange(-1e-6, 1e-6, 1e-9)
    named = dict(cage_speed=cage_speed, gap=gap)
    h_c, plates, h, outside = capacitors(physics, raceway, overlap, **named)
    assert np.all(h > 0) and np.all(outside > 0)
    assert np.all((h_c > 0) == (plates > 0))
    first = overlap[np.argmax(plates > 0)]
    fine = first - 1e-9 + 1e-12 * np.arange(1001)
    _, fine_plates, fine_h, fine_outside = capacitors(physics, raceway, fine, **named)
    assert fine_plates[0] == 0 < fine_plates[-1]
    total = fine_plates + fine_outside
    assert np.abs(np.diff(fine_h)).max() < 1e-10
    # the film in the gap begins together with the plates, at an overlap of h/1000; the capacitance
    # of the plates then grows as Q^(2/3)
    assert np.abs(np.diff(total)).max() < 2e-4 * total.mean()


def test_the_separation(physics):
    """The separation is the film thickness h_c at the load max(Q, Q_u), or the height of the gap if
    this is larger."""
    raceway = physics.raceway(**OIL)
    derived = raceway.radial()
    cage_speed = 200.0
    q_u = raceway.data["ball_mass"] * PITCH * cage_speed**2
    heavy, light = (4 * q_u / derived.K) ** (2 / 3), (0.1 * q_u / derived.K) ** (2 / 3)
    h = capacitors(physics, raceway, [heavy, light, -1e-9, -1e-5], cage_speed=cage_speed)[2]
    r_x, r_y = groove_radii(INNER)
    film = MASJEDI, hertz.exact(r_x, r_y).kappa, 0.04, 15e-9, 210e9 / 0.91, r_x, 1.5
    least = film_pair(*film, q_u)[1]
    assert h[0] == pytest.approx(film_pair(*film, 4 * q_u)[1], rel=1e-12)
    np.testing.assert_allclose(h[1:3], least, rtol=1e-12)
    assert h[3] == 1e-5
    at_rest = capacitors(physics, raceway, [-1e-9], cage_speed=0.0)[2]
    assert at_rest == pytest.approx(film_pair(*film, 0.1)[1], rel=1e-12)
    assert capacitors(physics, raceway, [-1e-9, 1e-7], film_floor=2e-6)[2] == pytest.approx(2e-6)


def test_plates_are_those_without_surroundings(physics):
    raceway = physics.raceway(**OIL)
    overlap = np.r_[np.geomspace(1e-12, 3e-5, 15), -1e-6]
    for changes in ({}, dict(at=1, rough=1), dict(at=2)):
        alone = capacitors(physics, raceway, overlap, surroundings=0, **changes)
        with_all = capacitors(physics, raceway, overlap, **changes)
        np.testing.assert_array_equal(alone[:2], with_all[:2])
        assert not np.any(alone[2:])


@pytest.mark.parametrize("ambient", [1.0, 2.2, 4.0, 9.9])
@pytest.mark.parametrize("pressure", [0.0, 1e3, 2e7, 1e8, 1.5e9, 4e9])
def test_mean_permittivity(ambient, pressure):
    def ring(q):
        return 2 * q * laws.permittivity(ambient, pressure * q)

    exact = quad(ring, 0, 1, epsabs=1e-13, epsrel=1e-13)[0]
    assert laws.mean_permittivity(ambient, pressure) == pytest.approx(exact, rel=1e-10)


@pytest.mark.parametrize("at, eps", [(0, 2.654), (1, 2.578), (2, 2.593)])
def test_where_the_permittivity_is_taken(physics, at, eps):
    """The relative permittivity, 2.2 at ambient pressure, increases at 1.5 GPa. By how much depends
    on where in the contact the pressure is evaluated."""
    raceway = physics.raceway(**OIL)
    derived = raceway.radial()
    overlap = (1.5e9 / derived.p) ** 2
    h_c, plates, _, _ = capacitors(physics, raceway, [overlap], at=at, surroundings=0)
    area = np.pi * derived.a * derived.b * overlap
    assert plates * h_c / (epsilon_0 * area) == pytest.approx(eps, abs=6e-4)


def test_t12_rough_films(physics):
    factors = [laws.rough_film_factor(1 / x) for x in (3, 4, 5, 6, 10, 2.5)]
    known = [1.125, 1.0667, 1.0417, 1.0286, 1.0101, 25 / 21]
    np.testing.assert_allclose(factors, known, atol=5e-5)
    assert laws.rough_film_factor(0.0) == 1
    assert laws.rough_film_factor(1 / 0.3) == pytest.approx(25 / 21)
    raceway = physics.raceway(**OIL)
    smooth, rough = (capacitors(physics, raceway, [1e-5], rough=r) for r in (0, 1))
    film_parameter = smooth[0] / 50e-9  # roughness 40 nm and 30 nm
    assert rough[1] / smooth[1] == pytest.approx(1 / (1 - film_parameter**-2), rel=1e-12)


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize(
    "changes", [{}, dict(gap=1.0), dict(at=1, rough=1, surroundings=CAVITATED)]
)
def test_four_side_by_side_are_one_by_one(physics, side, changes):
    """Contacts and gaps in any mixture, radial and oblique, light and heavy, are compared bitwise
    in `capacitors`."""
    raceway = physics.raceway_6208(side, **OIL)
    random = np.random.default_rng(13)
    n = 400
    values = capacitors(
        physics,
        raceway,
        random.choice([1, -1], n) * 10 ** random.uniform(-9, -4.7, n),
        speed=10 ** random.uniform(-3, 1.3, n),
        cage_speed=10 ** random.uniform(0, 2.7, n),
        cos_angle=np.where(random.random(n) < 0.5, 1.0, random.uniform(0.7, 1, n)),
        **changes,
    )
    assert np.isfinite(values).all() and (values[2:] > 0).all()


# ---- two grooves per ring
def arch(physics, side, free, bottom):
    """Return one of the two grooves of a 6208 ring. A centred ball touches it at the angle `free`
    (rad), at the same radius as the bottom of a single groove with the radius `bottom` (m)."""
    gap, way = 6.552e-3 - BALL, -1 if side == INNER else 1
    radius = bottom + way * gap * (1 - np.cos(free))
    return physics.raceway(side=side, raceway_radius=radius, offset=gap * np.sin(free), **OIL)


def rigid_flank(side, free, bottom, play, shoulder):
    """Return the integral I (m) for a rigid centred ball and one flank of an arch, taken from the
    edge between the grooves to a `shoulder` with a given radius (m). The integration uses planes
    through the bearing's axis and, in each direction from the ball's centre, a parabola along
    rolling."""
    groove, gap = 6.552e-3, 6.552e-3 - BALL
    # coordinates of the groove centre relative to the ball centre
    centre = np.array([-gap * np.cos(free), gap * np.sin(free)])
    if play:  # the ball is moved away from the raceway by the clearance at its contact
        centre *= 1 - play / gap
    pitch = bottom + (BALL if side == INNER else -BALL)
    # `down` points towards the raceway
    height = pitch - shoulder if side == INNER else shoulder - pitch

    def wall(angle):
        """Return the distance between the groove and the ball's centre in the direction at `angle`
        from straight down, towards the flank."""
        line = np.array([np.cos(angle), -np.sin(angle)])
        along = line @ centre
        return along + np.sqrt(along**2 + groove**2 - centre @ centre)

    def past(angle):
        return wall(angle) * np.cos(angle) - height

    def strip(angle):
        ratio = BALL * np.cos(angle) / pitch
        r_x = BALL * (1 - ratio if side == INNER else 1 + ratio)
        return np.pi * np.sqrt(2 * r_x / (wall(angle) - BALL)) * BALL

    edge = brentq(past, 1e-3, 1.5)
    return quad(strip, 0.0, edge, points=[free], limit=200)[0]


@pytest.mark.parametrize(
    "side, bottom, shoulder", [(INNER, 24.0e-3, 26.3e-3), (OUTER, 36.6e-3, 34.3e-3)]
)
@pytest.mark.parametrize("free", np.radians([20.0, 35.0]))
@pytest.mark.parametrize("play", [2e-6, 10e-6])
def test_a_flank_of_two_grooves(physics, side, bottom, shoulder, free, play):
    """A flank that the ball does not touch is integrated from the edge between the grooves to the
    shoulder."""
    raceway = arch(physics, side, free, bottom)
    named = {"inner_shoulder": 2 * shoulder} if side == INNER else {"outer_shoulder": 2 * shoulder}
    outside = capacitors(
        physics, raceway, [-play], cos_angle=np.cos(free), surroundings=DRY, **named
    )[3]
    exact = rigid_flank(side, free, bottom, play, shoulder)
    assert outside / epsilon_0 == pytest.approx(exact, rel=0.01)
