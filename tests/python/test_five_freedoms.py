# SPDX-License-Identifier: GPL-2.0-or-later
"""Equilibrium under moments and with held degrees of freedom is compared with independently written
equations solved by scipy. Balance in space, derivatives and symmetries are tested too. Comparisons
with published values are in test_published_bearings.py."""

import numpy as np
import pytest
from raceway import hertz, kinematics, static
from raceway.errors import NoEquilibrium
from raceway.theory.balance import Balance
from raceway.theory.bearing import INNER, OUTER, DoubleRow
from scipy.optimize import root
from scipy.spatial.transform import Rotation

LOADS = {
    "radial, axial, moment": dict(
        radial_load=2000.0,
        axial_load=1000.0,
        moment=(10.0, -4.0),
        clearance=10e-6,
        load_azimuth=0.4,
        phase=0.1,
    ),
    "moment alone": dict(moment=(0.0, 12.0), clearance=20e-6, phase=0.1),
    "preload": dict(radial_load=3000.0, moment=(-5.0, 8.0), clearance=-30e-6, phase=0.2),
    "thrown balls": dict(
        radial_load=1500.0,
        axial_load=-800.0,
        moment=(2.0, 6.0),
        clearance=5e-6,
        orbital_speed=900.0,
    ),
    "fast": dict(
        radial_load=3000.0,
        axial_load=-500.0,
        moment=(1.0, 0.0),
        clearance=15e-6,
        phase=0.3,
        orbital_speed=1500.0,
    ),
}


KINDS = {
    "one groove": lambda bearing: bearing,
    "four points": lambda bearing: bearing.four_point(np.radians(30)),
    "back to back": lambda bearing: bearing.double_row(DoubleRow(0.02, 30e-6)),
    "two rows of four points face to face": lambda bearing: bearing.four_point(0.5).double_row(
        DoubleRow(0.02, 2e-6, "face_to_face")
    ),
}


def force(radial_load=0.0, axial_load=0.0, load_azimuth=0.0, **_):
    """Return the load (3,) in N on the ring for arguments of `static.equilibrium`."""
    way = np.array([np.cos(load_azimuth), np.sin(load_azimuth)])
    return np.array([*radial_load * way, axial_load])


def centrifugal(bearing, orbital_speed):
    """Return the centrifugal load in N of a steel ball."""
    mass = 7800 * np.pi / 6 * bearing.ball_diameter**3
    return mass * bearing.pitch_radius * orbital_speed**2


