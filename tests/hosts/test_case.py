# SPDX-License-Identifier: GPL-2.0-or-later
"""bearing_case: commands by a word, in hosts that compare numbers only."""

import pytest
from host import run

DECK = """\
variable kind index oil
variable said string nothing
bearing_case kind ${kind} oil "variable said string wet" 'print "SAID ${said}"' &
  dry none "print 'SAID ${kind}'" "include FOLDER/more"
print "END ${said}"
"""


def case(tmp_path, deck=DECK, host="liggghts", **values):
    (tmp_path / "more").write_text("variable said string more\n")
    path = tmp_path / "in.deck"
    path.write_text(deck.replace("FOLDER", str(tmp_path)))
    return run(path, host=host, **values)


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize(
    "kind, lines",
    [
        ("oil", ["SAID wet", "END wet"]),
        ("dry", ["END nothing"]),
        ("none", ["SAID none", "END more"]),
    ],
)
def test_commands_of_a_word(tmp_path, host, kind, lines):
    done = case(tmp_path, host=host, kind=kind)
    assert done.code == 0, done.text[-1000:]
    said = [line for line in done.text.splitlines() if line.split()[:1] in (["SAID"], ["END"])]
    assert said == lines


@pytest.mark.parametrize(
    "deck, says",
    [
        ("bearing_case kind wet oil dry", "bearing_case: kind is 'wet', must be one of oil, dry"),
        ('bearing_case kind oil "print 1" oil', "a value of kind comes before 'print 1'"),
        ("bearing_case kind", "too few arguments: value of kind is missing"),
    ],
)
def test_refused(tmp_path, deck, says):
    done = case(tmp_path, deck + "\n")
    assert done.code != 0 and says in done.error, done.text[-1000:]
