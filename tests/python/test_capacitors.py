# SPDX-License-Identifier: GPL-2.0-or-later
"""The capacitors of a whole bearing agree with published values and limits, and the transition when
contact is lost is tested."""

import numpy as np
import pytest
from raceway import capacitance, capacitors, film, hertz, kinematics, lubrication
from raceway.inputs import Oil
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.capacitors import Filling
from raceway.theory.validity import Shoulders

OIL = Oil(viscosity=0.03, pressure_viscosity=18e-9, permittivity=2.2, roughness=1e-7)
SHOULDERS = Shoulders(2 * 26.3e-3, 2 * 34.3e-3)  # m, for grooves that are 2.3 mm deep


def point(bearing, load, rpm, clearance, filling, **options):
    spin = rpm * np.pi / 30
    state, orbit = lubrication.turning(
        bearing, spin, float(load), clearance=clearance, ball_density=7850.0
    )
    quiet = capacitors.quiet_load(bearing, orbit)
    return quiet, capacitors.of_statics(
        bearing, state, OIL, spin, quiet, filling=filling, clearance=clearance, **options
    )


@pytest.fixture(scope="module")
def heavy(bearing):
    """Return the capacitors of a 6208 at 3 kN and 1500 rpm for each way to fill its gaps."""
    return {
        kind: point(bearing, 3000, 1500, 0.0, Filling(kind, shoulders=SHOULDERS))
        for kind in ("flooded", "cavitated", "dry")
    }


# pF at 0, 40 and 80 degrees
@pytest.mark.parametrize(("kind", "balls", "whole"), [
    ("flooded", (65.5, 52.9, 22.0), 248),
    ("cavitated", (59.9, 47.5, 17.7), 214),
])  # fmt: skip
def test_heavy_load(heavy, kind, balls, whole):
    quiet, found = heavy[kind]
    assert quiet == pytest.approx(0.96, abs=0.005)
    assert found.inner.load[:3] == pytest.approx([1461.7, 980.1, 105.8], abs=0.5)
    assert 1e12 * found.of_plates[:3] == pytest.approx([44.9, 33.3, 6.27], abs=0.06)
    assert 1e12 * found.ball[:3] == pytest.approx(balls, abs=0.06)
    assert 1e12 * found.plates == pytest.approx(124, abs=0.5)
    assert 1e12 * found.total == pytest.approx(whole, rel=0.01)


@pytest.mark.parametrize(("kind", "whole"), [("flooded", 101), ("cavitated", 77)])
def test_light_load_at_high_speed(bearing, kind, whole):
    """The capacitance of the plates alone is wrong by a factor of ten. The capacitance of an
    unloaded ball is 7 to 13 pF in flooded gaps and 5 to 10 pF in cavitated gaps."""
    quiet, found = point(bearing, 400, 6000, 12e-6, Filling(kind, shoulders=SHOULDERS))
    assert quiet == pytest.approx(15.4, abs=0.05)
    assert 1e12 * found.plates == pytest.approx(9.4, abs=0.06)
    assert 1e12 * found.total == pytest.approx(whole, rel=0.01)
    low, high = {"flooded": (7, 13), "cavitated": (5, 10)}[kind]
    free = 1e12 * found.ball[found.inner.load == 0]
    assert len(free) == 6 and np.all((free > low) & (free < high))
    assert found.unloaded == pytest.approx(1e-12 * free.sum())


def test_fills_are_exact_by_symmetry(heavy):
    flooded, cavitated, dry = (heavy[kind][1] for kind in ("flooded", "cavitated", "dry"))
    for side in ("inner", "outer"):
        wet, half, none = (getattr(one, side) for one in (flooded, cavitated, dry))
        assert half.total == pytest.approx((wet.total + none.total) / 2, rel=1e-12)
        around = none.outside / capacitance.VACUUM
        assert wet.outside - none.outside == pytest.approx(
            capacitance.VACUUM * 1.2 * around, rel=1e-12
        )
        assert wet.paths == pytest.approx(wet.area / wet.separation + around, rel=1e-12)
        assert none.paths == pytest.approx(wet.area / wet.separation, rel=1e-12)


