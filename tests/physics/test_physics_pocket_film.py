# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of pocket_film.h. The squeeze force agrees with quadrature of the short-bearing line load
and, with its effective width, with numerical solutions of Reynolds' equation."""

import numpy as np
import pytest
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

RADIUS, CLEARANCE, HEIGHT, OIL = 6e-3, 0.15e-3, 4.2e-3, 0.04
CUT = 0.99  # largest eccentricity ratio of the film


def width(physics, spherical, e, clearance=CLEARANCE, height=HEIGHT):
    return physics.formula("pocket_film_width")(RADIUS, clearance, height, spherical, e)


def squeeze(physics, x, v, spherical=1):
    return physics.call(
        "pocket_squeeze",
        film=np.array([RADIUS, CLEARANCE, HEIGHT, OIL, spherical]),
        x=np.array(x, float),
        v=np.array(v, float),
    )


def force(physics, x, v, spherical=1):
    s = squeeze(physics, x, v, spherical)
    return -(s.spring * np.asarray(x) + s.damper * np.asarray(v))


def line_loads(L, e, angle):
    """Return the force components along the displacement and across it for the unit speed in the
    direction `angle` (rad), by quadrature over the half of the band that the ball approaches."""
    nodes, weights = np.polynomial.legendre.leggauss(200)
    theta = angle + np.pi / 2 * nodes
    load = OIL * (L / CLEARANCE / (1 - e * np.cos(theta))) ** 3 * np.cos(theta - angle)
    weights = weights * np.pi / 2 * RADIUS * load
    return -np.array([np.sum(weights * np.cos(theta)), np.sum(weights * np.sin(theta))])


@pytest.mark.parametrize("spherical", [0, 1])
@pytest.mark.parametrize("e", [0.0, 1e-4, 0.3, 0.8, 0.97])
def test_the_force_is_the_integral_of_the_line_load(physics, e, spherical):
    L = width(physics, spherical, e)
    for angle in (0.0, 0.7, np.pi / 2, 2.2, np.pi, -1.1):
        expected = line_loads(L, e, angle) * 1e-3
        for turn in (0.0, 2.0):  # direction of the displacement in the pocket
            t = np.array([np.cos(turn), np.sin(turn), 0.0])
            s = np.array([-np.sin(turn), np.cos(turn), 0.0])
            v = 1e-3 * (np.cos(angle) * t + np.sin(angle) * s)
            found = force(physics, e * CLEARANCE * t, v, spherical)
            assert found == pytest.approx(
                expected[0] * t + expected[1] * s, rel=1e-5, abs=2e-5 * np.abs(expected).max()
            )


def test_a_film_resists_every_motion(physics):
    draw = np.random.default_rng(1)
    for _ in range(200):
        x, v = draw.normal(size=3) * 1e-4, draw.normal(size=3) * 10 ** draw.uniform(-6, 0)
        assert np.dot(force(physics, x, v), v) < 0
    # a ball that leaves the wall is held back by the film on the far side alone
    wall = np.array([0.9 * CLEARANCE, 0, 0])
    away, closer = (abs(force(physics, wall, (sign, 0, 0))[0]) for sign in (-1.0, 1.0))
    assert away < 1e-2 * closer


@pytest.mark.parametrize("spherical", [0, 1])
def test_derivatives_of_the_coefficients(physics, spherical):
    draw = np.random.default_rng(2)
    for _ in range(30):
        x, v = np.zeros(3), np.zeros(3)
        plane = 3 if spherical else 2
        x[:plane] = draw.normal(size=plane)
        x *= draw.uniform(0.05, 0.97) * CLEARANCE / np.linalg.norm(x)
        v[:plane] = draw.normal(size=plane) * 1e-2
        s = squeeze(physics, x, v, spherical)
        for way in np.eye(3)[:plane]:
            for moved, size, slopes in (
                (1, 1e-10, lambda k, w=way, x=x, v=v: 2 * k[0] * x @ w + k[1] * v @ w),
                (0, 1e-7, lambda k, w=way, x=x, v=v: k[1] * x @ w + 2 * k[2] * v @ w),
            ):
                step = way * size
                ends = [
                    squeeze(physics, x + moved * d, v + (1 - moved) * d, spherical)
                    for d in (-step, step)
                ]
                for name in ("spring", "damper"):
                    low, high = (getattr(one, name) for one in ends)
                    slope = slopes(getattr(s, f"by_{name}"))
                    error = 1e-9 * max(abs(low), abs(high)) / size  # of the difference
                    assert slope == pytest.approx((high - low) / (2 * size), rel=1e-4, abs=error)


def test_the_surfaces_do_not_come_closer_than_their_roughness(physics):
    ways = [np.array([e * CLEARANCE, 0, 0]) for e in (CUT, 1.0, 1.05)]
    damper = [force(physics, x, (1e-3, 0, 0))[0] for x in ways]
    assert damper[1:] == pytest.approx(damper[:1] * 2, rel=1e-9)


