# SPDX-License-Identifier: GPL-2.0-or-later
"""circuit.h, film_network.h, film_breakdown.h and waveform.h: closed forms, and the same circuit as
dense systems."""

import numpy as np
import pytest
from circuits import PICO, films, steady, turning
from raceway import core, film_voltage, impedance
from raceway.core import laws
from raceway.electric import circuit
from raceway.electric.breakdown import Breakdown, threshold
from raceway.electric.films import series
from raceway.electric.network import ACCOUNT
from raceway.electric.outer import Floating, Motor, Source
from raceway.electric.waveforms import CommonMode, Constant, Sine, Table
from references import circuit as reference
from scipy.signal import sawtooth

WEAK = Breakdown(30e6)
ROW = "point side ball film_voltage bearing_voltage bearing_voltage_after film_energy energy"


def solve(given, outer, breakdown=None):
    """(voltages by name, failures as rows, the CircuitEnd) of the C++."""
    n, _, z = given.capacitance.shape
    terms = outer.terms(given.time, series(given.capacitance).bearing)
    columns = np.stack(
        [
            terms.capacitance,
            np.full(n, terms.coupling),
            np.full(n, terms.conductance),
            terms.driving,
        ],
        axis=1,
    )
    limit = breakdown.limit(given) if breakdown else np.full(given.capacitance.shape, np.inf)
    by_point = "bearing bearing_before ring_charge supplied discharge_work current".split()
    account = np.empty((n, len(ACCOUNT)))
    made = {name: np.empty(n) for name in by_point}
    made |= {name: np.empty((n, z)) for name in ("ball", "ball_before", "ball_charge")}
    rows = np.empty((4 * n, 8))
    count, end = core.library().call(
        "bearing_circuit",
        points=n,
        balls=z,
        time=given.time,
        capacitance=given.capacitance,
        conductance=given.conductance,
        limit=limit,
        outer=columns,
        start=terms.start,
        most=len(rows),
        failures=rows,
        leaked=np.empty((n, 2, z)),
        account=account,
        **made,
    )
    assert count <= len(rows)
    return made, rows[:count], end


