# SPDX-License-Identifier: GPL-2.0-or-later
"""Geometry and material of one bearing.

A raceway is a groove in the shape of a torus. The centres of curvature of its cross-sections lie on
a circle about the ring's axis. The radius of this circle is R_i + r_ci for the inner ring and R_e -
r_co (+ P_d/2 if there is a diametral clearance) for the outer ring. A `Layout` gives each ring
several grooves, for one or more rows of balls, as in four-point contact and double-row bearings.
"""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, NamedTuple

import numpy as np

from raceway.arrays import Floats, Numbers
from raceway.core import laws
from raceway.theory.steel import STEEL, Steel

INNER, OUTER = 0, 1
MOST = 1.0  # m; larger values are assumed to have been given in millimetres
ARRANGEMENTS = {"back_to_back": 1.0, "face_to_face": -1.0}


class DoubleRow(NamedTuple):
    """Two adjacent rows of a bearing; loads act at the point midway between them."""

    spacing: float  # m, distance between the planes of the balls
    # m, distance by which each row is pushed along the axis beyond first contact
    preload: float = 0.0
    arrangement: str = "back_to_back"  # one of `ARRANGEMENTS`


def grooves(four_point: float | None, double_row: DoubleRow | None) -> dict[str, Any]:
    """Return a four-point contact angle in rad and the data of two rows as results of a command,
    with the keys of `rows.GROOVES`; those of two rows only if there are two."""
    names = ("row_spacing_m", "row_preload_m", "arrangement")
    return {"four_point_rad": four_point, **dict(zip(names, double_row or ()))}


@dataclass(frozen=True)
class Layout:
    """Axial positions of rows and grooves in m, relative to the point where loads act. By default
    there is one row with one groove per ring."""

    rows: tuple[float, ...] = (0.0,)  # planes of the balls, relative to the outer ring
    # m, axial positions of the centres of curvature; one tuple per row, with one value per groove
    inner: tuple[tuple[float, ...], ...] = ((0.0,),)
    outer: tuple[tuple[float, ...], ...] = ((0.0,),)

    @property
    def tracks(self) -> int:
        """Number of grooves in the inner ring, summed over all rows."""
        return len(self.rows) * len(self.inner[0])

    def centres(self, raceway: int, balls: int) -> Floats:
        """Return the axial positions (grooves, rows x balls) in m of the centres of curvature of a
        ring; the balls are ordered row by row."""
        by_row = np.array(self.inner if raceway == INNER else self.outer, float)
        return np.repeat(by_row.T, balls, axis=1)


