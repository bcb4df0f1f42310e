# SPDX-License-Identifier: GPL-2.0-or-later
"""Double-row and four-point contact bearings are compared with single-row bearings that have one
groove per ring."""

from dataclasses import replace

import numpy as np
import pytest
from bearings import B6208
from host import ROOT
from raceway import ball_motion, static
from raceway.errors import NoEquilibrium
from raceway.theory import steady_heat
from raceway.theory.bearing import INNER, OUTER, DoubleRow, Layout
from raceway.theory.contact_law import FilmInGap

ANGLE = np.radians(35)
FOUR = B6208.four_point(ANGLE)
ANGULAR = replace(FOUR, layout=Layout())  # its free contact angle is `ANGLE`
STRAIGHT = dict.fromkeys(("x", "y", "rx", "ry"), 0.0)


# ---- double row
@pytest.mark.parametrize("finite_shift", [False, True])
@pytest.mark.parametrize("arrangement, way", [("back_to_back", 1.0), ("face_to_face", -1.0)])
def test_double_row_is_two_rows(arrangement, way, finite_shift):
    """Each row has its own position on the ring, and the forces, moments and stiffnesses of both
    rows add up."""
    spacing, preload = 0.02, 4e-6
    two = ANGULAR.double_row(DoubleRow(spacing, preload, arrangement), ANGLE)
    place = np.array([6e-6, -3e-6, 2e-6, 1e-4, 2e-4])
    options = {"finite_shift": finite_shift}
    found = static.equilibrium(two, held=dict(zip(static.FREEDOMS, place)), **options)
    reach = (ANGULAR.groove_gap(INNER) + ANGULAR.groove_gap(OUTER)) * np.sin(ANGLE) + preload
    force, stiffness = np.zeros(5), np.zeros((5, 5))
    for side in (1.0, -1.0):
        at = -way * side * spacing / 2
        # a load acts in the plane of a row's groove centres, which deviates slightly from the plane
        # of its balls
        turn = np.eye(5)
        turn[0, 4], turn[1, 3] = at + side * reach, -(at + side * reach)
        own = turn @ place + [0, 0, side * reach, 0, 0]
        one = static.equilibrium(ANGULAR, held=dict(zip(static.FREEDOMS, own)), **options)
        force += turn.T @ [*one.force, *one.moment[:2]]
        stiffness += turn.T @ one.stiffness @ turn
    # with finite shifts, `turn` describes the two planes only approximately
    within = 1e-3 if finite_shift else 1e-7
    got = np.array([*found.force, *found.moment[:2]])
    assert got == pytest.approx(force, rel=within, abs=1e-6 + within * np.abs(force).max())
    if not finite_shift:
        assert found.stiffness == pytest.approx(stiffness, rel=1e-6, abs=1.0)
    assert np.abs(got).min() > 0.01


def test_preload_needs_no_load():
    rest = static.equilibrium(ANGULAR.double_row(DoubleRow(0.02, 5e-6), ANGLE))
    assert rest.shift == pytest.approx(np.zeros(3), abs=1e-12) and (rest.inner.load > 0).all()
    with pytest.raises(NoEquilibrium, match="without a load"):
        static.equilibrium(ANGULAR.double_row(DoubleRow(0.02, -5e-6), ANGLE))


# ---- four points


def share(found, groove):
    """Return the fraction of the inner contact loads that `groove` carries."""
    load = found.inner.load
    return load[groove].sum() / load.sum()


