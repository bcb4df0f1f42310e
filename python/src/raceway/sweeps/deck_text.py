# SPDX-License-Identifier: GPL-2.0-or-later
"""Text of a deck with changed values of its variables, as if a user had edited it."""

import os
import re
from collections.abc import Mapping
from numbers import Integral, Real

from raceway.errors import RacewayError, near
from raceway.files import FilePath
from raceway.sweeps.points import deck_variables

# characters that have a special meaning for a host
SPECIAL = re.compile(r"[\"'$&#\x00-\x1f\x7f]")
LINE = r"^(\s*variable\s+{}\s+index\s+)(\"[^\"]*\"|\S+)([^\S\n]*)"
FIRST = re.compile(r"^\s*variable\s", re.MULTILINE)
# Variables that are file names. Here, paths are relative to the caller's folder, but in decks they
# are relative to the inputs folder.
FILES = ("bearing", "lubricant")


def values(deck: FilePath, given: Mapping[str, object]) -> dict[str, str]:
    """Convert the `given` values of variables of `deck` to text, omitting those that are None.

    Numbers keep all their digits, True and False become yes and no, and a bearing or lubricant with
    a slash is a path. Raise `RacewayError` for a name that the deck does not have and for a value
    that cannot be written.
    """
    known, found = deck_variables(deck), {}
    for name, value in given.items():
        if value is None:
            continue
        if name not in known:
            raise RacewayError(f"{deck} has no variable '{name}'{near(name, known)}")
        found[name] = _text(name, value)
        if name in FILES and "/" in found[name]:
            found[name] = os.path.abspath(found[name])
    return found


def _text(name, value):
    if hasattr(value, "item") and not getattr(value, "shape", ()):
        value = value.item()  # a NumPy scalar
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value)).removesuffix(".0")  # 2000 and 2000.0 have the same folder
    if not isinstance(value, str | os.PathLike):
        raise RacewayError(f"{name} is {value!r}, must be a number, a string, True or False")
    text = os.fspath(value)
    if not text.strip() or SPECIAL.search(text):
        raise RacewayError(
            f"{name} is {text!r}, must be a text without quotes, line breaks and $ & #"
        )
    return text


def text(deck: FilePath, own: Mapping[str, str], heading: str) -> str:
    """Return the deck at path `deck` with the values of `own` and a `heading` as comment line.

    `own` maps variables to text. For a variable that the deck takes from its data files, a line is
    inserted before the first of the deck's own variables.
    """
    with open(deck, encoding="utf-8") as file:
        found = file.read()
    added = []
    for name, value in own.items():
        word = f'"{value}"' if " " in value else value
        line = re.compile(LINE.format(re.escape(name)), re.MULTILINE)
        if match := line.search(found):
            width = len(match[2]) + len(match[3])
            blanks = max(width, len(word) + 1) if match[3] else 0
            found = found[: match.end(1)] + word.ljust(blanks) + found[match.end() :]
        else:
            added.append(f"variable {name} index {word}\n")
    first = FIRST.search(found)
    place = first.start() if first else 0
    return f"# {heading}\n" + found[:place] + "".join(added) + found[place:]
