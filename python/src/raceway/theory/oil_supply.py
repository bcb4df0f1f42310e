# SPDX-License-Identifier: GPL-2.0-or-later
"""Kinds of lubrication, which determine the inlet of rolling contacts, SKF's starvation constant,
and the volume fraction of oil around the balls (docs/tribology, Kinds of lubrication)."""

from typing import NamedTuple

from raceway.core import laws
from raceway.theory.bearing import Bearing

KINDS = ("bath", "jet", "mist", "grease", "minimal")  # in the order of core/laws/lubrication.h


class Supply(NamedTuple):
    """The way in which a bearing is lubricated."""

    kind: str = "bath"  # one of `KINDS`
    # oil level of a bath above the lowest point of the raceway, in ball diameters
    level: float = 0.5


BATH = Supply()  # the oil level is at the middle of the lowest ball


class Numbers(NamedTuple):
    """Friction parameters that are determined by a `Supply`."""

    inlet: float  # inlet length in multiples of b; 0: fully flooded, 1: the shortest inlet
    replenishment: float  # K_rs of SKF's starvation factor; 0: no starvation
    share: float  # X, volume fraction of oil around the balls


def numbers(supply: Supply, bearing: Bearing, density: float) -> Numbers:
    """Return the `Numbers` for a bearing with an oil whose `density` is in kg/m^3. Raises
    `ValueError` for an unknown kind of lubrication or a level below 0."""
    if supply.kind not in KINDS:
        raise ValueError(f"lubrication '{supply.kind}' is not one of {', '.join(KINDS)}")
    if not supply.level >= 0:
        raise ValueError(f"oil level {supply.level:g} must not be below 0")
    pitch = (bearing.inner_radius + bearing.outer_radius) / 2
    kind = KINDS.index(supply.kind)
    found = laws.lubrication(kind, supply.level, pitch / bearing.ball_radius, density)
    return Numbers(float(found.inlet), float(found.replenishment), float(found.share))
