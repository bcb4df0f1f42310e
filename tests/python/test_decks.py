# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway decks` copies every file that it lists, and never overwrites a user's file."""

from pathlib import Path

import pytest
from raceway import catalogue, decks, inputs
from raceway.cli import main

ROOT = Path(__file__).resolve().parents[2]


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
    assert main(["decks", "in.6208"]) == 0
    assert "in.6208: already exists" in capsys.readouterr().out


@pytest.mark.parametrize("name", ["6205", "7205B", "vg46"])
def test_data_to_edit(name, tmp_path):
    (path,) = decks.copy(name, tmp_path / "new")
    shelf = "lubricants" if name == "vg46" else "bearings"
    assert inputs.values(path) == inputs.values(ROOT / "inputs" / shelf / name)


def test_a_file_of_the_user_stays(tmp_path, capsys):
    mine = tmp_path / "inputs" / "bearings" / "6208"
    mine.parent.mkdir(parents=True)
    mine.write_text("mine\n")
    assert main(["decks", "in.6208", "--to", str(tmp_path)]) == 1
    assert f"{mine} exists with different text" in capsys.readouterr().err
    assert mine.read_text() == "mine\n" and not (tmp_path / "in.6208").exists()


def test_the_list_has_every_name(capsys):
    assert main(["decks"]) == 0
    said = capsys.readouterr().out
    assert all(name in said for name in [*decks.decks(), *decks.lubricants()])
    assert f"Bearings: {len(decks.bearings())}," in said
    assert main(["decks", "in.6207"]) == 1
    assert "there is no deck, bearing or lubricant 'in.6207'" in capsys.readouterr().err
