# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the theory behind the paper's figures: loads, films, capacitance and the change of
regime."""

import numpy as np
import pytest
from raceway import capacitance, distribution, film, hertz
from raceway.inputs import Oil
from raceway.paper import passage, theory
from raceway.theory.bearing import INNER, OUTER

OIL = Oil(0.040, 22e-9, 2.25, 1e-7)
SPEED = 0.725


@pytest.mark.parametrize("printed", [False, True])
def test_contact_is_the_formulas(bearing, printed):
    load = np.array([2436.2, 0.0, 176.3])
    found = theory.contact(bearing, OIL, OUTER, load, SPEED, printed=printed)
    r_x, r_y = bearing.effective_radii(OUTER)
    shape = hertz.hamrock_brewe(r_x, r_y, printed=True) if printed else hertz.exact(r_x, r_y)
    for at in (0, 2):
        a, b = hertz.semi_axes(shape, bearing.effective_modulus, load[at])
        group = film.group(
            0.040, 22e-9, bearing.effective_modulus, r_x, shape.kappa, SPEED, load[at]
        )
        h_c = film.h_c(r_x, group, printed=printed)
        value = capacitance.contact(2.25, 1.5 * load[at] / (np.pi * a * b), a, b, h_c)
        assert found.capacitance[at] == pytest.approx(value, rel=1e-13)
        assert found.h_min[at] == pytest.approx(film.h_min(r_x, group), rel=1e-13)
    assert found.capacitance[1] == 0 and np.isnan(found.h_c[1])
    assert found.pressure[0] == pytest.approx(
        hertz.pressure(shape, bearing.effective_modulus, 2436.2), rel=1e-12
    )


def test_loads_balance_the_ring(bearing):
    psi, load, _ = theory.loads(bearing, 5000.0)
    assert psi.shape == load.shape == (theory.PHASES, bearing.balls)
    # 0.1 %, because the contact normals deviate slightly from the radial direction when the ring is
    # displaced
    assert (load * np.cos(np.radians(psi))).sum(1) == pytest.approx(5000.0, rel=1e-3)
    # Harris's value, which does not include the effect of finite shift
    assert theory.largest_load(bearing, 5000.0) == pytest.approx(2436.2, rel=1e-3)


def test_mean_shift_is_stribecks(bearing):
    # 1 % is the difference between nine balls and a continuous load distribution
    assert theory.loads(bearing, 5000.0, 44.1e-6)[2] == pytest.approx(
        distribution.shift(bearing, 5000.0, 44.1e-6), rel=1e-2
    )


def test_bearing_is_the_sum_of_balls(bearing):
    _, load, _ = theory.loads(bearing, 5000.0)
    sides = [theory.contact(bearing, OIL, side, load, SPEED).capacitance for side in (INNER, OUTER)]
    assert theory.bearing_capacitance(bearing, OIL, 5000.0, SPEED) == pytest.approx(
        capacitance.bearing(*sides).mean(), rel=1e-13
    )


def test_speed_of_a_film(bearing):
    at = passage.speed(bearing, OIL, 5000.0, 123e-9)
    found = theory.contact(bearing, OIL, INNER, theory.largest_load(bearing, 5000.0), at).h_min
    # the exponent of the speed follows from the logarithms of two values
    assert found == pytest.approx(123e-9, rel=1e-9)


@pytest.mark.parametrize("whole", [True, False])
@pytest.mark.parametrize("printed", [False, True])
def test_roughness_of_a_capacitance(bearing, whole, printed):
    needed = passage.roughness(bearing, OIL, 5000.0, 60e-12, whole, printed)
    assert passage.capacitance(bearing, OIL, 5000.0, needed, whole, printed) == pytest.approx(
        60e-12, rel=1e-7
    )