def test_plates_are_the_paper_s(bearing, heavy):
    """If both raceways are loaded, the capacitance of the plates equals that computed by
    `lubrication.lubricate`. For h -> 0 the films dominate."""
    spin = 1500 * np.pi / 30
    state, _ = lubrication.turning(bearing, spin, 3000.0, ball_density=7850.0)
    films = lubrication.lubricate(bearing, state, OIL, spin)
    assert heavy["flooded"][1].plates == pytest.approx(films.total, rel=1e-12)
    thin = point(bearing, 3000, 1500, 0.0, Filling(shoulders=SHOULDERS), scale=1e-4)[1]
    loaded = thin.inner.load > 0
    assert np.all(thin.inner.plates[loaded] > 50 * thin.inner.outside[loaded])


def test_through_loss_of_contact(bearing):
    """When contact is lost, the separation is constant and the capacitance is continuous. Without
    the quiet load of the ball, the film thickness would grow without bound."""
    r_x, r_y = bearing.effective_radii(INNER)
    kappa, modulus = hertz.exact(r_x, r_y).kappa, bearing.effective_modulus
    speed = kinematics.entrainment(bearing, 50.0, 0.0)
    quiet = 0.96

    def thickness(load):
        group = film.group(0.03, 18e-9, modulus, r_x, kappa, speed, load)
        return film.h_c(r_x, group)

    play = np.concatenate([-np.geomspace(1e-6, 1e-12, 60), np.geomspace(1e-12, 2e-5, 60)])
    load = hertz.load(hertz.stiffness(hertz.exact(r_x, r_y), modulus), -play)
    apart = capacitors.separation(thickness, load, play, quiet)
    assert np.all(apart >= play) and apart[-1] == play[-1]
    assert np.ptp(apart[(load < quiet) & (play < apart)]) < 1e-15
    total = capacitors.of_raceway(bearing, INNER, 2.2, load, apart, play=play).total
    steps = np.diff(total) / total[1:]
    lost = 59  # between the last loaded and the first unloaded position
    # only the plates at an overlap of 1e-12 m remain
    assert abs(steps[lost]) < 5e-6 and steps.max() < 1e-4


def test_roughness_and_permittivity(bearing, heavy):
    flooded = heavy["flooded"][1]
    rough = point(bearing, 3000, 1500, 0.0, Filling(roughness="gamma", shoulders=SHOULDERS))[1]
    ratio = flooded.inner.separation[0] / OIL.roughness
    assert rough.inner.plates[0] / flooded.inner.plates[0] == pytest.approx(
        ratio**2 / (ratio**2 - 1)
    )
    assert rough.inner.outside == pytest.approx(flooded.inner.outside, rel=1e-14)
    mean = point(bearing, 3000, 1500, 0.0, Filling(permittivity_at="mean", shoulders=SHOULDERS))[1]
    assert 0.96 < mean.inner.plates[0] / flooded.inner.plates[0] < 0.99


def test_bad_values(bearing):
    with pytest.raises(ValueError, match="roughness 'gauss' is not one of none, gamma"):
        capacitors.of_raceway(bearing, OUTER, 2.2, 1.0, 1e-7, filling=Filling(roughness="gauss"))
    with pytest.raises(ValueError, match="permittivity_at 'top' is not one of"):
        capacitors.of_raceway(bearing, OUTER, 2.2, 0.0, 1e-7, filling=Filling("dry", 1.0, "top"))
    state = lubrication.turning(bearing, 50.0, 1000.0)[0]
    with pytest.raises(ValueError, match="balls that do not turn have no film"):
        capacitors.of_statics(bearing, state, OIL, 0.0, 1.0)


def test_quiet_load(bearing):
    assert capacitors.quiet_load(bearing, 0.0) == 0.1
    mass = 7850 * 4 / 3 * np.pi * 6.3e-3**3
    assert capacitors.quiet_load(bearing, 100.0) == pytest.approx(mass * 30.3e-3 * 1e4)