def harris(
    bearing,
    radial_load=0.0,
    axial_load=0.0,
    moment=(0, 0),
    clearance=0.0,
    load_azimuth=0.0,
    phase=0.0,
    orbital_speed=0.0,
):
    """Return the position (5,), the loads Q_i and Q_o (grooves, Z), and the corresponding angles.
    They are the solution of Harris's equations (ch. 7 and 9, without gyroscopic moment), with one
    term per groove; the solver is scipy's.

    The unknowns are the position of the ring and, for each ball, X_1 and X_2, the axial and radial
    distances of its centre from the centre of an outer groove in the middle of its row. The units
    are 0.1 mm for lengths and 1 kN for forces, so that `root` works with numbers near one.
    """
    layout, count, load = (
        bearing.layout,
        bearing.balls,
        force(radial_load, axial_load, load_azimuth),
    )
    psi = np.tile(phase + 2 * np.pi * np.arange(count) / count, len(layout.rows))
    c, s, row = np.cos(psi), np.sin(psi), np.repeat(layout.rows, count)
    heights = [np.repeat(np.transpose(one), count, axis=1) for one in (layout.inner, layout.outer)]
    r_i, (gap_i, gap_o) = bearing.groove_circle(INNER), map(bearing.groove_gap, (INNER, OUTER))
    apart = r_i - bearing.groove_circle(OUTER, clearance)  # radially, between the groove centres
    thrown = centrifugal(bearing, orbital_speed)

    def contacts(unknown):
        place = unknown[:5] * [1e-4, 1e-4, 1e-4, 1e-3, 1e-3]
        x1, x2 = 1e-4 * unknown[5:].reshape(2, -1)
        x, y, z, rx, ry = place
        h_i, h_o = heights
        a1 = z + r_i * (rx * s - ry * c) + h_i - row
        a2 = apart + (x + h_i * ry) * c + (y - h_i * rx) * s
        at_o = x1 - (h_o - row)
        d_i, d_o = np.hypot(a1 - x1, a2 - x2) - gap_i, np.hypot(at_o, x2) - gap_o
        alpha_i, alpha_o = np.arctan2(a1 - x1, a2 - x2), np.arctan2(at_o, x2)
        q = []
        for side, d, alpha in ((INNER, d_i, alpha_i), (OUTER, d_o, alpha_o)):
            ellipse = hertz.exact(*bearing.effective_radii(side, alpha, clearance))
            k = hertz.stiffness(ellipse, bearing.effective_modulus)
            q.append(k * np.maximum(d, 0) ** 1.5)
        return place, *q, alpha_i, alpha_o

    def miss(unknown):
        _, q_i, q_o, alpha_i, alpha_o = contacts(unknown)
        axial = (q_o * np.sin(alpha_o)).sum(0) - (q_i * np.sin(alpha_i)).sum(0)
        radial = (q_o * np.cos(alpha_o)).sum(0) - (q_i * np.cos(alpha_i)).sum(0) - thrown
        lever = r_i * q_i * np.sin(alpha_i) - heights[0] * q_i * np.cos(alpha_i)
        ring = [
            load[0] - np.sum(q_i * np.cos(alpha_i) * c),
            load[1] - np.sum(q_i * np.cos(alpha_i) * s),
            load[2] - np.sum(q_i * np.sin(alpha_i)),
            (moment[0] - np.sum(lever * s)) / 0.03,
            (moment[1] + np.sum(lever * c)) / 0.03,
        ]
        return np.concatenate([ring, axial, radial]) / 1000

    return contacts, miss


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", LOADS)
def test_against_harris_equations(bearing, name, kind):
    """Our position satisfies the equations. If there is one groove per ring, scipy's `root`
    converges to this position from a starting point 1 um and 0.1 mrad away."""
    bearing, case = KINDS[kind](bearing), LOADS[name]
    if kind != "one groove":  # the position of balls with play between four grooves is not unique
        case = case | {"orbital_speed": 900.0}
    state = static.equilibrium(bearing, **case)
    contacts, miss = harris(bearing, **case)
    inner, outer = (np.atleast_2d(one.load) for one in (state.inner, state.outer))
    holds = np.argmax(outer, 0), np.arange(outer.shape[1])
    reach, angle = (
        np.atleast_2d(one)[holds]
        for one in (bearing.groove_gap(OUTER) + state.outer.overlap, state.outer.angle)
    )
    height = bearing.layout.centres(OUTER, bearing.balls)[holds]
    height = height - np.repeat(bearing.layout.rows, bearing.balls)
    solution = np.concatenate(
        [
            np.concatenate([state.shift, state.tilt]) / [1e-4, 1e-4, 1e-4, 1e-3, 1e-3],
            (reach * np.sin(angle) + height) / 1e-4,
            reach * np.cos(angle) / 1e-4,
        ]
    )
    if kind == "one groove":
        scatter = np.random.default_rng(1)
        solution = root(
            miss,
            solution + 0.01 * scatter.uniform(-1, 1, len(solution)),
            method="lm",
            options={"xtol": 1e-15, "ftol": 1e-15},
        ).x
    place, q_i, q_o, alpha_i, _ = contacts(solution)
    assert np.abs(miss(solution)).max() < 1e-9  # kN
    scale = state.outer.load.max()
    # the tilt stiffness is only 2e4 N m/rad, and loads are accurate to 1e-6 N
    assert place[:3] == pytest.approx(state.shift, abs=1e-11)
    assert place[3:] == pytest.approx(state.tilt, abs=1e-9)
    assert q_i == pytest.approx(inner, abs=1e-6 * scale)
    assert q_o[outer > 0] == pytest.approx(outer[outer > 0], abs=1e-6 * scale)
    live = inner > 0.01 * scale
    assert alpha_i[live] == pytest.approx(np.atleast_2d(state.inner.angle)[live], abs=1e-6)


