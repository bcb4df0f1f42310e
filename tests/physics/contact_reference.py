# SPDX-License-Identifier: GPL-2.0-or-later
"""Reference for contact.h that treats a ball and a ring as moving rigid bodies, with 40 digits.

The reference does not use the derivation in the header. Points on the bodies are followed along the
motion (constant velocities, Rodrigues rotation), and their positions are differentiated in time.
Vectors consist of mpmath numbers, so the step size of the differences does not limit the accuracy.
"""

import mpmath
import numpy as np
from mpmath import mpf

DIGITS = 40


def vector(values):
    return [mpf(float(v)) for v in values]


def dot(a, b):
    return mpmath.fsum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b, s=1):
    return [x + s * y for x, y in zip(a, b)]


def scale(a, s):
    return [s * x for x in a]


def length(a):
    return mpmath.sqrt(dot(a, a))


def turn(a, w):
    angle = length(w)
    if angle == 0:
        return a
    k, c, s = scale(w, 1 / angle), mpmath.cos(angle), mpmath.sin(angle)
    return add(add(scale(a, c), cross(k, a), s), k, dot(k, a) * (1 - c))


def derivative(f):
    """Return df/dt at t = 0 for a vector function, from central differences with Richardson
    extrapolation.

    The time scale of the motions is T = 1e-5 s or more, so the truncation error is (h/T)^4 = 1e-36,
    and the rounding error is 1e-40 m/h = 1e-26 m/s.
    """
    h = mpf(10) ** -14  # s

    def central(h):
        return scale(add(f(h), f(-h), -1), 1 / (2 * h))

    return add(scale(central(h), mpf(4) / 3), central(2 * h), mpf(-1) / 3)


class Reference:
    """A ball (x, v, w) with a given `radius` (m), and a ring (x, v, w, e) with a torus groove whose
    centre circle has the radius `circle` (m)."""

    def __init__(self, ball, ring, circle, radius):
        self.ball, self.ring = [vector(q) for q in ball], [vector(q) for q in ring]
        # make the axis a unit vector
        self.ring[3] = scale(self.ring[3], 1 / length(self.ring[3]))
        self.circle, self.radius = mpf(circle), mpf(radius)

    def frame(self, t=0):
        """Return the geometry at time t (s): u, t, e, n, w, s and the contact point."""
        t = mpf(t)
        x = add(self.ball[0], self.ball[1], t)
        centre = add(self.ring[0], self.ring[1], t)
        e = turn(self.ring[3], scale(self.ring[2], t))
        d = add(x, centre, -1)
        radial = add(d, e, -dot(d, e))
        u = scale(radial, 1 / length(radial))
        arm = add(d, u, -self.circle)  # from the nearest point on the circle of groove centres
        s = length(arm)
        n = scale(arm, 1 / s)
        rolling = cross(e, u)
        return dict(
            u=u, t=rolling, e=e, n=n, w=cross(n, rolling), s=s, point=add(x, n, self.radius), d=d
        )

    def speeds(self):
        """Return (overlap_rate, sliding_t, sliding_w, entrainment)."""
        now = self.frame()
        arm = add(now["point"], self.ball[0], -1)
        lever = add(now["point"], self.ring[0], -1)
        on_ball = derivative(
            lambda t: add(add(self.ball[0], self.ball[1], t), turn(arm, scale(self.ball[2], t)))
        )
        on_ring = derivative(
            lambda t: add(add(self.ring[0], self.ring[1], t), turn(lever, scale(self.ring[2], t)))
        )
        point = derivative(lambda t: self.frame(t)["point"])
        sliding = add(on_ball, on_ring, -1)
        entrained = add(add(on_ball, on_ring), point, -2)
        rate = derivative(lambda t: [self.frame(t)["s"]])[0]
        return [
            float(v)
            for v in (
                rate,
                dot(sliding, now["t"]),
                dot(sliding, now["w"]),
                abs(dot(entrained, now["t"])) / 2,
            )
        ]

    def vectors(self):
        return {
            name: np.array([float(v) for v in value])
            for name, value in self.frame().items()
            if name != "s"
        }
