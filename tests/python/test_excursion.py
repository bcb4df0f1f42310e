# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of statics for balls that run ahead of their cage or lag behind it under moments."""

import numpy as np
import pytest
from raceway import catalogue, inputs
from raceway.theory import excursion
from raceway.theory.lubrication import turning
from raceway.theory.operating_point import figures
from scipy.integrate import quad
from scipy.interpolate import CubicSpline

SPEED = 157.0


def equilibrium(bearing, moment=(0.0, 0.0)):
    """Return the bearing and its `Equilibrium` under a thrust of 3 kN and a `moment`."""
    body = inputs.bearing(catalogue.find("bearings", bearing))
    options = dict(moment=moment, held={}, ball_density=7800.0)
    return body, turning(body, SPEED, 0.0, 3000.0, **options)[0]


def test_balls_run_ahead_by_the_integral_of_their_speeds():
    """The excursion follows from the time that a ball takes to orbit the bearing, which is obtained
    by integrating a spline through the reciprocal speeds of the balls."""
    body, state = equilibrium("7208B", (20.0, 0.0))
    found = excursion.excursion(body, state, SPEED)
    gamma = body.ball_radius / body.pitch_radius
    inner, outer = state.inner.angle, state.outer.angle
    tilt = np.tan((inner + outer) / 2)
    there = (np.cos(outer) + tilt * np.sin(outer)) * (1 - gamma * np.cos(inner))
    here = (np.cos(inner) + tilt * np.sin(inner)) * (1 + gamma * np.cos(outer))
    share = there / (there + here)
    assert (state.inner.load > 0).all() and np.ptp(share) > 0.01
    turns = np.append(state.azimuth, state.azimuth[0] + 2 * np.pi)
    time = CubicSpline(turns, np.append(1 / share, 1 / share[0]), bc_type="periodic")
    mean = 2 * np.pi / quad(time, turns[0], turns[-1])[0]
    points = np.linspace(turns[0], turns[-1], 361)
    ahead = [psi - points[0] - mean * quad(time, points[0], psi)[0] for psi in points]
    # this integral neglects the curvature of the grooves, whose effect is 1 %
    assert found.whole == pytest.approx(np.ptp(ahead) * body.pitch_radius, rel=2e-2)
    assert found.ahead > 0 > found.behind


def test_an_axial_load_alone_moves_no_ball():
    body, state = equilibrium("7208B")
    found = excursion.excursion(body, state, SPEED, np.full((2, body.balls), 0.05))
    assert found.whole < 1e-9 and found.force == 0
    assert excursion.warning(found) is None


def test_a_turned_moment_turns_the_excursion():
    one, other = (
        excursion.excursion(*equilibrium("7208B", moment), SPEED, np.full((2, 13), 0.05))
        for moment in ((20 * np.cos(a), 20 * np.sin(a)) for a in (0.0, 4 * np.pi / 13))
    )
    assert one.whole == pytest.approx(other.whole, rel=1e-9)
    assert one.needed == pytest.approx(other.needed, rel=1e-9)
    assert one.force == pytest.approx(other.force, rel=1e-9)


def test_a_shaft_that_turns_backwards_mirrors_the_excursion():
    body = inputs.bearing(catalogue.find("bearings", "7208"))
    options = dict(held={}, ball_density=7800.0)
    one, other = (
        excursion.excursion(
            body, turning(body, SPEED, 200.0, 600.0, moment=(x, 3.5), **options)[0], speed
        )
        for x, speed in ((-2.9, SPEED), (2.9, -SPEED))
    )
    assert one.ahead / -one.behind > 1.05 or one.ahead / -one.behind < 0.95
    assert (one.ahead, one.behind) == pytest.approx((other.ahead, other.behind), rel=1e-6)


def test_balls_that_are_held_back_press_with_their_traction():
    """The force on the cage is at most the Coulomb friction on both raceways, and smaller if the
    pocket play is almost as large as the excursion."""
    body, state = equilibrium("7208B", (20.0, 0.0))
    limit = 0.05 * (state.inner.load + state.outer.load).max() * (1 + 1e-12)  # rounding
    held = [
        excursion.excursion(
            body, state, SPEED, np.full((2, body.balls), 0.05), play=play, centred=True
        )
        for play in (0.0, 1.53e-3, 1.0)
    ]
    assert 0 == held[2].force < held[1].force < held[0].force <= limit
    assert held[0].force > 0.4 * limit


@pytest.mark.parametrize("order", [1, 2, 3])
def test_play_that_the_balls_need(order):
    """A shift of the cage by half the amplitude of a sine wave leaves circles of half its size in
    the pockets. No shift helps against shorter waves."""
    psi = 2 * np.pi * np.arange(720) / 720
    path = 3e-4 * np.cos(order * psi + 0.4) + 1e-4
    needed = 3e-4 if order == 1 else 6e-4
    assert excursion._needed(path) == pytest.approx(needed, rel=1e-4)


def test_a_free_cage_restrains_less():
    """A centred cage needs the whole excursion as play, a free one less but at least half of it."""
    body, state = equilibrium("7208B", (20.0, 0.0))
    free, centred = (excursion.excursion(body, state, SPEED, centred=one) for one in (False, True))
    assert centred.needed == pytest.approx(centred.whole, rel=1e-12)
    assert free.whole == centred.whole and free.whole / 2 <= free.needed < 0.6 * free.whole


def test_statics_warns():
    point = dict(load=3500.0, axial=5000.0, rpm=1500.0, lubricant="mineral")
    found = figures("7208B", moment=(25.0, 15.0), **point)
    assert 2e-3 < found["ball_excursion_m"] < 4e-3
    text = [one for one in found["warnings"] if "behind their cage" in one]
    assert len(text) == 1 and "have a play of 298 µm: some press against them" in text[0]
    assert 50 < found["pocket_force_N"] < 300
    quiet = figures("6208", load=5000.0, rpm=477.5, lubricant="mineral")
    assert quiet["ball_excursion_m"] < 5e-5 and quiet["pocket_force_N"] is None
    assert not any("cage" in one for one in quiet["warnings"])