@pytest.mark.parametrize("name", LOADS)
def test_exact_circle_balances_in_space(bearing, name):
    """The contacts are recomputed from the ball centres in the frame of the rotated ring. The
    overlaps agree, the forces on the balls and on the ring balance, and so do the moments on the
    ring about axes perpendicular to its own."""
    case = LOADS[name]
    state = static.equilibrium(bearing, finite_shift=True, **case)
    u = np.stack([np.cos(state.azimuth), np.sin(state.azimuth), 0 * state.azimuth], 1)
    e_z = np.array([0.0, 0.0, 1.0])
    out = np.cos(state.outer.angle)[:, None] * u + np.sin(state.outer.angle)[:, None] * e_z
    reach = bearing.groove_gap(OUTER) + np.maximum(state.outer.overlap, 0)
    ball = bearing.groove_circle(OUTER, case["clearance"]) * u + reach[:, None] * out
    x, y = np.sin(state.tilt[1]), -np.sin(state.tilt[0])
    e = np.array([x, y, np.sqrt(1 - x * x - y * y)])
    turn, _ = Rotation.align_vectors([e], [e_z])
    seen = turn.inv().apply(ball - state.shift)  # in the ring's frame
    radius = np.hypot(seen[:, 0], seen[:, 1])
    section = np.stack([radius - bearing.groove_circle(INNER), seen[:, 2]], 1)
    overlap = np.linalg.norm(section, axis=1) - bearing.groove_gap(INNER)
    live = (state.inner.load > 0) & (state.outer.load > 0)
    assert overlap[live] == pytest.approx(state.inner.overlap[live], abs=1e-14)
    angle = np.arctan2(-section[:, 1], -section[:, 0])
    assert angle[live] == pytest.approx(state.inner.angle[live], abs=1e-9)

    unit = section / np.linalg.norm(section, axis=1)[:, None]
    push = np.stack(
        [unit[:, 0] * seen[:, 0] / radius, unit[:, 0] * seen[:, 1] / radius, unit[:, 1]], 1
    )
    on_ring = turn.apply(state.inner.load[:, None] * push)
    scale = state.outer.load.max()
    assert on_ring.sum(0) == pytest.approx(-force(**case), abs=1e-7 * scale)
    moment = np.cross(ball - state.shift, on_ring).sum(0)
    assert np.cross(moment + [*case["moment"], 0.0], e) == pytest.approx(
        np.zeros(3), abs=1e-8 * scale
    )
    assert state.force == pytest.approx(on_ring.sum(0), abs=1e-7 * scale)
    assert state.moment == pytest.approx(moment, abs=1e-8 * scale)
    thrown = centrifugal(bearing, case.get("orbital_speed", 0))
    balance = -on_ring - state.outer.load[:, None] * out + thrown * u
    balance = np.array([(balance * u).sum(1), balance @ e_z])[:, state.outer.load > 0]
    assert np.all(np.abs(balance) < 1e-7 * scale)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("finite_shift", [False, True])
def test_gradient_and_hessian(bearing, finite_shift, kind):
    """Gradient and Hessian equal central differences of the energy, with the balls in equilibrium
    at every position. The differences use 10 nm steps at overlaps near 20 um."""
    bearing = KINDS[kind](bearing)
    azimuth = np.tile(0.1 + 2 * np.pi * np.arange(9) / 9, len(bearing.layout.rows))
    balance = Balance(
        bearing,
        np.array([2000.0, 300.0, 900.0]),
        (9.0, -5.0),
        np.full(5, np.nan),
        azimuth,
        10e-6,
        40.0,
        finite_shift,
    )
    place = np.array([25e-6, -8e-6, 110e-6, 40e-6, -50e-6])  # tilts are given as lengths
    here = balance.at(place)
    gradient, hessian = here.gradient, here.hessian(balance.metres)
    for k in range(5):
        step = 1e-8 * np.eye(5)[k]
        ends = balance.at(place + step), balance.at(place - step)
        slope, curve = ((one - other) / 2e-8 for one, other in zip(ends[0][:2], ends[1][:2]))
        # errors: 1e-15 J in an energy of 0.05 J, and (1e-8/2e-5)^2 times the third derivative
        assert gradient[k] == pytest.approx(slope, abs=1e-6 * np.abs(gradient).max() + 1e-3)
        assert hessian[:, k] == pytest.approx(curve, rel=1e-5, abs=1e-5 * np.abs(hessian).max())


