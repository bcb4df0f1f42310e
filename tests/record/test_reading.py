# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of raceway.open on records of real runs: the main deck, and a deck with one additional
line."""

import numpy as np
import pytest
import raceway
import xarray as xr
from host import succeed
from raceway.errors import RunError
from raceway.runs.record import Record
from recorded_runs import MAIN, small
from smallest import SMALLEST


@pytest.fixture(scope="module")
def main_run(tmp_path_factory):
    """Return the folder of a run of the main deck."""
    folder = tmp_path_factory.mktemp("main")
    succeed(out=folder, **{**MAIN, "passes": 2, "dumps": "no"})
    return folder


@pytest.fixture(scope="module")
def one_line(tmp_path_factory):
    """Return the folder of a run of docs/decks/in.smallest with one additional line."""
    folder = tmp_path_factory.mktemp("small")
    succeed(small(folder))
    return folder / "run"


def test_datasets_fit_together(main_run):
    run = raceway.open(main_run)
    times = [
        getattr(run, name)["time"].values for name in ("contacts", "balls", "rings", "bearing")
    ]
    assert all(np.array_equal(times[0], time) for time in times[1:])
    for name in ("contacts", "balls", "cage", "rings", "bearing"):
        for one in getattr(run, name).data_vars.values():
            assert one.attrs["units"] and one.attrs["long_name"]


def test_windows_and_blocks(main_run):
    whole = raceway.open(main_run)
    part = raceway.open(main_run, samples=slice(30, 50))
    for name in ("contacts", "balls", "rings", "bearing"):
        mine, other = getattr(part, name), getattr(whole, name).isel(time=slice(30, 50))
        assert mine.identical(other.drop_attrs(deep=False).assign_attrs(mine.attrs))
    for name in ("contacts", "balls", "cage"):
        samples = sum(block.sizes["time"] for block in whole.blocks(name))
        assert samples == whole.contacts.sizes["time"]
    with pytest.raises(RunError, match="has 81 samples, none from number 81 on"):
        _ = raceway.open(main_run, samples=slice(81, None)).tables.contacts


def test_read_when_used(main_run):
    """Opening a record does not read contacts; the values are still in the file."""
    contacts = raceway.open(main_run).contacts
    assert not contacts["load"].variable._in_memory
    assert float(contacts["load"].max()) > 2000


@pytest.mark.parametrize("name", ["load", "ring_fx", "bearing_capacitance", "cage_vx", "time"])
def test_samples_here_and_there(main_run, name):
    """An index selects the same values from the file as from an array in memory."""
    record = Record(main_run)
    with xr.open_dataset(main_run / "record.nc", engine="scipy") as data:
        values = data[name].to_numpy().astype(float)
    rest = (slice(None),) * (values.ndim - 1)
    some = (5, np.int64(5), np.array([3, 1, 9]), np.array([], int))
    steps = ((None, None, 7), (10, 2, -3), (4, 4, 2), (-3, None, 2))
    for time in (*some, *(slice(*step) for step in steps)):
        np.testing.assert_array_equal(record.pick(name, (time, *rest)), values[time])
    with pytest.raises(IndexError):
        record.pick(name, (len(values), *rest))


def test_what_nobody_told(one_line):
    """If a deck does not state the load, its direction and the speed, measured values are used."""
    run = raceway.open(one_line)
    settings = run.settings
    assert settings["rpm"] == pytest.approx(50 * 30 / np.pi, rel=1e-12)
    assert settings["load_azimuth_rad"] == pytest.approx(-np.pi / 2, abs=1e-2)
    assert settings["load_N"] == pytest.approx(4600, rel=1e-2)
    assert (settings["integrator"], settings["lubricant"]) == ("verlet", "dry")
    universe = run.universe()
    assert len(universe.trajectory) == 201 and len(universe.select_atoms("name ball")) == 9


def test_many(tmp_path):
    words = dict(bearings=4, columns=2, time=6e-3, ramp=1e-3, record="all", cage="chain")
    succeed("inputs/in.many", out=tmp_path / "run", **words)
    run = raceway.open(tmp_path / "run")
    assert run.bearing_numbers == [1, 2, 3, 4] and run.contacts.sizes["ball"] == 36
    for number in run.bearing_numbers:
        one = run.select(number)
        assert one.contacts.sizes["ball"] == 9 and one.cage.sizes["ball"] == 9
        loads = one.contacts["load"].sel(raceway="inner").max("ball")
        assert np.array_equal(one.bearing["load_inner"], loads)
        assert one.summary()["q_max_N"] == float(one.contacts["load"].max())
        assert one.settings["inner_ring"] in run.tables.record.fixed("ring").tolist()
    assert run.select(1).summary()["q_max_N"] != run.select(3).summary()["q_max_N"]


def test_a_summary_has_the_figures(tmp_path):
    succeed(small(tmp_path, "content summary"))
    run = raceway.open(tmp_path / "run")
    figures = run.summary()
    assert figures["q_max_N"] == pytest.approx(2407, rel=1e-3)
    with pytest.raises(RunError, match="has no contacts"):
        _ = run.tables.contacts
    with pytest.raises(RunError, match="no balls"):
        _ = run.balls


def test_unfinished(tmp_path):
    """A run that has stopped half-way can be read, but its summary is refused."""
    folder = tmp_path / "run"
    succeed(small(tmp_path, deck=SMALLEST.replace("run 20000", "run 5000")))
    text = (folder / "run.yaml").read_text()
    (folder / "run.yaml").write_text(text.split("step_s: ")[0])
    run = raceway.open(folder)
    assert not run.tables.finished and float(run.contacts["load"].max()) > 2000
    with pytest.raises(RunError, match="run has not finished"):
        run.summary()


@pytest.mark.parametrize("content", [b"", b"CDF\2\0\0\0", b"not a record at all" * 50])
def test_broken(content, tmp_path):
    (tmp_path / "record.nc").write_bytes(content)
    with pytest.raises(RunError, match="cannot read .*record.nc"):
        raceway.open(tmp_path)


def test_atoms_of_a_cage_ring(tmp_path):
    succeed(out=tmp_path, **{**MAIN, "passes": 1, "dumps": "no", "models": "full", "cage": "ring"})
    atoms = raceway.open(tmp_path).universe().atoms
    assert sorted(atoms.names) == ["ball"] * 9 + ["cage_ring", "inner", "outer"]


@pytest.mark.parametrize("samples", [7, slice(5, 5), slice(0, None, 2), slice(-3, None)])
def test_windows_that_are_none(main_run, samples):
    with pytest.raises(ValueError, match=r"samples .* slice\(first, stop\)"):
        raceway.open(main_run, samples)
