# SPDX-License-Identifier: GPL-2.0-or-later
"""Output of commands: JSON with the option --json, otherwise text."""

import argparse
import json
from collections.abc import Callable, Sequence
from typing import Any

POINTS = "print a JSON object, or a list for several points"


def option(to: Any, said: str = "print a JSON object instead of tables") -> None:
    """Add --json to a parser or an option group."""
    to.add_argument("--json", action="store_true", help=said)


def as_json(result: Any) -> str:
    """Return the JSON of a `result`, in which numbers that are not finite are null."""
    from raceway.arrays import plain  # loads numpy

    return json.dumps(plain(result), indent=2, ensure_ascii=False, allow_nan=False)


def show(arguments: argparse.Namespace, result: Any, text: Callable[[Any], str]) -> None:
    """Print a `result` as JSON if --json is given, otherwise as `text`."""
    print(as_json(result) if arguments.json else text(result))


def show_each(
    arguments: argparse.Namespace,
    results: Sequence[Any],
    one: Callable[[Any], str],
    several: Callable[[Any], str],
) -> None:
    """Print the only one of `results` in the form `one`, or all of them in the form `several`."""
    if results[1:]:
        show(arguments, results, several)
    else:
        show(arguments, results[0], one)
