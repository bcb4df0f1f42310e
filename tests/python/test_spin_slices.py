# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of combined slip and spin in statics: limits and comparison with closed-form expressions;
tests/physics compares the slices with Gauss points."""

import numpy as np
import pytest
from host import ROOT
from raceway import friction_torque, inputs, spin
from raceway.theory.lubrication import lubricate, turning
from raceway.theory.operating_point import figures
from references import spin as gauss_points

OIL = ROOT / "inputs/lubricants/mineral"


def losses(bearing, load, axial, law):
    ring = 50.0
    state, orbit = turning(bearing, ring, load, axial)
    films = lubricate(bearing, state, inputs.oil(OIL), ring)
    fluid = inputs.fluid(OIL)
    return friction_torque.losses(bearing, state, films, fluid, ring, orbit, spin_law=law)


def test_radial_load_has_no_spin(bearing):
    closed, slices = (losses(bearing, 5000.0, 0.0, law) for law in friction_torque.SPIN_LAWS)
    assert slices.parts == closed.parts and not closed.spin.any()


def test_as_the_closed_forms(bearing):
    """Under combined load, both raceways share the spin, which reduces the losses due to slip. The
    closed-form expressions are fits and agree within 5 %."""
    closed, slices = (losses(bearing, 2000.0, 10000.0, law) for law in friction_torque.SPIN_LAWS)
    for part in ("rolling", "hysteresis", "drag"):
        assert slices.parts[part] == closed.parts[part]
    apart, together = (sum(one.parts[p] for p in ("slip", "spin")) for one in (closed, slices))
    assert together == pytest.approx(apart, rel=0.05)
    assert np.all(slices.slip + slices.spin >= 0)
    assert np.all((slices.spin[:, 0] > 0) & (closed.spin[:, 0] > 0))


def test_free_slip_leaves_no_force():
    case = dict(load=2000.0, friction=0.05, a=2e-3, b=2.5e-4)
    rates, edge = np.array([0.0, 5.0, 20.0, 200.0]), 1e4 * 4e-6
    found = spin.free_slip(**case, spin=rates, curve=1e4)
    assert np.abs(found.along).max() < 5e-3 * 0.05 * 2000
    assert found.power[0] == pytest.approx(0.161142 * 0.05 * 2000 * edge, rel=5e-3)
    fine = gauss_points.free_slip(**case, spin=rates, curve=1e4, points=60)
    assert found.moment == pytest.approx(fine.moment, abs=0.01 * 0.05 * 2000 * 2e-3)
    assert found.power == pytest.approx(fine.power, rel=0.01)


def test_figures_and_mistakes(bearing):
    options = dict(load=2000.0, axial=10000.0, rpm=477.5, models="full")
    closed, slices = (
        figures("6208", "mineral", ROOT / "inputs", **options, spin_law=law)
        for law in friction_torque.SPIN_LAWS
    )
    assert slices["friction_torque_N_m"] == pytest.approx(closed["friction_torque_N_m"], rel=0.05)
    with pytest.raises(ValueError, match="spin law 'open' is not one of closed, slices"):
        losses(bearing, 5000.0, 0.0, "open")
