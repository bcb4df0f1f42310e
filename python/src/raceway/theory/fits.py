# SPDX-License-Identifier: GPL-2.0-or-later
"""Reduction of a bearing's clearance by interference fits (Lamé's solution for thick-walled tubes).

A ring is treated as a tube that ends at the bottom of its groove, without shoulders. Shaft and
housing are tubes with the length of the ring. `heat.clearance_change` computes the effect of
temperature.
"""

import math
from typing import NamedTuple

from raceway.theory.bearing import Bearing
from raceway.theory.steel import Steel


class Material(NamedTuple):
    """Elastic constants of a shaft or a housing."""

    young: float  # Pa
    poisson: float


STEEL = Material(*Steel()[:2])


def clearance_change(
    bearing: Bearing,
    bore: float,
    outside: float,
    shaft: float = 0.0,
    housing: float = 0.0,
    *,
    shaft_bore: float = 0.0,
    housing_outside: float = math.inf,
    shaft_material: Material = STEEL,
    housing_material: Material = STEEL,
) -> float:
    """Return the change in the diametral clearance in m, which is 0 or negative.

    `shaft` and `housing` are the diametral interferences (m) of the inner ring on its shaft and of
    the outer ring in its housing; values of 0 or less, i.e. loose fits, have no effect. `bore` and
    `outside` are the diameters of the bearing, `shaft_bore` is the bore of a hollow shaft and
    `housing_outside` the outside diameter of the housing, all in m. Raises `ValueError` if the
    diameters are not in increasing order.

    For a 6208 with an interference of 10 um on a solid steel shaft, the raceway grows by the
    interference times the ratio of bore to raceway diameter:

    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> round(1e6 * clearance_change(b, 40e-3, 80e-3, shaft=10e-6), 3)
    -8.333
    """
    inner, outer = 2 * bearing.inner_radius, 2 * bearing.outer_radius
    order = (shaft_bore, bore, inner, outer, outside, housing_outside)
    if not (0 <= order[0] and all(one < other for one, other in zip(order, order[1:]))):
        raise ValueError(
            "the diameters of shaft bore, bore, inner raceway, outer raceway, outside and housing"
            f" must increase: {', '.join(f'{one:g}' for one in order)} m"
        )
    ring = Material(bearing.ring.young, bearing.ring.poisson)
    grows = 0.0
    if shaft > 0:
        pressure = shaft / (_shrinks(shaft_bore, bore, shaft_material) + _widens(bore, inner, ring))
        ratio = (bore / inner) ** 2
        grows = pressure * 2 * inner * ratio / (ring.young * (1 - ratio))
    if housing > 0:
        pressure = housing / (
            _shrinks(outer, outside, ring) + _widens(outside, housing_outside, housing_material)
        )
        ratio = (outer / outside) ** 2
        grows += pressure * 2 * outer / (ring.young * (1 - ratio))
    return -grows


def _shrinks(inside, outside, material):
    """Return the decrease of a tube's outside diameter under external pressure in m/Pa."""
    square = (inside / outside) ** 2
    return outside / material.young * ((1 + square) / (1 - square) - material.poisson)


def _widens(inside, outside, material):
    """Return the increase of a tube's inside diameter under internal pressure in m/Pa."""
    square = (inside / outside) ** 2
    return inside / material.young * ((1 + square) / (1 - square) + material.poisson)
