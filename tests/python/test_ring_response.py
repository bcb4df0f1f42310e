# SPDX-License-Identifier: GPL-2.0-or-later
"""The response of a ring to small motions is compared with the closed-form solution for springs and
dampers in series. Damping laws and the mean over a ball pass are tested too."""

import numpy as np
import pytest
from bearings import B6208
from commands import answer
from raceway import film_damping, lubrication, ring_response, small_motion, static
from raceway.inputs import Oil
from raceway.theory.lubricant import Fluid

OIL = Oil(viscosity=0.04, pressure_viscosity=22e-9, permittivity=2.25, roughness=1e-7)
SPIN = 300.0  # rad/s
MASS = 8.17e-3  # kg, mass of a ball


@pytest.fixture(scope="module")
def radial():
    return static.equilibrium(B6208, 3000.0)


@pytest.fixture(scope="module")
def combined():
    return static.equilibrium(B6208, 1500.0, 2500.0, clearance=20e-6)


def test_without_dampers_it_is_the_stiffness(combined):
    found = small_motion.response(combined.linear, 0.0, 100.0)
    assert found.stiffness == pytest.approx(combined.stiffness, rel=1e-9, abs=1e-6)
    assert np.all(found.damping == 0)


@pytest.mark.parametrize("frequency, mass", [(0.0, 0.0), (2000.0, 0.0), (20000.0, MASS)])
def test_springs_and_dampers_in_series(radial, frequency, mass):
    """Under a radial load, the balls move along their radii, with a spring and a damper on each
    side."""
    c = np.array([800.0, 300.0])
    found = small_motion.response(
        radial.linear, np.broadcast_to(c[:, None], (2, 9)), frequency, ball_mass=mass
    )
    rate = max(frequency, 1e-3)
    live = radial.inner.load > 0
    inner, outer = radial.linear.along[:, live] + 1j * rate * c[:, None]
    line = inner - inner**2 / (inner + outer - mass * frequency**2)
    whole = (line * np.cos(radial.azimuth[live]) ** 2).sum()
    assert found.stiffness[0, 0] == pytest.approx(whole.real, rel=1e-9)
    assert found.damping[0, 0] == pytest.approx(whole.imag / rate, rel=1e-6)


def test_two_branches_of_the_law(combined):
    films = lubrication.lubricate(B6208, combined, OIL, SPIN, 20e-6)
    paper = ring_response.dampers(B6208, combined, films, OIL, "paper", clearance=20e-6)
    top = int(np.argmax(combined.inner.load))
    load, a, h = combined.inner.load[top], combined.inner.a[top], films.inner.h_min[top]
    want = 0.12 * load + 3 * np.pi * 0.04 * a / np.sqrt(2) * (6.3e-3 / max(h, 1e-7)) ** 1.5
    assert paper.damping[0, top] == pytest.approx(want, rel=1e-9)
    assert np.all(paper.stiffening == 0) and np.all(paper.damping > 0)

    k, elastic = combined.linear.along[0, top], combined.inner.overlap[top]
    one = film_damping.branch(
        k, films.inner.h_c[top], elastic, combined.inner.b[top], films.inner.entrainment[top]
    )
    for turn in (0.0, 1.0):
        full = ring_response.dampers(
            B6208, combined, films, OIL, "full", clearance=20e-6, frequency=turn / one.time
        )
        want = 0.12 * load + one.stiffness * one.time / (1 + turn)
        assert full.damping[0, top] == pytest.approx(want, rel=1e-6)
        assert full.stiffening[0, top] == pytest.approx(one.stiffness * turn / 2, rel=1e-6)
    with pytest.raises(ValueError, match="models 'dry' is not one of paper, full"):
        ring_response.dampers(B6208, combined, films, OIL, "dry")


def test_negative_numbers(radial):
    with pytest.raises(ValueError, match="dampers, of which the smallest is -1 N s/m"):
        small_motion.response(radial.linear, -1.0)
    with pytest.raises(ValueError, match="0 phases"):
        ring_response.over_pass(lambda phase: None, 9, 0)


MANY = 96  # positions in a ball pass
# loads in N, and options
PASSES = {
    "most of the balls": ((3000.0,), dict(clearance=10e-6, speed=SPIN)),
    "few balls": ((1000.0,), dict(clearance=10e-6, speed=SPIN)),
    "two balls": ((300.0,), dict(clearance=40e-6)),
    "free tilts": ((3000.0, 500.0), dict(clearance=10e-6, moment=(0.0, 0.0))),
    "film": ((3000.0,), dict(speed=SPIN, oil=OIL, models="paper", frequency=SPIN)),
    "not symmetric": ((2000.0, 300.0), dict(held={"rx": 3e-4, "ry": 1e-4}, clearance=10e-6)),
}


@pytest.mark.parametrize("name", PASSES)
def test_over_a_ball_pass(name, monkeypatch):
    """The reference for mean and extremes solves many positions of the balls, then, around each
    extreme, positions that are closer and closer together."""
    loads, options = PASSES[name]
    found = ring_response.turning_ring(B6208, *loads, **options)
    monkeypatch.setattr(ring_response, "over_pass", lambda at, *_, **__: at)
    at = ring_response.turning_ring(B6208, *loads, **options)

    def diagonals(one):
        return np.concatenate([np.diag(matrix) for matrix in one])

    spacing = 2 * np.pi / B6208.balls
    where = np.linspace(0, spacing, MANY, endpoint=False)
    each = np.array([diagonals(at(one)[0]) for one in where])
    mean, least, most = (how(each, axis=0) for how in (np.mean, np.min, np.max))
    for width in (MANY, 8 * MANY, 64 * MANY):
        ends = where[np.unique([each.argmin(0), each.argmax(0)])]
        where = (ends[:, None] + spacing / width * np.linspace(-1, 1, 17)).ravel()
        each = np.array([diagonals(at(one)[0]) for one in where])
        least, most = np.minimum(least, each.min(0)), np.maximum(most, each.max(0))
    for one, want in zip(found, (mean, least, most)):
        assert np.all(np.abs(diagonals(one) - want) <= 2e-3 * most)


def test_full_needs_the_fluid():
    with pytest.raises(ValueError, match="models full need the fluid"):
        ring_response.turning_ring(B6208, 3000.0, speed=SPIN, oil=OIL, models="full")
    assert "viscosity" in Fluid._fields


def test_static_prints_it(capsys):
    """The --json output includes the damping matrix for a bearing at standstill, which is null
    without a film."""
    shape = "static --load 1500 --axial 2500 --clearance 20e-6"
    found = answer(capsys, f"{shape} --rpm 1910 --lubricant mineral")
    matrix = np.array(found["damping"])
    assert matrix.shape == (5, 5) and np.all(np.diag(matrix) > 0)
    assert found["damping_x_N_s_m"] == matrix[0, 0]
    assert np.linalg.eigvalsh(matrix)[0] > -1e-12 * matrix.max()
    assert found["damping_law"] == ring_response.LAWS["full"]
    assert answer(capsys, shape)["damping"] is None
