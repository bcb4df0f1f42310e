# SPDX-License-Identifier: GPL-2.0-or-later
"""A run can be continued only with the same data with which it began."""

import math
import shutil

import pytest
from host import refuses, succeed

DECK = "inputs/in.6208"
SCENE = {"samples": 20, "record": "none", "flaw_outer": "file OUT/table.txt"}
DATA = {
    "viscosity": "0.05",
    "ball_young": "2e11",
    "roughness": "2e-7",
    "permittivity": "2.3",
    "inner_mass": "0.5",
    "balls": "8",
    "ball_density": "7000",
    "cage_ball_diameter": "8.3e-3",
    "flaw_inner": "wave 12 1.0e-7 0",
}


def table(height):
    """Return a table with twelve points of a raceway: azimuth in rad and height in m."""
    return "".join(f"{math.pi * k / 6:.12f} {height * (k % 2)}\n" for k in range(12))


def scene(folder):
    return {**SCENE, "flaw_outer": f"file {folder}/table.txt"}


@pytest.fixture(scope="module")
def begun(tmp_path_factory):
    folder = tmp_path_factory.mktemp("begun") / "run"
    folder.mkdir()
    (folder / "table.txt").write_text(table(1.0e-7))
    succeed(DECK, out=folder, passes=1, **scene(folder))
    return folder


@pytest.mark.parametrize("name", [None, "table", *DATA])
def test_other_data_are_refused(name, begun, tmp_path):
    folder = tmp_path / "run"
    shutil.copytree(begun, folder)
    if name == "table":
        (folder / "table.txt").write_text(table(1.1e-7))
    changed = {name: DATA[name]} if name in DATA else {}
    words = {"out": folder, "passes": 2, "resume": "yes", **scene(folder), **changed}
    if name is None:
        assert "Measured 2 ball passes" in succeed(DECK, **words).text
    else:
        refuses(DECK, "belongs to another run", changed.get(name) or "a file, checksum", **words)
