# SPDX-License-Identifier: GPL-2.0-or-later
"""raceway.open on records: what it says of the text dumps of the same run, and everything that a
folder of one added line gives."""

import re
import shutil

import numpy as np
import pytest
import raceway
import xarray as xr
from host import ROOT, succeed
from raceway.cli import main as command
from raceway.errors import RunError
from raceway.runs.record import Record
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from recorded_runs import MAIN, SMALL, small


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """(folder with the record, folder with the text alone) of one run of the main deck."""
    folder = tmp_path_factory.mktemp("both")
    succeed(out=folder / "record", **{**MAIN, "passes": 2})
    text = folder / "text"
    shutil.copytree(folder / "record", text)
    (text / "record.nc").unlink()
    return folder / "record", text


@pytest.fixture(scope="module")
def one_line(tmp_path_factory):
    """docs/decks/in.smallest plus one line."""
    folder = tmp_path_factory.mktemp("small")
    succeed(small(folder))
    return folder / "run"


# of forces in rings.dat
MAKERS = ("torque_skf_N_m", "torque_palmgren_N_m")


def close(found, wanted, rtol=1e-9, atol=0.0):
    np.testing.assert_allclose(found, wanted, rtol=rtol, atol=atol)


def test_summary(both):
    found, wanted = (summary(RunTables(folder)) for folder in both)
    assert found.keys() == wanted.keys()
    for key, value in wanted.items():
        if isinstance(value, str):
            assert found[key] == value
        elif key == "losses_W":
            assert {part for part, loss in value.items() if loss is not None} == {"slip", "film"}
            for part, loss in value.items():  # text has no losses of the cage
                assert (found[key][part] is None) == (loss is None) or part == "cage"
                if loss is not None:
                    close(found[key][part], loss, 1e-9)
        elif key in ("power_loss_W", "friction_torque_N_m"):
            without_cage = 1 - found["losses_W"]["cage"] / found["power_loss_W"]
            close(found[key] * without_cage, value, 1e-5)
        elif key == "model_ranges":
            assert found[key].keys() == value.keys()
            for figure, one in value.items():
                assert found[key][figure]["why"] == one["why"]
                for end in ("low", "high"):
                    close(found[key][figure][end], one[end], 1e-5)
        elif key in ("ring_shift_m", *MAKERS):  # rings.dat has six digits
            close(found[key], value, 1e-5)
        elif value is None or isinstance(value, list):
            assert found[key] == value
        else:
            close(found[key], value, 1e-9 if key != "load_parameter" else 1e-5, 1e-12)


def test_contacts_and_balls(both):
    found, wanted = (raceway.open(folder) for folder in both)
    for name in ("contacts", "balls", "cage"):
        mine, other = getattr(found, name), getattr(wanted, name)
        assert set(other.data_vars) - set(mine.data_vars) <= {"ring"}
        assert dict(mine.sizes) == dict(other.sizes)
        for variable in mine.data_vars:
            close(mine[variable], other[variable], 1e-9, 1e-18)
            assert mine[variable].attrs == other[variable].attrs
        for coordinate in ("time", "passes", "azimuth", "from_load_line"):
            close(mine[coordinate], other[coordinate], 1e-9, 1e-9)
            assert mine[coordinate].attrs == other[coordinate].attrs
        assert mine["ball"].values.tolist() == other["ball"].values.tolist()


def test_rings_and_bearing(both):
    found, wanted = (raceway.open(folder) for folder in both)
    for name in ("rings", "bearing"):
        mine, other = getattr(found, name), getattr(wanted, name)
        mine = mine.isel(time=slice(mine.sizes["time"] - other.sizes["time"], None))
        assert set(other.data_vars) <= set(mine.data_vars)
        for variable in other.data_vars:
            scale = float(np.abs(other[variable]).max())
            close(mine[variable], other[variable], 1e-4, 1e-5 * scale)
        for variable in mine.data_vars:
            assert mine[variable].attrs["units"] and mine[variable].attrs["long_name"]


def test_datasets_of_a_record_fit_together(both):
    run = raceway.open(both[0])
    times = [
        getattr(run, name)["time"].values for name in ("contacts", "balls", "rings", "bearing")
    ]
    assert all(np.array_equal(times[0], time) for time in times[1:])


def test_windows_and_blocks(both):
    whole = raceway.open(both[0])
    part = raceway.open(both[0], samples=slice(30, 50))
    for name in ("contacts", "balls", "rings", "bearing"):
        mine, other = getattr(part, name), getattr(whole, name).isel(time=slice(30, 50))
        assert mine.identical(other.drop_attrs(deep=False).assign_attrs(mine.attrs))
    for name in ("contacts", "balls", "cage"):
        samples = sum(block.sizes["time"] for block in whole.blocks(name))
        assert samples == whole.contacts.sizes["time"]
    with pytest.raises(RunError, match="holds 81 samples, none from number 81 on"):
        _ = raceway.open(both[0], samples=slice(81, None)).tables.contacts


