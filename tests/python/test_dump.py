# SPDX-License-Identifier: GPL-2.0-or-later
"""LAMMPS dumps and tables: what is in them, and what is said when they are broken."""

import numpy as np
import pytest
from raceway import dump as module
from raceway.errors import RunError, RunWarning
from raceway.runs.dump import Index, blocks, frames, read_dump, read_table

HEAD = (
    "ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ENTRIES\n{n}\n"
    "ITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ENTRIES c_x[1]\n"
)
FIRST = HEAD.format(step=10, n=2) + "1 0.5\n2 1e-05 \n"
EMPTY = HEAD.format(step=20, n=0)
LAST = HEAD.format(step=30, n=1) + "3 -inf\n"
COLUMNS = ["ball", "load"]


def dump(tmp_path, text):
    path = tmp_path / "some.dump"
    path.write_text(text)
    return path


def test_frames_and_empty_frames(tmp_path):
    path = dump(tmp_path, FIRST + EMPTY + LAST)
    assert [frame.step for frame in frames(path, COLUMNS)] == [10, 20, 30]
    table = read_dump(path, COLUMNS)
    assert table.attrs["samples"] == 3
    assert table.to_numpy().tolist() == [[1, 0.5, 0], [2, 1e-5, 0], [3, -np.inf, 2]]


def test_atoms_units_and_time_of_newer_hosts(tmp_path):
    frame = FIRST.replace("ENTRIES c_x[1]", "ATOMS id").replace("ENTRIES", "ATOMS")
    text = "ITEM: UNITS\nsi\nITEM: TIME\n0.1\n" + frame
    assert len(read_dump(dump(tmp_path, text), COLUMNS)) == 2


@pytest.mark.parametrize("end", range(1, len(LAST)))
def test_cut_anywhere_in_the_last_frame(tmp_path, end):
    """Even one character short: 1.25 may have been 1.2537."""
    with pytest.warns(RunWarning, match="line 12: the file ends inside"):
        table = read_dump(dump(tmp_path, FIRST + LAST[:end]), COLUMNS)
    assert table.attrs["samples"] == 1


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "no complete frame"),
        ("hello\n", "line 1: expected the head of a frame, found 'hello'"),
        (FIRST.replace("\n10\n", "\nten\n"), "line 2: expected a whole number, found 'ten'"),
        (FIRST.replace("1e-05", "abc"), "line 11: load is not a number: 'abc'"),
        (FIRST.replace("1e-05", "-nan"), "line 11: load is not a number: '-nan'"),
        (FIRST.replace("0.5", "0.5 7"), r"line 10: 3 columns where 2 are named \(ball load\)"),
        (FIRST.replace("1 0.5\n", "1\n") + LAST, "line 10: 1 columns where 2"),
        (FIRST.replace("2 1e-05 \n", "") + LAST, "line 11: only 1 of 2 rows before the next frame"),
        (FIRST + "4 0.1\n" + LAST, "line 12: expected the head of a frame, found '4 0.1'"),
        ("ITEM: ENTRIES a\n1 2\n", "line 1: rows without TIMESTEP"),
        (FIRST.replace("\n0 1\n0 1\n0 1", "\n0 1\n0 1"), "line 9: expected the head of a frame"),
    ],
)
def test_broken_dump_names_its_line(tmp_path, text, said):
    with pytest.raises(RunError, match=said):
        read_dump(dump(tmp_path, text), COLUMNS)


def test_missing_file(tmp_path):
    with pytest.raises(RunError, match="cannot read .*none.dump: No such file"):
        read_dump(tmp_path / "none.dump", COLUMNS)


def test_table(tmp_path):
    table = read_table(dump(tmp_path, "# step time x\n0 0.0 1e-6\n100 1e-3 2e-6\n"))
    assert table["x"].tolist() == [1e-6, 2e-6]


def test_table_cut_in_its_last_line(tmp_path):
    with pytest.warns(RunWarning, match="line 3: the file ends inside"):
        assert len(read_table(dump(tmp_path, "# step x\n0 1.0\n100 2."))) == 1


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "no complete line"),
        ("# x\n", "no complete row"),
        ("0 1\n", "line 1: expected '#'"),
        ("# a b\n0 1\n0\n", "line 3: 1 columns"),
        ("# a b\n0 1\n0 one\n", "line 3: b is not a number: 'one'"),
    ],
)
def test_broken_table_names_its_line(tmp_path, text, said):
    with pytest.raises(RunError, match=said):
        read_table(dump(tmp_path, text))


@pytest.mark.parametrize("size", [1, 7, 15, 16, 17, 40, 113, 10**6])
@pytest.mark.parametrize("newer", [False, True])
def test_index_whatever_the_pieces_read(tmp_path, monkeypatch, size, newer):
    text = FIRST + EMPTY + LAST
    if newer:
        text = "ITEM: UNITS\nsi\n" + text.replace(
            "ITEM: TIMESTEP", "ITEM: TIME\n0.1\nITEM: TIMESTEP"
        )
    path = dump(tmp_path, text)
    monkeypatch.setattr(module, "BLOCK", size)
    index = Index(path)
    places = [at for at in range(len(text)) if text.startswith("ITEM: TIMESTEP\n", at)]
    assert index.offsets.tolist() == places and len(index) == 3
    assert index.lines.tolist() == [text[:at].count("\n") for at in places]


@pytest.mark.parametrize("size", [1, 10**6])
def test_any_frames(tmp_path, monkeypatch, size):
    path = dump(tmp_path, FIRST + EMPTY + LAST)
    monkeypatch.setattr(module, "BLOCK", size)
    for start, stop in ((0, 1), (0, None), (1, 2), (1, None), (2, 9)):
        steps = [step for block in blocks(path, COLUMNS, start, stop) for step in block.steps]
        assert steps == [10, 20, 30][start:stop]
    assert read_dump(path, COLUMNS, 2).to_numpy().tolist() == [[3, -np.inf, 2]]
    with pytest.raises(RunError, match="holds 3 complete frames, none from number 3 on"):
        read_dump(path, COLUMNS, 3)


def test_index_of_a_cut_file(tmp_path):
    with pytest.warns(RunWarning, match="line 21: the file ends inside"):
        assert len(Index(dump(tmp_path, (FIRST + EMPTY + LAST)[:-2]))) == 2


def test_broken_line_is_named_after_a_jump_too(tmp_path, monkeypatch):
    path = dump(tmp_path, FIRST + EMPTY + LAST.replace("-inf", "low"))
    monkeypatch.setattr(module, "BLOCK", 1)
    with pytest.raises(RunError, match="line 30: load is not a number: 'low'"):
        read_dump(path, COLUMNS)
    with pytest.raises(RunError, match="line 30: load is not a number: 'low'"):
        read_dump(path, COLUMNS, start=1)
