# SPDX-License-Identifier: GPL-2.0-or-later
"""Bearing and oil data that plain decks obtain by name equal the data that Python reads: default
data, rows of a table, a user's files, and oils at a given temperature."""

import math
import re

import pytest
import raceway
from host import ROOT, box, deck_file, succeed
from raceway import catalogue, inputs
from raceway.theory import makers

BEARINGS, OILS = ROOT / "inputs/bearings", ROOT / "inputs/lubricants"
HOSTS = ["liggghts", "lammps", "wheel"]
NAME = "bearing b ${bearing} types 1 2 3 4 clearance ${clearance} vars four_point contact_angle\n"
HEAD = "variable bearing index 6208\nvariable clearance index 0\n" + NAME
SCENE = (
    HEAD
    + """variable lubricant index vg46
variable temperature index 40
variable rpm index 1500
variable out index x
"""
    + box(neighbor="${b_skin} nsq")
    + """
pair_style bearing oil ${lubricant} temperature ${temperature} models full
pair_coeff * * b
variable omega equal 2*PI*${rpm}/60
create_bearing b speed ${omega} 0
fix rails cage bearing/cage b
fix move all bearing/implicit
fix record all bearing/record 1 ${out}
timestep 1.0e-6
run 0
"""
)


def told(tmp_path, names, head=HEAD, **words):
    """Return a dict that maps each of `names` to the text of the deck variable b_NAME."""
    deck = deck_file(
        tmp_path, head + "".join(f'print "IS {name} ${{b_{name}}}"\n' for name in names)
    )
    lines = succeed(deck, **words).text.splitlines()
    return dict(line.split(None, 2)[1:] for line in lines if line.startswith("IS "))


def recorded(tmp_path, **words):
    """Return the record of a run of the scene."""
    deck = deck_file(tmp_path, SCENE)
    succeed(deck, out=tmp_path / "run", **words)
    return raceway.open(tmp_path / "run").tables.record


USUAL = [("7208", 0.0), ("6303", 0.0), ("6303", -7e-6), ("7205B", 0.0)]


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("name, clearance", USUAL)
def test_usual_data(tmp_path, host, name, clearance):
    radii = ("inner_radius", "outer_radius", "inner_groove", "outer_groove")
    others = ("cage_ball_diameter", "box", "inner_mass", "inner_inertia", "inner_inertia_t")
    texts = told(tmp_path, (*radii, *others), host=host, bearing=name, clearance=clearance)
    found = {key: float(value) for key, value in texts.items()}
    data, file = inputs.bearing(BEARINGS / name), inputs.values(BEARINGS / name)
    wanted = {key: getattr(data, key) for key in radii}
    wanted["outer_radius"] += clearance / 2
    bore, width = float(file["bore_diameter"]) / 2, float(file["bearing_width"])
    shoulder = data.inner_radius + 0.18 * data.ball_diameter
    squares = shoulder**2 + bore**2
    mass = wanted["inner_mass"] = 7800 * math.pi * (shoulder**2 - bore**2) * width
    wanted["inner_inertia"] = mass * squares / 2
    wanted["inner_inertia_t"] = mass * (3 * squares + width**2) / 12
    half = float(file["pitch_diameter"]) * math.sin(math.pi / 2 / data.balls)
    gap = 2 * half - data.ball_diameter
    wanted["cage_ball_diameter"] = gap - float(file["pocket_play"])
    wanted["box"] = 1.3 * wanted["outer_radius"]
    assert found == pytest.approx(wanted, rel=1e-13)


def test_contact_angle(tmp_path):
    """If its contact angle is changed, a bearing keeps the circle of its balls."""
    names = ("inner_radius", "outer_radius")
    given = told(tmp_path, names, bearing="7208", contact_angle=25)
    data = inputs.bearing(BEARINGS / "7208")
    way = math.cos(math.radians(25)) - math.cos(math.radians(40))
    for side, sign in (("inner", 1), ("outer", -1)):
        moved = sign * (getattr(data, f"{side}_groove") - data.ball_radius) * way
        radius = getattr(data, f"{side}_radius") + moved
        assert float(given[f"{side}_radius"]) == pytest.approx(radius, rel=1e-13), side


