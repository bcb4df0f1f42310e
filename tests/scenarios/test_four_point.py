# SPDX-License-Identifier: GPL-2.0-or-later
"""Bearings with four-point contact, i.e. with two grooves per ring, agree with statics.
docs/decks/in.four_point reverses a thrust; the tests apply other loads in a copy of this deck."""

import numpy as np
import pytest
import raceway
from bearings import B6208
from host import ROOT, columns, frames, succeed
from raceway import electric_point, electrical, static, whole_capacitance
from raceway.electric import circuit
from raceway.electric.breakdown import Breakdown
from raceway.electric.leak import Leak
from raceway.electric.outer import Motor
from raceway.electric.waveforms import Sine
from raceway.errors import RunError
from raceway.export import particles
from raceway.runs.columns import _TABLES

DECK = ROOT / "docs/decks/in.four_point"
FOUR = B6208.four_point(np.radians(35))
STRAIGHT = dict.fromkeys(("x", "y", "rx", "ry"), 0.0)
LIMIT = 400.0  # N, largest thrust
SETTLED = 0.012  # s, time at which the initial transient has decayed
VERLET = {
    "fix move all bearing/implicit": "fix move balls nve/sphere",
    "timestep 2.5e-5": "timestep 1.0e-6",
    "run 1600": "run 40000",
    "print 8 ": "print 200 ",
    "local 8 ": "local 200 ",
}
MOVERS = {"implicit": {}, "verlet": VERLET}


def turned(folder, changes):
    """Run the deck in `folder` with these changes to its text."""
    text = DECK.read_text()
    for old, new in changes.items():
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    folder.joinpath("in.deck").write_text(text)
    succeed(folder / "in.deck", out=folder)


@pytest.fixture(scope="module", params=MOVERS)
def path(request, tmp_path_factory):
    """Return (time in s, displacement in m, force of the balls in N, loads in N as an array
    (n, raceway, groove, ball))."""
    folder = tmp_path_factory.mktemp("four_point")
    turned(folder, MOVERS[request.param])
    thrust, place, force = np.loadtxt(folder / "line.dat").T
    samples = list(frames(folder / "contacts.dump").values())[-len(thrust) :]
    loads = np.zeros((len(thrust), 2, 2, 9))
    for load, rows in zip(loads, samples):
        ball, raceway, groove, value = np.array([row.split()[:4] for row in rows], float).T
        load[raceway.astype(int), groove.astype(int), ball.astype(int) - 1] = value
    time = 0.04 * np.arange(1, len(thrust) + 1) / len(thrust)
    return time, place, force, loads


def rests(force):
    options = {"held": STRAIGHT, "clearance": -4e-6}
    return [static.equilibrium(FOUR, axial_load=-one, **options) for one in force]


def test_path_of_statics(path):
    """The displacement as a function of force agrees with statics over the whole cycle."""
    time, place, force, _ = path
    some = np.flatnonzero(time > SETTLED)[::4]
    want = np.array([rest.shift[2] for rest in rests(force[some])])
    assert force[some].min() < -0.9 * LIMIT and force[some].max() > 0.9 * LIMIT
    assert np.abs(place[some] - want).max() < 1e-3 * np.abs(want).max()


def test_grooves_of_statics(path):
    """The loads in each groove agree with statics."""
    time, _, force, loads = path
    some = np.flatnonzero(time > SETTLED)[::16]
    for rest, load in zip(rests(force[some]), loads[some]):
        for side, want in enumerate((rest.inner.load, rest.outer.load)):
            assert np.abs(load[side] - want).max() < 1e-3 * loads.max()


