# SPDX-License-Identifier: GPL-2.0-or-later
"""The command bearing takes a row of FOLDER/*.csv as it takes a file of that name, and Python reads
the same."""

import pytest
from host import ROOT, run, succeed
from raceway import catalogue, data_table, inputs

BEARINGS = ROOT / "inputs" / "bearings"
NAMES = ["6210", "7205B", "7010AC", "QJ208"]
HOSTS = ["liggghts", "lammps", "wheel"]
FOLLOWS = "ball_diameter inner_radius outer_groove cage_ball_diameter inner_mass ball_young".split()


def told(tmp_path, data, names=FOLLOWS, **words):
    """The numbers of a bearing in a deck, as texts."""
    deck = tmp_path / "in.deck"
    deck.write_text(
        f"bearing b {data} types 1 2 3 4 vars inputs\n"
        + "".join(f'print "HAS {one} ${{b_{one}}}"\n' for one in names)
    )
    lines = succeed(deck, **words).text.splitlines()
    found = dict(line.split()[1:] for line in lines if line.startswith("HAS"))
    assert set(found) == set(names)
    return found


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("name", NAMES)
def test_row_is_a_file(tmp_path, host, name):
    """The row, on two ranks, and the file that `raceway catalogue --file` writes of it give the
    same texts."""
    (tmp_path / name).write_text(inputs.text(catalogue.find("bearings", name, ROOT / "inputs")))
    row = told(tmp_path, name, host=host, ranks=2)
    assert row == told(tmp_path, tmp_path / name, host=host)
    given = inputs.values(BEARINGS / name)
    assert row["ball_diameter"] == given["ball_diameter"]


COMPLETE = {
    "inner_groove": "6.6e-3",
    "outer_groove": "6.6e-3",
    "inner_radius": "24e-3",
    "outer_radius": "36.6e-3",
    "cage_ball_diameter": "8e-3",
    "ball_young": "2e11",
    "ball_poisson": "0.3",
    "ball_density": "7800",
    "inner_mass": "0.2",
    "inner_inertia": "1e-4",
    "inner_inertia_t": "1e-4",
}
OWN = (
    "".join(f"variable {name} index {value} # of all\n" for name, value in COMPLETE.items())
    + """name,balls,ball_diameter,source,made
one,8,1.2e-2,me,1999
two,9,,me,2000
"""
)


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("change", ["", "mark", "spreadsheet"])
def test_own_table(tmp_path, host, change):
    """Tables saved by a spreadsheet are read. A value that -var gives wins, as with a file."""
    text = OWN
    if change == "mark":
        text = "\ufeff" + text
    elif change == "spreadsheet":
        text = OWN.replace(" # of all\n", ",,,,\r\n").replace("2000\n", "2000\r\n,,,,\r\n")
    own = tmp_path / "bearings"
    own.mkdir()
    (own / "table.csv").write_text(text, newline="")
    for given, balls in (({}, "8"), ({"balls": 4}, "4")):
        found = told(tmp_path, "one", ("balls", "ball_young"), host=host, inputs=tmp_path, **given)
        assert found == {"balls": balls, "ball_young": "2e11"}
    assert inputs.values(own / "one") == {"balls": "8", "ball_diameter": "1.2e-2"} | COMPLETE
    assert inputs.values(own / "two") == {"balls": "9"} | COMPLETE


def test_file_comes_first(tmp_path):
    own = tmp_path / "bearings"
    own.mkdir()
    (own / "table.csv").write_text(OWN)
    (own / "one").write_text((BEARINGS / "6208").read_text())
    assert told(tmp_path, "one", ("balls",), inputs=tmp_path) == {"balls": "9"}
    assert inputs.values(own / "one")["balls"] == "9"
    assert data_table.names(own) == ["one", "two"]


@pytest.mark.parametrize(
    "table, message",
    [
        (
            OWN.replace("8,", ""),
            "table.csv', line 13: 4 cells, must be 5 as in the line of",
        ),
        (OWN.replace("two", "one"), "table.csv', line 14: a second row 'one'"),
        (OWN.replace("name,", "bearing,"), "has no line of columns that begins with name,"),
        (OWN, "'two' of '{folder}/table.csv' has no variable ball_diameter"),
    ],
)
def test_broken_table(tmp_path, table, message):
    own = tmp_path / "bearings"
    own.mkdir()
    (own / "table.csv").write_text(table)
    deck = tmp_path / "in.deck"
    deck.write_text("bearing b two types 1 2 3 4 vars inputs\n")
    done = run(deck, ranks=2, inputs=tmp_path)
    assert done.code != 0 and message.format(folder=own) in done.error
    if table != OWN:
        with pytest.raises(inputs.InputError) as error:
            inputs.values(own / "two")
        assert message.split("table.csv', ")[-1] in str(error.value)


def test_names_that_are_near_come_first(tmp_path):
    done = run("inputs/in.6208", bearing="7205", out=tmp_path)
    assert done.code != 0
    says = "there is no '7205' in folder inputs/bearings; there is: 6205, 7205A, 7205B, 7205C, 7208"
    assert says in done.error and "harris209" in done.error and "catalogue.csv" not in done.error
    done = run("inputs/in.6208", bearing="catalogue.csv", out=tmp_path)
    assert "there is no 'catalogue.csv'" in done.error
