# SPDX-License-Identifier: GPL-2.0-or-later
"""The circuit of a bearing without breakdown is compared with closed-form solutions. Intermediate
points and leakage are tested too."""

import numpy as np
import pytest
from circuits import MOTOR, PICO, WEAK, films, steady, turning
from raceway.electric import circuit
from raceway.electric.films import series
from raceway.electric.leak import relaxation_time
from raceway.electric.outer import Floating, Source
from raceway.electric.waveforms import Constant, Sine
from references.circuit import STAGE
from scipy.integrate import solve_ivp


def test_current_into_a_capacitance_that_changes():
    """At a constant voltage V, the current into a capacitance C0 (1 + m cos W t) has the amplitude
    V C0 m W."""
    n, mean, depth, speed = 2001, 100 * PICO, 0.3, 2 * np.pi * 50
    time = np.linspace(0, 0.04, n)
    one = 2 * mean * (1 + depth * np.cos(speed * time))  # two equal films in series
    data = circuit.run(films(np.tile(one[:, None, None], (1, 2, 1)), time), Source(Constant(5.0)))
    middle = 0.5 * (time[1:] + time[:-1])
    expected = -5.0 * mean * depth * speed * np.sin(speed * middle)
    largest = 5.0 * mean * depth * speed
    # the mean over a step is sinc(W dt/2) times the value in the middle of the step
    assert np.abs(data.data.current[1:] - expected).max() < largest * (speed * 2e-5) ** 2 / 20
    assert float(np.abs(data.data.current).max()) == pytest.approx(largest, rel=1e-5)


@pytest.mark.parametrize("outer", [MOTOR, Source(Sine(20.0, 900.0)), Floating(12.0)])
def test_without_breakdown_it_is_series_and_parallel(outer):
    given = turning()
    data = circuit.run(given, outer, points=1).data
    ball, bearing = series(given.capacitance)
    driving = outer.waveform(given.time)
    expected = {
        "Motor": driving * 50 * PICO / (1250 * PICO + bearing),
        "Source": driving,
        "Floating": 12.0 * bearing[0] / bearing,
    }[type(outer).__name__]
    scale = np.abs(expected).max()
    np.testing.assert_allclose(data.bearing_voltage, expected, rtol=1e-12, atol=1e-12 * scale)
    if outer is MOTOR:
        ratio = 50 * PICO / (1250 * PICO + bearing)
        np.testing.assert_allclose(data.bearing_voltage_ratio, ratio, rtol=1e-12)
    film = expected[:, None, None] * ball[:, None] / given.capacitance
    np.testing.assert_allclose(data.film_voltage, film, rtol=1e-12, atol=1e-12 * scale)


def test_both_ways_to_solve_agree():
    """With negligible leakage, the staged method gives the same points."""
    plain = circuit.run(turning(), MOTOR, WEAK)
    staged = circuit.run(turning(conductance=1e-30), MOTOR, WEAK)
    assert len(plain.events) > 10 and (plain.events.ball == staged.events.ball).all()
    np.testing.assert_allclose(staged.events.energy, plain.events.energy, rtol=1e-11)
    np.testing.assert_allclose(
        staged.data.ball_voltage, plain.data.ball_voltage, rtol=1e-11, atol=1e-11
    )


def test_points_are_points_of_a_finer_record():
    coarse = turning(n=41)
    fine = circuit.run(coarse.refined(5), MOTOR, points=1).data
    data = circuit.run(coarse, MOTOR, points=5).data
    assert data.sizes["time"] == 201
    np.testing.assert_array_equal(data.bearing_voltage, fine.bearing_voltage)
    np.testing.assert_array_equal(data.film_capacitance[::5], coarse.capacitance)
    np.testing.assert_allclose(
        data.film_capacitance[2::5],
        0.6 * coarse.capacitance[:-1] + 0.4 * coarse.capacitance[1:],
        rtol=1e-14,
    )


