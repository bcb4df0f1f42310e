# SPDX-License-Identifier: GPL-2.0-or-later
"""In ngspice, the exported element gives the same voltages and currents as the network."""

import ngspice
import numpy as np
import pytest
import raceway
from circuits import films, turning
from commands import reply
from raceway.electric import circuit, spice
from raceway.electric.films import of_run, series
from raceway.electric.leak import Leak
from raceway.electric.outer import Motor, Source
from raceway.electric.waveforms import CommonMode, Sine, Table

OPTIONS = ".options reltol=1e-6 abstol=1e-19 vntol=1e-9 chgtol=1e-19\n"
WITHIN = 1e-3
# s, R C of both films; the values differ, so balls become charged
TAU = np.array([4e-3, 7e-3]).reshape(1, 2, 1)


@pytest.fixture(scope="module")
def leaky():
    given = turning(n=41, z=9)
    return films(given.capacitance, conductance=given.capacitance / TAU)


def compare(given, outer, lines, tmp_path, wanted, step=4e-6):
    """Run the netlist `lines` with the element for `given`, and compare the vectors `wanted`, named
    as in ngspice, with the dataset of the circuit."""
    tran = f".tran {step:g} {given.time[-1]:g} 0 {step:g} uic\n"
    found = ngspice.run(
        f"test\n{spice.element(given)}\n{lines}\n{OPTIONS}{tran}.end\n", tmp_path, list(wanted)
    )
    data = circuit.run(given, outer, points=20).data
    for name, select in wanted.items():
        ours = select(data)
        theirs = np.interp(ours.time, found["time"], found[name])
        assert np.abs(theirs - ours).max() < WITHIN * np.abs(ours).max(), name


def test_motor(leaky, tmp_path):
    compare(
        leaky,
        Motor(Sine(300.0, 500.0), 50e-12, 1e-9),
        "Vcm cm 0 SIN(0 300 500)\nCwr cm rotor 50p\nCrf rotor 0 1n\nX1 rotor 0 bearing",
        tmp_path,
        {
            "rotor": lambda data: data.bearing_voltage,
            "x1.ball3": lambda data: data.ball_voltage.sel(ball=3, drop=True),
            "x1.ball8": lambda data: data.ball_voltage.sel(ball=8, drop=True),
        },
    )


def test_inverter(leaky, tmp_path):
    """Each switching edge of the inverter legs takes 5 ns."""
    wave = CommonMode(560.0, 1530.0, 47.0, 0.9)
    edges = wave.edges(leaky.time)
    corners = [f"{t:.12g} {before:.9g} {t + 5e-9:.12g} {after:.9g}" for t, before, after in edges]
    compare(
        leaky,
        Motor(wave, 50e-12, 1e-9),
        f"Vcm cm 0 PWL(0 {wave(0.0):.9g}\n+ " + "\n+ ".join(corners) + ")\n"
        "Cwr cm rotor 50p\nCrf rotor 0 1n\nX1 rotor 0 bearing",
        tmp_path,
        {
            "rotor": lambda data: data.bearing_voltage,
            "x1.ball3": lambda data: data.ball_voltage.sel(ball=3, drop=True),
        },
    )


def test_source_with_a_resistance(tmp_path):
    """Without leakage, the balls remain uncharged, and a single element for the whole bearing gives
    the same voltage."""
    outer = Source(Table([0, 1e-3, 2e-3, 6e-3], [0, 10, -10, 5]), 2e6)
    for element in ("bearing", "bearing_total"):
        compare(
            turning(n=41, z=4),
            outer,
            f"Vs s 0 PWL(0 0 1m 10 2m -10 6m 5)\nRs s ring 2meg\nX1 ring 0 {element}",
            tmp_path,
            {"ring": lambda data: data.bearing_voltage},
        )


def test_current_of_moving_plates(tmp_path):
    """At constant voltage, the current is i = V dC/dt; a capacitor that is defined only by its
    capacitance would omit this current."""
    given = turning(n=41, z=5)
    # the trapezoidal rule oscillates after the start
    tran = ".options method=gear\n.tran 2e-6 0.01 0 2e-6 uic\n"
    lines = "Vs ring 0 PWL(0 0 1m 6)\nX1 ring 0 bearing"
    found = ngspice.run(
        f"test\n{spice.element(given)}\n{lines}\n{OPTIONS}{tran}.end\n", tmp_path, ["vs#branch"]
    )
    data = circuit.run(given, Source(Table([0, 1e-3], [0, 6])), points=20).data
    middle = (data.time[1:] + data.time.values[:-1]) / 2  # away from the kinks
    theirs = -np.interp(middle, found["time"], found["vs#branch"])
    ours = data.current.to_numpy()[1:]
    later = data.time[1:] > 1.1e-3
    assert np.abs(theirs - ours)[later].max() < WITHIN * np.abs(ours[later]).max()


def test_files_of_a_run(folder, tmp_path, capsys):
    out = tmp_path / "spice"
    command = ["export", str(folder), "--format", "spice", "--every", "2", "--resistivity", "1e9"]
    assert reply(capsys, [*command, "--out", out]) == f"{out / 'bearing.cir'}\n"
    given = of_run(raceway.open(folder), Leak(1e9)).every(2)
    assert (out / "bearing.cir").read_text() == spice.element(given)
    lines = (out / "bearing.pwl").read_text()
    assert lines.startswith("# time_s capacitance_F leak_ohm\n")
    time, capacitance, leak = np.loadtxt(lines.splitlines()).T
    np.testing.assert_array_equal(time, raceway.open(folder).contacts.time[::2])
    np.testing.assert_array_equal(capacitance, series(given.capacitance).bearing)
    # in a uniform lubricant, R C has the same value for every film and for all films together
    np.testing.assert_allclose(leak * capacitance, 1e9 * 8.8541878128e-12 * 2.2, rtol=1e-12)


def test_resistivity_is_for_spice(folder, capsys):
    assert "--resistivity applies to --format spice" in reply(
        capsys, ["export", folder, "--format", "xyz", "--resistivity", "1e9"], code=2
    )
