# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the input to the circuit: voltages as functions of time, and input that is rejected."""

import warnings

import numpy as np
import pytest
from circuits import turning
from raceway.electric import circuit
from raceway.electric.breakdown import Breakdown
from raceway.electric.leak import Leak
from raceway.electric.outer import Floating, Motor, Source
from raceway.electric.waveforms import CommonMode, Constant, Sine, Table, read_table
from raceway.errors import RunError

WEAK = Breakdown(30e6)


def test_common_mode_has_four_levels():
    time = np.linspace(0, 0.1, 20001)
    voltage = CommonMode(600.0, 1050.0, 50.0, 0.9)(time)
    assert np.allclose(np.unique(voltage.round(9)), [-300, -100, 100, 300])
    # without modulation, all inverter legs switch together, and each leg is high for half of the
    # time
    plain = CommonMode(600.0, 1000.0, 50.0, 0.0)(time + 1e-7)
    assert set(np.unique(plain)) == {-300, 300} and abs(plain.mean()) < 1


def test_table_from_a_file(tmp_path):
    path = tmp_path / "table.txt"
    path.write_text("# s V\n0 1\n1e-3 3\n")
    assert read_table(path)(np.array([-1, 5e-4, 2])).tolist() == [1, 2, 3]
    path.write_text("0 1\n1e-3 3\n1e-3 4\n")
    with pytest.raises(RunError, match="times in a table must increase: row 3"):
        read_table(path)
    path.write_text("0 1 2\n")
    with pytest.raises(RunError, match="3 columns, not 2"):
        read_table(path)
    path.write_text("# s V\n")
    with warnings.catch_warnings(), pytest.raises(RunError, match="it has no rows"):
        warnings.simplefilter("error")
        read_table(path)


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: Sine(1.0, 0.0), "frequency = 0 Hz must be positive"),
        (lambda: CommonMode(1.0, 1e3, 50.0, 1.2), "modulation = 1.2 must lie from 0 to 1"),
        (lambda: Table([0, 1], [1]), "two columns with at least two rows"),
        (lambda: Source(Constant(1.0), -1.0), "resistance = -1 ohm must be 0 or more"),
        (lambda: Motor(Constant(1.0), 0.0, 1e-9), "winding_rotor = 0 F must be positive"),
        (lambda: Motor(Constant(1.0), 1e-12, 1e-9, 1e-12, 1.0), "not both"),
        (lambda: Breakdown(0.0), "strength = 0 V/m must be positive"),
        (lambda: Breakdown(1e6, "wavy"), "surfaces = 'wavy' must be rough or smooth"),
        (lambda: Leak(-1.0), "resistivity = -1 ohm m must be positive"),
        (lambda: Leak(share=1.0), "share = 1 must be at least 0 and below 1"),
        (lambda: circuit.run(turning(), Floating(), points=0), "points = 0 must be a positive"),
        (lambda: circuit.run(turning(), Source(Constant(1.0)), WEAK), "give it a resistance"),
        (
            lambda: circuit.run(turning(n=11), Source(Sine(1.0, 1e3)), points=1),
            "points = 1 must be at least 8: a sample takes 0.001 s",
        ),
        (lambda: circuit.run(turning(), Floating(), stray=1e-12), "included in the given films"),
        (lambda: Sine(1e300, 50.0), "amplitude = 1e\\+300 V must lie from -1e\\+06 to 1e\\+06"),
        (lambda: Sine(1.0, np.inf), "frequency = inf Hz must be positive"),
        (lambda: CommonMode(np.nan, 1e3, 50.0, 1.0), "link = nan V must lie"),
        (lambda: CommonMode(1.0, 90.0, 50.0, 1.0), "carrier = 90 Hz must be at least twice"),
        (lambda: Table([0, 1], [1e7, 0]), "voltages must lie from"),
        (
            lambda: circuit.run(turning(), Source(Table([5, 6], [0, 1]))),
            "table's times, 5 to 6 s, must overlap the times of the films, 0 to 0.01 s",
        ),
        (lambda: circuit.run(turning(), Source(Sine(1.0, 1e12))), "exceed the limit of 1e\\+08"),
    ],
)
def test_bad_input(make, message):
    with pytest.raises(ValueError, match=message):
        make()
