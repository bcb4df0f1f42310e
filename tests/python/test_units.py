# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of SI prefixes."""

import argparse
import math

import pytest
from commands import reply
from raceway import cli
from raceway.units import PREFIX, SCALED, axis, prefixed, read


@pytest.mark.parametrize(
    "value, unit, shown",
    [
        (2.5713e9, "Pa", "2.571 GPa"),
        (34.87e-6, "m", "34.87 µm"),
        (1.06e-10, "F", "106 pF"),
        (999.99, "N", "1 kN"),
        (1000, "N", "1 kN"),
        (-44.1e-6, "m", "-44.1 µm"),
        (1e-3, "m", "1 mm"),
        (0, "m", "0 m"),
        (938.0, "", "938"),
        (0.938, "", "0.938"),
        (1e-20, "F", "1e-20 F"),
    ],
)
def test_prefixed(value, unit, shown):
    assert prefixed(value, unit) == shown


@pytest.mark.parametrize(
    "text, unit, value",
    [
        ("5kN", "N", 5000.0),
        ("5 kN", "N", 5000.0),
        ("5e3", "N", 5000.0),
        ("10um", "m", 10e-6),
        ("-12.5µm", "m", -12.5e-6),
        ("10um", "mm", 10e-3),
        ("2in", "mm", None),
        ("60C", "C", 60.0),
        ("60 °C", "C", 60.0),
        ("3000rpm", "rpm", 3000.0),
        ("2krpm", "rpm", 2000.0),
        ("50Hz", "rpm", 3000.0),
        ("2kHz", "Hz", 2000.0),
        ("10Nm", "N m", 10.0),
        ("2.5kN*m", "N m", 2500.0),
        ("150pF", "F", 150e-12),
        ("1Gohm m", "ohm m", 1e9),
        ("20MV/m", "V/m", 20e6),
        ("40deg", "degrees", 40.0),
        ("20arcmin", "rad", math.pi / 540),
        ("5mrad", "rad", 5e-3),
        ("5kg", "N", None),
        ("5kN", "m", None),
        ("5kN", "passes", None),
        ("kN", "N", None),
        ("5kkN", "N", None),
        ("5k", "N", None),
        ("", "N", None),
    ],
)
def test_read(text, unit, value):
    if value is None:
        with pytest.raises(ValueError, match="is not a number"):
            read(text, unit)
    else:
        assert read(text, unit) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize("unit", sorted(SCALED))
def test_what_is_printed_can_be_read(unit):
    """Decimal numbers with a prefix are read as the same floats as numbers with an exponent."""
    for power, sign in PREFIX.items():
        assert read(f"12.7{sign}{unit}", unit) == float(f"12.7e{power}")
    assert read(prefixed(4.7e3, unit), unit) == 4700.0


def test_every_physical_option_takes_its_unit():
    """No command parses an option with `float`, so every length can be given as, e.g., 10um."""
    (commands,) = (
        action
        for action in cli._parser()._actions
        if isinstance(action, argparse._SubParsersAction)
    )
    plain = [
        (name, action.option_strings)
        for name, parser in commands.choices.items()
        for action in parser._actions
        if action.type is float
    ]
    assert plain == []


def test_an_error_names_option_value_and_range(capsys):
    for text, said in (
        ("5kg", "argument --load: '5kg' is not a number in N: give 12.5 or, with its unit, 5kN"),
        ("2MN", "argument --load: 2MN is out of range: must lie from 0 to 1e+06 N"),
    ):
        assert said in reply(capsys, ["static", "--load", text], code=2)


def test_axis():
    assert axis(2436, "N") == (pytest.approx(1e-3), "kN")
    assert axis(0, "N") == (1, "N")
