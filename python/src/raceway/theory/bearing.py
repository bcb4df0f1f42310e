# SPDX-License-Identifier: GPL-2.0-or-later
"""The geometry and steel of one bearing.

A raceway is a torus groove. The centres of curvature of its cross-sections lie on a circle about
the ring's axis, of radius R_i + r_ci for the inner ring and R_e - r_co (+ P_d/2 with a diametral
clearance) for the outer.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws

INNER, OUTER = 0, 1


@dataclass(frozen=True)
class Bearing:
    """Deep-groove ball bearing; lengths in m, `young` in Pa. `outer_radius` is the value before
    clearance.

    Raises `ValueError` for a size that is not positive or a groove no wider than its ball.
    """

    balls: int
    ball_diameter: float
    inner_radius: float
    outer_radius: float
    inner_groove: float
    outer_groove: float
    young: float = 210e9
    poisson: float = 0.3

    def __post_init__(self):
        for field in fields(self):
            value = getattr(self, field.name)
            if not (np.isfinite(value) and (value > 0 or field.name == "poisson")):
                raise ValueError(f"{field.name} = {value} must be positive")
        if not -1 < self.poisson < 0.5:
            raise ValueError(f"poisson = {self.poisson} must lie between -1 and 0.5")
        for name in ("inner_groove", "outer_groove"):
            if getattr(self, name) <= self.ball_radius:
                raise ValueError(
                    f"{name} = {getattr(self, name)} m is conformal: the ball's radius is "
                    f"{self.ball_radius} m and the groove's must be larger"
                )
        if self.outer_radius <= self.inner_radius:
            raise ValueError(
                f"outer_radius = {self.outer_radius} m is not outside "
                f"inner_radius = {self.inner_radius} m"
            )

    @classmethod
    def from_mapping(cls, data: Mapping[str, Any]) -> "Bearing":
        """From a mapping with the field names as keys. Raises `ValueError` for a missing or unknown
        key."""
        known = {field.name for field in fields(cls)}
        if unknown := sorted(set(data) - known):
            raise ValueError(f"unknown bearing data: {', '.join(unknown)}")
        try:
            return cls(**data)
        except TypeError:
            missing = sorted(known - set(data) - {"young", "poisson"})
            raise ValueError(f"missing bearing data: {', '.join(missing)}") from None

    @property
    def ball_radius(self) -> float:
        """R_b, m."""
        return self.ball_diameter / 2

    @property
    def pitch_radius(self) -> float:
        """Half-way between the raceways before clearance, m."""
        return (self.inner_radius + self.outer_radius) / 2

    @property
    def effective_modulus(self) -> float:
        """E' = E/(1 - nu^2), Pa: Hamrock's 2/sum((1 - nu^2)/E) for like bodies (eq 2)."""
        return self.young / (1 - self.poisson**2)

    def groove(self, raceway: int) -> float:
        """Groove radius r_c of a raceway (`INNER` or `OUTER`), m."""
        return self.inner_groove if raceway == INNER else self.outer_groove

    def groove_gap(self, raceway: int) -> float:
        """r_c - R_b, m: how far a just-touching ball's centre is from the groove's centre of
        curvature."""
        return self.groove(raceway) - self.ball_radius

    def groove_circle(self, raceway: int, clearance: float = 0.0) -> float:
        """Radius of the circle of centres of curvature, m; all the clearance goes to the outer
        groove."""
        if raceway == INNER:
            return self.inner_radius + self.inner_groove
        return self.outer_radius + clearance / 2 - self.outer_groove

    def effective_radii(
        self, raceway: int, angle: Numbers = 0.0, clearance: float = 0.0
    ) -> tuple[Numbers, Numbers]:
        """(R_x along rolling, R_y across the groove) in m, the shape of `angle` (contact angle,
        rad).

        gamma = R_b cos(angle)/r_pitch; R_x = R_b (1 - gamma) inner, R_b (1 + gamma) outer (eq 2,
        Harris 2.28).
        """
        inner = raceway == INNER
        # the pitch of a ball at rest on that raceway: clearance has gone into the outer ring
        pitch = self.pitch_radius + (0.0 if inner else clearance / 2)
        return tuple(
            laws.effective_radii(
                self.ball_radius, self.groove(raceway), pitch, inner, np.cos(angle)
            )
        )
