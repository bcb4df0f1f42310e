# SPDX-License-Identifier: GPL-2.0-or-later
"""Call functions in src-package/core by name from Python (physics_c.cpp)."""

from typing import NamedTuple

import numpy as np
from raceway.core import laws
from raceway.core.exports import Library

INNER, OUTER = 0, 1
EXACT, HAMROCK, PRINTED = 0, 1, 2  # Ellipse
MASJEDI, MASJEDI_PRINTED, HAMROCK_DOWSON = 0, 1, 2  # FilmModel
FRICTIONLESS, CONSTANT, STRIBECK = 0, 1, 2  # Friction

PITCH, BALL = 30.3e-3, 6.3e-3  # m, of a 6208
BALL_MASS = 4 / 3 * np.pi * BALL**3 * 7800

# Data for a raceway (RacewayInput in physics_c.cpp); the values describe a dry 6208 inner ring.
RACEWAY = dict(
    side=INNER,
    raceway_radius=24.0e-3,
    groove_radius=6.552e-3,
    ball_radius=BALL,
    ball_young=210e9,
    ball_poisson=0.3,
    ring_young=210e9,
    ring_poisson=0.3,
    ellipse=EXACT,
    film=MASJEDI,
    viscosity=0.0,
    pressure_viscosity=0.0,
    damper_full_axis=0,
    damper_rolling_radius=0,
    friction=FRICTIONLESS,
    mu=0.0,
    mu_boundary=0.0,
    mu_full=0.0,
    lambda_1=1.0,
    lambda_2=3.0,
    hysteresis=0.08,
    ring_roughness=0.0,
    ball_roughness=0.0,
    film_floor=-1.0,
    tangential_ratio=-1.0,
    tangential_zeta=0.3,
    pitch_radius=PITCH,
    ball_mass=BALL_MASS,
    overlap_limit=0.1,
    offset=0.0,
)
OIL = dict(viscosity=0.04, pressure_viscosity=15e-9, ring_roughness=40e-9, ball_roughness=30e-9)

# functions in exp_log.h, in the same order as in physics_c.cpp
ELEMENTARY = ("exponential", "logarithm", "rough_exponential", "rough_logarithm", "arctangent")


class Hertz(NamedTuple):
    """A contact at an overlap of 1 m: a, b and p grow with the root of the overlap."""

    kappa: float
    first: float
    second: float
    radius: float
    K: float
    a: float
    b: float
    p: float


def hertz_contact(r_x, r_y, modulus, form=EXACT):
    ellipse = laws.hertz_ellipse(r_x, r_y, form)
    kappa, _, second, radius = ellipse
    stiffness = laws.hertz_stiffness(*ellipse, modulus)
    axes = laws.hertz_semi_axes(kappa, second, radius, modulus, stiffness)
    pressure = laws.hertz_pressure(kappa, second, radius, modulus, stiffness)
    return Hertz(*ellipse, stiffness, *axes, pressure)


def groove_radii(side, cos_angle=1.0, groove=6.552e-3):
    return np.array(laws.effective_radii(BALL, groove, PITCH, side == INNER, cos_angle))


def film_pair(model, kappa, viscosity, xi, modulus, r_x, speed, load):
    """Return (h_min, h_c) in m."""
    group = (viscosity * speed / (modulus * r_x), xi * modulus, load / (modulus * r_x**2))
    return tuple(r_x * h for h in laws.film_thickness(model, *group, kappa))


def rolling(inner_speed, outer_speed=0.0):
    return laws.pure_rolling(BALL, PITCH, inner_speed, outer_speed)


class Physics(Library):
    """The library of core functions; frequently used functions have their own methods."""

    def __init__(self, path):
        super().__init__(path)
        self.record("RacewayInput", RACEWAY)  # the names in C++ and Python must agree

    def elementary(self, name, x):
        """Apply a function of `ELEMENTARY` to an array, and return (one by one, four at a time)."""
        one, four = np.full(len(x), np.nan), np.full(len(x), np.nan)
        self.call("elementary", which=ELEMENTARY.index(name), n=len(x), x=x, one=one, four=four)
        return one, four

    def rotate(self, a, w):
        return self.call("vec3_rotate", a, w)

    def locate(self, d, e, circle):
        return self.call("groove_locate", d=d, e=e, centre_circle=circle)

    def raceway(self, **changes):
        return Raceway(self, changes)

    def raceway_6208(self, side, clearance=0.0, **changes):
        """Return a raceway of a 6208; a diametral clearance (m) is added to the outer groove."""
        radius = 24.0e-3 if side == INNER else 36.6e-3 + clearance / 2
        return Raceway(self, dict(side=side, raceway_radius=radius) | changes)


class Raceway:
    """A RacewayPhysics and the input `data` from which it was constructed."""

    def __init__(self, physics, changes):
        assert not set(changes) - set(RACEWAY)
        self.data = RACEWAY | changes
        self._physics = physics
        self._handle = physics.call("raceway_new", self.data)

    def __del__(self):
        self._physics.call("raceway_delete", self._handle)

    def derived(self):
        return self._physics.call("raceway_derived", self._handle)

    def exact(self, cos_angle):
        return self._physics.call(
            "raceway_exact",
            p=self._handle,
            pitch_radius=self.data["pitch_radius"],
            cos_angle=cos_angle,
        )

    def table(self, cos_angle):
        return self._physics.call("raceway_table", self._handle, cos_angle)

    def radial(self):
        return self._physics.call("raceway_radial", self._handle)

    def reach(self, depth, angle=0.0, semi_axis=0.0):
        """Return how far (m) a groove of a given depth (m) extends on both sides of a contact."""
        return self._physics.call(
            "groove_reach",
            p=self._handle,
            depth=depth,
            sine=np.sin(angle),
            cosine=np.cos(angle),
            semi_axis=semi_axis,
        )

    def touch(self, d, e):
        """Return (whether the surfaces overlap, contact state with its geometry set)."""
        touching, state = self._physics.call("contact_touch", p=self._handle, d=d, e=e)
        return bool(touching), state

    def contact(self, ball, ring, dt=0.0, xi=(0.0, 0.0)):
        """Return the state, with forces, of the contact between a ball (x, v, w) and a ring (x, v,
        w, e). The state also contains `xi` at the end of the step."""
        spring = np.array(xi, dtype=float)
        result, forces = self._physics.call(
            "contact",
            p=self._handle,
            with_film=self.data["viscosity"] > 0,
            ball=dict(zip("xvw", ball, strict=True)),
            ring=dict(zip("xvwe", ring, strict=True)),
            dt=dt,
            xi=spring,
        )
        result.xi = spring
        result.force = forces.force
        result.ball_torque, result.ring_torque = forces.ball_torque, forces.ring_torque
        return result
