# SPDX-License-Identifier: GPL-2.0-or-later
"""The variables of datasets are available as attributes. Names that are not valid in Python have
alternative names."""

import pytest
import raceway
import xarray as xr
from raceway.runs.named import ALIASES, NamedDataset

DATASETS = ("contacts", "balls", "cage", "rings", "bearing")


@pytest.fixture
def run(folder):
    return raceway.open(folder)


@pytest.mark.parametrize("name", DATASETS)
def test_every_variable_is_an_attribute(run, name):
    data = getattr(run, name)
    other = {own: alias for alias, own in ALIASES.items()}
    for variable in data.data_vars:
        alias = other.get(variable, variable)
        assert getattr(data, alias).identical(data[variable]), variable
        assert data[alias].identical(data[variable])
        assert alias in dir(data)


def test_second_names(run):
    contacts = run.contacts
    assert contacts.Q.name == "load" and contacts.Q.attrs["units"] == "N"
    assert (contacts.lambda_ratio.max() == contacts["lambda"].max()).all()
    assert run.rings.radial_displacement.identical(run.rings["shift"])
    assert list(contacts[["Q", "mu"]].data_vars) == ["load", "mu"]


def test_results_have_them_too(run):
    later = run.contacts.isel(time=slice(2, None)).sel(raceway="inner")
    assert isinstance(later, NamedDataset)
    assert later.max("time").Q.identical(later.max("time")["load"])
    assert (2 * later).Q.identical(2 * later["load"])


def test_they_are_names_and_no_copies(run):
    assert "Q" not in run.contacts.data_vars
    assert not hasattr(run.balls, "Q") and not hasattr(run.contacts, "radial_displacement")
    with pytest.raises(KeyError):
        run.balls["Q"]


def test_a_variable_of_that_name_comes_first():
    data = NamedDataset({"load": 1.0, "Q": 2.0})
    assert float(data.Q) == float(data["Q"]) == 2.0
    assert isinstance(data, xr.Dataset)
