# SPDX-License-Identifier: GPL-2.0-or-later
"""The results of fix bearing/circuit agree with those that the Python package computes from the
record of the same run; events and rejected input are tested too."""

import shutil

import numpy as np
import pandas as pd
import pytest
import raceway
from host import ROOT, columns, deck_file, run
from raceway.electric import circuit
from raceway.electric.breakdown import Breakdown
from raceway.electric.leak import Leak
from raceway.electric.outer import Floating, Motor, Source
from raceway.electric.waveforms import CommonMode, Constant, Sine, Table
from raceway.errors import RunError
from raceway.runs.columns import _TABLES

# these scenes have few steps, and are evaluated both in C++ and in Python
pytestmark = pytest.mark.filterwarnings("ignore:films fail late")
SAMPLES = 120
NAMES = [row["name"] for row in _TABLES["fix_circuit"]]
CASES = {
    "motor": (
        "motor 50e-12 1e-9 second_factor 1.0 voltage sine 300 200 breakdown 30e6 points 4",
        Motor(Sine(300.0, 200.0), 50e-12, 1e-9, second_factor=1.0),
        Breakdown(30e6),
        None,
        4,
    ),
    "inverter": (
        "motor 50e-12 1e-9 second_factor 1.0 voltage common_mode 560 900 50 0.8 breakdown 30e6",
        Motor(CommonMode(560.0, 900.0, 50.0, 0.8), 50e-12, 1e-9, second_factor=1.0),
        Breakdown(30e6),
        None,
        1,
    ),
    "leaking source": (
        "source 3e6 voltage table {table} resistivity 1e9 breakdown 30e6 surfaces smooth beside"
        " 20e-12 stray 1e-12",
        Source(Table([0, 2e-3, 5e-3], [0, 40, -25]), 3e6, 20e-12),
        Breakdown(30e6, "smooth"),
        Leak(1e9),
        1,
    ),
    "stiff source": (
        "source 0 voltage constant 5 resistivity 1e9 points 3",
        Source(Constant(5.0)),
        None,
        Leak(1e9),
        3,
    ),
    "floating": ("floating 4 stray 2e-12", Floating(4.0), None, None, 1),
    "whole capacitance": (
        "motor 50e-12 1e-9 voltage sine 300 200 breakdown 30e6 resistivity 1e9 points 4 arc 0.5",
        Motor(Sine(300.0, 200.0), 50e-12, 1e-9),
        Breakdown(30e6, arc=0.5),
        Leak(1e9),
        4,
    ),
    "instants": (
        "motor 50e-12 1e-9 voltage sine 300 200 breakdown 30e6 arc 2 points 2 within 4",
        Motor(Sine(300.0, 200.0), 50e-12, 1e-9),
        Breakdown(30e6, arc=2.0),
        None,
        2,
    ),
}
WHOLE = dict(cap="surroundings cavitated 1", clearance=2e-5)
WITHIN = 4  # samples per step, in the case with instants within steps


FAST = "x free y free spin speed 150 force 0 -800 0 ramp 3.0e-3"
SLOW = "x free y free spin speed 25 force 0 -800 0 ramp 3.0e-3"
RECORD = "fix rec all bearing/record 1 {}\n"


def run_with(folder, words, more="", samples=SAMPLES, record=RECORD, cap="", **options):
    """Run in.case in `folder` with a record and with a circuit that has the keywords `words`, and
    return the `Outcome`."""
    folder.mkdir(exist_ok=True)
    (folder / "table.txt").write_text("# s V\n0 0\n2e-3 40\n5e-3 -25 # the end\n")
    values = "".join(f"variable v{k} equal f_cir[{k}]\n" for k in range(1, len(NAMES) + 1))
    shown = " ".join(f"${{v{k}}}" for k in range(1, len(NAMES) + 1))
    fixes = folder / "fixes"
    fixes.write_text(
        f"fix cap balls bearing/capacitance 1 permittivity 2.25 {cap}\n"
        f"{record.format(folder / 'rec')}"
        f"fix cir balls bearing/circuit 1 cap {words.format(table=folder / 'table.txt')}\n"
        f"{values}fix say all print 1 '{shown}' file {folder / 'circuit.txt'} screen no\n{more}"
    )
    case = dict(sample=1e-4, samples=samples, inner=FAST) | options
    return run("tests/implicit/in.case", out=folder, more=fixes, **case)


