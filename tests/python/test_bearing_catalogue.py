# SPDX-License-Identifier: GPL-2.0-or-later
"""Bearings in the catalogue: their balls follow from the load ratings, their columns are
consistent, and each bearing carries a load."""

import csv
import math
import re
from pathlib import Path

import numpy as np
import pytest
from host import ROOT
from raceway import data_table, inputs, listing, load_rating, static

BEARINGS = ROOT / "inputs" / "bearings"
NAMES = data_table.names(BEARINGS)
RATED = [name for name in NAMES if name not in ("7208", "harris209")]
lines = (BEARINGS / "catalogue.csv").read_text().splitlines()
TABLE = list(csv.DictReader(line for line in lines if re.match(r"name,|\w+,\d", line)))
DEEP, ANGULAR, FOUR_POINT = (
    [row for row in TABLE if row["kind"] == kind]
    for kind in ("deep groove", "angular contact", "four-point contact")
)
# Ratio of the value of C stated by the maker to the value that ISO 281 gives for the balls. With a
# ratio of 1, the same balls result for the three contact angles that JTEKT offers in one size. For
# SKF's 6205, with the balls measured by CWRU, the ratio is 1.06. With a ratio of 1, the balls of
# the QJ bearings have the diameters that GMN states for 7207, 7208, 7209 and 7210.
DYNAMIC_FACTOR = {"SKF": 1.05, "SKF QJ": 1.0, "JTEKT": 1.0}


def numbers(row, *names):
    return [float(row[name]) for name in names]


@pytest.mark.parametrize("row", TABLE, ids=lambda row: row["name"])
def test_balls_follow_from_the_ratings(row):
    """Estimated balls agree with `load_rating.balls`. If the maker states the ball diameter, the
    number of balls follows from C0."""
    rated = numbers(row, "basic_dynamic_load", "basic_static_load")
    bore, outside, ball, pitch = numbers(
        row, "bore_diameter", "outside_diameter", "ball_diameter", "pitch_diameter"
    )
    angle = math.radians(float(row["four_point"] or row["contact_angle"] or 0))
    if row["balls_from"] == "estimate":
        rows, factor = (2 if row["four_point"] else 1), DYNAMIC_FACTOR[row["source"]]
        number, found = load_rating.balls(*rated, pitch, angle, factor, rows=rows)
        assert row["ball_diameter_from"] == "estimate"
    else:
        assert (row["balls_from"], row["ball_diameter_from"]) == ("from C0", row["source"])
        number, found = load_rating.number(rated[1], ball, pitch, angle), ball
    assert (number, round(found, 6)) == (int(row["balls"]), ball)
    if row["pitch_diameter_from"] != row["source"]:
        assert row["pitch_diameter_from"] == "(bore + outside diameter)/2"
        assert pitch == pytest.approx((bore + outside) / 2, rel=1e-12)
    assert float(row["pocket_play"]) == pytest.approx(round(0.01 * ball, 5), rel=1e-12)
    if row in DEEP:
        assert row["series"] == row["name"][:2]


def test_names_stand_once():
    """A file next to the table takes precedence over a row of the table, so no row may have the
    name of a file."""
    files = {path.name for path in BEARINGS.iterdir()}
    assert not files & {row["name"] for row in TABLE}
    assert len(NAMES) == len(TABLE) + len(files) - 1 and len(TABLE) == 116


def test_every_size_is_there():
    """Series 60, 62 and 63, and series 70 and 72 with three contact angles, contain all bores from
    10 to 50 mm. The bore in the file or table agrees with the designation."""
    bores = {"00": 10, "01": 12, "02": 15, "03": 17} | {f"{n:02}": 5 * n for n in range(4, 11)}
    for code, bore in bores.items():
        for series in ("60", "62", "63", "70", "72"):
            for letter in "CAB" if series[0] == "7" else ("",):
                one = listing.entry(BEARINGS / f"{series}{code}{letter}")
                assert one.bore_m == pytest.approx(1e-3 * bore)
                assert one.dynamic_load_N > one.static_load_N > 0


