# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of input that was once accepted, or rejected with the wrong message: bearing and lubricant
data, words that only C reads as numbers, and paths that are not files."""

import pytest
from host import ROOT, liggghts, refused


def test_a_lubricant_for_a_bearing(tmp_path):
    end = liggghts("inputs/in.6208", bearing="../lubricants/mineral", out=tmp_path)
    refused(end, r"'inputs/bearings/../lubricants/mineral' has no variable balls, ball_diameter")


def test_files_that_are_none(tmp_path):
    own = tmp_path / "inputs"
    (own / "bearings").mkdir(parents=True)
    text = (ROOT / "inputs/bearings/6208").read_text()
    (own / "bearings" / "mine").write_text("\ufeff" + text)
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
