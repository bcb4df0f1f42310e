# SPDX-License-Identifier: GPL-2.0-or-later
"""Double row and four-point contact bearings against the statics of one row with one groove."""

import numpy as np
import pytest
from raceway import many_grooves, static
from raceway.errors import NoEquilibrium
from raceway.theory.bearing import INNER, OUTER, Bearing

B6208 = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
ANGLE = np.radians(35)
STRAIGHT = dict.fromkeys(("x", "y", "rx", "ry"), 0.0)


@pytest.mark.parametrize("moment", [None, (10.0, -4.0)])
@pytest.mark.parametrize("clearance, orbit", [(0.0, 0.0), (10e-6, 200.0), (-5e-6, 200.0)])
def test_one_row_is_the_statics(moment, clearance, orbit):
    rows = [many_grooves.Row(B6208, clearance=clearance)]
    found = many_grooves.equilibrium(rows, (2000.0, 0.0, 1000.0), moment, orbital_speed=orbit)
    want = static.equilibrium(
        B6208, 2000.0, 1000.0, moment=moment, clearance=clearance, orbital_speed=orbit
    )
    for mine, theirs in zip(found.rows[0], (want.inner, want.outer)):
        assert mine.load[0] == pytest.approx(theirs.load, rel=1e-8)
        assert mine.angle[0] == pytest.approx(theirs.angle, abs=1e-8)
    assert found.place[:3] == pytest.approx(want.shift, rel=1e-7, abs=1e-14)
    assert found.stiffness == pytest.approx(want.stiffness, rel=1e-7, abs=1e-3)
    assert found.force[:3] == pytest.approx([-2000.0, 0.0, -1000.0], abs=1e-6)


# ---- double row
def angular(angle=ANGLE):
    """A bearing whose free contact angle is `angle`."""
    row = many_grooves.four_point(B6208, angle)[0]
    return row.bearing


@pytest.mark.parametrize("arrangement, way", [("back_to_back", 1.0), ("face_to_face", -1.0)])
def test_double_row_is_two_rows(arrangement, way):
    """Each row has its own place on the ring; forces and moments add up, and so does stiffness."""
    body, spacing, preload = angular(), 0.02, 4e-6
    rows = many_grooves.double_row(body, spacing, ANGLE, preload, arrangement)
    place = np.array([6e-6, -3e-6, 2e-6, 1e-4, 2e-4])
    found = many_grooves.equilibrium(rows, held=dict(zip(static.FREEDOMS, place)))
    reach = (body.groove_gap(INNER) + body.groove_gap(OUTER)) * np.sin(ANGLE) + preload
    force, stiffness = np.zeros(5), np.zeros((5, 5))
    for side in (1.0, -1.0):
        at = -way * side * spacing / 2
        # loads of circles of groove centres, which sit a little beside the balls' plane
        turn = np.eye(5)
        turn[0, 4], turn[1, 3] = at + side * reach, -(at + side * reach)
        own = turn @ place + [0, 0, side * reach, 0, 0]
        one = static.equilibrium(body, held=dict(zip(static.FREEDOMS, own)))
        force += turn.T @ [*one.force, *one.moment[:2]]
        stiffness += turn.T @ one.stiffness @ turn
    assert found.force == pytest.approx(force, rel=1e-7, abs=1e-6)
    assert found.stiffness == pytest.approx(stiffness, rel=1e-6, abs=1.0)
    assert np.abs(found.force).min() > 0.01


def test_back_to_back_holds_tilts_better():
    rows = {
        name: many_grooves.double_row(angular(), 0.02, ANGLE, 5e-6, name)
        for name in many_grooves.ARRANGEMENTS
    }
    stiff = {
        name: many_grooves.equilibrium(two, (0.0, 0.0, 1e-3)).stiffness[4, 4]
        for name, two in rows.items()
    }
    assert stiff["back_to_back"] > 3 * stiff["face_to_face"]
    with pytest.raises(ValueError, match="'tandem' is none of back_to_back, face_to_face"):
        many_grooves.double_row(angular(), 0.02, ANGLE, 0.0, "tandem")


