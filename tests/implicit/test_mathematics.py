# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the mathematics of the implicit step: contact derivatives are compared with finite
differences, solvers with numpy, and a single ring with scipy; frames rotate with the balls."""

import subprocess

import numpy as np
import pytest
import scipy.integrate
from host import ROOT
from raceway.core.exports import Library


@pytest.fixture(scope="module")
def lib():
    source, target = ROOT / "tests/implicit/implicit_c.cpp", ROOT / "build/test/libimplicit.so"
    target.parent.mkdir(parents=True, exist_ok=True)
    built = ROOT / "build/obj"
    units = ("tables", "bodies", "geometry", "numbers", "step")
    core = [*sorted(built.glob("core/*/*.o")), *(built / f"units/core_{unit}.o" for unit in units)]
    flags = "-std=c++17 -O1 -DRACEWAY_ONE_TARGET -ffp-contract=off -Wall -Wextra -Wno-psabi"
    words = ["g++", *flags.split(), "-fPIC", "-shared", source, *core, "-o", target]
    subprocess.run(words, check=True)
    return Library(target)


def ball(overlap=20e-6, angle=0.0, v=(0, 0, 0), w=(0, 0, 0)):
    """Return a ball at azimuth 0.7 rad that is pressed into the outer groove at a contact angle."""
    circle, s, phi = 36.6e-3 - 6.552e-3, 0.252e-3 + overlap, 0.7
    r, z = circle + s * np.cos(angle), s * np.sin(angle)
    u, t = np.array([np.cos(phi), np.sin(phi), 0]), np.array([-np.sin(phi), np.cos(phi), 0])
    v = v[0] * u + v[1] * t + v[2] * np.array([0, 0, 1])
    return np.concatenate([r * u + [0, 0, z], v, w]).astype(float)


def force(lib, state, spin, mu, frozen):
    return lib.call("contact_force", state=state, spin=spin, mu=mu, frozen=frozen)


def derivatives(lib, state, spin, mu):
    """Return the derivatives D and K as matrices, and the normal of the contact."""
    D, K, n = lib.call("contact_derivatives", state=state, spin=spin, mu=mu)
    return D.reshape(3, 3), K.reshape(3, 3), n


def differences(lib, state, spin, mu, first, step):
    """Return -df/ds for three entries of the state, from `first` on; C, mu and the friction's
    denominator keep their values in `state`."""
    frozen = np.array([-1.0, 0, 0])
    force(lib, state, spin, mu, frozen)
    columns = []
    for k in range(3):
        up, down = state.copy(), state.copy()
        up[first + k] += step
        down[first + k] -= step
        columns.append(
            (force(lib, down, spin, mu, frozen) - force(lib, up, spin, mu, frozen)) / (2 * step)
        )
    return np.array(columns).T


ROLLING = dict(v=(2e-3, 0.6, 1e-3), w=(3.0, -2.0, -95.5))


@pytest.mark.parametrize("angle", [0.0, 0.4])
@pytest.mark.parametrize("mu", [0.0, 0.07])
def test_velocity_derivative_is_exact(lib, angle, mu):
    state = ball(angle=angle, **ROLLING)
    D, _, n = derivatives(lib, state, 0.0, mu)
    numeric = differences(lib, state, 0.0, mu, 3, 1e-7)
    assert np.abs(D - numeric).max() < 1e-6 * np.abs(D).max()
    # the spin moves the contact point: w x R n
    R = 6.3e-3
    arm = R * np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    spin = differences(lib, state, 0.0, mu, 6, 1e-5)
    assert np.abs(-D @ arm - spin).max() < 1e-6 * np.abs(D @ arm).max() + 1e-9 * np.abs(D).max()


@pytest.mark.parametrize("angle, tolerance", [(0.0, 1e-6), (0.4, 1e-2)])
def test_position_derivative(lib, angle, tolerance):
    """The derivative is exact for a radial contact. With a contact angle, it does not include the
    derivative of the constants, which are frozen."""
    state = ball(angle=angle)
    _, K, _ = derivatives(lib, state, 0.0, 0.0)
    numeric = differences(lib, state, 0.0, 0.0, 0, 1e-9)
    assert np.abs(K - numeric).max() < tolerance * np.abs(K).max()


def test_turn_of_the_normal(lib):
    """The two terms due only to the rotation of the normal are N/s across the groove and N/r along
    it."""
    state = ball()
    frozen = np.array([-1.0, 0, 0])
    N = np.linalg.norm(force(lib, state, 0.0, 0.0, frozen))
    _, K, n = derivatives(lib, state, 0.0, 0.0)
    along = np.array([-n[1], n[0], 0])
    assert K[2, 2] == pytest.approx(N / 0.272e-3, rel=1e-6)
    assert along @ K @ along == pytest.approx(N / np.hypot(*state[:2]), rel=1e-6)


def test_friction_slope_is_a_dashpot(lib):
    """A sliding contact resists motion in every direction: except for the cross term mu C, the
    slope has no negative eigenvalue."""
    state = ball(v=(0, 0.65, 2e-3), w=(0, 0, -95.5))
    D = derivatives(lib, state, 0.0, 0.07)[0]
    assert np.linalg.eigvalsh(D + D.T).min() > -1e-3 * np.abs(D).max()


@pytest.mark.parametrize("n", [3, 6])
def test_blocks_against_numpy(lib, n):
    rng = np.random.default_rng(5)
    A, r = np.zeros((4, 6, 6)), np.zeros((4, 6))
    A[:, :n, :n] = rng.normal(size=(4, n, n)) * 0.3 + 3 * np.eye(n)
    r[:, :n] = rng.normal(size=(4, n))
    expected = np.linalg.solve(A[:, :n, :n], r[:, :n, None])[..., 0]
    lib.call("blocks", n=n, A=A, r=r)
    np.testing.assert_allclose(r[:, :n], expected, rtol=1e-13, atol=1e-14)


@pytest.mark.parametrize("n", [1, 2, 5, 12])
def test_dense_against_numpy(lib, n):
    rng = np.random.default_rng(6)
    A, y = rng.normal(size=(n, n)), rng.normal(size=n)
    expected = np.linalg.solve(A, y)
    lib.call("dense", n=n, A=A, y=y)
    np.testing.assert_allclose(y, expected, rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize("links", ["circle", "open", "broken"])
@pytest.mark.parametrize("balls", [1, 2, 3, 9])
def test_chain_against_dense(lib, balls, links):
    rng = np.random.default_rng(7)
    n = 2 * balls  # ball, cage ball, ball, ...
    inverse = rng.normal(size=(n, 3, 3)) * 0.1 + np.eye(3)
    pairs = [(k, (k + 1) % n) if k % 2 == 0 else ((k + 1) % n, k) for k in range(n)]
    if links == "open":
        pairs = pairs[:-1]
    if links == "broken":
        pairs = [p for k, p in enumerate(pairs) if k % 5 not in (2, 3)]
    order = rng.permutation(len(pairs))
    pairs = np.array([pairs[i] for i in order], dtype=np.int32).reshape(-1, 2)
    m = len(pairs)
    normals = rng.normal(size=(m, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    a, x = rng.uniform(0.5, 50, size=m), rng.normal(size=m)
    matrix = np.diag(1 / a)
    for i in range(m):
        for j in range(m):
            for end, body in enumerate(pairs[i]):
                for other, same in enumerate(pairs[j]):
                    if body == same:
                        matrix[i, j] += (
                            (1 if end == other else -1) * normals[i] @ inverse[body] @ normals[j]
                        )
    expected = np.linalg.solve(matrix, x)
    found = lib.call(
        "chain", bodies=n, inverse=inverse, links=m, pairs=pairs, normals=normals, a=a, x=x
    )
    assert found == 1
    np.testing.assert_allclose(x, expected, rtol=1e-11, atol=1e-12)


def test_a_third_link_is_no_chain(lib):
    pairs = np.array([[0, 1], [0, 2], [0, 3]], dtype=np.int32)
    inverse, normals = np.tile(np.eye(3), (4, 1, 1)), np.tile([1.0, 0, 0], (3, 1))
    a, x = np.ones(3), np.ones(3)
    found = lib.call(
        "chain", bodies=4, inverse=inverse, links=3, pairs=pairs, normals=normals, a=a, x=x
    )
    assert found == 0


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-3, -0.1, 0.37, -0.6, 0.6])
def test_small_turn(lib, angle):
    c, s = lib.call("turn", angle)
    assert c[0] == pytest.approx(np.cos(angle), rel=3e-16)
    assert s[0] == pytest.approx(np.sin(angle), rel=3e-16)


INERTIA, SPIN, MOMENT = np.array([3e-4, 1.6e-4]), 800.0, np.array([0.4, -0.2, 0.1])


def lone_ring(lib, order, steps, time):
    return lib.call(
        "lone_ring", order=order, n=steps, h=time / steps, spin=SPIN, inertia=INERTIA, moment=MOMENT
    )


def gyroscope(time):
    """Return the axis and its rate of change from L' = M + reaction along e, which scipy integrates
    with the complete kinematics."""
    axial, transverse = INERTIA

    def slope(_, y):
        e, L = y[:3], y[3:]
        along = e * (L @ e)
        turn = np.cross((L - along) / transverse, e)
        # the spin is imposed, so the momentum along e remains I_a spin, and the drive supplies the
        # other part of the moment
        return np.concatenate([turn, MOMENT - e * (MOMENT @ e)])

    start = np.array([0, 0, 1, 0, 0, axial * SPIN])
    y = scipy.integrate.solve_ivp(slope, (0, time), start, rtol=1e-12, atol=1e-14).y[:, -1]
    across = (y[3:] - y[:3] * (y[3:] @ y[:3])) / transverse
    return y[:3], across[:2]


@pytest.mark.parametrize("order, method", [(1, 1), (2, 2), (1, 0)], ids=["1", "2", "dampers only"])
def test_gyroscope(lib, order, method):
    """A spinning ring under a moment precesses and nutates as in theory, with errors at the order
    of the method."""
    time = 5e-3
    axis, rate = gyroscope(time)
    errors = []
    for steps in (400, 800, 1600):
        out = lone_ring(lib, method, steps, time)
        errors.append(
            max(
                np.abs(out.e - axis).max() / np.abs(axis[:2]).max(),
                np.abs(out.rate - rate).max() / np.abs(rate).max(),
            )
        )
    for coarse, fine in zip(errors, errors[1:]):
        assert 0.85 * 2**order < coarse / fine < 1.15 * 2**order
    assert errors[-1] < (0.1, 1e-3)[order - 1]


@pytest.mark.parametrize("method", [2, 0], ids=["order 2", "dampers only"])
def test_free_fall_is_exact(lib, method):
    """Under a constant force, order 2 reproduces the parabola to rounding accuracy. The same
    applies to `solve damping`, which treats springs in the same way as velocity Verlet."""
    out, time = lone_ring(lib, method, 7, 2e-3), 2e-3
    acceleration = np.array([1.0, 2.0, 3.0]) / 0.5
    np.testing.assert_allclose(out.v, acceleration * time, rtol=1e-12)
    np.testing.assert_allclose(out.x, 0.5 * acceleration * time**2, rtol=1e-12)


def estimated(lib, n, h, place, velocity, relative=0.0, **loads):
    """Return the largest error estimated in a step, and position and velocity at the end."""
    x, v = np.array([place, 0.0]), np.array([velocity, 0.0])
    loads = {"stiffness": 0.0, "force": 0.0, **loads}
    error = lib.call("estimated_errors", relative=relative, n=n, h=h, place=x, velocity=v, **loads)
    return error, x[1], v[1]


# relative tolerance, and the smallest error that is assumed, relative to that of a first-order
# method
SHARES = pytest.mark.parametrize("relative, share", [(0.0, 0.7), (2e-4, 0.3)])


RATE, SWING = 2000.0, 1e-6  # vibration of a ring of 0.5 kg on a spring: rate (rad/s), amplitude (m)
SPRING = 0.5 * RATE**2
GAMMA = 1 - np.sqrt(0.5)


@pytest.mark.parametrize("turn", [0.1, 0.05, 0.02])
def test_estimate_of_a_step_of_a_vibration(lib, turn):
    """The velocity is the same at both ends of each stage, so the error bound is 0. The relevant
    error is the distance of the end point from the exact one in the plane of position and velocity:
    R(z) of the method lacks c z^3, and the first stage has the second difference gamma z^2 v
    instead of z^2 v/2. Four times the error for a velocity that is a given function of time is 0.59
    of this distance."""
    h = turn / RATE
    start = -0.5 * (1 + GAMMA) * turn
    error, x, v = estimated(
        lib, 1, h, SWING * np.sin(start), SWING * RATE * np.cos(start), stiffness=SPRING
    )
    end = start + turn
    off = np.hypot(x - SWING * np.sin(end), v / RATE - SWING * np.cos(end))
    c = GAMMA**2 * (3 - 2 * GAMMA) - 1 / 6
    given = GAMMA + (1 - GAMMA) * GAMMA**2 - 1 / 3  # for v = t^2
    assert off == pytest.approx(c * turn**3 * SWING, rel=turn, abs=0)
    assert error == pytest.approx(4 * given * GAMMA / c * off, rel=2 * turn, abs=0)


@SHARES
def test_estimate_of_a_constant_force_is_a_share_of_the_bound(lib, relative, share):
    """The method has no error under a constant force, so the estimate is a share of the error of a
    first-order method."""
    h, acceleration = 1e-4, 3.0 / 0.5
    error, x, _ = estimated(lib, 1, h, 0.0, 0.0, relative, force=3.0)
    bound = GAMMA * (1 - GAMMA) * h**2 * acceleration
    assert x == pytest.approx(0.5 * acceleration * h**2, rel=1e-12, abs=0)
    assert error == pytest.approx(share * bound, rel=1e-12, abs=0)


@SHARES
@pytest.mark.parametrize("periods", [1, 10])
def test_vibration_lags_by_less_than_the_stated_bound(lib, periods, relative, share):
    """After s radians of a vibration that determines the step, the error is below 0.195 s/share
    times the largest error estimated in a step (docs/fix_bearing_implicit). In theory it is
    c/(share gamma (1 - gamma)) s times this estimate."""
    turn = 0.02
    n = round(2 * np.pi * periods / turn)
    error, x, v = estimated(lib, n, turn / RATE, SWING, 0.0, relative, stiffness=SPRING)
    s = n * turn
    off = np.hypot(x - SWING * np.cos(s), v / RATE + SWING * np.sin(s))
    assert 0.18 * s * error < share * off < 0.1956 * s * error


@pytest.mark.parametrize("swing, lost", [(10, 0.04), (3, 0.13), (1, 0.27)])
def test_share_of_a_small_vibration_that_is_filtered_out(lib, swing, lost):
    """A vibration of `swing` times the tolerance loses the stated share per period, if its steps
    have the length at which its error reaches the tolerance (docs/fix_bearing_implicit)."""
    turn = 1 / np.sqrt(0.3 * GAMMA * (1 - GAMMA) * swing)
    _, x, v = estimated(lib, 1, turn / RATE, SWING, 0.0, 2e-4, stiffness=SPRING)
    left = np.hypot(x, v / RATE) / SWING
    assert 1 - left ** (2 * np.pi / turn) == pytest.approx(lost, abs=0.005)


def test_turning_frame_keeps_a_circle(lib):
    x, v = np.array([30e-3, 0, 1e-3]), np.array([0, 0.6, 0])
    for _ in range(1000):
        x, v = lib.call("drift", x=x, v=v, h=1e-3)
    assert np.hypot(*x[:2]) == pytest.approx(30e-3, rel=1e-13)
    assert np.arctan2(x[1], x[0]) % (2 * np.pi) == pytest.approx(20.0 % (2 * np.pi), rel=1e-10)
    assert v @ x == pytest.approx(0, abs=1e-15) and np.linalg.norm(v) == pytest.approx(
        0.6, rel=1e-13
    )


def test_between_steps_a_cubic_is_exact(lib):
    place = np.polynomial.Polynomial([0.3, -2.0, 1.5, 4.0])
    t, h = 0.7, 0.4
    for s in (0.0, 0.25, 0.6, 1.0):
        speed = place.deriv()
        ends = dict(x_from=place(t), v_from=speed(t), x_to=place(t + h), v_to=speed(t + h))
        found = lib.call("cubic", s=s, h=h, **ends)
        assert found == pytest.approx(place(t + s * h), rel=1e-14)


def test_between_steps_an_axis_turns_to_fourth_order(lib):
    """Half-way between two instants h apart, the axis of a precessing ring has an error of order
    h^4."""
    errors = []
    for h in (2e-3, 1e-3, 5e-4):
        miss = lib.call("axis_between", [40.0, -60.0, 30.0], h)
        errors.append(np.linalg.norm(miss))
    for coarse, fine in zip(errors, errors[1:]):
        assert 15 < coarse / fine < 17


def flawed(lib, overlap, off_middle, width, of_ball):
    """Return the matrix of a ball on a flaw, its differences and its transposed part."""
    found = lib.call(
        "flawed_system",
        notch=np.array([1e-3, width, 1e-4, 5e-5]),
        of_ball=of_ball,
        off_middle=off_middle,
        overlap=overlap,
        h=1e-5,
    )
    return [part.reshape(6, -1) for part in found]


@pytest.mark.parametrize("width", [0, 3e-4], ids=["full", "pit"])
@pytest.mark.parametrize("off_middle", [-4e-4, 1e-5, 2e-4, 2e-3])
def test_derivatives_over_a_flaw(lib, off_middle, width):
    """The matrix of the implicit step includes the slope and the curvature of a flaw, on a flank,
    at an edge and on a wave. It also includes the motion of the ring with the flaw."""
    matrix, differences, transposed = flawed(lib, 2.5e-5, off_middle, width, 0)
    mass, frame, _ = flawed(lib, -2e-4, off_middle, width, 0)  # without contact
    force, want = (matrix - mass)[:3], (differences - frame)[:3]
    stiff = want[0, 0]
    # the matrix rotates the force as the ball moves around, whereas the ball's frame already does
    # so: h^2 N/r
    assert np.abs(force[1, 1] - want[1, 1]) < 7e-4 * stiff
    force[1, 1] = want[1, 1]
    assert np.abs(force - want)[:, [0, 1, 2, 6, 7]].max() < 5e-5 * stiff
    assert force[:, 8] == pytest.approx(want[:, 8], abs=1e-8 * stiff)  # spin of the ring
    assert transposed[:3, :2] == pytest.approx(force[:, 6:8], abs=1e-12 * stiff)
    if off_middle < 1e-3:
        assert np.abs(want[0, 1]) > 1e-3 * stiff  # the slope is not negligible


@pytest.mark.parametrize("width", [5e-3, 3e-4], ids=["wide", "narrow"])
@pytest.mark.parametrize("off_middle", [-4e-4, 1e-5, 2e-4, 2e-3])
def test_derivatives_over_a_flaw_of_the_ball(lib, off_middle, width):
    """For a flaw of a ball, the ball's spin about the axis replaces its motion along the
    raceway.
    """
    matrix, differences, transposed = flawed(lib, 2.5e-5, off_middle, width, 1)
    mass, frame, _ = flawed(lib, -2e-4, off_middle, width, 1)  # without contact
    force, want = matrix - mass, differences - frame
    stiff, radius = want[0, 0], 6.3e-3
    for row, unit_row in ((0, 1.0), (1, 1.0), (5, radius)):
        for column, unit in ((0, 1.0), (5, radius)):
            off = force[row, column] - want[row, column]
            assert abs(off) < 5e-5 * stiff * unit_row * unit, (row, column)
    assert np.abs(force - want)[0, 6:8].max() < 5e-5 * stiff  # x, y of the ring
    assert np.abs(force[:, 8]).max() < 1e-8 * stiff  # spin of the ring
    assert transposed[0, :2] == pytest.approx(force[0, 6:8], abs=1e-12 * stiff)
    if off_middle < 1e-3:
        assert np.abs(want[0, 5]) > 1e-3 * stiff * radius  # the slope is not negligible


def test_old_factors_stay(lib):
    """Corrections that reuse earlier factors solve with exactly these factors and do not add masses
    a second time."""
    h = 1e-4
    found = lib.call("old_factors", h=h)
    assert found.reshape(3, 3) == pytest.approx(
        np.array([[1.0, 2.0, 3.0]] * 3) * h / 0.5, rel=1e-14
    )


def resting(lib, steps=1, **words):
    """Return the number of corrections, the estimated error (m) and the overlap (m) for each step
    of a ball on a raceway."""
    found = np.zeros((3, steps))
    lib.call("resting", n=steps, corrections=found[0], error=found[1], overlap=found[2], **words)
    return found


def test_a_ball_that_rests_stays(lib):
    """A ball of 8 g that rolls around at 2 rad/s is pressed on its raceway by 1 mN, up to an
    overlap of 1 nm. It starts a nanometre away from the raceway. The tolerance is 5 nm, and a step
    lasts a few periods of the ball's vibration. One correction per stage brings the ball to its
    equilibrium position, and it does not jump off the raceway and back."""
    scene = dict(speed=2 * 30.3e-3, gap=1e-9, heavy=0.0, h=4e-3, steps=10)
    corrections, _, overlap = resting(lib, newton=5e-9, **scene)
    assert corrections.tolist() == [2] * 10
    exact = resting(lib, newton=1e-13, **scene)[2][-1]
    assert 0 < exact < 2e-9
    assert overlap[-1] == pytest.approx(exact, rel=1e-6)


def test_a_light_ball_counts_a_tenth(lib):
    """The error of an unloaded ball has a weight of only a tenth if another ball has an overlap of
    0.1 um."""
    scene = dict(speed=30.0, gap=1e-6, newton=1e-9, h=1e-7)
    alone, beside = (resting(lib, heavy=heavy, **scene)[1][0] for heavy in (0.0, 1e-7))
    assert alone > 1e-11
    assert beside == pytest.approx(0.1 * alone, rel=1e-12)


@pytest.mark.parametrize(
    "gap, speed, h", [(1e-8, 3e-4, 2e-4), (6e-8, 1e-3, 1e-3), (6.5e-8, 1e-2, 3e-5)]
)
def test_a_contact_that_opens_and_closes_in_turn_is_met_half_way(lib, gap, speed, h):
    """A ball reaches a cage ball within a step. Full corrections would alternate between the open
    and the closed contact."""
    corrections = np.zeros(1)
    lib.call("meeting", gap=gap, speed=speed, h=h, newton=1e-9, corrections=corrections)
    assert corrections[0] <= 16


@pytest.mark.parametrize("again", [0, 1])
def test_corrections_of_the_cage_alone_start_from_the_matrix_of_the_raceways(lib, again):
    """The matrix is restored even after a correction that used the factors of an earlier matrix."""
    want = np.random.default_rng(4).standard_normal(48)
    want[:36:7] += 10.0
    np.testing.assert_array_equal(lib.call("matrix_kept", again=again, matrix=want), want)
