# SPDX-License-Identifier: GPL-2.0-or-later
"""Bearing frequencies and entrainment speeds are compared with rolling without slip."""

import numpy as np
import pytest
from raceway import kinematics


def test_every_ball_passes_both_rings(bearing):
    order = kinematics.frequencies(bearing, np.radians(25))
    assert order.outer + order.inner == pytest.approx(bearing.balls, rel=1e-14)
    assert order.outer == pytest.approx(bearing.balls * order.cage, rel=1e-14)


def test_entrainment_from_the_surfaces(bearing):
    """Relative to the contact, both surfaces at each raceway move at (ring - cage) times the radius
    of the raceway."""
    spin = 50.0
    cage = spin * kinematics.frequencies(bearing).cage
    speed = kinematics.entrainment(bearing, spin)
    assert speed == pytest.approx((spin - cage) * bearing.inner_radius, rel=1e-13)
    assert speed == pytest.approx(cage * bearing.outer_radius, rel=1e-13)
    for rpm, expected in ((477.5, 0.725), (270.0, 0.41)):  # docs/errata
        found = kinematics.entrainment(bearing, rpm * np.pi / 30)
        assert found == pytest.approx(expected, abs=5e-4)
    assert kinematics.entrainment(bearing, -spin) == speed