# ---- four points
def test_two_points_are_an_angular_contact():
    """A thrust presses on one groove of each ring: that of a bearing with one groove a ring."""
    found = many_grooves.equilibrium(many_grooves.four_point(B6208, ANGLE), (0.0, 0.0, 3000.0))
    body = angular()
    one = static.equilibrium(body, axial_load=3000.0, held=STRAIGHT)
    start = (body.groove_gap(INNER) + body.groove_gap(OUTER)) * np.sin(ANGLE)
    assert found.place[2] == pytest.approx(one.shift[2] - start, rel=1e-6)
    (row,) = found.rows
    assert np.all(row.inner.load[0] == 0) and np.all(row.outer.load[1] == 0)
    assert row.inner.load[1] == pytest.approx(one.inner.load, rel=1e-8)
    assert row.outer.angle[0] == pytest.approx(one.outer.angle, abs=1e-8)
    assert one.inner.angle[0] > ANGLE


def share(found, groove):
    """Of the inner contact loads, what `groove` carries."""
    load = found.rows[0].inner.load
    return load[groove].sum() / load.sum()


def test_reversal_switches_grooves_without_a_jump():
    """Under preload, from one side to the other: place and loads follow the stiffness all along."""
    rows = many_grooves.four_point(B6208, ANGLE, clearance=-4e-6)
    thrust = np.linspace(-800.0, 800.0, 65)
    rests = [many_grooves.equilibrium(rows, (0.0, 0.0, one), held=STRAIGHT) for one in thrust]
    z = np.array([one.place[2] for one in rests])
    assert z == pytest.approx(-z[::-1], abs=1e-12)
    soft = 1 / np.array([one.stiffness[2, 2] for one in rests])
    step = thrust[1] - thrust[0]
    assert np.diff(z) == pytest.approx(step * (soft[1:] + soft[:-1]) / 2, rel=0.02)
    first = np.array([share(one, 1) for one in rests])
    assert first[32] == pytest.approx(0.5, abs=1e-9)
    assert first[0] == 0.0 and first[-1] == 1.0
    assert np.all(np.diff(first) >= -1e-12) and np.abs(np.diff(first)).max() < 0.08


def test_balls_switch_one_by_one_under_radial_load():
    """Loaded balls leave their second grooves at different thrusts. Half the step in the thrust is
    half the change of any load: nothing jumps."""
    rows = many_grooves.four_point(B6208, ANGLE)
    thrusts = np.linspace(-2400, 2400, 25)
    rests = [many_grooves.equilibrium(rows, (2000.0, 0.0, one)) for one in thrusts]
    loads = np.array([one.rows[0].inner.load for one in rests])
    four = (loads > 0).all(1).sum(1)
    assert four[12] == 5 and {0, 2, 3} & set(four)
    assert loads[0][0] == pytest.approx(loads[-1][1], rel=1e-6)
    whole, half = (np.abs(np.diff(one, axis=0)).max() for one in (loads[::2], loads))
    assert 0.4 < half / whole < 0.65


def test_mistakes():
    with pytest.raises(ValueError, match="angle 2 rad must lie between 0 and pi/2"):
        many_grooves.four_point(B6208, 2.0)
    with pytest.raises(ValueError, match="no degree of freedom"):
        many_grooves.equilibrium([many_grooves.Row(B6208)], held={"w": 0.0})
    with pytest.raises(NoEquilibrium, match="must be finite"):
        many_grooves.equilibrium([many_grooves.Row(B6208)], (np.nan, 0.0, 0.0))
    with pytest.raises(NoEquilibrium):
        many_grooves.equilibrium([many_grooves.Row(B6208, clearance=1e-5)])
