# SPDX-License-Identifier: GPL-2.0-or-later
"""Stiffness and damping are recovered from known motions and forces."""

import types

import numpy as np
import pytest
import xarray as xr
from raceway import ring_fit
from raceway.errors import RunError

TIME = np.arange(2001) * 1e-5
RATES = 2 * np.pi * np.array([150.0, 250.0, 350.0])
PLACE = 1e-6 * np.sin(TIME[:, None] * RATES)
SPEED = 1e-6 * RATES * np.cos(TIME[:, None] * RATES)
STIFFNESS = np.array([[2e8, 1e5, -3e6], [-1e5, 1.5e8, 0.0], [-3e6, 0.0, 5e7]])
DAMPING = np.array([[700.0, 0.0, -10.0], [0.0, 500.0, 0.0], [-10.0, 0.0, 100.0]])
FORCE = 300.0 - PLACE @ STIFFNESS.T - SPEED @ DAMPING.T


def of_rings(force, time=TIME):
    """Return data with the layout that `of_run` reads from a run."""
    names = dict(x=PLACE[:, 0], y=PLACE[:, 1], z=PLACE[:, 2])
    names |= dict(zip(("fx", "fy", "fz"), force.T))
    data = {name: ("time", values) for name, values in names.items()}
    return types.SimpleNamespace(rings=xr.Dataset(data, coords={"time": time}))


def test_exact_data():
    found = ring_fit.fitted(PLACE, SPEED, FORCE)
    assert found.stiffness == pytest.approx(STIFFNESS, rel=1e-6, abs=1.0)
    assert found.damping == pytest.approx(DAMPING, rel=1e-6, abs=1e-4)
    assert np.all(found.left < 1e-8)


def test_errors_are_those_of_the_noise():
    """Deviations due to noise are about as large as the standard errors, and never more than four
    times as large."""
    force = FORCE + np.random.default_rng(1).normal(size=FORCE.shape)
    found = ring_fit.fitted(PLACE, SPEED, force)
    off = np.abs(found.damping - DAMPING) / found.damping_error
    assert np.all(off < 4) and off.mean() > 0.2
    assert np.all(np.abs(found.stiffness - STIFFNESS) < 4 * found.stiffness_error)
    changes = FORCE - FORCE.mean(0)
    assert found.left == pytest.approx(1 / changes.std(0), rel=0.1)


def test_of_a_run():
    """Velocities are computed from positions, and a force at the ball pass frequency is fitted
    too."""
    passing = 2 * np.pi * 178.2
    force = FORCE + 20.0 * np.cos(passing * TIME + 0.3)[:, None]
    found = ring_fit.of_run(of_rings(force), ("x", "y", "z"), since=1e-4, lines=[passing])
    assert found.stiffness == pytest.approx(STIFFNESS, rel=1e-5, abs=500.0)
    assert found.damping == pytest.approx(DAMPING, rel=1e-4, abs=0.1)
    without = ring_fit.of_run(of_rings(force), ("x", "y", "z"))
    assert without.left.max() > 10 * found.left.max()


def test_what_cannot_be_fitted():
    with pytest.raises(ValueError, match="not independent"):
        ring_fit.fitted(PLACE[:, [0, 0]], SPEED[:, [0, 0]], FORCE[:, :2])
    with pytest.raises(ValueError, match="motion 1 of 4 is constant"):
        ring_fit.fitted(PLACE[:, :2] * [1, 0], SPEED[:, :2], FORCE[:, :2])
    with pytest.raises(ValueError, match="10 samples are too few for 6 motions"):
        ring_fit.fitted(PLACE[:10], SPEED[:10], FORCE[:10])
    with pytest.raises(ValueError, match="must agree"):
        ring_fit.fitted(PLACE, SPEED[:-1], FORCE)
    with pytest.raises(RunError, match="'tilt' is not one of x, y, z, rx, ry"):
        ring_fit.of_run(of_rings(FORCE), ("tilt",))
    with pytest.raises(RunError, match="evenly spaced"):
        ring_fit.of_run(of_rings(FORCE, TIME**1.1), ("x",))
