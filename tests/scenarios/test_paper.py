# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway paper`, all of it, against the record in docs/paper."""

import pandas as pd
import pytest
from host import ROOT
from raceway.cli import main
from raceway.paper.figures import FIGURES
from raceway.paper.tables import TABLES

RECORD = ROOT / "docs/paper"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The folder with everything the command makes."""
    out = tmp_path_factory.mktemp("paper")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(ROOT)
        assert main(["paper", "--out", str(out), "--runs", str(out / "runs")]) == 0
    return out


def test_everything_is_there(made):
    for name in FIGURES:
        picture = (made / f"fig_{name}.png").read_bytes()
        # not empty, fit for the docs
        assert picture[:4] == b"\x89PNG" and 20_000 < len(picture) < 150_000, name
        assert len(pd.read_csv(made / f"fig_{name}.csv")) > 5
    for name in TABLES:
        assert len(pd.read_csv(made / f"{name.replace('-', '_')}.csv")) > 3


def test_the_record_has_nothing_else(made):
    files = {path.name for path in made.iterdir()} - {"runs"}
    assert {path.name for path in RECORD.iterdir()} == files


def test_verdicts(made):
    new, old = (
        pd.read_csv(folder / "statements.csv", keep_default_na=False) for folder in (made, RECORD)
    )
    for column in ("says", "corrected", "printed", "whole"):
        assert list(new[column]) == list(old[column])


def test_static_theory(made):
    numbers = pd.read_csv(made / "quantities.csv").set_index(["formulas", "quantity"])["value"]
    # 0.1 %: C goes as U^-0.7, and the speed of the runs differs by 0.1 % from that of undeformed
    # radii
    assert numbers["corrected", "theory_ball"] < 1e-3
    assert numbers["corrected", "theory_bearing"] < 1e-3


def test_numbers(made):
    new, old = (
        pd.read_csv(folder / "quantities.csv", keep_default_na=False).set_index(
            ["formulas", "quantity"]
        )
        for folder in (made, RECORD)
    )
    assert list(new.index) == list(old.index)
    # 1 %: three digits are shown. Differences (%) and azimuths (degrees) are errors, no results:
    # verdicts hold them.
    results = old[~old["unit"].isin(["%", "°"])].index
    for key in results:
        assert new.loc[key, "value"] == pytest.approx(old.loc[key, "value"], rel=1e-2, abs=1e-12), (
            key
        )
