# SPDX-License-Identifier: GPL-2.0-or-later
"""Elliptical contacts of arrays, without load, and between conformal surfaces; the tests in
tests/physics compare the laws with theory."""

import numpy as np
import pytest
from raceway import hertz


def test_arrays_equal_numbers():
    ratios = np.array([0.5, 1.0, 20.0, 33.0])
    assert np.array_equal(hertz.ellipticity(ratios), [hertz.ellipticity(ratio) for ratio in ratios])


def test_no_load():
    assert hertz.pressure(hertz.exact(5e-3, 0.16), 2e11, 0.0) == 0
    assert hertz.load(3e10, np.array([-1e-6, 0.0])).tolist() == [0, 0]


def test_conformal_is_an_error():
    with pytest.raises(ValueError, match="conformal"):
        hertz.exact(1.0, -1.0)
    with pytest.raises(ValueError, match="at least 1"):
        hertz.hamrock_brewe(2.0, 1.0)