def test_columns_of_a_table_belong_together():
    """These relations reveal a misplaced column: the shoulders lie on both sides of the pitch
    diameter, the load centre corresponds to the nominal angle (two bearings of series 72 in JTEKT's
    table are 0.45 mm off), heavier bearings have higher ratings, and the f_0 in the catalogue
    agrees with ISO 76."""
    for row in DEEP:
        bore, outside, low, high = numbers(
            row,
            "bore_diameter",
            "outside_diameter",
            "inner_shoulder_diameter",
            "outer_shoulder_diameter",
        )
        assert bore < low < (bore + outside) / 2 < high < outside
        assert (low + high) / (bore + outside) == pytest.approx(1, abs=0.03)
        static_load, fatigue = numbers(row, "basic_static_load", "fatigue_load_limit")
        assert 22.5 < static_load / fatigue < 24.5
    for row in (row for row in ANGULAR if row["load_centre"]):
        bore, outside, width, angle, centre = numbers(
            row,
            "bore_diameter",
            "outside_diameter",
            "bearing_width",
            "contact_angle",
            "load_centre",
        )
        found = width / 2 + (bore + outside) / 4 * math.tan(math.radians(angle))
        assert centre == pytest.approx(found, abs=0.5e-3)
    for row in FOUR_POINT:
        bore, outside, high, static_load, fatigue = numbers(
            row,
            "bore_diameter",
            "outside_diameter",
            "outer_shoulder_diameter",
            "basic_static_load",
            "fatigue_load_limit",
        )
        assert (bore + outside) / 2 < high < outside
        assert 22.5 < static_load / fatigue < 26.5
    for rows in (DEEP, ANGULAR, FOUR_POINT):
        for one, other in zip(rows, rows[1:]):
            if (
                one["name"][:3] == other["name"][:3]
                and one["bore_diameter"] != other["bore_diameter"]
            ):
                assert float(one["bearing_mass"]) < float(other["bearing_mass"])
    for row in (*DEEP, *ANGULAR):
        if row["f0"]:
            data = inputs.bearing(BEARINGS / row["name"])
            pitch = listing.entry(BEARINGS / row["name"]).pitch_diameter_m
            angle = math.radians(float(row["contact_angle"] or 0))
            found = load_rating.static_factor(data.ball_diameter, pitch, angle)
            # SKF prints f_0 with two digits, JTEKT with three
            assert found == pytest.approx(float(row["f0"]), abs=0.5 if row in DEEP else 0.25)


@pytest.mark.parametrize("name", RATED)
def test_ratings_of_the_balls(name):
    """C according to ISO 281 is within 10 % of the stated value, and C0 according to ISO 76 within
    6 %. The 6208 of Farah et al. and the 6306 of Jablonka et al. have larger balls than the
    catalogue ratings imply."""
    one = listing.entry(BEARINGS / name)
    balls = (one.balls, one.ball_diameter_m, one.pitch_diameter_m)
    angle, rows = math.radians(one.contact_angle_deg), 2 if name.startswith("QJ") else 1
    dynamic = load_rating.dynamic(*balls, angle, rows=rows)
    assert dynamic == pytest.approx(one.dynamic_load_N, rel=0.10)
    assert load_rating.static(*balls, angle, rows=rows) == pytest.approx(
        one.static_load_N, rel=0.06
    )


def test_contact_angles_of_a_size_have_the_same_balls():
    """The rule uses the ratings at a single contact angle, but JTEKT states ratings for three. In
    22 sizes, all three angles give the same balls. As far as ratings can tell, the maker therefore
    uses these balls."""
    for size in {row["name"][:4] for row in ANGULAR}:
        found = {
            (one.balls, one.ball_diameter_m)
            for letter in "CAB"
            for one in [listing.entry(BEARINGS / f"{size}{letter}")]
        }
        assert len(found) == 1, size


