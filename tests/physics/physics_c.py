# SPDX-License-Identifier: GPL-2.0-or-later
"""The functions of src-package/physics, callable from Python: records come back as namespaces,
vectors as arrays."""

import ctypes
from types import SimpleNamespace

import numpy as np

INNER, OUTER = 0, 1
EXACT, HAMROCK, PRINTED = 0, 1, 2  # Ellipse
MASJEDI, MASJEDI_PRINTED, HAMROCK_DOWSON = 0, 1, 2  # FilmModel
FRICTIONLESS, CONSTANT, STRIBECK = 0, 1, 2  # Friction

PITCH, BALL = 30.3e-3, 6.3e-3  # m, of a 6208
BALL_MASS = 4 / 3 * np.pi * BALL**3 * 7800

# What a raceway is made of, in the order of RacewayInput in physics_c.cpp; the values are a dry
# 6208 inner ring.
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
)
OIL = dict(viscosity=0.04, pressure_viscosity=15e-9, ring_roughness=40e-9, ball_roughness=30e-9)

CONSTANTS = "K a b p min_lnA min_p min_m central_lnA central_p central_m film_damper".split()
STATE = (
    "r z nu ne overlap root cos_angle overlap_rate load stiffness damping normal entrainment "
    "sliding_t sliding_w h_min lam mu kt ct friction_t friction_w"
).split()


def _argument(value):
    if isinstance(value, ctypes.c_void_p):
        return value
    if np.ndim(value) == 0:
        return ctypes.c_double(value)
    if isinstance(value, np.ndarray) and value.dtype == float and value.flags.c_contiguous:
        # shared: the function may write
        return value.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
    return (ctypes.c_double * len(value))(*value)


class Physics:
    """The library; a function of one number `name` is called `scalar(name, ...)`, the rest have a
    method each."""

    def __init__(self, path):
        self._library = ctypes.CDLL(str(path))
        assert self.scalar("raceway_input_size") == len(RACEWAY), (
            "physics_c.py and physics_c.cpp differ"
        )

    def scalar(self, name, *arguments):
        function = self._library[name]
        function.restype = ctypes.c_double
        return function(*map(_argument, arguments))

    def array(self, name, size, *arguments):
        out = np.full(size, np.nan)
        function = self._library[name]
        function.restype = None
        function(*map(_argument, arguments), _argument(out))
        return out

    def record(self, name, fields, *arguments):
        fields = fields.split() if isinstance(fields, str) else fields
        return SimpleNamespace(
            **dict(zip(fields, map(float, self.array(name, len(fields), *arguments))))
        )

    def elementary(self, name, x):
        """`exponential` or `logarithm` of an array: (one by one, four side by side)."""
        one, four = np.full(len(x), np.nan), np.full(len(x), np.nan)
        self._library.elementary(
            *map(_argument, (name == "exponential", len(x), np.array(x, float), one, four))
        )
        return one, four

    def rotate(self, a, w):
        return self.array("vec3_rotate", 3, a, w)

    def elliptic(self, m1):
        return self.record("elliptic", "K E D", m1)

    def hertz(self, r_x, r_y, modulus, form=EXACT):
        return self.record("hertz", "kappa Ebar Fbar R K a b p", r_x, r_y, modulus, form)

    def radii(self, side, cos_angle=1.0, groove=6.552e-3):
        return self.array("radii", 2, BALL, groove, PITCH, side == INNER, cos_angle)

    def film(self, model, kappa, viscosity, xi, modulus, r_x, speed, load):
        """(h_min, h_c) in m."""
        laws = self.array("film", 6, model, kappa, viscosity, xi, modulus, r_x)
        return tuple(self.scalar("thickness", *law, speed, load) for law in (laws[:3], laws[3:]))

    def locate(self, d, e, circle):
        out = self.array("groove_locate", 11, d, e, circle)
        return SimpleNamespace(
            u=out[:3], t=out[3:6], **dict(zip("r z s nu ne".split(), map(float, out[6:])))
        )

    def rolling(self, inner_speed, outer_speed=0.0, ball=BALL, pitch=PITCH):
        return self.record("rolling", "orbit spin", ball, pitch, inner_speed, outer_speed)

    def raceway(self, **changes):
        return Raceway(self, changes)

    def raceway_6208(self, side, clearance=0.0, **changes):
        """Raceway of a 6208; the diametral clearance goes into the outer groove."""
        radius = 24.0e-3 if side == INNER else 36.6e-3 + clearance / 2
        return Raceway(self, dict(side=side, raceway_radius=radius) | changes)


class Raceway:
    """A RacewayPhysics; `data` is what it was made of."""

    def __init__(self, physics, changes):
        assert not set(changes) - set(RACEWAY)
        self.data = RACEWAY | changes
        self._physics, self._library = physics, physics._library
        self._library.raceway_new.restype = ctypes.c_void_p
        self._handle = ctypes.c_void_p(
            self._library.raceway_new(_argument(list(self.data.values())))
        )

    def __del__(self):
        self._library.raceway_delete(self._handle)

    def derived(self):
        return self._physics.record(
            "raceway_derived",
            "centre_circle slack largest_overlap roughness "
            "inverse_roughness floor kt_ratio ct_factor modulus",
            self._handle,
        )

    def exact(self, cos_angle):
        return self._physics.record(
            "raceway_exact", CONSTANTS, self._handle, self.data["pitch_radius"], cos_angle
        )

    def table(self, cos_angle):
        return self._physics.record("raceway_table", CONSTANTS, self._handle, cos_angle)

    def radial(self):
        return self._physics.record("raceway_radial", CONSTANTS, self._handle)

    def touch(self, d, e):
        """(whether the surfaces overlap, state with the geometry set)."""
        state = np.full(28, np.nan)
        touching = self._physics.scalar("contact_touch", self._handle, d, e, state)
        return bool(touching), _state(state)

    def contact(self, ball, ring, dt=0.0, xi=(0.0, 0.0)):
        """State with forces of a ball (x, v, w) on a ring (x, v, w, e); `xi` after the step is in
        the state."""
        assert len(ball) == 3 and len(ring) == 4
        state, forces, spring = np.full(28, np.nan), np.full(9, np.nan), np.array(xi, dtype=float)
        self._library.contact(
            self._handle,
            *map(
                _argument,
                (
                    self.data["viscosity"] > 0,
                    np.concatenate(ball),
                    np.concatenate(ring),
                    dt,
                    spring,
                    state,
                    forces,
                ),
            ),
        )
        result = _state(state)
        result.xi = spring
        result.force, result.ball_torque, result.ring_torque = forces[:3], forces[3:6], forces[6:]
        return result


def _state(values):
    return SimpleNamespace(u=values[:3], t=values[3:6], **dict(zip(STATE, map(float, values[6:]))))
