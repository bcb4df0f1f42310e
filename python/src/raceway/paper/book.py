# SPDX-License-Identifier: GPL-2.0-or-later
"""Input data of the products: readings, the bearing and the oils."""

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from raceway import inputs
from raceway.inputs import Oil
from raceway.paper.reading import Readings
from raceway.theory import kinematics
from raceway.theory.bearing import Bearing

OILS = {"mineral": "mineral oil", "pao48": "PAO VG48"}


@dataclass
class Book:
    """Readings of the finished cases, and the corresponding data of inputs/."""

    root: Path
    readings: Readings

    @cached_property
    def bearing(self) -> Bearing:
        """The bearing of the paper, a 6208."""
        return inputs.bearing(self.root / "inputs/bearings/6208")

    @cached_property
    def oils(self) -> dict[str, Oil]:
        """{name: `Oil`} for the two oils of the paper."""
        return {name: inputs.oil(self.root / "inputs/lubricants" / name) for name in OILS}

    def entrainment(self, rpm: float) -> float:
        """Return U_r in m/s of the 6208 for an inner ring speed in rpm."""
        return float(kinematics.entrainment(self.bearing, rpm * math.pi / 30))
