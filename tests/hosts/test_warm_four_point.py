# SPDX-License-Identifier: GPL-2.0-or-later
"""The temperatures of two four-point bearings jump while they are recorded. The record is the same
in all hosts, on any number of ranks, in any order of the fixes, and for any division of the run."""

import re

import pytest
from host import deck_file, succeed
from recorded_runs import bytes_of
from scipy.io import netcdf_file

FIXES = {
    "cages": "fix cage_p cage_p bearing/cage/ring p\nfix cage_q cage_q bearing/cage/ring q",
    "rings": "fix inner inner bearing/ring mass 0.3 x free y free spin speed 300 force 0 -3000 0\n"
    "fix pushed pushed bearing/ring mass 0.3 x free y free z free spin speed 300 "
    "force 0 -900 1500",
    "heat p": "fix heat_p balls_p bearing/heat cooling 0.5",
    "heat q": "fix heat_q balls_q bearing/heat cooling 0.8",
    "move": "fix move all bearing/implicit",
}
AMBIENT = 20.0  # C, where temperatures begin by default
BEGIN = """boundary f f f
region box block -0.06 0.06 -0.06 0.06 -0.05 0.11 units box
create_box 8 box"""
GROUPS = "\n".join(
    f"group {name} type {types}"
    for name, types in {
        "balls_p": 1, "cage_p": 2, "inner": 3, "balls_q": 5, "cage_q": 6, "pushed": 7
    }.items()
)  # fmt: skip
DECK = """bearing p 6205 types 1 2 3 4 four_point 25 cage ring
bearing q 6208 types 5 6 7 8 four_point 30 cage ring clearance 1.0e-5
units si
atom_style sphere
atom_modify map array sort 0 0.0
newton off
{begin}
neighbor 2.0e-3 bin
neigh_modify delay 0 every 1 check yes
pair_style bearing oil vg46 models full
pair_coeff * * p
pair_coeff * * q
create_bearing p centre 0.004 0.003 0 speed 300 0 groups no
create_bearing q centre 0.004 0.003 0.06 speed 300 0 thrust 1500 groups no
{groups}
{fixes}
fix cap_p balls_p bearing/capacitance 2 surroundings flooded
fix cap_q balls_q bearing/capacitance 2 surroundings flooded
fix record all bearing/record 2 ${{out}} overwrite yes
timestep 1.0e-4
{runs}
"""


def record(folder, fixes=tuple(FIXES), begin=BEGIN, runs="run 400", **options):
    """Run the deck and return the variables of its record and the commands of its pair style."""
    words = {"fixes": "\n".join(FIXES[name] for name in fixes), "begin": begin, "groups": GROUPS}
    folder.mkdir(exist_ok=True)
    deck = deck_file(folder, DECK.format(**words, runs=runs))
    succeed(deck, out=folder, **options)
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        oil = file.variables["bearing_temperature_oil"].data
        assert len(set(oil[:, 0])) > 2 and len(set(oil[:, 1])) > 2, "temperatures have not jumped"
        commands = file.pair_commands
    found = bytes_of(folder)
    del found["checksum"]  # that of the header, which names the host
    return found | {"commands": commands}


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    return record(tmp_path_factory.mktemp("whole"))


@pytest.mark.parametrize(
    ("host", "ranks"), [("liggghts", 2), ("lammps", 1), ("wheel", 1), ("sanitized", 1)]
)
def test_hosts(tmp_path, whole, host, ranks):
    assert record(tmp_path, host=host, ranks=ranks) == whole


@pytest.mark.parametrize("first", [101, 250, 333])
def test_two_runs(tmp_path, whole, first):
    assert record(tmp_path, runs=f"run {first}\nrun 400 upto") == whole


@pytest.mark.parametrize("first", [100, 300])
def test_a_restart(tmp_path, whole, first):
    """The header describes the oil with which the record began."""
    file = tmp_path / "restart"
    assert record(tmp_path, runs=f"run {first}\nwrite_restart {file}\nrun 400 upto") == whole
    assert record(tmp_path, begin=f"read_restart {file}", runs="run 400 upto", ranks=2) == whole


@pytest.mark.parametrize("order", [(4, 3, 2, 1, 0), (1, 0, 3, 2, 4), (2, 4, 0, 1, 3)])
def test_the_order_of_the_fixes(tmp_path, whole, order):
    """A cage follows the rings of its own bearing out of their plane wherever its fix is."""
    names = list(FIXES)
    assert record(tmp_path, fixes=[names[k] for k in order]) == whole


def test_a_bearing_that_is_heated_later(tmp_path):
    """A bearing warms up even if it is heated only after another one has become steady, which keeps
    its temperature."""
    fixes = "\n".join(FIXES[name] for name in ("rings", "heat q", "move"))
    tell = 'print "{} $(f_heat_q) $({})"\n'
    runs = f"run 15000\n{tell.format('FIRST', 0)}{FIXES['heat p']}\nrun 3000\n"
    text = DECK.format(
        begin=BEGIN, groups=GROUPS, fixes=fixes, runs=runs + tell.format("LATER", "f_heat_p")
    )
    text = re.sub(r"(?m)^fix (cap|record).*\n", "", text).replace("cage ring", "cage no")
    text = re.sub(r"cooling 0\.\d", "cooling 5", text)
    done = succeed(deck_file(tmp_path, text))
    found = re.findall(r"(?m)^(?:FIRST|LATER) (\S+) (\S+)", done.text)
    (steady, _), (kept, later) = ((float(a), float(b)) for a, b in found)
    assert kept == steady > AMBIENT
    assert later > AMBIENT
