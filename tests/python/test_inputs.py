# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the data files for decks."""

import math
import re

import pytest
from host import ROOT
from raceway import catalogue, inputs
from raceway.theory import makers
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.operating_point import figures


def test_values(tmp_path):
    path = tmp_path / "data"
    path.write_text(
        "# variable no index 1\nvariable film index film\n  variable  a index\t1.0e-7 # m\n\n"
        "variable b index 2#mm, # wide\nvariable a index 3 # ignored, as in a deck\n"
    )
    assert inputs.values(path) == {"film": "film", "a": "1.0e-7", "b": "2"}
    assert inputs.comments(path) == {"a": "m", "b": "mm, # wide"}


@pytest.mark.parametrize(
    "line",
    ["balls: 8", "variable balls 8", "variable balls equal 8", "variable balls index # 8", "balls"],
)
def test_line_in_another_form(tmp_path, line):
    """Decks reject such lines too (`tests/hosts/test_own_deck.py`)."""
    (tmp_path / "data").write_text(f"variable a index 1\n\n{line}\nvariable b index 2\n")
    (tmp_path / "own.csv").write_text(f"# data\n{line}\nname,a,source\nrow,4,me\n")
    for file, name, number in (("data", "data", 3), ("own.csv", "row", 2)):
        with pytest.raises(inputs.InputError) as error:
            inputs.values(tmp_path / name)
        says = f"{tmp_path / file}, line {number}: a line of data is 'variable NAME index VALUE', "
        assert str(error.value) == f"{says}not '{line}'"


def test_first_value_counts(tmp_path):
    """As in the host, which takes the row's value before the value of all rows of a table."""
    (tmp_path / "data").write_text("variable a index 1\nvariable a index 2\n")
    (tmp_path / "own.csv").write_text("variable a index 3\nname,a,source\nrow,4,me\nother,,me\n")
    assert inputs.values(tmp_path / "data") == {"a": "1"}
    assert inputs.values(tmp_path / "row") == {"a": "4"}
    assert inputs.values(tmp_path / "other") == {"a": "3"}


def test_bearing(bearing):
    assert inputs.bearing(ROOT / "inputs/bearings/6208") == bearing


@pytest.mark.parametrize("name", ["7208", "7205B", "7208C", "6210"])
def test_pitch_diameter(name):
    """The stated pitch circle is that of balls that touch both raceways at the contact angle. The
    circle half-way between the raceways has this size only if both grooves have the same radius or
    the contact angle is 0."""
    path = catalogue.find("bearings", name)
    one, cosine = inputs.bearing(path), math.cos(inputs.nominal_angle(path))
    stated = inputs.numbers(path, "pitch_diameter")["pitch_diameter"]
    for side, out in ((INNER, -1), (OUTER, 1)):
        centre = one.groove_circle(side) + out * one.groove_gap(side) * cosine
        assert 2 * centre == pytest.approx(stated, rel=1e-15)
    apart = (one.outer_groove - one.inner_groove) * (1 - cosine)
    assert 2 * one.pitch_radius - stated == pytest.approx(apart, rel=1e-9, abs=1e-16)
    assert one.pitch_radius == pytest.approx(stated / 2, rel=5e-4)


def test_series_without_constants(tmp_path):
    """Only the torque by SKF's formula is missing if it has no constants for the series."""
    path, text = tmp_path / "own", (ROOT / "inputs/bearings/6208").read_text()
    found = []
    for series in ("62", "32"):
        path.write_text(re.sub(r"(variable series +index) \S+", rf"\1 {series}", text))
        found.append(figures(str(path), "vg46", load=1000.0, rpm=1000.0))
    known, unknown = found
    assert unknown["absent"]["torque_skf_N_m"] == makers.NO_SERIES
    assert unknown["friction_torque_N_m"] == known["friction_torque_N_m"]
    assert known["torque_skf_N_m"] > 0


def test_composite_roughness(tmp_path):
    path = tmp_path / "oil"
    text = (
        (ROOT / "inputs/lubricants/mineral")
        .read_text()
        .replace("ball_roughness     index 0", "ball_roughness index 7.5e-8")
    )
    path.write_text(text)
    # 100 and 75 nm combine to 125 nm, as in a 3-4-5 triangle
    assert inputs.oil(path) == pytest.approx((0.040, 22e-9, 2.25, 1.25e-7), rel=1e-15)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (None, "cannot read"),
        ("\ufeffvariable viscosity index 0.04\n", "starts with a byte order mark"),
        ("variable permittivity index 2\n", "has no viscosity"),
        (
            "".join(
                f"variable {name} index x\n" for name in (*inputs.Oil._fields, "ball_roughness")
            ),
            "is not a number",
        ),
    ],
)
def test_bad_file(tmp_path, text, message):
    path = tmp_path / "oil"
    if text is not None:
        path.write_text(text)
    with pytest.raises(inputs.InputError, match=message):
        inputs.oil(path)


def test_bad_bearing(tmp_path):
    path = tmp_path / "bearing"
    path.write_text((ROOT / "inputs/bearings/6208").read_text().replace("6.552e-3", "6.2e-3"))
    with pytest.raises(inputs.InputError, match="conformal"):
        inputs.bearing(path)
    path.write_text((ROOT / "inputs/bearings/6208").read_text().replace("index 9  ", "index 16  "))
    with pytest.raises(inputs.InputError, match="overlapping balls: 16 balls of diameter 0.0126 m"):
        inputs.bearing(path)
