# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of input that was once accepted, or rejected with the wrong message: bearing and lubricant
data, words that only C reads as numbers, and paths that are not files."""

import re

import pytest
from host import ROOT, liggghts, refused
from raceway.sweeps.variable_table import rows

BEARING = (ROOT / "inputs" / "bearings" / "6208").read_text()
OF_BEARING = [row["name"] for row in rows() if row["of"] == "bearing data" and not row["default"]]
MINERAL = (ROOT / "inputs" / "lubricants" / "mineral").read_text()


def inputs(tmp_path, folder, name, text):
    """Return an inputs folder that contains one additional file."""
    own = tmp_path / "inputs"
    own.mkdir()
    for path in (ROOT / "inputs").iterdir():
        if path.name != folder:
            (own / path.name).symlink_to(path)
    (own / folder).mkdir()
    if text is not None:
        (own / folder / name).write_text(text)
    return own


def without(text, key):
    return re.sub(rf"^variable {key} .*\n", "", text, flags=re.MULTILINE)


@pytest.mark.parametrize("key", OF_BEARING)
def test_a_key_that_a_bearing_does_not_have(tmp_path, key):
    own = inputs(tmp_path, "bearings", "mine", without(BEARING, key))
    end = liggghts("inputs/in.6208", inputs=own, bearing="mine", out=tmp_path / "out")
    refused(end, rf"bearing: '{own}/bearings/mine' has no variable {key}\b")


def test_a_lubricant_without_viscosity(tmp_path):
    own = inputs(tmp_path, "lubricants", "mine", without(MINERAL, "viscosity"))
    end = liggghts("inputs/in.6208", inputs=own, lubricant="mine", out=tmp_path / "out")
    refused(end, rf"pair_style bearing: '{own}/lubricants/mine' has no variable viscosity\b")


def test_a_lubricant_for_a_bearing(tmp_path):
    end = liggghts("inputs/in.6208", bearing="../lubricants/mineral", out=tmp_path)
    refused(end, r"'inputs/bearings/../lubricants/mineral' has no variable balls, ball_diameter")


def test_files_that_are_none(tmp_path):
    own = inputs(tmp_path, "bearings", "mine", "\ufeff" + BEARING)
    (own / "bearings" / "loop").symlink_to("loop")
    (own / "bearings" / "folder").mkdir()
    for name, message in (
        ("mine", r"mine' starts with a byte order mark"),
        ("loop", r"loop' is not a file but a folder, a pipe or a broken link"),
        ("folder", r"folder' is not a file but a folder, a pipe or a broken link"),
    ):
        end = liggghts("inputs/in.6208", inputs=own, bearing=name, out=tmp_path / "out")
        refused(end, message)


@pytest.mark.parametrize("name", ["a b", "a%b", "a*b"])
def test_names_of_folders(tmp_path, name):
    refused(
        liggghts("inputs/in.6208", out=f"{tmp_path}/{name}"),
        r"bearing_resume: (a folder's name is one word without blanks, not '\S+ b/restart'"
        r"|the folder's name '\S+' may not contain any of)",
    )
    assert not list(tmp_path.iterdir())


def test_a_file_called_like_an_option_stays(tmp_path):
    """A file named -f in the current folder was once taken for an option by the host's `rm`."""
    for name in ("inputs",):
        (tmp_path / name).symlink_to(ROOT / name)
    (tmp_path / "-f").write_text("mine")
    end = liggghts(
        ROOT / "inputs" / "in.dry", cwd=tmp_path, out=tmp_path / "out", passes=1, samples=10
    )
    assert end.code == 0, end.text[-1000:]
    assert (tmp_path / "-f").read_text() == "mine"


def test_a_file_that_the_checkpoint_sees_too_often(tmp_path):
    """The file is written every 200 steps but checked every 20 steps, so it often does not grow
    between checks; this does not mean that the disk is full."""
    deck = tmp_path / "in.often"
    text = (ROOT / "docs" / "decks" / "in.ehd").read_text()
    deck.write_text(
        text.replace(
            "run 40000",
            f"fix ck all bearing/checkpoint 20 {tmp_path}/ck files ${{out}}/contacts.dump\nrun 400",
        )
    )
    refused(
        liggghts(deck, out=tmp_path / "out"),
        r"contacts.dump has stopped growing at step \d+: it must grow every 20 steps."
        r" Is it written less often",
    )
