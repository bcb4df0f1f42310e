# SPDX-License-Identifier: GPL-2.0-or-later
"""For the same input, results are bitwise identical on 1, 2 and 4 ranks, in one run or two, and
after a restart on a different number of ranks.

The scene (in.bits) includes lubricant films, friction springs, a cage, a free inner ring with
gyroscopic moments, a wobbling outer ring that carries the rails, and capacitances. The box is cut
through the balls but far from the ring atoms; neighbour lists are rebuilt many times, and atoms
move to other ranks.
"""

import math
import re

import pytest
from host import frames, same_files, succeed

LAST = 400  # steps
DUMPS = ("contacts.dump", "balls.dump")
FULL = (
    "gap 1 film_damping branch inlet_shear murch 0.047 0.134 friction mixed 0.12 0.05 heathcote"
    " 1.0e-4 rolling 0.047 0.134 1.0 rolling_hysteresis 0.01 spin 1.0 drag 870 0.1"
)
# balls centred in the Gothic arches have a contact angle of 35 degrees
SLACK, ANGLE = 6.552e-3 - 6.3e-3, math.radians(35)
GOTHIC = {
    "arch": SLACK * math.sin(ANGLE),
    "inner_radius": 24.0e-3 - SLACK * (1 - math.cos(ANGLE)),
    "outer_radius": 36.6e-3 + SLACK * (1 - math.cos(ANGLE)),
}
SCENES = {
    "film, ring free to tilt": {"lubricant": "mineral", "tilt": "free"},
    "film in the gap, ring free to tilt": {"lubricant": "mineral", "tilt": "free", "law": FULL},
    "dry, ring not tilting": {"lubricant": "dry", "tilt": "fixed"},
    "four points, ring free to tilt": {"lubricant": "dry", "tilt": "free", **GOTHIC},
    "flaws, housing, ring free to tilt": {
        "lubricant": "mineral",
        "tilt": "free",
        "flaw_inner": "notch 0.1 3.0e-3 5.0e-4 1.0e-4 5.0e-5 wave 40 1.0e-7 0.5",
        "flaw_outer": "notch 0.15 3.0e-3 full 1.0e-4 5.0e-5",
        "flaw_ball": "wave 12 2.0e-7 0.2",
        "flawed_ball": "2 5",
        "housing": 1,
    },
}


@pytest.fixture(
    scope="module", params=SCENES, ids=lambda name: name.replace(", ", "-").replace(" ", "_")
)
def scene(request, tmp_path_factory):
    """Return the variables of a scene and the folder of its run on one rank."""
    folder = tmp_path_factory.mktemp("bits")
    variables = SCENES[request.param]
    outcome = succeed("tests/hosts/in.bits", out=folder / "whole", **variables)
    builds = int(re.search(r"Neighbor list builds = (\d+)", outcome.text).group(1))
    assert builds >= 5, f"{builds} neighbour lists are too few: atoms hardly change rank"
    return variables, folder


def state(folder):
    """Return the last sample for the contacts, the atoms and the ring, with all digits."""
    return [frames(folder / name)[LAST] for name in DUMPS] + [
        (folder / "ring.txt").read_text().splitlines()[-1]
    ]


def test_scene_is_worth_comparing(scene):
    contacts, balls, ring = state(scene[1] / "whole")
    if "arch" in scene[0]:
        assert len(contacts) > 30  # most balls touch two grooves of each ring
    else:
        assert len(contacts) == 18  # the preload keeps all nine balls on both raceways
    housing = 21  # ID of the atom of the housing
    moved = {int(row.split()[0]): row for row in balls}
    assert len(balls) == (housing if "housing" in scene[0] else housing - 1)
    if housing in moved:  # displacement of the ring relative to its atom, m
        (x, y), outer = (list(map(float, moved[one].split()[1:3])) for one in (housing, 20))
        assert min(abs(outer[0] - (x + 0.03)), abs(outer[1] - y)) > 1e-8
    assert abs(float(ring.split()[2])) > 1000  # N, force that the balls exert on the ring


@pytest.mark.parametrize("ranks", [2, 4])
def test_ranks(scene, ranks):
    variables, folder = scene
    succeed("tests/hosts/in.bits", ranks=ranks, out=folder / str(ranks), **variables)
    same_files(folder / str(ranks), folder / "whole", *DUMPS, read=frames)
    same_files(folder / str(ranks), folder / "whole", "ring.txt")


@pytest.mark.parametrize("cuts", ["z", "3x3"])
def test_cuts(scene, cuts, tmp_path):
    """The box is cut in its middle plane, with balls on both sides of the cut. On nine ranks, the
    rank that owns the rings has no balls."""
    variables, _ = scene
    box = {"xhi": 0.05, "ylo": -0.05, **variables}
    grid, ranks = {
        "z": ({"cuts_x": 1, "cuts_y": 1, "cuts_z": 2}, 2),
        "3x3": ({"cuts_x": 3, "cuts_y": 3}, 9),
    }[cuts]
    succeed("tests/hosts/in.bits", out=tmp_path / "one", **box)
    succeed("tests/hosts/in.bits", ranks=ranks, out=tmp_path / "many", **box, **grid)
    same_files(tmp_path / "many", tmp_path / "one", *DUMPS, read=frames)
    same_files(tmp_path / "many", tmp_path / "one", "ring.txt")


def test_two_runs_are_one(scene):
    variables, folder = scene
    succeed("tests/hosts/in.bits", out=folder / "split", first=200, second=200, **variables)
    assert state(folder / "split") == state(folder / "whole")


@pytest.mark.parametrize(
    "when, write_ranks, read_ranks",
    [("during", 1, 1), ("after", 1, 2), ("after", 4, 1), ("during", 2, 4)],
)
def test_restart(scene, when, write_ranks, read_ranks):
    """Restart files are written either during a run, or by a command after the run."""
    variables, folder = scene
    out = folder / f"{when}{write_ranks}{read_ranks}"
    how = {"keep": 200} if when == "during" else {"first": 200, "write": 1}
    succeed("tests/hosts/in.bits", ranks=write_ranks, out=out, **how, **variables)
    succeed(
        "tests/hosts/in.bits_resume",
        ranks=read_ranks,
        out=out / "resumed",
        **variables,
        **{"from": out / "restart.200"},
    )
    assert state(out / "resumed") == state(folder / "whole")
