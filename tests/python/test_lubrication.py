# SPDX-License-Identifier: GPL-2.0-or-later
"""Film and capacitance from statics are compared with the formulas for each contact, and trends of
the bearing's totals are tested."""

import numpy as np
import pytest
from raceway import capacitance, film, hertz, kinematics
from raceway.inputs import Oil
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.lubrication import lubricate, turning
from raceway.theory.static import equilibrium

OIL = Oil(viscosity=0.04, pressure_viscosity=22e-9, permittivity=2.25, roughness=1e-7)


def test_each_contact(bearing):
    """The films equal the results of each formula for the load and the contact angle of each
    ball."""
    state = equilibrium(bearing, 2000.0, 1000.0, moment=(10.0, 0.0), clearance=10e-6)
    films = lubricate(bearing, state, OIL, 50.0, 10e-6)
    assert films.inner.entrainment[0] != films.inner.entrainment[4]  # due to the contact angle
    modulus, series = bearing.effective_modulus, []
    for side, contact, found in (
        (INNER, state.inner, films.inner),
        (OUTER, state.outer, films.outer),
    ):
        r_x, r_y = bearing.effective_radii(side, contact.angle, 10e-6)
        ellipse, speed = hertz.exact(r_x, r_y), kinematics.entrainment(bearing, 50.0, contact.angle)
        g = film.group(0.04, 22e-9, modulus, r_x, ellipse.kappa, speed, contact.load)
        pressure = hertz.pressure(ellipse, modulus, contact.load)
        h_min, h_c = film.h_min(r_x, g), film.h_c(r_x, g)
        a, b = hertz.semi_axes(ellipse, modulus, contact.load)
        c = capacitance.contact(2.25, pressure, a, b, h_c)
        expected = np.array([speed, h_min, h_c, h_min / 1e-7, c, speed])
        assert np.array(found) == pytest.approx(expected, rel=1e-12)
        series.append(c)
    assert films.ball == pytest.approx(1 / (1 / series[0] + 1 / series[1]), rel=1e-12)
    assert films.total == pytest.approx(films.ball.sum(), rel=1e-12)


def test_unloaded_balls_add_nothing(bearing):
    state = equilibrium(bearing, 5000.0, clearance=20e-6)
    films = lubricate(bearing, state, OIL, 50.0, 20e-6)
    idle = state.inner.load == 0
    assert idle.any()
    assert np.all(films.ball[idle] == 0) and np.all(films.inner.h_min[idle] == 0)
    assert np.all(films.ball[~idle] > 0)


def test_thrown_ball_touches_the_outer_raceway_only(bearing):
    """At 1000 rad/s an unloaded ball has a film at the outer raceway but no capacitance, because
    the series connection is open at the inner raceway."""
    state, _ = turning(bearing, 1000.0, 1000.0, clearance=20e-6)
    films = lubricate(bearing, state, OIL, 1000.0, 20e-6)
    idle = (state.inner.load == 0) & (state.outer.load > 0)
    assert idle.any()
    assert np.all(films.outer.h_min[idle] > 0) and np.all(films.outer.capacitance[idle] > 0)
    assert np.all(films.ball[idle] == 0)


def test_more_load_more_capacitance_more_speed_less(bearing):
    def total(load, spin):
        return lubricate(bearing, equilibrium(bearing, load), OIL, spin).total

    assert total(2000.0, 50.0) < total(4000.0, 50.0)
    assert total(4000.0, 50.0) > total(4000.0, 100.0)
