# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway circuit`: its results, tables and picture."""

import numpy as np
import pandas as pd
import pytest
import raceway
from commands import answer, drawn, reply
from raceway.cli import main
from raceway.electric import circuit, circuit_figures
from raceway.electric.breakdown import Breakdown
from raceway.electric.leak import Leak
from raceway.electric.outer import Floating, Motor, Source
from raceway.electric.waveforms import CommonMode, Constant, Sine

LOCAL = "--roughness 2e-7 --film-floor 3e-9".split()
MOTOR = ["--motor", "50e-12", "1e-9", "--common-mode", "560", "300", "50", "0.8"]


@pytest.mark.parametrize(
    "words, outer, breakdown, leak",
    [
        (
            [*MOTOR, "--second-factor", "1", "--strength", "30e6", "--surfaces", "smooth"],
            Motor(CommonMode(560, 300, 50, 0.8), 50e-12, 1e-9, second_factor=1.0),
            Breakdown(30e6, "smooth"),
            None,
        ),
        (
            ["--source", "1e6", "--sine", "3", "100", "--resistivity", "1e9"],
            Source(Sine(3, 100), 1e6),
            None,
            Leak(1e9),
        ),
        (
            [*"--floating 5 --background 20e-12 --strength 1e7".split(), *LOCAL],
            Floating(5.0, 20e-12),
            Breakdown(1e7, "rough", 3e-9, 2e-7),
            None,
        ),
    ],
)
def test_json(folder, capsys, words, outer, breakdown, leak):
    found = circuit.run(raceway.open(folder), outer, breakdown, leak)
    assert answer(capsys, ["circuit", folder, *words]) == circuit_figures.figures(found)


def test_figures(folder):
    result = circuit.run(
        raceway.open(folder), Source(Constant(20.0), 1e7), Breakdown(30e6, "smooth")
    )
    found, events = circuit_figures.figures(result), result.events
    per_discharge = events.groupby("discharge").energy.sum()
    assert found["discharges"] == events.discharge.max() > 2
    assert found["failed_inner"] + found["failed_outer"] == len(events)
    assert found["discharge_energy_J"] == pytest.approx(events.energy.sum(), rel=1e-12)
    assert found["energy_max_J"] == per_discharge.max()
    assert found["bearing_voltage_max_V"] == events.bearing_voltage.max()
    assert found["field_max_V_m"] == events.field.max() > 30e6
    assert found["floor_share"] == 0
    # films are thinnest under the load
    assert abs(found["place_rad"]) < 0.5
    assert found["bearing_voltage_ratio_mean"] is None
    text = circuit_figures.table(found)
    assert f"number {found['discharges']}" in " ".join(text.split())
    assert "Bearing voltage ratio" not in text


def test_films_at_the_floor(folder):
    """At 477.5 rpm, the films are thinner than three times the roughness, so their local thickness
    is at the floor."""
    run = raceway.open(folder)
    data, _ = result = circuit.run(run, Source(Constant(20.0), 1e7), Breakdown(30e6, floor=2e-9))
    thin = (run.contacts.h_c <= 3 * 1.5e-7 + 2e-9).sum() / run.contacts.h_c.notnull().sum()
    figures = circuit_figures.figures(result)
    np.testing.assert_array_equal(data.local_field.notnull(), data.local_thickness > 2e-9)
    assert (result.events.field.isna() == (result.events.local_thickness == 2e-9)).all()
    assert figures["threshold_min_V"] == 0
    assert "least                                  bridged" in circuit_figures.table(figures)
    found = figures["floor_share"]
    assert found == pytest.approx(float(thin)) and found > 0.5
    assert float(data.local_thickness.min()) == 2e-9


def test_files(folder, tmp_path, capsys):
    out = tmp_path / "circuit"
    words = ["--source", "1e7", "--constant", "20", "--strength", "30e6", "--surfaces", "smooth"]
    assert reply(capsys, ["circuit", folder, *words, "--out", out]).startswith("Time\n  simulated")
    result = circuit.run(
        raceway.open(folder), Source(Constant(20.0), 1e7), Breakdown(30e6, "smooth")
    )
    events = pd.read_csv(out / "events.csv")
    np.testing.assert_array_equal(events["energy (J)"], result.events.energy)
    assert events["raceway"].tolist() == result.events.raceway.tolist()
    table = pd.read_csv(out / "circuit.csv")
    np.testing.assert_array_equal(table["bearing_voltage (V)"], result.data.bearing_voltage)
    column = table["film_capacitance outer 4 (F)"]
    np.testing.assert_array_equal(column, result.data.film_capacitance[:, 1, 3])
    drawn(out / "discharges.png")


def test_a_map_without_discharges(folder, tmp_path):
    words = ["--source", "1e7", "--constant", "1", "--strength", "1e9", "--out", str(tmp_path)]
    assert main(["circuit", str(folder), *words]) == 0
    assert (tmp_path / "discharges.png").stat().st_size > 10_000
    assert (tmp_path / "events.csv").read_text().count("\n") == 1


@pytest.mark.parametrize(
    "words, message",
    [
        (["--motor", "50e-12", "1e-9"], "give the voltage: --constant, --sine"),
        (["--floating", "5", "--constant", "1"], "--floating excludes a voltage"),
        (["--source", "1", "--sine", "3", "-1"], "--sine: -1 is out of range"),
        (["--source", "0", "--constant", "3", "--strength", "1e7"], "give it a resistance"),
        (["--source", "1", "--sine", "3", "1e5", "--points", "1"], "points = 1 must be at"),
        (["--constant", "1"], "one of the arguments --motor --source --floating is required"),
        (["--source", "1", "--constant", "1", "--strength", "1"], "1 is out of range"),
    ],
)
def test_bad_command_line(folder, capsys, words, message):
    assert message in reply(capsys, ["circuit", folder, *words], code=2)


def test_a_table_that_is_none(folder, tmp_path, capsys):
    path = tmp_path / "none.txt"
    assert f"{path} is not a table of seconds and volts" in reply(
        capsys, ["circuit", folder, "--source", "1", "--table", path], code=1
    )
