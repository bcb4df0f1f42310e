# SPDX-License-Identifier: GPL-2.0-or-later
"""The cage speeds of runs agree with statics, and spectral lines reveal the hidden clearances of
runs and the mounting of a motor bearing with published recordings."""

import numpy as np
import pytest
import raceway
from bench import cwru
from host import ROOT, succeed
from raceway import cage_speed, identify, inputs, steady_heat
from raceway.recordings.prediction import Model
from raceway.recordings.readings import Point, Reading, Readings

# values found in recordings of Case Western Reserve University (docs/measured_bearings)
CWRU = {one.name: one for one in cwru.setups()}
TRIED = ("inner 7 mil", "inner 21 mil", "outer 7 mil at 6 o'clock", "outer 7 mil at 3 o'clock")
THRUST = 30.0  # N, the same in all cases


def readings(found, unknown, oil="vg68", models="full", **known):
    known = {"clearance": 0.0, "load": 10.0, "axial": THRUST, "temperature": 40.0} | known
    known = {name: value for name, value in known.items() if name not in unknown}
    shelf = ROOT / "inputs"
    paths = shelf / "bearings/6205", shelf / "lubricants" / oil
    return Readings(*paths, models, known, unknown, found)


def cage(folder, **variables):
    """Return the cage speed of a run divided by the speed of its inner ring."""
    case = {"bearing": "6205", "lubricant": "vg68", "passes": 10, "settle": 20, "record": "summary"}
    succeed("inputs/in.6208", out=folder, **case | variables)
    motion = raceway.open(folder).motion
    return motion.cage / motion.inner


@pytest.mark.parametrize("models, within", [("paper", 2e-5), ("full", 1.5e-4)])
@pytest.mark.parametrize(
    "rpm, load, axial, clearance",
    [(1797, 10, 30, 8e-6), (600, 10, 30, 2e-6), (1797, 100, 300, 6e-6)],
)
def test_speeds_of_cage_and_balls(tmp_path, models, within, rpm, load, axial, clearance):
    """Differential slip alone changes the cage speed by 2e-4 to 1e-3 and the ball speed by 1e-3;
    the direction of the balls' spin axes changes them by 1e-4 to 3e-4. With the models `paper`, the
    spin axes keep their initial directions."""
    case = {"rpm": rpm, "load": load, "axial": axial, "clearance": clearance}
    cage(tmp_path, models=models, **case, record="all")
    motion = raceway.open(tmp_path).motion
    own = {"FTF": motion.cage / motion.inner, "BSF": motion.spin / motion.inner}
    rows = [Reading(name, value, 1e-6, Point(float(rpm))) for name, value in own.items()]
    found = Model(readings(rows, {}, models=models, **case)).predict(
        {"clearance": clearance, "load": load, "axial": axial, "temperature": 40.0}
    )
    known = len(own) if models == "full" else 1
    values = [one.value for one in found][:known]
    assert values == pytest.approx([*own.values()][:known], rel=within)
    assert not any(one.idle for one in found)


def test_hidden_clearance_of_a_run(tmp_path):
    """If the thrust is known, the clearance is found. If neither is known, the result is a curve
    through the true thrust and clearance."""
    clearance, axial = 6e-6, 60.0
    run = cage(tmp_path, models="full", rpm=1797, load=10, axial=axial, clearance=clearance)
    at = [Reading("BPFO", 9 * run, 1e-4, Point(1797.0))]
    found = identify.identify(readings(at, {"clearance": (-5e-6, 20e-6)}, axial=axial))
    one = found.values["clearance"]
    assert one.low < clearance < one.high and one.high - one.low < 4e-6 and one.determined
    unknown = {"clearance": (0.0, 15e-6), "axial": (20.0, 160.0)}
    valley = identify.identify(readings(at, unknown)).valley
    assert len(valley) > 3
    thrusts, clearances = np.transpose([(one["axial"], one["clearance"]) for one in valley])
    assert np.ptp(thrusts) > 40 and (np.diff(clearances) < 1e-12).all()
    assert np.interp(axial, thrusts, clearances) == pytest.approx(clearance, abs=2e-6)


def test_two_states_with_the_same_lines(tmp_path):
    """The four lines of this run can also be explained by a bearing with twice the clearance under
    a twentieth of the thrust. Both states are found, and the intervals contain the state of the
    run. If the lines have errors of 2e-4, the standard deviation of the clearance is 1.8 um."""
    true = {"clearance": 13.4e-6, "axial": 148.0}
    known = {"load": 21.0, "temperature": 82.0}
    cage(tmp_path, models="full", rpm=1797, record="all", **true, **known)
    motion = raceway.open(tmp_path).motion
    own, spin = motion.cage / motion.inner, motion.spin / motion.inner
    lines = {"BPFO": 9 * own, "BPFI": 9 * (1 - own), "BSF": spin, "FTF": own}
    rows = [Reading(name, at, 2e-4 * at, Point(1797.0)) for name, at in lines.items()]
    unknown = {"clearance": (-20e-6, 53e-6), "axial": (0.78, 780.0)}
    found = identify.identify(readings(rows, unknown, **known))
    for name, one in found.values.items():
        assert one.low < true[name] < one.high
    few, many = sorted(found.valley, key=lambda state: state["clearance"])
    assert few["clearance"] == pytest.approx(true["clearance"], abs=2e-6)
    assert many["clearance"] > 20e-6 and many["axial"] < 10
    model = Model(readings(rows, {}))
    for state in found.valley:
        predicted = [one.value for one in model.predict(state)]
        assert predicted == pytest.approx([*lines.values()], rel=3e-4)


