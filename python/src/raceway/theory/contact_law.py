# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact load in statics as a function of overlap, from Hertz's law either alone or combined with
the film in the gap."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, Numbers
from raceway.core import laws
from raceway.theory import film, film_factors, film_gap, hertz, kinematics
from raceway.theory.bearing import Bearing
from raceway.theory.lubricant import Fluid


class Response(NamedTuple):
    """Load and stiffness of contacts at given overlaps, in arrays of equal shape."""

    load: Floats  # N
    slope: Floats  # d(load)/d(overlap), N/m
    energy: Floats  # J
    elastic: Floats  # m, elastic compression by Hertz's law


Law = Callable[[Floats], Response]  # a function of overlaps in m, which are negative in a gap


def hertzian(stiffness: Floats) -> Law:
    """Return the law Q = K overlap^1.5, with K in N/m^1.5."""

    def law(overlap):
        squeeze = np.maximum(overlap, 0)
        load = hertz.load(stiffness, overlap)
        energy = laws.hertz_energy(load, squeeze)
        return Response(load, 1.5 * stiffness * np.sqrt(squeeze), energy, squeeze)

    return law


@dataclass(frozen=True)
class FilmInGap:
    """The film of Masjedi and Khonsari between rolling surfaces, reduced by inlet shear heating.

    Below a load of `film_gap.CUT` newtons the film thickness is constant, so that contact begins at
    a gap of that height.
    """

    fluid: Fluid
    speed: float  # rad/s, speed of the inner ring
    starvation: float = 1.0  # factor on the film thickness due to starvation
    share: float = 1.0  # factor zeta on the film thickness in the gap
    # (C, Z), m/s, entrainment speeds; by default, of pure rolling at the angle of each contact
    entrainment: Floats | None = None

    def factor(self, speed: Numbers) -> Numbers:
        """Return the factor on the film thickness at the entrainment `speed` in m/s, i.e. phi_T of
        Murch and Wilson times the starvation factor."""
        loading = film_factors.thermal_loading(
            self.fluid.temperature_viscosity, self.fluid.viscosity, speed, self.fluid.conductivity
        )
        return film_factors.murch_wilson(loading) * self.starvation

    def law(self, bearing: Bearing, angle: Floats, clearance: float, stiffness: Floats) -> Law:
        """Return the `Law` of the contacts of `bearing.raceways`. The contact `angle` in rad and
        the `stiffness` are arrays (C, Z), by contact and ball."""
        radii = np.array(
            [
                bearing.effective_radii(side, one, clearance)
                for side, one in zip(bearing.raceways, angle)
            ]
        )
        r_x, r_y = radii[:, 0], radii[:, 1]
        kappa = hertz.ellipticity(r_y / r_x)
        speed = self.entrainment
        if speed is None:
            speed = kinematics.entrainment(bearing, self.speed, angle)
        exponent, cut = film.load_exponent(kappa), film_gap.CUT
        thickness = film_gap.power_law(
            self.fluid.viscosity,
            self.fluid.pressure_viscosity,
            bearing.effective_modulus,
            r_x,
            kappa,
            speed,
            factor=self.factor(speed),
        )
        bottom, _ = thickness(np.full(r_x.shape, cut))

        def law(overlap):
            found = film_gap.solve(overlap, stiffness, thickness, self.share)
            energy = film_gap.energy(found, exponent, self.share, cut, bottom)
            return Response(found.load, found.slope, energy, found.elastic)

        return law
