# SPDX-License-Identifier: GPL-2.0-or-later
"""The results of fix bearing/implicit are bitwise identical on any number of ranks, wherever the
box is cut, with other bearings in the box, and when a run continues on another number of ranks.

The scene (in.ranks) is a transient under a growing load, in which some steps are rejected. The
inner ring starts at the cuts through the middle of the box and moves away from them, so the bearing
moves to another rank.
"""

import re

import pytest
from host import BOX, ROOT, deck_file, frames, refuses, succeed

DECK = "tests/implicit/in.ranks"
TWO = {"bearings": 2, "xhi": 0.18}
LAST = 60  # steps


def state(folder):
    """Return all data that a run has written, step by step."""
    return [frames(folder / name) for name in ("balls.dump", "contacts.dump")] + [
        (folder / name).read_text()
        for name in ("ring.txt", "control.txt", "capacitance.txt", "between.txt", "events.txt")
    ]


def first_bearing(folder):
    """Return the rows of atoms 1 to 20, which belong to the first bearing."""
    return {
        step: [row for row in rows if int(row.split()[0]) <= 20]
        for step, rows in frames(folder / "balls.dump").items()
    }


def last(folder):
    """Return the last samples of atoms, contacts and the ring."""
    return [frames(folder / name)[LAST] for name in ("balls.dump", "contacts.dump")] + [
        (folder / "ring.txt").read_text().splitlines()[-1]
    ]


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Return the folder of a run of one bearing on one rank."""
    folder = tmp_path_factory.mktemp("whole")
    outcome = succeed(DECK, out=folder)
    assert int(re.search(r"Neighbor list builds = (\d+)", outcome.text).group(1)) >= 15
    return folder


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """Return the folder of a run of two bearings on one rank."""
    folder = tmp_path_factory.mktemp("both")
    succeed(DECK, out=folder, **TWO)
    return folder


def test_scene_is_worth_comparing(whole):
    assert len(frames(whole / "balls.dump")[LAST]) == 20
    rings = [
        list(map(float, row.split())) for row in (whole / "ring.txt").read_text().splitlines()[1:]
    ]
    assert all(r[2] < -1e-6 for r in rings)  # m: the ring has moved away from the cut at y = 0
    # N: the load is still growing at the first sample
    assert 1000 < rings[0][7] < 4500 < rings[-1][7]
    assert abs(rings[0][8]) > 1e-4  # rad: the outer ring wobbles
    assert rings[-1][10] > 3  # discharges
    refused = float((whole / "control.txt").read_text().splitlines()[-1].split()[4])
    assert refused > 0


@pytest.mark.parametrize("ranks", [2, 4])
def test_ranks(whole, ranks, tmp_path):
    succeed(DECK, ranks=ranks, out=tmp_path)
    assert state(tmp_path) == state(whole)


@pytest.mark.parametrize(
    "cuts, ranks, box",
    [
        ((2, 1, 1), 2, {}),
        ((1, 2, 1), 2, {}),
        ((1, 1, 2), 2, {}),
        ((2, 1, 1), 2, {"xhi": 0.09}),  # the cut lies next to the rings
        ((1, 2, 2), 4, {"ylo": -0.1}),
        ((3, 3, 1), 9, {"xhi": 0.06}),  # the rank with the rings has no ball
    ],
    ids=str,
)
def test_cuts(whole, cuts, ranks, box, tmp_path):
    succeed(DECK, ranks=ranks, out=tmp_path, cuts_x=cuts[0], cuts_y=cuts[1], cuts_z=cuts[2], **box)
    assert state(tmp_path) == state(whole)


def test_a_cage_ball_between_strangers(tmp_path):
    """Without rails, a cage ball is connected to its bearing only through balls, which belong to
    other ranks in this case."""
    succeed(DECK, out=tmp_path / "one", rails=0)
    succeed(DECK, ranks=8, out=tmp_path / "eight", rails=0, cuts_x=8, cuts_y=1)
    assert state(tmp_path / "eight") == state(tmp_path / "one")


@pytest.mark.parametrize("ranks", [2, 4])
def test_two_bearings(both, ranks, tmp_path):
    succeed(DECK, ranks=ranks, out=tmp_path, **TWO)
    assert state(tmp_path) == state(both)


def test_another_bearing_changes_no_bits(whole, both):
    """The results are bitwise identical, although the other bearing requires finer steps and other
    neighbour lists."""
    assert first_bearing(both) == frames(whole / "balls.dump")
    finest = [
        float((f / "control.txt").read_text().splitlines()[-1].split()[1]) for f in (whole, both)
    ]
    assert finest[1] < finest[0]


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_fix_for_each_bearing(both, ranks, tmp_path):
    succeed(DECK, ranks=ranks, out=tmp_path, moved="one", apart=1, **TWO)
    assert frames(tmp_path / "balls.dump") == frames(both / "balls.dump")


@pytest.mark.parametrize("bearings", [1, 2])
def test_restart_on_other_ranks(whole, both, bearings, tmp_path):
    """Two ranks write a restart file in the middle of a run, while the load grows and steps are
    refined. One rank and four ranks resume from it."""
    case = TWO if bearings == 2 else {}
    unbroken = {1: whole, 2: both}[bearings]
    succeed(DECK, ranks=2, out=tmp_path, keep=22, first=22, second=38, **case)
    assert state(tmp_path)[:2] == state(unbroken)[:2]
    for ranks in (1, 4):
        out = tmp_path / str(ranks)
        succeed(
            DECK,
            ranks=ranks,
            out=out,
            begin="resume",
            first=38,
            bearings=bearings,
            **{"from": tmp_path / "restart.22"},
        )
        assert last(out) == last(unbroken)


@pytest.mark.parametrize("scene", ["full", "full by estimates", "flaw", "dampers"])
def test_models_full_or_flaws(scene, tmp_path):
    """The results of two ranks, and of four ranks that resume from a restart file written in the
    middle, are bitwise identical to those of one rank. One scene has film in the gap, film branch
    and tangential springs, which store forces between steps; the other has flaws of balls and of a
    ring, whose ghosts must have the ring's angle. With `solve damping`, only dampers are
    implicit."""
    kept = {
        "full": {"control": "tolerance 1e-8 cage_tolerance 1e-6"},
        "full by estimates": {"control": "tolerance 1e-8 cage_tolerance 1e-6 control estimate"},
        "dampers": {"control": "solve damping"},
        "flaw": {
            "flaw": "notch -1.4 3.0e-3 full 1.0e-5 5.0e-5 wave 40 2.0e-7 0.5",
            "flaw_ball": "ball pit 0.9 0.05 2.0e-3 1.0e-3 1.0e-5 1.0e-4 wave 7 2.0e-7 0",
            "housing": 1,
        },
    }[scene]
    full = {"models": "full", "lubricant": "mineral"} if "full" in scene else {}
    words = dict(kept, **full)
    succeed(DECK, out=tmp_path / "one", **words)
    succeed(DECK, ranks=4, out=tmp_path / "four", **words)
    assert state(tmp_path / "four") == state(tmp_path / "one")
    succeed(DECK, ranks=2, out=tmp_path / "two", keep=22, first=22, second=38, **words)
    assert state(tmp_path / "two")[:2] == state(tmp_path / "one")[:2]
    succeed(
        DECK,
        ranks=4,
        out=tmp_path / "resumed",
        begin="resume",
        first=38,
        **kept,
        **{"from": tmp_path / "two/restart.22"},
    )
    assert last(tmp_path / "resumed") == last(tmp_path / "one")


def test_a_fixed_housing_is_the_ground(tmp_path):
    """A fixed housing has its centre on the pitch circle, closer to some cage balls than their ring
    is. The results are bitwise identical to those with the ground."""
    held = (ROOT / "tests/hosts/bits.housing.1").read_text().split("fix housing")[0]
    text = (ROOT / DECK).read_text()
    for name, words in (
        ("ground", held.replace(" to housing", "")),
        ("housing", held + "fix housing housing bearing/ring\n"),
    ):
        deck = deck_file(
            tmp_path,
            text.replace("include tests/hosts/bits.housing.${housing}", words),
            f"in.{name}",
        )
        succeed(deck, out=tmp_path / name, housing=int(name == "housing"))
    ground, housing = (frames(tmp_path / name / "balls.dump") for name in ("ground", "housing"))
    assert ground == {
        step: [row for row in rows if not row.startswith("21 ")] for step, rows in housing.items()
    }


BEARINGS = (
    BOX.replace("box 4 box", "box 5 box").replace("0.06 -0.06 0.06 -0.06", "0.18 -0.06 0.06 -0.06")
    + """
