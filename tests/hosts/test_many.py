# SPDX-License-Identifier: GPL-2.0-or-later
"""Many bearings in one box: the results for each bearing are bitwise identical to those of a run
with this bearing alone, on any number of ranks and for any cut of the box.

Twelve bearings are arranged in three columns. Their loads, speeds and initial azimuths differ, and
two lubricants alternate. Between two ranks, the box is cut between rows of bearings. Between three
ranks, the cuts pass through two rows, and between four ranks through the middle column, i.e.
through rings, balls and cages.
"""

import re

import numpy as np
import pytest
import raceway
from host import BOX, deck_file, frames, refuses, same_files, succeed
from recorded_runs import bytes_of

DECK = "tests/hosts/in.many_bits"
# {atoms per bearing: number of the first raceway ring}, with a cage ring and with a chain
INNER = {12: 10, 20: 19}
SCENES = {
    "implicit": {"integrator": "implicit", "time": 4e-3, "sample": 1e-3, "step": 2.5e-4},
    "verlet": {
        "integrator": "verlet",
        "models": "paper",
        "time": 4e-4,
        "sample": 1e-4,
        "step": 2e-7,
        "ramp": 2e-4,
    },  # fmt: skip
}
BEARINGS = {"bearings": 12, "columns": 3}


def fleet(folder):
    """Return a dict that maps each bearing to (inner ring, load, rpm, lubricant)."""
    lines = (folder / "fleet.txt").read_text().splitlines()
    oils = dict(re.findall(r"^# kind (\d+): (\S+)$", "\n".join(lines), flags=re.M))
    rows = [line.split() for line in lines if line[0] != "#"]
    return {int(row[0]): (int(row[1]), float(row[4]), float(row[5]), oils[row[6]]) for row in rows}


def table(folder, ring):
    """Return a dict that maps each step to the columns, except for the first, of the row for an
    inner ring."""
    found = {}
    for step, rows in frames(folder / "bearings.dump").items():
        mine = [row.split()[1:] for row in rows if int(row.split()[0]) == ring]
        assert len(mine) == 1
        found[step] = mine[0]
    return found


def atoms(folder, ring):
    """Return the last state of the atoms that belong to the bearing with the inner ring `ring`, in
    their original order."""
    (rows,) = frames(folder / "last.dump").values()
    count = len(rows) // len(fleet(folder))
    first = ring - INNER[count] + 1
    mine = sorted(
        (int(row.split()[0]), row.split()[1:])
        for row in rows
        if first <= int(row.split()[0]) < first + count
    )
    assert len(mine) == count
    return [values for _, values in mine]


@pytest.fixture(scope="module", params=SCENES)
def scene(request, tmp_path_factory):
    """Return the variables of a scene and the folder of its run on one rank."""
    folder = tmp_path_factory.mktemp("many")
    variables = {**BEARINGS, **SCENES[request.param]}
    succeed(DECK, out=folder, **variables)
    return variables, folder


def test_scene_is_worth_comparing(scene):
    _, folder = scene
    them = fleet(folder)
    assert len(them) == 12 and len({(load, rpm) for _, load, rpm, _ in them.values()}) == 12
    assert {oil for *_, oil in them.values()} == {"mineral", "pao48"}
    for ring, load, rpm, _ in them.values():
        row = [float(word) for word in table(folder, ring)[max(table(folder, ring))]]
        assert row[2] == pytest.approx(rpm * 3.14159265358979 / 30, rel=1e-5)  # spin, rad/s
        assert 0.5 * load < row[4] < 1.5 * load  # N, load on the contacts at this time
        assert row[14] > 1e-11  # F


@pytest.mark.parametrize("ranks", [2, 3, 4])
def test_ranks(scene, ranks, tmp_path):
    variables, folder = scene
    succeed(DECK, ranks=ranks, out=tmp_path, **variables)
    for name in ("bearings.dump", "last.dump"):
        assert frames(tmp_path / name) == frames(folder / name)
    assert (tmp_path / "record.nc").read_bytes() == (folder / "record.nc").read_bytes()


@pytest.mark.parametrize("host, ranks", [("lammps", 1), ("wheel", 2)])
def test_hosts(tmp_path, host, ranks):
    """The rows of the table and the samples of the record are the same in every host."""
    words = {"bearings": 4, "columns": 2, "time": 2e-3, "record": "all"}
    for folder, where in (("one", {}), ("other", dict(host=host, ranks=ranks))):
        succeed("inputs/in.many", out=tmp_path / folder, **where, **words)
    assert (tmp_path / "one/fleet.txt").read_text() == (tmp_path / "other/fleet.txt").read_text()
    one, other = (frames(tmp_path / folder / "bearings.dump") for folder in ("one", "other"))
    assert one == other
    one, other = (bytes_of(tmp_path / folder) for folder in ("one", "other"))
    assert one == other and "ring_x" in one


