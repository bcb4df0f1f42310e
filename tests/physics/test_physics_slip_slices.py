# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of slip and spin in slices of the ellipse, against fine Gauss points over the ellipse
(references/spin) and against closed-form limits, and of the states of the part over a time step."""

import itertools

import numpy as np
import pytest
from raceway import hertz, sliding, spin
from raceway.core import laws
from references import spin as reference
from test_physics_rolling_friction import FRICTION, REST, of, radii, turning

FREE = dict(along=0.0, across=0.0, spin=0.0, edge=1.0, aspect=1 / 8, least=1e-4)
MOTIONS = list(
    itertools.product((-0.5, 0.02, 0.12, 0.3, 0.7, 3.0), (0.0, 0.1, 0.5), (0.0, 0.3, 1.0, 3.0))
)


def sums(**motion):
    return laws.slip_slices(**FREE | motion)


def fine(along, across, turned, aspect=1 / 8):
    """Return reference values: forces divided by mu Q, and moments divided by mu Q and the
    semi-axis across the groove."""
    return reference.with_slip(
        1.0, 1.0, 1.0, aspect, along, across, -turned, curve=1.0, width=1e-4, points=120
    )


@pytest.mark.parametrize(
    "aspect, bounds", [(1 / 8, (5e-3, 2e-2, 3e-3)), (1 / 4, (1.3e-2, 8e-2, 1.2e-2))]
)
def test_against_gauss_points(aspect, bounds):
    worst = np.zeros(3)
    for along, across, turned in MOTIONS:
        found = sums(along=along, across=across, spin=turned, aspect=aspect)
        theory = fine(along, across, turned, aspect)
        off = [found.along - theory.along, found.across - theory.across,
               found.moment + theory.moment]  # fmt: skip
        worst = np.maximum(worst, np.abs(off))
        power = found.along * along + found.across * across + found.moment * turned + found.couple
        assert power > 0
        assert power == pytest.approx(theory.power, abs=3e-3 * (1 + along + across + turned))
    print(worst)
    assert np.all(worst < bounds)
    assert np.all(worst > 0.1 * np.array(bounds)), "the bounds show the accuracy of the slices"


@pytest.mark.parametrize("kappa, expected, bound", [(9.37359, 0.381695, 1e-3), (2, 0.454146, 0.02)])
def test_pure_spin(kappa, expected, bound):
    found = sums(spin=1.0, edge=0.0, aspect=1 / kappa, least=1e-6)
    assert found.moment == pytest.approx(expected, rel=bound)
    assert found.along == pytest.approx(0, abs=1e-12)
    theory = reference.with_slip(1.0, 1.0, 1.0, 1 / kappa, 0.0, 0.0, 1.0, points=60)
    assert theory.moment == pytest.approx(expected, rel=2e-5)


def test_free_rolling():
    """Free rolling agrees with Heathcote's solution: the force vanishes at a slip of 0.120615 s_e,
    and the loss is 0.161142 mu Q s_e."""
    found = sums(along=sliding.FREE**2)
    assert found.along == pytest.approx(0, abs=2e-3)
    power = found.couple + found.along * sliding.FREE**2
    assert power == pytest.approx(0.161142, rel=2e-3)
    for slip in (-0.4, 0.3, 0.6, 0.9, 1.3):
        theory = sliding.heathcote(slip, load=1.0, friction=1.0, speed=1.0, a=1.0, r_d=0.5, r_x=1.0)
        assert sums(along=slip).along == pytest.approx(theory.force, abs=5e-3)


def test_forces_have_no_steps():
    """At every slip from 0 to s_e, the sliding velocity vanishes at some points of the ellipse, but
    the force does not jump."""
    slips = np.linspace(0, 1.2, 1201)
    forces = np.array([sums(along=slip, spin=0.2).along for slip in slips])
    assert 0 < np.diff(forces).min() and np.diff(forces).max() < 0.025


def test_mirrored():
    """Reversing the spin reverses the moment, and reversing the rolling direction reverses the
    couple."""
    one = sums(along=0.3, across=0.1, spin=0.5)
    other = sums(along=0.3, across=0.1, spin=-0.5)
    assert (other.along, other.across) == pytest.approx((one.along, one.across), rel=1e-12)
    assert other.moment == pytest.approx(-one.moment, rel=1e-12)
    back = sums(along=-0.3, across=0.1, spin=0.5, edge=-1.0)
    assert (back.along, back.couple) == pytest.approx((-one.along, -one.couple), rel=1e-12)


# ---- the part ------------------------------------------------------------------------------------
def steady(physics, part, **changes):
    """Return a contact after one second of constant motion with a spin of omega a = `part` s_e, and
    reference values at the slip for which the force vanishes."""
    free = of(physics, "slices_of", turning(), np.zeros(4))
    r_d = sliding.deformed_radius(6.552e-3, 6.3e-3)
    edge = sliding.edge_slip(0.724764, free.a, r_d, radii(0)[0])
    contact = turning(spin_n=part * edge / free.a, **changes)
    curve = edge / free.a**2
    gauss = reference.free_slip(
        free.load, FRICTION, free.a, free.b, np.array([contact["spin_n"]]), curve, points=60
    )
    return free, edge, contact, gauss


@pytest.mark.parametrize("part", [0.0, 0.2, 0.7, 2.0, 10.0])
def test_free_rolling_with_spin(physics, part):
    """In a freely rolling contact, the moment agrees within 1 % of mu Q a, and the power within
    1 %; the closed-form solutions deviate by up to 5 %."""
    free, edge, contact, gauss = steady(physics, part)
    lo, hi = 0.0, edge
    for _ in range(40):
        middle = (lo + hi) / 2
        found = of(physics, "slices_of", contact | dict(sliding_t=middle), np.zeros(4))
        lo, hi = (lo, middle) if found.friction_t > 0 else (middle, hi)
    limit = FRICTION * free.load
    assert found.couple_n == pytest.approx(gauss.moment[0], abs=0.01 * limit * free.a)
    lost = found.couple_n * contact["spin_n"] + found.slip_couple * contact["roll_w"]
    assert lost == pytest.approx(gauss.power[0], rel=0.01)
    booked = lost + found.hysteresis_couple * contact["roll_w"] + found.friction_t * middle
    assert found.loss == pytest.approx(booked, rel=1e-9)


def test_a_spring_for_short_times(physics):
    """A rolling contact that begins to slide first deflects elastically with the stiffness k_t, and
    then slips."""
    contact = turning(spin_n=5.0)
    free = of(physics, "slices_of", contact, np.zeros(4))
    r_d = sliding.deformed_radius(6.552e-3, 6.3e-3)
    edge = sliding.edge_slip(0.724764, free.a, r_d, radii(0)[0])
    slide = dict(sliding_t=sliding.FREE**2 * edge + 1e-4, sliding_w=2e-4)
    kept = of(physics, "slices_of", contact | slide, np.zeros(4))
    before = np.append(kept.states, kept.slips)
    slide = {name: value + 1e-3 for name, value in slide.items()}
    for dt in (1e-9, 1e-8):
        found = of(physics, "slices_of", contact | slide | dict(dt=dt), before)
        moved = np.array([found.friction_t, found.friction_w]) - before[:2]
        assert moved == pytest.approx(found.kt * 1e-3 * dt, rel=0.02)
    still = of(physics, "slices_of", contact | slide | dict(dt=0.0), before)
    assert [*still.states, *still.slips] == list(before)


def test_no_load_no_force(physics):
    found = of(physics, "slices_of", REST | dict(overlap=0.0, spin_n=3.0), [5.0, 5.0, 1.0, 1.0])
    assert (found.friction_t, found.friction_w, found.couple_n) == (0, 0, 0)


def test_pure_spin_of_the_part(physics):
    found = of(physics, "slices_of", REST | dict(spin_n=30.0), np.zeros(4))
    ellipse = hertz.exact(*radii(0))
    theory = spin.moment(found.load, FRICTION, found.a, ellipse.second)
    assert found.couple_n == pytest.approx(theory, rel=2e-3)
