# SPDX-License-Identifier: GPL-2.0-or-later
"""The load fraction carried by asperities is compared with published values and with integrals over
a normal distribution."""

import numpy as np
import pytest
from raceway import asperity
from scipy.integrate import quad
from scipy.stats import norm


def test_zhou_hoeprich():
    found = asperity.zhou_hoeprich(np.array([0.3, 1.0, 2.0, 3.0]))
    for value, expected, half in zip(
        found, [0.47015, 0.12246, 0.022703, 0.0047823], [5e-6, 5e-6, 5e-7, 5e-8]
    ):
        assert value == pytest.approx(expected, abs=half)
    assert asperity.ZHOU_HOEPRICH[1e-7] == (2.1, 0.85)


def test_spread_of_the_laws():
    ratio = np.array([0.30, 1.41])
    assert asperity.olver_spikes(ratio) == pytest.approx([0.59, 0.17], abs=0.005)
    assert asperity.clarke(ratio) == pytest.approx([0.67, 0.05], abs=0.005)


@pytest.mark.parametrize("law", [asperity.zhou_hoeprich, asperity.olver_spikes, asperity.clarke])
def test_all_of_the_load_at_zero_none_far_off(law):
    assert law(0.0) == pytest.approx(1, abs=2e-7) and 0 < law(5.0) < 0.03
    assert np.all(np.diff(law(np.linspace(0, 5, 100))) < 0)


def test_overlap_integral():
    ratio = np.array([0.0, 1.0, 2.0, 3.0])
    found = asperity.overlap_integral(ratio)
    for value, expected, half in zip(
        found, [0.616634, 0.0805623, 0.00542371, 1.70873e-4], [5e-7, 5e-8, 5e-9, 5e-10]
    ):
        assert value == pytest.approx(expected, abs=half)
    for order in (2, 2.5):
        for gap, value in zip(ratio, asperity.overlap_integral(ratio, order)):
            mean = quad(lambda s, g=gap, n=order: (s - g) ** n * norm.pdf(s), gap, 12)[0]
            assert value == pytest.approx(mean, rel=1e-7)


def test_fits():
    ratio = np.linspace(0, 4, 401)
    for fit, order, worst in ((asperity.five_halves, 2.5, 0.0042), (asperity.two, 2, 0.0048)):
        error = np.abs(fit(ratio) / asperity.overlap_integral(ratio, order) - 1).max()
        assert error == pytest.approx(worst, abs=5e-5)


def test_greenwood_tripp(bearing):
    low = asperity.greenwood_tripp(0.0, bearing.effective_modulus, 0.03, 1e-3)
    high = asperity.greenwood_tripp(0.0, bearing.effective_modulus, 0.05, 1e-2)
    assert (1e-6 * low, 1e-6 * high) == pytest.approx((10, 84), abs=0.5)
