# SPDX-License-Identifier: GPL-2.0-or-later
"""By default, a finished run is not overwritten; it can be continued with more ball passes."""

import pytest
from host import ROOT, refuses, same_files, succeed

DECK = "inputs/in.6208"
SHORT = {"samples": 20, "rpm": 20000, "passes": 2}
COST = ("wall_s", "processor_s")  # these differ from run to run


@pytest.mark.parametrize("deck", ["in.6208", "in.dry", "in.nocage", "in.preload"])
def test_finished_run_stays(tmp_path, deck):
    scene = {**SHORT, "out": tmp_path, "clearance": 0}
    succeed(f"inputs/{deck}", **scene)
    before = (tmp_path / "record.nc").read_bytes()
    for more in ({}, {"passes": 3}, {"overwrite": "no"}):
        says = (
            f"{tmp_path} holds a finished run: give another -var out or -var overwrite yes, "
            "or more passes with -var resume yes"
        )
        refuses(f"inputs/{deck}", says, **{**scene, **more})
    assert (tmp_path / "record.nc").read_bytes() == before
    succeed(f"inputs/{deck}", overwrite="yes", **{**scene, "passes": 1})
    assert (tmp_path / "record.nc").read_bytes() != before


def test_finished_run_that_cannot_go_on(tmp_path):
    """The run has no restart file, for example because it was made by an older version."""
    succeed(DECK, out=tmp_path, **SHORT)
    (tmp_path / "restart").unlink()
    failed = refuses(DECK, "holds a finished run", out=tmp_path, resume="yes", **SHORT)
    assert "more passes" not in failed.error


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
@pytest.mark.parametrize("host", ["liggghts", "lammps"])
def test_more_passes(tmp_path, host, integrator):
    """The output of the continued run is identical, byte for byte, to that of a run that was this
    long from the start."""
    scene = {**SHORT, "integrator": integrator, "dumps": "yes", "unbalance": 1e-5}
    succeed(DECK, host=host, out=tmp_path / "whole", **{**scene, "passes": 5})
    for passes in (2, 3, 5):
        succeed(
            DECK, host=host, out=tmp_path / "parts", resume="yes", **{**scene, "passes": passes}
        )
    names = ("record.nc", "contacts.dump", "balls.dump", "rings.dat")
    same_files(tmp_path / "whole", tmp_path / "parts", *names)
    lines = [(tmp_path / way / "run.yaml").read_text().splitlines() for way in ("whole", "parts")]
    assert [line for line in lines[0] if not line.startswith(COST)] == [
        line for line in lines[1] if not line.startswith(COST)
    ]


def test_make_run_replaces_its_own():
    (rule,) = [
        line
        for line in (ROOT / "Makefile").read_text().splitlines()
        if "-in inputs/in.6208" in line
    ]
    assert rule.endswith("-var overwrite yes")
