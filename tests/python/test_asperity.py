# SPDX-License-Identifier: GPL-2.0-or-later
"""The load fraction carried by asperities is compared with published values and limits."""

import numpy as np
import pytest
from raceway import asperity


def test_spread_of_the_laws():
    ratio = np.array([0.30, 1.41])
    assert asperity.olver_spikes(ratio) == pytest.approx([0.59, 0.17], abs=0.005)
    assert asperity.clarke(ratio) == pytest.approx([0.67, 0.05], abs=0.005)


@pytest.mark.parametrize("law", [asperity.zhou_hoeprich, asperity.olver_spikes, asperity.clarke])
def test_all_of_the_load_at_zero_none_far_off(law):
    assert law(0.0) == pytest.approx(1, abs=2e-7) and 0 < law(5.0) < 0.03
    assert np.all(np.diff(law(np.linspace(0, 5, 100))) < 0)
