# SPDX-License-Identifier: GPL-2.0-or-later
"""Material of balls, rings and shafts."""

from typing import NamedTuple

from raceway.sweeps import variable_table


class Steel(NamedTuple):
    """Material of balls, rings or a shaft; bearing steel by default."""

    young: float = float(variable_table.default("ball_young"))  # Pa
    poisson: float = float(variable_table.default("ball_poisson"))
    density: float = float(variable_table.default("ball_density"))  # kg/m^3


STEEL = Steel()
