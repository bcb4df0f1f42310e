# SPDX-License-Identifier: GPL-2.0-or-later
"""SI prefixes."""

import pytest
from raceway.units import axis, prefixed


@pytest.mark.parametrize(
    "value, unit, shown",
    [
        (2.5713e9, "Pa", "2.571 GPa"),
        (34.87e-6, "m", "34.87 µm"),
        (1.06e-10, "F", "106 pF"),
        (999.99, "N", "1 kN"),
        (1000, "N", "1 kN"),
        (-44.1e-6, "m", "-44.1 µm"),
        (1e-3, "m", "1 mm"),
        (0, "m", "0 m"),
        (938.0, "", "938"),
        (0.938, "", "0.938"),
        (1e-20, "F", "1e-20 F"),
    ],
)
def test_prefixed(value, unit, shown):
    assert prefixed(value, unit) == shown


def test_axis():
    assert axis(2436, "N") == (pytest.approx(1e-3), "kN")
    assert axis(0, "N") == (1, "N")
