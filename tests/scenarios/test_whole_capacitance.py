# SPDX-License-Identifier: GPL-2.0-or-later
"""The total capacitance of a run with clearance, in which most balls are unloaded, agrees with
statics, and with overlaps, films and plates of the same run."""

import numpy as np
import pytest
import raceway
from host import ROOT, succeed
from raceway import electric_point, film_voltage, whole_capacitance
from raceway.errors import RunError
from raceway.theory.capacitors import Filling

LOAD, RPM, CLEARANCE = 400.0, 6000.0, 12e-6


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("play") / "run"
    succeed(
        "inputs/in.6208", out=folder, passes=2, samples=60, load=LOAD, rpm=RPM, clearance=CLEARANCE
    )
    return raceway.open(folder)


@pytest.fixture(scope="module")
def filling():
    """Return the shoulder diameters from the file of the bearing, because the run does not contain
    them."""
    return point(Filling("cavitated")).filling


@pytest.fixture(scope="module")
def whole(run, filling):
    return whole_capacitance.over_time(run, filling)


def point(filling, phase=0.0, **other):
    words = dict(load=LOAD, rpm=RPM, clearance=CLEARANCE, phase=phase, filling=filling) | other
    return electric_point.solve("6208", "mineral", ROOT / "inputs", **words)


def test_mean_is_that_of_statics(whole, filling):
    """Means over the positions of the balls agree within 0.3 %. The differences arise because the
    balls skid and the ring moves slightly."""
    phases = 2 * np.pi / 9 * np.arange(8) / 8
    statics = [point(filling, phase).capacitors() for phase in phases]
    assert float(whole["bearing"].mean()) == pytest.approx(
        np.mean([one.total for one in statics]), rel=3e-3, abs=0
    )
    free = whole["one_ball"].where(whole["load"].sel(raceway="inner") == 0)
    assert 5e-12 < float(free.min()) < float(free.max()) < 10e-12
    assert float(whole["bearing"].min()) > 9 * float(free.min())
    assert whole.attrs["quiet_load_N"] == pytest.approx(15.33, rel=2e-3)


def test_slow_mean_is_that_of_statics(tmp_path):
    """At low speed, the outer film of a ball without load is that at 1 N, below which films in the
    gap are constant, in the run and in statics."""
    words = dict(load=LOAD, rpm=477.5, clearance=CLEARANCE, models="full")
    succeed("inputs/in.6208", out=tmp_path / "run", settle="auto", surroundings="flooded", **words)
    run = raceway.open(tmp_path / "run")
    own = whole_capacitance.filling_of(run)
    phases = 2 * np.pi / 9 * np.arange(8) / 8
    statics = [point(own, phase, rpm=477.5, models="full").capacitors().total for phase in phases]
    mean = float(whole_capacitance.over_time(run)["bearing"].mean())
    assert mean == pytest.approx(np.mean(statics), rel=2e-3, abs=0)


def test_gaps_are_the_run_s_overlaps(run, whole):
    overlap = run.contacts["overlap"].sel(time=whole["time"]).transpose(*whole["play"].dims)
    loaded = run.contacts["load"].sel(time=whole["time"]) > 0
    apart = (whole["play"] + overlap).where(loaded)
    assert int(loaded.sum()) > 1000 and float(np.abs(apart).max()) < 1e-12


def test_plates_are_the_run_s(run, whole):
    """The capacitances of the plates agree for those contacts that carry more than Q_u, the
    centrifugal force on a ball."""
    plates = run.contacts["capacitance"].sel(time=whole["time"]).transpose(*whole["plates"].dims)
    heavy = whole["load"] > 1.001 * whole.attrs["quiet_load_N"]
    assert float(np.abs(whole["plates"] / plates - 1).where(heavy).max()) < 1e-9
    assert 8 < float(whole["bearing"].mean() / run.bearing["capacitance"].mean()) < 14


def test_no_jump_where_contact_is_lost(whole):
    """With 60 samples per pass, the change in a ball's capacitance between two samples is only
    slightly larger where a contact opens or closes than elsewhere."""
    one = whole["one_ball"].to_numpy()
    load = whole["load"].sel(raceway="inner").to_numpy()
    steps = np.abs(np.diff(one, axis=0)) / one[1:]
    lost = (load[1:] > 0) != (load[:-1] > 0)
    # in each of two passes, one ball enters and one leaves
    assert lost.sum() == 4 and steps[lost].max() < 1.2 * steps[~lost].max() < 0.02


@pytest.mark.parametrize("rpm", [477.5, 9549.0])
def test_time_is_resolved(tmp_path, rpm):
    """With clearance, the mean over every second sample is the same as that over all samples, at
    low and at high speed."""
    succeed("inputs/in.6208", out=tmp_path / "run", passes=2, rpm=rpm, clearance=CLEARANCE)
    total = whole_capacitance.over_time(raceway.open(tmp_path / "run"))["bearing"][1:].to_numpy()
    assert len(total) >= 398 and np.abs(np.diff(total) / total[1:]).max() < 2e-3
    assert total[::2].mean() == pytest.approx(total.mean(), rel=1e-4, abs=0)