def test_read_when_used(both):
    """Opening reads no contact: the values are still in the file."""
    contacts = raceway.open(both[0]).contacts
    assert not contacts["load"].variable._in_memory
    assert float(contacts["load"].max()) > 2000


@pytest.mark.parametrize("name", ["load", "ring_fx", "bearing_capacitance", "cage_vx", "time"])
def test_samples_here_and_there(both, name):
    """What an index picks of the file is what it picks of the values."""
    record = Record(both[0])
    with xr.open_dataset(both[0] / "record.nc", engine="scipy") as data:
        values = data[name].to_numpy().astype(float)
    rest = (slice(None),) * (values.ndim - 1)
    some = (5, np.int64(5), np.array([3, 1, 9]), np.array([], int))
    steps = ((None, None, 7), (10, 2, -3), (4, 4, 2), (-3, None, 2))
    for time in (*some, *(slice(*step) for step in steps)):
        np.testing.assert_array_equal(record.pick(name, (time, *rest)), values[time])
    with pytest.raises(IndexError):
        record.pick(name, (len(values), *rest))


def test_universe(both):
    mine, other = (raceway.open(folder).universe() for folder in both)
    assert len(mine.trajectory) == len(other.trajectory)
    for a, b in zip(mine.trajectory[::16], other.trajectory[::16]):
        order = np.argsort(mine.atoms.ids), np.argsort(other.atoms.ids)
        assert a.data.keys() - b.data.keys() <= {"ring_inner", "ring_outer"}
        for name in ("position", "velocity", "load_inner", "h_min_outer", "capacitance_inner"):
            close(a.data[name][order[0]], b.data[name][order[1]], 1e-9, 1e-15)
        assert a.data["step"] == b.data["step"]


@pytest.mark.parametrize(
    "words",
    [
        ["summary"],
        ["summary", "--json"],
        ["plot", "--out", "OUT.png"],
        ["plot", "--kind", "polar", "--out", "OUT.png"],
        ["animate", "--frames", "3", "--passes", "0.2", "--out", "OUT.gif"],
        ["export", "--format", "vtk", "--out", "OUT"],
        ["spectrum", "--signal", "y", "--out", "OUT.png"],
    ],
)
def test_commands_on_one_line(one_line, words, tmp_path, capsys):
    name, *more = words
    command([name, str(one_line), *(word.replace("OUT", str(tmp_path / "out")) for word in more)])
    made = list(tmp_path.iterdir())
    assert name == "summary" or (made and all(path.stat().st_size for path in made))
    assert name != "summary" or re.search(r"2\.4\d+ kN|: 240\d\.", capsys.readouterr().out)


def test_what_nobody_told(one_line):
    """Load, speed and direction of a deck that names none are those measured."""
    run = raceway.open(one_line)
    settings = run.settings
    assert settings["rpm"] == pytest.approx(50 * 30 / np.pi, rel=1e-12)
    assert settings["load_azimuth_rad"] == pytest.approx(-np.pi / 2, abs=1e-2)
    assert settings["load_N"] == pytest.approx(4600, rel=1e-2)
    assert (settings["integrator"], settings["lubricant"]) == ("verlet", "dry")
    universe = run.universe()
    assert len(universe.trajectory) == 201 and len(universe.select_atoms("name ball")) == 9


def test_many(tmp_path, capsys):
    deck = tmp_path / "in.many"
    text = (ROOT / "inputs" / "in.many").read_text()
    line = "fix rec all bearing/record ${b_every} ${out}\n"
    deck.write_text(text.replace("timestep ${b_dt}", line + "timestep ${b_dt}"))
    succeed(deck, out=tmp_path / "run", bearings=4, columns=2, time=6e-3, ramp=1e-3)
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
    with pytest.raises(RunError, match="has the bearings 1 to 4, not 5"):
        run.select(5)
    with pytest.raises(RunError, match="has 4 bearings: choose one"):
        run.summary()
    words = ["spectrum", str(tmp_path / "run"), "--signal", "y"]
    assert command(words) == 1
    assert "has 4 bearings: choose one with --bearing NUMBER" in capsys.readouterr().err
    assert command([*words, "--bearing", "5"]) == 1
    assert "has the bearings 1 to 4, not 5" in capsys.readouterr().err
    assert command([*words, "--bearing", "3"]) == 1
    assert "has 7 samples: a spectrum needs 32" in capsys.readouterr().err


def test_a_summary_has_the_figures(tmp_path):
    succeed(small(tmp_path, "content summary"))
    run = raceway.open(tmp_path / "run")
    figures = run.summary()
    assert figures["q_max_N"] == pytest.approx(2407, rel=1e-3)
    with pytest.raises(RunError, match="holds no contacts"):
        _ = run.tables.contacts
    with pytest.raises(RunError, match="no balls"):
        _ = run.balls


def test_unfinished(tmp_path):
    """A run that stops half-way can be read, its figures are refused."""
    folder = tmp_path / "run"
    succeed(small(tmp_path, deck=SMALL.replace("run 20000", "run 5000")))
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
