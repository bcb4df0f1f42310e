# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/record agrees with the host's dumps and writes the same bytes on any number of ranks.
A continued run writes the same bytes as an uninterrupted run."""

import re

import numpy as np
import pytest
import xarray as xr
from host import ROOT, columns, run, succeed, tables
from recorded_runs import MAIN, small
from smallest import SMALLEST


def opened(folder):
    return xr.open_dataset(folder / "record.nc", engine="scipy")


@pytest.fixture(scope="module", params=["liggghts", "lammps", "wheel"])
def main(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    succeed(host=request.param, out=folder, **MAIN)
    return folder


def settings(folder):
    return dict(line.split(": ", 1) for line in (folder / "run.yaml").read_text().splitlines())


def test_contacts_are_those_of_the_dump(main):
    columns = settings(main)["contact_columns"].split()
    with opened(main) as data:
        assert data.sizes["time"] == 41
        for sample, (step, table) in enumerate(tables(main / "contacts.dump")):
            one = data.isel(time=sample)
            assert one["step"] == step
            live = np.zeros((2, 9), dtype=bool)
            side, ball = table[:, columns.index("raceway")].astype(int), table[:, 0].astype(int) - 1
            live[side, ball] = True
            for k, name in enumerate(columns):
                if name in ("ball", "ring", "raceway"):
                    continue
                values = one[name].to_numpy()
                np.testing.assert_allclose(values[side, ball], table[:, k], rtol=1e-11)
                empty = values[~live]
                assert np.isnan(empty).all() or (empty == 0).all()
            assert (one["load"].to_numpy()[~live] == 0).all()
            assert np.isnan(one["h_min"].to_numpy()[~live]).all()


def test_balls_and_cage_are_those_of_the_dump(main):
    columns = settings(main)["ball_columns"].split()
    with opened(main) as data:
        for sample, (_, table) in enumerate(tables(main / "balls.dump")):
            one = data.isel(time=sample)
            table = table[np.argsort(table[:, 0])]
            for k, name in enumerate(columns[2:], 2):
                for kind, prefix in ((1, "ball_"), (2, "cage_")):
                    wanted = table[table[:, 1] == kind, k]
                    np.testing.assert_allclose(one[prefix + name], wanted, rtol=1e-11)


def test_rings_and_totals(main):
    with opened(main) as data:
        assert data["ring_raceway"].values.tolist() == [0, 1]
        table = columns(main / "rings.dat")
        data = data.isel(time=np.searchsorted(data["step"].values, table.pop("step")), ring=0)
        del table["time"]
        for name, wanted in table.items():
            found, atol = data["ring_" + name], 1e-6 * abs(wanted).max()
            np.testing.assert_allclose(found, wanted, rtol=1e-4, atol=atol)


def test_cage_speed_is_the_mean_of_the_balls(main):
    """test_one_sum.py compares the other totals with the contacts."""
    with opened(main) as data:
        ring = data.isel(ring=1)
        x, y = (data[f"ball_{k}"] - (ring[f"ring_{k}"] + ring[f"ring_origin_{k}"]) for k in "xy")
        vx, vy = (data[f"ball_v{k}"] - ring[f"ring_v{k}"] for k in "xy")
        speed = ((x * vy - y * vx) / (x * x + y * y)).mean("ball")
        found = data.isel(bearing=0)["bearing_cage_speed"]
        np.testing.assert_allclose(found, speed, rtol=1e-12)


def test_what_the_bearing_is(main):
    with opened(main) as data:
        assert float(data["ball_diameter"][0]) == pytest.approx(12.6e-3)
        assert float(data["clearance"][0]) == 0.0
        assert float(data["viscosity"][0]) == 0.04 and float(data["permittivity"][0]) == 2.25
        assert data.attrs["load_N"] == 5000 and data.attrs["bearing"] == "6208"
        style, inner, *_ = data.attrs["pair_commands"].splitlines()
        assert style == "pair_style bearing/ehd" and " young 210e9 210e9 " in inner
        assert int(data["finished"]) == 1
        assert "flaws" not in data.attrs
        for name in data.variables:
            if name not in ("raceway",):
                assert data[name].attrs["units"] and data[name].attrs["long_name"]
        assert data.attrs["sample_s"] == pytest.approx(float(np.diff(data["time"]).mean()))


@pytest.mark.parametrize(
    "host, ranks", [("liggghts", 2), ("liggghts", 4), ("lammps", 2), ("wheel", 2)]
)
def test_ranks(host, ranks, tmp_path):
    """The record has the same bytes if the box of the main deck is split through the bearing."""
    for n in (1, ranks):
        succeed(host=host, ranks=n, out=tmp_path / str(n), **MAIN)
    one = (tmp_path / "1" / "record.nc").read_bytes()
    assert (tmp_path / str(ranks) / "record.nc").read_bytes() == one


def test_smallest(tmp_path):
    succeed(small(tmp_path))
    with opened(tmp_path / "run") as data:
        assert data.sizes["time"] == 201 and "h_min" not in data and "cage_ball" not in data
        assert np.array_equal(data["step"], np.arange(0, 20001, 100))
        np.testing.assert_allclose(data["time"], np.arange(201) * 1e-4, rtol=1e-12)
        force = float(data["ring_fy"].isel(ring=0)[100:].mean())
        assert force == pytest.approx(5000, rel=2e-2)
    done = settings(tmp_path / "run")
    assert float(done["simulated_s"]) == 0.02 and float(done["step_s"]) == 1e-6


def test_cage_force_is_that_of_the_compute(tmp_path):
    deck = (ROOT / "docs" / "decks" / "in.ehd").read_text()
    # the displaced cage hits balls
    deck = deck.replace("timestep 4.0e-7\nrun 40000", "timestep 4.0e-7\nrun 2000")
    deck = deck.replace("fix step all", "velocity cage set 0.1 0 0\nfix step all")
    told = f'variable q equal c_total[11]\nfix told all print 100 "${{q}}" file {tmp_path}/told\n'
    succeed(small(tmp_path, more=told, deck=deck), out=tmp_path / "dumps")
    wanted = np.loadtxt(tmp_path / "told")
    with opened(tmp_path / "run") as data:
        found = data.isel(bearing=0)["bearing_cage_force"].values
    assert wanted.max() > 0
    np.testing.assert_allclose(found[-len(wanted) :], wanted, rtol=1e-4)


def test_choice_of_columns(tmp_path):
    succeed(small(tmp_path, "contacts load friction_t single yes"))
    with opened(tmp_path / "run") as data:
        names = {name for name in data.data_vars if data[name].dims == ("time", "raceway", "ball")}
        assert names == {"load", "friction_t"}
        assert data["load"].dtype == np.float32 and data["ball_x"].dtype == np.float64
        loads = data.isel(bearing=0)["bearing_load_inner"].values
        assert np.array_equal(data["load"].sel(raceway="inner").max("ball"), loads.astype("f4"))


def test_none(tmp_path):
    succeed(small(tmp_path))
    succeed(small(tmp_path, "content none overwrite yes text note quiet"))
    assert not (tmp_path / "run" / "record.nc").exists()
    assert settings(tmp_path / "run")["note"] == "quiet"


def test_a_finished_run_stays(tmp_path):
    succeed(small(tmp_path))
    before = (tmp_path / "run" / "record.nc").read_bytes()
    outcome = run(small(tmp_path))
    assert outcome.code != 0 and "holds a finished run: name another" in outcome.error
    assert (tmp_path / "run" / "record.nc").read_bytes() == before
    succeed(small(tmp_path, "overwrite yes"))


def test_several_runs(tmp_path):
    """The end of one run is the start of the next and is recorded only once."""
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    for folder, runs in ((whole, "run 20000"), (parts, "run 5050\nrun 14950")):
        folder.mkdir()
        succeed(small(folder, deck=SMALLEST.replace("run 20000", runs)))
    assert (whole / "run/record.nc").read_bytes() == (parts / "run/record.nc").read_bytes()


@pytest.mark.parametrize("ranks", [1, 2])
def test_resume(ranks, tmp_path):
    """A run resumes from a restart file written half-way; the samples after it are removed."""
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    for folder in (whole, parts):
        folder.mkdir()
        again = f"restart 1400 {folder / 'restart'}.*\n"
        deck = SMALLEST.replace("run 20000", "run 4000")
        succeed(small(folder, deck=deck, more=again), ranks=ranks)
    deck = re.sub(r"(?s)boundary.*?create_box[^\n]*", "newton off\nREAD", SMALLEST)
    deck = deck.replace("READ", f"read_restart {parts}/restart.1400")
    deck = re.sub(r"(?s)pair_style.*?create_bearing[^\n]*", "", deck)
    deck = deck.replace("run 20000", "run 4000 upto")
    succeed(small(parts, deck=deck), ranks=ranks)
    assert (parts / "run/record.nc").read_bytes() == (whole / "run/record.nc").read_bytes()


@pytest.mark.parametrize(
    "options, says",
    [
        ("contacts weight", "unknown attribute 'weight'; known: all, usual, ball"),
        ("contacts h_min", "attribute 'h_min' needs a lubricant"),
        ("content most", "content is 'most', must be one of: none, summary, all"),
        ("wobble", r"unknown keyword .*'wobble'; known: contacts, content, within"),
        ("number mass heavy", "mass"),
        ("text variables own", "'variables', which readers of netCDF reserve"),
        ("text _own word", "'_own': it begins with a letter and has letters, digits and '_' only"),
        ("number own-mass 2", "'own-mass': it begins with a letter"),
    ],
)
def test_refused(options, says, tmp_path):
    outcome = run(small(tmp_path, options))
    assert outcome.code != 0 and re.search(says, outcome.error), outcome.text[-2000:]


def test_refuses_another_step(tmp_path):
    deck = SMALLEST.replace("run 20000", "run 1000\ntimestep 5.0e-7\nrun 1000")
    outcome = run(small(tmp_path, deck=deck))
    assert outcome.code != 0
    assert "the time step was 1e-06 s and is now 5e-07 s" in outcome.error


def test_folder_that_cannot_be(tmp_path):
    (tmp_path / "run").write_text("a file")
    outcome = run(small(tmp_path))
    assert outcome.code != 0 and "cannot make the folder" in outcome.error


MANY = {"bearings": 6, "columns": 3, "time": 4e-3, "ramp": 1e-3}


@pytest.fixture(scope="module")
def many(tmp_path_factory):
    """Return the folder of runs of in.many with all digits in its table, on 1, 2 and 4 ranks."""
    folder = tmp_path_factory.mktemp("many")
    deck = folder / "in.many"
    text = (ROOT / "inputs" / "in.many").read_text()
    short, digits = "dump_modify table sort 1\n", " ".join(["%.0f"] + 15 * ["%.12g"])
    assert short in text
    deck.write_text(text.replace(short, f'{short}dump_modify table format "{digits}"\n'))
    for ranks in (1, 2, 4):
        succeed(deck, ranks=ranks, out=folder / str(ranks), **MANY)
    return folder


def test_many_on_any_ranks(many):
    one = (many / "1" / "record.nc").read_bytes()
    for ranks in (2, 4):
        assert (many / str(ranks) / "record.nc").read_bytes() == one


def test_many_is_its_table(many):
    """The record equals the table, which contains one row of compute bearing/ring for each inner
    ring and sample."""
    names = (
        "ring x y spin fx fy torque contacts balls load pressure h_min lambda orbit friction_power"
    )
    names = names.split() + ["capacitance"]
    with opened(many / "1") as data:
        assert data.sizes["bearing"] == 6 and data.sizes["ball"] == 54 and data.sizes["ring"] == 18
        inner = data.isel(ring=data["ring_raceway"].values == 0)
        assert inner["ring_bearing"].values.tolist() == [1, 2, 3, 4, 5, 6]
        for sample, (step, table) in enumerate(tables(many / "1" / "bearings.dump")):
            table = table[np.argsort(table[:, 0])]
            one, column = inner.isel(time=sample), dict(zip(names, table.T))
            assert one["step"] == step and np.array_equal(one["ring"], column["ring"])
            for name in ("x", "y", "spin", "fx", "fy", "torque"):
                np.testing.assert_allclose(one[f"ring_{name}"], column[name], rtol=1e-11)
            for name in ("capacitance", "load_inner", "loaded_balls"):
                table_name = {"load_inner": "load", "loaded_balls": "balls"}.get(name, name)
                wanted = column[table_name]
                np.testing.assert_allclose(one[f"bearing_{name}"], wanted, rtol=1e-11)
