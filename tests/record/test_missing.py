# SPDX-License-Identifier: GPL-2.0-or-later
"""What a record does not hold is said in a line, with how to get it."""

import pytest
import raceway
from host import succeed
from raceway.cli import main
from raceway.errors import RunError
from recorded_runs import MAIN, small

NO_CONTACTS = "record.nc holds no contacts: record them with -var record all"


@pytest.fixture(scope="module")
def sums(tmp_path_factory):
    """The main deck with a record of sums alone."""
    folder = tmp_path_factory.mktemp("sums") / "run"
    succeed(out=folder, **{**MAIN, "record": "summary", "dumps": "no"})
    return folder


@pytest.fixture(scope="module")
def motion_alone(tmp_path_factory):
    """docs/decks/in.smallest with a record that has balls and no contacts."""
    folder = tmp_path_factory.mktemp("motion")
    succeed(small(folder, "contacts none"))
    return folder / "run"


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
    assert main([name, str(sums), *more]) == 1
    said = capsys.readouterr().err
    assert NO_CONTACTS in said and said.count("\n") == 1


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
