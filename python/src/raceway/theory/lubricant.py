# SPDX-License-Identifier: GPL-2.0-or-later
"""Properties of oils as functions of temperature and pressure (Walther, Vogel, Roelands, Barus).
Temperatures are in degrees C.

A `Lubricant` contains the physical data, and `Lubricant.at` returns the `Fluid` at a temperature.
Values are for ambient pressure unless a pressure is given. Functions accept numbers or arrays of
equal shape in SI units, except for kinematic viscosity, which is in mm^2/s like viscosity grades
and ASTM D341.
"""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws
from raceway.sweeps import variable_table


class Fluid(NamedTuple):
    """Properties of a lubricant at one temperature and ambient pressure."""

    temperature: Numbers  # degrees C
    viscosity: Numbers  # eta, Pa s
    pressure_viscosity: Numbers  # xi, 1/Pa
    temperature_viscosity: Numbers  # beta = -d(ln eta)/dT, 1/K
    density: Numbers  # kg/m^3
    permittivity: Numbers  # relative permittivity
    conductivity: float  # k_f, W/(m K)
    heat_capacity: float  # J/(kg K)
    eyring_stress: float  # tau_0, Pa
    limiting_traction: float  # Lambda_L, limiting shear stress divided by pressure

    @property
    def kinematic(self) -> Numbers:
        """Kinematic viscosity, mm^2/s."""
        return 1e6 * self.viscosity / self.density


@dataclass(frozen=True)
class Walther:
    """lg lg(nu + 0.7) = A - B lg T, defined by the kinematic viscosities in mm^2/s at 40 and 100 C.

    See ASTM D341. Raises `ValueError` unless low > high > 0.3, the limit of the double logarithm.
    """

    low: float  # kinematic viscosity at 40 C
    high: float  # kinematic viscosity at 100 C

    def __post_init__(self):
        if not (np.isfinite(self.low) and self.low > self.high > 0.3):
            raise ValueError(
                f"kinematic viscosity {self.low} mm2/s at 40 C and {self.high} at 100 C: "
                "must fall and stay above 0.3"
            )

    def viscosity(self, temperature: Numbers, oil: "Lubricant") -> tuple[Numbers, Numbers]:
        """Return (nu in mm^2/s, -d(ln nu)/dT in 1/K) at a temperature; the density of `oil` is not
        used."""
        return tuple(laws.walther(self.low, self.high, temperature))


@dataclass(frozen=True)
class Vogel:
    """eta = k exp(b/(T + c)) with T in degrees C; for FVA 3, k = 0.062e-3 Pa s, b = 1021.7 K and c
    = 101.5517 C."""

    k: float  # Pa s
    b: float  # K
    c: float  # degrees C

    def viscosity(self, temperature: Numbers, oil: "Lubricant") -> tuple[Numbers, Numbers]:
        """Return (nu in mm^2/s, -d(ln nu)/dT in 1/K) at a temperature, using the density of
        `oil`."""
        return tuple(laws.vogel(self.k, self.b, self.c, oil.density, oil.thinning, temperature))


def _usual(name):
    """Return a field whose default is the default of the deck variable `name`."""
    return field(default_factory=lambda: float(variable_table.default(name)))


@dataclass(frozen=True)
class Lubricant:
    """Physical data of an oil. Density and 1/xi are linear functions of temperature, and the
    permittivity follows Clausius-Mossotti. 1/xi depends on temperature in the same way as for FVA 3
    at ambient pressure.

    >>> vg46 = Lubricant(Walther(46.0, 7.04), 862.9, 0.6, 22.57e-9, 14.5e-9, 2.25, 0.15, 1950.0)
    >>> hot = vg46.at(70.0)
    >>> print(f"{1e3 * hot.viscosity:.2f} mPa s, {hot.temperature_viscosity:.4f} 1/K")
    12.84 mPa s, 0.0310 1/K
    """

    law: Walther | Vogel
    density: float  # kg/m^3, density at 40 C
    thinning: float  # kg/(m^3 K), rate at which the density decreases with temperature
    pressure_viscosity: float  # 1/Pa, xi at 40 C
    pressure_viscosity_hot: float  # 1/Pa, xi at 100 C
    permittivity: float  # relative permittivity at 40 C
    conductivity: float = _usual("oil_conductivity")  # W/(m K)
    heat_capacity: float = _usual("oil_heat_capacity")  # J/(kg K)
    eyring_stress: float = _usual("eyring_stress")  # Pa
    limiting_traction: float = _usual("limiting_traction")

    def at(self, temperature: Numbers) -> Fluid:
        """Return the `Fluid` at a temperature in degrees C. Raises `ValueError` outside -40 to 200
        C."""
        warm = np.asarray(temperature, float)
        if not np.all((warm >= -40) & (warm <= 200)):
            raise ValueError(f"temperature = {temperature} C must lie from -40 to 200 C")
        nu, slope = self.law.viscosity(warm, self)
        oil = laws.oil_at_temperature(
            self.density,
            self.thinning,
            self.pressure_viscosity,
            self.pressure_viscosity_hot,
            self.permittivity,
            nu,
            slope,
            warm,
        )
        if not np.all(oil.permittivity > 0):
            raise ValueError(
                f"permittivity = {self.permittivity} is too large for Clausius-Mossotti at the "
                f"density {oil.density} kg/m3"
            )
        return Fluid(
            warm[()],
            *oil,
            self.conductivity,
            self.heat_capacity,
            self.eyring_stress,
            self.limiting_traction,
        )


def roelands(viscosity: Numbers, pressure_viscosity: Numbers, pressure: Numbers) -> Numbers:
    """Return the viscosity eta in Pa s under `pressure` p in Pa (Roelands 1966): ln eta = ln eta_0
    + (ln eta_0 + 9.67) ((1 + p/1.96e8)^z - 1)."""
    return laws.roelands(viscosity, pressure_viscosity, pressure)
