# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway electric DIR`: the results for a run, its table, pictures and messages."""

import csv

import numpy as np
import pytest
import raceway
from commands import answer, drawn, reply
from raceway import film_figures, film_table, film_voltage, whole_capacitance
from raceway.theory.capacitors import Filling
from raceway.theory.electric_point import Ask

ALL = "--frequency 1e4 --resistivity 1e9 --voltage 5 --c-wr 50e-12 --c-rf 1e-9".split()
ASK = Ask(voltage=5.0, frequency=1e4, resistivity=1e9, motor=(50e-12, 1e-9))


def printed(capsys, *arguments):
    return reply(capsys, ["electric", *arguments])


def figures(capsys, *arguments):
    return answer(capsys, ["electric", *arguments])


def test_figures(folder, capsys):
    found = figures(capsys, folder, *ALL)
    run = raceway.open(folder)
    whole = whole_capacitance.over_time(run)
    data = film_figures.over_time(run, whole, ASK)
    fields = whole_capacitance.fields(run, whole, 5.0)
    assert found == film_table.figures(run, data, fields, 1e4)
    parts = ("capacitance_F", "capacitance_surroundings_F", "capacitance_unloaded_F")
    assert sum(found[part] for part in parts) == pytest.approx(found["capacitance_total_F"])
    assert found["capacitance_total_min_F"] < found["capacitance_total_max_F"]
    assert found["field_V_m"] == pytest.approx(float(np.abs(fields["field"]).max()))
    assert found["threshold_V"] == float(data["threshold"].min()) < found["threshold_mean_V"]
    first = int(data["threshold"].to_numpy().argmin())
    hangs = 1050e-12 + 2 * float(data["bearing"][first])  # as for the bearing voltage ratio
    assert found["stored_energy_J"] == pytest.approx(
        film_voltage.stored_energy(hangs, found["threshold_V"])
    )
    # films are thinnest under the load
    assert abs(found["threshold_azimuth_deg"]) < 45
    both = 2 * data["bearing"].to_numpy()
    assert found["bearing_voltage_ratio"] == pytest.approx(np.mean(50e-12 / (1050e-12 + both)))


def test_json_alone_on_stdout(folder, capsys, tmp_path):
    table, picture = tmp_path / "a.csv", tmp_path / "a.png"
    wanted = ["--csv", table, "--kind", "parts", "--out", picture]
    figures(capsys, folder, *wanted)
    assert table.exists() and picture.exists()


def test_what_is_not_asked_for_is_not_there(folder, capsys):
    found = figures(capsys, folder)
    for key in ("leak_ohm", "impedance_ohm", "phase_deg", "field_V_m", "bearing_voltage_ratio"):
        assert found[key] is None, key
    text = printed(capsys, folder)
    assert "balls without load" in text and "Impedance" not in text


def test_peaks_that_meet(folder, capsys):
    """The text names a film that its peaks bridge, as that of an operating point does."""
    found = figures(capsys, folder) | {"threshold_peaks_V": 0.0}
    (row,) = (one for one in film_table.table(found).splitlines() if "voltage, rough" in one)
    assert "bridged" in row and "0 V" not in row


def test_another_filling(folder, capsys):
    dry = figures(capsys, folder, "--surroundings", "dry")
    whole = whole_capacitance.over_time(raceway.open(folder), Filling("dry"))
    assert dry["surroundings"] == "dry"
    assert dry["capacitance_total_F"] == pytest.approx(float(whole["bearing"].mean()))
    wet = figures(capsys, folder)
    assert wet["surroundings"] == "flooded"
    assert wet["capacitance_total_F"] > dry["capacitance_total_F"]
    mean = figures(capsys, folder, "--permittivity-at", "mean")
    assert mean["surroundings"] == "flooded" and mean["capacitance_F"] < wet["capacitance_F"]


def test_table(folder, capsys, tmp_path):
    path = tmp_path / "electric.csv"
    printed(capsys, folder, *ALL, "--csv", path)
    with open(path) as file:
        rows = list(csv.DictReader(file))
    run = raceway.open(folder)
    data = film_figures.over_time(run, whole_capacitance.over_time(run), ASK)
    assert set(film_figures.MEANING) <= set(rows[0]) and len(rows) == data.sizes["time"]
    for name in film_figures.MEANING:
        assert [float(row[name]) for row in rows] == pytest.approx(data[name].to_numpy())


@pytest.mark.parametrize("kind", ["parts", "field", "bode"])
def test_pictures(folder, capsys, tmp_path, kind):
    out = tmp_path / "picture.png"
    shown = printed(capsys, folder, *ALL, "--kind", kind, "--out", out)
    assert shown.splitlines()[-1] == str(out)
    drawn(out)


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["--load", "5"], 2, "--load is part of the run"),
        (["--measured-impedance", "1", "-90"], 2, "--measured-impedance is part of the run"),
        (["--kind", "reading", "--out", "x.png"], 2, "applies to an operating point, not to a run"),
        (["--bearing", "6208"], 1, "6208"),
        (["--bearing", "one"], 2, "--bearing is one, must be a number for a run"),
    ],
)
def test_messages(folder, capsys, arguments, code, message):
    assert message in reply(capsys, ["electric", folder, *arguments], code)


def test_a_dry_run_has_none(dry_folder, capsys):
    assert "capacitance" in reply(capsys, ["electric", dry_folder], code=1)
