# SPDX-License-Identifier: GPL-2.0-or-later
"""Kinds of lubrication: the inlet of rolling contacts, SKF's starvation constant and the share of
oil around the balls (docs/tribology, Kinds of lubrication)."""

from typing import NamedTuple

from raceway.core import laws
from raceway.theory.bearing import Bearing

KINDS = ("bath", "jet", "mist", "grease", "minimal")  # in the order of core/laws/lubrication.h


class Supply(NamedTuple):
    """How a bearing is lubricated."""

    kind: str = "bath"  # one of `KINDS`
    level: float = 0.5  # level of a bath above the lowest raceway, in ball diameters


BATH = Supply()  # oil level at the middle of the lowest ball


class Numbers(NamedTuple):
    """Friction parameters determined by a `Supply`."""

    inlet: float  # in semi-axes b along rolling; 0: flooded, 1: the shortest
    replenishment: float  # K_rs of SKF's starvation factor; 0: none
    share: float  # X, volume fraction of oil around the balls


def numbers(supply: Supply, bearing: Bearing, density: float) -> Numbers:
    """`Numbers` of a bearing with oil of a `density` in kg/m^3. Raises `ValueError` for an unknown
    type or a level below 0."""
    if supply.kind not in KINDS:
        raise ValueError(f"lubrication '{supply.kind}' is not one of {', '.join(KINDS)}")
    if not supply.level >= 0:
        raise ValueError(f"oil level {supply.level:g} must not be below 0")
    pitch = (bearing.inner_radius + bearing.outer_radius) / 2
    kind = KINDS.index(supply.kind)
    found = laws.lubrication(kind, supply.level, pitch / bearing.ball_radius, density)
    return Numbers(float(found.inlet), float(found.replenishment), float(found.share))
