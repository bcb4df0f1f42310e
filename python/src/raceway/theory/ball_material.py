# SPDX-License-Identifier: GPL-2.0-or-later
"""Material of the balls of a bearing, whose rings are of bearing steel."""

from typing import NamedTuple

from raceway.core import laws
from raceway.theory.steel import STEEL as BEARING_STEEL
from raceway.theory.steel import Steel


class BallMaterial(NamedTuple):
    """Properties of the balls."""

    young: float = BEARING_STEEL.young  # Pa
    poisson: float = BEARING_STEEL.poisson
    density: float = BEARING_STEEL.density  # kg/m^3
    expansion: float = float(laws.steel_of_bearings().expansion)  # 1/K
    effusivity: float = 1.0  # sqrt(k rho c) divided by that of the rings

    @property
    def heat_share(self) -> float:
        """Fraction of the heat generated in a contact that enters the ball."""
        return float(laws.heat_share_of_balls(self.effusivity))


STEEL = BallMaterial()


def resolve(given: dict[str, float], material: str) -> tuple[BallMaterial, Steel]:
    """Return the materials of the balls and of the rings for the data `ball_...` and `ring_...`
    that a bearing's file states and the `material` of its balls, as the command `bearing` does
    (src-package/styles/derive_data.cpp). 0 stands for a value that is not stated."""
    ceramic, steel = laws.silicon_nitride(), laws.steel_of_bearings()
    ball, ring = {}, {}
    for name, usual in BEARING_STEEL._asdict().items():
        stated, apart = given.get(f"ball_{name}"), given.get(f"ring_{name}")
        ring[name] = apart or (usual if stated is None else stated)
        own = ring[name] if stated is None else stated
        if material == "silicon_nitride" and (not apart or stated is None):
            own = float(getattr(ceramic, name))
        ball[name] = own
    thermal = ("expansion", "heat_capacity", "conductivity")
    own = {name: given.get(f"ball_{name}", 0.0) for name in thermal}
    if material == "silicon_nitride":
        own = {name: own[name] or float(getattr(ceramic, name)) for name in thermal}
    effusivity = 1.0
    if own["heat_capacity"] or own["conductivity"]:
        effusivity = float(
            laws.effusivity_of_balls(
                own["conductivity"] or steel.conductivity,
                ball["density"],
                own["heat_capacity"] or steel.heat,
            )
        )
    expansion = own["expansion"] or float(steel.expansion)
    return BallMaterial(**ball, expansion=expansion, effusivity=effusivity), Steel(**ring)
