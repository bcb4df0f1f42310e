# SPDX-License-Identifier: GPL-2.0-or-later
"""A run is opened in MDAnalysis. Every column of every frame has double precision, because single
precision would lose too many digits."""

import pickle

import numpy as np
import pytest
import raceway
import synthetic
from bearings import B6208
from MDAnalysis.analysis.base import AnalysisFromFunction
from raceway.runs import universe as module


@pytest.fixture
def run(folder, monkeypatch):
    # 7 frames are read at once, so 49 frames need several reads
    monkeypatch.setattr(module, "ROWS", 7 * 20)
    return raceway.open(folder)


def test_atoms(run):
    u = run.universe()
    assert len(u.atoms) == 20 and len(u.trajectory) == 49
    assert u.atoms.ids.tolist() == list(range(1, 21))
    assert u.select_atoms("name ball").ids.tolist() == list(range(1, 10))
    assert u.select_atoms("name inner or name outer").types.tolist() == ["3", "4"]


def test_every_frame_in_any_order(run):
    u, balls, contacts = run.universe(), run.tables.balls, run.contacts
    for frame in [*range(49), 3, 40, 7, 6, 47, 0]:
        ts = u.trajectory[frame]
        rows = balls[balls["sample"] == frame].sort_values("id")
        assert ts.frame == ts.data["sample"] == frame and ts.data["step"] == 100 * frame
        assert ts.time == pytest.approx(frame * run.settings["sample_s"], rel=1e-15)
        for name, columns in (
            ("position", "x y z"),
            ("velocity", "vx vy vz"),
            ("spin", "omegax omegay omegaz"),
        ):
            assert np.array_equal(ts.data[name], rows[columns.split()])
        assert np.array_equal(u.atoms.positions, ts.data["position"].astype(np.float32))
        assert np.array_equal(u.atoms.velocities, ts.data["velocity"].astype(np.float32))
        for side in ("inner", "outer"):
            here = contacts.sel(raceway=side).isel(time=frame)
            for name in "load pressure h_min lambda capacitance azimuth overlap".split():
                values = ts.data[f"{name}_{side}"]
                assert values.dtype == np.float64 and len(values) == 20
                assert np.array_equal(values[:9], here[name], equal_nan=True)
                assert set(np.nan_to_num(values[9:])) == {0.0}  # cage and rings have no contacts


def test_single_precision_is_not_enough(run, lubricated):
    """As the docstring of the module states, positions are wrong by up to 2 nm, so overlaps
    computed from them are useless, whereas the columns are exact."""
    u, radius = run.universe(), B6208.pitch_radius
    off = max(np.abs(u.atoms.positions - ts.data["position"]).max() for ts in u.trajectory)
    assert np.finfo(np.float32).eps * radius / 8 < off < 2e-9
    smallest = min(row[5] for frame in lubricated["contacts"] for row in frame)
    film = min(
        row[synthetic.LUBRICATED.index("h_min")]
        for frame in lubricated["contacts"]
        for row in frame
    )
    assert smallest < 1e-5 and off / film > 1e-3


def test_analysis_copies_and_pickles(run):
    u = run.universe()
    largest = AnalysisFromFunction(
        lambda atoms: atoms.universe.trajectory.ts.data["load_inner"].max(), u.trajectory, u.atoms
    ).run(start=5, stop=45, step=4)
    assert np.array_equal(largest.results["timeseries"], run.bearing["load_inner"][5:45:4])
    u.trajectory[11]
    for other in (u.copy(), pickle.loads(pickle.dumps(u))):
        assert other.trajectory.frame == 11
        other.trajectory[30]
        assert u.trajectory.frame == 11
        assert np.array_equal(
            other.trajectory.ts.data["load_inner"][:9],
            run.contacts["load"].sel(raceway="inner").isel(time=30),
        )


def test_no_box(run):
    assert run.universe().trajectory.ts.dimensions is None


def test_window(folder):
    u = raceway.open(folder, slice(10, 20)).universe()
    assert len(u.trajectory) == 10
    assert [ts.data["sample"] for ts in u.trajectory] == list(range(10, 20))
    assert u.trajectory[0].time == pytest.approx(
        10 * raceway.open(folder).settings["sample_s"], rel=1e-15
    )
