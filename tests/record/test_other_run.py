# SPDX-License-Identifier: GPL-2.0-or-later
"""A record and a run.yaml that belong to different runs are rejected; files of the same run are
accepted."""

import shutil

import pytest
import raceway
from commands import reply
from host import succeed
from raceway.errors import RunError
from recorded_runs import MAIN, small
from smallest import SMALLEST

SHORT = {**MAIN, "samples": 20, "dumps": "no"}
OTHERS = {
    "passes": ({"passes": 2}, "passes"),
    "load": ({"load": 3000}, "deck_variables"),
    "oil": ({"lubricant": "vg46"}, "deck_variables"),
    "phase": ({"phase": 0.1}, "deck_variables"),
}


@pytest.fixture(scope="module")
def one(tmp_path_factory):
    folder = tmp_path_factory.mktemp("one")
    succeed(out=folder / "run", **SHORT)
    return folder / "run"


@pytest.mark.parametrize("words, key", OTHERS.values(), ids=OTHERS)
def test_of_the_main_deck(one, words, key, tmp_path, capsys):
    succeed(out=tmp_path, **{**SHORT, **words})
    shutil.copy(one / "record.nc", tmp_path)
    for command in ("summary", "plot", "report"):
        said = reply(capsys, [command, tmp_path], code=1)
        assert f"{tmp_path}/record.nc belongs to a different run than run.yaml: {key} is" in said
        assert said.count("\n") == 1


@pytest.mark.parametrize("steps", [5000, 30000])
def test_of_a_deck_that_notes_nothing(steps, tmp_path):
    """The two runs differ only in length."""
    for name, count in (("a", 20000), ("b", steps)):
        (tmp_path / name).mkdir()
        succeed(small(tmp_path / name, deck=SMALLEST.replace("run 20000", f"run {count}")))
    shutil.copy(tmp_path / "a/run/record.nc", tmp_path / "b/run")
    with pytest.raises(RunError, match="a different run than run.yaml: simulated_s is 0.02 "):
        raceway.open(tmp_path / "b/run")


def test_numbers_that_a_deck_notes(tmp_path):
    for name, load in (("a", 5000), ("b", 4000)):
        (tmp_path / name).mkdir()
        succeed(small(tmp_path / name, f"number load_N {load}"))
    shutil.copy(tmp_path / "a/run/record.nc", tmp_path / "b/run")
    with pytest.raises(RunError, match="load_N is 5000 in the record, but 4000 in run.yaml"):
        raceway.open(tmp_path / "b/run")


def test_a_run_that_goes_on_is_one(tmp_path):
    """Until a continued run has ended, its record contains more samples than run.yaml states for
    the previous part."""
    succeed(small(tmp_path, more="", deck=SMALLEST + "run 5000\n"))
    folder = tmp_path / "run"
    assert raceway.open(folder).tables.settings["simulated_s"] == pytest.approx(0.025)
    path, text = folder / "run.yaml", (folder / "run.yaml").read_text()
    path.write_text(text.split("step_s: ")[0])
    assert not raceway.open(folder).tables.finished
    succeed(out=tmp_path / "main", **SHORT)
    succeed(out=tmp_path / "main", **{**SHORT, "passes": 2, "resume": "yes"})
    assert raceway.open(tmp_path / "main").tables.settings["passes"] == 2


def test_words_of_a_deck(tmp_path):
    """Numbers that agree to 15 digits are considered equal, and texts remain texts however YAML
    would interpret them."""
    notes = "number third 0.3333333333333333333 number large 1.23456789012345678e23"
    notes += " text quoted 'x:y' text label \"a: b # c\""
    succeed(small(tmp_path, notes))
    assert raceway.open(tmp_path / "run").settings["label"] == "a: b # c"
