# SPDX-License-Identifier: GPL-2.0-or-later
"""The tests that docs/validation.rst names for T1 to T12 exist, and its torques with each law for
asperities are those of statics."""

import re

import numpy as np
import pytest
from host import ROOT
from raceway.theory import asperity, operating_point

PAGE = (ROOT / "docs/validation.rst").read_text()
STRAIGHT = {"rx": 0.0, "ry": 0.0}
ROW = re.compile(r"\* - (T\d+)\n +- .*\n +- ``(.*)``\n +- ``(.*)``")
ROWS = ROW.findall(PAGE)


def test_all_are_there():
    assert [row[0] for row in ROWS] == [f"T{number}" for number in range(1, 13)]


@pytest.mark.parametrize(("number", "engine", "package"), ROWS)
def test_named_tests_exist(number, engine, package):
    """The cells contain entries `file: names`, separated by semicolons, where each name is part of
    the name of a test."""
    for folder, words in (("tests/physics", engine), ("tests/python", package)):
        for one in words.split("; "):
            name, _, wanted = one.partition(": ")
            path = ROOT / ("tests" if "/" in name else folder) / f"{name}.py"
            tests = re.findall(r"^def test_(\w+)", path.read_text(), re.M)
            for part in filter(None, wanted.split(", ")):
                assert any(part in test for test in tests), (one, part)


LAWS = re.compile(r'^   "[^"]*", "([\d.]+), ([\d.]+)", (\d+), (\d+)$', re.M)


@pytest.mark.parametrize(
    ("row", "law"),
    list(enumerate([asperity.zhou_hoeprich, asperity.olver_spikes, asperity.clarke, None])),
)
def test_sensitivity_to_the_asperity_law(monkeypatch, row, law):
    """The rows list load fractions of asperities and torques due to slip (N mm) at two speeds; the
    last row assumes that the fraction is the same in all contacts."""
    section = PAGE.split(".. _asperity-laws:")[1]
    *shares, slow, fast = map(float, LAWS.findall(section)[row])
    for rpm, share, torque in ((48, shares[0], slow), (477.5, shares[1], fast)):
        constant = law or (lambda ratio, share=share: np.full(np.shape(ratio), share))
        monkeypatch.setattr(asperity, "clarke", constant)
        found = operating_point.figures("6208", "mineral", load=5000.0, rpm=rpm, held=STRAIGHT)
        assert found["asperity_share"] == pytest.approx(share, abs=0.006)
        slip = 1e3 * found["losses_W"]["slip"] / (rpm * np.pi / 30)
        assert slip == pytest.approx(torque, abs=0.6)