def test_reversal_switches_grooves_without_a_jump():
    """While the thrust on a preloaded bearing is reversed in steps, the position and the loads
    change according to the stiffness at every step."""
    thrust = np.linspace(-800.0, 800.0, 65)
    options = {"clearance": -4e-6, "held": STRAIGHT}
    rests = [static.equilibrium(FOUR, axial_load=one, **options) for one in thrust]
    z = np.array([one.shift[2] for one in rests])
    assert z == pytest.approx(-z[::-1], abs=1e-12)
    soft = 1 / np.array([one.stiffness[2, 2] for one in rests])
    step = thrust[1] - thrust[0]
    assert np.diff(z) == pytest.approx(step * (soft[1:] + soft[:-1]) / 2, rel=0.02)
    first = np.array([share(one, 1) for one in rests])
    assert first[32] == pytest.approx(0.5, abs=1e-9)
    assert first[0] == 0.0 and first[-1] == 1.0
    assert np.all(np.diff(first) >= -1e-12) and np.abs(np.diff(first)).max() < 0.08


def test_balls_switch_one_by_one_under_radial_load():
    """The loaded balls leave their second grooves at different values of the thrust. If the thrust
    is increased in steps half as large, the largest change of a load halves, so there are no
    jumps."""
    thrusts = np.linspace(-2400, 2400, 25)
    rests = [static.equilibrium(FOUR, 2000.0, one) for one in thrusts]
    loads = np.array([one.inner.load for one in rests])
    four = (loads > 0).all(1).sum(1)
    assert four[12] == 5 and {0, 2, 3} & set(four)
    assert loads[0][0] == pytest.approx(loads[-1][1], rel=1e-6)
    whole, half = (np.abs(np.diff(one, axis=0)).max() for one in (loads[::2], loads))
    assert 0.4 < half / whole < 0.65


def test_mistakes():
    with pytest.raises(ValueError, match="angle 2 rad must lie between 0 and pi/2"):
        B6208.four_point(2.0)
    with pytest.raises(ValueError, match="four points need a bearing with one row and one groove"):
        FOUR.four_point(ANGLE)
    with pytest.raises(ValueError, match="'tandem' is not one of back_to_back, face_to_face"):
        ANGULAR.double_row(DoubleRow(0.02, 0.0, "tandem"))
    with pytest.raises(ValueError, match="spacing 0.01 m of the rows must be at least"):
        ANGULAR.double_row(DoubleRow(0.01))
    with pytest.raises(ValueError, match="two rows need a bearing with one row"):
        FOUR.double_row(DoubleRow(0.02)).double_row(DoubleRow(0.02))
    with pytest.raises(NoEquilibrium, match="without a load"):
        static.equilibrium(FOUR, clearance=1e-5)


@pytest.mark.parametrize(
    ("load", "axial", "rpm", "clearance", "preload", "temperature"),
    [
        (1985.0, 100.0, 5725.0, 28.8e-6, None, 71.6),  # light balls gain and lose the inner ring
        (2268.0, 1588.0, 6253.0, 0.0, 0.0, 41.74),
        (4402.0, 1701.0, 8625.0, 0.0, 16.79e-6, 59.35),
    ],
)
def test_motion_and_films_settle(load, axial, rpm, clearance, preload, temperature):
    """The films in the gaps are those of the motion of the balls, on which the loads depend in
    turn. The result does not depend on where the search starts."""
    rows = None if preload is None else DoubleRow(22e-3, preload)
    words = dict(load=load, axial=axial, rpm=rpm, clearance=clearance, double_row=rows)
    case = steady_heat.Case("QJ210", "vg46", ROOT / "inputs", **words)

    def found(*temperatures):
        scene = case.scene()
        return [scene.rest(one, clearance) for one in temperatures][-1]

    far, near = found(temperature), found(temperature + 1, temperature)
    assert near.losses().power == pytest.approx(far.losses().power, rel=1e-6)
    film = FilmInGap(far.fluid, far.ring)
    speeds, _ = ball_motion.speeds(far.bearing, far.ring, far.state)
    again = static.equilibrium(
        far.bearing,
        load,
        axial,
        held=case.scene().held,
        clearance=clearance,
        orbital_speed=far.orbit,
        ball_density=far.density,
        film=replace(film, entrainment=speeds),
    )
    for side, other in ((far.state.inner, again.inner), (far.state.outer, again.outer)):
        assert other.load == pytest.approx(side.load, rel=1e-4, abs=1e-6 * load)