def test_what_is_given_stays(tmp_path):
    names = ("inner_mass", "inner_inertia")
    given = told(tmp_path, names, bearing="7208", inner_mass="0.250")
    own = told(tmp_path, names, bearing="7208")
    assert given["inner_mass"] == "0.250"
    share = 0.25 / float(own["inner_mass"])
    assert float(given["inner_inertia"]) == pytest.approx(
        share * float(own["inner_inertia"]), rel=1e-14
    )


def test_usual_play_of_a_pocket(tmp_path):
    """A file without this play, which makers do not state, has that of a cage ring."""
    file = tmp_path / "own"
    text = (BEARINGS / "7208").read_text()
    file.write_text(re.sub("^variable pocket_play .*\n", "", text, flags=re.M))
    play = 0.025 * inputs.bearing(BEARINGS / "7208").ball_diameter
    own = told(tmp_path, ["cage_ball_diameter"], bearing=file)
    given = told(tmp_path, ["cage_ball_diameter"], bearing="7208", pocket_play=play)
    assert own == given


@pytest.mark.parametrize("name", ["6210", "7205B", "7010AC"])
def test_row_is_a_file(tmp_path, name):
    """A table row, used on two ranks, and the file that `raceway catalogue --file` writes for this
    row give every variable the same text."""
    path = tmp_path / name
    path.write_text(inputs.text(catalogue.find("bearings", name, ROOT / "inputs")))
    names = ("balls", "ball_diameter", "inner_radius", "outer_groove", "cage_ball_diameter")
    row = told(tmp_path, names, bearing=name, ranks=2)
    assert row == told(tmp_path, names, bearing=path)
    assert row["ball_diameter"] == inputs.values(BEARINGS / name)["ball_diameter"]


def test_four_point(tmp_path):
    """The record contains the offset of the arch, and groove radii that account for it."""
    record = recorded(tmp_path, four_point=35, clearance=4e-6)
    bearing = inputs.bearing(BEARINGS / "6208", four_point=math.radians(35))
    for side, play in (("inner", 0.0), ("outer", 2e-6)):
        radius, offset = record.fixed(f"{side}_radius")[0], record.fixed(f"{side}_arch")[0]
        assert radius == pytest.approx(getattr(bearing, f"{side}_radius") + play, rel=2e-15)
        assert offset == pytest.approx(max(getattr(bearing.layout, side)[0]), rel=4e-15)


@pytest.mark.parametrize("warm", [-20.0, 70.0])
@pytest.mark.parametrize("name", ["vg32", "vg46", "vg68", "vg100", "pao8", "grease110"])
def test_oils_at_a_temperature(tmp_path, name, warm):
    """The pair style receives the viscosity according to Walther's or Vogel's equation, and the
    other data of the oil."""
    record = recorded(tmp_path, lubricant=name, temperature=warm)
    oil = inputs.fluid(OILS / name, warm)
    assert record.fixed("viscosity")[0] == pytest.approx(oil.viscosity, rel=1e-14)
    words = record.attrs["pair_commands"].split("\n")[1].split()
    at = words.index("lubricant")
    assert float(words[at + 2]) == pytest.approx(oil.pressure_viscosity, rel=1e-14)
    assert float(words[words.index("drag") + 1]) == pytest.approx(oil.density, rel=1e-14)


@pytest.mark.parametrize("rpm", [477.5, 9549])
def test_starvation(tmp_path, rpm):
    record = recorded(tmp_path, bearing=6205, temperature=20, rpm=rpm)
    oil = inputs.fluid(OILS / "vg46", 20.0)
    skf = makers.skf(inputs.boundary(BEARINGS / "6205"), 1.0, 0.0, rpm, oil.kinematic)
    words = record.attrs["pair_commands"].split("\n")[1].split()
    assert skf.starvation < 0.99
    share = float(words[words.index("rolling") + 3])
    assert share == pytest.approx(float(skf.starvation), rel=1e-14)