def test_a_film_relaxes_with_its_resistivity_times_permittivity():
    tau = relaxation_time(1e9, 2.25)
    given = steady([40 * PICO], [60 * PICO], n=401, time=np.linspace(0, 0.05, 401))
    leaky = films(given.capacitance, given.time, conductance=given.capacitance / tau)
    data = circuit.run(leaky, Floating(10.0)).data
    z = -given.time[1] / tau  # growth per step of the method, an approximation of exp
    growth = (1 + (1 - 2 * STAGE) * z) / (1 - STAGE * z) ** 2
    np.testing.assert_allclose(data.bearing_voltage, 10 * growth ** np.arange(401), rtol=1e-12)
    np.testing.assert_allclose(data.bearing_voltage, 10 * np.exp(-given.time / tau), rtol=5e-6)
    assert (data.film_state == 1).all()


def exact(given, outer):
    """Return the voltages (n,) of the inner ring, computed by scipy's integrator with the charges
    as unknowns; C and G vary linearly between points."""

    def voltages(t, charge):
        at = [
            np.array([[np.interp(t, given.time, one) for one in side.T] for side in values])
            for values in (
                given.capacitance.transpose(1, 0, 2),
                given.conductance.transpose(1, 0, 2),
            )
        ]
        (inner, outer_c), conductance = at
        z = len(inner)
        matrix = np.zeros((z + 1, z + 1))
        matrix[range(z), range(z)] = inner + outer_c
        matrix[:z, z] = matrix[z, :z] = -inner
        matrix[z, z] = inner.sum() + outer.capacitance
        return np.linalg.solve(matrix, charge), conductance

    def flow(t, charge):
        v, conductance = voltages(t, charge)
        leak = conductance * np.array([v[-1] - v[:-1], v[:-1]])
        driven = (outer.waveform(np.array([t]))[0] - v[-1]) / outer.resistance
        return [*(leak[0] - leak[1]), driven - leak[0].sum()]

    start, z = np.zeros(given.capacitance.shape[2] + 1), given.capacitance.shape[2]
    found = solve_ivp(
        flow, given.time[[0, -1]], start, "LSODA", given.time, rtol=1e-10, atol=1e-21, max_step=2e-4
    )
    return np.array([voltages(t, y)[0][z] for t, y in zip(found.t, found.y.T)])


def test_leak_and_resistance_are_of_second_order():
    """If the step is halved, the difference from scipy's integrator falls to a quarter."""
    outer = Source(Sine(10.0, 150.0), 2e7, 20 * PICO)
    coarse = turning(n=41, z=2)
    tau = np.array([4e-3, 7e-3]).reshape(1, 2, 1)
    coarse = films(coarse.capacitance, conductance=coarse.capacitance / tau)
    reference = exact(coarse, outer)
    errors = []
    for points in (2, 4, 8):
        data = circuit.run(coarse, outer, points=points).data
        errors.append(np.abs(data.bearing_voltage.to_numpy()[::points] - reference).max())
    assert errors[0] < 0.01 * np.abs(reference).max()
    # the kinks of C(t) coincide with time points, so they do not reduce the order
    assert [a / b for a, b in zip(errors, errors[1:])] == pytest.approx([4, 4], abs=0.6)


def test_a_metal_contact_shorts_its_film_without_ringing():
    """R C is 1 ps, whereas the time steps are 50 us."""
    given = steady([50 * PICO] * 2, [80 * PICO] * 2, n=11)
    conductance = np.zeros((11, 2, 2))
    conductance[5:, 1, 0] = 10.0
    data = circuit.run(films(given.capacitance, conductance=conductance), Floating(10.0)).data
    film = data.film_voltage.to_numpy()
    shorted = np.abs(film[5:, 1, 0])
    assert (shorted < 1e-5).all()
    assert (np.diff(shorted) <= 1e-17).all()  # except for the rounding errors of 10 V
    # the two films of ball 2 still share its voltage in inverse proportion to their capacitances
    np.testing.assert_allclose(film[:, 1, 1] / film[:, 0, 1], 50 / 80, rtol=1e-12)
