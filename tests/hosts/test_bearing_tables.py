# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `bearing` reads a row of a table INPUTS/bearings/*.csv as if it were a file named
after the row, and Python reads the same data."""

import pytest
from host import ROOT, deck_file, refuses, succeed
from raceway import data_table, inputs

HOSTS = ["liggghts", "lammps", "wheel"]
VALUES = inputs.values(ROOT / "inputs/bearings/6208")
COLUMNS = [name for name in VALUES if name != "series"]
ROW = ",".join(VALUES[name] for name in COLUMNS)
OWN = f"""# a comment
variable series index 62 # of all
name,{",".join(COLUMNS)},source,made
one,{ROW},me,1999
two,{ROW.replace(VALUES["balls"], "", 1)},me,2000
"""
HEAD = "variable bearing index one\n"
DECK = (
    HEAD
    + """{before}bearing b ${{bearing}} types 1 2 3 4 inputs {folder}
print "NOW ${{b_balls}} ${{b_ball_diameter}}"
"""
)


def table(tmp_path, text=OWN):
    """Return an inputs folder that contains the table `text`."""
    folder = tmp_path / "own"
    (folder / "bearings").mkdir(parents=True)
    (folder / "bearings" / "table.csv").write_text(text, newline="")
    return folder


def deck(tmp_path, folder, before=""):
    path = deck_file(tmp_path, DECK.format(folder=folder, before=before))
    return path


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("change", ["", "mark", "spreadsheet"])
def test_own_table(tmp_path, host, change):
    """Tables saved by a spreadsheet program can be read. Values from the deck and from -var take
    precedence over those of the table."""
    text = OWN
    if change == "mark":
        text = "\ufeff" + text
    elif change == "spreadsheet":
        text = OWN.replace(" # of all\n", ",,,,\r\n").replace("2000\n", "2000\r\n,,,,\r\n")
    folder = table(tmp_path, text)
    diameter = VALUES["ball_diameter"]
    for before, given, says in (
        ("", {}, f"NOW 9 {diameter}"),
        ("", {"balls": 8}, f"NOW 8 {diameter}"),
        ("variable balls index 7\n", {}, f"NOW 7 {diameter}"),
    ):
        done = succeed(deck(tmp_path, folder, before), host=host, **given)
        assert says in done.text
    found = inputs.values(folder / "bearings" / "one")
    assert found == {**{name: VALUES[name] for name in COLUMNS}, "series": "62"}
    assert "balls" not in inputs.values(folder / "bearings" / "two")


def test_file_comes_first(tmp_path):
    folder = table(tmp_path)
    lines = [f"variable {name} index {value}" for name, value in (VALUES | {"balls": 5}).items()]
    (folder / "bearings" / "one").write_text("\n".join(lines))
    assert "NOW 5 " in succeed(deck(tmp_path, folder)).text
    assert inputs.values(folder / "bearings" / "one")["balls"] == "5"
    assert data_table.names(folder / "bearings") == ["one", "two"]


@pytest.mark.parametrize(
    "text, message",
    [
        (
            OWN.replace("one,9,", "one,"),
            "table.csv', line 4: {a} cells, must be {b} as in the heading",
        ),
        (OWN.replace("two", "one"), "table.csv', line 5: a second row 'one'"),
        (OWN.replace("name,", "bearing,"), "has no heading that begins with name,"),
        (OWN, "'two' of '{folder}/bearings/table.csv' has no variable balls"),
    ],
)
def test_broken_table(tmp_path, text, message):
    folder = table(tmp_path, text)
    message = message.format(folder=folder, a=len(COLUMNS) + 2, b=len(COLUMNS) + 3)
    refuses(deck(tmp_path, folder), message, ranks=2, bearing="two")
    if text != OWN:
        with pytest.raises(inputs.InputError) as error:
            inputs.values(folder / "bearings" / "two")
        assert message.split("table.csv', ")[-1] in str(error.value)


def test_names_that_are_near_come_first(tmp_path):
    says = "there is no '7205' in folder inputs/bearings; there is: 6205, 7205A, 7205B, 7205C, 7208"
    done = refuses("inputs/in.6208", says, " in all", bearing="7205", out=tmp_path)
    assert "catalogue.csv" not in done.error
    says = "there is no 'catalogue.csv'"
    refuses("inputs/in.6208", says, bearing="catalogue.csv", out=tmp_path)
