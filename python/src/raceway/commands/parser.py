# SPDX-License-Identifier: GPL-2.0-or-later
"""Command-line parser that lists the commands by group and suggests corrections for wrong words."""

import argparse
import re
import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

from raceway.commands import GROUPS
from raceway.errors import near

REST = "Others"  # heading of commands that are in no group
NAMES, WIDTH = 12, 80  # widths of the name column and of the whole list, in characters


class Parser(argparse.ArgumentParser):
    """An `argparse` parser that keeps the line breaks of its texts, reads -20e-6 as a number, and
    suggests commands or options similar to a wrong word."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(formatter_class=argparse.RawDescriptionHelpFormatter, **kwargs)
        # before Python 3.14, argparse accepts negative numbers only without an exponent
        self._negative_number_matcher = re.compile(r"-\.?[0-9]")

    def _check_value(self, action, value):
        if action.choices is not None and value not in action.choices:
            known = [str(word) for word in action.choices]
            of_commands = isinstance(action, argparse._SubParsersAction)
            some = "" if of_commands else f" (choose from {', '.join(known)})"
            raise argparse.ArgumentError(
                action, f"there is no '{value}'{near(str(value), known)}{some}"
            )

    def _get_values(self, action, words):
        # before Python 3.13, argparse drops the value of --option=--
        if action.option_strings and words == ["--"]:
            raise argparse.ArgumentError(action, "expected a value, not '--'")
        return super()._get_values(action, words)

    def refuse(self, unknown: Sequence[str]) -> None:
        """Exit with a message about the first word that matches no option or argument."""
        options = [word for action in self._actions for word in action.option_strings]
        wrong = next((word for word in unknown if word.startswith("-")), None)
        if wrong is None:
            self.error(f"unrecognized arguments: {' '.join(unknown)}")
        name = wrong.partition("=")[0]
        self.error(f"there is no option {name}{near(name, options)}")


def grouped(helps: Mapping[str, str]) -> str:
    """Return the list of commands with their `helps`, under the headings of `GROUPS`."""
    listed = {name for names in GROUPS.values() for name in names}
    groups = GROUPS | {REST: tuple(name for name in helps if name not in listed)}
    result = []
    for heading, names in groups.items():
        if names := [name for name in names if name in helps]:
            result += ["", f"{heading}:"]
            result += [_line(name, helps[name]) for name in names]
    return "\n".join(result[1:])


def _line(name, text):
    first, later = f"    {name:<{NAMES}}", " " * (4 + NAMES)
    return textwrap.fill(text, WIDTH, initial_indent=first, subsequent_indent=later)
