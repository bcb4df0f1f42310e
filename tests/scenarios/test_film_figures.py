# SPDX-License-Identifier: GPL-2.0-or-later
"""If resistivity, frequency and strength are given, the leakage, impedance, threshold, energy and
Hertz area from fix bearing/capacitance agree with those that the Python package computes from the
record of the same run (T11)."""

import numpy as np
import pytest
import raceway
from host import columns, refuses, succeed
from raceway import film_figures, impedance, whole_capacitance
from raceway.theory.capacitance import VACUUM
from raceway.theory.electric_point import Ask

CASE = "tests/implicit/in.case"
SPIN = "x free y free spin speed 150 force 0 -800 0 ramp 3.0e-3"
EPS, RHO, HERTZ, STRENGTH, BESIDE = 2.25, 3e9, 2e3, 20e6, 30e-12
ASKED = f"resistivity {RHO} frequency {HERTZ} strength {STRENGTH}"
FIGURES = "leak impedance phase threshold threshold_peaks energy hertz_area".split()
ASK = Ask(strength=STRENGTH, frequency=HERTZ, resistivity=RHO)


def measured(folder, words, record=True, samples=60):
    """Return (columns of the fix's file by name, the run), where the run is None if there is no
    record."""
    folder.mkdir()
    (folder / "more").write_text(
        f"fix cap balls bearing/capacitance 1 permittivity {EPS} {words} file {folder}/totals.txt\n"
        + (f"fix rec all bearing/record 1 {folder}/rec contacts all\n" if record else "")
    )
    succeed(CASE, out=folder, more=folder / "more", inner=SPIN, samples=samples, clearance=2e-5)
    return columns(folder / "totals.txt"), raceway.open(folder / "rec") if record else None


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    return measured(
        tmp_path_factory.mktemp("figures") / "run", f"surroundings cavitated 1.2 {ASKED}"
    )


def test_the_fix_gives_the_numbers_of_python(pair):
    rows, of = pair
    whole = whole_capacitance.over_time(of)
    assert whole.attrs["source"] == "record"
    found = film_figures.over_time(of, whole, ASK)
    names = list(rows)[-len(FIGURES) :]
    for ours, name in zip(FIGURES, names, strict=True):
        np.testing.assert_allclose(rows[name], found[ours], rtol=3e-9, err_msg=name)
    assert 0 < np.ptp(rows["impedance"]) and 0 < np.ptp(rows["leak"])
    assert np.all(rows["threshold_voltage_local"] < rows["threshold_voltage"])
    parts = found["plates"] + found["around"] + found["unloaded"]
    np.testing.assert_allclose(parts, rows["capacitance_total"], rtol=1e-10)
    np.testing.assert_allclose(found["plates"], rows["capacitance"], rtol=1e-10)
    # at the threshold, the largest field equals the dielectric strength
    at = film_figures.over_time(of, whole, ASK._replace(voltage=float(found["threshold"][9])))
    assert float(at["field"][9]) == pytest.approx(STRENGTH, rel=1e-12)


def test_impedance_is_that_of_the_whole(pair):
    """Far above the corner frequency, the impedance is determined by the capacitance alone, and far
    below it by the leakage alone."""
    _, of = pair
    whole = whole_capacitance.over_time(of)
    z = film_figures.spectrum(whole, np.array([1e-4, 1e8]), RHO)
    fast = impedance.capacitance_of(z[:, 1].to_numpy(), 1e8)
    np.testing.assert_allclose(fast, whole["bearing"], rtol=1e-9)
    leak = film_figures.over_time(of, whole, ASK)["leak"]
    np.testing.assert_allclose(np.abs(z[:, 0]), leak, rtol=1e-4)


def test_one_fill_relaxes_with_its_resistivity(tmp_path):
    """At the first sample there is no contact yet and the bearing is flooded, so that
    R C = rho eps_0 eps."""
    rows, _ = measured(tmp_path / "run", f"surroundings flooded {ASKED}", False, 1)
    none = rows["capacitance"] == 0
    assert none[0] and rows["hertz_area"][0] == 0
    product = rows["leak"][0] * rows["capacitance_total"][0]
    assert product == pytest.approx(RHO * VACUUM * EPS, rel=1e-11)


def test_plates_alone_and_a_background(tmp_path):
    """Without surroundings, a ball that is not in contact is an open circuit. The background
    capacitance is in parallel with the films."""
    rows, of = measured(tmp_path / "run", f"background {BESIDE} {ASKED}")
    whole = of.contacts
    area = np.pi * (whole["a"] * whole["b"]).fillna(0.0).sum(("raceway", "ball"))
    np.testing.assert_allclose(rows["hertz_area"], area, rtol=1e-9)
    omega = 2 * np.pi * HERTZ
    ball = whole["capacitance"].fillna(0.0).transpose("raceway", "time", "ball").to_numpy()
    paths = (np.pi * whole["a"] * whole["b"] / whole["h_c"]).fillna(0.0)
    paths = paths.transpose("raceway", "time", "ball").to_numpy()
    film = paths / RHO + 1j * omega * ball
    both = film.prod(0) / np.where(film.sum(0) == 0, 1, film.sum(0))
    z = 1 / (both.sum(1) + 1j * omega * BESIDE)
    np.testing.assert_allclose(rows["impedance"], np.abs(z), rtol=1e-9)
    np.testing.assert_allclose(rows["phase"], np.angle(z), rtol=1e-9)
    energy = rows["capacitance"] * rows["threshold_voltage"] ** 2 / 2
    np.testing.assert_allclose(rows["threshold_energy"], energy, rtol=1e-10)


def test_instants_have_them(tmp_path):
    """The values at the last instant of a step equal those of a sample at the end of the step."""
    words = f"surroundings dry {ASKED}"
    one, _ = measured(tmp_path / "one", words, False, 6)
    many, _ = measured(tmp_path / "many", f"within 5 {words}", False, 6)
    assert len(many["time"]) == 31
    for name, values in one.items():
        np.testing.assert_array_equal(many[name][::5], values, err_msg=name)
    assert np.all(many["impedance"] > 0)


@pytest.mark.parametrize(
    "words, message",
    [
        ("resistivity 0", "resistivity of the lubricant (ohm m)"),
        ("frequency -1", "frequency of the impedance (Hz)"),
        ("strength x", "dielectric strength of a film (V/m)"),
    ],
)
def test_bad_words(tmp_path, words, message):
    more = tmp_path / "more"
    more.write_text(f"fix cap balls bearing/capacitance 1 permittivity 2.25 {words}\n")
    refuses(CASE, message, "fix cap bearing/capacitance", out=tmp_path, more=more, samples=1)
