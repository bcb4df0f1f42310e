# SPDX-License-Identifier: GPL-2.0-or-later
"""The picture of the ring's motion is drawn, with a title that describes the simulated run."""

import numpy as np
import pytest
import synthetic
from raceway.pictures import motion as plot
from raceway.pictures.page import title
from raceway.runs.tables import RunTables


def test_panels(folder, lubricated, tmp_path, panels):
    plot.motion(RunTables(folder), tmp_path / "motion.png")
    orbit, displacement, torque, _ = panels().values()
    rings = np.array(lubricated["rings"])
    x, y = orbit.lines[0].get_data()
    assert np.ptp(x) > 0 and np.ptp(y) > 0
    assert np.ptp(x) / np.ptp(y) == pytest.approx(np.ptp(rings[:, 2]) / np.ptp(rings[:, 3]))
    along = next(line for line in displacement.lines if line.get_ydata().min() < -1)
    assert along.get_ydata() == pytest.approx(rings[:, 3] * 1e6)
    assert along.get_xdata() == pytest.approx(np.arange(len(rings)) / 24)
    assert np.sign(torque.lines[0].get_ydata()).tolist() == [1.0] * len(rings)
    largest = np.abs(rings[:, 14]).max()
    assert torque.lines[0].get_ydata() / np.abs(torque.lines[0].get_ydata()).max() == pytest.approx(
        -rings[:, 14] / largest
    )


@pytest.mark.parametrize(
    "force, says",
    [
        (lambda k: (0, 4000, 0), ["4 kN radial"]),
        (lambda k: (0, 4000, -1500), ["4 kN radial", "1.5 kN axial"]),
        (lambda k: (0, 1, 1500), ["−1.5 kN axial"]),
        (lambda k: (500 * np.sin(k), 500 * np.cos(k), 0), ["500 N turning radial load"]),
    ],
)
def test_title_says_what_was_measured(folder, lubricated, force, says):
    rings = [[*row[:9], *force(k), *row[12:]] for k, row in enumerate(lubricated["rings"])]
    parts = title(RunTables(synthetic.write(folder, dict(lubricated, rings=rings)))).split("  ·  ")
    assert parts[1:-3] == says and parts[-3] == "477.5 rpm"


def test_title_of_a_ramp(folder, lubricated):
    rings = [[*row[:8], 10 + k, *row[9:]] for k, row in enumerate(lubricated["rings"])]
    text = title(RunTables(synthetic.write(folder, dict(lubricated, rings=rings))))
    assert f"{11 * 30 / np.pi:.4g} to {(9 + len(rings)) * 30 / np.pi:.4g} rpm" in text
