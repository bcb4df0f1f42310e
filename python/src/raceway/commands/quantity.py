# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers on the command line: range checks with a clear message."""

import argparse
import math
import re
from collections.abc import Callable

ANGLES = {
    "": 1.0,
    "rad": 1.0,
    "mrad": 1e-3,
    "deg": math.pi / 180,
    "arcmin": math.pi / 10800,
    "'": math.pi / 10800,
}


def number(low: float, high: float, unit: str) -> Callable[[str], float]:
    """An argparse type: a float from `low` to `high`, in `unit`."""

    def convert(text):
        try:
            value = float(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"'{text}' is not a number") from None
        return inside(value, text, low, high, unit)

    return convert


def positive(text: str) -> int:
    """An argparse type: a whole number from 1."""
    if not re.fullmatch(r"[1-9][0-9]*", text):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1")
    return int(text)


def angle(low: float, high: float) -> Callable[[str], float]:
    """An argparse type: an angle in rad, or with one of the suffixes of `ANGLES`; from `low` to
    `high` rad."""

    def convert(text):
        match = re.fullmatch(r"([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)([a-z']*)", text)
        try:
            value = float(match.group(1)) * ANGLES[match.group(2)]
        except (AttributeError, KeyError, ValueError):
            raise argparse.ArgumentTypeError(
                f"'{text}' is not an angle: give rad, or 20arcmin, 0.3deg, 5mrad"
            ) from None
        return inside(value, text, low, high, "rad")

    return convert


def inside(value: float, text: str, low: float, high: float, unit: str) -> float:
    """`value`, or the complaint that it is not between `low` and `high`."""
    if not low <= value <= high:
        raise argparse.ArgumentTypeError(
            f"{text} is out of range: must lie from {low:g} to {high:g} {unit}".rstrip()
        )
    return value


def takes_negative(parser: argparse.ArgumentParser) -> None:
    """Let `parser` read -20e-6 as a number: before Python 3.14 argparse accepts negative numbers
    only without exponent."""
    parser._negative_number_matcher = re.compile(r"-\.?[0-9]")
