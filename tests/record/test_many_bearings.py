# SPDX-License-Identifier: GPL-2.0-or-later
"""If a record contains several bearings, one must be selected to obtain results, and commands
accept the number of the bearing."""

import re

import pytest
import raceway
from commands import answer, reply
from host import succeed
from raceway import electrical, losses, regimes, spectrum
from raceway.cli import main
from raceway.errors import RunError

WHICH = (
    r"record.nc has 2 bearings: select one with --bearing NUMBER or, in Python, with"
    r" run.select\(number\)"
)
COMMANDS = [
    "summary",
    "plot --out OUT.png",
    "plot --kind polar --out OUT.png",
    "plot --kind waterfall --out OUT.png",
    "plot --kind bearing --out OUT.png",
    "plot --kind motion --out OUT.png",
    "report --out OUT.html",
    "animate --frames 2 --passes 0.1 --out OUT.gif",
    "export --format vtk --out OUT",
    "export --format xyz --out OUT",
    "export --format spice --out OUT",
    "circuit --floating 10",
    "spectrum --signal y",
    "electric",
]


@pytest.fixture(scope="module")
def many(tmp_path_factory):
    """Return the folder of a run of inputs/in.many with two bearings."""
    folder = tmp_path_factory.mktemp("many")
    words = dict(bearings=2, columns=2, time=6e-3, ramp=1e-3, record="all")
    succeed("inputs/in.many", out=folder / "run", **words)
    return folder / "run"


def command(text, folder, out):
    name, *more = text.replace("OUT", str(out)).split()
    return [name, str(folder), *more]


@pytest.mark.parametrize("text", COMMANDS)
def test_commands_ask_which(many, text, tmp_path, capsys):
    said = reply(capsys, command(text, many, tmp_path / "out"), code=1)
    assert re.search(WHICH, said) and said.count("\n") == 1


@pytest.mark.parametrize(
    "wanted",
    [
        lambda run: run.rings,
        lambda run: run.tables.rings,
        lambda run: run.bearing,
        lambda run: run.flaws,
        losses.losses,
        losses.losses_around,
        lambda run: spectrum.of_run(run, "y"),
        regimes.shares,
        electrical.over_time,
        electrical.by_raceway,
    ],
)
def test_python_asks_which(many, wanted):
    with pytest.raises(RunError, match=WHICH):
        wanted(raceway.open(many))


def test_all_bearings_together_have_contacts(many):
    assert raceway.open(many).contacts.sizes["ball"] == 18


@pytest.mark.parametrize("text", COMMANDS)
def test_commands_take_a_number(many, text, tmp_path, capsys):
    assert "has bearings 1 to 2, but no bearing 3" in reply(
        capsys, [*command(text, many, tmp_path / "out"), "--bearing", "3"], code=1
    )
    done = main([*command(text, many, tmp_path / "out"), "--bearing", "2"])
    said = capsys.readouterr().err
    assert done == 0 or "has 7 samples: a spectrum needs 32" in said


def test_figures_are_those_of_the_number(many, capsys):
    for number in (1, 2):
        figures = answer(capsys, ["summary", many, "--bearing", number])
        assert figures["q_max_N"] == raceway.open(many).select(number).summary()["q_max_N"]


def test_mistakes(many, tmp_path, capsys):
    assert "does not have the deck's variables" in reply(capsys, ["check", many], code=1)
    (tmp_path / "point").mkdir()
    (tmp_path / "point" / "point.yaml").write_text("load: 1\n")
    for words in (["report", str(tmp_path), "--bearing", "1"], ["summary", "x", "--bearing", "0"]):
        assert "--bearing" in reply(capsys, words, code=2)