def reynolds(spherical, e, clearance, height):
    """Return the squeeze force for unit viscosity and speed towards the wall, from a numerical
    solution of Reynolds' equation (finite volumes) over the half of the band that the ball
    approaches. The pressure is zero at the edges."""
    R, n, m = RADIUS, 121, 61
    s, u = np.linspace(-1, 1, n), np.linspace(-1, 1, m)
    theta = np.pi / 2 * np.sinh(3 * s) / np.sinh(3)  # denser where the gap is small
    y = height / 2 * u if spherical else 0.95 * R * np.sinh(3 * u) / np.sinh(3)

    def gap(theta, y):
        if spherical:
            return clearance * (1 - e * np.cos(theta) * np.cos(y / R))
        return clearance * (1 - e * np.cos(theta)) + R - np.sqrt(R * R - y * y)

    T, Y = np.meshgrid(theta, y, indexing="ij")
    towards = np.cos(T) * np.cos(Y / R) if spherical else np.cos(T)
    dx, dy = np.diff(R * theta), np.diff(y)
    cell = np.outer(dx[1:] + dx[:-1], dy[1:] + dy[:-1])[:, :] / 4
    wide, high = (dx[1:] + dx[:-1])[:, None] / 2, (dy[1:] + dy[:-1])[None, :] / 2
    by_x = gap((T[1:] + T[:-1]) / 2, Y[1:])[:, 1:-1] ** 3 / dx[:, None] * high
    by_y = gap(T[:, 1:], (Y[:, 1:] + Y[:, :-1]) / 2)[1:-1] ** 3 / dy[None, :] * wide
    number = np.full((n, m), -1)
    number[1:-1, 1:-1] = np.arange((n - 2) * (m - 2)).reshape(n - 2, m - 2)
    here = number[1:-1, 1:-1]
    near = [
        (number[2:, 1:-1], by_x[1:]),
        (number[:-2, 1:-1], by_x[:-1]),
        (number[1:-1, 2:], by_y[:, 1:]),
        (number[1:-1, :-2], by_y[:, :-1]),
    ]
    rows, columns, values = [here.ravel()], [here.ravel()], [-sum(k for _, k in near).ravel()]
    for other, k in near:
        inside = other >= 0
        rows.append(here[inside])
        columns.append(other[inside])
        values.append(k[inside])
    matrix = sparse.csc_matrix(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    )
    share = towards[1:-1, 1:-1] * cell
    return float(np.sum(spsolve(matrix, -12 * share.ravel()) * share.ravel()))


@pytest.mark.parametrize("height", [0.4, 0.7, 1.0])
def test_a_spherical_pocket_solves_reynolds_equation(physics, height):
    for e in (0.0, 0.3, 0.6, 0.8, 0.9, 0.95, 0.98):
        L = width(physics, 1, e, height=height * RADIUS)
        found = -line_loads(L, e, 0.0)[0] / OIL
        assert found == pytest.approx(reynolds(True, e, CLEARANCE, height * RADIUS), rel=0.12)


@pytest.mark.parametrize("clearance", [0.01, 0.025, 0.04])
def test_a_cylindrical_pocket_solves_reynolds_equation(physics, clearance):
    c = clearance * RADIUS
    for e in (0.0, 0.3, 0.6, 0.8, 0.9, 0.95, 0.98):
        L = width(physics, 0, e, clearance=c)
        found = -line_loads(L, e, 0.0)[0] / OIL * (CLEARANCE / c) ** 3
        assert found == pytest.approx(reynolds(False, e, c, HEIGHT), rel=0.08)


@pytest.mark.parametrize("spherical", [0, 1])
def test_close_to_the_wall_the_force_is_that_of_two_curved_surfaces(physics, spherical):
    """The pressure A/h^2 solves Reynolds' equation in the gap between two surfaces with the
    relative radii of curvature r_x and r_y. Its integral is 12 pi eta v sqrt(r_x r_y)/(h (1/r_x +
    1/r_y))."""
    r_x = RADIUS**2 / CLEARANCE
    r_y = r_x if spherical else RADIUS
    e = 1 - 1e-7
    L = width(physics, spherical, e)
    # of the line load, only the part close to the wall counts; in a cylinder, L is fitted with
    # 1 + 3c/R instead of 1 + c/R, which is 5 % here
    near = OIL * RADIUS * L**3 * np.sqrt(2) * 3 * np.pi / 8 * (1 - e) ** -2.5 / CLEARANCE**3
    expected = 12 * np.pi * OIL * np.sqrt(r_x * r_y) / (1 / r_x + 1 / r_y)
    assert near * CLEARANCE * (1 - e) == pytest.approx(expected, rel=2e-2 if spherical else 6e-2)
