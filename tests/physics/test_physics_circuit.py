# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of circuit.h, film_network.h, film_breakdown.h and waveform.h against closed-form
solutions, and against the solution of the same circuit as dense systems."""

import dataclasses
from contextlib import nullcontext

import numpy as np
import pytest
from circuits import (
    CASES,
    LEAKY,
    MOTOR_OF_INVERTER,
    PICO,
    SOURCE_OF_INVERTER,
    SOURCE_OF_TABLE,
    WEAK,
    films,
    turning,
)
from raceway import film_voltage, impedance
from raceway.core import laws
from raceway.electric import circuit
from raceway.electric.breakdown import Breakdown, threshold
from raceway.electric.films import series
from raceway.electric.outer import Floating
from raceway.electric.waveforms import CommonMode, Constant, Sine, Table
from raceway.errors import RunError
from references import circuit as reference
from scipy.signal import sawtooth

ROW = "film_voltage bearing_voltage bearing_voltage_after film_energy energy".split()


def with_edges(given, terms, breakdown):
    """Return the points for the films, for their limits and for the outer circuit, with two points
    inserted at each edge of the driving voltage, one just before and one just after it. Also return
    the positions of the original points."""
    n = len(given.time)
    arrays = [given.time, given.capacitance, given.conductance, given.thickness, terms.driving]
    rows, own = [[one[0] for one in arrays]], [0]
    for p in range(1, n):
        low, high = given.time[p - 1 : p + 1]
        for time, *volts in terms.edges[(terms.edges[:, 0] > low) & (terms.edges[:, 0] <= high)]:
            share = (time - low) / (high - low)
            row = [one[p - 1] + share * (one[p] - one[p - 1]) for one in arrays]
            for driving in volts:
                rows.append([time, *row[1:4], driving])
        rows.append([one[p] for one in arrays])
        own.append(len(rows) - 1)
    time, capacitance, conductance, thickness, driving = (np.array(one) for one in zip(*rows))
    beside = terms.beside(series(capacitance).bearing)
    columns = np.broadcast_arrays(beside, terms.coupling, terms.conductance, driving)
    limit = np.full(capacitance.shape, np.inf)
    if breakdown:
        limit = breakdown.limit(
            dataclasses.replace(
                given,
                time=np.arange(len(time)),
                capacitance=capacitance,
                conductance=conductance,
                thickness=thickness,
            )
        )
    return (time, capacitance, conductance, limit, np.stack(columns, axis=1)), own


@pytest.mark.parametrize("name", CASES)
def test_against_dense_systems(name):
    given, outer, breakdown = CASES[name]
    data, events = circuit.run(given, outer, breakdown, points=1)
    terms = outer.terms(given.time)
    (time, *points), own = with_edges(given, terms, breakdown)
    exact, flown, failures = reference.solve(time, *points, terms.start)
    exact, flown = exact[own], np.diff(np.cumsum(flown)[own])
    scale = max(np.abs(exact).max(), np.abs(terms.driving).max())
    near = dict(rtol=1e-10, atol=1e-10 * scale)
    np.testing.assert_allclose(data.bearing_voltage, exact[:, -1], **near)
    np.testing.assert_allclose(data.ball_voltage, exact[:, :-1], **near)
    current = flown / np.diff(given.time)
    most = np.abs(current).max()
    np.testing.assert_allclose(data.current[1:], current, rtol=1e-8, atol=1e-8 * most)
    assert len(events) == len(failures)
    assert name in ("open film", "stiff source") or failures
    if failures:
        failures = np.array(failures, float)
        np.testing.assert_array_equal(time[failures[:, 0].astype(int)], events.time)
        np.testing.assert_array_equal(failures[:, 1], events.raceway == "outer")
        np.testing.assert_array_equal(failures[:, 2] + 1, events.ball)
        np.testing.assert_allclose(failures[:, 3:], events[ROW], rtol=1e-8, atol=1e-10 * scale)


def test_discharges_do_not_depend_on_the_step():
    """Films break down at edges if there are at least 8 points per carrier period, so discharges do
    not depend on the step."""
    given = turning(n=11)
    runs = [circuit.run(given, MOTOR_OF_INVERTER, WEAK, points=points) for points in (16, 17, 320)]
    figures = [
        (
            run.events.discharge.nunique(),
            run.events.energy.sum(),
            run.events.energy.max(),
            run.events.bearing_voltage.abs().max(),
        )
        for run in runs
    ]
    assert figures[0][0] > 100
    np.testing.assert_allclose(figures[:2], [figures[2]] * 2, rtol=0.02)


@pytest.mark.parametrize("outer", [SOURCE_OF_INVERTER, SOURCE_OF_TABLE])
def test_edges_between_points_keep_the_order(outer):
    """Halving the step quarters the error of the second-order method, even if there are edges
    between points."""
    given = turning(n=11, **LEAKY)
    ends = {
        points: circuit.run(given, outer, points=points).data.bearing_voltage[::points]
        for points in (32, 64, 128, 2048)
    }
    errors = [float(np.abs(ends[points] - ends[2048]).max()) for points in (32, 64, 128)]
    assert errors[0] < 0.01 * float(np.abs(ends[2048]).max())
    assert [a / b for a, b in zip(errors, errors[1:])] == pytest.approx([4, 4], abs=1.0)


def test_one_leg_switches_at_a_time():
    """Inverter edges are steps of a third of the DC voltage, which occur when scipy's triangle wave
    crosses the sine, for any number of points. Each edge starts from the voltage at which the
    previous one ended."""
    wave = CommonMode(560.0, 1950.0, 50.0, 0.8)
    fine, coarse = (wave.edges(np.linspace(0, 0.02, n)) for n in (100_001, 313))
    np.testing.assert_array_equal(fine, coarse)
    time, before, after = fine.T
    assert len(time) == 6 * 39 and (np.diff(time) > 0).all()
    np.testing.assert_allclose(np.abs(after - before), 560.0 / 3)
    np.testing.assert_array_equal(before[1:], after[:-1])
    triangle = sawtooth(2 * np.pi * (1950.0 * time + 0.5), 0.5)
    sines = 0.8 * np.sin(2 * np.pi * (50.0 * time[:, None] - np.arange(3) / 3))
    assert np.abs(sines - triangle[:, None]).min(axis=1).max() < 1e-11
    still = CommonMode(560.0, 2000.0, 50.0, 0.0).edges(np.linspace(0, 1e-3, 9))
    np.testing.assert_allclose(
        np.diff(still[:, 1:]).ravel(), np.repeat([1, -1, 1, -1], 3) * 560 / 3
    )


def test_a_full_discharge_leaves_other_charges():
    """After many discharges with a ring whose charge is constant, the discharge energy minus the
    mechanical work plus the stored energy equals the initial energy."""
    given = turning(thickness=(20e-9, 40e-9))
    data, events = circuit.run(given, Floating(7.0), WEAK)
    start, end = 0.5 * series(given.capacitance).bearing[0] * 49, data.isel(time=-1)
    assert events.bearing_voltage_after.iloc[-1] == 0.0 and len(events) >= 2
    left = end.discharge_energy - end.mechanical_work + end.stored_energy
    assert float(left) == pytest.approx(start)


def test_a_charge_that_loses_its_films():
    """Ball 1 is charged when one of its films breaks down. If the ball then loses its films, there
    is an error that reports the charge; a charge within rounding error is ignored."""
    thickness = np.array([[100e-9, 900e-9], [900e-9, 900e-9]])
    said = "ball 1 has a charge of 3e-10 C and no film at 0.0075 s"
    for left, lost in (([0.0, 0.0], True), ([40 * PICO, 0.0], False)):
        capacitance = np.full((5, 2, 2), 40 * PICO)
        capacitance[3:] = left
        given = films(capacitance, thickness=thickness)
        with pytest.raises(RunError, match=said) if lost else nullcontext():
            events = circuit.run(given, Floating(10.0, 20 * PICO), Breakdown(45e6)).events
            assert events.ball.tolist() == [1]


def test_limit():
    found = laws.film_limit([100e-9, 50e-9, np.nan], strength=1e6, less=60e-9, floor=1e-9)
    assert found == pytest.approx([0.04, 1e-3, np.inf])


def in_series(admittance):
    """Return the conductance of films with the `admittance` (Z, 2) in S, where the two films of
    each ball are in series."""
    return (admittance.prod(1) / admittance.sum(1)).sum()


@pytest.mark.parametrize("frequency", [0.1, 1e3, 1e7])
def test_t11_impedance_and_back(frequency):
    """If the two films of each ball leak equally, C and R are recovered to rounding accuracy."""
    random = np.random.default_rng(11)
    for c, tau in zip(random.uniform(1, 900, 20) * PICO, 10 ** random.uniform(-5, 1, 20)):
        both = np.array([[c], [2 * c]])
        z = impedance.of_films(both, both / tau, frequency, 1.0)
        assert impedance.capacitance_of(z, frequency) == pytest.approx(c / 1.5, rel=1e-13)
        assert impedance.resistance_of(z) == pytest.approx(1.5 * tau / c, rel=1e-13)
        exact = 1 / (c / 1.5 * (1 / tau + 2j * np.pi * frequency))
        assert z == pytest.approx(exact, rel=1e-14)
    z = impedance.of_films(both, both, frequency)
    assert impedance.capacitance_of(z, frequency) == pytest.approx(c / 1.5, rel=1e-14)
    assert impedance.resistance_of(z) == np.inf
    assert np.angle(z) == -np.pi / 2


def test_t11_impedance_of_a_bearing():
    """The impedance of films that leak differently agrees with the closed-form solution."""
    random = np.random.default_rng(12)
    capacitance = random.uniform(5, 90, (9, 2)) * PICO
    paths = random.uniform(1, 9, (9, 2))
    frequency = np.array([1e-2, 1e2, 1e4, 1e7])
    found = impedance.of_films(capacitance.T, paths.T, frequency, 1e9)
    exact = [1 / in_series(paths / 1e9 + 2j * np.pi * f * capacitance) for f in frequency]
    np.testing.assert_allclose(found, exact, rtol=1e-13)
    z = 1 / in_series(paths / 1e9)
    assert impedance.leak_of_films(paths.T, 1e9) == pytest.approx(z, rel=1e-13)
    open_one = np.array([[0.0, 50 * PICO], [50 * PICO, 50 * PICO]])
    z = impedance.of_films(open_one.T, np.zeros((2, 2)), 1e6)
    assert abs(z) == pytest.approx(1 / (2e6 * np.pi * 25 * PICO), rel=1e-14)


@pytest.mark.parametrize("roughness", [0.0, 25e-9, 60e-9])
def test_threshold_is_that_of_statics(roughness):
    """The threshold equals the result of the function that `raceway electric` uses, for the same
    films."""
    random = np.random.default_rng(5)
    thickness = random.uniform(90e-9, 900e-9, (2, 2, 9))
    capacitance = random.uniform(5, 90, (2, 2, 9)) * PICO
    limit = laws.film_limit(thickness, 20e6, 3 * roughness, 0.0)
    found = threshold(films(capacitance), limit)[0]
    exact = film_voltage.threshold(tuple(thickness[0]), tuple(capacitance[0]), 20e6, roughness)
    assert found == pytest.approx(exact.bearing, rel=1e-14)
    assert (found == 0) == (roughness == 60e-9)


def test_waveforms():
    at = np.linspace(0, 0.07, 3001) + 1e-7  # avoid crossings of sine and triangle wave
    near = dict(rtol=1e-12, atol=1e-11)
    sine = 20.0 * np.sin(2 * np.pi * 50.0 * at + 0.3)
    np.testing.assert_allclose(Sine(20.0, 50.0, 0.3)(at), sine, **near)
    # each leg switches where its sine crosses scipy's triangle wave
    triangle = sawtooth(2 * np.pi * (1950.0 * at + 0.5), 0.5)
    legs = [0.8 * np.sin(2 * np.pi * (50.0 * at - leg / 3)) >= triangle for leg in range(3)]
    mean = 560.0 * (np.mean(legs, axis=0) - 0.5)
    np.testing.assert_allclose(CommonMode(560.0, 1950.0, 50.0, 0.8)(at), mean, **near)
    constant, table = laws.waveform(at, 0, 3.5, 0.0, 0.0, 0.0, 0.0), Table([1.0, 2.0], [1.0, -4.0])
    assert (constant == 3.5).all() and (Constant(3.5)(at) == 3.5).all()
    assert table([0.0, 1.5, 3.0]).tolist() == [1.0, -1.5, -4.0]


@pytest.mark.parametrize("name", ["rough", "leaking source"])
def test_cases_have_discharges_of_all_kinds(name):
    """Single and multiple films break down, at both raceways; otherwise the comparison would not be
    conclusive."""
    given, outer, breakdown = CASES[name]
    events = circuit.run(given, outer, breakdown, points=1).events
    assert {1, 2} <= set(events.groupby("discharge").size())
    assert set(events.raceway) == {"inner", "outer"}