include inputs/bearings/6208
pair_style bearing/hertz young 2.07e11 2.07e11 poisson 0.29 0.29
pair_coeff 1 3 inner ${inner_radius} ${inner_groove}
pair_coeff 1 4 outer ${outer_radius} ${outer_groove}
create_bearing 1 none 3 4 balls 9 diameter ${ball_diameter}
create_bearing 1 none 3 4 balls 9 diameter ${ball_diameter} centre 0.12 0 0
create_atoms 5 single 0.02 0.05 0.05 units box
set type 5 density 7800 diameter 1.0e-3
group one id 1:11
group two id 12:22
group both id 1:22
group inner type 3
group rings type 3 4
timestep 1.0e-5
"""
)


@pytest.mark.parametrize(
    "fixes, message",
    [
        (
            "fix move all bearing/implicit\nfix r rings bearing/ring",
            "atom 23 of its group is not a ball, cage ball or ring of a bearing",
        ),
        (
            "group some id 1:10 12:22\nfix move some bearing/implicit\nfix r inner bearing/ring",
            "atom 11 (type 4) belongs to a bearing that has other atoms in the fix's group",
        ),
        (
            "group some id 9:22\nfix move some bearing/implicit\nfix r inner bearing/ring",
            "atom 1 (type 1) belongs to",
        ),
        (
            "fix move one bearing/implicit\nfix r inner bearing/ring",
            "some rings of fix r but not all of them",
        ),
        (
            "group some id 20:22\nfix a both bearing/implicit\nfix b some bearing/implicit",
            "both move atom",
        ),
        ("fix a both bearing/implicit\nfix b two nve/sphere", "moves them too"),
    ],
)
@pytest.mark.parametrize("ranks", [1, 2])
def test_mistakes_are_named(ranks, fixes, message, tmp_path):
    deck = deck_file(tmp_path, BEARINGS + fixes + "\nrun 1\n")
    refuses(deck, message, ranks=ranks, timeout=60)


@pytest.mark.parametrize("ranks", [1, 2])
def test_impossible_load_stops_all_ranks(ranks, tmp_path):
    fixes = "fix a both bearing/implicit\nfix r inner bearing/ring mass 0.2 x free force 1e9 0 0\n"
    deck = deck_file(tmp_path, BEARINGS + fixes + "run 10\n")
    refuses(deck, "no solution with substeps down to", ranks=ranks, timeout=60)