def test_stiffness_is_load_per_displacement(bearing):
    """One additional newton, or newton metre, along each degree of freedom moves the ring by the
    inverse of `stiffness`. This matrix neglects the dependence of the contact stiffness on the
    angle."""
    base = dict(radial_load=2000.0, axial_load=1000.0, moment=(10.0, -4.0), clearance=10e-6)
    state = static.equilibrium(bearing, **base)
    compliance = np.linalg.inv(state.stiffness)
    for k, step, more in (
        (0, 1.0, dict(radial_load=2001.0)),
        (2, 1.0, dict(axial_load=1001.0)),
        (3, 0.01, dict(moment=(10.01, -4.0))),
    ):
        other = static.equilibrium(bearing, **base | more)
        moved = np.concatenate([other.shift - state.shift, other.tilt - state.tilt])
        expected = compliance[:, k] * step
        least = np.abs(expected[: 3 if k == 3 else 5]).max()
        assert moved == pytest.approx(expected, rel=0.02, abs=0.02 * least)


def test_turning_and_mirroring(bearing):
    case = dict(radial_load=2000.0, axial_load=1000.0, clearance=10e-6)
    one = static.equilibrium(bearing, moment=(10.0, -4.0), phase=0.1, **case)
    turn = Rotation.from_euler("z", 1.0)
    moment = turn.apply([10.0, -4.0, 0.0])[:2]
    other = static.equilibrium(bearing, moment=moment, phase=1.1, load_azimuth=1.0, **case)
    assert other.inner.load == pytest.approx(one.inner.load, rel=1e-7)
    assert other.shift == pytest.approx(turn.apply(one.shift), abs=1e-13)
    assert np.append(other.tilt, 0) == pytest.approx(turn.apply(np.append(one.tilt, 0)), abs=1e-11)
    # mirrored in the plane of the bearing: axial load, moments, tilts and angles change sign
    below = static.equilibrium(
        bearing, moment=(-10.0, 4.0), phase=0.1, **{**case, "axial_load": -1000.0}
    )
    assert below.inner.load == pytest.approx(one.inner.load, rel=1e-7)
    assert below.shift == pytest.approx(one.shift * [1, 1, -1], abs=1e-13)
    assert below.tilt == pytest.approx(-one.tilt, abs=1e-11)
    assert below.inner.angle == pytest.approx(-one.inner.angle, abs=1e-9)


def test_held_tilt_gives_back_its_moment(bearing):
    """A moment is required to hold a tilt of 20 arc-minutes, and this moment, if applied, causes a
    tilt of 20 arc-minutes."""
    tilt = np.radians(20 / 60)
    for finite_shift in (False, True):
        held = static.equilibrium(
            bearing,
            2000.0,
            500.0,
            held={"rx": 0.2 * tilt, "ry": tilt},
            clearance=10e-6,
            finite_shift=finite_shift,
        )
        assert held.tilt == pytest.approx([0.2 * tilt, tilt], rel=1e-12)
        e = np.array([np.sin(tilt), -np.sin(0.2 * tilt), 0])
        e[2] = np.sqrt(1 - e @ e)
        # only the component perpendicular to the axis does work; the applied moment has the same
        # component
        needed = -held.moment
        needed = (needed - needed[2] / e[2] * e)[:2] if finite_shift else needed[:2]
        free = static.equilibrium(
            bearing, 2000.0, 500.0, moment=needed, clearance=10e-6, finite_shift=finite_shift
        )
        assert free.tilt == pytest.approx(held.tilt, rel=1e-7)
        assert free.inner.load == pytest.approx(held.inner.load, rel=1e-6, abs=1e-5)


