# SPDX-License-Identifier: GPL-2.0-or-later
"""The run folder: settings are read as text and as numbers, samples are read as tables, and a
damaged folder causes an error message."""

import numpy as np
import pandas as pd
import pytest
import synthetic
from bearings import B6208
from raceway.errors import RunError
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from synthetic import spoil


def test_settings(folder, lubricated):
    run = RunTables(folder)
    assert run.settings["bearing"] == "6208"  # the name looks like a number
    assert run.settings["clearance_m"] == 1e-5
    assert run.lubricated and run.finished
    told = lubricated["settings"]
    assert {key: run.settings[key] for key in told} == told


@pytest.mark.parametrize("name", ["dry", "none"])
def test_dry_needs_no_lubricant(tmp_path, dry, name):
    other = synthetic.changed(dry, lubricant=name)
    assert not RunTables(synthetic.write(tmp_path, other)).lubricated


@pytest.mark.parametrize(
    "pattern, replacement, said",
    [
        ("^wall_s:.*", "wall_s: fast", "run.yaml: wall_s is not a number: 'fast'"),
        ("^wall_s:.*", "wall_s: .inf", "wall_s is not a number: '.inf'"),
        ("^wall_s:.*", "wall_s: [1, 2]", "wall_s is not a number"),
        ("^wall_s:.*", "wall_s: [1", "cannot read .*run.yaml: .*\n.*line [0-9]+"),
        ("^load_N: .*$", r"\g<0>\nload_N: 1", "cannot read .*run.yaml: load_N is given twice"),
        ("^step_s: .*", "step_s: -1", "step_s = -1 must be finite and not negative"),
        ("^wall_s: .*", "wall_s: inf", "wall_s = inf must be finite and not negative"),
        ("^wall_s: .*", "wall_s: 0", "wall_s = 0 must be positive"),
        ("^simulated_s: .*", "simulated_s: 0", "belongs to a different run than run.yaml"),
        (r"\A[\s\S]*\Z", "a: " + 9000 * "[" + 9000 * "]", "cannot read .*run.yaml: "),
    ],
)
def test_spoilt_run_yaml(folder, pattern, replacement, said):
    spoil(folder, pattern, replacement)
    with pytest.raises(RunError, match=said):
        RunTables(folder)


@pytest.mark.parametrize(
    "pattern, said",
    [
        ("^wall_s:.*\n", "no wall_s$"),
        (r"\n\Z", "no step_s and no simulated_s and no wall_s$"),
        ("^simulated_s:.*\nwall_s:.*\n", "no simulated_s and no wall_s$"),
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


def test_blocks_are_the_whole(folder, small_blocks):
    for name in ("contacts", "balls"):
        whole = getattr(RunTables(folder), name)
        blocks = list(RunTables(folder).blocks(name))
        assert len(blocks) > 3
        assert pd.concat(blocks).reset_index(drop=True).equals(whole)
        ends = [block.attrs["first"] + block.attrs["samples"] for block in blocks]
        assert [block.attrs["first"] for block in blocks] == [0, *ends[:-1]] and ends[-1] == 49


def test_parts_of_kept_numbers_are_not_read_again(folder, small_blocks, monkeypatch):
    """A summary reads the whole record for one number per sample only once, whatever the ranges."""
    names = ["time", "ring_x", "bearing_contacts"]
    parts = [RunTables(folder).record.read(names, 20, stop) for stop in (48, None)]
    record, scans = RunTables(folder).record, []
    scan = type(record)._scan
    monkeypatch.setattr(type(record), "_scan", lambda *a: scans.append(a[2:]) or scan(*a))
    record.read(names)
    for part, stop in zip(parts, (48, None)):
        again = record.read(names, 20, stop)
        assert all(np.array_equal(again[name], part[name], equal_nan=True) for name in names)
    assert scans == [(0, 49)]


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
    with pytest.raises(RunError, match="has 49 samples, none from number 49 on"):
        RunTables(folder, slice(49, None)).contacts
    for wrong in (slice(3, 3), slice(-1, 4), slice(0, 9, 2)):
        with pytest.raises(ValueError, match="must be slice"):
            RunTables(folder, wrong)


def test_geometry(folder):
    assert RunTables(folder).geometry == B6208


@pytest.mark.parametrize(
    "made, said",
    [
        (None, "is not a folder: a run with -var out NAME creates one"),
        ("run.yaml", "has no record.nc: its run recorded nothing, or the file was removed"),
        ("contacts.dump", "has text dumps but no record.nc: raceway reads records; run the deck"),
    ],
)
def test_no_record(tmp_path, made, said):
    folder = tmp_path / "run"
    if made:
        folder.mkdir()
        (folder / made).write_text("")
    with pytest.raises(RunError, match=f"{folder} {said}"):
        RunTables(folder)


def test_contacts(folder, lubricated):
    contacts = RunTables(folder).contacts
    expected = np.array([row for frame in lubricated["contacts"] for row in sorted(frame)])
    rows = contacts.sort_values(["sample", "ball", "raceway"], kind="stable")
    assert np.array_equal(rows[synthetic.LUBRICATED].to_numpy(), expected)
    assert contacts.attrs["samples"] == len(lubricated["contacts"])


def test_balls(folder, lubricated):
    """Positions and velocities of balls, cage balls and rings are read bitwise identically."""
    rows = RunTables(folder).balls.sort_values(["sample", "id"])
    expected = [sorted(frame) for frame in lubricated["balls"]]
    assert np.array_equal(rows[synthetic.BALL_COLUMNS].to_numpy(), np.concatenate(expected))


def test_azimuth_counts_from_the_load_line(folder):
    run = RunTables(folder)  # the load points to -90 degrees
    assert run.from_load_line(np.array([-np.pi / 2, 0, np.pi - 0.1])) == pytest.approx(
        [0, np.pi / 2, -np.pi / 2 - 0.1]
    )
    assert run.passes(24) == pytest.approx(1, rel=1e-12)


def test_pair_needs_both_raceways(tmp_path, lubricated):
    data = dict(lubricated, contacts=[list(frame) for frame in lubricated["contacts"]])
    before = RunTables(synthetic.write(tmp_path / "a", data))
    # one outer contact is removed
    first = next(i for i, row in enumerate(data["contacts"][0]) if row[2] == 1)
    lost = data["contacts"][0].pop(first)
    after = RunTables(synthetic.write(tmp_path / "b", data))
    assert len(after.pairs) == len(before.pairs) - 1
    assert not ((after.pairs["sample"] == 0) & (after.pairs["ball"] == lost[0])).any()


def test_pairs_are_in_series(folder):
    """The capacitance of the bearing in the record equals the sum over its balls, each of which is
    a pair of capacitors in series."""
    run = RunTables(folder)
    total = run.pairs.groupby("sample")["capacitance"].sum()
    np.testing.assert_allclose(total, run.bearing_capacitance, rtol=1e-13)