@pytest.mark.parametrize("number, ranks", [(1, 1), (5, 3), (8, 1), (11, 4)])
def test_alone(scene, number, ranks, tmp_path):
    """On four ranks, the cuts pass through bearings 5 and 8 in the middle column. In the
    single-bearing runs, these bearings are at the same position in the same box."""
    variables, folder = scene
    succeed(DECK, ranks=ranks, out=tmp_path, only=number, **variables)
    (alone,) = fleet(tmp_path).values()
    ring, *case = fleet(folder)[number]
    assert list(alone[1:]) == case
    assert table(tmp_path, alone[0]) == table(folder, ring)
    assert atoms(tmp_path, alone[0]) == atoms(folder, ring)


def test_table_against_the_contacts(tmp_path):
    """Sums and extremes in a row match the contact table of the ring, and its force and torque
    match the values of `fix bearing/ring`."""
    deck = deck_file(
        tmp_path,
        f"""
variable out index {tmp_path}
include inputs/in.many
compute contact balls bearing/contact ring raceway load pressure h_min lambda friction capacitance
dump contacts balls local 1 {tmp_path}/contacts.dump &
  c_contact[1] c_contact[2] c_contact[3] c_contact[4] &
  c_contact[5] c_contact[6] c_contact[7] c_contact[8]
dump_modify contacts format "%.0f %.0f %.12g %.12g %.12g %.12g %.12g %.12g"
variable fx1 equal f_inner[1][11]
variable fy4 equal f_inner[4][12]
variable x4 equal f_inner[4][1]
variable torque4 equal f_inner[4][17]
fix say all print 1 "said ${{fx1}} ${{fy4}} ${{x4}} ${{torque4}}"
undump table
dump table inner local 1 {tmp_path}/now.dump c_of[1] c_of[2] c_of[5] c_of[6] c_of[7] c_of[8] &
  c_of[10] c_of[11] c_of[12] c_of[13] c_of[16]
dump_modify table format "%.0f %.12g %.12g %.12g %.12g %.0f %.12g %.12g %.12g %.12g %.12g"
run 1
""",
    )
    outcome = succeed(deck, bearings=4, columns=2, time=4e-3)
    said = [
        float(word) for word in re.findall(r"^said (.*)$", outcome.text, flags=re.M)[-1].split()
    ]
    rows = [[float(word) for word in row.split()] for row in frames(tmp_path / "now.dump")[17]]
    contacts = [
        [float(word) for word in row.split()] for row in frames(tmp_path / "contacts.dump")[17]
    ]
    rows.sort()
    assert len(rows) == 4
    for ring, *_, live, load, pressure, h_min, film, _ in rows:
        mine = [c for c in contacts if c[0] == ring]
        assert {c[1] for c in mine} == {0.0} and len(mine) == live > 2
        assert load == max(c[2] for c in mine) and pressure == max(c[3] for c in mine)
        assert h_min == min(c[4] for c in mine) and film == min(c[5] for c in mine)
    # the two capacitors of each ball are in series, and all balls are in parallel; the second
    # capacitors belong to the outer ring (the next tag), and are listed in the same order
    for row in rows:
        inner = [c[7] for c in contacts if c[0] == row[0]]
        outer = [c[7] for c in contacts if c[0] == row[0] + 1]
        assert max(inner) / 2 < row[10] < sum(inner) and row[10] < sum(outer)
    digits = pytest.approx
    # one value has 12 digits; the other was printed by the host in %g format
    assert rows[0][2] == digits(said[0], rel=1e-9, abs=1e-9)
    assert rows[3][3] == digits(said[1], rel=1e-9)
    assert rows[3][1] == digits(said[2], rel=1e-9)
    assert rows[3][4] == digits(said[3], rel=1e-9)


def test_the_table_is_one_file_that_a_person_can_read(scene):
    _, folder = scene
    steps = frames(folder / "bearings.dump")
    assert len(steps) == 5 and all(len(rows) == 12 for rows in steps.values())
    lines = (folder / "bearings.dump").read_text().splitlines()
    rings = [int(line.split()[0]) for line in lines[9:21]]
    assert rings == sorted(rings)


ONE_RING = (
    BOX
    + """
pair_style bearing/hertz friction constant 0.1
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer 36.6e-3 6.552e-3
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed 50 0
group balls type 1
group inner type 3
fix move MOVE
variable force atom FORCE
variable spin atom 50
variable tilt atom 1.0e-4
fix inner inner bearing/ring mass 0.2 inertia 1.2e-4 6.5e-5 x free y free spin speed SPIN &
  rx position TILT moment 0 0 MOMENT force 0 LOAD 0 ramp 1e-4
timestep STEP
run 100
write_dump all custom OUT id x y z vx vy vz omegax omegay omegaz modify &
  format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g" sort id
"""
)


def one_ring(**words):
    """Return the deck `ONE_RING` with the words in capitals replaced by `words`."""
    text = ONE_RING
    for name, word in words.items():
        text = text.replace(name.upper(), str(word))
    return text


