# SPDX-License-Identifier: GPL-2.0-or-later
"""Values are read correctly from a run folder with known contents."""

from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest
import synthetic
from raceway import capacitance, static
from raceway.errors import RunError
from raceway.inputs import Oil
from raceway.paper import theory
from raceway.paper.reading import Reading, endplay
from raceway.theory.bearing import INNER, OUTER

OIL = Oil(*synthetic.OIL.values())
GAP = 1e-5  # m, clearance of the run in the folder


@pytest.fixture
def reading(folder):
    return Reading(SimpleNamespace(given={"load": 5000}), folder)


def test_around(reading, bearing):
    psi, load = reading.around(OUTER, "load")
    # with clearance, the load zone covers less than half of the ring
    assert np.all(np.diff(psi) >= 0) and -95 < psi[0] < -60 and 60 < psi[-1] < 95
    rest = static.equilibrium(bearing, 5000.0, clearance=GAP, phase=0.0)
    # 0.2 % is the error of linear interpolation with 24 samples per ball pass
    assert reading.top(OUTER, "load") == pytest.approx(rest.outer.load[0], rel=2e-3)
    assert load.max() <= rest.outer.load[0] * (1 + 1e-9)


def test_capacitance_and_permittivity(reading, bearing):
    speed = reading.figures["entrainment_speed_m_s"]
    assert reading.top_capacitance() == pytest.approx(
        float(theory.ball(bearing, OIL, reading.top(INNER, "load"), speed)), rel=1e-3
    )
    psi, value = reading.permittivity(INNER)
    assert value == pytest.approx(
        capacitance.permittivity(OIL.permittivity, reading.around(INNER, "pressure")[1]), rel=1e-9
    )
    assert np.array_equal(psi, reading.around(INNER, "load")[0])


def test_loaded_balls(reading):
    balls = reading.loaded_balls()
    assert len(balls) == 49 and set(balls) <= {3, 4, 5}
    assert balls.mean() == pytest.approx(reading.figures["loaded_balls_mean"], rel=1e-12)


def test_coulomb_use(reading):
    contacts = reading.tables.contacts
    contacts["friction"], contacts["mu"] = 0.0, 0.1
    contacts.loc[7, "friction"] = -0.06 * contacts.loc[7, "normal"]
    assert reading.coulomb_use() == pytest.approx(0.6, rel=1e-12)


def test_cage_contact_share(reading):
    """Cage balls are half-way between the balls, and in every sample one of them touches its
    neighbour."""
    angle, count = 2 * np.pi * np.arange(9) / 9, 9

    def places(turn, push):
        ring = angle + turn
        ring[0] += push
        return np.column_stack(
            [np.full(9, 1), 30.3e-3 * np.cos(ring), 30.3e-3 * np.sin(ring), np.zeros(9)]
        )

    half = np.pi / 9
    gap = 2 * 30.3e-3 * np.sin(half / 2) - 6.3e-3 - 4.19e-3  # 33 um
    rows = [
        (sample, at + 1 + 9 * (kind - 1), kind, *place[1:])
        for sample in range(2)
        for kind, turn, push in ((1, 0.0, 0.0), (2, half, 1.1 * gap / 30.3e-3))
        for at, place in enumerate(places(turn, push))
    ]
    reading.tables.balls = pd.DataFrame(rows, columns=["sample", "id", "type", "x", "y", "z"])
    assert reading.cage_contact_share(6.3e-3, 4.19e-3) == pytest.approx(1 / (2 * count), rel=1e-12)


def test_endplay(tmp_path):
    (tmp_path / "screen.txt").write_text(
        "free contact angle 12.5 degrees, theory 12\nfree endplay 4.2e-4 m, theory 4e-4\n"
    )
    assert endplay(tmp_path) == (12.5, 4.2e-4)
    (tmp_path / "screen.txt").write_text("free contact angle 12.5 degrees, theory 12\n")
    with pytest.raises(RunError, match="screen.txt has no free contact angle and endplay"):
        endplay(tmp_path)
