# SPDX-License-Identifier: GPL-2.0-or-later
"""Free contact angle, endplay and load parameter are compared with geometric relations."""

import dataclasses

import numpy as np
import pytest
from raceway import clearance


@pytest.mark.parametrize("groove", [6.804e-3, 6.93e-3, 7.056e-3, 7.182e-3])  # table A.1
def test_free_angle_and_endplay_close_the_triangle(bearing, groove):
    """The line between the groove centres has the length C. Its radial component is C minus half
    the clearance, and its axial component is half the endplay."""
    open_groove = dataclasses.replace(bearing, inner_groove=groove, outer_groove=groove)
    c, pd = clearance.groove_distance(open_groove), 60e-6
    assert c / open_groove.ball_diameter == pytest.approx(2 * groove / 12.6e-3 - 1, rel=1e-12)
    half = clearance.free_endplay(open_groove, pd) / 2
    assert np.hypot(c - pd / 2, half) == pytest.approx(c, rel=1e-14)
    assert np.arctan2(half, c - pd / 2) == pytest.approx(
        clearance.free_contact_angle(open_groove, pd), rel=1e-9
    )


def test_no_clearance_no_play(bearing):
    assert clearance.free_endplay(bearing, 0.0) == 0


@pytest.mark.parametrize("value", [-1e-6, 2e-3])
def test_clearance_outside_the_grooves(bearing, value):
    with pytest.raises(ValueError, match="clearance"):
        clearance.free_contact_angle(bearing, value)


def test_load_parameter():
    assert clearance.load_parameter(0.0, 3e-5) == 0.5
    assert clearance.load_parameter(20e-6, 40e-6) == pytest.approx(0.375)
    with pytest.raises(ValueError, match="not moved"):
        clearance.load_parameter(20e-6, 0.0)
