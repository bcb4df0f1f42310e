# SPDX-License-Identifier: GPL-2.0-or-later
"""Interference fits are compared with Lame's equation, solved for both tubes simultaneously."""

import math

import numpy as np
import pytest
from raceway import fits
from raceway.theory.fits import STEEL, Material

CAST_IRON, BRASS = Material(110e9, 0.25), Material(100e9, 0.34)


def shrink_fit(radii, inner, outer, interference):
    """Return the radial displacements at the first and the last of three radii, for two tubes with
    a radial `interference` at the middle radius. In each tube u = A r + B/r, and four conditions
    determine the constants."""
    first, middle, last = radii

    def stress(r, material):
        """Return the coefficients of A and B in the radial stress under plane stress."""
        plane = material.young / (1 - material.poisson**2)
        return plane * np.array([1 + material.poisson, -(1 - material.poisson) / r**2])

    none = np.zeros(2)
    rows = [
        np.r_[stress(first, inner) if first else [0.0, 1.0], none],
        np.r_[stress(middle, inner), -stress(middle, outer)],
        np.r_[-middle, -1 / middle, middle, 1 / middle],
        np.r_[none, stress(last, outer)],
    ]
    a, b, c, d = np.linalg.solve(rows, [0.0, 0.0, interference, 0.0])
    return a * first + (b / first if first else 0.0), c * last + d / last


@pytest.mark.parametrize("hollow", [0.0, 22e-3])
@pytest.mark.parametrize("material", [STEEL, BRASS])
def test_shaft(bearing, hollow, material):
    ring = Material(bearing.young, bearing.poisson)
    _, moved = shrink_fit((hollow / 2, 20e-3, bearing.inner_radius), material, ring, 1e-6)
    found = fits.clearance_change(
        bearing, 40e-3, 80e-3, shaft=2e-6, shaft_bore=hollow, shaft_material=material
    )
    assert found == pytest.approx(-2 * moved, rel=1e-9)


@pytest.mark.parametrize("outside", [110e-3, 0.5])
@pytest.mark.parametrize("material", [STEEL, CAST_IRON])
def test_housing(bearing, outside, material):
    ring = Material(bearing.young, bearing.poisson)
    moved, _ = shrink_fit((bearing.outer_radius, 40e-3, outside / 2), ring, material, 1e-6)
    found = fits.clearance_change(
        bearing, 40e-3, 80e-3, housing=2e-6, housing_outside=outside, housing_material=material
    )
    assert found == pytest.approx(2 * moved, rel=1e-9)
    assert found < 0


def test_same_steel(bearing):
    """If a solid shaft and an infinite housing are made of the same steel as the rings, only the
    ratio of the diameters matters."""
    ring = Material(bearing.young, bearing.poisson)
    same = {"shaft_material": ring, "housing_material": ring}
    both = fits.clearance_change(bearing, 40e-3, 80e-3, 8e-6, 5e-6, **same)
    expected = -8e-6 * 40 / (2e3 * bearing.inner_radius) - 5e-6 * 2e3 * bearing.outer_radius / 80
    assert both == pytest.approx(expected, rel=1e-12)


def test_loose_fits_change_nothing(bearing):
    assert fits.clearance_change(bearing, 40e-3, 80e-3, -5e-6, 0.0) == 0


def test_errors(bearing):
    for wrong in ({"bore": 50e-3}, {"outside": 70e-3}, {"shaft_bore": 40e-3}):
        with pytest.raises(ValueError, match="must increase"):
            fits.clearance_change(bearing, **{"bore": 40e-3, "outside": 80e-3, **wrong})
    with pytest.raises(ValueError, match="must increase"):
        fits.clearance_change(bearing, 40e-3, math.nan)