def test_balls_change_grooves_without_a_jump(path):
    """At +400 N one pair of grooves is unloaded, and at -400 N the other pair. In between, each
    load changes only little from sample to sample, and no more than usual when a contact opens or
    closes."""
    time, _, force, loads = path
    late = time > SETTLED
    loads, force = loads[late], force[late]
    mean = loads.mean(axis=-1)  # mean over the balls, which are equivalent
    ends = [np.argmin(force), np.argmax(force)]
    for end, free in zip(ends, (0, 1)):  # the inner ring is pushed towards +z, then towards -z
        assert (mean[end, 0, free], mean[end, 1, 1 - free]) == (0.0, 0.0)
        assert mean[end, 0, 1 - free] > 70 and mean[end, 1, free] > 70
    between = np.abs(force) < 0.5 * LIMIT
    assert (loads[between] > 0).all()
    change = np.abs(np.diff(mean, axis=0)).max(axis=(1, 2))
    fastest = 2 * np.pi / 0.04 * LIMIT * np.diff(time[late])[0]  # N per sample
    # ratio of a contact load to the thrust, and preload
    stiffest = 0.5 / 9 / np.sin(np.radians(33))
    assert change.max() < 2.2 * stiffest * fastest
    opening = (mean[1:] == 0) != (mean[:-1] == 0)
    assert opening.any()
    assert np.abs(np.diff(mean, axis=0))[opening].max() < change.max() / 2


def tilted(folder, changes):
    """Return the displacements x, y, z (m) and tilts rx, ry (rad) of a ring that is free except for
    its spin, under a radial load, a thrust and a moment."""
    folder.mkdir()
    damped = "support x 1.0 3.0e3 support y 1.0 3.0e3 support rx 1.0e-3 3 support ry 1.0e-3 3"
    loads = {
        "y free z free force 0 0 v_thrust": (
            "y free z free inertia 1.2e-4 6.5e-5 rx free ry free force 300 0 200 moment 1 0.5 0"
            f" ramp 4.0e-3 {damped}"
        ),
        '"${thrust} ${z} ${force}"': '"$(f_inner[1]) $(f_inner[2]) $(f_inner[3]) ${rx} ${ry}"',
        "variable z equal f_inner[3]": (
            "variable rx equal f_inner[7]\nvariable ry equal f_inner[8]\n"
            "variable z equal f_inner[3]"
        ),
    }
    turned(folder, loads | changes)
    return np.loadtxt(folder / "line.dat")[-1] * [1, 1, 1, 0.03, 0.03]


def test_tilted_ring_of_statics(tmp_path):
    """Friction keeps the balls at their azimuths; because it is smoothed, the ring can reach a
    state of rest."""
    rough = {"pair_style bearing/hertz": "pair_style bearing/hertz friction constant 0.1"}
    found = tilted(tmp_path / "rough", rough)
    rest = static.equilibrium(FOUR, 300, 200, moment=(1, 0.5), clearance=-4e-6)
    want = np.concatenate([rest.shift, rest.tilt]) * [1, 1, 1, 0.03, 0.03]
    assert np.abs(found - want).max() < 1e-3 * np.abs(want).max()


def test_tilted_ring_with_both_integrators(tmp_path):
    """Without friction, the balls leave the load zone in the same way with either integrator."""
    one = tilted(tmp_path / "implicit", {})
    other = tilted(tmp_path / "verlet", VERLET)
    assert np.abs(one - other).max() < 1e-3 * np.abs(one).max()


def seated(folder, way, extra):
    """Return the positions at which create_bearing places ball 1 and the inner ring, each as (x, y,
    z) in m."""
    folder.mkdir()
    dump = "dump all all custom 1 ${out}/all.dump id x y z"
    dump += '\ndump_modify all format "%d %.15g %.15g %.15g"'
    changes = {
        "diameter 12.6e-3\n": f"diameter 12.6e-3 seat {way}\n",
        "-2.0e-6": extra,
        "run 1600": f"{dump}\nrun 0",
    }
    turned(folder, changes)
    (rows,) = frames(folder / "all.dump").values()
    at = {int(tag): np.array(place, float) for tag, *place in map(str.split, rows)}
    return at[1], at[10]