@pytest.mark.parametrize(
    "move, step",
    [("all bearing/implicit", 5e-6), ("balls nve/sphere", 5e-7)],
    ids=["implicit", "verlet"],
)
def test_a_value_of_its_own_is_the_number(move, step, tmp_path):
    """The results for loads, speeds and positions from atom-style variables are bitwise identical
    to those for plain numbers."""
    by = {
        "number": {"spin": 50, "tilt": 1e-4, "load": -2000, "moment": 50},
        "variable": {"spin": "v_spin", "tilt": "v_tilt", "load": "v_force", "moment": "v_spin"},
    }
    for name, words in by.items():
        deck = deck_file(
            tmp_path,
            one_ring(move=move, step=step, force="-2000.0", out=tmp_path / name, **words),
            f"in.{name}",
        )
        succeed(deck)
    assert frames(tmp_path / "variable") == frames(tmp_path / "number")


@pytest.mark.parametrize(
    "force, message",
    [
        ("exp(1000*id)", "fix inner bearing/ring: variable 'force' is inf for ring atom 10"),
        ("-2000/(id-10)", "Divide by 0 in variable formula"),
    ],
)
def test_a_value_that_is_no_number(force, message, tmp_path):
    words = {"spin": 50, "tilt": 0, "load": "v_force", "moment": 0, "out": tmp_path / "dump"}
    text = one_ring(move="balls nve/sphere", step=5e-7, force=force, **words)
    refuses(deck_file(tmp_path, text), message)


@pytest.mark.parametrize(
    "words, message",
    [
        ({"only": 13}, "only is 13, but there are 12 bearings"),
        ({"lubricant": "dry"}, "needs a lubricant"),
        ({"lubricant": ["vg46", "dry"]}, "all bearings of a run have films, or all are dry"),
        ({"kinds": 3}, "kinds is 3, but lubricant has 2 oils"),
        ({"kinds": 2, "lubricant": ["vg46", "vg68", "pao8"]}, "kinds is 2, but lubricant has 3"),
        ({"sample": 1e-4}, "steps between samples is 0, must be a whole number from 1"),
    ],
)
def test_mistakes(words, message, tmp_path):
    refuses("inputs/in.many", message, out=tmp_path, **{**BEARINGS, **words})


def test_oils_in_turn(tmp_path):
    """If seven bearings use three oils, the record contains the viscosity of the oil in each."""
    oils = ["mineral", "vg68", "vg46"]
    words = {"bearings": 7, "columns": 3, "time": 1e-3, "kinds": 3, "lubricant": oils}
    succeed("inputs/in.many", out=tmp_path, **words)
    assert [oil for *_, oil in fleet(tmp_path).values()] == [*oils, *oils, "mineral"]
    run = raceway.open(tmp_path)
    assert run.bearing_numbers == [*range(1, 8)] and run.settings["bearing"] == "6208"
    viscosity = [run.select(k).settings["viscosity_Pa_s"] for k in run.bearing_numbers]
    assert viscosity[0] == 0.040 and len(set(viscosity)) == 3
    assert viscosity == [*viscosity[:3], *viscosity[:3], viscosity[0]]


def test_alike(tmp_path):
    """Results for all bearings are equal to those for the first, because load, speed and azimuth
    are the same."""
    words = {"bearings": 2, "columns": 2, "fleet": "alike", "lubricant": "vg46", "phase": 0.3}
    succeed(DECK, out=tmp_path, time=2e-3, **words)
    one, other = fleet(tmp_path).values()
    assert one[1:] == other[1:] == (5000.0, 477.5, "vg46")


def test_surroundings(tmp_path):
    """The record contains the capacitances; the motion and the table do not change."""
    short = {"bearings": 2, "columns": 2, "time": 2e-3}
    runs = {}
    for word in ("none", "cavitated"):
        more = {"surroundings": word, "outlet": 1.3, "out": tmp_path / word}
        succeed("inputs/in.many", **short, **more)
        runs[word] = raceway.open(tmp_path / word)
    same_files(tmp_path / "none", tmp_path / "cavitated", "bearings.dump")
    for number in (1, 2):
        plain, whole = (runs[word].select(number).bearing for word in runs)
        assert np.array_equal(plain.capacitance, whole.capacitance)
        assert (whole.capacitance_total > 1.05 * whole.capacitance).all()


def test_starved_as_alone(tmp_path):
    """The starvation factor depends on the nominal speed, but not on which bearing comes first."""
    for only in (0, 2):
        succeed(DECK, out=tmp_path / str(only), only=only, models="full", time=2e-3, **BEARINGS)
    ring = fleet(tmp_path / "0")[2][0]
    assert table(tmp_path / "2", fleet(tmp_path / "2")[2][0]) == table(tmp_path / "0", ring)
    assert "rolling" in raceway.open(tmp_path / "0").tables.record.attrs["pair_commands"]


def test_one_oil_in_lammps(tmp_path):
    """With a single oil, LAMMPS once crashed in its own input reader."""
    words = {"bearings": 4, "time": 5e-4, "sample": 2.5e-4, "lubricant": "vg46"}
    succeed("inputs/in.many", host="lammps", out=tmp_path, **words)
    assert [oil for *_, oil in fleet(tmp_path).values()] == 4 * ["vg46"]
