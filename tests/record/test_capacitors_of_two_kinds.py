# SPDX-License-Identifier: GPL-2.0-or-later
"""Between the steps, every bearing has the capacitors of its own fix bearing/capacitance. Two
bearings of different sizes and oils in a deck have bitwise the same capacitances as each alone, and
so have two bearings on a shaft if only one of them has capacitors."""

import numpy as np
import pytest
from host import box, deck_file, liggghts, refused, succeed
from scipy.io import netcdf_file

KINDS = {
    "left": "6208 types 1 2 3 4",
    "right": "6306 types 5 6 7 8",
}
PLACE = {"left": "0", "right": "0.12"}
OILS = {"left": "vg46", "right": "pao8"}
COLUMNS = ("capacitance", "capacitance_total", "h_c")


def deck(names):
    lines = [f"bearing {name} {KINDS[name]} cage no" for name in names]
    lines += [box("-0.06 0.2 -0.06 0.06 -0.06 0.06", types=8)]
    lines += ["pair_style bearing oil vg46 temperature 60 models full"]
    lines += [f"pair_coeff * * {name} oil {OILS[name]}" for name in names]
    lines += [f"create_bearing {name} centre {PLACE[name]} 0 0 speed 200 0" for name in names]
    for name in names:
        balls, inner = KINDS[name].split()[2], KINDS[name].split()[4]
        lines += [
            f"group {name} type {balls}",
            f"group inner_{name} type {inner}",
            f"fix inner_{name} inner_{name} bearing/ring mass 0.2 x free y free spin speed 200 "
            "force 0 -2000 0 ramp 1e-3",
            f"fix c_{name} {name} bearing/capacitance 1 surroundings flooded",
        ]
    lines += ["fix move all bearing/implicit"]
    lines += ["fix record all bearing/record 1 ${out} within 5", "timestep 1e-4", "run 40", ""]
    return "\n".join(lines)


def read(folder, number):
    """Return the contacts of one of the bearings in a record, keyed by the columns in it."""
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        mine = file.variables["ball_bearing"].data == number
        names = [name for name in COLUMNS if name in file.variables]
        return {name: file.variables[name].data[..., mine] for name in names}


def capacitances(folder, number):
    """Return the values of one of the bearings in a record, and all totals of it."""
    values = read(folder, number)
    assert set(values) == set(COLUMNS)
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        total = file.variables["bearing_capacitance_total"].data
        return values | {"total": total[:, number - 1]}


def test_together_and_alone(tmp_path):
    succeed(deck_file(tmp_path, deck(KINDS)), out=tmp_path / "both")
    for number, name in enumerate(KINDS, 1):
        succeed(deck_file(tmp_path, deck([name])), out=tmp_path / name)
        together = capacitances(tmp_path / "both", number)
        alone = capacitances(tmp_path / name, 1)
        for key in together:
            np.testing.assert_array_equal(together[key], alone[key], key)
        assert np.nanmax(together["total"]) > 1e-11  # F


def shaft(names, surroundings):
    """Return a deck with both bearings on a shaft, of which those in `names` have capacitors."""
    lines = [line for line in deck(KINDS).splitlines() if "bearing/ring" not in line]
    for name in KINDS:
        at = next(k for k, line in enumerate(lines) if line.startswith(f"fix c_{name} "))
        lines[at] = lines[at].replace("surroundings flooded", surroundings[name])
        if name not in names:
            del lines[at]
    at = next(k for k, line in enumerate(lines) if line.startswith("fix move"))
    lines[at:at] = [
        "group inner type 3 7",
        "fix shaft inner bearing/shaft mass 3 inertia 2e-3 1.5e-2 y free z free ry free rz free "
        "spin speed 200 load 0.05 0 -3000 500 ramp 1e-3",
    ]
    return "\n".join([*lines, ""]).replace("temperature 60", "temperature 60 axis x")


@pytest.mark.parametrize(
    "surroundings",
    [
        dict.fromkeys(KINDS, "surroundings flooded"),
        {"left": "", "right": "surroundings dry film_floor 2e-9"},
    ],
    ids=["flooded", "plates"],
)
def test_on_a_shaft(tmp_path, surroundings):
    succeed(deck_file(tmp_path, shaft(KINDS, surroundings)), out=tmp_path / "both")
    for number, name in enumerate(KINDS, 1):
        succeed(deck_file(tmp_path, shaft([name], surroundings)), out=tmp_path / name)
        both, own = (read(tmp_path / folder, number) for folder in ("both", name))
        for key in own:
            np.testing.assert_array_equal(both[key], own[key], key)
        assert np.nanmax(own["capacitance"]) > 1e-11  # F


@pytest.mark.parametrize("balls", ["1:3", "1:9"])
def test_two_models_in_one_bearing(tmp_path, balls):
    """Balls of one bearing cannot have different models, whether or not the groups overlap."""
    usual = "fix c_left left bearing/capacitance 1 surroundings flooded\n"
    text = deck(["left"])
    assert usual in text
    other = "rest" if balls == "1:3" else "left"
    text = text.replace(
        usual,
        f"group some id {balls}\ngroup rest subtract left some\n"
        "fix d some bearing/capacitance 1 surroundings dry\n"
        f"fix e {other} bearing/capacitance 1 surroundings flooded\n",
    )
    end = liggghts(deck_file(tmp_path, text), out=tmp_path)
    refused(end, "two fixes request different data between the steps of fix move")
