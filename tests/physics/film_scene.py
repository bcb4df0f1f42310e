# SPDX-License-Identifier: GPL-2.0-or-later
"""A contact of a 6208 with its film, evaluated by the code of a run, by the Python package, and in
40-digit arithmetic."""

import pytest
from physics_c import groove_radii
from raceway import film_factors, film_gap
from references import film as reference
from references import hertz

OIL = (0.04, 22e-9)
SPEEDS = (0.0725, 0.72481, 2.899, 14.4946)
ROUNDING = 1e-12  # forty rounding errors, in exponents of at most 50
OVERLAPS = (-3e-6, -2.2e-6, -1.5e-6, -0.7e-6, -1e-7, -3e-8, 0.0, 3e-8, 1e-6, 17e-6, 60e-6)


def scene(share=1.0, starvation=1.0, regimes=False, shear=0, sliding=0.0):
    return {
        "share": share,
        "starvation": starvation,
        "all_regimes": float(regimes),
        "shear": float(shear),
        "sliding": sliding,
    }


class Gap:
    """A contact of a 6208 with its film, on one of the raceways."""

    def __init__(self, physics, side):
        self.call = physics.call
        self.raceway = physics.raceway_6208(
            side, viscosity=OIL[0], pressure_viscosity=OIL[1], ring_roughness=1e-7
        )
        self.modulus = self.raceway.derived().modulus
        self.r_x, self.r_y = groove_radii(side)
        exact = hertz.contact(self.r_x, self.r_y, self.modulus, 1.0)
        self.kappa, self.stiffness = exact["kappa"], self.raceway.radial().K
        assert exact["stiffness"] == pytest.approx(self.stiffness, rel=1e-13)

    def cpp(self, overlap, speed, share=1.0, starvation=1.0, **changes):
        """Return whether the contact is open, and the values for the contact, computed by the code
        of a run."""
        return self.call(
            "film_contact",
            p=self.raceway._handle,
            scene=scene(share=share, starvation=starvation, **changes),
            overlap=overlap,
            speed=speed,
        )

    def stored(self, overlap, speed, **changes):
        """Return the energy in J that is stored in the contact."""
        return self.call(
            "film_stored",
            p=self.raceway._handle,
            scene=scene(**changes),
            overlap=overlap,
            speed=speed,
        )

    def law(self, speed, factor=1.0):
        return reference.power_law(*OIL, self.modulus, self.r_x, self.kappa, speed, factor)

    def regimes(self, speed, factor=1.0):
        return reference.all_regimes(*OIL, self.modulus, self.r_x, self.r_y, speed, factor)

    def heated(self, law, speed, sliding, cut):
        """Return `law` with Gupta's factor for inlet shear heating included."""
        loading = 0.047 * OIL[0] * speed**2 / 0.134
        peak = self.raceway.radial().p * self.stiffness ** (-1 / 3) / self.modulus
        return reference.heated(law, loading, peak, sliding / speed, cut)

    def python(self, law, speed, share=1.0, factor=1.0, overlap=0.0):
        """Return `film_gap.Squeeze` from the Python package; `law` contains changes of the same
        form as those of `cpp`."""
        contact = (*OIL, self.modulus, self.r_x)
        if law.get("regimes"):
            film = film_gap.all_regimes(*contact, self.r_y, speed, factor=factor)
        else:
            film = film_gap.power_law(*contact, self.kappa, speed, factor=factor)
        if "shear" in law:
            loading = film_factors.thermal_loading(0.047, OIL[0], speed, 0.134)
            peak = self.raceway.radial().p * self.stiffness ** (-1 / 3) / self.modulus
            film = film_gap.heated(film, loading, peak, law["sliding"] / speed, cut=film.cut)
        return film_gap.solve(overlap, self.stiffness, film, share)
