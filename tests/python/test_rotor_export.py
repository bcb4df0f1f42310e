# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the stiffness and damping exported for rotor programs: axes, names, units, files, and
their use in ROSS."""

import csv
import json
import sys
import tomllib
import types

import numpy as np
import pytest
from bearings import B6208
from commands import reply
from raceway import beam, beam_motion, export, static
from raceway.cli import main
from raceway.errors import RacewayError, RunWarning
from raceway.export import rotor
from raceway.theory.beam import Disc, Section, Steel
from raceway.theory.small_motion import Response
from raceway.units import prefixed

CASE = dict(axial=2500.0, clearance=20e-6, phases=1)
OILED = dict(lubricant="vg46", temperature=70.0, models="paper", **CASE)
# the first six natural frequencies in Hz of the rotor below at 6000 rpm, computed by ROSS 2.3.0
# with the exported arguments: with its BearingElement only, and with the remaining terms added to
# K0
ROSS_HELD = (267.5332352, 267.852525, 677.395444, 1008.881426, 1152.218606, 2721.708329)
ROSS_WHOLE = (273.4117005, 273.8277096, 675.3206635, 1012.398655, 1155.409870, 2639.294152)


@pytest.fixture(scope="module")
def point():
    return rotor.points("6208", 1500.0, 6000.0, **CASE)[0]


@pytest.fixture(scope="module")
def oiled():
    return rotor.points("6208", [1500.0], [1000.0, 3000.0, 6000.0], **OILED)


@pytest.fixture(scope="module")
def shaft():
    """Return a shaft of ROSS's steel with eight elements, each 50 mm long and 40 mm in diameter,
    and with a disc of 0.2 m diameter in the middle."""
    steel = Steel(211e9, 211e9 / (2 * 81.2e9) - 1, 7810.0)
    z, pieces = beam.divided([Section(0.4, 0.04)], np.linspace(0.0, 0.4, 9))
    mass = 7810.0 * np.pi / 4 * (0.2**2 - 0.04**2) * 0.02
    across = mass * (3 * (0.2**2 + 0.04**2) / 4 + 0.02**2) / 12
    disc = Disc(0.2, mass, mass * (0.2**2 + 0.04**2) / 8, across)
    return beam_motion.matrices(z, pieces, [disc], steel)


def whirl(shaft, five):
    """Return the natural frequencies in Hz at 6000 rpm, with springs given by the (5, 5) matrix
    `five` at both ends."""
    springs = np.zeros_like(shaft.stiffness)
    springs[:5, :5], springs[-5:, -5:] = five, five
    return beam_motion.frequencies(shaft, springs, 200 * np.pi)[:6] / (2 * np.pi)


def test_as_ross(shaft, point):
    """The natural frequencies of our beam equal those of ROSS 2.3.0, both with the arguments alone
    and with the remaining terms added."""
    named, five = rotor.ross_of([point]), np.zeros((5, 5))
    for name in ("xx", "xy", "yx", "yy", "zz"):
        five["xyz".index(name[0]), "xyz".index(name[1])] = named["k" + name]
    assert whirl(shaft, five) == pytest.approx(ROSS_HELD, rel=1e-7)
    five += rotor.rest(point)[0][:5, :5]
    assert np.array_equal(five, point.over.mean.stiffness)
    assert whirl(shaft, five) == pytest.approx(ROSS_WHOLE, rel=1e-7)


def test_arguments(point, oiled):
    """A single speed gives plain floats without a frequency. Several speeds give lists, together
    with the frequency in rad/s."""
    one, many = rotor.ross_of([point]), rotor.ross_of(oiled)
    assert all(type(value) is float for value in one.values()) and "frequency" not in one
    assert set(many) == {*one, "frequency"}
    assert all(type(value) is list and type(value[0]) is float for value in many.values())
    assert many["frequency"] == pytest.approx([104.72, 314.159, 628.319], rel=1e-5)
    assert one["kxx"] == point.over.mean.stiffness[0, 0] and one["cxx"] == 0.0
    assert many["cyy"][1] == oiled[1].over.mean.damping[1, 1] > 100.0
    assert many["cxx"][0] > many["cxx"][2]  # thicker films damp less
    assert export.ross("6208", 1500.0, 6000.0, **CASE) == one
    assert point.over.mean.stiffness[0, 4] < 0 < point.over.mean.stiffness[1, 3]  # axes of ROSS


def test_free_tilts():
    """If no moments act, the compliance is that of a ring with free tilts."""
    here = rotor.points("6208", 1500.0, 0.0, axial=2500.0, phases=1, moment=(0.0, 0.0))[0]
    found, _ = rotor.translations(here, "free")
    step, loads = 10.0, np.eye(3) * 10.0
    places = []
    for sign in (-1, 1):
        rests = [
            static.equilibrium(
                B6208,
                np.hypot(*(load := np.array([1500.0, 0.0, 2500.0]) + sign * extra)[:2]),
                load[2],
                load_azimuth=np.arctan2(load[1], load[0]),
                moment=(0.0, 0.0),
            )
            for extra in loads
        ]
        places.append(np.array([one.shift for one in rests]).T)
    softness = (places[1] - places[0]) / (2 * step)
    assert found == pytest.approx(np.linalg.inv(softness), rel=2e-3, abs=2e-3 * found.max())
    with pytest.raises(ValueError, match="tilts 'loose' is not one of held, free"):
        rotor.translations(here, "loose")


def test_add_rest(point):
    """The remaining terms are added to the rows of the node in K0 and C0."""
    there = types.SimpleNamespace(number_dof=6, K0=np.ones((24, 24)), C0=np.zeros((24, 24)))
    rotor.add_rest(there, 2, point)
    added, mean = there.K0 - 1, point.over.mean
    assert added[12, 16] == pytest.approx(mean.stiffness[0, 4]) and added[12, 12] == 0
    assert added[15, 15] == pytest.approx(mean.stiffness[3, 3]) and added[12, 14] != 0
    assert np.all(added[:12] == 0) and np.all(added[17:] == 0)
    there.number_dof = 4
    with pytest.raises(RacewayError, match="4 degrees of freedom per node"):
        rotor.add_rest(there, 2, point)


def test_element(monkeypatch, point):
    """The element is created from the arguments. If ROSS is missing, the message contains the
    command that installs it."""
    fake = types.ModuleType("ross")
    fake.BearingElement = lambda node, **named: (node, named)
    monkeypatch.setitem(sys.modules, "ross", fake)
    node, named = rotor.element(np.int64(3), "6208", 1500.0, 6000.0, tag="left", **CASE)
    assert type(node) is int and node == 3
    assert named == {"tag": "left", **rotor.ross_of([point])}
    monkeypatch.setitem(sys.modules, "ross", None)
    with pytest.raises(RacewayError, match="pip install ross-rotordynamics 'plotly<7'"):
        rotor.element(3, "6208", 1500.0, 6000.0, **CASE)


def test_csv(tmp_path, oiled):
    path = rotor.write_csv(oiled, tmp_path / "k.csv")
    first, *rows = list(csv.reader(path.read_text().splitlines()))
    assert len(rows) == 3 and {len(first)} == {len(row) for row in rows}
    data = dict(zip(first, map(float, rows[1])))
    mean = oiled[1].over.mean
    assert data["speed [rpm]"] == 3000.0 and data["axial load [N]"] == 2500.0
    assert data["kxx [N/m]"] == pytest.approx(mean.stiffness[0, 0], rel=1e-8)
    assert data["kxry [N/rad]"] == pytest.approx(mean.stiffness[0, 4], rel=1e-8)
    assert data["cryry [N m s/rad]"] == pytest.approx(mean.damping[4, 4], rel=1e-8)
    assert data["most kyy [N/m]"] == pytest.approx(oiled[1].over.most.stiffness[1, 1], rel=1e-8)


def test_command_writes_what_ross_reads(tmp_path, capsys, oiled):
    path = tmp_path / "b.toml"
    words = "stiffness --load 1500 --axial 2500 --clearance 20e-6 --rpm 1000 3000 6000 --phases 1"
    words += f" --lubricant vg46 --temperature 70 --models paper --node 4 --out {path}"
    assert reply(capsys, words) == f"{path}\n"
    (name, table), *others = tomllib.loads(path.read_text()).items()
    assert name == "BearingElement_6208" and not others
    assert table == {"n": 4, "tag": "6208", **rotor.ross_of(oiled)}
    found = json.loads(rotor.write_json(oiled, tmp_path / "b.json").read_text())
    assert found == rotor.as_mapping(oiled) and found["order"] == ["x", "y", "z", "rx", "ry"]


def test_command_prints(capsys):
    heading, *rows = reply(capsys, "stiffness --load 1000 3000 --phases 2").splitlines()
    assert heading.split()[:3] == ["rpm", "load", "kxx"] and len(rows) == 2
    least = rotor.points("6208", 3000.0, 0.0, phases=2)[0].over.least.stiffness[1, 1]
    assert rows[1].split()[7:9] == prefixed(least, "N/m").split()


@pytest.mark.parametrize(
    "words, says",
    [
        (["--out", "a.xls"], "must end in .csv, .json, .toml"),
        (["--load", "1", "2", "--out", "a.toml"], "ROSS accepts only one load, not 2"),
        (["--rpm", "2", "1"], "speeds must be in ascending order"),
        (["--lubricant", "vg46"], "give --rpm above 0"),
        (["--rpm", "9", "--temperature", "70"], "give --lubricant"),
        (["--rpm", "9", "--frequency", "50"], "--frequency applies to the damping; give --lubr"),
        (["--node", "-1"], "must be at least 0"),
    ],
)
def test_wrong_words(words, says, capsys):
    assert says in reply(capsys, ["stiffness", *words], code=2)


def test_frequency(oiled):
    """A bearing without a lubricant has no dampers, so that its stiffness does not depend on the
    frequency; that of a bearing with films does."""
    slow, fast = (
        rotor.points("6208", 1500.0, 1000.0, frequency=w, **CASE)[0].over.mean for w in (0.0, 1e5)
    )
    assert not fast.damping.any() and (slow.stiffness == fast.stiffness).all()
    wet = rotor.points("6208", 1500.0, 1000.0, frequency=1e5, **OILED)[0].over.mean
    assert (np.diag(wet.damping) < np.diag(oiled[0].over.mean.damping)).all()


def test_incomplete_lubricant(tmp_path, capsys):
    oil = tmp_path / "oil"
    names = dict(viscosity=0.04, pressure_viscosity=22e-9, permittivity=2.2, temperature=40)
    names |= dict(roughness=1e-7, ball_roughness=0)
    oil.write_text("".join(f"variable {key} index {value}\n" for key, value in names.items()))
    words = ["stiffness", "--load", "100", "--rpm", "100", "--phases", "1", "--lubricant", str(oil)]
    assert "which models full need, unlike models paper" in reply(capsys, words, code=1)
    assert main([*words, "--models", "paper"]) == 0


def test_smoothing_warns():
    """There is a warning that ROSS would alter damping that decreases steeply over a table of six
    speeds."""
    mean = static.equilibrium(B6208, 1500.0, 2500.0).stiffness
    both = [Response(mean, np.eye(5) * damping) for damping in (9.0, 4.0, 1.0, 0.5, 0.3, 0.2)]
    table = [
        rotor.Point(1000.0 * k, 1500.0, 2500.0, rotor.OverPass(one, one, one))
        for k, one in enumerate(both, 1)
    ]
    with pytest.warns(RunWarning, match="changes cxx by .* of 9, cyy by .*four speeds or fewer"):
        rotor.ross_of(table)
    assert rotor.ross_of(table[:4])["cxx"] == [9.0, 4.0, 1.0, 0.5]
    with pytest.raises(ValueError, match="one load, in order of increasing speed"):
        rotor.ross_of(table[::-1])
