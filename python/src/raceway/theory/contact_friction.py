# SPDX-License-Identifier: GPL-2.0-or-later
"""Parameters of the friction laws of rolling contacts, and the resistances that they determine."""

from dataclasses import dataclass

import numpy as np

from raceway.arrays import Floats
from raceway.core import laws
from raceway.theory import film_factors, oil_supply, rolling, traction
from raceway.theory.bearing import Bearing
from raceway.theory.lubricant import Fluid
from raceway.theory.makers import Size


@dataclass(frozen=True)
class Surfaces:
    """Parameters of the friction laws other than geometry, loads and oil."""

    boundary: float = 0.12  # boundary friction coefficient mu_b in running (SKF)
    film: float | None = 0.05  # traction coefficient of the film; None: from the Eyring stress
    loss: float = 0.016  # hysteresis loss factor alpha, typically 0.005 to 0.05
    oil_share: float = 0.05  # fraction of the space around the balls that is filled with oil
    inlet: float = 0.0  # inlet length of rolling contacts, in multiples of b; 0: fully flooded
    starvation: float = 1.0  # factor on the hydrodynamic couple


def surfaces(
    bearing: Bearing,
    size: Size | None,
    fluid: Fluid,
    ring: float,
    models: str = "full",
    supply: oil_supply.Supply = oil_supply.BATH,
) -> Surfaces:
    """Return the `Surfaces` for the `models` of a run, full or eyring. The inlet, the oil fraction
    and SKF's starvation factor are those of a `supply` for an inner ring that turns at `ring`
    rad/s. If the `size` of the bearing is not given, the starvation factor is 1."""
    found = oil_supply.numbers(supply, bearing, fluid.density)
    starved = 1.0
    if size is not None:
        mm, rpm = (1e3 * size.bore, 1e3 * size.outside), abs(ring) * 30 / np.pi
        starved = laws.skf_starvation(*mm, fluid.kinematic, rpm, found.replenishment, size.slender)
    return Surfaces(
        film=None if models == "eyring" else Surfaces.film,
        starvation=float(starved),
        oil_share=found.share,
        inlet=found.inlet,
    )


def coefficient(
    surfaces: Surfaces, fluid: Fluid, share: Floats, pressure: Floats, slid: Floats, h_c: Floats
) -> Floats:
    """Return the friction coefficient mu of contacts whose asperities carry the fraction `share` of
    the load. Films of thickness h_c (m) are sheared at the sliding speed `slid` in m/s, under the
    largest `pressure` in Pa."""
    smooth = surfaces.film
    if smooth is None:
        smooth = traction.coefficient(
            fluid.viscosity,
            fluid.pressure_viscosity,
            pressure,
            slid / h_c,
            fluid.eyring_stress,
            fluid.limiting_traction,
        )
    return traction.mixed(share, surfaces.boundary, smooth)


def rolling_force(
    bearing: Bearing,
    fluid: Fluid,
    surfaces: Surfaces,
    r_x: Floats,
    r_y: Floats,
    h_c: Floats,
    b: Floats,
    load: Floats,
    speed: Floats,
) -> Floats:
    """Return the force 2 f in N that resists rolling at the entrainment `speed` in m/s, which is
    reduced by inlet shear heating, starvation and a short inlet. The effective radii, the film h_c
    and the semi-axis b are in m, and the load is in N."""
    loading = film_factors.thermal_loading(
        fluid.temperature_viscosity, fluid.viscosity, speed, fluid.conductivity
    )
    inlet = rolling.inlet(surfaces.inlet, h_c, b, r_x) if len(b) else 1.0
    factor = rolling.inlet_shear(loading) * surfaces.starvation * inlet
    oil, modulus = fluid.viscosity, bearing.effective_modulus
    return 2 * factor * rolling.hydrodynamic(oil, modulus, r_x, r_y, speed, load)
