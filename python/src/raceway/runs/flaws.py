# SPDX-License-Identifier: GPL-2.0-or-later
"""Flaws of the raceways, as a run notes them: words of fix bearing/profile by ring."""

import re
from collections.abc import Mapping
from typing import Any

from raceway.theory.bearing import INNER, OUTER

RINGS = {INNER: "inner_ring", OUTER: "outer_ring"}  # keys of a run's settings
ONE = re.compile(r"(?:^|; )(\d+) ((?:(?!; \d+ ).)*)")  # a ring's atom number and the words


def by_raceway(settings: Mapping[str, Any]) -> dict[str, str]:
    """{"inner": words, "outer": words} of the raceways with flaws of the one bearing that
    `settings` are of; words of several fixes stand one after another.

    >>> by_raceway({"inner_ring": 19, "outer_ring": 20, "flaws": "20 wave 8 1e-8 0"})
    {'outer': 'wave 8 1e-8 0'}
    """
    found: dict[int, list[str]] = {}
    for ring, words in ONE.findall(str(settings.get("flaws", ""))):
        found.setdefault(int(ring), []).append(words)
    places = {side: settings.get(key) for side, key in RINGS.items()}
    names = {INNER: "inner", OUTER: "outer"}
    return {names[side]: " ".join(found[ring]) for side, ring in places.items() if ring in found}
