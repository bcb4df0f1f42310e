# SPDX-License-Identifier: GPL-2.0-or-later
"""For balls that touch only the outer ring, unloaded times are tested, and the rotation is compared
with closed-form solutions."""

import numpy as np
import pytest
from raceway.theory import skidding

AZIMUTH = 0.1 + np.arange(9) * 2 * np.pi / 9
LOADED = np.array([1, 1, 1, 0, 0, 0, 0, 1, 1], bool)
ROW = np.zeros(9)
STEP = 2 * np.pi / 9 / 20.0


def times(loaded=LOADED, azimuth=AZIMUTH, row=ROW, orbit=20.0):
    return np.array(skidding.unloaded(loaded, azimuth, row, orbit, 0.03))


def test_times_without_load():
    speed, since, until, frequency = times()
    assert speed == pytest.approx(0.6 * ~LOADED)
    assert since / STEP == pytest.approx([0, 0, 0, 0.5, 1.5, 2.5, 3.5, 0, 0])
    assert until / STEP == pytest.approx([0, 0, 0, 0, 0, 0, 4, 0, 0])
    assert frequency * STEP == pytest.approx([0, 0, 0, 0, 0, 0, 1, 0, 0])


def test_turned_mirrored_and_two_rows():
    once = times()
    np.testing.assert_allclose(times(np.roll(LOADED, 4)), np.roll(once, 4, axis=1))
    np.testing.assert_allclose(times(azimuth=-AZIMUTH, orbit=-20.0), once)
    both = times(np.tile(LOADED, 2), np.tile(AZIMUTH, 2), np.repeat([0, 1], 9))
    np.testing.assert_allclose(both, np.tile(once, 2))
    assert np.all(times(np.zeros(9, bool))[1] == np.inf)
    assert not times(np.ones(9, bool)).any()


def test_rotation():
    """The cases are a constant excess moment, a moment that decreases until the rotation is steady,
    and sufficient traction."""
    time, rate = np.array([0.0, 0.3, 1.0, 9.0, np.inf]), np.full(5, 2.0)
    found = skidding.rotation(lambda x: 0.2 + 0 * x, rate, time)
    assert found == pytest.approx(np.clip(1 - 0.4 * time, 0, 1), abs=1e-12)
    found = skidding.rotation(lambda x: x - 0.4, rate, time)
    assert found == pytest.approx(0.4 + 0.6 * np.exp(-2 * time), abs=2e-3)
    assert np.all(skidding.rotation(lambda x: x - 1.1, rate, time) == 1)
