# SPDX-License-Identifier: GPL-2.0-or-later
"""Film thickness, damping and capacitance of every recorded contact agree with the formulas,
evaluated for the load and the speed of this contact."""

import numpy as np
import pytest
from host import QUICK, succeed
from raceway import capacitance, damping, film, hertz
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER


@pytest.fixture(scope="module", params=["radial", "printed", "preload", "play"])
def run(request, tmp_path_factory):
    """Run the main deck for one ball pass, and variants of it: with the central film as printed in
    the paper, with preload, and with clearance."""
    folder = tmp_path_factory.mktemp("main")
    deck = "inputs/in.6208"
    if request.param == "printed":
        from host import ROOT  # needed for a copy of the deck with one more keyword

        deck = folder / "in.printed"
        text = (ROOT / "inputs" / "in.6208").read_text()
        deck.write_text(
            text.replace("pair_coeff * * b\n", "pair_coeff * * b film masjedi/printed\n")
        )
    clearance = {"preload": -56.7e-6, "play": 56.7e-6}.get(request.param, 0.0)
    succeed(deck, out=folder / "run", passes=1, clearance=clearance, **QUICK)
    result = RunTables(folder / "run")
    result.printed = request.param == "printed"
    return result


@pytest.mark.parametrize("side", [INNER, OUTER])
def test_contacts(run, side):
    """Columns and formulas agree within a relative error of 1e-9."""
    settings = run.settings
    bearing = run.geometry
    rows = run.contacts
    rows = rows[(rows["raceway"] == side) & (rows["load"] > 0)]
    assert len(rows) > 200
    # the load is radial, so the formulas below apply at a contact angle of 0
    assert np.all(np.abs(rows["angle"]) < 1e-6)
    modulus = bearing.effective_modulus
    r_x, r_y = bearing.effective_radii(side, 0.0, settings["clearance_m"])
    ellipse = hertz.exact(r_x, r_y)
    load, speed = rows["load"].to_numpy(), rows["entrainment"].to_numpy()
    group = film.group(
        settings["viscosity_Pa_s"],
        settings["pressure_viscosity_per_Pa"],
        modulus,
        r_x,
        ellipse.kappa,
        speed,
        load,
    )
    a, b = hertz.semi_axes(ellipse, modulus, load)
    pressure = hertz.pressure(ellipse, modulus, load)
    h_min, h_c = film.h_min(r_x, group), film.h_c(r_x, group, printed=run.printed)
    expected = {
        "a": a,
        "b": b,
        "pressure": pressure,
        "h_min": h_min,
        "h_c": h_c,
        "lambda": film.ratio(h_min, settings["roughness_m"]),
        "damping": (
            damping.hysteretic(load)
            + damping.film(
                settings["viscosity_Pa_s"],
                a,
                bearing.ball_radius,
                np.maximum(h_min, settings["roughness_m"]),
            )
        ),
        "capacitance": capacitance.contact(settings["permittivity"], pressure, a, b, h_c),
    }
    for name, value in expected.items():
        np.testing.assert_allclose(rows[name], value, rtol=1e-9, err_msg=name)


def test_bearing_total(run):
    """The capacitance of the bearing in the record equals eq 12, evaluated for its contacts."""
    rows = run.contacts.pivot_table(
        index=["sample", "ball"], columns="raceway", values="capacitance"
    ).dropna()
    total = (rows[INNER] * rows[OUTER] / (rows[INNER] + rows[OUTER])).groupby("sample").sum()
    rings = run.rings.set_index("sample")["capacitance"]
    assert len(rings) == 201
    np.testing.assert_allclose(rings, total.loc[rings.index], rtol=1e-13)
