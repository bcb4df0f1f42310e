# SPDX-License-Identifier: GPL-2.0-or-later
"""In the circuit of a bearing, charge is conserved and energy balances."""

import numpy as np
import pytest
from circuits import CASES, PICO, turning
from raceway.electric import circuit
from raceway.electric.films import series
from raceway.electric.outer import Floating, Motor, Source
from raceway.electric.waveforms import Sine


@pytest.mark.parametrize("name", [name for name in CASES if name != "open film"])
def test_charge_is_conserved(name):
    """The charges transported by the currents equal the charges calculated from the voltages, to
    rounding error."""
    given, outer, breakdown = CASES[name]
    result = circuit.run(given, outer, breakdown, points=1)
    assert breakdown is None or len(result.events)
    film = result.data.film_voltage.to_numpy()
    largest = np.abs(given.capacitance * film).max() + 300 * 50 * PICO * isinstance(outer, Motor)
    assert float(result.data.charge_error.max()) < 1e-13 * largest


@pytest.mark.parametrize("name", [name for name in CASES if name != "open film"])
def test_energy_is_balanced(name):
    given, outer, breakdown = CASES[name]
    data = circuit.run(given, outer, breakdown, points=1).data
    assert float(np.abs(data.energy_error).max()) < 1e-13 * float(data.stored_energy.max())
    end = data.isel(time=-1)
    out = end.leak_heat + end.resistor_heat + end.discharge_energy + end.stored_energy
    into = float(end.source_work + end.mechanical_work)
    before = float(data.stored_energy[0] + data.discharge_energy[0] - data.source_work[0])
    assert float(out) == pytest.approx(into + before, rel=1e-9)
    if breakdown:
        assert float(end.discharge_energy) > 0
    if given.leaking:
        assert float(end.leak_heat) > 0


def test_each_term_of_the_energy_is_of_second_order():
    """The errors are taken relative to solutions with 32 and 64 times as many steps, because the
    energy balance itself is satisfied identically."""
    given = turning(n=41, z=3, conductance=2e-9)
    outer = Source(Sine(10.0, 150.0), 1e6)
    names = ["source_work", "mechanical_work", "leak_heat", "resistor_heat"]
    ends = {
        m: circuit.run(given, outer, points=m).data[names].isel(time=-1).to_array()
        for m in (4, 8, 256)
    }
    error = {m: np.abs(ends[m] - ends[256]).to_numpy() for m in (4, 8)}
    assert (error[4] < 2e-3 * np.abs(ends[256])).all()
    np.testing.assert_allclose(error[4] / error[8], 4.0, atol=0.5)


def test_work_of_moving_plates():
    """The energy Q^2/2C of a charged, isolated ring increases by the work required to move the
    plates."""
    given = turning()
    data = circuit.run(given, Floating(10.0)).data
    bearing = series(given.capacitance).bearing
    energy = 0.5 * (10 * bearing[0]) ** 2 / bearing
    np.testing.assert_allclose(data.stored_energy, energy, rtol=1e-12)
    np.testing.assert_allclose(data.mechanical_work, energy - energy[0], atol=1e-12 * energy.max())
