# SPDX-License-Identifier: GPL-2.0-or-later
"""A result is given with a range if the uncertainty of its model is known."""

import pytest
from raceway import asperity, film, film_factors, hertz
from raceway.runs.model_range import model_ranges
from raceway.runs.summary import summary
from raceway.runs.summary_table import reasons, table
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER
from synthetic import changed, write

OWN = ("h_min_m", "h_c_m", "lambda", "capacitance_F", "capacitance_top_F")


def test_the_figure_lies_inside(folder):
    figures = summary(RunTables(folder))
    ranges = figures["model_ranges"]
    assert set(OWN) == set(ranges)
    for key, one in ranges.items():
        assert 0 < one["low"] < figures[key] < one["high"], key
    text = table(figures)
    assert "Known ranges of the model" in text
    for reason in reasons(figures):
        assert reason in text
    assert any(one.startswith("minimum film thickness, central film") for one in reasons(figures))


@pytest.mark.parametrize("given, ends", [(1.5e-7, (1.5e-7, 1.5e-7)), (1e-7, (0.5e-7, 3e-7))])
def test_film_parameter(tmp_path, lubricated, given, ends):
    """For the roughness in the file, 0.1 um, the range is 0.5 to 3 times this value. A roughness
    set by the user is assumed to be exact."""
    folder = write(tmp_path, changed(lubricated, roughness_m=given))
    ranges = summary(RunTables(folder))["model_ranges"]
    film_range, ratio = ranges["h_min_m"], ranges["lambda"]
    assert ratio["low"] == pytest.approx(film_range["low"] / ends[1], rel=1e-12)
    assert ratio["high"] == pytest.approx(film_range["high"] / ends[0], rel=1e-12)


def test_values_given_outright_have_no_range(tmp_path, lubricated):
    """Here, the range of the film follows from the laws alone; it is computed for the top
    contact."""
    own = changed(lubricated, viscosity_Pa_s=0.05, pressure_viscosity_per_Pa=2e-8)
    tables = RunTables(write(tmp_path, own))
    figures = summary(tables)
    bearing, speed = tables.geometry, figures["entrainment_speed_m_s"]
    r_x, r_y = bearing.effective_radii(INNER, 0.0, figures["clearance_m"])
    kappa = hertz.exact(r_x, r_y).kappa
    modulus, load = bearing.effective_modulus, figures["q_inner_max_N"]
    group = film.group(0.05, 2e-8, modulus, r_x, kappa, speed, load)
    other = film.hamrock_dowson_c(r_x, group) / film.h_c(r_x, group)
    loading = film_factors.thermal_loading(0.047, 0.05, speed, 0.134)  # data of mineral
    shear = [film_factors.murch_wilson(loading), film_factors.wilson(loading)]
    shear.append(film_factors.gupta(loading, figures["p_max_inner_Pa"] / modulus))
    found = model_ranges(tables, figures)["h_c_m"]
    assert found.low == pytest.approx(figures["h_c_m"] * min(1, other) * min(1, *shear), rel=1e-9)
    assert found.high == pytest.approx(figures["h_c_m"] * max(1, other), rel=1e-9)
    assert "viscosity" not in found.why


def test_laws_of_asperities_and_torque(folder):
    tables = RunTables(folder)
    figures = {**summary(tables), "asperity_share": 0.06, "lambda": 1.41, "models": "full"}
    figures.update(friction_torque_N_m=0.1, torque_skf_N_m=0.12, torque_palmgren_N_m=0.08)
    found = model_ranges(tables, figures)
    laws = [asperity.olver_spikes(1.41), asperity.clarke(1.41), asperity.zhou_hoeprich(1.41)]
    assert found["asperity_share"][:2] == pytest.approx((min(laws), max(laws)), rel=1e-12)
    assert found["friction_torque_N_m"][:2] == (0.08, 0.12)
    figures["models"] = "paper"  # in this model the torque does not include rolling resistance
    assert "friction_torque_N_m" not in model_ranges(tables, figures)


def test_dry_and_unknown_lubricants(tmp_path, lubricated, dry_folder):
    assert summary(RunTables(dry_folder))["model_ranges"] is None
    folder = write(tmp_path / "mine", changed(lubricated, lubricant="mine"))
    assert summary(RunTables(folder))["model_ranges"] is None
