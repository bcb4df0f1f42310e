# SPDX-License-Identifier: GPL-2.0-or-later
"""inputs/in.6208 written in plain commands: with models paper, results are bitwise identical to
those of an earlier program, and with the defaults a run settles by itself."""

import hashlib

import pytest
import raceway
from host import ROOT, succeed
from scipy.io import netcdf_file

SAME = dict(models="paper", settle=1, passes=1, samples=100)
FLAWS = dict(
    flaw_outer="notch -1.5 1.0e-3 full 1.0e-4 5.0e-5",
    flaw_ball="wave 12 2.0e-7 0.2",
    flawed_ball="2 5",
)
# {name: (variables of a run with `models paper`, digest of the record that was written by the
# program and deck of commit a7b5052)}
CASES = {
    "radial load": ({}, "03f184de03b1a1a0"),
    "combined load": (
        dict(lubricant="vg46", temperature=60, axial=1000, moment_x=5),
        "c1bba69a9a4ad7df",
    ),
    "given viscosity": (dict(viscosity=0.05, clearance=1e-05), "48b662d50290fc60"),
    "preload": (dict(clearance=-5.67e-05), "7fb7e1eb3ce91580"),
    "dry": (dict(lubricant="dry", rpm=100), "37f51ed9792c3416"),
    "no cage": (dict(cage="no"), "77c0f1b74681c5be"),
    "angular contact": (dict(bearing="7205B", axial=1000), "171671efe0bac934"),
    "flaws": (FLAWS, "64858357215473fa"),
    "housing": (
        dict(housing="springs", surroundings="flooded", unbalance=1e-05),
        "a83b66eca3d056e8",
    ),
    "damping": (dict(integrator="damping"), "adc67cceff66f53d"),
    "vibration": (dict(integrator="vibration", samples=200), "b34d453ae1c80999"),
    "velocity Verlet": (dict(integrator="verlet", rpm=5000), "ebadcd956696ab21"),
}
# variables that records did not yet contain at a7b5052
LATER = {"checksum", "bearing_cage_power", "bearing_cage_force"}


def values(folder):
    """Return the variables of a record as bytes, with the signs of zeros removed."""
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        return {
            name: (one.data + 0.0 if one.data.dtype.kind == "f" else one.data).tobytes()
            for name, one in file.variables.items()
        }


def digest(folder):
    """Return a digest of the variables that records already contained at a7b5052."""
    known = sorted((name, data) for name, data in values(folder).items() if name not in LATER)
    total = hashlib.sha256()
    for name, data in known:
        total.update(name.encode() + data)
    return total.hexdigest()[:16]


@pytest.mark.parametrize("name", CASES)
def test_bits_of_the_paper(tmp_path, name):
    case, bits = CASES[name]
    succeed("inputs/in.6208", out=tmp_path, **{**SAME, **case})
    assert digest(tmp_path) == bits


def test_settles_by_itself(tmp_path):
    """With the defaults, i.e. `settle auto` and models full, the record states to what extent the
    run has settled."""
    succeed("inputs/in.6208", out=tmp_path, passes=1, models=None, settle=None)
    found = raceway.open(tmp_path)
    assert found.settings["models"] == "full" and found.settings["settled_passes"] >= 2
    assert found.settings["rest_torque"] < 1e-2 and found.settings["rest_load"] < 1e-3


def test_plain():
    """The deck has at most 60 lines and does not include another deck."""
    lines = (ROOT / "inputs/in.6208").read_text().splitlines()
    assert len(lines) <= 60
    assert not [line for line in lines if line.startswith("include")]
