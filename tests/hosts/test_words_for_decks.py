# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of deck commands that replace long passages: create_bearing ... groups, bearing_dump,
and fix bearing/checkpoint ... balance."""

import re

import numpy as np
import pytest
from host import BOX, FORMATS, box, deck_file, refuses, succeed
from raceway import core

HOSTS = pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
RACEWAYS = """pair_style bearing/hertz friction constant 0.1
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer 36.6e-3 6.552e-3
pair_coeff 1 2 sphere 210e9 0.3 3.3e9 0.41
"""
CREATE = "create_bearing 1 2 3 4 balls 9 diameter 12.6e-3 cage 8.38e-3 speed 50 0"
MOVE = """fix rails cage bearing/cage 4
fix move all bearing/implicit
fix inner inner bearing/ring mass 0.2 x free y free spin speed 50 force 300 -400 0 ramp 1e-3
timestep 1e-4
"""
LAST = 'write_dump all custom OUT id x y vx modify FORMAT "%d %.17g %.17g %.17g" sort id\n'


def given(tmp_path, name, text, **words):
    deck = tmp_path / f"in.{name}"
    text = text.replace("FORMAT", FORMATS.get(words.get("host"), "format"))
    deck.write_text(text.replace("OUT", str(tmp_path / name)))
    succeed(deck, **words)
    return (tmp_path / name).read_text()


COUNT = "".join(
    f'variable n equal count({name})\nprint "COUNT {name} ${{n}}"\n'
    for name in ("balls", "cage", "inner", "outer", "moving")
)


@HOSTS
def test_groups(tmp_path, host):
    deck = deck_file(tmp_path, BOX + RACEWAYS + CREATE + " groups yes\n" + COUNT)
    found = dict(re.findall(r"^COUNT (\w+) (\d+)$", succeed(deck, host=host).text, re.M))
    assert found == {"balls": "9", "cage": "9", "inner": "1", "outer": "1", "moving": "18"}
    # several bearings share the groups
    more = CREATE.replace("1 2 3 4", "1 none 3 4").replace(" cage 8.38e-3", "")
    small = more.replace("balls 9", "balls 5") + " centre 0 0 0.03 groups yes\n"
    deck.write_text(BOX + RACEWAYS + CREATE + " groups yes\n" + small + COUNT)
    found = dict(re.findall(r"^COUNT (\w+) (\d+)$", succeed(deck, host=host).text, re.M))
    assert found == {"balls": "14", "cage": "9", "inner": "2", "outer": "2", "moving": "23"}


@HOSTS
def test_one_command_for_new_and_resumed_runs(tmp_path, host):
    """A run of ten steps gives the same output as a restart file from its middle followed by the
    second half."""
    new = BOX + RACEWAYS + CREATE + " groups yes\n" + MOVE
    halves = f"run 5\nwrite_restart {tmp_path}/re\nrun 5\n"
    whole = given(tmp_path, "whole", new + halves + LAST, host=host)
    begin = BOX[: BOX.index("region")].replace("boundary f f f\n", "")
    again = begin + f"read_restart {tmp_path}/re\nneighbor 2.0e-3 bin\n"
    again += "neigh_modify delay 0 every 20 check yes\n"
    again += f"{CREATE} groups yes\n{MOVE}run 5\n"
    assert given(tmp_path, "again", again + LAST, host=host) == whole


NAMED = """
bearing a 6208 types 1 2 3 4 clearance 1.0e-5
bearing c 6305 types 5 6 7 8 clearance 8.0e-6
BEGIN
pair_style bearing oil vg46 temperature 60 models full
pair_coeff * * a
pair_coeff * * c oil vg100 temperature 30
create_bearing a speed 100 -30
create_bearing c centre 0 0 0.2 speed 100 -30
fix rails_a cage bearing/cage a
fix rails_c cage bearing/cage c
fix inner inner bearing/ring mass 0.2 free loaded spin speed 100 load 1000 ramp 3.0e-3
fix move all bearing/implicit
timestep 1.0e-4
"""


@HOSTS
def test_named_bearings_after_read_restart(tmp_path, host):
    """The same commands create the bearings of a new run and make the groups of a run from a
    restart file. Outer rings without a fix keep their spin."""
    space = box("-0.06 0.06 -0.06 0.06 -0.06 0.36", 8, "${a_skin} nsq")
    new = NAMED.replace("BEGIN", space)
    last = 'print "IS $(step) $(f_inner[2]) $(f_inner[2][2]) $(f_inner[2][12])"\n'
    kept = tmp_path / "re"
    said = []
    for name, deck in (
        ("whole", f"{new}run 50\nwrite_restart {kept}\nrun 50\n"),
        ("again", re.sub("region.*box\n", f"read_restart {kept}\n", new, flags=re.S) + "run 50\n"),
    ):
        (tmp_path / name).write_text(deck + last)
        said.append(re.findall(r"^IS .*$", succeed(tmp_path / name, host=host).text, re.M))
    assert said[0] == said[1] and said[0][0].startswith("IS 100 ")


BY_HAND = """
dump contacts balls local 2 OUT.contacts c_contact[1] c_contact[2]
dump_modify contacts append APPEND FORMAT "%.0f %.12g"
fix rings all print 2 "VALUES" FILE OUT.rings screen no title TITLE
"""
AT_ONCE = """
bearing_dump contacts balls 2 OUT.contacts contact append APPEND columns names
bearing_dump rings all 2 OUT.rings inner append APPEND
print "NAMES ${names}"
"""


@HOSTS
def test_dump(tmp_path, host):
    """A file that is started in one run and continued in the next is identical, byte for byte, to
    one written with the commands of the host."""
    first = BOX + RACEWAYS + CREATE + " groups yes\n" + MOVE
    first += "compute contact balls bearing/contact ball load\n"
    said = {}
    names = [row["name"] for row in core.table("columns")["fix_ring"]]
    names = names[: names.index("torque") + 1]  # without the loads, which are variables of the deck
    values = ["$(step)", "$(step*dt)", *(f"$(f_inner[{k + 1}])" for k in range(len(names)))]
    words = {"FORMAT": FORMATS.get(host, "format"), "VALUES": " ".join(values), "FILE": "file"}
    words["TITLE"] = f'"# step time {" ".join(names)}"'
    more_words = {**words, "FILE": "append", "TITLE": "none"}
    for name, text in (("hand", BY_HAND), ("once", AT_ONCE)):
        new, more = text.replace("APPEND", "no"), text.replace("APPEND", "yes")
        for word, meaning in words.items():
            new, more = new.replace(word, meaning), more.replace(word, more_words[word])
        end = "run 4\nundump contacts\nunfix rings\n"
        deck = deck_file(
            tmp_path,
            (first + new + end + more + end).replace("OUT", str(tmp_path / name)),
            f"in.{name}",
        )
        said[name] = succeed(deck, host=host).text
    assert re.findall(r"^NAMES (.*)$", said["once"], re.M) == ["ball load"] * 2
    for kind in ("contacts", "rings"):
        once = (tmp_path / f"once.{kind}").read_bytes()
        assert len(once) > 500 and once == (tmp_path / f"hand.{kind}").read_bytes()


@pytest.mark.parametrize(
    "words, says",
    [
        ("d all 0 f contact", "steps between samples is 0, must be"),
        ("d all 1 f nothing", "there is no compute or fix 'nothing'"),
        ("d all 1 f contact sort", "unknown keyword or one argument too many: 'sort'"),
        ("d all 1 f contact append maybe", "append is 'maybe', must be one of: no, yes"),
    ],
)
def test_dump_refused(tmp_path, words, says):
    compute = "compute contact all bearing/contact ball load\n"
    text = f"{BOX}{RACEWAYS}{CREATE}\n{compute}bearing_dump {words}\n"
    refuses(deck_file(tmp_path, text), "bearing_dump", says)


@HOSTS
def test_balance(tmp_path, host):
    """The fix computes which fraction of the mean load is not carried by the contacts, along the
    free directions; here only y is free."""
    deck = tmp_path / "in.balance"
    text = BOX + RACEWAYS + CREATE + " groups yes\n" + MOVE.replace("x free y free", "y free")
    text += "fix mean all ave/time 2 20 40 f_inner[12] f_inner[19]\n"
    text += f"fix keep all bearing/checkpoint 2 {tmp_path}/re balance inner\n"
    text += 'run 40\nprint "IS $(f_keep) $(f_mean[1]) $(f_mean[2])"\n'
    deck.write_text(text)
    share, force, load = map(
        float, re.findall(r"^IS (.*)$", succeed(deck, host=host).text, re.M)[-1].split()
    )
    assert load == pytest.approx(-400, rel=0.1) and 1e-4 < share < 0.5
    assert share == pytest.approx(np.abs((force + load) / load), rel=1e-12)


def test_balance_of_a_resumed_run(tmp_path):
    """The fraction is computed from all samples, before and after the restart."""
    begin = BOX + RACEWAYS + CREATE + " groups yes\n"
    again = BOX[: BOX.index("region")].replace("boundary f f f\n", "")
    again += f"read_restart {tmp_path}/re\nneighbor 2.0e-3 bin\n"
    again += f"neigh_modify delay 0 every 20 check yes\n{CREATE} groups yes\n"
    keep = f"fix keep all bearing/checkpoint 2 {tmp_path}/re last yes balance inner "
    said = []
    for first, words, steps in ((begin, "", 40), (begin, "", 20), (again, "resume yes", 20)):
        deck = deck_file(
            tmp_path, f'{first}{MOVE}{keep}{words}\nrun {steps}\nprint "IS $(f_keep)"\n'
        )
        said += re.findall(r"^IS (.*)$", succeed(deck).text, re.M)
    whole, half, resumed = said
    assert whole == resumed != half


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
def test_main_deck_that_has_not_settled(tmp_path, host):
    given = {"passes": 1, "samples": 20, "rpm": 20000, "settle": 0, "inner_mass": 200}
    says = "contacts do not carry", "of the load, at most 0.05 is allowed: not settled"
    refuses("inputs/in.6208", *says, host=host, out=tmp_path / "run", **given)
