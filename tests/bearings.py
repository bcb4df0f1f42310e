# SPDX-License-Identifier: GPL-2.0-or-later
"""Provide the bearing of the paper to the tests of theory and runs."""

from raceway.theory.bearing import Bearing

B6208 = Bearing(
    balls=9,
    ball_diameter=12.6e-3,
    inner_radius=24e-3,
    outer_radius=36.6e-3,
    inner_groove=6.552e-3,
    outer_groove=6.552e-3,
)