def test_imposed_displacement(bearing):
    """If the ring is held in all directions, the loads follow from the displacement by Hertz's
    formula. The contacts of the ball on the load line are compressed by 30 um."""
    state = static.equilibrium(bearing, held={"x": 30e-6, "y": 0, "z": 0, "rx": 0, "ry": 0})
    assert state.inner.overlap[0] + state.outer.overlap[0] == pytest.approx(30e-6, rel=1e-10)
    assert state.residual == 0
    back = static.equilibrium(bearing, -state.force[0])
    assert back.shift[0] == pytest.approx(30e-6, rel=1e-9)


def test_held_straight_is_the_default_and_needs_a_moment(bearing):
    straight = static.equilibrium(bearing, 2000.0, 1000.0, clearance=10e-6)
    assert np.all(straight.tilt == 0)
    assert abs(straight.moment[1]) > 1  # combined radial and axial load tends to tilt the ring
    free = static.equilibrium(bearing, 2000.0, 1000.0, clearance=10e-6, moment=(0, 0))
    assert abs(free.tilt[1]) > 1e-4
    assert free.moment[:2] == pytest.approx([0, 0], abs=1e-8)


def test_pure_rolling_speed(bearing):
    """`turning` agrees with an equilibrium calculated by hand: the orbital speed belongs to the
    mean contact angle, and the angles are in equilibrium at this orbital speed."""
    from raceway.theory.lubrication import orbit, turning

    state, speed = turning(bearing, 1000.0, 0.0, 2000.0, clearance=30e-6)
    assert orbit(bearing, state, 1000.0) == pytest.approx(speed, rel=1e-8)
    angle, load = (
        np.array([getattr(one, name)[0] for one in (state.inner, state.outer)])
        for name in ("angle", "load")
    )
    mean = np.arccos(np.cos(angle) @ load / load.sum())
    assert speed == pytest.approx(1000.0 * kinematics.frequencies(bearing, mean).cage, rel=1e-8)
    # centrifugal force turns the outer contacts towards the radial direction
    assert np.all(state.inner.angle > state.outer.angle)


@pytest.mark.parametrize(
    "arguments, said",
    [
        (dict(moment=(float("nan"), 0)), "finite"),
        (dict(radial_load=float("nan")), "finite"),
        (dict(clearance=1e-5), "without a load"),
        (dict(moment=(0, 0), clearance=1e-5), "without a load"),
        (dict(radial_load=1e7), "groove|no place"),
        (dict(axial_load=1e7), "groove|no place"),
        (dict(moment=(0, 5e4)), "groove|no place"),
        (dict(held={"x": 1e-6, "rx": 0, "ry": 0}, clearance=1e-4), "no ball carries"),
    ],
)
def test_no_equilibrium(bearing, arguments, said):
    with pytest.raises(NoEquilibrium, match=said):
        static.equilibrium(bearing, **arguments)


@pytest.mark.parametrize(
    "held, said", [({"phi": 0}, "phi is not a degree of freedom"), ({"x": float("inf")}, "finite")]
)
def test_wrong_hold(bearing, held, said):
    with pytest.raises(ValueError, match=said):
        static.equilibrium(bearing, 100.0, held=held)


@pytest.mark.parametrize(
    "case",
    [
        dict(
            radial_load=1.0,
            clearance=5e-5,
            phase=0.6993181176267562,
            load_azimuth=1.572880777139937,
        ),
        dict(
            radial_load=1.0,
            axial_load=1.0,
            phase=0.44263309053734035,
            load_azimuth=2.2868251944242615,
            orbital_speed=20.0,
        ),
        dict(axial_load=1.0, clearance=1e-5, phase=0.2686148344495519, finite_shift=True),
        dict(
            radial_load=1.0,
            clearance=1e-5,
            phase=0.1456511270822216,
            load_azimuth=2.8692457983051347,
            finite_shift=True,
        ),
        dict(
            radial_load=1.0,
            moment=(0.0, 0.01),
            clearance=5e-5,
            phase=0.137,
            load_azimuth=5.977,
            finite_shift=True,
        ),
    ],
)
def test_light_loads(bearing, case):
    """Under loads of 1 N, a change in the last digit of a distance corresponds to 1e-10 N, so the
    search ends before it reaches the tolerance for the force."""
    state = static.equilibrium(bearing, **case)
    assert state.residual < 1e-8
    assert state.force == pytest.approx(-force(**case), abs=1e-8)
