# SPDX-License-Identifier: GPL-2.0-or-later
"""The first lines that a user types work: data are given by name, results fit on a screen, and
sizes in millimetres cause a warning."""

import numpy as np
import pytest
from raceway import inputs, lubrication, static
from raceway.errors import InputError
from raceway.theory.bearing import Bearing


def test_data_by_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # this folder has no inputs
    shipped = inputs.bearing("6206")
    assert shipped.balls == 9 and inputs.bearing("7205B").balls == 12
    assert inputs.oil("vg46") == inputs.oil("vg46", 40)
    assert inputs.fluid("vg46", 80).viscosity < inputs.fluid("vg46").viscosity
    assert inputs.lubricant("vg46").at(40).viscosity == inputs.fluid("vg46", 40).viscosity
    # a file in the current folder takes precedence over a name in the catalogue
    (tmp_path / "6206").write_text(inputs.text(inputs._named("bearings", "6208")))
    assert inputs.bearing("6206").ball_diameter > shipped.ball_diameter
    for read, name in ((inputs.bearing, "6299"), (inputs.oil, "vg47")):
        with pytest.raises(InputError, match=f"'{name}' in"):
            read(name)


def test_results_are_short():
    """The printed result has one line per field, whatever the number of balls."""
    body = inputs.bearing("6208")
    state = static.equilibrium(body, 2000.0, 500.0)
    films = lubrication.lubricate(body, state, inputs.oil("vg46"), 100.0)
    shown = [state, state.inner, state.linear, films, films.inner]
    for one in shown:
        text = repr(one)
        assert len(text.splitlines()) <= 12 and max(map(len, text.splitlines())) <= 100, text
    assert f"pressure: 9, {state.inner.pressure.min():.6g} to" in repr(state.inner)
    assert f"shift: [{state.shift[0]:.6g}, " in repr(state)
    assert "inner: Contacts of overlap, load, angle, a, b, pressure" in repr(state)
    assert not np.isnan(state.residual)


def test_a_bearing_in_millimetres():
    sizes = {"ball_diameter": 12.6, "inner_radius": 24.0, "outer_radius": 36.6}
    grooves = {"inner_groove": 6.552, "outer_groove": 6.552}
    with pytest.warns(UserWarning, match="ball_diameter = 12.6 m: sizes are in metres, 12.6 mm is"):
        Bearing(9, **sizes, **grooves)
