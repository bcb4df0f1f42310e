# SPDX-License-Identifier: GPL-2.0-or-later
"""bearing_input takes a row of FOLDER/*.csv as it takes a file of that name, and Python reads the
same."""

import pytest
from host import ROOT, run, succeed
from raceway import catalogue, data_table, inputs

BEARINGS = ROOT / "inputs" / "bearings"
NAMES = ["6210", "7205B", "7010AC", "QJ208"]
HOSTS = ["liggghts", "lammps", "wheel"]
FOLLOWS = ("inner_radius", "outer_groove", "cage_ball_diameter", "inner_mass", "ball_young")


def told(tmp_path, folder, name, **host):
    """The variables of a deck after it took the bearing, as texts."""
    names = [*inputs.values(BEARINGS / name), *FOLLOWS]
    deck = tmp_path / "in.deck"
    deck.write_text(
        f"variable inputs index inputs\nvariable bearing index {name}\nvariable clearance index 0\n"
        f"bearing_input {folder} {name}\n"
        + "".join(f'print "HAS {one} ${{{one}}}"\n' for one in names)
    )
    lines = succeed(deck, **host).text.splitlines()
    found = dict(line.split()[1:] for line in lines if line.startswith("HAS"))
    assert set(found) == set(names)
    return found


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("name", NAMES)
def test_row_is_a_file(tmp_path, host, name):
    """The row, on two ranks, and the file that `raceway catalogue --file` writes of it give every
    variable the same text, that which Python reads."""
    (tmp_path / name).write_text(inputs.text(catalogue.find("bearings", name, ROOT / "inputs")))
    row = told(tmp_path, BEARINGS, name, host=host, ranks=2)
    assert row == told(tmp_path, tmp_path, name, host=host)
    assert row.items() >= inputs.values(BEARINGS / name).items()


OWN = """# mm are no SI units
variable colour index red # of all
name,balls,ball_diameter,source,made
one,8,1e-2,me,1999
two,9,,me,2000
"""
BEFORE = "variable balls index 1\nvariable ball_diameter index 2\n"
DECK = """bearing_input {folder} {name} needs colour
print "NOW ${{balls}} ${{ball_diameter}} ${{colour}}"
bearing_variables {folder}
bearing_forget {folder}
variable balls index 5
print "THEN ${{balls}}"
"""


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("change", ["", "mark", "spreadsheet"])
def test_own_table(tmp_path, host, change):
    """Tables saved by a spreadsheet are read. A variable that the deck or -var has set keeps its
    value, as with a file. bearing_forget deletes the variables of a row."""
    text = OWN
    if change == "mark":
        text = "\ufeff" + text
    elif change == "spreadsheet":
        text = OWN.replace(" # of all\n", ",,,,\r\n").replace("2000\n", "2000\r\n,,,,\r\n")
    own = tmp_path / "own"
    own.mkdir()
    (own / "table.csv").write_text(text, newline="")
    deck = tmp_path / "in.deck"
    for before, given, says in (
        ("", {}, "NOW 8 1e-2 red"),
        ("", {"balls": 4}, "NOW 4 1e-2 red"),
        (BEFORE, {}, "NOW 1 2 red"),
    ):
        deck.write_text(before + DECK.format(folder=own, name="one"))
        done = succeed(deck, host=host, **given)
        assert says in done.text and "THEN 5" in done.text
    assert inputs.values(own / "one") == {"balls": "8", "ball_diameter": "1e-2", "colour": "red"}
    assert inputs.values(own / "two") == {"balls": "9", "colour": "red"}


def test_file_comes_first(tmp_path):
    (tmp_path / "table.csv").write_text(OWN)
    (tmp_path / "one").write_text("variable colour index blue\n")
    deck = tmp_path / "in.deck"
    deck.write_text(BEFORE + DECK.format(folder=tmp_path, name="one"))
    assert "NOW 1 2 blue" in succeed(deck).text
    assert inputs.values(tmp_path / "one") == {"colour": "blue"}
    assert data_table.names(tmp_path) == ["in.deck", "one", "two"]


@pytest.mark.parametrize(
    "table, message",
    [
        (OWN.replace("8,", ""), "table.csv', line 4: 4 cells, must be 5 as in the line of columns"),
        (OWN.replace("two", "one"), "table.csv', line 5: a second row 'one'"),
        (OWN.replace("name,", "bearing,"), "has no line of columns that begins with name,"),
        (OWN, "'two' of '{folder}/table.csv' has no variable pitch_diameter"),
    ],
)
def test_broken_table(tmp_path, table, message):
    (tmp_path / "table.csv").write_text(table)
    deck = tmp_path / "in.deck"
    deck.write_text(f"bearing_input {tmp_path} two needs colour balls pitch_diameter\n")
    done = run(deck, ranks=2)
    assert done.code != 0 and message.format(folder=tmp_path) in done.error
    if table != OWN:
        with pytest.raises(inputs.InputError) as error:
            inputs.values(tmp_path / "two")
        assert message.split("table.csv', ")[-1] in str(error.value)


def test_names_that_are_near_come_first(tmp_path):
    done = run("inputs/in.6208", bearing="7205", out=tmp_path)
    assert done.code != 0
    says = "there is no '7205' in folder inputs/bearings; there is: 6205, 7205A, 7205B, 7205C, 7208"
    assert says in done.error and "harris209" in done.error and "catalogue.csv" not in done.error
    done = run("inputs/in.6208", bearing="catalogue.csv", out=tmp_path)
    assert "there is no 'catalogue.csv'" in done.error