def test_another_maker_has_the_same_number_of_balls():
    """JTEKT (catalogue pages 20 to 25, in jtekt_deep_groove.csv) rates its bearings by ISO 281, so
    the rule needs no factor: C agrees within 1.2 %. With four exceptions, each size has as many
    balls as SKF's bearing."""
    text = Path(__file__).with_name("jtekt_deep_groove.csv").read_text()
    other = {}
    for row in csv.DictReader(text.splitlines()):
        pitch = listing.entry(BEARINGS / row["name"]).pitch_diameter_m
        rated = numbers(row, "dynamic", "static")
        found = load_rating.balls(*rated, pitch)
        again = load_rating.dynamic(*found, pitch)
        assert again == pytest.approx(rated[0], rel=0.012)
        if found.number != listing.entry(BEARINGS / row["name"]).balls:
            other[row["name"]] = found.number
    assert other == {"6009": 13, "6010": 14, "6209": 9, "6305": 8}


# mm, None if the number is missing in the text layer of the catalogue
GMN = {
    "6201": (5.953, 22.0),
    "6202": (5.953, 25.3),
    "6203": (6.747, 28.5),
    "6004": (6.350, None),
    "6207": (11.112, 53.5),
    "7008C": (7.938, 54.0),
    "7010C": (8.731, 65.0),
    "7207C": (11.112, 53.5),
    "7208C": (11.906, 60.0),
    "7209C": (12.7, 65.0),
    "7210C": (12.7, 70.0),
}


@pytest.mark.parametrize("name", GMN)
def test_balls_that_a_maker_states(name):
    """GMN, High precision ball bearings (4000 0813 EN), states ball and pitch diameters for
    bearings of these sizes. Different makers need not use the same balls, but they do so for these
    sizes."""
    one = listing.entry(BEARINGS / name)
    ball, pitch = GMN[name]
    assert 1e3 * one.ball_diameter_m == pytest.approx(ball, rel=0.01)
    if pitch:
        assert 1e3 * one.pitch_diameter_m == pytest.approx(pitch, rel=0.015)


@pytest.mark.parametrize("size", [7, 8, 9, 10])
def test_balls_of_four_points_are_those_of_angular_contact_bearings(size):
    """If SKF's ratings of the QJ 2 series are interpreted as ratings of two rows, they give the
    ball diameters that GMN states for the 72C series."""
    one = listing.entry(BEARINGS / f"QJ2{size:02}")
    assert 1e3 * one.ball_diameter_m == pytest.approx(GMN[f"72{size:02}C"][0], abs=0.001)


def test_6305_of_another_program():
    """The reference for ISO/TS 16281 has 7 balls of 11.5 mm diameter on a pitch diameter of 43.5 mm
    (see test_published_bearings)."""
    one = listing.entry(BEARINGS / "6305")
    found = (one.balls, 1e3 * one.ball_diameter_m, 1e3 * one.pitch_diameter_m)
    assert found == pytest.approx((7, 11.5, 43.5), rel=2e-3)


@pytest.mark.parametrize("name", NAMES)
def test_every_bearing_carries_a_load(name):
    """Each bearing is loaded with a radial load of 0.1 C0 and, if the balls have a contact angle,
    an equal axial load. The pressure on the balls stays below the pressure that defines C0."""
    path = BEARINGS / name
    data, rated = inputs.bearing(path), inputs.ratings(path)
    inputs.shoulders(path), inputs.boundary(path)
    load = 0.1 * rated.static if rated else 1000.0
    tilted = inputs.nominal_angle(path) or inputs.four_point_angle(path)
    axial = load if tilted else 0.0
    state = static.equilibrium(data, load, axial)
    assert -state.force == pytest.approx([load, 0.0, axial], abs=1e-6 * load)
    assert 0.5e9 < np.max(state.inner.pressure) < 3.0e9
