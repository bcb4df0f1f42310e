# SPDX-License-Identifier: GPL-2.0-or-later
"""Apply command lines to intact and damaged files. Damaged files may be rejected, but must not
change any result."""

import json
import math

from fuzz import child, commands, files
from fuzz.lab import Finding


def check(draw, folder, runs):
    """Run a command line and return "passed" or "refused". Raise Finding if it fails in another
    way."""
    damage, places, whole = "", runs, draw.choice(runs)
    if draw.chance(0.3):
        place, damage = files.damaged(draw, whole, folder)
        places = [place]
    words = commands.line(draw, {"DIR": places, **files.tables(folder, draw)})
    try:
        end = child.raceway(words, folder)
    except Finding as error:
        raise Finding(f"{error} ({damage})" if damage else str(error)) from None
    if end.code == 0 and "--json" in words:
        try:
            told = json.loads(end.out, parse_constant=_constant)
        except json.JSONDecodeError as error:
            raise Finding(f"no JSON from {words}: {error}") from None
        _finite(told, words)
        if damage and str(places[0]) in words:
            again = [str(whole) if word == str(places[0]) else word for word in words]
            before = json.loads(
                child.raceway(again, folder).out.replace(str(whole), str(places[0]))
            )
            if told != before:
                raise Finding(f"damage changes the results of {words}: {damage}")
    return "refused" if end.code else "passed"


def _constant(word):
    raise Finding(f"{word} in the JSON of an accepted command")


def _finite(value, words):
    if isinstance(value, dict | list):
        for item in value.values() if isinstance(value, dict) else value:
            _finite(item, words)
    elif isinstance(value, float) and not math.isfinite(value):
        raise Finding(f"{value} in the JSON of {words}")
