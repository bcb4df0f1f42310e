# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of oil supply and asperities against quadrature and scipy: the fraction of the rolling
resistance that remains if the inlet is short, the oil around the balls, and the fraction of the
load that asperities carry in the models `full`."""

import numpy as np
import pytest
from raceway import asperity, inputs, oil_supply, rolling
from raceway.core import laws
from references import friction as reference
from scipy.integrate import quad

THICKNESS = np.geomspace(1e-3, 20.0, 12)


@pytest.mark.parametrize("length", [1.5, 3.0, 10.0, 50.0])
def test_share_of_a_short_inlet(length):
    exact = np.array([reference.inlet_share(length, one) for one in THICKNESS])
    # Simpson's rule with steps of 0.1 in ln(X - 1), and a lower limit of e^-14 for the integral
    assert laws.inlet_share(length, THICKNESS) == pytest.approx(exact, rel=1e-5)
    b, r_x = 0.2e-3, 5e-3
    fitted = rolling.inlet(length, THICKNESS * b**2 / (2 * r_x), b, r_x)
    assert fitted == pytest.approx(np.maximum(exact, 0.5), abs=7e-3)


@pytest.mark.parametrize("thickness", [0.01, 0.07, 0.4, 1.1])
def test_share_of_the_dissipated_power(thickness):
    """The integral leaves out both the viscosity's growth with pressure and the force behind the
    contact, which nearly cancel: the power dissipated in Grubin's inlet has the same fraction."""
    length = 3.0
    exact = reference.dissipated_inlet_share(length, thickness)
    assert laws.inlet_share(length, thickness) == pytest.approx(exact, abs=0.015)


def test_ends_of_the_inlet():
    assert np.all(rolling.inlet(0.0, THICKNESS, 1e-4, 5e-3) == 1.0)
    assert np.all(rolling.inlet(1.0, THICKNESS, 1e-4, 5e-3) == 0.5)
    assert laws.inlet_share(1e5, 0.1) == 1.0


def test_the_shortest_inlet_that_feeds_the_film_leaves_half():
    """With the meniscus of Hamrock and Dowson, the shortest inlet that still feeds the film leaves
    half of the rolling resistance, over the range of film thicknesses in bearings."""
    for thickness in (0.007, 0.07, 0.3, 1.0, 3.0, 18.0):
        length = 1 + 3.06 * (thickness / 2) ** 0.58
        assert 0.49 < reference.inlet_share(length, thickness) < 0.57


@pytest.mark.parametrize("gap", [12.0])
def test_the_inlet_of_a_point_contact(gap):
    """With a meniscus at 12 h_c, the force in the two-dimensional solution is the flooded force
    divided by 1.6 to 1.83 (our EHL solutions at 14.5 m/s, 300 and 100 N). The line-contact result
    agrees with these values within 12 %."""
    for thickness, known in ((1.248, 1.6), (2.793, 1.83)):
        x = np.linspace(1, 20, 200001)
        height = x * np.sqrt(x * x - 1) - np.arccosh(x)
        length = np.interp((gap - 1) * thickness, height, x)
        assert 1 / reference.inlet_share(length, thickness) == pytest.approx(known, rel=0.12)


@pytest.mark.parametrize("level", [0.1, 0.5, 1.0, 3.0, 5.5])
def test_immersed_balls(level):
    # the tested function uses 720 azimuths, the reference uses slices with a thickness of 1e-3
    pitch = 30.3 / 6.3
    assert laws.immersed_share(level, pitch) == pytest.approx(
        reference.immersed(level, pitch), abs=1e-3
    )


def test_a_bath_is_empty_or_full():
    assert laws.immersed_share(0.0, 5.0) == pytest.approx(0.0, abs=1e-6)
    assert laws.immersed_share(6.0, 5.0) == pytest.approx(1.0, abs=1e-15)


def test_kinds():
    body = inputs.bearing("6208")
    known = {kind: oil_supply.numbers(oil_supply.Supply(kind), body, 870.0)
             for kind in oil_supply.KINDS}  # fmt: skip
    assert known["bath"] == (3.0, 3e-8, pytest.approx(laws.immersed_share(0.5, 30.3 / 6.3)))
    assert known["jet"] == (3.0, 3e-8, pytest.approx(2 * known["bath"].share))
    for kind in ("mist", "grease", "minimal"):
        assert known[kind] == (1.0, 6e-8, pytest.approx(1.2 / 870))
    flooded = oil_supply.numbers(oil_supply.Supply("bath", 10.0), body, 870.0)
    assert flooded == (0.0, 0.0, 1.0)
    assert oil_supply.numbers(oil_supply.Supply("bath", 0.6), body, 870.0).replenishment == 0
    with pytest.raises(ValueError, match="not one of bath, jet"):
        oil_supply.numbers(oil_supply.Supply("spray"), body, 870.0)


def test_clarke_s_share():
    """Heights above the film thickness carry the load; they are normally distributed."""
    ratio = np.linspace(0.0, 6.0, 121)
    exact = [quad(lambda s: 2 / np.sqrt(np.pi) * np.exp(-s * s), one, np.inf)[0] for one in ratio]
    assert asperity.clarke(ratio) == pytest.approx(exact, abs=1.5e-7)
