# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway decks` copies every file that it lists, and never overwrites a user's file."""

import pytest
from commands import reply
from host import ROOT
from raceway import catalogue, decks, inputs
from raceway.cli import main


def test_a_deck_comes_with_all_that_it_reads(tmp_path, capsys, monkeypatch):
    for name in decks.decks():
        assert main(["decks", name, "--to", str(tmp_path)]) == 0
        assert (tmp_path / name).read_text() == (ROOT / "inputs" / name).read_text()
    wanted = {path.relative_to(ROOT / "inputs") for path in (ROOT / "inputs").rglob("*")}
    assert {path.relative_to(tmp_path / "inputs") for path in (tmp_path / "inputs").rglob("*")} == (
        wanted
    )
    monkeypatch.chdir(tmp_path)
    assert catalogue.folder() == tmp_path / "inputs"
    assert "in.6208: already exists" in reply(capsys, "decks in.6208")


@pytest.mark.parametrize("name", ["6205", "7205B", "vg46"])
def test_data_to_edit(name, tmp_path):
    (path,) = decks.copy(name, tmp_path / "new")
    shelf = "lubricants" if name == "vg46" else "bearings"
    assert inputs.values(path) == inputs.values(ROOT / "inputs" / shelf / name)


def test_a_file_of_the_user_stays(tmp_path, capsys):
    mine = tmp_path / "inputs" / "bearings" / "6208"
    mine.parent.mkdir(parents=True)
    mine.write_text("mine\n")
    assert f"{mine} exists with different text" in reply(
        capsys, ["decks", "in.6208", "--to", tmp_path], code=1
    )
    assert mine.read_text() == "mine\n" and not (tmp_path / "in.6208").exists()


def test_the_list_has_every_name(capsys):
    said = reply(capsys, "decks")
    assert all(name in said for name in [*decks.decks(), *decks.lubricants()])
    assert f"Bearings: {len(decks.bearings())}," in said
    assert "there is no deck, bearing or lubricant 'in.6207'" in reply(
        capsys, "decks in.6207", code=1
    )
