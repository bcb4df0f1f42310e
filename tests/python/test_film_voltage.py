# SPDX-License-Identifier: GPL-2.0-or-later
"""Voltages, impedances and rough films are compared with algebraic identities and printed
values."""

import numpy as np
import pytest
from raceway import capacitance, film_voltage, impedance, rough_film


def test_division():
    """Of two films in series, the film with half the capacitance carries two thirds of the
    voltage."""
    shares = film_voltage.divided(9.0, 2e-10, 1e-10)
    assert shares.inner == pytest.approx(3.0) and shares.outer == pytest.approx(6.0)
    with pytest.raises(ValueError, match="capacitance = 0.0 must be positive"):
        film_voltage.divided(1.0, 0.0, 1e-10)


def test_field_and_threshold():
    gaps = (np.array([2e-7, 3e-7]), np.array([2.5e-7, 3.5e-7]))
    parts = (np.array([1e-10, 5e-11]), np.array([1.2e-10, 4e-11]))
    found = film_voltage.threshold(gaps, parts, 15e6, 3e-8)
    shares = film_voltage.divided(found.bearing, *parts)
    local = [film_voltage.local_gap(gap, 3e-8) for gap in gaps]
    fields = np.array([film_voltage.field(share, gap) for share, gap in zip(shares, local)])
    assert fields.max() == pytest.approx(15e6)
    assert fields[found.first[found.weakest], found.weakest] == fields.max()
    assert found.bearing == found.ball.min() == found.ball[found.weakest]
    assert film_voltage.field(3.0, 1e-7) == pytest.approx(3e7)
    assert film_voltage.field(-3.0, 1e-7) == pytest.approx(-3e7)
    assert film_voltage.local_gap(1e-7, 4e-8) == 0.0
    assert film_voltage.local_gap(1e-7, 4e-8, 1e-9) == 1e-9
    assert film_voltage.field(3.0, 0.0) == np.inf
    assert film_voltage.threshold(([1e-7], [1e-7]), ([1e-10], [1e-10]), 15e6, 4e-8).bearing == 0.0
    with pytest.raises(ValueError, match="strength = -1.0 must be positive"):
        film_voltage.threshold(gaps, parts, -1.0)


def test_open_films():
    """If one film is open, the entire voltage drops across it; if both are open, there is no
    voltage across either."""
    inner, outer = np.array([1e-10, 0.0, 0.0]), np.array([0.0, 1e-10, 0.0])
    assert film_voltage.shares(inner, outer).outer.tolist() == [1, 0, 0]
    found = film_voltage.ring_voltages((3.0, 4.0), inner, outer)
    assert found.tolist() == [[np.inf, 3.0, np.inf], [4.0, np.inf, np.inf]]


def test_discharge():
    assert film_voltage.stored_energy(2e-10, 10.0) == pytest.approx(1e-8)
    assert film_voltage.apparent_current_density(0.5, 5e-6) == pytest.approx(film_voltage.HARMLESS)
    assert film_voltage.states([0.0, 0.02, 0.0], [0.5, 0.5, 2.0]).tolist() == [0, 2, 1]


def test_impedance_and_back():
    """The impedance of a resistor beside a capacitor is worked out by hand."""
    c, r, f = np.array([1e-11, 2e-10, 1e-9]), np.array([1e5, 1e7, np.inf]), 2e4
    z = impedance.impedance(c, f, r)
    assert impedance.capacitance_of(z, f) == pytest.approx(c, rel=1e-13)
    assert impedance.resistance_of(z) == pytest.approx(r, rel=1e-13)
    assert z == pytest.approx(1 / (1 / r + 2j * np.pi * f * c), rel=1e-14)
    with pytest.raises(ValueError, match="frequency = 0.0 Hz must be positive"):
        impedance.impedance(1e-10, 0.0)


def test_leak_of_one_fill():
    """The product R C equals rho eps_0 eps for any geometry."""
    paths = np.random.default_rng(1).uniform(1.0, 9.0, (2, 5))
    r = impedance.leak_of_films(paths, 1e10)
    c = capacitance.bearing(*(capacitance.VACUUM * 2.2 * paths))
    assert r * c == pytest.approx(1e10 * capacitance.VACUUM * 2.2)


def test_film_from_capacitance():
    c = 7.4e-11
    scale = impedance.film_scale(c + 3e-11, lambda scale: c / scale + 3e-11)
    assert scale == pytest.approx(1.0, rel=1e-10)
    with pytest.raises(ValueError, match="films from 0.001 to 1000 times"):
        impedance.film_scale(2e-11, lambda scale: c / scale + 3e-11)


def test_rough_films():
    assert rough_film.factor(0.5) == rough_film.factor(2.5)


def test_clipped_film():
    found = rough_film.clipped(np.array([0.0, 2.5, 30.0]), 0.05)
    # at a mean gap of zero, half of the film is closed; a thick film is not closed anywhere
    assert found.closed == pytest.approx([0.5199, 0.00714, 0.0], abs=6e-5)
    assert found.factor[2] == pytest.approx(rough_film.factor(30.0), rel=1e-4)
    z = (np.arange(400_000) + 0.5) / 400_000 * 12 + 0.05  # gaps in sigmas
    mean = np.sum(np.exp(-((z - 2.5) ** 2) / 2) / z) * (12 / 400_000) / np.sqrt(2 * np.pi)
    assert found.factor[1] == pytest.approx(2.5 * mean, rel=1e-6)
    with pytest.raises(ValueError, match="boundary = 0.0 must be positive"):
        rough_film.clipped(1.0, 0.0)