@dataclass(frozen=True)
class Bearing:
    """A ball bearing, with lengths in m and `young` in Pa. `balls` is the number of balls in each
    row, and `outer_radius` is the radius without clearance. `young` and `poisson` are those of the
    balls, and of the rings unless `ring_young` and `ring_poisson` are given.

    Raises `ValueError` if a size is not positive or a groove is not wider than its ball, and warns
    if a size appears to be in millimetres.
    """

    balls: int
    ball_diameter: float
    inner_radius: float
    outer_radius: float
    inner_groove: float
    outer_groove: float
    young: float = STEEL.young
    poisson: float = STEEL.poisson
    layout: Layout = Layout()
    ring_young: float | None = None
    ring_poisson: float | None = None

    def __post_init__(self):
        for field in fields(self):
            value = getattr(self, field.name)
            if field.name == "layout" or value is None:
                continue
            if not (np.isfinite(value) and (value > 0 or field.name.endswith("poisson"))):
                raise ValueError(f"{field.name} = {value} must be positive")
        if self.ball_diameter > MOST:
            warnings.warn(
                f"ball_diameter = {self.ball_diameter:g} m: sizes are in metres, "
                f"{self.ball_diameter:g} mm is {1e-3 * self.ball_diameter:g}",
                stacklevel=3,
            )
        if self.ring[:2] == (self.young, self.poisson):  # so that alike bearings are equal
            for name in ("ring_young", "ring_poisson"):
                object.__setattr__(self, name, None)
        for name in ("poisson", "ring_poisson"):
            value = getattr(self, name)
            if value is not None and not -1 < value < 0.5:
                raise ValueError(f"{name} = {value} must lie between -1 and 0.5")
        for name in ("inner_groove", "outer_groove"):
            if getattr(self, name) <= self.ball_radius:
                raise ValueError(
                    f"{name} = {getattr(self, name)} m is conformal: the radius of the ball is "
                    f"{self.ball_radius} m, and that of the groove must be larger"
                )
        if self.outer_radius <= self.inner_radius:
            raise ValueError(
                f"outer_radius = {self.outer_radius} m is not outside "
                f"inner_radius = {self.inner_radius} m"
            )
        apart = 2 * self.pitch_radius * np.sin(np.pi / self.balls)
        if self.balls > 1 and apart < self.ball_diameter:
            raise ValueError(
                f"overlapping balls: {self.balls} balls of diameter {self.ball_diameter:g} m on a "
                f"pitch circle of radius {self.pitch_radius:g} m are {apart:g} m apart"
            )

    @classmethod
    def from_mapping(cls, data: Mapping[str, Any]) -> "Bearing":
        """Create a bearing from a mapping whose keys are the field names. Raises `ValueError` for a
        missing or unknown key."""
        known = {field.name for field in fields(cls)} - {"layout"}
        if unknown := sorted(set(data) - known):
            raise ValueError(f"unknown bearing data: {', '.join(unknown)}")
        try:
            return cls(**data)
        except TypeError:
            usual = {"young", "poisson", "ring_young", "ring_poisson"}
            missing = sorted(known - set(data) - usual)
            raise ValueError(f"missing bearing data: {', '.join(missing)}") from None

    def four_point(self, angle: float) -> "Bearing":
        """Return the four-point contact bearing with the same balls, pitch and groove radii. Each
        ring has two grooves, the one at -z first, and centred balls touch them at `angle` (rad).
        The clearance is then that of a centred ball.

        Raises `ValueError` if the angle is not between 0 and a right angle, or if a ring already
        has several grooves.

        >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
        >>> [round(1e6 * z, 1) for z in b.four_point(0.61).layout.inner[0]]  # um
        [-144.4, 144.4]
        """
        if not 0 < angle < np.pi / 2:
            raise ValueError(f"angle {angle:g} rad must lie between 0 and pi/2")
        if self.layout != Layout():
            raise ValueError("four points need a bearing with one row and one groove per ring")
        gap = [self.groove_gap(side) for side in (INNER, OUTER)]
        inside = self.pitch_radius + gap[INNER] * np.cos(angle) - self.inner_groove
        outside = self.pitch_radius - gap[OUTER] * np.cos(angle) + self.outer_groove
        arch = [((-size * float(np.sin(angle)), size * float(np.sin(angle))),) for size in gap]
        return replace(
            self,
            inner_radius=float(inside),
            outer_radius=float(outside),
            layout=Layout((0.0,), *arch),
        )

    def double_row(self, rows: DoubleRow, angle: float = 0.0) -> "Bearing":
        """Return the bearing with two `rows` of these balls, whose free contact angle is `angle`
        (rad); it is 0 for deep grooves.

        Raises `ValueError` if the arrangement is not in `ARRANGEMENTS`, if the rows overlap, or if
        the bearing already has two rows.
        """
        spacing, preload, arrangement = rows
        if arrangement not in ARRANGEMENTS:
            raise ValueError(f"arrangement '{arrangement}' is not one of {', '.join(ARRANGEMENTS)}")
        if not spacing >= self.ball_diameter:
            raise ValueError(
                f"spacing {spacing:g} m of the rows must be at least the ball's diameter,"
                f" {self.ball_diameter:g} m"
            )
        if len(self.layout.rows) > 1:
            raise ValueError("two rows need a bearing with one row")
        reach = self.seat(angle) + preload
        way = ARRANGEMENTS[arrangement]
        planes = (-way * spacing / 2, way * spacing / 2)
        (inner,), (outer,) = self.layout.inner, self.layout.outer
        layout = Layout(
            planes,
            tuple(tuple(at + h for h in inner) for at in (planes[0] + reach, planes[1] - reach)),
            tuple(tuple(at + h for h in outer) for at in planes),
        )
        return replace(self, layout=layout)

    def grown(self, inner: float, balls: float, outer: float) -> "Bearing":
        """Return the bearing whose inner ring, balls and outer ring have these thermal strains, as
        in a run (`RacewayPhysics::grow`)."""
        return replace(
            self,
            inner_radius=self.inner_radius * (1 + inner),
            inner_groove=self.inner_groove * (1 + inner),
            ball_diameter=self.ball_diameter * (1 + balls),
            outer_radius=self.outer_radius * (1 + outer),
            outer_groove=self.outer_groove * (1 + outer),
        )

    def seat(self, angle: float) -> float:
        """Return the displacement in m of the inner ring along z at which the balls touch both
        raceways at the free contact `angle` (rad)."""
        return (self.groove_gap(INNER) + self.groove_gap(OUTER)) * float(np.sin(angle))

    def play(self, angle: float) -> float:
        """Return the diametral clearance in m that gives the free contact `angle` (rad) (eq
        A.3)."""
        return 2 * (self.groove_gap(INNER) + self.groove_gap(OUTER)) * (1 - float(np.cos(angle)))

    @property
    def raceways(self) -> tuple[int, ...]:
        """`INNER` or `OUTER` for each possible contact of a ball; inner grooves come first."""
        return (INNER,) * len(self.layout.inner[0]) + (OUTER,) * len(self.layout.outer[0])

    @property
    def row(self) -> np.ndarray:
        """Row number of each ball, (rows x balls,)."""
        return np.repeat(np.arange(len(self.layout.rows)), int(self.balls))

    @property
    def ball_radius(self) -> float:
        """Ball radius R_b, m."""
        return self.ball_diameter / 2

    @property
    def pitch_radius(self) -> float:
        """Radius half-way between the raceways without clearance, m.

        It is that of the centres of the balls at a contact angle of 0. If they touch both raceways
        at the angle alpha, as in the definition of `pitch_diameter` in data files, that of their
        centres is smaller by (r_co - r_ci)(1 - cos(alpha))/2.
        """
        return (self.inner_radius + self.outer_radius) / 2

    @property
    def effective_modulus(self) -> float:
        """Hamrock's E' = 2/sum((1 - nu^2)/E), Pa, which is E/(1 - nu^2) for identical bodies (eq
        2)."""
        ball, ring = (steel.young / (1 - steel.poisson**2) for steel in (self, self.ring))
        return ball if ball == ring else 2 / (1 / ball + 1 / ring)

    @property
    def ring(self) -> Steel:
        """Elastic constants of the rings; the density is not that of the bearing."""
        young = self.young if self.ring_young is None else self.ring_young
        return Steel(young, self.poisson if self.ring_poisson is None else self.ring_poisson)

    def groove(self, raceway: int) -> float:
        """Return the groove radius r_c of a raceway (`INNER` or `OUTER`) in m."""
        return self.inner_groove if raceway == INNER else self.outer_groove

    def groove_gap(self, raceway: int) -> float:
        """Return r_c - R_b in m, the distance between the centre of a ball that just touches the
        groove and the centre of curvature of the groove."""
        return self.groove(raceway) - self.ball_radius

    def arch(self, raceway: int) -> float:
        """Return the distance in m of the centres of curvature from the central plane of the balls
        if the raceway has two grooves, or 0 if it has one."""
        by_row = self.layout.inner if raceway == INNER else self.layout.outer
        return (by_row[0][-1] - by_row[0][0]) / 2

    def groove_circle(self, raceway: int, clearance: float = 0.0) -> float:
        """Return the radius in m of the circle of centres of curvature. The clearance is assigned
        entirely to the outer groove."""
        if raceway == INNER:
            return self.inner_radius + self.inner_groove
        return self.outer_radius + clearance / 2 - self.outer_groove

    def effective_radii(
        self, raceway: int, angle: Numbers = 0.0, clearance: float = 0.0
    ) -> tuple[Numbers, Numbers]:
        """Return (R_x in the rolling direction, R_y across the groove) in m for a contact at the
        contact angle `angle` (rad).

        With gamma = R_b cos(angle)/r_pitch, R_x is R_b (1 - gamma) for the inner and R_b (1 +
        gamma) for the outer raceway (eq 2, Harris 2.28).
        """
        inner = raceway == INNER
        # pitch radius of a ball resting on this raceway; the outer groove has all the clearance
        pitch = self.pitch_radius + (0.0 if inner else clearance / 2)
        return tuple(
            laws.effective_radii(
                self.ball_radius, self.groove(raceway), pitch, inner, np.cos(angle)
            )
        )
