# SPDX-License-Identifier: GPL-2.0-or-later
"""Scenes are run under AddressSanitizer and UndefinedBehaviorSanitizer, either of which stops the
run at its first finding."""

import pytest
from host import ROOT, deck_file, frames, same_files, succeed


@pytest.mark.parametrize("lubricant", ["mineral", "dry"])
def test_bits_scene(tmp_path, lubricant):
    """The results are bitwise identical to those of the plain build, because sanitizers do not
    change the arithmetic."""
    for name, sanitized in (("plain", False), ("checked", True)):
        succeed(
            "tests/hosts/in.bits",
            sanitized=sanitized,
            out=tmp_path / name,
            lubricant=lubricant,
            tilt="free",
            keep=200,
        )
    assert frames(tmp_path / "plain" / "balls.dump") == frames(tmp_path / "checked" / "balls.dump")


def test_two_ranks_and_resume(tmp_path):
    succeed("tests/hosts/in.bits", sanitized=True, ranks=2, out=tmp_path, first=200, write=1)
    succeed(
        "tests/hosts/in.bits_resume",
        sanitized=True,
        ranks=2,
        out=tmp_path / "resumed",
        **{"from": tmp_path / "restart.200"},
    )


@pytest.mark.parametrize("deck", ["6208", "preload", "nocage"])
def test_main_decks(tmp_path, deck):
    """A few passes are run at 20,000 rpm."""
    succeed(f"inputs/in.{deck}", sanitized=True, out=tmp_path, rpm=20000, passes=1, samples=20)


def test_axial_deck(tmp_path):
    """Only the first steps after each change in the force are run."""
    text = (ROOT / "inputs" / "in.axial").read_text()
    deck = deck_file(tmp_path, text.replace("run 25000\n", "run 2500\n"), "in.axial")
    assert text.count("run 25000\n") == 4
    succeed(deck, sanitized=True)


@pytest.mark.parametrize("ranks", [1, 2])
def test_implicit(tmp_path, ranks):
    """Two bearings, one of which is cut by the boundary between two ranks, run through a transient
    with rejected steps, and then continue from a restart file."""
    deck, case = "tests/implicit/in.ranks", {"bearings": 2, "xlo": -0.15, "xhi": 0.18}
    succeed(deck, sanitized=True, ranks=ranks, out=tmp_path, keep=20, **case)
    succeed(
        deck,
        sanitized=True,
        ranks=ranks,
        out=tmp_path / "resumed",
        begin="resume",
        first=40,
        bearings=2,
        **{"from": tmp_path / "restart.20"},
    )
    succeed(deck, out=tmp_path / "plain", **case)
    plain = frames(tmp_path / "plain" / "balls.dump")
    assert frames(tmp_path / "balls.dump") == plain
    assert frames(tmp_path / "resumed" / "balls.dump")[60] == plain[60]


@pytest.mark.parametrize("integrator, step", [("implicit", 2.5e-4), ("verlet", 4e-7)])
def test_many(tmp_path, integrator, step):
    """Several rings have values and tables on two ranks, and the cut between the ranks passes
    through two of the six bearings."""
    case = {
        "bearings": 6,
        "columns": 3,
        "integrator": integrator,
        "step": step,
        "sample": 4 * step,
        "time": 12 * step,
        "ramp": step,
    }
    succeed("inputs/in.many", sanitized=True, ranks=2, out=tmp_path / "checked", **case)
    succeed("inputs/in.many", out=tmp_path / "plain", **case)
    same_files(tmp_path / "checked", tmp_path / "plain", "bearings.dump", read=frames)
