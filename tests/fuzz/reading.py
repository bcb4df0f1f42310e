# SPDX-License-Identifier: GPL-2.0-or-later
"""Command lines on whole and damaged files."""

import json
import math

from fuzz import child, commands, files
from fuzz.lab import Finding


def check(draw, folder, runs):
    """A command line: "passed" or "refused"; raises Finding."""
    damage, places = "", runs
    if draw.chance(0.3):
        place, damage = files.damaged(draw, draw.choice(runs), folder)
        places = [place]
    words = commands.line(draw, {"DIR": places, **files.tables(folder, draw)})
    try:
        end = child.raceway(words, folder)
    except Finding as error:
        raise Finding(f"{error} ({damage})" if damage else str(error)) from None
    if end.code == 0 and "--json" in words:
        _finite(json.loads(end.out, parse_constant=_constant), words)
    return "refused" if end.code else "passed"


def _constant(word):
    raise Finding(f"{word} in the JSON of an accepted command")


def _finite(value, words):
    if isinstance(value, dict | list):
        for item in value.values() if isinstance(value, dict) else value:
            _finite(item, words)
    elif isinstance(value, float) and not math.isfinite(value):
        raise Finding(f"{value} in the JSON of {words}")
