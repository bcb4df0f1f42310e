# SPDX-License-Identifier: GPL-2.0-or-later
"""raceway.open returns every number of the record with its labels and its unit."""

import numpy as np
import pytest
import raceway
import synthetic
import xarray as xr
from raceway import columns
from raceway.errors import RunError
from raceway.runs.summary import summary


def test_contacts(folder, lubricated):
    data = raceway.open(folder).contacts
    assert data.sizes == {"time": 49, "raceway": 2, "ball": 9}
    seen = np.zeros((49, 2, 9), dtype=bool)
    place = {name: i for i, name in enumerate(synthetic.LUBRICATED)}
    for sample, frame in enumerate(lubricated["contacts"]):
        for row in frame:
            one = data.sel(raceway=("inner", "outer")[row[2]], ball=row[0]).isel(time=sample)
            names = [name for name in place if name not in ("ball", "ring", "raceway")]
            assert [float(one[name]) for name in names] == [row[place[name]] for name in names]
            seen[sample, row[2], row[0] - 1] = True
    assert not seen.all()  # entries outside the load zone are missing
    for name in data.data_vars:
        empty = data[name].to_numpy()[~seen]
        assert (
            np.isnan(empty).all() if np.isnan(columns.CONTACT[name].absent) else (empty == 0).all()
        )


def test_coordinates(folder, lubricated):
    run, settings = raceway.open(folder), lubricated["settings"]
    time = np.arange(49) * settings["sample_s"]
    for data in (run.contacts, run.balls, run.cage, run.bearing):
        assert np.array_equal(data["time"], time)
        np.testing.assert_allclose(data["passes"], np.arange(49) / 24, rtol=1e-12)
    assert np.array_equal(run.rings["time"], time)
    assert run.contacts["raceway"].to_numpy().tolist() == ["inner", "outer"]
    assert run.balls["ball"].to_numpy().tolist() == list(range(1, 10))
    assert run.cage["ball"].to_numpy().tolist() == list(range(10, 19))
    # the load points to -y: a ball there has the azimuth -90 degrees, which is 0 from the load line
    turned = np.mod(run.balls["azimuth"] + np.pi / 2 + np.pi, 2 * np.pi) - np.pi
    np.testing.assert_allclose(run.balls["from_load_line"], turned, atol=1e-12)


def test_balls(folder, lubricated):
    run = raceway.open(folder)
    for sample in (0, 17, 47):
        for row in lubricated["balls"][sample]:
            atoms = {1: run.balls, 2: run.cage}.get(row[1])
            if atoms is not None:
                one = atoms.sel(ball=row[0]).isel(time=sample)
                assert [float(one[name]) for name in synthetic.BALL_COLUMNS[2:]] == row[2:]
                assert float(one["azimuth"]) == pytest.approx(np.arctan2(row[3], row[2]), abs=1e-12)


def test_contact_and_ball_azimuths_agree(folder):
    run = raceway.open(folder)
    contact, ball = xr.broadcast(run.contacts["azimuth"], run.balls["azimuth"])
    live = np.isfinite(contact.to_numpy())
    # the synthetic balls are on the pitch circle, 35 um away from their theoretical position
    np.testing.assert_allclose(contact.to_numpy()[live], ball.to_numpy()[live], atol=2e-3)


def test_rings(folder, lubricated):
    rings = raceway.open(folder).rings
    table = np.array(lubricated["rings"])
    for name, values in zip(synthetic.RING_COLUMNS, table.T):
        if name != "time":
            assert np.array_equal(rings[name], values)
    assert np.array_equal(rings["shift"], -table[:, 3]) or np.allclose(
        rings["shift"], -table[:, 3], rtol=1e-14
    )


def test_units(folder):
    run = raceway.open(folder)
    for data, names in (
        (run.contacts, columns.CONTACT),
        (run.balls, columns.ATOM),
        (run.rings, columns.RING),
        (run.bearing, columns.BEARING),
    ):
        for name in data.data_vars:
            assert (
                data[name].attrs["units"] == (names[name].unit or "1")
                and data[name].attrs["long_name"]
            )
        for name in ("time", "passes"):
            assert data[name].attrs["units"]
    assert run.contacts["azimuth"].attrs["units"] == "rad"
    assert run.contacts.attrs["load_N"] == 5000


def test_dry(dry_folder):
    run = raceway.open(dry_folder)
    assert "h_min" not in run.contacts and "capacitance" not in run.bearing
    assert float(run.bearing["friction_power"].min()) > 0


def test_blocks_and_windows(folder, small_blocks):
    whole = raceway.open(folder)
    for name in ("contacts", "balls", "cage"):
        blocks = list(raceway.open(folder).blocks(name))
        assert len(blocks) > 3
        xr.testing.assert_identical(xr.concat(blocks, "time"), getattr(whole, name))
    with pytest.raises(ValueError, match="no dataset 'rings' in blocks"):
        next(whole.blocks("rings"))
    some = raceway.open(folder, samples=slice(10, 20))
    xr.testing.assert_identical(some.contacts, whole.contacts.isel(time=slice(10, 20)))
    xr.testing.assert_identical(some.bearing, whole.bearing.isel(time=slice(10, 20)))
    xr.testing.assert_identical(some.rings, whole.rings.isel(time=slice(10, 20)))


def test_summary(folder):
    run = raceway.open(folder)
    assert run.summary() == summary(run.tables)


def test_growing_run(tmp_path, lubricated):
    """Every dataset contains the samples that were present when the run was first read. A later
    read sees more samples."""
    rings = lubricated["rings"]
    folder = synthetic.write(tmp_path / "run", {**lubricated, "rings": rings[:30]}, end=False)
    run = raceway.open(folder)
    assert "not finished" in repr(run) and run.contacts.sizes["time"] == 30
    synthetic.write(folder, lubricated, end=False)
    names = ("contacts", "balls", "cage", "rings", "bearing")
    for one, samples in ((run, 30), (raceway.open(folder), 49)):
        assert {getattr(one, name).sizes["time"] for name in names} == {samples}


def test_nothing_recorded_yet(tmp_path, lubricated):
    folder = synthetic.write(tmp_path / "run", {**lubricated, "rings": []}, end=False)
    run = raceway.open(folder)
    assert "no sample yet" in repr(run)
    with pytest.raises(RunError, match="has no samples"):
        _ = run.rings


def test_a_cut_record(folder):
    path = folder / "record.nc"
    path.write_bytes(path.read_bytes()[:-20])
    with pytest.raises(RunError, match="record.nc"):
        raceway.open(folder).rings
