# SPDX-License-Identifier: GPL-2.0-or-later
"""A number with its unit and its name in words."""

from typing import NamedTuple

from raceway.units import prefixed


class Quantity(NamedTuple):
    """`value` in SI `unit` ("" for a plain number, "%" for a share given as a fraction)."""

    value: float
    unit: str
    label: str

    @property
    def text(self) -> str:
        """For people, four digits and an SI prefix; shares three."""
        if self.unit == "%":
            return f"{100 * self.value:.3g} %".replace("-", "−")
        plain = not self.unit or self.unit in ("°", "rpm", "rad/s")
        shown = (
            f"{self.value:.4g} {self.unit}".strip() if plain else prefixed(self.value, self.unit)
        )
        return shown.replace("-", "−").replace(" °", "°")