def test_fields(run, whole):
    found = whole_capacitance.fields(run, whole, 10.0, strength=15e6)
    shares = found["share"].sum("raceway")
    assert np.allclose(shares, 10.0)
    assert float((found["field"] * whole["separation"] / found["share"]).max()) == pytest.approx(1)
    at = whole_capacitance.fields(run, whole, float(found["threshold"][5]), strength=15e6)
    largest = at["field"].isel(time=5)
    assert float(largest.max()) == pytest.approx(15e6)
    assert float(largest.sel(ball=found["weakest"][5]).max()) == pytest.approx(15e6)
    assert np.all(found["threshold_peaks"] < found["threshold"])
    assert set(np.unique(found["state"])) == {film_voltage.STATES.index("capacitive")}
    with_units = [name for name in found.data_vars if found[name].attrs.get("units")]
    assert len(with_units) == len(found.data_vars)


def test_dry_runs_have_none(tmp_path):
    succeed("inputs/in.6208", out=tmp_path / "run", passes=1, samples=20, lubricant="dry")
    with pytest.raises(RunError, match="capacitance"):
        whole_capacitance.over_time(raceway.open(tmp_path / "run"))


# ---- compared with the engine, which computes the same quantities with its own formulas ----------
@pytest.fixture(scope="module", params=["flooded", "cavitated"])
def recorded(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole") / "run"
    succeed(
        "inputs/in.6208",
        out=folder,
        passes=2,
        samples=60,
        load=LOAD,
        rpm=RPM,
        clearance=CLEARANCE,
        record="all",
        surroundings=request.param,
    )
    return raceway.open(folder)


def test_the_record_is_taken(recorded):
    """The columns of the record, and the settings of the fix that are stored in it, are used."""
    found = whole_capacitance.over_time(recorded)
    assert found.attrs["source"] == "record"
    filling = whole_capacitance.filling_of(recorded)
    assert filling.kind == found.attrs["filling"] != "dry"
    assert filling.shoulders == (52.6e-3, 67.4e-3)
    engine = recorded.bearing["capacitance_total"].sel(time=found["time"])
    assert found["bearing"].to_numpy() == pytest.approx(engine.to_numpy(), rel=1e-12, abs=0)


def test_engine_and_python(recorded):
    """Loads, films and positions are taken from the run; the engine and Python have separate
    formulas. The results differ for films of balls that carry less than Q_u, because the engine
    uses the orbital speed of each ball."""
    own = whole_capacitance.over_time(recorded, whole_capacitance.filling_of(recorded))
    engine = whole_capacitance.over_time(recorded)
    loaded = own["load"] > 0
    assert 300 < int(loaded.sum()) < loaded.size - 300
    off = {
        name: np.abs(own[name] / engine[name] - 1) for name in ("separation", "outside", "total")
    }
    for name, one in off.items():
        assert float(one.where(loaded).max()) < 6e-5, name
    for name in ("outside", "total"):
        assert float(off[name].where(~loaded).max()) < 6e-5, name
    assert float(np.abs(own["plates"] - engine["plates"]).max()) < 1e-9 * float(own["plates"].max())
    assert float(off["separation"].where(~loaded).max()) < 2e-4


FILMS = {  # kinds of films in the gap, with Q_u below and above the load at which films are cut
    "power law, slow": dict(rpm=477.5, load=LOAD, clearance=CLEARANCE),
    "power law, fast": dict(rpm=RPM, load=LOAD, clearance=CLEARANCE),
    "all regimes": dict(rpm=RPM, load=LOAD, clearance=2e-4, gap_film="moes"),
    "no film in the gap": dict(rpm=477.5, load=LOAD, clearance=CLEARANCE, models="paper"),
    "heated": dict(rpm=RPM, load=2000, lubricant="vg46", heat="yes"),
}


@pytest.mark.parametrize("name", FILMS)
def test_engine_and_python_with_each_film(tmp_path, name):
    """Contacts that open and close are resolved. The engine uses the orbital speed of each ball,
    which changes Q_u and hence the film there by 0.2 %, and the capacitance of a gap by a sixth of
    that. In a heated run, gaps include the thermal expansion."""
    words = {"passes": 2, "surroundings": "flooded", "models": "full"} | FILMS[name]
    succeed("inputs/in.6208", out=tmp_path / "run", **words)
    run = raceway.open(tmp_path / "run")
    own = whole_capacitance.over_time(run, whole_capacitance.filling_of(run))
    engine = whole_capacitance.over_time(run)
    assert float(np.abs(own["separation"] / engine["separation"] - 1).max()) < 2e-3
    assert float(np.abs(own["total"] / engine["total"] - 1).max()) < 4e-4
    assert own["bearing"].to_numpy() == pytest.approx(engine["bearing"].to_numpy(), rel=1e-4, abs=0)
    overlap = run.contacts["overlap"].transpose(*own["play"].dims)
    apart = (own["play"] + overlap).where(own["load"] > 0)
    assert float(np.abs(apart).max()) < 1e-12
