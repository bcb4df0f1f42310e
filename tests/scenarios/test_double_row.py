# SPDX-License-Identifier: GPL-2.0-or-later
"""In docs/decks/in.double_row, two preloaded rows under a radial force, a thrust and a moment agree
with statics."""

import numpy as np
import pytest
from host import succeed
from raceway import catalogue, inputs, static
from raceway.theory.bearing import DoubleRow

BEARING = inputs.bearing(catalogue.find("bearings", "7208"))
ANGLE, PRELOAD = np.radians(40), 5e-6
CAGE = 2 * np.pi * 10 * (1 - 5.95 / 30 * np.cos(ANGLE)) / 2  # rad/s, at 600 rpm
ARRANGEMENTS = {
    "back_to_back": {},
    "face_to_face": {"first": "minus", "second": "plus", "preload": -PRELOAD},
}


@pytest.fixture(scope="module")
def rows(tmp_path_factory):
    """Return {arrangement: (y in m, z in m, tilt in rad)}, where the values are means over the last
    15 ms, i.e. over most of a ball pass."""
    found = {}
    for name, variables in ARRANGEMENTS.items():
        folder = tmp_path_factory.mktemp(name)
        succeed("docs/decks/in.double_row", out=folder, **variables)
        found[name] = np.loadtxt(folder / "line.dat")[-15:, 1:].mean(axis=0)
    return found


@pytest.mark.parametrize("arrangement", ARRANGEMENTS)
def test_statics(rows, arrangement):
    two = BEARING.double_row(DoubleRow(0.018, PRELOAD, arrangement), ANGLE)
    loads = {"load_azimuth": -np.pi / 2, "moment": (10, 0)}
    rest = static.equilibrium(two, 1000, 300, **loads, orbital_speed=CAGE)
    assert rows[arrangement] == pytest.approx([*rest.shift[1:], rest.tilt[0]], rel=1e-2)
