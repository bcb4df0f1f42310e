# SPDX-License-Identifier: GPL-2.0-or-later
"""Flaws of a run: the words of fix bearing/profile for each ring or ball."""

import re
from collections.abc import Mapping
from typing import Any

from raceway.theory.bearing import INNER, OUTER

RINGS = {INNER: "inner_ring", OUTER: "outer_ring"}  # keys of a run's settings
ONE = re.compile(r"(?:^|; )(\d+) ((?:(?!; \d+ ).)*)")  # an atom number and its words
OF_BALL = "ball "  # before the words of a ball


def by_raceway(settings: Mapping[str, Any]) -> dict[str, str]:
    """{"inner": words, "outer": words} for the flawed raceways of the single bearing of `settings`;
    the words of several fixes follow one another.

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
    """Words by atom number of the flawed balls; the words of several fixes follow one another.

    >>> by_ball({"flaws": "20 wave 8 1e-8 0; 3 ball wave 2 1e-7 0"})
    {3: 'wave 2 1e-7 0'}
    """
    found: dict[int, list[str]] = {}
    for ball, words in ONE.findall(str(settings.get("flaws", ""))):
        if words.startswith(OF_BALL):
            found.setdefault(int(ball), []).append(words.removeprefix(OF_BALL))
    return {ball: " ".join(words) for ball, words in found.items()}


def by_part(settings: Mapping[str, Any]) -> dict[str, str]:
    """Words of the raceways by "inner" and "outer", and of balls by "ball N", N the atom number."""
    balls = {f"ball {ball}": words for ball, words in by_ball(settings).items()}
    return {**by_raceway(settings), **balls}
