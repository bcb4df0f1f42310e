# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of slip, spin, rolling resistance, mixed friction and drag against integrals over the
contact, 40-digit arithmetic, and published values."""

import numpy as np
import pytest
from physics_c import INNER, OUTER
from raceway import asperity, drag, film, hertz, rolling, sliding, spin, traction
from raceway.core import laws
from references import friction as reference
from references import spin as gauss_points
from scipy.optimize import brentq

GROOVE, BALL, PITCH = 6.552e-3, 6.3e-3, 30.3e-3
MODULUS = 210e9 / (1 - 0.3**2)
FRICTION = 0.05
REST = dict(
    side=INNER,
    overlap=18e-6,
    overlap_rate=0.0,
    cos_angle=1.0,
    entrainment=0.724764,
    sliding_t=0.0,
    sliding_w=0.0,
    spin_n=0.0,
    roll_w=0.0,
    dt=1.0,
    least=1e-4,
    mu=FRICTION,
    mu_boundary=0.12,
    mu_film=0.05,
    beta=0.047,
    starvation=0.9,
    alpha=0.01,
    density=870.0,
    oil=0.1,
    eyring=0.0,
    limit=0.0,
)
NONE = np.zeros(2)


def radii(side, cos_angle=1.0):
    gamma = BALL * cos_angle / PITCH
    r_x = BALL * (1 - gamma if side == INNER else 1 + gamma)
    return r_x, BALL * GROOVE / (GROOVE - BALL)


def turning(side=INNER, speed=0.724764, **changes):
    """Return a contact that rolls with the entrainment speed `speed` (m/s)."""
    at = REST | dict(side=side, entrainment=abs(speed)) | changes
    return at | dict(roll_w=speed / radii(side, at["cos_angle"])[0])


def of(physics, kind, contact, before=NONE):
    return physics.call(kind, contact, np.array(before, float))


def slip_arguments(found, side=INNER, speed=0.724764, cos_angle=1.0):
    """Return the arguments (load, friction, speed, a, R_d, R_x) for the functions in
    theory.sliding."""
    r_d = sliding.deformed_radius(GROOVE, BALL)
    return found.load, FRICTION, speed, found.a, r_d, radii(side, cos_angle)[0]


# ---- differential slip ---------------------------------------------------------------------------
def test_closed_form():
    unit = dict(load=1.0, friction=1.0, speed=1.0, a=1.0, r_d=0.5, r_x=1.0)  # s_e = a^2/2R_d = 1
    free, lost, slope = reference.free_rolling()
    assert [sliding.FREE**2, sliding.FREE_SPEED, sliding.LEAN] == pytest.approx(
        [free, lost, slope], rel=1e-14
    )
    for slip in (-0.7, -1e-6, 1e-6, 0.05, 0.120614, 0.3, 0.999999, 1.0, 1.4):
        found = laws.differential_slip(slip - free)
        force, couple, power = reference.heathcote(slip)
        assert found.force == pytest.approx(force, abs=1e-12)
        assert found.secant == pytest.approx(force / (slip - free), rel=1e-9)
        assert found.couple == pytest.approx(couple, abs=1e-12)
        assert sliding.heathcote(slip, **unit) == pytest.approx((force, couple, power), abs=1e-12)
        assert sliding.secant(slip, **unit) == pytest.approx(found.secant, rel=1e-12)
        # near s_e, the root follows from the small difference between F and its limit, so its
        # rounding error is 1e-8
        root = laws.slip_root_of_force(found.force)
        assert root == pytest.approx(found.root, abs=1e-12 if slip < 0.9 else 1e-7)
    found = laws.differential_slip(0.0)
    assert found.root == pytest.approx(0.347296, abs=5e-7)
    assert found.secant == pytest.approx(3.80, abs=5e-3)
    assert found.couple == pytest.approx(-0.161142, abs=5e-7)
    assert laws.deformed_radius(GROOVE, BALL) == pytest.approx(6.42353e-3, rel=1e-6)


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize("speed", [0.0724764, 0.724764, -0.724764, 14.4946])
@pytest.mark.parametrize("part", [-0.5, 0.0, 0.1, 0.120615, 0.5, 1.3])
def test_slip_law_after_a_long_time(physics, side, speed, part):
    """For dt >> tau, force, couple and power agree with theory.sliding. They change sign if the
    ball rolls backwards."""
    contact = turning(side, speed)
    arguments = slip_arguments(of(physics, "slip_of", contact), side, abs(speed))
    edge = sliding.edge_slip(abs(speed), *arguments[3:])
    slip = part * edge
    back = np.sign(speed)
    found = of(physics, "slip_of", contact | dict(sliding_t=back * slip))
    theory = sliding.heathcote(slip, *arguments)
    limit = FRICTION * found.load
    assert back * found.friction_t == pytest.approx(theory.force, abs=1e-11 * limit)
    # +C acts on the ball; couple_w has the opposite sign
    assert back * found.couple_w == pytest.approx(
        -theory.couple, abs=1e-11 * limit * found.a**2 / 0.0128
    )
    assert found.friction_power == pytest.approx(theory.power, abs=1e-11 * limit * edge)
    assert found.friction_power > 0


def test_friction_has_one_circle(physics):
    """Gross sliding in any direction causes a force mu Q opposite to the sliding velocity."""
    for angle in np.linspace(0, 2 * np.pi, 13):
        along, across = 50 * np.cos(angle), 50 * np.sin(angle)
        found = of(physics, "slip_of", turning(sliding_t=along, sliding_w=across))
        force = np.array([found.friction_t, found.friction_w])
        assert np.hypot(*force) == pytest.approx(FRICTION * found.load, rel=1e-3)
        np.testing.assert_allclose(
            force / np.hypot(*force), [np.cos(angle), np.sin(angle)], atol=2e-3
        )
    # for sliding across the rolling direction, the slope is that of free rolling
    found = of(physics, "slip_of", turning())
    arguments = slip_arguments(found)
    free = sliding.free_slip(*arguments[2:])
    found = of(physics, "slip_of", turning(sliding_t=free, sliding_w=1e-7))
    assert found.friction_w / 1e-7 == pytest.approx(sliding.secant(free, *arguments), rel=1e-6)


@pytest.mark.parametrize("along", [-3.0, -0.1, 0.0, 0.02, 0.5, 4.0])
@pytest.mark.parametrize("across", [-2.0, 0.0, 1e-3, 0.3])
def test_slip_in_both_directions(physics, along, across):
    """The law that statics evaluates for sliding along and across rolling at once is that of the
    contact after a long step. `along` and `across` are in units of s_e."""
    sizes = slip_arguments(of(physics, "slip_of", turning()))[2:]
    edge, free = sliding.edge_slip(*sizes), sliding.free_slip(*sizes)
    speeds = dict(sliding_t=free + along * edge, sliding_w=across * edge)
    found = of(physics, "slip_of", turning(**speeds))
    law, limit = laws.slip_both_ways(along, across), FRICTION * found.load
    assert found.friction_t == pytest.approx(limit * law.along, abs=1e-9 * limit)
    assert found.friction_w == pytest.approx(limit * law.across, abs=1e-9 * limit)
    arm = found.a**2 / (2 * sliding.deformed_radius(GROOVE, BALL))
    assert found.couple_w == pytest.approx(-limit * arm * law.couple, abs=1e-8 * limit * arm)


@pytest.mark.parametrize("step", [1e-9, 1e-6, 5e-5, 1e-2])
def test_spring_in_series(physics, step):
    """The slip law acts in series with the tangential spring: the force decays from its value at
    the start of the step to that of the law."""
    contact = turning(sliding_t=0.009, dt=step)
    before = np.array([15.0, 0.0])
    found = of(physics, "slip_of", contact, before)
    arguments = slip_arguments(found)
    distance = 0.009 - sliding.free_slip(*arguments[2:])
    secant = sliding.secant(0.009, *arguments)
    force = secant * distance
    force += (15.0 - force) * np.exp(-step * found.kt / secant)
    assert found.friction_t == pytest.approx(force, rel=1e-11)
    assert list(found.states) == [found.friction_t, found.friction_w]
    # the couple is due to the part of the slip that is not taken up by the spring; spring and slip
    # carry the same force
    edge = sliding.edge_slip(*arguments[2:])
    slip = brentq(
        lambda slip: sliding.heathcote(slip, *arguments).force - force, 0, edge, xtol=1e-16
    )
    couple = sliding.heathcote(slip, *arguments).couple
    assert found.couple_w == pytest.approx(-couple, rel=1e-10)


def test_no_time_changes_nothing(physics):
    before = [31.0, -7.5]
    found = of(physics, "slip_of", turning(sliding_t=0.02, sliding_w=-0.1, dt=0.0), before)
    assert [found.friction_t, found.friction_w] == before == list(found.states)


def test_spring_sticks_at_rest(physics):
    """A contact that does not roll creeps under a force below mu Q; under a force of mu Q, its
    speed is 1e-4/3.80 m/s."""
    found = of(physics, "slip_of", REST | dict(sliding_t=1e-3, dt=1e-6))
    assert found.friction_t == pytest.approx(found.kt * 1e-3 * 1e-6, rel=1e-3)  # acts as a spring
    assert found.couple_w == 0
    found = of(physics, "slip_of", REST | dict(sliding_t=1e-9, dt=1e3))
    assert found.friction_t == pytest.approx(FRICTION * found.load * 1e-9 * 3.80 / 1e-4, rel=2e-3)


def test_force_falls_with_the_load(physics):
    """While the ball is being unloaded, a spring force above mu Q is reduced to mu Q; the force
    vanishes together with the load."""
    for overlap in (18e-6, 1e-6, 1e-8, 1e-12):
        found = of(physics, "slip_of", turning(overlap=overlap, dt=1e-7), [120.0, -50.0])
        assert np.hypot(found.friction_t, found.friction_w) <= FRICTION * found.load * (1 + 1e-14)
    assert abs(found.friction_t) < 1e-6
    found = of(physics, "slip_of", turning(overlap_rate=-1e3, dt=1e-7), [120.0, -50.0])
    assert found.normal == 0
    assert max(abs(found.friction_t), abs(found.friction_w), abs(found.couple_w)) < 1e-190


def test_couple_goes_through_zero_speed_on_a_line(physics):
    speeds = np.array([-2e-6, -1e-6, 0.0, 1e-6, 2e-6])
    couples = [of(physics, "slip_of", turning(speed=speed)).couple_w for speed in speeds]
    assert couples[2] == 0
    np.testing.assert_allclose(couples, couples[3] * speeds / 1e-6, rtol=1e-3)
    assert couples[3] > 0


# ---- mixed friction ------------------------------------------------------------------------------
def test_asperity_share():
    for ratio, share in ((0.3, 0.47015), (1, 0.12246), (2, 0.022703), (3, 0.0047823)):
        found = asperity.zhou_hoeprich(ratio)
        assert found == pytest.approx(share, rel=5e-5)
        assert found == pytest.approx(np.exp(-2.1 * ratio**0.85), rel=1e-13)
    assert asperity.zhou_hoeprich(0.0) == 1.0


def test_mixed_friction(physics):
    shares = []
    for speed in (0.0725, 0.725, 2.9, 14.5):
        found = of(physics, "all_of", turning(speed=speed))
        shares.append(found.asperity_share)
        assert found.asperity_share == pytest.approx(np.exp(-2.1 * found.lambda_**0.85), rel=1e-13)
        share = found.asperity_share
        assert found.mu == pytest.approx(share * 0.12 + (1 - share) * 0.05, rel=1e-14)
    assert shares[0] > 0.3 and np.all(np.diff(shares) < 0)
    assert of(physics, "all_of", REST | dict(entrainment=0.0)).mu == pytest.approx(0.12, rel=1e-15)


@pytest.mark.parametrize("oil", [(0.04, 22e-9), (0.005, 15e-9), (0.1, 25e-9)])
def test_film_coefficient(oil):
    """The coefficient equals the sum over its eight Gauss points in 40-digit arithmetic, which
    differs from the integral by less than 1 %."""
    lowest = []
    for pressure in (1e7, 1e9, 2.5e9, 4e9):
        for rate in np.geomspace(1e-3, 1e9, 13):
            contact = (*oil, pressure, rate, 5e6, 0.047)
            found = traction.coefficient(*contact)
            assert found == pytest.approx(reference.film_coefficient(*contact, 8), rel=1e-12)
            assert found == pytest.approx(reference.film_coefficient(*contact), rel=1e-2)
            assert found <= 0.047 * (1 + 1e-9)
            lowest.append(found)
    assert min(lowest) < 1e-8 and max(lowest) > 0.04699


def test_inverse_sinh_has_no_seam():
    """If the shear stress in the film is so low that asinh alone determines the coefficient, the
    coefficient is continuous at x = 1e-3 and 1, where the formula changes."""
    for x in (1e-6, 0.999e-3, 1.001e-3, 0.5, 30.0):
        found = traction.coefficient(1.0, 1e-30, 1e9, x, 1.0, 1.0)
        assert found == pytest.approx(1.5e-9 * np.arcsinh(x), rel=1e-12)
        assert traction.eyring(2.0, -x, 2.0, 1.0) == pytest.approx(-np.arcsinh(x), rel=1e-12)


def test_mixed_friction_with_a_film_after_eyring(physics):
    """The friction coefficient of the film is evaluated at the sliding speed of free rolling
    combined with the additional sliding."""
    r_d = sliding.deformed_radius(GROOVE, BALL)
    found = []
    for speed, along, across in (
        (0.0725, 0.0, 0.0),
        (0.725, 0.0, 0.0),
        (-0.725, 1e-3, 2e-3),
        (14.5, 0.05, 0.0),
        (14.5, 0.0, 0.3),
    ):
        contact = turning(speed=speed, eyring=5e6, limit=0.047)
        r_x, r_y = radii(INNER)
        one = of(physics, "all_of", contact)
        edge = sliding.edge_slip(abs(speed), one.a, r_d, r_x)
        slip = np.sign(speed) * sliding.FREE**2 * edge + along
        one = of(physics, "all_of", contact | dict(sliding_t=slip, sliding_w=across))
        slid = np.sqrt((sliding.FREE_SPEED * edge) ** 2 + along**2 + across**2)
        kappa = hertz.exact(r_x, r_y).kappa
        h = film.h_c(r_x, film.group(0.04, 22e-9, MODULUS, r_x, kappa, abs(speed), one.load))
        pressure = 1.5 * one.load / (np.pi * one.a * one.b)
        mu = traction.coefficient(0.04, 22e-9, pressure, slid / h, 5e6, 0.047)
        share = one.asperity_share
        assert one.mu == pytest.approx(traction.mixed(share, 0.12, mu), rel=1e-11)
        found.append(mu)
    assert min(found) > 0.035 and max(found) > found[0]
    rest = REST | dict(entrainment=0.0, eyring=5e6, limit=0.047)
    assert of(physics, "all_of", rest).mu == pytest.approx(0.12, rel=1e-12)


# ---- rolling -------------------------------------------------------------------------------------
@pytest.mark.parametrize("side", [INNER, OUTER])
def test_hydrodynamic_rolling(side):
    r_x, r_y = radii(side)
    for speed in (0.0725, 0.725, 2.9, 14.5):
        given = 0.04, MODULUS, r_x, r_y, speed, 2436.0
        expected = reference.rolling_powers(*given)
        assert rolling.hydrodynamic(*given) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize("cos_angle", [1.0, 0.9])
def test_rolling_couples(physics, side, cos_angle):
    r_x, r_y = radii(side, cos_angle)
    for speed in (0.0725, 0.7248, 2.899, 14.4946):
        found = of(physics, "all_of", turning(side, speed, cos_angle=cos_angle))
        force = reference.rolling_powers(0.04, MODULUS, r_x, r_y, speed, found.load)
        factor = 0.9 * float(reference.aihara(0.047 * 0.04 * speed**2 / 0.134))
        assert found.rolling_couple == pytest.approx(factor * 2 * force * r_x, rel=1e-12)
        hysteresis = 0.01 * found.load * 2 * found.b / (3 * np.pi)
        assert found.hysteresis_couple == pytest.approx(hysteresis, rel=1e-13)
        assert rolling.hysteresis(found.load, found.b, 0.01) == pytest.approx(hysteresis, rel=1e-13)
        back = of(physics, "all_of", turning(side, -speed, cos_angle=cos_angle))
        assert back.rolling_couple == -found.rolling_couple
        assert back.hysteresis_couple == -found.hysteresis_couple
        total = found.slip_couple + found.rolling_couple + found.hysteresis_couple
        assert found.couple_w == pytest.approx(total, rel=1e-14)


def test_rolling_couples_go_through_zero_speed_on_a_line(physics):
    found = [
        of(physics, "dry_of", turning(speed=speed)).hysteresis_couple
        for speed in (-1e-3, -5e-4, 0.0, 5e-4, 1e-3, 2e-3)
    ]
    np.testing.assert_allclose(np.array(found) / found[-1], [-1, -0.5, 0, 0.5, 1, 1], rtol=1e-12)


# ---- spin ----------------------------------------------------------------------------------------
@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize("speed", [0.0724764, -0.724764, 14.4946])
def test_no_part_of_the_friction_supplies_power(physics, side, speed):
    """At any slip beside any spin, both slip and spin dissipate power."""
    sizes = slip_arguments(of(physics, "slip_of", turning(side, speed)), side, abs(speed))
    edge, free = sliding.edge_slip(*sizes[2:]), sliding.free_slip(*sizes[2:])
    for spun in (0.0, 0.3, 0.8, 3.0):
        for along in (-2.0, -0.12, -0.05, -1e-3, 0.0, 1e-3, 0.05, 0.5, 2.0):
            for across in (0.0, 0.02, 1.0):
                slid = np.sign(speed) * (free + along * edge)
                at = dict(sliding_t=slid, sliding_w=across * edge, spin_n=spun * edge / sizes[3])
                found = of(physics, "dry_of", turning(side, speed, **at))
                assert found.friction_power >= -1e-12 * FRICTION * found.load * edge, at
                assert found.couple_n * at["spin_n"] >= 0


@pytest.mark.parametrize("cos_angle", [1.0, 0.8])
@pytest.mark.parametrize("side", [INNER, OUTER])
def test_pure_spin(physics, side, cos_angle):
    found = of(physics, "dry_of", REST | dict(spin_n=30.0, side=side, cos_angle=cos_angle))
    ellipse = hertz.exact(*radii(side, cos_angle))
    theory = spin.moment(found.load, FRICTION, found.a, ellipse.second)
    assert found.couple_n == pytest.approx(theory, rel=1e-9 if cos_angle < 1 else 1e-12)
    back = of(physics, "dry_of", REST | dict(spin_n=-30.0, side=side, cos_angle=cos_angle))
    assert back.couple_n == -found.couple_n


def test_slow_spin_at_rest_has_the_least_width_of_slip(physics):
    """Without rolling, the couple of a slow spin is proportional to the spin, because of S_LEAST of
    heathcote."""
    couples = [
        of(physics, "dry_of", REST | dict(spin_n=1e-3, least=least)).couple_n
        for least in (1e-4, 2e-4, 1e-2)
    ]
    assert couples[0] == pytest.approx(2 * couples[1], rel=1e-12)
    assert couples[0] == pytest.approx(100 * couples[2], rel=1e-12)


@pytest.mark.parametrize("part", [0.1, 0.3, 0.5, 0.7, 1.0, 2.0, 5.0])
def test_spin_beside_differential_slip(physics, part):
    """Moment and power agree with an integration over the ellipse by Gauss points, at the slip for
    which the force vanishes and at a spin of omega a = part s_e."""
    free = of(physics, "dry_of", turning())
    r_d = sliding.deformed_radius(GROOVE, BALL)
    edge = sliding.edge_slip(0.724764, free.a, r_d, radii(INNER)[0])
    contact = turning(spin_n=part * edge / free.a, sliding_t=sliding.FREE**2 * edge)
    found = of(physics, "dry_of", contact)
    curve = edge / free.a**2
    slips = np.linspace(0.0, 0.15, 31) * edge
    gauss = [
        gauss_points.with_slip(
            free.load, FRICTION, free.a, free.b, slip, 0.0, contact["spin_n"], curve=curve,
            width=1e-4 * edge,
        )
        for slip in slips
    ]  # fmt: skip
    best = gauss[np.argmin([abs(one.along) for one in gauss])]
    limit = FRICTION * found.load
    assert found.couple_n == pytest.approx(best.moment, abs=0.05 * limit * free.a)
    lost = found.couple_n * contact["spin_n"] + found.slip_couple * contact["roll_w"]
    assert lost == pytest.approx(best.power, abs=0.05 * limit * edge)


# ---- drag ----------------------------------------------------------------------------------------
def test_drag_of_a_ball(physics):
    for reynolds in (1e-3, 0.1, 0.5, 1, 33, 1e3, 4e4, 1e5, 3e6):
        expected = reference.drag_coefficient(reynolds)
        assert drag.coefficient(reynolds) == pytest.approx(expected, rel=1e-13)
    # if the ball does not slide, its centre moves at -R_b roll_w
    for speed in (-7.0, -0.3, 1e-6, 0.3, 7.0):
        contact = REST | dict(side=OUTER, roll_w=-speed / BALL)
        found = of(physics, "all_of", contact)
        size = reference.drag_coefficient(870.0 * abs(speed) * 2 * BALL / 0.04)
        force = 0.5 * 0.1 * 870.0 * size * np.pi * BALL**2 * speed * abs(speed)
        assert found.drag == pytest.approx(force, rel=1e-12)
        assert drag.force(BALL, speed, 0.04, 870.0, 0.1) == pytest.approx(force, rel=1e-12)
        assert found.drag_power == pytest.approx(found.drag * speed, rel=1e-12)
    assert of(physics, "all_of", REST | dict(side=OUTER)).drag == 0
    assert of(physics, "all_of", contact | dict(side=INNER)).drag == 0
    # 0.3 N per ball of a 6208 at 9549 rpm, for an oil fraction of 0.1
    found = of(physics, "all_of", REST | dict(side=OUTER, roll_w=-12.0 / BALL))
    assert found.drag == pytest.approx(0.3, rel=0.25)


# ---- energy --------------------------------------------------------------------------------------
def test_losses_are_the_work_on_the_motions(physics):
    """The loss equals the sum of all forces and couples multiplied by their motions, excluding the
    Hertzian spring."""
    contact = turning(
        OUTER, 2.9, sliding_t=0.01, sliding_w=-0.02, spin_n=20.0, overlap_rate=0.003, cos_angle=0.9
    )
    found = of(physics, "all_of", contact, [4.0, 2.0])
    work = (
        (found.normal - found.load) * contact["overlap_rate"]
        + found.friction_t * contact["sliding_t"]
        + found.friction_w * contact["sliding_w"]
        + found.couple_n * contact["spin_n"]
        + found.couple_w * contact["roll_w"]
        + found.drag_power
    )
    assert found.loss == pytest.approx(work, rel=1e-12)
