# SPDX-License-Identifier: GPL-2.0-or-later
"""Properties of oils as functions of temperature and pressure are compared with published values
and with the values in the deck, and their slopes are compared with finite differences."""

import mpmath
import numpy as np
import pytest
from host import ROOT
from raceway import inputs, lubricant
from references import friction

OILS = ROOT / "inputs/lubricants"
PHYSICAL = ["vg32", "vg46", "vg68", "vg100", "pao8", "grease110"]
TEMPERATURES = [-20.0, 40.0, 70.0, 115.0]


def test_walther_passes_through_its_points():
    law = lubricant.Walther(46.0, 7.04)
    found, _ = law.viscosity(np.array([40.0, 100.0]), None)
    assert found == pytest.approx([46.0, 7.04], rel=1e-13)


@pytest.mark.parametrize("warm", [-20.0, 40.0, 55.0, 70.0, 115.0])
def test_walther_against_high_precision(warm):
    with mpmath.workdps(40):

        def twice(nu):
            return mpmath.log10(mpmath.log10(mpmath.mpf(nu) + mpmath.mpf("0.7")))

        def nu(t):
            kelvin = [mpmath.mpf(one) + mpmath.mpf("273.15") for one in (40, 100, t)]
            logs = [mpmath.log10(one) for one in kelvin]
            steep = (twice("46") - twice("7.04")) / (logs[1] - logs[0])
            return 10 ** (10 ** (twice("46") - steep * (logs[2] - logs[0]))) - mpmath.mpf("0.7")

        slope = -mpmath.diff(lambda t: mpmath.log(nu(t)), mpmath.mpf(warm))
        expected = float(nu(warm)), float(slope)
    assert lubricant.Walther(46.0, 7.04).viscosity(warm, None) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("pressure", [0.0, 1e7, 5e8, 2.5e9])
def test_roelands_against_high_precision(pressure):
    exact = float(friction.roelands(0.04, 22e-9, pressure))
    assert lubricant.roelands(0.04, 22e-9, pressure) == pytest.approx(exact, rel=1e-13)


@pytest.mark.parametrize(("name", "seventy"), [("vg32", 11.1), ("vg46", 15.2), ("vg68", 20.1)])
def test_grades_at_seventy(name, seventy):
    found = inputs.fluid(OILS / name, 70.0)
    assert found.kinematic == pytest.approx(seventy, abs=0.05)


@pytest.mark.parametrize(
    ("name", "cold", "density"), [("vg32", 27.97, 874), ("vg46", 39.69, 863), ("vg68", 57.07, 867)]
)
def test_grades_at_forty(name, cold, density):
    found = inputs.fluid(OILS / name)
    assert found.temperature == 40 and found.density == pytest.approx(density, abs=0.5)
    assert 1e3 * found.viscosity == pytest.approx(cold, abs=0.005)


@pytest.mark.parametrize("name", PHYSICAL)
def test_grade_limits(name):  # ISO 3448 allows 10 % at 40 C
    number = {"pao8": 46, "grease110": 100}.get(name) or float(name[2:])
    assert inputs.fluid(OILS / name).kinematic == pytest.approx(number, rel=0.1001)


def test_fva3():
    found = inputs.fluid(OILS / "vg100", np.array([40.0, 60.0, 80.0, 100.0]))
    assert 1e3 * found.viscosity == pytest.approx([84.54, 34.59, 17.24, 9.86], abs=0.005)
    assert 1e9 * found.pressure_viscosity == pytest.approx([22.36, 19.73, 17.65, 15.96], abs=0.005)
    expected = [0.0510, 0.0391, 0.0310, 0.0252]
    assert found.temperature_viscosity == pytest.approx(expected, abs=0.00005)
    assert found.density == pytest.approx([872.6, 860.6, 848.6, 836.6], rel=1e-14)
    # table A1 of Schwarz et al. 2023: the viscosity, and its slope with pressure (in bar) at p = 0
    exact = 0.062e-3 * np.exp(1021.7 / (found.temperature + 101.5517))
    assert found.viscosity == pytest.approx(exact, rel=1e-13)
    slope = 1e-5 / (327.7918 + 2.9862 * found.temperature)
    assert found.pressure_viscosity == pytest.approx(slope, rel=1e-6)


@pytest.mark.parametrize("name", PHYSICAL)
def test_slope_with_temperature(name):
    oil = inputs.lubricant(OILS / name)
    for warm in TEMPERATURES:
        up, down = oil.at(warm + 1e-3).viscosity, oil.at(warm - 1e-3).viscosity
        expected = -np.log(up / down) / 2e-3
        assert oil.at(warm).temperature_viscosity == pytest.approx(expected, rel=1e-8)


def test_permittivity_follows_the_density():
    cold, hot = (inputs.fluid(OILS / "vg46", warm) for warm in (40.0, 100.0))
    assert cold.permittivity == pytest.approx(2.25, rel=1e-14)

    def mossotti(one):
        return (one.permittivity - 1) / (one.permittivity + 2) / one.density

    assert mossotti(hot) == pytest.approx(mossotti(cold), rel=1e-13)


def test_outside_its_range():
    with pytest.raises(inputs.InputError, match="temperature = 250.0 C must lie from -40 to 200"):
        inputs.fluid(OILS / "vg46", 250.0)
    with pytest.raises(inputs.InputError, match="mineral has values for 40 C only, not for 70"):
        inputs.oil(OILS / "mineral", 70.0)
    with pytest.raises(ValueError, match="must fall and stay above 0.3"):
        lubricant.Walther(7.0, 46.0)


def test_outright_goes_before_physical(tmp_path):
    path = tmp_path / "oil"
    path.write_text((OILS / "vg46").read_text() + "variable viscosity index 0.05\n")
    found = inputs.fluid(path, 70.0)
    assert found.viscosity == 0.05
    assert found.pressure_viscosity == inputs.fluid(OILS / "vg46", 70.0).pressure_viscosity


@pytest.mark.parametrize("name", [*PHYSICAL, "mineral", "pao48"])
def test_every_value_has_its_source(name):
    lines = (OILS / name).read_text().splitlines()
    numbers = [line for line in lines if line.startswith("variable") and "index film" not in line]
    bare = {line.split()[1] for line in numbers if not line.partition("#")[2].strip()}
    assert len(numbers) > 10 and bare <= {"ball_roughness"}