MOTOR = Motor(Sine(300.0, 2000.0), 50 * PICO, 1000 * PICO, second=200 * PICO)
LEAKY = dict(conductance=2e-9)
CASES = {
    "motor": (turning(), MOTOR, WEAK),
    "motor, other bearing alike": (
        turning(),
        Motor(CommonMode(560.0, 2000.0, 50.0, 0.8), 50 * PICO, 1e-9, second_factor=1.0),
        WEAK,
    ),
    "leaking motor": (turning(**LEAKY), MOTOR, WEAK),
    "rough": (turning(roughness=10e-9), MOTOR, WEAK),
    "source": (turning(), Source(Sine(15.0, 900.0), 1e6), WEAK),
    "leaking source": (turning(**LEAKY), Source(Sine(15.0, 900.0), 1e6, 30 * PICO), WEAK),
    "stiff source": (turning(**LEAKY), Source(Sine(15.0, 900.0)), None),
    "charged ring": (turning(), Floating(5.5, 30 * PICO), WEAK),
    "open film": (
        steady([50 * PICO, 0.0, 0.0], [50 * PICO, 40 * PICO, 0.0]),
        Source(Constant(4.0), 1e7),
        WEAK,
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_against_dense_systems(name):
    given, outer, breakdown = CASES[name]
    ours, rows, end = solve(given, outer, breakdown)
    result = circuit.run(given, outer, breakdown, points=1)
    data, events = result
    terms = outer.terms(given.time, series(given.capacitance).bearing)
    columns = np.broadcast_arrays(
        terms.capacitance, terms.coupling, terms.conductance, terms.driving
    )
    limit = breakdown.limit(given) if breakdown else np.full(given.capacitance.shape, np.inf)
    exact, current, failures, account = reference.solve(
        given.time,
        given.capacitance,
        given.conductance,
        limit,
        np.stack(columns, axis=1),
        terms.start,
    )
    scale = max(np.abs(exact).max(), np.abs(terms.driving).max())
    near = dict(rtol=1e-10, atol=1e-10 * scale)
    np.testing.assert_allclose(ours["bearing"], exact[:, -1], **near)
    np.testing.assert_allclose(ours["ball"], exact[:, :-1], **near)
    np.testing.assert_array_equal(data.bearing_voltage, ours["bearing"])
    np.testing.assert_array_equal(data.ball_voltage, ours["ball"])
    most = np.abs(current[1:]).max()
    for one in (ours["current"], data.current):
        np.testing.assert_allclose(one[1:], current[1:], rtol=1e-8, atol=1e-8 * most)
    assert len(rows) == len(events) == len(failures)
    assert name in ("open film", "stiff source") or len(rows) > 0
    assert end.failures == len(events) and end.discharges == events.discharge.nunique()
    if failures:
        failures = np.array(failures, float)
        np.testing.assert_array_equal(rows[:, :3], failures[:, :3])
        np.testing.assert_allclose(rows[:, 3:], failures[:, 3:], rtol=1e-8, atol=1e-10 * scale)
        np.testing.assert_array_equal(given.time[rows[:, 0].astype(int)], events.time)
        np.testing.assert_array_equal(rows[:, 1], events.raceway == "outer")
        np.testing.assert_array_equal(rows[:, 2] + 1, events.ball)
        for column, key in enumerate(ROW.split()[3:], 3):
            np.testing.assert_array_equal(rows[:, column], events[key].astype(float))
    most = np.abs(account).max()
    for key, column in zip(ACCOUNT, account.T):
        np.testing.assert_allclose(data[key], column, rtol=1e-9, atol=1e-9 * most, err_msg=key)
        assert getattr(end, key) == data[key][-1]


@pytest.mark.parametrize("name", CASES)
def test_charge_and_energy(name):
    """Charges of currents and of voltages, and the energy of every step, to rounding."""
    given, outer, breakdown = CASES[name]
    ours, _, end = solve(given, outer, breakdown)
    volts = max(np.abs(ours["bearing"]).max(), np.abs(ours["ball"]).max(), 4.0)
    coupled = 300 * 50 * PICO * isinstance(outer, Motor)
    charge = given.capacitance.max() * volts + coupled
    assert end.charge_error < 1e-13 * charge
    assert end.energy_error < 1e-13 * 300 * charge


def test_series_and_ratio():
    """C_i = 2 C_o: V_i = V/3. C_wr 50 pF, C_rf 1 nF, C_b 200 pF twice: 0.03448."""
    ours, *_ = solve(steady([2 * PICO], [PICO]), Source(Constant(6.0)))
    assert ours["ball"][-1, 0] == pytest.approx(4.0, rel=1e-15)
    alike = steady([100 * PICO] * 4, [100 * PICO] * 4)
    motor = Motor(Constant(1.0), 50 * PICO, 1000 * PICO, second=200 * PICO)
    ours, *_ = solve(alike, motor)
    assert ours["bearing"][-1] == pytest.approx(50 / 1450, rel=1e-14)
    given = turning()
    ours, *_ = solve(given, Floating(12.0))
    bearing = series(given.capacitance).bearing
    np.testing.assert_allclose(ours["bearing"], 12 * bearing[0] / bearing, rtol=1e-12)


def test_t9_current_into_a_capacitance_that_changes():
    """C0 (1 + m cos W t) at constant voltage: |i| = V C0 m W, to the mean over a step."""
    time, mean, depth, speed = np.linspace(0, 0.04, 2001), 100 * PICO, 0.3, 2 * np.pi * 50
    one = 2 * mean * (1 + depth * np.cos(speed * time))  # two alike in series
    given = films(np.tile(one[:, None, None], (1, 2, 1)), time)
    found = solve(given, Source(Constant(5.0)))[0]["current"][1:]
    largest = 5.0 * mean * depth * speed
    exact = -largest * np.sin(speed * (time[1:] + time[:-1]) / 2)
    assert np.abs(found - exact).max() < largest * (speed * 2e-5) ** 2 / 20
    assert np.abs(found).max() == pytest.approx(largest, rel=1e-5)


def test_a_full_discharge_leaves_other_charges():
    """After many discharges at constant charge of a ring: energy is what was there."""
    given = turning(thickness=(20e-9, 40e-9))
    _, rows, end = solve(given, Floating(7.0), WEAK)
    start = 0.5 * series(given.capacitance).bearing[0] * 49
    assert rows[-1, 5] == 0.0 and end.failures >= 2
    assert end.discharge_energy - end.mechanical_work + end.stored_energy == pytest.approx(start)


def test_a_charge_that_loses_its_films():
    """Ball 1 gets a charge by the failure of one film; rounding does not count."""
    thickness = np.array([[100e-9, 900e-9], [900e-9, 900e-9]])
    for left, lost in (([0.0, 0.0], 0), ([40 * PICO, 0.0], -1)):
        capacitance = np.full((5, 2, 2), 40 * PICO)
        capacitance[3:] = left
        given = films(capacitance, thickness=thickness)
        _, rows, end = solve(given, Floating(10.0, 20 * PICO), Breakdown(45e6))
        assert len(rows) == 1 and rows[0, 2] == 0
        assert end.lost == lost


def test_limit():
    found = laws.film_limit([100e-9, 50e-9, np.nan], strength=1e6, less=60e-9, floor=1e-9)
    assert found == pytest.approx([0.04, 1e-3, np.inf])


def in_series(admittance):
    """S of films (Z, 2), those of a ball in series."""
    return (admittance.prod(1) / admittance.sum(1)).sum()


@pytest.mark.parametrize("frequency", [0.1, 1e3, 1e7])
def test_t11_impedance_and_back(frequency):
    """Films of a ball that leak alike; C and R come back to rounding."""
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
    """Films that leak differently."""
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
    """The same films by the function that `raceway electric` uses."""
    random = np.random.default_rng(5)
    thickness = random.uniform(90e-9, 900e-9, (2, 2, 9))
    capacitance = random.uniform(5, 90, (2, 2, 9)) * PICO
    limit = laws.film_limit(thickness, 20e6, 3 * roughness, 0.0)
    found = threshold(films(capacitance), limit)[0]
    exact = film_voltage.threshold(tuple(thickness[0]), tuple(capacitance[0]), 20e6, roughness)
    assert found == pytest.approx(exact.bearing, rel=1e-14)
    assert (found == 0) == (roughness == 60e-9)


def test_waveforms():
    at = np.linspace(0, 0.07, 3001) + 1e-7  # of no tie between sine and triangle
    near = dict(rtol=1e-12, atol=1e-11)
    sine = 20.0 * np.sin(2 * np.pi * 50.0 * at + 0.3)
    np.testing.assert_allclose(Sine(20.0, 50.0, 0.3)(at), sine, **near)
    # each leg switches where its sine meets the triangle of scipy
    triangle = sawtooth(2 * np.pi * (1950.0 * at + 0.5), 0.5)
    legs = [0.8 * np.sin(2 * np.pi * (50.0 * at - leg / 3)) >= triangle for leg in range(3)]
    mean = 560.0 * (np.mean(legs, axis=0) - 0.5)
    np.testing.assert_allclose(CommonMode(560.0, 1950.0, 50.0, 0.8)(at), mean, **near)
    constant, table = laws.waveform(at, 0, 3.5, 0.0, 0.0, 0.0, 0.0), Table([1.0, 2.0], [1.0, -4.0])
    assert (constant == 3.5).all() and (Constant(3.5)(at) == 3.5).all()
    assert table([0.0, 1.5, 3.0]).tolist() == [1.0, -1.5, -4.0]


@pytest.mark.parametrize("name", ["rough", "leaking source"])
def test_cases_have_discharges_of_all_kinds(name):
    """Of one film and of more, at either raceway, or the comparison sees little."""
    given, outer, breakdown = CASES[name]
    events = circuit.run(given, outer, breakdown, points=1).events
    assert {1, 2} <= set(events.groupby("discharge").size())
    assert set(events.raceway) == {"inner", "outer"}
