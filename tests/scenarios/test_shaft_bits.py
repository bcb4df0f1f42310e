# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft: results of rigid and flexible shafts are bitwise identical in all hosts, on
any number of ranks and after restarts."""

import pytest
from flexible_shaft import HELD, LOADED, modes_file, reduced
from host import refuses, succeed
from shaft_runs import BITS, DECK, data_of, rows_of

from scenarios import test_rigid_shaft as rigid

STEPS = {"implicit": 60, "verlet": 1500, "flexible": 60}


@pytest.fixture(scope="module", params=STEPS)
def whole(request, tmp_path_factory):
    """Return (variables, number of steps, folder) of a run on a single rank."""
    name, folder = request.param, tmp_path_factory.mktemp("whole")
    variables = {**BITS, "every": STEPS[name] // 6}
    if name == "flexible":
        modes = modes_file(tmp_path_factory.mktemp("modes"), damping=0.02)
        variables["words"] = f"flexible {modes} {LOADED} {HELD}"
    else:
        variables |= {"words": rigid.LOADED, **rigid.MOVERS[name]}
    succeed(DECK, out=folder, **variables, steps=STEPS[name])
    return variables, STEPS[name], folder


def test_scene_is_worth_comparing(whole):
    variables, _, folder = whole
    last = {key: value[-1] for key, value in data_of(folder).items()}
    assert last["f1y"] > 100 and last["f2y"] > 100 and last["angle"] > 0.2
    assert abs(last["z"]) > 1e-7 and abs(last["rx"]) > 1e-6
    straight = last["y"] - (0.2 - reduced().body.centre) * last["rx"]
    assert "flexible" not in variables["words"] or abs(last["y2"] - straight) > 1e-7


@pytest.mark.parametrize(
    "host, ranks", [("liggghts", 2), ("liggghts", 4), ("lammps", 1), ("lammps", 2)]
)
def test_same_bits(whole, host, ranks, tmp_path):
    variables, steps, one = whole
    succeed(DECK, host=host, ranks=ranks, out=tmp_path, **variables, steps=steps)
    assert rows_of(tmp_path)[-6:] == rows_of(one)[-6:]


def test_restart(whole, tmp_path):
    """A run continues from a restart file on another number of ranks, unless the shaft has other
    modes."""
    variables, steps, one = whole
    half = steps // 2
    succeed(DECK, out=tmp_path / "first", **variables, steps=half, keep=half)
    again = {**variables, "from": tmp_path / "first" / f"restart.{half}", "begin": "resume"}
    succeed(DECK, ranks=2, out=tmp_path / "second", **again, steps=half)
    assert rows_of(tmp_path / "second")[-3:] == rows_of(one)[-3:]
    if "flexible" in variables["words"]:
        again["words"] = f"mass 4 inertia 2e-3 2e-2 {LOADED}"
        says = "the restart file has 8 modes of the shaft, but the deck has 0"
        refuses(DECK, says, out=tmp_path, **again, steps=1)
