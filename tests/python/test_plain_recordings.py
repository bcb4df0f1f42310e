# SPDX-License-Identifier: GPL-2.0-or-later
"""Channels, times and units of recordings in plain columns: CSV, NPZ and WAV files as other
programs write them."""

import numpy as np
import pytest
from raceway import recording
from raceway.errors import RunError
from raceway.recordings.contents import GRAVITY
from scipy.io import wavfile

RATE = 48000.0  # Hz


@pytest.mark.parametrize("mark", [";", ";,", ",", "\t", "\t,", ",\t", "  "])
@pytest.mark.parametrize("head", [True, False])
@pytest.mark.parametrize("names", [["a_m_s2"], ["time_s", "a_m_s2", "b_g"]])
def test_separators(tmp_path, bearing, mark, head, names):
    """Files may have one or more columns, with or without a heading, after a comment. Numbers have
    decimal points or, if the separators are semicolons or tabs, decimal commas. Times without a
    heading are not a channel."""
    values = np.cos(np.arange(2400.0))
    table = np.column_stack([np.arange(len(values)) / RATE, values, values])[:, -len(names) :]
    mark, point = (mark[0], "," if names[1:] else ".") if mark[1:] == "," else (mark, ".")
    rows = [mark.join(f"{x:.9e}".replace(".", point) for x in row) for row in table]
    lines = [mark.join(names)] * head + rows
    (tmp_path / "a.csv").write_text("# a rig\n" + "\n".join(lines))
    rate = None if head and len(names) > 1 else RATE
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800, rate=rate)
    wanted = names[-2:] if head else [f"column_{k + 1}" for k in range(len(names))][-2:]
    assert list(found.channels) == wanted
    assert found.signal().values == pytest.approx(values, rel=1e-8)


@pytest.mark.parametrize("end", ["", ";"])
def test_decimal_commas_without_one_in_the_last_line(tmp_path, bearing, end):
    """A separator at the end of each row is not another cell."""
    rows = ["0,0;1,5", "0,5;-2,5", "1;3"]
    (tmp_path / "a.csv").write_text("\n".join(["# v. 2", "t;a.u.", *(row + end for row in rows)]))
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800)
    (one,) = found.channels.values()
    assert one.rate == 2 and one.values.tolist() == [1.5, -2.5, 3]


@pytest.mark.parametrize(
    "name, unit_s, index",
    [
        ("Time (s)", 1, False),
        ("time [ms]", 1e-3, False),
        ("t_us", 1e-6, True),
        ("Time", 1, True),
        ("", 1, False),
    ],
)
def test_times_and_numbers_of_rows(tmp_path, bearing, name, unit_s, index):
    """The unit in the heading of the times counts, and numbers of rows are not a channel."""
    rows = np.arange(4000)
    table = np.column_stack([rows, rows / RATE / unit_s, np.cos(rows), -np.cos(rows)])
    heads = ["", name, "a_g", "b"]
    table, heads = (table, heads) if index else (table[:, 1:], heads[1:])
    np.savetxt(tmp_path / "a.csv", table, delimiter=",", header=",".join(heads), comments="")
    rate = None if name else RATE
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800, rate=rate)
    assert list(found.channels) == ["a_g", "b"]
    assert 1 / found.signal().sample_s == pytest.approx(RATE, rel=1e-9)
    assert found.signal().values == pytest.approx(GRAVITY * np.cos(rows), abs=1e-9)


@pytest.mark.parametrize("digits", [9, 6, 3])
def test_times_with_a_gap(tmp_path, bearing, digits):
    """One missing row in a hundred thousand is reported, unless the times are rounded to more than
    the gap; rounded times alone are accepted."""
    rows = np.arange(100_000)
    for keep in (rows, np.delete(rows, 70_000)):
        table = np.column_stack([keep / RATE, np.cos(keep)])
        np.savetxt(tmp_path / "a.csv", table, delimiter=",", header="t,a", fmt=f"%.{digits}f")
        (tmp_path / "a.csv").write_text((tmp_path / "a.csv").read_text().removeprefix("# "))
        if len(keep) == len(rows) or digits == 3:
            found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800)
            assert 1 / found.signal().sample_s == pytest.approx(RATE, rel=2e-4)
        else:
            with pytest.raises(RunError, match="gap after row 70000"):
                recording.Recording(tmp_path / "a.csv", bearing, rpm=1800)


def test_times_at_two_rates(tmp_path, bearing):
    """The mean of two rates is the rate of neither."""
    time = np.append(np.arange(2000), 2000 + 2 * np.arange(1000)) / RATE
    np.savetxt(tmp_path / "a.csv", np.column_stack([time, time**2]), "%.9f", ",")
    (tmp_path / "a.csv").write_text("t,a\n" + (tmp_path / "a.csv").read_text())
    with pytest.raises(RunError, match="equal steps"):
        recording.Recording(tmp_path / "a.csv", bearing, rpm=1800)


