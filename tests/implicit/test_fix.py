# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of fix bearing/implicit against velocity Verlet with the same friction, against statics,
and against its own results with finer steps."""

import re

import numpy as np
import pytest
import raceway
from host import ROOT, deck_file, frames, refuses, succeed
from scenarios import closed_forms

CASE = "tests/implicit/in.case"


def loads(folder):
    """Return the contact loads (samples, raceways, balls) in N from a run of in.case."""
    table = np.zeros((len(frames(folder / "contacts.dump")), 2, 9))
    for sample, rows in enumerate(frames(folder / "contacts.dump").values()):
        for ball, side, load, *_ in (map(float, row.split()) for row in rows):
            table[sample, int(side), int(ball) - 1] = load
    return table


def error(tmp_path, control="", verlet_step=5e-8, after=0, **case):
    """Return the largest difference in any contact load between the two integrators, starting from
    sample `after`, relative to the largest load."""
    sample = float(case.get("sample", 1e-4))
    succeed(
        CASE,
        out=tmp_path / "verlet",
        integrator="verlet",
        substeps=round(sample / verlet_step),
        **case,
    )
    succeed(CASE, out=tmp_path / "implicit", control=control, **case)
    truth, found = loads(tmp_path / "verlet"), loads(tmp_path / "implicit")
    return np.abs(found - truth)[after:].max() / truth.max()


def ring(motion):
    return f"x free y free {motion} ramp 3.0e-3"


RADIAL = ring("spin speed 50 force 0 -5000 0")
ESTIMATE = "tolerance 1e-10 control estimate"
LOOSE, TIGHT = dict(clearance=44.1e-6), dict(clearance=-88.2e-6)
SMALL_PLAY = dict(cage_ball=8.4455e-3)


@pytest.mark.parametrize(
    "bound, control, case",
    [
        (1e-4, "", {}),
        (1e-3, "", LOOSE),
        (1e-4, "", TIGHT),
        (1e-3, "", dict(inner=ring("z free spin speed 50 force 0 -2000 3000"))),
        (1e-4, "", dict(outer="x free y free force 0 5000 0 ramp 3.0e-3")),
        (3e-3, "", dict(inner=ring("spin free force 0 -5000 0 moment 0 0 0.5"))),
        (2e-3, "", dict(lubricant="dry")),
        (1e-4, "", SMALL_PLAY),
        (2e-4, ESTIMATE, {}),
        (1e-3, ESTIMATE, LOOSE),
        (2e-4, ESTIMATE, SMALL_PLAY),
    ],
    ids=str,
)
def test_loads_against_verlet(tmp_path, bound, control, case):
    """Loads after the ramp agree with velocity Verlet, with the defaults and with errors estimated
    to 0.1 nm. The implicit run has one step per sample of 0.1 ms, 2000 times as long as Verlet's
    steps."""
    assert error(tmp_path, control, samples=100, after=75, **dict(inner=RADIAL) | case) < bound


def test_transient_with_tilts_and_everything_free(tmp_path):
    """Three translations and two tilts are free, and a load is applied in 3 ms. The error relative
    to velocity Verlet with a step of 12.5 ns decreases with the implicit step."""
    case = dict(
        inner=(
            "x free y free z free rx free ry free spin speed 50 force 0 -2000 1000 moment 3 0 0"
            " ramp 3.0e-3"
        ),
        samples=50,
        verlet_step=1.25e-8,
    )
    errors = [
        error(tmp_path, control=f"tolerance 1e-6 largest {h}", **case) for h in (4e-6, 2e-6, 1e-6)
    ]
    assert errors[2] < 2e-3
    for coarse, fine in zip(errors, errors[1:]):
        assert coarse / fine > 1.7


@pytest.mark.parametrize("order", [1, 2])
def test_order(tmp_path, order):
    """A load of 3 kN is applied suddenly at 1000 rad/s, where the film is thick and its damper
    soft. The error relative to a run with an eighth of the smallest step decreases at the order of
    the method."""
    case = dict(
        start=1000,
        inner="x free y free spin speed 1000 force 0 -3000 0 ramp 3.0e-4",
        clearance=-20e-6,
        samples=40,
        sample=4e-5,
    )

    def found(order, step):
        succeed(CASE, out=tmp_path, control=f"order {order} tolerance 1e-6 largest {step}", **case)
        return loads(tmp_path)

    truth = found(2, 1e-6 / 8)
    errors = [np.abs(found(order, h) - truth).max() / truth.max() for h in (4e-6, 2e-6, 1e-6)]
    print(errors)
    for coarse, fine in zip(errors, errors[1:]):
        assert 0.75 * 2**order < coarse / fine < 1.35 * 2**order


@pytest.mark.parametrize("rpm", [47.75, 477.5, 9549])
def test_deck_against_statics(tmp_path, rpm):
    """In in.6208 with the implicit integrator, the ball loads at every azimuth, including
    centrifugal load, agree with statics within 0.2 % of the largest load. At 9549 rpm the balls
    vibrate on the contact springs, and a difference of 2 % is allowed."""
    succeed("inputs/in.6208", out=tmp_path, integrator="implicit", passes=1, rpm=rpm)
    bound = 2e-3 if rpm < 1000 else 2e-2
    tables = raceway.open(tmp_path).tables
    for found, theory in closed_forms.ball_loads(tables, range(0, 201, 10)):
        np.testing.assert_allclose(found, theory, rtol=0, atol=bound * theory.max())


def test_cold_step_refines_by_itself(tmp_path):
    """If 5 kN is applied at once to a bearing with clearance, substeps become much shorter than the
    sample interval of 0.1 ms and then longer again. The motion after the impact agrees with
    velocity Verlet."""
    case = dict(inner="x free y free spin speed 50 force 0 -5000 0", clearance=44.1e-6, samples=100)
    assert error(tmp_path, after=75, verlet_step=2.5e-8, **case) < 2e-3
    text = succeed(CASE, out=tmp_path / "again", **case).text
    mean, smallest = map(float, re.search(r"CONTROL mean (\S+) smallest (\S+)", text).groups())
    assert smallest < 1e-6 and mean > 10 * smallest


def test_a_step_far_too_large_is_refined_not_wrong(tmp_path):
    """The samples are 2 ms apart, so there are 18 per ball pass."""
    assert error(tmp_path, inner=RADIAL, sample=2e-3, samples=20, after=3) < 1e-3


@pytest.mark.parametrize(
    "control, message",
    [
        ("tolerance -1", "tolerance (m) is -1"),
        ("cage_tolerance 1e-10", "of cage balls (m) is 1e-10, below the tolerance of 1e-09"),
        ("error 0.5", "error is 0.5, must be from 1 to 100"),
        ("solve damping error 2", "error is 2, must be 1 with 'solve damping'"),
        ("order 3", "order is 3, must be a whole number from 1 to 2"),
        ("corrections 0", "corrections in a stage is 0"),
        ("energy maybe", "energy"),
        ("speed 3", "'speed'"),
        ("control guess", "control"),
        ("order 1 control estimate", "control is estimate, must be bound"),
        ("solve damping control estimate", "control is estimate, must be bound"),
    ],
)
def test_mistakes_are_named(tmp_path, control, message):
    refuses(CASE, message, out=tmp_path, control=control)


def test_two_implicit_steps_of_one_atom_are_refused(tmp_path):
    again = "fix again moving bearing/implicit\nneigh_modify"
    text = (ROOT / CASE).read_text().replace("neigh_modify", again, 1)
    refuses(deck_file(tmp_path, text), "both move atom", out=tmp_path / "out")


def test_a_step_that_turns_a_ball_too_far_is_refined(tmp_path):
    """Each host step is 40 ms, during which the balls orbit by 0.8 rad; with preload, nothing else
    shortens the steps. The frames rotate according to series that are accurate up to 0.6 rad, so
    the error control must limit the step. Every ball stays on the pitch circle.
    """
    case = dict(
        inner=ring("spin speed 50 force 0 -50 0"), clearance=-88.2e-6, samples=10, sample=4e-2
    )
    text = succeed(CASE, out=tmp_path, control="tolerance 1e-5", **case).text
    mean = float(re.search(r"CONTROL mean (\S+)", text).group(1))
    orbit = 0.5 * 50 * (1 - 6.3 / 30.3)
    assert (1 - 0.5**0.5) * mean * orbit * (1 + 2**0.5) < 0.6
    for rows in frames(tmp_path / "balls.dump").values():
        places = np.array([row.split()[2:4] for row in rows[:9]], float)
        np.testing.assert_allclose(np.hypot(*places.T), 30.3e-3, rtol=0, atol=1e-4)


@pytest.mark.parametrize("speed, bound", [(50, 1e-4), (1000, 1e-3)])
def test_only_dampers_implicit_against_verlet(tmp_path, speed, bound):
    """`solve damping` agrees with velocity Verlet at its stability limit. At 50 rad/s nothing
    vibrates. At 1000 rad/s the balls vibrate when they are loaded, with an amplitude of 1e-3 of the
    largest load, and the period of this vibration has an error of (h omega)^2/24, up to a tenth."""
    case = dict(
        start=speed,
        inner=ring(f"spin speed {speed} force 0 -5000 0"),
        clearance=44.1e-6,
        samples=100,
    )
    assert error(tmp_path, control="solve damping", after=75, **case) < bound


def test_only_dampers_implicit_keeps_its_step_stable(tmp_path):
    """Host steps of fifty times the stability limit of the springs are divided into steps at the
    limit, h^2 k = 3 m + 1.5 h c, for the heaviest ball: k is the stiffness of its two contacts
    (4.2e8 N/m under 5 kN), and the contribution of c is small at this speed. During the load ramp,
    drift makes the steps shorter.
    """
    case = dict(inner=ring("spin speed 1000 force 0 -5000 0"), start=1000, sample=4e-4, samples=40)
    text = succeed(CASE, out=tmp_path, control="solve damping", **case).text
    ball_mass = 7800 * 4 / 3 * np.pi * 6.3e-3**3
    limit = (3 * ball_mass / 4.2e8) ** 0.5
    assert 0.8 * limit < float(re.search(r"CONTROL mean (\S+)", text).group(1)) < 1.3 * limit
    # with the ring at rest the largest load is 2436 N if a ball is on the load line, and less if
    # two balls share the load; the centrifugal load of a ball is 38 N
    assert 2200 < loads(tmp_path)[-20:].max() < 2600


def test_only_dampers_implicit_keeps_a_swing(tmp_path):
    """A dry ring under a suddenly applied 5 kN oscillates on its balls, slowly damped by the
    contacts. In the last 3 of 15 ms the oscillation agrees with another method, order 2 with steps
    of 0.25 us. The period of the balls has an error of (h omega)^2/24; the period of the ring has
    none.
    """
    case = dict(
        lubricant="dry",
        inner="x free y free spin speed 50 force 0 -5000 0",
        sample=5e-5,
        samples=300,
    )
    swing = []
    for control in ("tolerance 1e-6 largest 2.5e-7", "solve damping"):
        succeed(CASE, out=tmp_path, control=control, **case)
        swing.append(np.ptp(loads(tmp_path)[-60:, 0].max(1)))
    assert swing[0] > 20 and swing[1] == pytest.approx(swing[0], rel=0.05)


def results(out, **words):
    """Run the main deck with the models `full`, and return the results."""
    succeed("inputs/in.6208", out=out, models="full", **words)
    return raceway.open(out).summary()


FIGURES = ("q_max_N", "h_c_m", "cage_speed_rad_s", "friction_torque_N_m", "capacitance_F")


def test_cage_balls_may_be_farther_off(tmp_path):
    """With the models `full`, in which the cage drives the unloaded balls, a tolerance of 1 um
    instead of 1 nm for cage balls makes steps more than twice as long, and the results for the
    bearing change by less than 0.1 %."""
    words = dict(cage="chain", passes=1)
    fine, coarse = (
        results(tmp_path / str(cage), cage_tolerance=cage, **words) for cage in (1e-9, 1e-6)
    )
    assert coarse["step_s"] > 2 * fine["step_s"]
    for name in ("ring_shift_m", "q_max_N", "cage_speed_rad_s", "friction_torque_N_m", "h_c_m"):
        assert coarse[name] == pytest.approx(fine[name], rel=1e-3), name


def test_coarse_cage_balls_leave_unloaded_balls_at_rest(tmp_path):
    """At low speed stages are long. The contact force that remains on a cage ball after the last
    correction must not throw unloaded balls. With bounded errors, a tolerance of 1 um for cage
    balls requires fewer evaluations than 0.1 um, and the differences from the results with 0.1 nm
    are not larger. Without finer corrections in long stages, 1 um would require more evaluations
    than 0.1 um."""
    found = {}
    for cage, more in ((1e-7, {}), (1e-6, {}), (1e-10, dict(tolerance=1e-10))):
        words = dict(cage="chain", settle=1, rpm=47.75, step_control="bound", **more)
        found[cage] = results(tmp_path / str(cage), cage_tolerance=cage, **words)
    assert found[1e-6]["evaluations"] < found[1e-7]["evaluations"]
    for cage in (1e-7, 1e-6):
        for name in FIGURES:
            assert found[cage][name] == pytest.approx(found[1e-10][name], rel=1e-3), (cage, name)


def test_an_error_may_be_larger_than_corrections(tmp_path):
    """A step may have an error 2.5 times as large as the error that the corrections leave. With the
    models `full`, this saves a sixth of the evaluations at high speed and changes the results by
    less than 0.1 %."""
    fine, coarse = (
        results(tmp_path / str(share), rpm=9549, step_error=share) for share in (1, 2.5)
    )
    assert coarse["evaluations"] < 5 / 6 * fine["evaluations"]
    for name in FIGURES:
        assert coarse[name] == pytest.approx(fine[name], rel=1e-3), name


@pytest.mark.parametrize("rpm", [477.5, 9549])
def test_estimated_errors_need_fewer_evaluations(tmp_path, rpm):
    """With estimated errors the models `full` require less than 60 % of the evaluations required
    with bounded errors. The results agree within 0.1 % with those for errors bounded by 0.1 nm."""
    words = dict(cage="chain", settle=1, rpm=rpm)
    ours, bounds = (
        results(tmp_path / one, step_control=one, **words) for one in ("estimate", "bound")
    )
    fine = dict(tolerance=1e-10, cage_tolerance=1e-10, step_control="bound")
    truth = results(tmp_path / "fine", **fine, **words)
    assert ours["evaluations"] < 0.6 * bounds["evaluations"]
    for name in FIGURES:
        assert ours[name] == pytest.approx(truth[name], rel=1e-3), name
