# SPDX-License-Identifier: GPL-2.0-or-later
"""A number with its unit and its name in words."""

from typing import NamedTuple

from raceway.units import prefixed


class Quantity(NamedTuple):
    """`value` in the SI `unit`, which is "" for a plain number and "%" for a share given as a
    fraction."""

    value: float
    unit: str
    label: str

    @property
    def text(self) -> str:
        """Text to be read: four digits with an SI prefix, three digits for a share."""
        if self.unit == "%":
            return f"{100 * self.value:.3g} %".replace("-", "−")
        plain = not self.unit or self.unit in ("°", "rpm", "rad/s")
        shown = (
            f"{self.value:.4g} {self.unit}".strip() if plain else prefixed(self.value, self.unit)
        )
        return shown.replace("-", "−").replace(" °", "°")
