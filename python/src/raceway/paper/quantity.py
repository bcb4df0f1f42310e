# SPDX-License-Identifier: GPL-2.0-or-later
"""A value with its unit and a label."""

from typing import NamedTuple

from raceway.units import prefixed


class Quantity(NamedTuple):
    """A value in the SI `unit`, which is "" for a dimensionless number and "%" for a percentage
    whose `value` is a fraction."""

    value: float
    unit: str
    label: str

    @property
    def text(self) -> str:
        """Formatted value: four digits with an SI prefix, or three digits for a percentage."""
        if self.unit == "%":
            return f"{100 * self.value:.3g} %".replace("-", "−")
        plain = not self.unit or self.unit in ("°", "rpm", "rad/s")
        shown = (
            f"{self.value:.4g} {self.unit}".strip() if plain else prefixed(self.value, self.unit)
        )
        return shown.replace("-", "−").replace(" °", "°")
