# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the table of a sweep: accepted forms, and a message for every mistake before any run
starts."""

from pathlib import Path

import pytest
from raceway.sweeps.points import LONGEST, TableError, deck_variables, folder_name, read_points
from raceway.sweeps.variable_table import DATA, rows

DECK = Path(__file__).resolve().parents[2] / "inputs" / "in.6208"
VARIABLES = deck_variables(DECK)


def points(tmp_path, text):
    path = tmp_path / "table.csv"
    path.write_text(text)
    return read_points(path, VARIABLES)


def test_deck_variables():
    assert VARIABLES["load"] == "5000" and VARIABLES["lubricant"] == "mineral"
    assert VARIABLES["ramp"] == "3.0e-3" and VARIABLES["tolerance"] == "0"  # command defaults


def test_main_deck_has_every_variable_of_the_table():
    """This includes variables on continued lines."""
    of_decks = [row for row in rows() if row["of"] not in DATA and row["of"][:3] != "in."]
    assert {row["name"] for row in of_decks} <= VARIABLES.keys()


def test_points(tmp_path):
    found = points(tmp_path, "# a comment\nrpm,load,lubricant\n\n477.5,5e3,dry\n 100 , 20 ,pao48\n")
    assert [point.name for point in found] == [
        "load=5e3_rpm=477.5_lubricant=dry",
        "load=20_rpm=100_lubricant=pao48",
    ]
    # values are kept as written, in the order of the deck's variables
    assert found[0].variables == {"load": "5e3", "rpm": "477.5", "lubricant": "dry"}


def test_words_of_another_meaning(tmp_path):
    """A variable whose default is a word is accepted, and so is a bearing whose name ends in
    letters that could be a unit."""
    path = tmp_path / "table.csv"
    path.write_text("bearing,load,rpm\n6205N,5kN,1500\n")
    known = {"bearing": "6208", "load": "left", "rpm": "1"}
    assert read_points(path, known)[0].variables["load"] == "5kN"


def test_name_is_stable(tmp_path):
    """The name of a point does not depend on the order of columns and rows."""
    one = points(tmp_path, "load,rpm\n1,2\n3,4\n")
    other = points(tmp_path, "rpm,load\n4,3\n2,1\n")
    assert {point.name for point in one} == {point.name for point in other}


def test_long_names():
    names = {folder_name({"bearing": "b" * 200, "load": str(load)}) for load in range(50)}
    assert len(names) == 50 and max(map(len, names)) <= LONGEST


def test_names_of_paths():
    """Files with the same name in different folders give points with different names."""
    names = {folder_name({"bearing": path, "load": "1"}) for path in ("a/own", "b/own", "own")}
    assert len(names) == 3 and not any("/" in name for name in names)


def test_mark_of_spreadsheets(tmp_path):
    (tmp_path / "table.csv").write_bytes(b"\xef\xbb\xbfload,rpm\r\n1,2\r\n")
    assert read_points(tmp_path / "table.csv", VARIABLES)[0].variables == {"load": "1", "rpm": "2"}


@pytest.mark.parametrize(
    "text, complaint",
    [
        ("", "is empty"),
        ("load,rpm\n", "no rows below its header"),
        ("load,share\n1,0\n", "line 2: share is '0', must be a number above 0"),
        ("load,share\n1,half\n", "line 2: share is 'half', must be a number above 0"),
        ("load,rpn\n1,2\n", "is not a variable of the deck; did you mean rpm? Variables: load,"),
        ("load,load\n1,2\n", "column 'load' occurs 2 times"),
        *(
            (f"load,{name}\n1,x\n", f"column '{name}' cannot be swept")
            for name in ("out", "resume", "overwrite")
        ),
        ("load,\n1,2\n", "column '' is not a variable"),
        ("load,rpm\n1,\n", "line 2: rpm is empty"),
        ("load,rpm\n1,2\n1.0,2e0\n", "line 3: the same point as line 2"),
        ("load,rpm\n1\n", "line 2: 1 cells instead of 2"),
        ("load,rpm\n1,2,3\n", "line 2: 3 cells instead of 2"),
        ("load,clearance\n1,10um\n", "line 2: clearance is '10um': give a number alone, in m"),
        ("bearing\nmy bearing\n", "line 2: bearing is 'my bearing', must be one word"),
        ("bearing\n./x;y\n", "line 2: bearing is './x;y'"),
        ("bearing\n${x}\n", "line 2: bearing is '${x}'"),
    ],
)
def test_mistakes(tmp_path, text, complaint):
    with pytest.raises(TableError) as error:
        points(tmp_path, text)
    assert complaint in str(error.value) and "table.csv" in str(error.value)


def test_all_mistakes_at_once_but_not_a_thousand(tmp_path):
    with pytest.raises(TableError) as error:
        points(tmp_path, "load,rpm\n" + "1,\n" * 1000)
    assert str(error.value).count("is empty") == 20 and "and 980 more" in str(error.value)


def test_missing_files(tmp_path):
    with pytest.raises(TableError, match="cannot read .*nowhere"):
        read_points(tmp_path / "nowhere.csv", VARIABLES)
    with pytest.raises(TableError, match="cannot read deck"):
        deck_variables(tmp_path / "in.nothing")
