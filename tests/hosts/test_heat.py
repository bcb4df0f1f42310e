# SPDX-License-Identifier: GPL-2.0-or-later
"""The results of `fix bearing/heat` are bitwise identical in all hosts, on several ranks, and after
a run has been stopped and continued. If heat is off, the fix has no effect."""

import re
import signal

import pytest
from host import ROOT, deck_file, named_bearing, start, succeed, wait_for_file
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


@pytest.mark.parametrize("again, times", [("", 1), (None, 0), ("fix heat all bearing/heat", 0)])
def test_a_fix_that_is_deleted_takes_its_temperatures_along(tmp_path, again, times):
    """The oil of the pair style at its temperature and the cold parts are back, as the run says."""
    end = "" if again is None else f"unfix heat\n{again}\n"
    deck = (
        named_bearing(clearance="-4.0e-6", neighbor="2.0e-3 bin", every=1)
        + f"""
create_bearing b speed 50 0
fix rails cage bearing/cage b
fix inner inner bearing/ring spin speed 50
fix move all bearing/implicit
compute films balls bearing/ball inner_h_min
compute film balls reduce min c_films
thermo_style custom step c_film
timestep 2.0e-5
run 20
fix heat all bearing/heat ambient 20
run 20
{end}run 20
run 20
"""
    )
    found = succeed(deck_file(tmp_path, deck)).text
    said = "WARNING: pair_style bearing: fix bearing/heat of bearing b is gone: the oil has its"
    assert found.count(said) == times
    rows = re.findall(r"^ +(\d+) +(\S+) *$", found, re.M)
    film = {int(a): float(b) for a, b in reversed(rows)}  # at the end of each run
    assert film[40] > 2 * film[20]
    assert (film[80] < 1.1 * film[20]) == bool(times)
