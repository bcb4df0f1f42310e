# SPDX-License-Identifier: GPL-2.0-or-later
"""Model of the leakage current through an intact film (docs/electric_circuit, Leakage)."""

from dataclasses import dataclass

import numpy as np
import xarray as xr

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.theory.capacitance import VACUUM


@dataclass(frozen=True)
class Leak:
    """Conduction of films through a lubricant with the given `resistivity` (ohm m), and through
    asperities with the resistance `metal` (ohm) per contact.

    Asperities conduct where they carry more than the fraction `share` of the contact load. If
    `resistivity` or `metal` is None, there is no conduction by that mechanism. By default the
    relative `permittivity` of the lubricant is taken from the run.
    """

    resistivity: float | None = None
    metal: float | None = None
    share: float = 0.0
    permittivity: float | None = None

    def __post_init__(self) -> None:
        for name, unit in (("resistivity", "ohm m"), ("metal", "ohm")):
            value = getattr(self, name)
            if value is not None and not 0 < value < np.inf:
                raise ValueError(f"{name} = {value:g} {unit} must be positive")
        if not 0 <= self.share < 1:
            raise ValueError(f"share = {self.share:g} must be at least 0 and below 1")
        if self.permittivity is not None and not self.permittivity >= 1:
            raise ValueError(f"permittivity = {self.permittivity:g} must be 1 or more")

    def of(
        self, capacitance: Floats, contacts: xr.Dataset, permittivity: float | None, name: str
    ) -> tuple[Floats, Floats | None]:
        """Return the conductance in S of films with `capacitance` (n, 2, Z) in F, and an array that
        is 1 where asperities conduct.

        The second result is None if `metal` is None. Otherwise, `contacts` must have the column
        `asperity_share`; if it is missing, `RunError` is raised with `name` in its message.
        """
        conductance = np.zeros_like(capacitance)
        if self.resistivity is not None:
            relative = self.permittivity or permittivity
            if relative is None:
                raise ValueError(
                    "a leak with a resistivity needs the permittivity of the lubricant"
                )
            conductance += capacitance / relaxation_time(self.resistivity, relative)
        if self.metal is None:
            return conductance, None
        if "asperity_share" not in contacts:
            raise RunError(
                f"{name}: metallic films need the column asperity_share (friction mixed, contacts"
                " all)"
            )
        carried = contacts["asperity_share"].transpose("time", "raceway", "ball").to_numpy()
        metallic = np.where(np.nan_to_num(carried) > self.share, 1.0, 0.0)
        return conductance + metallic / self.metal, metallic


def relaxation_time(resistivity: float, permittivity: float) -> float:
    """Return the time constant R C in s, which is the same for any gap filled with one lubricant:
    `resistivity` (ohm m) times eps_0 times the relative `permittivity`.

    >>> round(relaxation_time(1e9, 2.25), 6)
    0.019922
    """
    return resistivity * VACUUM * permittivity