@pytest.mark.parametrize("way, sign", [("plus", 1), ("minus", -1)])
def test_seat_is_where_the_smallest_thrust_puts_it(tmp_path, way, sign):
    ball, ring = seated(tmp_path / "clearance", way, "+5.0e-6")
    side = int(sign < 0)  # loaded groove of the outer ring
    found = []
    for thrust in (1.0, 0.125):
        rest = static.equilibrium(FOUR, axial_load=sign * thrust, held=STRAIGHT, clearance=10e-6)
        found.append(np.append(rest.shift, rest.outer.angle[side, 0]))
    *place, angle = (4 * found[1] - found[0]) / 3  # deflections grow as load^(2/3)
    assert sign * place[2] > 5e-6
    assert ring == pytest.approx(place, abs=1e-9)
    # the centre lies on the line through both contacts
    gap, centre = FOUR.groove_gap(1), FOUR.layout.outer[0][side]
    at = [FOUR.groove_circle(1, 10e-6) + gap * np.cos(angle), 0, centre + gap * np.sin(angle)]
    assert ball == pytest.approx(at, abs=1e-9)


def test_seat_of_a_preloaded_bearing_is_the_middle(tmp_path):
    ball, ring = seated(tmp_path / "preload", "plus", "-2.0e-6")
    assert ring.tolist() == [0, 0, 0] and ball[2] == 0


# ---- outputs
WET = {
    "pair_style bearing/hertz": (
        "pair_style bearing/ehd lubricant 0.04 2.2e-8 roughness 1e-7 0 friction stribeck 0.12 0.05"
    ),
    "balls 9 diameter 12.6e-3": "balls 9 diameter 12.6e-3 speed 60 0",
    "force 0 0 v_thrust": "spin speed 60 rx speed 0.02 force 0 -300 v_thrust",
    "run 1600": """compute ball balls bearing/ball inner_load inner_groove
fix cap balls bearing/capacitance 1 permittivity 2.2 resistivity 1e9 frequency 2e4 strength 3e7 &
  contacts ${out}/cap.dat file ${out}/figures.dat
fix circuit balls bearing/circuit 1 cap motor 50e-12 1e-9 voltage sine 300 200 breakdown 30e6 &
  resistivity 1e9 arc 0.5 stray 1e-12 events ${out}/events.txt
fix record all bearing/record 1 ${out}
run 400
dump balls balls custom 1 ${out}/balls.dump id c_ball[1] c_ball[2] f_cap[1] f_cap[2] f_cap[3]
dump now all local 1 ${out}/now.dump c_contacts[1] c_contacts[2] c_contacts[3] c_contacts[4]
fix said all print 1 "CIRCUIT" file ${out}/circuit.txt screen no title ""
run 1""",
}
SOLVED = ("driving_voltage", "bearing_capacitance", "threshold_voltage", "leak_heat", "current")
OF_CIRCUIT = [row["name"] for row in _TABLES["fix_circuit"]]
WET["run 1600"] = WET["run 1600"].replace(
    "CIRCUIT", " ".join(f"$(f_circuit[{k}])" for k in range(1, len(OF_CIRCUIT) + 1))
)


def last(path):
    return np.array([row.split() for row in list(frames(path).values())[-1]], float)


@pytest.fixture(scope="module")
def outputs(tmp_path_factory):
    """Return the folder of a lubricated run with all types of output, and the loads (N) in its last
    sample as an array (raceway, groove, ball)."""
    folder = tmp_path_factory.mktemp("outputs")
    turned(folder, WET)
    loads = np.zeros((2, 2, 9))
    for ball, side, groove, load in last(folder / "now.dump"):
        loads[int(side), int(groove), int(ball) - 1] = load
    return folder, loads


def test_by_ball(outputs):
    """The values listed for a ball are those of its more heavily loaded contact."""
    folder, loads = outputs
    table = last(folder / "balls.dump")
    assert table[:, 1] == pytest.approx(loads[0].max(axis=0), rel=1e-5)
    assert (table[:, 2] == loads[0].argmax(axis=0)).all()
    assert 0 < loads[0].argmax(axis=0).sum() < 9 and (loads > 0).sum() > 18


