# SPDX-License-Identifier: GPL-2.0-or-later
"""The changes between the last two ball passes of a run, and those that remain, estimated from the
means over its ball passes (settling.h, settling_rest.h)."""

import numpy as np
import pytest
from raceway.core import library


def scene(passes=2, samples=40, balls=7, drift=0.0, turn=0.0, seed=1):
    """Return the samples of `passes` ball passes, with a ripple at the ball pass frequency. From
    each pass to the next, torque and loads grow by `drift`, and the spin axes pitch by `turn`
    (rad)."""
    numbers = np.random.default_rng(seed)
    n = np.arange(passes * samples)
    growth = (1 + drift) ** (n // samples)
    ripple = 1 + 0.2 * np.cos(2 * np.pi * n / samples + 1.0)
    azimuth = 2 * np.pi * (np.arange(balls) + n[:, None] / samples) / balls
    pitch = 0.3 + turn * (n // samples)[:, None] + 0 * azimuth
    load = 100 * ripple[:, None] * (1.5 + np.cos(azimuth))
    radial, axial = np.sin(pitch), np.cos(pitch)
    spin = np.stack([radial * np.cos(azimuth), radial * np.sin(azimuth), axial], axis=-1)
    spin *= numbers.uniform(10, 1000, (len(n), balls, 1))
    place = np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth + 0.1], axis=-1)
    return dict(
        passes=passes,
        samples=samples,
        balls=balls,
        torque=0.01 * ripple * growth,
        load=1e3 * np.stack([ripple * growth, ripple * growth**0.5], axis=-1),
        cage_speed=30 * ripple * growth**2,
        cage_orbit=0.5 * ripple * growth,
        ball_load=load,
        place=0.03 * place,
        spin=spin,
    )


def test_a_settled_bearing_with_ripple_does_not_change():
    for passes in (2, 3, 8):
        found = library().call("settling", **scene(passes))
        assert max(vars(found).values()) < 1e-12


@pytest.mark.parametrize("drift", [-0.02, 1e-3, 0.3])
def test_the_change_between_two_ball_passes_is_taken_to_remain(drift):
    found = library().call("settling", **scene(drift=drift, turn=0.01))
    for kind in ("", "remaining_"):
        change = {name: getattr(found, kind + name) for name in ("torque", "load", "cage_speed")}
        assert change["torque"] == pytest.approx(abs(drift) / (1 + drift), rel=1e-9)
        # the larger of the two changes
        assert change["load"] == pytest.approx(abs(drift) / (1 + drift), rel=1e-9)
        assert change["cage_speed"] == pytest.approx(abs(1 - (1 + drift) ** -2), rel=1e-9)
        axis = getattr(found, kind + "spin_axis")
        assert axis == pytest.approx(2 * np.sin(0.005), rel=1e-9)
    assert found.cage_orbit == pytest.approx(0.5 * abs(drift), rel=1e-9)  # not relative
