# SPDX-License-Identifier: GPL-2.0-or-later
"""The scenes under AddressSanitizer and UndefinedBehaviorSanitizer: the first finding ends the run with an error."""

import pytest
from host import frames, succeed


@pytest.mark.parametrize("lubricant", ["mineral", "dry"])
def test_bits_scene(tmp_path, lubricant):
    """Also the same bits as the plain build: the sanitizers change no arithmetic."""
    for name, sanitized in (("plain", False), ("checked", True)):
        succeed("tests/hosts/in.bits", sanitized=sanitized, out=tmp_path / name, lubricant=lubricant, tilt="free",
                keep=200)
    assert frames(tmp_path / "plain" / "balls.dump") == frames(tmp_path / "checked" / "balls.dump")


def test_two_ranks_and_resume(tmp_path):
    succeed("tests/hosts/in.bits", sanitized=True, ranks=2, out=tmp_path, first=200, write=1)
    succeed("tests/hosts/in.bits_resume", sanitized=True, ranks=2, out=tmp_path / "resumed",
            **{"from": tmp_path / "restart.200"})


@pytest.mark.parametrize("deck", ["6208", "preload", "nocage"])
def test_main_decks(tmp_path, deck):
    """With few, fast passes: 10 times the usual speed."""
    succeed(f"inputs/in.{deck}", sanitized=True, out=tmp_path, rpm=20000, passes=1, samples=20)


def test_axial_deck():
    succeed("inputs/in.axial", sanitized=True)
