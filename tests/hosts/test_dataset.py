# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway dataset` with the real program: the files and labels it writes, how it resumes,
and how it treats folders with other contents."""

import json

import numpy as np
import pandas as pd
import pytest
from host import ROOT
from raceway.cli import main
from raceway.datasets import make
from scipy import io

SPEC = """\
title: Two records
bearing: 6205
deck: {settle: 1, models: paper}
flaws:
  none:
  outer: {length: 1.0e-3}
conditions: {load: 500, rpm: 10000, lubricant: vg46, seed: 3}
record: {seconds: 0.01, rates: [12000, 48000], files: [mat, parquet]}
"""


pytestmark = pytest.mark.usefixtures("in_the_tree")


def dataset(folder, text=SPEC, *more):
    spec = folder / "spec.yaml"
    spec.write_text(text)
    return main(["dataset", str(spec), "--out", str(folder / "set"), *more])


def signal_of(folder, record, rate):
    return io.loadmat(folder / "set" / f"{rate // 1000}k" / f"{record:04d}.mat")


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("dataset")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(ROOT)
        assert dataset(folder) == 0
    return folder


def test_files(made):
    table = pd.read_csv(made / "set/labels.csv", dtype={"record": str}, keep_default_na=False)
    assert list(table["class"]) == ["none", "outer"] and list(table["record"]) == ["0001", "0002"]
    assert list(table["size_m"]) == [0, 1e-3] and list(table["load"]) == [500, 500]
    for row in table.to_dict("records"):
        number = int(row["record"])
        for rate in (12000, 48000):
            data = io.loadmat(made / "set" / row[f"file_{rate // 1000}k"])
            values = data[f"X{number:03d}_DE_time"]
            assert values.shape == (rate // 100, 1) and np.isfinite(values).all()
            assert data[f"X{number:03d}RPM"] == 10000 and data["sampling_Hz"] == rate
            assert data["fault"] == row["class"] and data["fault_size_m"] == row["size_m"]
        assert values.std() == pytest.approx(row["rms_m_s2"])
        run = made / "set/runs" / row["record"]
        assert (run / "summary.json").exists() and not (run / "record.nc").exists()
        assert row["BPFO_Hz"] == pytest.approx(9 * row["FTF_Hz"])
        assert row["BPFO_Hz"] == pytest.approx(597.5, rel=0.01)
    quiet, loud = table["rms_m_s2"]
    assert loud > 100 * quiet


def test_rates_hold_the_same_signal(made):
    """The 12 kHz signal equals every fourth sample of the 48 kHz signal, except for components that
    cannot be represented at 12 kHz."""
    fast, slow = (signal_of(made, 2, rate)["X002_DE_time"].ravel() for rate in (48000, 12000))
    low = np.fft.rfft(fast)[: int(0.35 * len(slow))] / len(fast)
    own = np.fft.rfft(slow)[: len(low)] / len(slow)
    # the ends differ, because the record is not a whole number of periods long
    assert np.abs(own - low).max() < 0.1 * np.abs(low).max()


def test_parquet_is_the_same_signal(made):
    table = pd.read_parquet(made / "set/48k/0002.parquet", engine="pyarrow")
    assert list(table) == ["time_s", "acceleration_m_s2"]
    values = signal_of(made, 2, 48000)["X002_DE_time"].ravel()
    assert (table["acceleration_m_s2"] == values).all()
    assert table["time_s"].to_numpy() == pytest.approx(np.arange(480) / 48000, abs=1e-15)


def test_parquet_without_its_library(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert dataset(tmp_path) == 1
    assert "pip install 'raceway[parquet]'" in capsys.readouterr().err
    assert not (tmp_path / "set").exists()


def test_card(made):
    card = (made / "set/README.md").read_text()
    assert "# Two records" in card and "2 of 2 records of 0.01 s" in card
    for heading in ("## What is simulated", "## What is assumed", "## Noise floor"):
        assert heading in card
    assert "Records without a flaw have an rms of" in card and "No noise was added" in card
    assert max(map(len, card.splitlines())) <= 100


def test_goes_on(made, tmp_path, monkeypatch):
    """If the command is stopped while it writes the files of a record, running it again completes
    the data set with the same signals."""

    def stop(one, *_):
        raise KeyboardInterrupt

    monkeypatch.setattr(make, "_write", stop)
    assert dataset(tmp_path, SPEC, "--jobs", "1") == 130
    assert not list((tmp_path / "set").glob("*/*.mat"))
    done = len(list((tmp_path / "set/runs").glob("*/summary.json")))
    assert done >= 1
    monkeypatch.undo()
    monkeypatch.chdir(ROOT)
    assert dataset(tmp_path) == 0
    for number in (1, 2):
        name = f"X{number:03d}_DE_time"
        own, other = (signal_of(at, number, 48000)[name] for at in (tmp_path, made))
        assert np.array_equal(own, other)


def test_makes_again_what_is_gone(made):
    labels = (made / "set/labels.csv").read_bytes()
    before = signal_of(made, 1, 12000)["X001_DE_time"]
    (made / "set/12k/0001.mat").unlink()
    other = (made / "set/12k/0002.mat").stat().st_mtime_ns
    assert dataset(made) == 0
    assert np.array_equal(signal_of(made, 1, 12000)["X001_DE_time"], before)
    assert (made / "set/12k/0002.mat").stat().st_mtime_ns == other
    assert (made / "set/labels.csv").read_bytes() == labels


def test_another_set_is_refused(made, tmp_path, capsys):
    spec = SPEC.replace("load: 500", "load: 600")
    assert dataset(made, spec) == 1
    assert "contains another data set" in capsys.readouterr().err
    (tmp_path / "set").mkdir()
    (tmp_path / "set/mine.txt").write_text("mine")
    assert dataset(tmp_path) == 1
    assert "contains other files" in capsys.readouterr().err
    assert [path.name for path in (tmp_path / "set").iterdir()] == ["mine.txt"]


def test_a_run_that_fails_is_named(tmp_path, capsys):
    assert dataset(tmp_path, SPEC.replace("load: 500", "load: [500, 2e7]")) == 1
    assert "2 of 4 runs failed" in capsys.readouterr().err
    failed = json.loads((tmp_path / "set/runs/0002/failed.json").read_text())
    assert "load" in failed["message"]
    assert len(pd.read_csv(tmp_path / "set/labels.csv")) == 2
