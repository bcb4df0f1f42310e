# SPDX-License-Identifier: GPL-2.0-or-later
"""The bearing's own frame: z is its axis, and the origin is the initial seat of its outer ring.

A record has vectors along the axes of the lab; its attribute `axis` is the axis of the bearing. The
conversion permutes components cyclically, as in the hosts (`lab_axes.h`), so no bit changes.
"""

import re

_COMPONENT = re.compile(r"((?:ball|cage|ring)_(?:origin_|v|omega|f|m|a|))([xyz])")
_PLACE = re.compile(r"(?:ball|cage|ring_origin)_([xyz])")


def own_name(name: str, axis: str) -> str:
    """Name in the bearing's frame of a variable of a record whose bearings have the lab's `axis`.
    Raises `ValueError` for an axis other than x, y or z.

    >>> own_name("ring_fy", "x"), own_name("ball_omegax", "x"), own_name("ring_spin", "x")
    ('ring_fx', 'ball_omegaz', 'ring_spin')
    """
    turn = "xyz".index(axis) + 1
    if not (found := _COMPONENT.fullmatch(name)):
        return name
    return found[1] + "xyz"[("xyz".index(found[2]) - turn) % 3]


def along(name: str) -> int | None:
    """Index of the coordinate, 0 to 2, that a position variable holds; None for other variables.

    >>> along("ball_y"), along("ring_origin_z"), along("ring_x")
    (1, 2, None)
    """
    found = _PLACE.fullmatch(name)
    return "xyz".index(found[1]) if found else None
