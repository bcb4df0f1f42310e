# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the main deck with a tolerance relative to the largest overlap."""

import pytest
from host import refuses, succeed
from raceway.runs.run import Run

SCENE = {"passes": 2, "samples": 20, "load": 5000}


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Return {share: folder of the run}."""
    folder = tmp_path_factory.mktemp("relative")
    for share in (0, 5e-4, 2e-3):
        succeed("inputs/in.6208", out=folder / f"{share:g}", relative_tolerance=share, **SCENE)
    succeed("inputs/in.6208", out=folder / "fine", tolerance=1e-11, **SCENE)
    return folder


def test_fewer_evaluations_and_exact_loads(runs):
    """Steps may have an error of R times the largest overlap, so loads have an error of at most 1.5
    R times the largest load."""
    exact = Run(runs / "fine").contacts["load"]
    evaluations = []
    for share in (0, 5e-4, 2e-3):
        ran = Run(runs / f"{share:g}")
        evaluations.append(ran.settings["evaluations"])
        off = float(abs(ran.contacts["load"] - exact).max() / exact.max())
        assert off < max(1e-3, 1.5 * share), share
    assert evaluations[0] > 1.3 * evaluations[1] > 1.3 * evaluations[2]


def test_light_loads_keep_the_tolerance(tmp_path):
    """A load of 5 N causes an overlap of 0.2 um. Since 5e-4 of this overlap is below 1 nm, the
    results are bitwise identical."""
    for share in (0, 5e-4):
        out = tmp_path / f"{share}"
        words = {**SCENE, "load": 5, "rpm": 100, "settle": 2, "lubricant": "dry"}
        succeed("inputs/in.6208", out=out, relative_tolerance=share, **words)
    loads = [Run(tmp_path / f"{share}").contacts["load"] for share in (0, 5e-4)]
    assert loads[0].equals(loads[1])


def test_goes_on_to_the_same_bits(tmp_path, runs):
    words = {**SCENE, "relative_tolerance": 5e-4, "out": tmp_path}
    succeed("inputs/in.6208", **{**words, "passes": 1})
    succeed("inputs/in.6208", resume="yes", **words)
    assert (tmp_path / "record.nc").read_bytes() == (runs / "0.0005" / "record.nc").read_bytes()


def test_refused(tmp_path):
    words = {**SCENE, "relative_tolerance": 1e-4, "integrator": "damping"}
    says = "relative is 0.0001, must be 0 with 'solve damping'"
    refuses("inputs/in.6208", says, out=tmp_path, **words)