@pytest.mark.parametrize("name", TRIED)
def test_a_motor_bearing(tmp_path, name):
    """A single clearance, found from the line at one speed, predicts the lines at the other speeds
    and the line of a run; if a single thrust is assumed, the clearance is within class CN."""
    line, orders = CWRU[name].line, list(CWRU[name].orders.values())
    rows = [Reading(line, at, 2e-4, Point(rpm)) for rpm, at in CWRU[name].orders.items()]
    found = identify.identify(readings(rows[:1], {"clearance": (-5e-6, 20e-6)}))
    clearance = found.values["clearance"].best
    assert 2e-6 < clearance < 11e-6
    predicted = Model(readings(rows, {})).predict(found.state)
    assert [one.value for one in predicted] == pytest.approx(orders, rel=3e-4)
    run = cage(tmp_path, models="full", rpm=1797, load=10, axial=THRUST, clearance=clearance)
    assert 9 * (1 - run if line == "BPFI" else run) == pytest.approx(orders[0], rel=3e-4)


def test_cooling_from_a_temperature():
    """The conductance that is given to `raceway heat` is recovered from the steady temperature that
    this command computes."""
    case = {"load": 1500.0, "rpm": 3000.0, "clearance": 5e-6}
    steady = steady_heat.figures("6205", "vg68", ROOT / "inputs", conductance=0.8, **case)
    at = [Reading("temperature", steady["temperature_C"], 0.5, Point(case["rpm"]))]
    given = readings(at, {"conductance": (0.05, 20.0)}, load=1500.0, axial=0.0, clearance=5e-6)
    del given.known["temperature"]
    one = identify.identify(given).values["conductance"]
    assert one.best == pytest.approx(0.8, rel=1e-3) and one.low < 0.8 < one.high


def test_a_capacitance_parts_clearance_and_thrust():
    """From readings that statics computes, with random errors added, the true clearance and thrust
    are found within the intervals."""
    true = {"clearance": 6e-6, "axial": 120.0, "load": 20.0, "temperature": 40.0}
    unknown = {"clearance": (0.0, 15e-6), "axial": (20.0, 400.0)}
    points = Point(1797.0), Point(3000.0)
    rows = [Reading(name, 1.0, 1.0, at) for at in points for name in ("BPFO", "capacitance")]
    exact = Model(readings(rows, {})).predict(true)
    signs = 1, -1, -1, 1
    found = [
        one._replace(value=own.value * (1 + sign * share), within=own.value * share)
        for one, own, sign, share in zip(rows, exact, signs, (1e-4, 5e-3) * 2)
    ]
    result = identify.identify(readings(found, unknown, load=20.0))
    assert not result.valley and result.chi < 6
    for name, one in result.values.items():
        assert one.determined and one.low < true[name] < one.high


def test_clearance_from_the_mean_capacitance_of_a_run(tmp_path):
    """Under a radial load, the capacitance ripples by 5 % as balls pass the load line; that with a
    ball on the load line differs from the mean by five times the error of the reading."""
    case = {"load": 1000.0, "clearance": 10e-6, "axial": 0.0}
    cage(tmp_path, models="full", rpm=1500, **case)
    mean = raceway.open(tmp_path).summary()["capacitance_F"]
    at = [Reading("capacitance", mean, 5e-3 * mean, Point(1500.0))]
    found = identify.identify(readings(at, {"clearance": (0.0, 30e-6)}, **case))
    one = found.values["clearance"]
    assert one.low < case["clearance"] < one.high


def test_play_of_the_pockets_counts_where_balls_are_idle():
    """The range of slip contains the published values of 0.1 to 0.6 % and the slip of a cage that
    hangs towards the load; if all balls are loaded, there is no slip."""
    body = inputs.bearing(ROOT / "inputs/bearings/6205")
    idle = raceway.static.equilibrium(body, 400.0, clearance=10e-6)
    low, high = cage_speed.lags(body, idle)
    assert -2e-2 < low < -3e-3 and 6e-3 < high < 4e-2
    assert cage_speed.lags(body, raceway.static.equilibrium(body, 0.0, 100.0)) == (0, 0)
