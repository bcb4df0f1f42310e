# SPDX-License-Identifier: GPL-2.0-or-later
"""bearing_range table: defaults and ranges of a deck's variables from one file."""

import pytest
from host import run

TABLE = """\
# a table
variable thick needed unit "mm long" range 1 5 or 9   # of the user
variable warm  index 40              range 0 100 whole advice "take another"
variable kind  index oil             one_of oil grease

variable free  index word
"""


def deck(tmp_path, table=TABLE, given="variable thick index 2\n", host="liggghts", **values):
    (tmp_path / "table").write_text(table)
    path = tmp_path / "in.deck"
    path.write_text(
        given + f'bearing_range table {tmp_path}/table\nprint "HAS ${{thick}} ${{warm}} ${{kind}} '
        '${free}"\n'
    )
    return run(path, host=host, ranks=values.pop("ranks", 1), **values)


@pytest.mark.parametrize("host, ranks", [("liggghts", 2), ("lammps", 1)])
def test_defaults_and_values_given(tmp_path, host, ranks):
    done = deck(tmp_path, host=host, ranks=ranks, warm=50, thick=9)
    assert done.code == 0 and "HAS 9 50 oil word" in done.text, done.text[-1000:]


@pytest.mark.parametrize(
    "values, says",
    [
        ({"thick": 6}, "bearing_range: thick (mm long) is 6, must be from 1 to 5, or 9"),
        ({"thick": "0x2"}, "thick (mm long) must be a number like 5000 or 5.0e3, not '0x2'"),
        ({"warm": 1.5}, "warm is 1.5, must be a whole number from 0 to 100 (take another)"),
        ({"kind": "water"}, "bearing_range: kind is 'water', must be one of oil, grease"),
        ({"given": ""}, "bearing_range: the deck has no variable thick, see '"),
        ({"given": "variable thick atom x\n"}, "variable thick has no value that is one"),
        ({"table": "variable x sometimes\n"}, "line 1: kind of variable is 'sometimes', must be"),
        ({"table": "\nvariable x index 1 rnage 0 1\n"}, "line 2: unknown keyword or one argument"),
        ({"table": "thick 1 5\n"}, "line 1: unknown keyword or one argument too many: 'thick'"),
        ({"table": "variable x index 1 range 0\n"}, "highest x is missing"),
    ],
)
def test_refused(tmp_path, values, says):
    done = deck(tmp_path, **values)
    assert done.code != 0 and says in done.error, done.text[-1000:]


def test_no_table(tmp_path):
    path = tmp_path / "in.deck"
    path.write_text("bearing_range table nowhere/at_all\n")
    done = run(path)
    assert done.code != 0
    assert "bearing_range: there is no table of variables in 'nowhere/at_all'" in done.error
