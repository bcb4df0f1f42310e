# SPDX-License-Identifier: GPL-2.0-or-later
"""The overview shows the right values for every kind of run."""

import matplotlib.image
import numpy as np
import pytest
import synthetic
from raceway.errors import RunWarning
from raceway.pictures import overview as plot
from raceway.pictures import part
from raceway.runs.tables import RunTables


def drawn(panel, colour):
    """Return all points of the lines with the given colour as an array of shape (n, 2)."""
    lines = [np.column_stack(line.get_data()) for line in panel.lines if line.get_color() == colour]
    points = np.concatenate(lines).astype(float)
    return points[~np.isnan(points).any(axis=1)]


def test_lubricated(folder, lubricated, tmp_path, panels):
    out = tmp_path / "picture.png"
    run = RunTables(folder)
    plot.overview(run, out)
    height, width, _ = matplotlib.image.imread(out).shape
    assert width >= 1200 and height >= 1200
    axes = panels()
    assert set(axes) == {
        "Contact load around the ring",
        "Film thickness around the ring",
        "Hertz pressure",
        "Capacitance of the contact ellipses",
    }
    load = drawn(axes["Contact load around the ring"], plot.COLOUR[0])
    expected = [row[6] for frame in lubricated["contacts"] for row in frame if row[2] == 0]
    # loads of all balls in all samples, in kN
    assert np.sort(load[:, 1]) == pytest.approx(np.sort(expected) / 1e3)
    heaviest = load[np.argmax(load[:, 1])]
    assert np.cos(heaviest[0]) > 0.99  # on the load line
    total = drawn(axes["Capacitance of the contact ellipses"], plot.INK)
    assert total[:, 0] == pytest.approx(np.arange(49) / 24)
    assert total[:, 1] == pytest.approx(run.bearing_capacitance * 1e12)
    pressure = drawn(axes["Hertz pressure"], plot.COLOUR[1])
    assert np.all(np.abs(pressure[:, 0]) <= 180)


def test_lost_contact_breaks_the_line(tmp_path, panels):
    """During twelve passes, balls return to the load zone, but no line is drawn across the unloaded
    zone."""
    data = synthetic.run(clearance=1e-5, passes=12, samples_per_pass=8)
    plot.overview(RunTables(synthetic.write(tmp_path / "long", data)), tmp_path / "long.png")
    panel = panels()["Contact load around the ring"]
    steps = np.concatenate([np.diff(line.get_xdata()) for line in panel.lines])
    assert np.isnan(steps).any()
    # the change in azimuth between two consecutive samples of one ball
    assert np.nanmax(np.abs(steps)) == pytest.approx(2 * np.pi / 9 / 8, rel=1e-6)


def test_dry(dry_folder, tmp_path, panels):
    plot.overview(RunTables(dry_folder), tmp_path / "dry.png")
    assert set(panels()) == {
        "Contact load around the ring",
        "Hertz pressure",
        "Radial displacement along the load",
    }


def test_ball_that_goes_round_more_than_once(tmp_path, panels):
    data = synthetic.run(clearance=-4e-5, passes=12, samples_per_pass=8)
    plot.overview(RunTables(synthetic.write(tmp_path / "long", data)), tmp_path / "long.png")
    pressure = panels()["Hertz pressure"]
    for line in pressure.lines:
        assert not np.any(np.abs(np.diff(line.get_xdata())) > 90)  # no line runs across the panel


def test_large_run_is_drawn_in_part(folder, tmp_path, panels, monkeypatch):
    monkeypatch.setattr(part, "LARGE", 1000)
    monkeypatch.setattr(part, "PASSES", 1)
    with pytest.warns(RunWarning, match="shows its first 1 ball passes; the results are for all"):
        plot.overview(RunTables(folder), tmp_path / "part.png")
    axes = panels()["Capacitance of the contact ellipses"]
    assert drawn(axes, plot.INK)[:, 0] == pytest.approx(np.arange(24) / 24)
