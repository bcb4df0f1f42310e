# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the total capacitance during a run whose contents are known. Tests with simulated runs
are in tests/scenarios."""

from types import SimpleNamespace

import numpy as np
import pytest
import raceway
from raceway import whole_capacitance
from raceway.electric import breakdown, films
from raceway.errors import RunError
from raceway.theory.capacitors import FLOODED, Filling
from raceway.theory.validity import Shoulders


def given(text):
    run = SimpleNamespace(
        settings={"capacitance_commands": text} if text else {},
        tables=SimpleNamespace(folder="a run"),
    )
    return whole_capacitance.filling_of(run)


@pytest.mark.parametrize(
    ("text", "filling"),
    [
        ("", FLOODED),
        ("permittivity 2.25", FLOODED),
        ("permittivity 2.25 surroundings none", FLOODED),
        ("surroundings cavitated outlet 1.3", Filling("cavitated", 1.3)),
        ("surroundings cavitated", Filling("cavitated", 1.0)),
        ("permittivity 2.25 surroundings dry roughness gamma", Filling("dry", roughness="gamma")),
        (
            "surroundings cavitated 1.3 shoulders 52.6e-3 67.4e-3 permittivity_at mean",
            Filling("cavitated", 1.3, "mean", shoulders=Shoulders(52.6e-3, 67.4e-3)),
        ),
    ],
)
def test_filling_of_a_run(text, filling):
    found = given(text)
    assert found[:4] == filling[:4]
    assert np.array_equal(found.shoulders, filling.shoulders, equal_nan=True)


def test_unknown_surroundings():
    with pytest.raises(RunError, match="a run: surroundings foam are unknown"):
        given("surroundings foam")


def test_columns_of_the_record_come_first(folder, monkeypatch):
    """The columns of a record are used if they include the total capacitance and no other filling
    is requested."""
    run = raceway.open(folder)
    own = whole_capacitance.over_time(run)
    assert own.attrs["source"] == "positions, loads and films"
    contacts = run.contacts
    for name, column in whole_capacitance.RECORDED.items():
        values = own[name].reindex(time=contacts["time"], fill_value=1.0)
        contacts[column] = (values.dims, 3 * values.to_numpy())
    monkeypatch.setattr(run, "contacts", contacts, raising=False)
    found = whole_capacitance.over_time(run)
    assert found.attrs["source"] == "record"
    for name in ("total", "separation", "one_ball", "bearing"):
        assert found[name].to_numpy() == pytest.approx(3 * own[name].to_numpy(), rel=1e-12)
    asked = whole_capacitance.over_time(run, Filling("dry"))
    assert asked.attrs["source"] == "positions, loads and films"


def test_threshold_is_the_least_of_the_balls(folder):
    """The threshold is the smallest value of E h (C_i + C_o)/C over balls and films, where C is the
    capacitance of the other film of the ball."""
    run = raceway.open(folder)
    whole = whole_capacitance.over_time(run)
    found = whole_capacitance.fields(run, whole, 1.0, strength=2e7)
    both = whole["total"].sum("raceway")
    other = whole["total"].isel(raceway=[1, 0]).assign_coords(raceway=whole["raceway"])
    least = (2e7 * whole["separation"] * both / other).min(("raceway", "ball"))
    assert found["threshold"].to_numpy() == pytest.approx(least.to_numpy())


def test_the_circuit_takes_it(folder):
    """Series connection, threshold and local thickness in the circuit equal those of the module
    `whole_capacitance`."""
    run = raceway.open(folder)
    whole = whole_capacitance.over_time(run)
    contacts = whole_capacitance.contacts_of(run, whole)
    found = films.of_dataset(contacts, roughness=run.settings["roughness_m"], balls=run.balls)
    both = films.series(found.capacitance)
    assert both.bearing == pytest.approx(whole["bearing"].to_numpy())
    own = whole_capacitance.fields(run, whole, 1.0, strength=2e7)
    for name, surfaces in (("threshold", "smooth"), ("threshold_peaks", "rough")):
        limit = breakdown.Breakdown(2e7, surfaces, floor=1e-15).limit(found)
        assert breakdown.threshold(found, limit) == pytest.approx(own[name].to_numpy(), abs=1e-6)