@pytest.mark.parametrize("name", ["Timestamp", "", "row"])
def test_missing_rows_of_any_count(tmp_path, bearing, name):
    """A first column that rises throughout counts times or rows whatever its name, so a step in it
    is a gap, and it is not a channel."""
    rows = np.delete(np.arange(4000), 70)
    table = np.column_stack([rows, np.cos(rows)])
    np.savetxt(tmp_path / "a.csv", table, "%.9g", ",", header=f"{name},a", comments="")
    with pytest.raises(RunError, match="gap after row 70"):
        recording.Recording(tmp_path / "a.csv", bearing, rpm=1800, rate=RATE)


def test_several_columns_of_times(tmp_path, bearing):
    rows = np.arange(400)
    table = np.column_stack([rows, rows / RATE, 1e3 * rows / RATE, np.cos(rows)])
    np.savetxt(tmp_path / "a.csv", table, delimiter=",", header="n,time_s,ms,a", comments="")
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800)
    assert list(found.channels) == ["a"]
    assert 1 / found.signal().sample_s == pytest.approx(RATE, rel=1e-9)


@pytest.mark.parametrize("name, unit_s", [("t", 1), ("time_ms", 1e-3)])
def test_times_in_an_npz_file(tmp_path, bearing, name, unit_s):
    rows = np.arange(400)
    more = {name: rows / RATE / unit_s, "a": np.cos(rows), "time": [0.5]}
    np.savez(tmp_path / "a.npz", **more)
    found = recording.Recording(tmp_path / "a.npz", bearing, rpm=1800)
    assert list(found.channels) == ["a"]
    assert 1 / found.signal().sample_s == pytest.approx(RATE, rel=1e-9)


@pytest.mark.parametrize("name", ["y_g", "y (g)", "y [g]", "y[ g ]", "y/g"])
def test_units_in_a_heading(tmp_path, bearing, name):
    columns_of = {name: GRAVITY, "z [m/s^2]": 1.0, "w (m/s²)": 1.0, "v_m_s2": 1.0}
    values = np.cos(np.arange(400.0))
    table = np.column_stack([values] * len(columns_of))
    head = ",".join(columns_of)
    np.savetxt(tmp_path / "a.csv", table, delimiter=",", header=head, comments="", encoding="utf-8")
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800, rate=RATE)
    for own, scale in columns_of.items():
        assert found.signal(own).values == pytest.approx(scale * values, rel=1e-12)
        assert found.signal(own).attrs == {"units": "m/s^2", "long_name": own[0]}


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_encodings(tmp_path, bearing, encoding):
    """Programs on Windows write headings such as µm in encodings other than UTF-8."""
    text = "time_s;µ\n" + "".join(f"{k / 100:g};{k * k}\n" for k in range(40)).replace(".", ",")
    (tmp_path / "a.csv").write_bytes(text.encode(encoding))
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800)
    assert list(found.channels) == ["µ"] and found.signal().values[5] == 25
    assert found.signal().sample_s == pytest.approx(0.01)


def test_separators_at_the_ends_of_all_lines(tmp_path, bearing):
    (tmp_path / "a.csv").write_text("t,a,\n" + "".join(f"{k},{k * k},\n" for k in range(40)))
    assert list(recording.Recording(tmp_path / "a.csv", bearing, rpm=1800).channels) == ["a"]


WAV = [("i2", 32767, 0), ("i4", 2**31 - 1, 0), ("u1", 127, 128)]


@pytest.mark.parametrize("kind, top, middle", WAV)
def test_integers_of_a_wav_file(tmp_path, bearing, kind, top, middle):
    """Full scale is 1, and silence is 0 even in files of 8 bits, which are unsigned."""
    wave = np.sin(np.arange(200))
    wavfile.write(tmp_path / "a.wav", 8000, np.round(wave * top + middle).astype(kind))
    found = recording.Recording(tmp_path / "a.wav", bearing, rpm=1800)
    assert found.signal().values == pytest.approx(wave, abs=1 / top)


def test_a_long_file_with_a_heading(tmp_path, bearing, recwarn):
    """No warning of pandas reaches the user."""
    rows = np.arange(300_000)
    table = np.column_stack([rows / RATE, np.cos(rows)])
    np.savetxt(tmp_path / "a.csv", table, "%.12g", ",", header="time_s,a", comments="")
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=1800)
    assert len(found.signal().values) == 300_000 and not list(recwarn)
