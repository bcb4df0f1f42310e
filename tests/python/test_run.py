# SPDX-License-Identifier: GPL-2.0-or-later
"""The run folder: settings as text and numbers, and what a spoilt one says."""

import re

import numpy as np
import pandas as pd
import pytest
import synthetic
from raceway.errors import RunError, RunWarning
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables


def spoil(folder, pattern, replacement, name="run.yaml"):
    path = folder / name
    text, count = re.subn(pattern, replacement, path.read_text(), count=1, flags=re.MULTILINE)
    assert count == 1
    path.write_text(text)


def test_settings(folder):
    run = RunTables(folder)
    assert run.settings["bearing"] == "6208"  # a name, though it looks like a number
    assert run.settings["clearance_m"] == 1e-5  # printed 1e-05, which YAML 1.1 takes for text
    assert run.lubricated


@pytest.mark.parametrize("name", ["dry", "none"])
def test_dry_needs_no_lubricant(dry_folder, name):
    spoil(dry_folder, "^lubricant: dry", f"lubricant: {name}")
    assert not RunTables(dry_folder).lubricated


@pytest.mark.parametrize(
    "pattern, replacement, said",
    [
        ("^rpm:.*\n", "", "has no rpm"),
        ("^viscosity_Pa_s:.*\n", "", "has no viscosity_Pa_s"),
        ("^rpm:.*", "rpm: fast", "rpm is not a number: 'fast'"),
        ("^rpm:.*", "rpm: .inf", "rpm is not a number: '.inf'"),
        ("^rpm:.*", "rpm: [1, 2]", "rpm is not a number"),
        ("^samples_per_pass:.*", "samples_per_pass: 0", "samples_per_pass = 0 must be positive"),
        ("^rpm:.*", "rpm: [1", "line [0-9]+: "),
        (r"\A[\s\S]*\Z", "words\n", "not a list of 'name: value'"),
    ],
)
def test_spoilt_settings(folder, pattern, replacement, said):
    spoil(folder, pattern, replacement)
    with pytest.raises(RunError, match=said):
        RunTables(folder)


@pytest.mark.parametrize(
    "pattern, said",
    [
        ("^wall_s:.*\n", "no wall_s$"),
        ("^wall_s:.*\n(.*\n)*?simulated_s:.*\n", "no simulated_s and no wall_s$"),
    ],
)
def test_unfinished_run_gives_its_tables_and_no_figures(folder, pattern, said):
    whole = RunTables(folder)
    spoil(folder, pattern, "")
    run = RunTables(folder)
    assert whole.finished and not run.finished
    for name in ("contacts", "balls", "rings"):
        assert getattr(run, name).equals(getattr(whole, name))
    for refused in (run.need_finished, lambda: summary(run)):
        with pytest.raises(RunError, match="^run has not finished: .*run.yaml has " + said):
            refused()


def test_growing_run(folder):
    """Every file may end anywhere; a later look sees more."""
    for name in ("contacts.dump", "balls.dump", "rings.dat"):
        path = folder / name
        path.write_bytes(path.read_bytes()[: path.stat().st_size * 2 // 3])
    with pytest.warns(RunWarning):
        tables = [getattr(RunTables(folder), name) for name in ("contacts", "balls", "rings")]
    assert all(0 < table["sample"].max() < 48 for table in tables)  # of 49


def test_blocks_are_the_whole(folder, monkeypatch):
    for name in ("contacts", "balls"):
        whole = getattr(RunTables(folder), name)
        monkeypatch.setattr("raceway.runs.dump.BLOCK", 10_000)
        blocks = list(RunTables(folder).blocks(name))
        assert len(blocks) > 3
        assert pd.concat(blocks).reset_index(drop=True).equals(whole)
        ends = [block.attrs["first"] + block.attrs["samples"] for block in blocks]
        assert [block.attrs["first"] for block in blocks] == [0, *ends[:-1]] and ends[-1] == 49
        monkeypatch.undo()


@pytest.mark.parametrize("window", [slice(0, 5), slice(7, 20), slice(40, None)])
def test_window_of_samples(folder, window):
    some, whole = RunTables(folder, window), RunTables(folder)
    for name in ("contacts", "balls", "rings"):
        table = getattr(whole, name)
        last = 49 if window.stop is None else window.stop
        kept = table[(table["sample"] >= window.start) & (table["sample"] < last)].reset_index(
            drop=True
        )
        assert getattr(some, name).equals(kept)
    assert some.contacts.attrs == {"first": window.start, "samples": last - window.start}
    assert some.totals.equals(whole.totals.loc[window.start : last - 1])


def test_window_outside_the_run(folder):
    with pytest.raises(RunError, match="holds 49 complete frames, none from number 49 on"):
        RunTables(folder, slice(49, None)).contacts
    for wrong in (slice(3, 3), slice(-1, 4), slice(0, 9, 2)):
        with pytest.raises(ValueError, match="must be slice"):
            RunTables(folder, wrong)


def test_geometry(folder):
    assert RunTables(folder).geometry == synthetic.DEEP_GROOVE


def test_no_folder(tmp_path):
    with pytest.raises(RunError, match="cannot read .*run.yaml: No such file"):
        RunTables(tmp_path / "nowhere")


def test_column_names(folder):
    spoil(folder, " overlap ", " load ")
    with pytest.raises(RunError, match="contact_columns names load twice"):
        RunTables(folder).contacts


def test_column_needed(folder):
    spoil(folder, "^(contact_columns: .*) load ", r"\1 weight ")
    with pytest.raises(RunError, match="contacts.dump has no column load"):
        RunTables(folder).contacts


def test_contacts(folder, lubricated):
    contacts = RunTables(folder).contacts
    expected = np.array([row for frame in lubricated["contacts"] for row in frame])
    assert np.array_equal(contacts[synthetic.LUBRICATED].to_numpy(), expected)
    assert contacts.attrs["samples"] == len(lubricated["contacts"])


def test_azimuth_counts_from_the_load_line(folder):
    run = RunTables(folder)  # loaded towards -90 degrees
    assert run.from_load_line(np.array([-np.pi / 2, 0, np.pi - 0.1])) == pytest.approx(
        [0, np.pi / 2, -np.pi / 2 - 0.1]
    )
    assert run.passes(24) == 1


def test_pair_needs_both_raceways(tmp_path, lubricated):
    data = dict(lubricated, contacts=[list(frame) for frame in lubricated["contacts"]])
    before = RunTables(synthetic.write(tmp_path / "a", data))
    # one outer contact goes
    first = next(i for i, row in enumerate(data["contacts"][0]) if row[2] == 1)
    lost = data["contacts"][0].pop(first)
    after = RunTables(synthetic.write(tmp_path / "b", data))
    assert len(after.pairs) == len(before.pairs) - 1
    assert not ((after.pairs["sample"] == 0) & (after.pairs["ball"] == lost[0])).any()
    assert after.bearing_capacitance[0] < before.bearing_capacitance[0]
    assert np.array_equal(after.bearing_capacitance[1:], before.bearing_capacitance[1:])