@pytest.fixture(scope="module", params=CASES)
def pair(request, tmp_path_factory):
    """Return (rows of the fix by name, rows of its events, the `Result` computed in Python) for one
    run."""
    words, outer, breakdown, leak, points = CASES[request.param]
    folder = tmp_path_factory.mktemp("circuit")
    if breakdown:
        words += f" events {folder / 'events.txt'}"
    whole, instants = (request.param == name for name in ("whole capacitance", "instants"))
    more = WHOLE if whole or instants else {}
    if instants:
        record = RECORD.rstrip() + f" within {WITHIN}\n"
        more = more | dict(record=record, sample=WITHIN * 1e-4, samples=SAMPLES // WITHIN)
    end = run_with(folder, words, **more)
    assert end.code == 0, end.text[-3000:]
    rows = dict(zip(NAMES, np.loadtxt(folder / "circuit.txt").T))
    events = pd.DataFrame()
    if breakdown:
        events = pd.DataFrame(columns(folder / "events.txt"))
    stray = {"leaking source": 1e-12, "floating": 2e-12}.get(request.param, 0.0)
    found = circuit.run(
        raceway.open(folder / "rec"), outer, breakdown, leak, points=points, stray=stray
    )
    assert bool((found.data.film_capacitance > 0).all()) == (whole or instants) or stray
    return rows, events, found, points * (WITHIN if instants else 1)


def test_the_fix_gives_the_numbers_of_python(pair):
    """The values agree at every sample except the first, which LIGGGHTS does not print."""
    rows, _, (data, events), points = pair
    on_films = float(np.abs(data.film_capacitance * data.film_voltage).max())
    step = float(data.time.diff("time").min())
    data = data.isel(time=slice(points, None, points))
    for name in NAMES:
        if name.endswith("_error"):
            continue
        if name == "discharges":
            ours = np.searchsorted(events.groupby("discharge").time.first(), data.time, "right")
        elif name == "failures":
            ours = np.searchsorted(events.time, data.time, "right")
        else:
            ours = data[name].to_numpy() if name in data else np.zeros(data.sizes["time"])
            ours = np.where(np.isinf(ours), 0.0, ours)  # values are infinite if no film can fail
        scale = 1e-9 * np.abs(ours).max()
        if name == "current":  # the films' charges cancel, the ring's does not
            scale = max(scale, 1e-13 * on_films / step)
        np.testing.assert_allclose(rows[name], ours, rtol=1e-9, atol=scale, err_msg=name)


def test_metal(tmp_path):
    """Films with asperity contact conduct, both in the fix and in Python. A limit of 0.1 on the
    load fraction of asperities distinguishes them from the other films."""
    here = tmp_path / "here"
    shutil.copytree(ROOT / "tests/implicit", here, ignore=shutil.ignore_patterns("__pycache__"))
    contact = here / "contact.film"
    stribeck = "friction stribeck 0.12 0.05 smoothed ${creep}"
    assert contact.read_text().count(stribeck) == 1
    mixed = (
        "friction mixed 0.12 0.05 heathcote 1.0e-4 rolling 0.047 0.134 1.0 rolling_hysteresis 0.01"
        " spin 1.0 drag 870 0.1"
    )
    contact.write_text(contact.read_text().replace(stribeck, mixed))
    words = "source 1e7 voltage constant 5 metal 10 0.1 points 2"
    every = RECORD.rstrip() + " contacts all\n"
    end = run_with(tmp_path / "run", words, record=every, here=here, inner=SLOW)
    assert end.code == 0, end.text[-3000:]
    rows = dict(zip(NAMES, np.loadtxt(tmp_path / "run" / "circuit.txt").T))
    outer, leak = Source(Constant(5.0), 1e7), Leak(metal=10.0, share=0.1)
    data = circuit.run(raceway.open(tmp_path / "run" / "rec"), outer, leak=leak, points=2).data
    states = set(np.unique(data.film_state))
    assert states == {0, 2}
    data = data.isel(time=slice(2, None, 2))
    for name in ("bearing_voltage", "leak_heat", "resistor_heat", "stored_energy"):
        scale = float(np.abs(data[name]).max())
        np.testing.assert_allclose(rows[name], data[name], rtol=1e-9, atol=1e-9 * scale)


def test_balances(pair):
    rows, _, (data, _), _ = pair
    on_films = float(np.abs(data.film_capacitance * data.film_voltage).max())
    assert rows["charge_error"].max() < 1e-12 * max(on_films, 300 * 50e-12)
    assert rows["energy_error"].max() < 1e-12 * rows["stored_energy"].max()


def test_the_events_are_those_of_python(pair):
    _, rows, (_, events), _ = pair
    assert len(rows) == len(events)
    if not len(rows):
        return
    events = events.assign(raceway=(events.raceway == "outer").astype(int))
    assert ("current_density" in rows) == bool(events.current.notna().all())
    for name, found in rows.items():
        ours = events[name].to_numpy(dtype=float)
        scale = np.abs(ours).max()
        np.testing.assert_allclose(found, ours, rtol=1e-9, atol=1e-9 * scale, err_msg=name)


def test_current_of_a_failure(pair):
    """The peak current is limited by the arc, the duration follows from the charge, and the current
    density refers to the total Hertz area."""
    _, rows, (_, events), _ = pair
    if "current" not in rows:
        return
    charge = rows["current"] * rows["duration"]
    np.testing.assert_allclose(charge * np.abs(rows["film_voltage"]), 2 * rows["energy"], rtol=1e-9)
    area = rows["current"] / rows["current_density"]
    assert 1e-8 < area.min() < area.max() < 1e-5


def test_the_cases_have_discharges(pair):
    _, rows, (data, events), _ = pair
    assert len(events) > 20 or "threshold_voltage" not in data


@pytest.mark.parametrize(
    "words, message",
    [
        ("motor 0 1e-9 voltage constant 1", "capacitance of winding to rotor (F)"),
        ("motor 1e-12 1e-9", "'voltage' is missing"),
        ("floating 1 voltage constant 1", "a floating inner ring takes no 'voltage'"),
        ("floating 1 second 1e-12", "'second' and 'second_factor' need a motor"),
        ("source 0 voltage constant 1 breakdown 1e6", "give it a resistance"),
        ("source 1 voltage square 1", "constant, sine, common_mode, table"),
        ("source 1 voltage table {table} points 0", "circuit points per sample"),
        ("source 1 voltage table nowhere.txt", "cannot read 'nowhere.txt'"),
        ("floating 1 events x", "'events' needs 'breakdown'"),
        ("floating 1 breakdown 1e6 arc 1", "'arc' needs 'events'"),
        ("floating 1 within 0", "samples per step is 0"),
        ("floating 1 metal 5", "share of the load on asperities above which a film is metallic"),
        ("floating 1 metal 5 0.1", "'metal' needs 'friction mixed', which computes the load share"),
        ("floating 1 loud yes", "voltage, second, second_factor, beside, stray, breakdown"),
        ("source 1 voltage common_mode 9 80 50 1", "a carrier of 80 Hz must have at least twice"),
        (
            "source 1 voltage sine 1 5000",
            "a sample takes 0.0001 s, a period of the voltage 0.0002 s: 'points' must be at least"
            " 4, not 1",
        ),
    ],
)
def test_bad_words(tmp_path, words, message):
    end = run_with(tmp_path / "run", words, samples=2)
    assert "fix cir bearing/circuit" in end.error and message in end.error, end.error


@pytest.mark.parametrize(
    "text, message",
    [
        ("0 1\n1 2 3\n", "line 2: a row of a voltage table must contain two numbers, s and V"),
        ("0 1\n\n0 2\n", "line 3: times of a voltage table must increase"),
        ("0 1\nx\n", "line 2: a row of a voltage table must contain two numbers"),
        ("0 1\n", "needs at least two rows of s and V"),
    ],
)
def test_bad_table(tmp_path, text, message):
    path = tmp_path / "bad.txt"
    path.write_text(text)
    end = run_with(tmp_path / "run", f"source 1 voltage table {path}", samples=2)
    assert message in end.error


def test_which_capacitance_and_which_balls(tmp_path):
    end = run_with(tmp_path / "a", "floating 1", "fix two balls bearing/circuit 1 rec floating 1\n")
    assert "fix two bearing/circuit: there is no fix bearing/capacitance 'rec'" in end.error
    none = "fix two inner bearing/circuit 1 cap floating 1\n"
    end = run_with(tmp_path / "b", "floating 1", none, samples=2)
    assert "fix two bearing/circuit: group inner has no balls" in end.error
    few = "group few id 1 2\nfix less few bearing/capacitance 1 permittivity 2\n"
    few += "fix two balls bearing/circuit 1 less floating 1\n"
    end = run_with(tmp_path / "c", "floating 1", few, samples=2)
    assert "fix two bearing/circuit: ball 3 is not in the group of fix less" in end.error
    part = "group few id 1 2\nfix two few bearing/circuit 1 cap floating 1\n"
    end = run_with(tmp_path / "d", "floating 1", part, samples=2)
    assert "fix two bearing/circuit: group few has only some of the balls of ring" in end.error


def test_instants_need_every_step_and_who_knows_them(tmp_path):
    more = "fix two balls bearing/circuit 2 cap floating 1 within 3\n"
    end = run_with(tmp_path / "a", "floating 1", more, samples=2)
    assert "'within' takes samples evenly within every step: N must be 1, not 2" in end.error
    end = run_with(tmp_path / "b", "floating 1 within 3", integrator="verlet", samples=1)
    assert "'within 3' needs fix bearing/implicit" in end.error, end.error


def test_the_time_step_must_stay(tmp_path):
    more = "run 3\ntimestep 5e-5\n"
    end = run_with(tmp_path / "run", "floating 1", more, samples=2, record="")
    says = "the step must not go back, nor the time step change: step 3 with 0.0001 s, then step 4"
    assert f"fix cir bearing/circuit: {says} with 5e-05 s" in end.error, end.error


def test_a_group_of_two_bearings(tmp_path):
    text = (ROOT / "tests/implicit/in.ranks").read_text()
    before = "variable n equal step"
    assert text.count(before) == 1
    deck = deck_file(tmp_path, text.replace(before, RECORD.format(tmp_path / "rec") + before))
    end = run(deck, out=tmp_path, bearings=2, xhi=0.18)
    assert end.code == 0, end.text[-2000:]
    two = raceway.open(tmp_path / "rec")
    with pytest.raises(RunError, match="has 2 bearings: select one with --bearing NUMBER"):
        circuit.run(two, Floating(3.0))
    for number in two.bearing_numbers:
        one = two.select(number)
        data = circuit.run(one, Floating(3.0, 1e-12)).data
        assert data.sizes["ball"] == 9
        np.testing.assert_allclose(
            data.bearing_capacitance, one.bearing.capacitance_total, rtol=1e-12
        )
    deck.write_text(
        text.replace(before, "fix cir balls bearing/circuit 1 cap floating 1\n" + before)
    )
    end = run(deck, out=tmp_path, bearings=2, xhi=0.18)
    assert "fix cir bearing/circuit: group balls has balls on ring atoms" in end.error, end.error
    assert "give each bearing a group and a fix" in end.error
