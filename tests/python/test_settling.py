# SPDX-License-Identifier: GPL-2.0-or-later
"""Settling (settling.h) is computed as the change in the means from one half of the last samples to
the next."""

import numpy as np
import pytest
from raceway.core import library


def scene(halves=3, half=40, balls=7, drift=0.0, turn=0.0, seed=1):
    """Return the samples of `halves` ball passes, with a ripple at the ball pass frequency. From
    each pass to the next, torque and loads grow by `drift`, and the spin axes pitch by `turn`
    (rad)."""
    numbers = np.random.default_rng(seed)
    n = np.arange(halves * half)
    growth = (1 + drift) ** (n // half)
    ripple = 1 + 0.2 * np.cos(2 * np.pi * n / half + 1.0)
    azimuth = 2 * np.pi * (np.arange(balls) + n[:, None] / half) / balls
    pitch = 0.3 + turn * (n // half)[:, None] + 0 * azimuth
    load = 100 * ripple[:, None] * (1.5 + np.cos(azimuth))
    radial, axial = np.sin(pitch), np.cos(pitch)
    spin = np.stack([radial * np.cos(azimuth), radial * np.sin(azimuth), axial], axis=-1)
    spin *= numbers.uniform(10, 1000, (len(n), balls, 1))
    place = np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth + 0.1], axis=-1)
    return dict(
        samples=len(n),
        balls=balls,
        half=half,
        torque=0.01 * ripple * growth,
        load=1e3 * np.stack([ripple * growth, ripple * growth**0.5], axis=-1),
        cage_speed=30 * ripple * growth**2,
        ball_load=load,
        place=0.03 * place,
        spin=spin,
    )


def test_a_settled_bearing_with_ripple_does_not_change():
    found = library().call("settling", **scene())
    assert max(vars(found).values()) < 1e-12


@pytest.mark.parametrize("drift", [-0.02, 1e-3, 0.3])
def test_changes_are_those_of_the_last_two_halves(drift):
    found = library().call("settling", **scene(drift=drift, turn=0.01))
    assert found.torque == pytest.approx(abs(drift) / (1 + drift), rel=1e-9)
    # the larger of the two changes
    assert found.load == pytest.approx(abs(drift) / (1 + drift), rel=1e-9)
    assert found.cage_speed == pytest.approx(abs(1 - (1 + drift) ** -2), rel=1e-9)
    assert found.spin_axis == pytest.approx(2 * np.sin(0.005), rel=1e-9)


def test_one_half_does_not_say():
    assert np.isinf(library().call("settling", **scene(halves=1)).torque)
