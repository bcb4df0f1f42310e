# SPDX-License-Identifier: GPL-2.0-or-later
"""A summary warns if a contact ellipse extends beyond the shoulder of its groove, provided that the
bearing file contains shoulder diameters."""

import pytest
import raceway
from host import succeed

CASES = {
    "far up the groove": ({"axial": 20000}, True),
    "at its bottom": ({}, False),
    "shoulders not known": (
        {"axial": 20000, "inner_shoulder_diameter": 0, "outer_shoulder_diameter": 0},
        False,
    ),
}


@pytest.mark.parametrize("variables, warned", CASES.values(), ids=CASES)
def test_shoulder(variables, warned, tmp_path):
    succeed(
        "inputs/in.6208",
        out=tmp_path,
        load=1000,
        clearance=2e-5,
        passes=1,
        settle=0,
        samples=20,
        **variables,
    )
    warnings = [text for text in raceway.open(tmp_path).summary()["warnings"] if "shoulder" in text]
    assert bool(warnings) == warned
    contacts = raceway.open(tmp_path).contacts
    if warned:  # the warning uses the largest angle and the longest ellipse of all samples
        assert warnings[0].startswith("the contact ellipse of the inner raceway reaches")
        assert float(abs(contacts.angle).max()) > 0.4