def test_capacitances_of_balls(outputs):
    """tests/record/test_one_sum.py tests the sums over all balls."""
    folder, _ = outputs
    *_, inner, outer, series = last(folder / "balls.dump").T
    assert series == pytest.approx(inner * outer / (inner + outer), rel=1e-5)
    rows = np.loadtxt(folder / "cap.dat")
    rows = rows[rows[:, 0] == rows[-1, 0]]
    for number, values in enumerate((inner, outer)):
        of_balls = [rows[(rows[:, 2] == k) & (rows[:, 3] == number), 6].sum() for k in range(1, 10)]
        assert values == pytest.approx(of_balls, rel=1e-5)


def test_record(outputs):
    """The record distinguishes between the grooves; sums over its rows equal the sums of the
    computes."""
    folder, loads = outputs
    run = raceway.open(folder)
    assert run.contacts.raceway.values.tolist() == ["inner 0", "inner 1", "outer 0", "outer 1"]
    now = run.contacts["load"].isel(time=-1).to_numpy()
    assert now == pytest.approx(loads.reshape(4, 9), rel=1e-5)
    rows = run.tables.contacts
    rows = rows[rows["sample"] == rows["sample"].max()]
    place = rows["raceway"].to_numpy(), rows["groove"].to_numpy(), rows["ball"].to_numpy() - 1
    assert rows["load"].to_numpy() == pytest.approx(loads[place], rel=1e-5)
    totals, pairs = run.tables.totals.iloc[-1], run.tables.pairs
    pairs = pairs[pairs["sample"] == pairs["sample"].max()]
    assert totals["contacts"] == (loads > 0).sum()
    assert totals["loaded_balls"] == len(pairs) == (loads > 0).any(axis=1).all(axis=0).sum()
    assert totals["load_inner"] == pytest.approx(loads[0].max(), rel=1e-5)
    assert totals["capacitance"] == pytest.approx(pairs["capacitance"].sum(), rel=1e-12)
    assert run.settings["inner_arch_m"] == pytest.approx(2.52e-4 * np.sin(np.radians(35)))
    assert run.settings["clearance_m"] == pytest.approx(-4e-6, abs=1e-12)


PARTS = ("a", "b", "h_c", "capacitance")


def test_grooves_of_a_ring_are_parallel_films(outputs):
    """The film values of the fix follow from the contacts in the record: the capacitances and
    conductances of the two grooves of a ring add up, and the thinner film breaks down."""
    folder, loads = outputs
    assert ((loads > 0).sum(axis=1) == 2).any()
    found = {name: column[-1] for name, column in columns(folder / "figures.dat").items()}
    now = raceway.open(folder).contacts.isel(time=-1)
    a, b, h, each = (now[name].to_numpy().reshape(2, 2, 9) for name in PARTS)
    electric, thickness = each.sum(axis=1), np.fmin.reduce(h, axis=1)
    conducts = np.nan_to_num(np.pi * a * b / h).sum(axis=1) / 1e9
    live = (electric > 0).all(axis=0)
    total = electric[:, live].sum(axis=0)
    limit = 3e7 * thickness[:, live] * total / electric[::-1, live]
    assert found["threshold_voltage"] == pytest.approx(limit.min(), rel=1e-9)
    leak = 1 / (1 / (1 / conducts[:, live]).sum(axis=0)).sum()
    assert found["leak"] == pytest.approx(leak, rel=1e-9)
    films = conducts[:, live] + 2j * np.pi * 2e4 * electric[:, live]
    impedance = 1 / (1 / (1 / films).sum(axis=0)).sum()
    assert found["impedance"] == pytest.approx(abs(impedance), rel=1e-9)
    assert found["phase"] == pytest.approx(np.angle(impedance), rel=1e-9)
    over = electrical.over_time(raceway.open(folder))
    series = electric[0, live] * electric[1, live] / total
    assert over["bearing"].values[-1] == pytest.approx(series.sum(), rel=1e-9)


