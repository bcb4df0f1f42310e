# SPDX-License-Identifier: GPL-2.0-or-later
"""Range of validity of the contact formulas.

The rules are defined in C++ (`src-package/core/raceway/validity.h`), which issues the warnings in a
run. Summaries and all results of statics are checked with the same rules.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from raceway import core
from raceway.theory.bearing import Bearing
from raceway.units import prefixed

if TYPE_CHECKING:
    from raceway.theory.lubrication import Lubrication
    from raceway.theory.static import Equilibrium

COUNTS = 0.19  # fraction of the radial load below which ISO 281 ignores axial loads (smallest e)


class Rule(NamedTuple):
    """A bound on a quantity. The quantity `value` is doubtful above `bound`, or below it if `below`
    is true; `limit` states the source of the bound."""

    name: str
    value: str
    unit: str
    limit: str
    bound: float
    below: bool


class Shoulders(NamedTuple):
    """Diameters in m of the shoulders of both rings; NaN if unknown."""

    inner: float = math.nan
    outer: float = math.nan


RULES = {row["name"]: Rule(**row) for row in core.table("columns")["validity"]}


class Doubt(NamedTuple):
    """A reason why runs differ from the friction torque of statics. Beyond `bound`, the torque of
    runs divided by that of statics is between `low` and `high` (docs/static)."""

    bound: float
    low: float
    high: float
    why: str


# Play that the balls need over that of the pockets; coefficient of friction needed against the
# gyroscopic moment over the available one; fraction of balls with hardly any load, if contact
# angles are not zero
TORQUE = {
    "pockets": Doubt(0.8, 0.65, 3.0, "balls press against their cage"),
    "gyroscopic": Doubt(0.9, 0.95, 2.5, "gyroscopic moments turn the balls"),
    "unloaded": Doubt(0.0, 0.85, 1.4, "balls lose and regain their load"),
}
AGREES = 0.05  # largest relative difference without such a reason
WEDGED = 1.25  # largest torque of a run in which the cage wedges, over the estimate from statics


def torque_range(
    values: Mapping[str, float], wedged: float = 0.0
) -> tuple[float, float, list[str]]:
    """Return the smallest and the largest torque of settled runs, divided by the torque of statics,
    for the `values` {name in `TORQUE`: value} in statics, and a list with a warning if they differ
    by more than `AGREES`. `wedged` is the torque with a cage that wedges between its balls, divided
    by that of statics; 0 if it cannot."""
    known = [TORQUE[name] for name, value in values.items() if value > TORQUE[name].bound]
    low = min([1 - AGREES, *(one.low for one in known)])
    high = max([1 + AGREES, WEDGED * wedged, *(one.high for one in known)])
    if not known:
        return low, high, []
    times = f"{low:g} to {high:.3g} times"
    why = " and ".join(one.why for one in known)
    return low, high, [f"the torque of a run may be {times} that of statics: {why}"]


def doubts(values: Mapping[str, float | None]) -> list[str]:
    """Return a warning for each of the `values` {name in `RULES`: value in SI units} that is
    outside its range of validity. Values that are None or NaN are ignored."""
    texts = []
    for name, value in values.items():
        rule = RULES[name]
        if value is None or not (value < rule.bound if rule.below else value > rule.bound):
            continue
        texts.append(
            f"{rule.value} is {'down' if rule.below else 'up'} to {_shown(value, rule.unit)};"
            f" {rule.limit} {_shown(rule.bound, rule.unit)}"
        )
    return texts


def _shown(value, unit):
    return prefixed(value, unit) if unit else f"{value:.4g}"


def of_statics(
    bearing: Bearing,
    shoulders: Shoulders,
    state: Equilibrium,
    films: Lubrication | None,
    *,
    load: float,
    axial: float,
    four_point: float | None = None,
) -> list[str]:
    """Return a warning for each quantity of the equilibrium `state` under the loads `load` and
    `axial` (N) that is outside its range of validity; `four_point` (rad) is the argument `free` of
    `past_middle`."""
    sides = (state.inner, state.outer)
    found = {"pressure": max(side.pressure.max() for side in sides)}
    if films is not None:
        wet = [(film, one, one.load > 0) for film, one in zip((films.inner, films.outer), sides)]
        ratio = np.concatenate([film.ratio[live] for film, _, live in wet])
        thick = np.concatenate([film.h_c[live] / one.b[live] for film, one, live in wet])
        if len(ratio):
            found |= {"thick_film": thick.max(), "lambda": ratio.max(), "conducts": ratio.min()}
    angle = tuple(side.angle[side.heavy] for side in sides)
    semi_axis = tuple(side.a[side.heavy] for side in sides)
    texts = doubts(found) + past_shoulder(bearing, shoulders, angle, semi_axis)
    if four_point is not None:
        texts += past_middle(bearing, four_point, angle, semi_axis)
    return texts + held(state.force[2] + axial, load, max(side.load.max() for side in sides))


def held(push: float, radial: float, largest: float) -> list[str]:
    """Return a warning if the balls push the inner ring along its axis with a force `push` (N) that
    no load balances, and if this force is significant relative to the `radial` load and the
    `largest` contact load."""
    if abs(push) <= COUNTS * max(radial, largest):
        return []
    return [
        f"the balls push the inner ring along its axis with {_shown(abs(push), 'N')}, and no load"
        " balances it: loads, life and friction are valid only if something else holds the ring,"
        " such as a second bearing"
    ]


def past_shoulder(
    bearing: Bearing,
    shoulders: Shoulders,
    angle: tuple[np.ndarray, np.ndarray],
    semi_axis: tuple[np.ndarray, np.ndarray],
) -> list[str]:
    """Return a warning for each raceway on which contact ellipses extend beyond the edge of the
    groove.

    `angle` (rad) and `semi_axis` a (m) describe the loaded contacts of the inner and the outer
    raceway. The groove ends at the angle theta from its bottom, with cos(theta) = 1 - depth/r_c. An
    ellipse extends to |alpha| + asin(a/r_c).
    """
    grooves = (bearing.inner_groove, bearing.outer_groove)
    depths = (
        shoulders.inner / 2 - bearing.inner_radius,
        bearing.outer_radius - shoulders.outer / 2,
    )
    texts = []
    for name, groove, depth, alpha, a in zip(("inner", "outer"), grooves, depths, angle, semi_axis):
        if math.isnan(depth) or len(alpha) == 0:
            continue
        if not 0 < depth <= groove:
            texts.append(
                f"the {name} shoulder does not fit the balls: it is {_shown(depth, 'm')} above the"
                f" bottom of its groove, but must be above 0 and at most the radius of the groove,"
                f" {_shown(groove, 'm')}"
            )
            continue
        edge = math.acos(1 - depth / groove)
        reach = float(np.max(np.abs(alpha) + np.arcsin(np.minimum(a / groove, 1.0))))
        if reach > edge:
            texts.append(
                f"the contact ellipse of the {name} raceway reaches {math.degrees(reach):.1f}° up"
                f" the groove; its shoulder is at {math.degrees(edge):.1f}°"
            )
    return texts


def past_middle(
    bearing: Bearing,
    free: float,
    angle: tuple[np.ndarray, np.ndarray],
    semi_axis: tuple[np.ndarray, np.ndarray],
) -> list[str]:
    """Return the same warnings as `past_shoulder`, but for the edge between the two grooves of a
    ring in a four-point contact bearing. `free` is the contact angle (rad) of a centred ball. The
    edge lies at the angle asin((r_c - R_b) sin(free)/r_c) from the bottom of the groove."""
    texts = []
    for side, (alpha, a) in enumerate(zip(angle, semi_axis)):
        groove = bearing.groove(side)
        edge = math.asin(bearing.groove_gap(side) * math.sin(free) / groove)
        if len(alpha) == 0:
            continue
        reach = float(np.min(np.abs(alpha) - np.arcsin(np.minimum(a / groove, 1.0))))
        if reach < edge:
            texts.append(
                f"the contact ellipse of the {('inner', 'outer')[side]} raceway reaches down to"
                f" {math.degrees(reach):.1f}°; its grooves meet at {math.degrees(edge):.1f}°"
            )
    return texts
