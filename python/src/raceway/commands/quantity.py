# SPDX-License-Identifier: GPL-2.0-or-later
"""Types for numbers on the command line, plain or with a unit, that check their range."""

import argparse
import re
from collections.abc import Callable
from typing import Any

from raceway import units
from raceway.sweeps import variable_table


def number(low: float, high: float, unit: str) -> Callable[[str], float]:
    """Return an argparse type for a float from `low` to `high`.

    The value is in `unit` unless the text gives another unit (see `units.read`).
    """

    def convert(text):
        try:
            value = units.read(text, unit)
        except ValueError as error:
            raise argparse.ArgumentTypeError(str(error)) from None
        return inside(value, text, low, high, unit)

    return convert


def variable(name: str) -> Callable[[str], float]:
    """Return an argparse type like `number` with the range and the unit of the deck variable
    `name`, without the value beside its range that stands for the default."""

    def convert(text):
        return number(*variable_table.limits(name), variable_table.row(name)["unit"])(text)

    return convert


def positive(text: str) -> int:
    """Convert `text` to a positive whole number; for use as an argparse type."""
    if not re.fullmatch(r"[1-9][0-9]*", text):
        raise argparse.ArgumentTypeError(f"'{text}' is not a positive whole number")
    return int(text)


def each(*kinds: Callable[[str], Any]) -> type[argparse.Action]:
    """Return an argparse action for an option that has one value for each of the types `kinds`."""

    class Each(argparse.Action):
        def __call__(self, parser, namespace, values, option_string=None):
            try:
                found = [kind(text) for kind, text in zip(kinds, values, strict=True)]
            except argparse.ArgumentTypeError as error:
                raise argparse.ArgumentError(self, str(error)) from None
            setattr(namespace, self.dest, found)

    return Each


def inside(value: float, text: str, low: float, high: float, unit: str) -> float:
    """Return `value`; raise `argparse.ArgumentTypeError` if it is not between `low` and `high`."""
    if not low <= value <= high:
        raise argparse.ArgumentTypeError(
            f"{text} is out of range: must lie from {low:g} to {high:g} {unit}".rstrip()
        )
    return value
