# SPDX-License-Identifier: GPL-2.0-or-later
"""Statics of a four-point contact bearing, with contacts by groove and ball (2, Z) where other
bearings have one of each raceway."""

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from raceway.theory import many_grooves
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.static import Equilibrium

NAMES = (("inner 0", "inner 1"), ("outer 0", "outer 1"))  # of the grooves, as a record has them


def equilibrium(
    bearing: Bearing,
    radial_load: float = 0.0,
    axial_load: float = 0.0,
    *,
    angle: float,
    moment: ArrayLike | None = None,
    held: Mapping[str, float] | None = None,
    clearance: float = 0.0,
    phase: float = 0.0,
    orbital_speed: float = 0.0,
    ball_density: float = 7800.0,
) -> Equilibrium:
    """`static.Equilibrium` of a `bearing` of `many_grooves.four_point` whose balls in the middle
    are in contact at `angle` (rad). Contacts are arrays (2, Z); `linear` has inner grooves, then
    outer ones. Other arguments are those of `static.equilibrium`, the radial load along x.

    Raises `NoEquilibrium` when the ring is free to move or balls are forced out of their grooves,
    `ValueError` for an unknown degree of freedom.
    """
    reach = [bearing.groove_gap(side) * math.sin(angle) for side in (INNER, OUTER)]
    row = many_grooves.Row(
        bearing, 0.0, *((-one, one) for one in reach), clearance=clearance, phase=phase
    )
    rest = many_grooves.equilibrium(
        [row],
        (radial_load, 0.0, axial_load),
        moment,
        held=held,
        orbital_speed=orbital_speed,
        ball_density=ball_density,
    )
    (found,) = rest.rows
    force, couple = rest.force[:3], np.append(rest.force[3:], 0.0)
    return Equilibrium(
        rest.place[:3],
        found.azimuth,
        found.inner,
        found.outer,
        rest.residual,
        rest.place[3:],
        force,
        couple,
        rest.stiffness,
        found.linear,
    )
