# SPDX-License-Identifier: GPL-2.0-or-later
"""Conversion to the bearing's own frame, in which z is the bearing axis and the origin is the
initial seat of the outer ring.

The vectors in a record have components along the lab axes; its attribute `axis` is the bearing
axis. The conversion permutes components cyclically, as in the hosts (`lab_axes.h`), so the values
do not change.
"""

import re
from functools import cache

_COMPONENT = re.compile(r"((?:ball|cage|ring)_(?:origin_|v|omega|f|m|a|))([xyz])")
_PLACE = re.compile(r"(?:ball|cage|ring_origin)_([xyz])")


@cache
def own_name(name: str, axis: str) -> str:
    """Return the name that a variable of a record has in the bearing's frame, if the bearing axis
    is the lab `axis`. Raise `ValueError` for an axis other than x, y or z.

    >>> own_name("ring_fy", "x"), own_name("ball_omegax", "x"), own_name("ring_spin", "x")
    ('ring_fx', 'ball_omegaz', 'ring_spin')
    """
    turn = "xyz".index(axis) + 1
    if not (found := _COMPONENT.fullmatch(name)):
        return name
    return found[1] + "xyz"[("xyz".index(found[2]) - turn) % 3]


@cache
def along(name: str) -> int | None:
    """Return the index (0 to 2) of the coordinate that a position variable contains, or None for
    other variables.

    >>> along("ball_y"), along("ring_origin_z"), along("ring_x")
    (1, 2, None)
    """
    found = _PLACE.fullmatch(name)
    return "xyz".index(found[1]) if found else None
