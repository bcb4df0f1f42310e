# SPDX-License-Identifier: GPL-2.0-or-later
"""If a quantity is missing from a record, a one-line error message explains how to record it."""

import re
import shutil
import warnings

import pytest
import raceway
from commands import reply
from host import succeed
from raceway.cli import main
from raceway.errors import RunError
from raceway.runs.record import Record
from recorded_runs import MAIN, small

NO_CONTACTS = "record.nc has no contacts: record them with -var record all"


@pytest.fixture(scope="module")
def sums(tmp_path_factory):
    """Return the folder of a run of the main deck whose record contains only sums."""
    folder = tmp_path_factory.mktemp("sums") / "run"
    succeed(out=folder, **{**MAIN, "record": "summary", "dumps": "no"})
    return folder


@pytest.fixture(scope="module")
def motion_alone(tmp_path_factory):
    """Return the folder of a run of docs/decks/in.smallest whose record contains balls but no
    contacts.
    """
    folder = tmp_path_factory.mktemp("motion")
    succeed(small(folder, "contacts none"))
    return folder / "run"


@pytest.fixture(scope="module")
def load_alone(tmp_path_factory):
    """Return the folder of a run of docs/decks/in.smallest whose record contains loads as the only
    contact column.
    """
    folder = tmp_path_factory.mktemp("load")
    succeed(small(folder, "contacts load"))
    return folder / "run"


def copied(folder, to, samples=None):
    """Copy the folder of a run and keep only some samples of its record."""
    shutil.copytree(folder, to)
    content = bytearray((to / "record.nc").read_bytes())
    if samples is not None:
        record = Record(folder)
        content = content[: (samples - len(record)) * record.record_bytes]
        content[4:8] = samples.to_bytes(4, "big")  # netCDF classic
        text = (to / "run.yaml").read_text()
        (to / "run.yaml").write_text(re.sub("simulated_s: .*", "simulated_s: 0", text))
    (to / "record.nc").write_bytes(content)
    return to


@pytest.mark.parametrize(
    "words",
    [
        ["export", "--format", "spice"],
        ["circuit", "--floating", "10"],
        ["plot", "--kind", "polar"],
        ["animate"],
    ],
)
def test_a_command_that_needs_contacts(sums, words, capsys):
    name, *more = words
    said = reply(capsys, [name, sums, *more], code=1)
    assert NO_CONTACTS in said and said.count("\n") == 1


@pytest.mark.parametrize(
    "words",
    [
        ["report"],
        ["animate"],
        *(["plot", "--kind", kind] for kind in ("overview", "polar", "bearing")),
    ],
    ids=lambda words: words[-1],
)
def test_contacts_of_one_column(load_alone, words, capsys):
    """A command that requires more columns reports this in one line, and a report omits such
    pictures.
    """
    name, *more = words
    code = main([name, str(load_alone), *more])
    said = capsys.readouterr().err
    assert code == 0 or re.search(r"has no column azimuth|needs the column", said), said
    assert said.count("\n") <= 1


@pytest.mark.parametrize("folder", ["sums", "motion_alone"])
def test_contacts_in_python(folder, request):
    run = raceway.open(request.getfixturevalue(folder))
    for wanted in (
        lambda: run.contacts,
        lambda: next(run.blocks("contacts")),
        lambda: run.tables.contacts,
    ):
        with pytest.raises(RunError, match=NO_CONTACTS):
            wanted()


def test_what_else_the_record_holds_is_there(sums, motion_alone):
    assert raceway.open(sums).rings.sizes["time"] == 41
    assert raceway.open(motion_alone).balls.sizes["ball"] == 9


@pytest.mark.parametrize("words", [[], ["record", "none"]], ids=["in your own deck", "main deck"])
def test_nothing_was_recorded(words, tmp_path, capsys):
    folder = tmp_path / "run"
    if words:
        succeed(out=folder, **{**MAIN, "record": "none", "dumps": "no"})
    else:
        succeed(small(tmp_path, "content none"))
    for command in (["summary"], ["plot", "--kind", "motion"], ["animate"], ["report"]):
        said = reply(capsys, [command[0], folder, *command[1:]], code=1)
        assert "has no record.nc: its run recorded nothing, or the file was removed" in said
        assert "-var record all or fix bearing/record writes one" in said and "column" not in said


def test_run_yaml_is_gone(sums, tmp_path, capsys):
    folder = copied(sums, tmp_path / "run")
    (folder / "run.yaml").unlink()
    for command in ("summary", "report"):
        assert f"{folder}/run.yaml, which states whether" in reply(
            capsys, [command, folder], code=1
        )
    assert raceway.open(folder).rings.sizes["time"] == 41


@pytest.mark.parametrize(
    "samples, said",
    [(0, "has no samples: its run has just begun"), (1, "has 1 sample: results are means over")],
)
@pytest.mark.parametrize("deck", ["sums", "motion_alone"])
def test_hardly_a_sample(deck, samples, said, tmp_path, request, capsys):
    folder = copied(request.getfixturevalue(deck), tmp_path / "run", samples=samples)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run = raceway.open(folder)
        assert str(folder) in repr(run)
        with pytest.raises(RunError, match=said):
            run.summary()
    for command in ("summary", "plot", "report"):
        assert said in reply(capsys, [command, folder], code=1)


@pytest.mark.parametrize("samples", [0, 1])
def test_too_few_samples_for_a_command(samples, tmp_path, capsys):
    succeed(out=tmp_path / "all", **{**MAIN, "dumps": "no"})
    folder = copied(tmp_path / "all", tmp_path / "run", samples=samples)
    commands = [["circuit", "--floating", "10"], ["export", "--format", "spice"]]
    commands += [["plot", "--kind", "waterfall"], *([["animate"]] if samples == 0 else [])]
    for name, *more in commands:
        said = reply(capsys, [name, folder, *more], code=1)
        assert "sample" in said and said.count("\n") == 1
