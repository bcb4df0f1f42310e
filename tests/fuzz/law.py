# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw keywords of the contact law from the tables that C++ exports."""

from fuzz.draw import grammar
from raceway import core

LAW = core.table("columns")["law"]
# parts that require another part
NEEDS = {"film_branch": "film_in_gap", "spin": "differential_slip"}


def words(draw, film):
    """Return keywords of pair_style for the parts that a law must have, at most one friction law
    and at most one tangential law, and some of the other parts."""
    slots, chosen = {}, []
    parts = [part for part in LAW if film or not part["film"]]
    for slot in sorted({part["slot"] for part in parts} - {""}):
        options = [part["name"] for part in parts if part["slot"] == slot]
        slots[slot] = draw.choice(options)
    friction = draw.chance(0.8)
    for part in parts:
        if part["slot"] and slots[part["slot"]] != part["name"] and part["when"] != "always":
            continue
        if part["slot"] in ("friction", "tangential") and not friction:
            continue
        if part["name"] in NEEDS and not friction | (part["name"] == "film_branch"):
            continue
        if part["name"] in NEEDS and NEEDS[part["name"]] not in slots.values():
            continue
        for keyword in part["keywords"]:
            needed = any(p["initial"] == "must be given" for p in keyword["parameters"])
            own = part["slot"] and keyword is part["keywords"][0]
            share = 1 if needed else 0.9 if own and part["when"] != "always" else 0.25
            if draw.chance(share):
                chosen += _keyword(draw, keyword)
    return " ".join(chosen)


def _keyword(draw, keyword):
    ranges = grammar("law").get(keyword["name"], [])
    values = [
        draw.choice(parameter["choices"]) if parameter["choices"] else f"{draw.number(ranges[i]):g}"
        for i, parameter in enumerate(keyword["parameters"])
    ]
    return [keyword["name"], *filter(None, [keyword["form"]]), *values]
