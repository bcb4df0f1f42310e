# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of films without contact in a circuit, and of the films read from a run."""

import numpy as np
import pytest
import raceway
from circuits import MOTOR, PICO, WEAK
from raceway.electric import circuit
from raceway.electric.films import of_dataset, of_run
from raceway.electric.leak import Leak
from raceway.errors import RunError


def test_a_run(folder):
    run = raceway.open(folder)
    result = circuit.run(run, MOTOR, WEAK, Leak(1e9), points=24)
    data = result.data
    np.testing.assert_allclose(
        data.bearing_capacitance[::24], run.bearing["capacitance"], rtol=1e-12
    )
    np.testing.assert_array_equal(data.time[::24], run.contacts.time)
    np.testing.assert_allclose(data.azimuth[::24], run.balls.azimuth, atol=1e-14)
    assert float(data.charge_error.max()) < 1e-13 * 300 * 50 * PICO
    assert set(np.unique(data.film_state)) == {0, 1}


def test_total_capacitance_and_separation_come_first(folder):
    contacts = raceway.open(folder).contacts
    more = contacts.assign(
        capacitance_total=contacts.capacitance + 20 * PICO, separation=contacts.h_c * 0 + 3e-6
    )
    given = of_dataset(more)
    np.testing.assert_array_equal(given.capacitance, more.capacitance_total)
    assert np.nanmax(given.thickness) == 3e-6
    assert (of_dataset(contacts, stray=PICO).capacitance >= PICO).all()


def test_metal_by_the_share_of_asperities(folder):
    contacts = raceway.open(folder).contacts
    share = (contacts["load"] > 1000) * 0.2
    given = of_dataset(contacts.assign(asperity_share=share), Leak(None, metal=5.0, share=0.1))
    np.testing.assert_array_equal(given.conductance, share)
    with pytest.raises(RunError, match="metallic films need the column asperity_share"):
        of_dataset(contacts, Leak(None, metal=5.0))


def test_a_dry_run_has_no_circuit(dry_folder):
    with pytest.raises(RunError, match="a dry run has no films"):
        of_run(raceway.open(dry_folder))
