# SPDX-License-Identifier: GPL-2.0-or-later
"""The results of `fix bearing/heat` are bitwise identical in all hosts, on several ranks, and after
a run has been stopped and continued. If heat is off, the fix has no effect."""

import re
import signal

import pytest
from host import ROOT, deck_file, start, succeed, wait_for_file
from recorded_runs import differ

POINT = dict(lubricant="vg46", rpm=1910, heat="yes", warm_time=60, passes=1, seat=3,
             housing_capacity=300, models="full", settle="auto")  # fmt: skip


def jumps(folder):
    """Return the table of time jumps as text (if any)."""
    table = folder / "heat.txt"
    return table.read_text() if table.exists() else ""


def differing(one, other):
    return differ(one, other) + ["jumps"] * (jumps(one) != jumps(other))


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    succeed("inputs/in.6208", out=folder, **POINT)
    return folder


@pytest.mark.parametrize(
    ("host", "ranks"), [("liggghts", 2), ("lammps", 1), ("wheel", 1), ("wheel", 2)]
)
def test_bits(tmp_path, whole, host, ranks):
    succeed("inputs/in.6208", out=tmp_path, host=host, ranks=ranks, **POINT)
    assert differing(whole, tmp_path) == []


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
def test_stopped_and_continued(tmp_path, whole, host):
    with start("inputs/in.6208", host=host, out=tmp_path, **POINT) as one:
        wait_for_file(tmp_path / "heat.txt", 800)
        one.send_signal(signal.SIGTERM)
    assert (tmp_path / "restart").exists()
    succeed("inputs/in.6208", out=tmp_path, host=host, resume="yes", **POINT)
    assert differing(whole, tmp_path) == []


def test_velocity_verlet(tmp_path):
    words = dict(POINT, integrator="verlet", rpm=5000, warm_time=3, settle=1)
    for ranks in (1, 2):
        succeed("inputs/in.6208", out=tmp_path / str(ranks), ranks=ranks, **words)
    assert differing(tmp_path / "1", tmp_path / "2") == []
    assert len(jumps(tmp_path / "1").splitlines()) > 2


def test_off_is_free(tmp_path):
    """If heat is off, the deck writes the same record as a deck without the fix."""
    text = (ROOT / "inputs/in.6208").read_text()
    without = re.sub(r"^fix heat (.*&\n)*.*\n", "", text, flags=re.M)
    assert "bearing/heat" in text and "bearing/heat" not in without
    words = dict(lubricant="vg46", rpm=1910, settle=1, passes=1, models="full")
    for name, path in (("off", "inputs/in.6208"), ("none", deck_file(tmp_path, without))):
        succeed(path, out=tmp_path / name, **words)
    assert differing(tmp_path / "off", tmp_path / "none") == []
    assert jumps(tmp_path / "off") == ""
