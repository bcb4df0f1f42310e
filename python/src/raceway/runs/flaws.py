# SPDX-License-Identifier: GPL-2.0-or-later
"""Flaws in a run, i.e. the arguments of fix bearing/profile for each ring or ball."""

import re
from collections.abc import Mapping
from typing import Any

from raceway.theory.bearing import INNER, OUTER

RINGS = {INNER: "inner_ring", OUTER: "outer_ring"}  # keys in the settings of a run
ONE = re.compile(r"(?:^|; )(\d+) ((?:(?!; \d+ ).)*)")  # an atom number and its arguments
OF_BALL = "ball "  # precedes the arguments for a ball


def by_raceway(settings: Mapping[str, Any]) -> dict[str, str]:
    """Return {"inner": arguments, "outer": arguments} for the flawed raceways of a single bearing.

    `settings` are the settings of the run. The arguments of several fixes are concatenated.

    >>> by_raceway({"inner_ring": 19, "outer_ring": 20, "flaws": "20 wave 8 1e-8 0"})
    {'outer': 'wave 8 1e-8 0'}
    """
    found: dict[int, list[str]] = {}
    for ring, words in ONE.findall(str(settings.get("flaws", ""))):
        found.setdefault(int(ring), []).append(words)
    places = {side: settings.get(key) for side, key in RINGS.items()}
    names = {INNER: "inner", OUTER: "outer"}
    return {names[side]: " ".join(found[ring]) for side, ring in places.items() if ring in found}


def by_ball(settings: Mapping[str, Any]) -> dict[int, str]:
    """Return {atom number: arguments} for the flawed balls.

    The arguments of several fixes are concatenated.

    >>> by_ball({"flaws": "20 wave 8 1e-8 0; 3 ball wave 2 1e-7 0"})
    {3: 'wave 2 1e-7 0'}
    """
    found: dict[int, list[str]] = {}
    for ball, words in ONE.findall(str(settings.get("flaws", ""))):
        if words.startswith(OF_BALL):
            found.setdefault(int(ball), []).append(words.removeprefix(OF_BALL))
    return {ball: " ".join(words) for ball, words in found.items()}


def by_part(settings: Mapping[str, Any]) -> dict[str, str]:
    """Return the arguments for raceways, with the keys "inner" and "outer", and for balls, with
    keys such as "ball 3", where 3 is the atom number."""
    balls = {f"ball {ball}": words for ball, words in by_ball(settings).items()}
    return {**by_raceway(settings), **balls}