def test_circuit_of_the_fix_is_that_of_python(outputs):
    folder, _ = outputs
    data, events = circuit.run(
        raceway.open(folder),
        Motor(Sine(300.0, 200.0), 50e-12, 1e-9),
        Breakdown(30e6, arc=0.5),
        Leak(1e9),
        stray=1e-12,
    )
    assert data.sizes["raceway"] == 2 and len(events) > 0
    found = dict(zip(OF_CIRCUIT, np.loadtxt(folder / "circuit.txt")))
    now = data.isel(time=-1)
    assert found["discharges"] == events["discharge"].nunique()
    for name in SOLVED:
        assert found[name] == pytest.approx(float(now[name]), rel=1e-5), name


def test_what_needs_one_groove_says_so(outputs):
    run = raceway.open(outputs[0])
    with pytest.raises(RunError, match="rings with two grooves per ball: their total capacitance"):
        whole_capacitance.over_time(run)


def test_main_deck(tmp_path):
    """In the main deck, a deep groove ball bearing can be changed into a four-point contact bearing
    with the same clearance."""
    variables = {"four_point": 35, "axial": 1000, "clearance": 2e-6, "passes": 1}
    variables["surroundings"] = "flooded"
    succeed("inputs/in.6208", out=tmp_path, **variables)
    recorded = raceway.open(tmp_path)
    assert recorded.settings["clearance_m"] == pytest.approx(2e-6, abs=1e-12)
    want, sums = recorded.contacts.load(), recorded.tables.totals
    # the whole gap at both grooves of a ring, including grooves without load
    whole = want["capacitance_total"].to_numpy()
    assert (whole > 0).all() and (want["load"].to_numpy() == 0).any()
    inner, outer = whole.reshape(len(whole), 2, 2, -1).sum(axis=2).transpose(1, 0, 2)
    series = (inner * outer / (inner + outer)).sum(axis=1)
    assert sums["capacitance_total"].to_numpy() == pytest.approx(series, rel=1e-12)
    read = whole_capacitance.over_time(recorded)
    assert read["bearing"].to_numpy() == pytest.approx(series, rel=1e-12)
    # statics evaluated at the positions that the balls pass through
    points = [
        electric_point.solve(
            "6208",
            "mineral",
            load=recorded.settings["load_N"],
            axial=1000.0,
            rpm=recorded.settings["rpm"],
            clearance=2e-6,
            models="paper",
            phase=2 * np.pi / 9 * k / 4,
            four_point=np.radians(35),
        )
        for k in range(4)
    ]
    of_statics = np.mean([point.capacitors().total for point in points])
    assert series.mean() == pytest.approx(of_statics, rel=2e-3)
    fails = [electric_point.figures(point)["threshold_V"] for point in points]
    voltage = whole_capacitance.fields(recorded, read, 1.0)["threshold"].to_numpy()
    assert voltage.mean() == pytest.approx(np.mean(fails), rel=1e-2)
    frame = list(particles.frames(recorded.tables, 1))[-1].data
    seen, now, balls = recorded.universe(), want.isel(time=-1), frame["type"] == 1
    ts, ours = seen.trajectory[-1], np.isin(seen.atoms.ids, want.ball)
    for name in ("load", "h_c", "capacitance"):
        for groove in ("inner 0", "inner 1", "outer 0", "outer 1"):
            values = now[name].sel(raceway=groove).to_numpy()
            key = f"{name}_{groove.replace(' ', '_')}"
            np.testing.assert_array_equal(frame[key][balls], values)
            np.testing.assert_array_equal(ts.data[key][ours], values)
    np.testing.assert_array_equal(frame["load"][balls], now["load"].max("raceway"))
    assert frame["capacitance"].sum() == pytest.approx(sums["capacitance"].iloc[-1], rel=1e-12)
