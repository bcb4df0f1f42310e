# SPDX-License-Identifier: GPL-2.0-or-later
"""Values with their units and labels."""

from collections.abc import Mapping
from functools import cache
from importlib import resources
from typing import Any, NamedTuple

import yaml

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


@cache
def data(name: str) -> Any:
    """Return the contents of the file `name`.yaml of this package."""
    path = resources.files("raceway.paper").joinpath(f"{name}.yaml")
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def labelled(values: Mapping[str, float | tuple[float, float]]) -> dict[str, Quantity]:
    """Return {name: `Quantity`} for {name: value}, with the units and labels of quantities.yaml. A
    value may be a pair whose second number is part of the label."""
    result = {}
    for name, found in values.items():
        unit, label = data("quantities")[name]
        if isinstance(found, tuple):
            found, more = found
            label %= more
        result[name] = Quantity(found, unit, label)
    return result
