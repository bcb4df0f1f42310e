# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities as functions of the position around the ring (regimes, pressure, permittivity, losses)
are compared with sums over the rows of the run."""

import numpy as np
import pytest
import raceway
import synthetic
from raceway import capacitance, electrical, losses, regimes
from raceway.errors import RunError
from raceway.runs import around

COLUMN = {name: i for i, name in enumerate(synthetic.LUBRICATED)}
BINS = 12


@pytest.fixture
def run(folder, small_blocks):
    """Return a run that is read in blocks of a few samples: the results must not depend on the
    block boundaries."""
    return raceway.open(folder)


def rows_of(data, side, part):
    """Yield the rows of the contacts whose azimuth, relative to the load line at -90 degrees, lies
    in the given part of the ring."""
    for row in (row for frame in data["contacts"] for row in frame):
        psi = np.mod(row[COLUMN["azimuth"]] + np.pi / 2 + np.pi, 2 * np.pi) - np.pi
        if row[COLUMN["raceway"]] == side and part == int((psi + np.pi) / (2 * np.pi) * BINS):
            yield {name: row[i] for name, i in COLUMN.items()}


def test_means_and_counts(run, lubricated):
    result = around.around(run, {"load": lambda table: table["load"]}, BINS)
    counted = 0
    for side, name in enumerate(("inner", "outer")):
        for part in range(BINS):
            loads = [row["load"] for row in rows_of(lubricated, side, part)]
            one = result.sel(raceway=name).isel(from_load_line=part)
            assert int(one["contacts"]) == len(loads)
            assert float(one["load"]) == pytest.approx(
                np.mean(loads) if loads else np.nan, rel=1e-13, nan_ok=True
            )
            counted += len(loads)
    assert counted == sum(map(len, lubricated["contacts"]))
    middle = result["from_load_line"].to_numpy()
    assert middle == pytest.approx(-middle[::-1]) and middle[0] == pytest.approx(
        -np.pi + np.pi / BINS
    )


def test_bins(run):
    with pytest.raises(ValueError, match="bins = 0"):
        around.around(run, {}, 0)


@pytest.mark.parametrize("limits", [(1.0, 3.0), (1.6, 2.0)])
def test_regime_shares(run, lubricated, limits):
    result = regimes.shares(run, BINS, *limits)
    for side, name in enumerate(("inner", "outer")):
        for part in range(BINS):
            ratios = np.array([row["lambda"] for row in rows_of(lubricated, side, part)])
            if len(ratios):
                low, high = limits
                expected = [
                    np.mean(ratios < low),
                    np.mean((ratios >= low) & (ratios <= high)),
                    np.mean(ratios > high),
                ]
                one = result.sel(raceway=name).isel(from_load_line=part)
                assert one["share"].to_numpy() == pytest.approx(expected, rel=1e-13)
                assert float(one["lambda"]) == pytest.approx(ratios.mean(), rel=1e-13)
    whole = regimes.totals(run, *limits)
    assert whole.sum("regime").to_numpy() == pytest.approx([1, 1], rel=1e-13)
    ratios = [row["lambda"] for part in range(BINS) for row in rows_of(lubricated, 1, part)]
    assert float(whole.sel(raceway="outer", regime="boundary")) == pytest.approx(
        np.mean(np.array(ratios) < limits[0])
    )


def test_pressure_and_permittivity_by_raceway(run, lubricated):
    result = electrical.by_raceway(run, BINS)
    for side, name in enumerate(("inner", "outer")):
        rows = list(rows_of(lubricated, side, BINS // 2))  # close to the load line
        one = result.sel(raceway=name).isel(from_load_line=BINS // 2)
        pressure = np.array([row["pressure"] for row in rows])
        assert float(one["pressure"]) == pytest.approx(pressure.mean(), rel=1e-13)
        assert float(one["permittivity"]) == pytest.approx(
            capacitance.permittivity(2.2, pressure).mean(), rel=1e-13
        )
        assert float(one["capacitance"]) == pytest.approx(
            np.mean([row["capacitance"] for row in rows]), rel=1e-13
        )
    top = result.isel(from_load_line=BINS // 2)
    assert top["pressure"].sel(raceway="inner") > top["pressure"].sel(raceway="outer")
    assert top["permittivity"].sel(raceway="inner") > top["permittivity"].sel(raceway="outer") > 2.2


def test_capacitance_over_time(run):
    data = electrical.over_time(run, background=3e-11)
    series = 1 / (1 / data["contact"].where(data["contact"] > 0)).sum("raceway", skipna=False)
    np.testing.assert_allclose(data["one_ball"], series.fillna(0), rtol=1e-14)
    np.testing.assert_allclose(data["bearing"] - 3e-11, run.bearing["capacitance"], rtol=1e-12)
    assert data["one_ball"].dims == ("time", "ball") and data["bearing"].attrs["units"] == "F"


def test_losses(run, lubricated):
    data = losses.losses(run)
    for part, each in (("friction_power", 1e-6), ("damping_power", 2e-6)):
        loads = np.array(
            [sum(row[COLUMN["load"]] for row in frame) for frame in lubricated["contacts"]]
        )
        np.testing.assert_allclose(data[part], each * loads, rtol=1e-13)
    np.testing.assert_allclose(
        data["power_in"], data["friction_power"] + data["damping_power"], rtol=1e-13
    )
    np.testing.assert_allclose(data["torque"] * 477.5 * np.pi / 30, data["power_in"], rtol=1e-13)
    ring = losses.losses_around(run, BINS)
    total = sum(
        float((ring["contacts"] * ring[name]).sum()) for name in ("friction_power", "damping_power")
    )
    assert total == pytest.approx(float(data["power_in"].sum()), rel=1e-12)


def test_torque_of_a_ring_that_turns_the_other_way(tmp_path, lubricated):
    """In the mirror image, the spin and the moment change sign, whereas the resisting torque and
    the power remain the same."""
    mirrored = [[*ring[:8], -ring[8], *ring[9:14], -ring[14]] for ring in lubricated["rings"]]
    one = losses.losses(raceway.open(synthetic.write(tmp_path / "a", lubricated)))
    two = losses.losses(
        raceway.open(synthetic.write(tmp_path / "b", dict(lubricated, rings=mirrored)))
    )
    assert np.array_equal(one["torque"], two["torque"]) and np.array_equal(
        one["power_in"], two["power_in"]
    )
    assert float(one["torque"].min()) > 0


@pytest.mark.parametrize(
    "function", [regimes.shares, regimes.totals, electrical.over_time, electrical.by_raceway]
)
def test_dry(dry_folder, function):
    with pytest.raises(RunError, match="no film"):
        function(raceway.open(dry_folder))
