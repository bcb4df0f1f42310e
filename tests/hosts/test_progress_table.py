# SPDX-License-Identifier: GPL-2.0-or-later
"""`fix bearing/progress` prints a table for a run, with names, units, the finished fraction and the
remaining time."""

import re

import pytest
import raceway
from host import QUICK, deck_file, refuses, succeed

SHORT = {"passes": 4, "samples": 200, "rpm": 20000}
HEAD = ["done", "%", "left", "s", "step", "time", "s", "ring", "um", "loaded", "load", "N"]
HEAD += ["p", "GPa", "cage", "rad/s"]


def table(text, title):
    """Return the rows of numbers in the table that follows `title`."""
    lines = text.split(title + "\n")[1].splitlines()
    assert lines[0].split() == HEAD
    rows = []
    for line in lines[1:]:
        if len(words := line.split()) == 9 and all(
            re.fullmatch(r"[-\d.]+", word) for word in words
        ):
            rows.append([float(word) if word != "-" else None for word in words])
    return rows


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("ranks", [1, 2])
def test_main_deck(tmp_path, host, ranks):
    end = succeed("inputs/in.6208", host=host, ranks=ranks, out=tmp_path, **SHORT)
    rows = table(end.text, "Measuring")
    assert [row[0] for row in rows] == sorted(row[0] for row in rows)
    done, left, step, time, ring, loaded, load, pressure, cage = rows[-1]
    assert (done, left, step) == (100.0, 0.0, 80)
    run = raceway.open(tmp_path)
    last = run.contacts.isel(time=-1)
    assert load == pytest.approx(float(last["load"].max()), rel=1e-4)
    assert pressure == pytest.approx(1e-9 * float(last["pressure"].max()), rel=1e-3)
    assert cage == pytest.approx(0.4 * SHORT["rpm"] * 3.14159 / 30, rel=0.05)
    place = run.rings.isel(time=-1)
    assert ring == pytest.approx(1e6 * float((place.x**2 + place.y**2) ** 0.5), abs=1e-3)
    assert loaded >= 1
    settled = table(end.text.split("Measuring\n")[0], "Settling")[-1]
    assert time > settled[3] > 0.01  # s: time advances


def test_a_cage_is_not_a_ring(tmp_path):
    # nothing centres the cage of this bearing, so it moves farther than the inner ring
    options = {**SHORT, "load": 100, "rpm": 6000, "cage": "ring", "cage_play": 1e-3}
    end = succeed("inputs/in.6208", out=tmp_path, **options)
    run = raceway.open(tmp_path)
    place = run.rings.isel(time=-1)
    ring = 1e6 * float((place.x**2 + place.y**2) ** 0.5)
    assert table(end.text, "Measuring")[-1][4] == pytest.approx(ring, abs=1e-3)
    assert 1e6 * float(abs(run.cage.isel(time=-1).x)) > 2 * ring


def test_settling_with_verlet_is_one_table(tmp_path):
    end = succeed("inputs/in.6208", out=tmp_path, integrator="verlet", **{**SHORT, "passes": 1})
    assert end.text.count("done %") == 2
    shares = [row[0] for row in table(end.text.split("Measuring\n")[0], "Settling")]
    assert shares == sorted(shares) and 0.0 <= shares[0] and 90 < shares[-1] <= 100.0


def test_needs_its_compute(tmp_path):
    deck = deck_file(
        tmp_path, "include inputs/in.6208\nfix more all bearing/progress 10 nothing\nrun 0\n"
    )
    says = "fix more bearing/progress: there is no compute bearing/total 'nothing'"
    refuses(deck, says, out=tmp_path / "run", **{**SHORT, **QUICK, "passes": 1})
