# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of files supplied by users (YAML, ROSS matrices) and of files written with --out."""

import io
import os
import stat
import time
import zipfile

import numpy as np
import pytest
from commands import reply
from raceway import data_file, files, ross_file, shaft_file, yaml_file
from raceway.datasets import spec
from raceway.errors import InputError, RacewayError, RunError
from raceway.runs import settings

SHAFT = """\
rpm: 3000
sections: [{length: 0.2, diameter: 0.03}]
bearings: [{name: 6206, at: 0.02}, {name: 6206, at: 0.18, floating: yes}]
loads: [{at: 0.1, force: [0, -500, 0]}]
"""
NESTED = "[" * 500 + "]" * 500
BOMB = "a: &a [x, x]\n" + "".join(
    f"{b}: &{b} [*{a}, *{a}]\n" for a, b in zip("abcdefgh", "bcdefghi")
)


@pytest.mark.parametrize(
    "text, message",
    [
        ("a: 1\nb: 2\na: 3\n", "a is given twice"),
        ("a: {b: 1, b: 2}\n", "b is given twice"),
        (NESTED, "nested too deeply"),
        (BOMB, "references"),
        ("a: " + "x" * (1 << 20), "longer than"),
        ("a: [1\n", "expected"),
        ("\ud800".encode("utf-8", "surrogatepass"), "decode"),
        (b"a: \x00", "special characters"),
    ],
)
def test_broken_yaml(tmp_path, text, message):
    """Every reader rejects broken YAML with a message and its own type of error."""
    path = tmp_path / "run.yaml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    readers = {
        yaml_file.read: InputError,
        shaft_file.read: InputError,
        lambda path: spec.read_spec(path, {}): spec.SpecError,
        settings._said: RunError,
    }
    for reader, error in readers.items():
        with pytest.raises(error, match=f"cannot read .*run.yaml: (.|\n)*{message}"):
            reader(path)


@pytest.mark.parametrize(
    "old, new",
    [
        ("rpm: 3000", "rpm: on"),
        ("rpm: 3000", "rpm: 3_000"),
        ("rpm: 3000", "rpm: 1:30"),
        ("rpm: 3000", "rpm:"),
        ("rpm: 3000", "rpm: {a: 1}"),
        ("diameter: 0.03", "diameter: yes"),
        ("-500", "yes"),
        ("length: 0.2", "length: [1]"),
        ("at: 0.1,", "at: .nan,"),
    ],
)
def test_no_word_is_a_number(tmp_path, old, new):
    path = tmp_path / "shaft.yaml"
    path.write_text(SHAFT)
    assert [one.floating for one in shaft_file.read(path).seats] == [False, True]
    path.write_text(SHAFT.replace(old, new))
    with pytest.raises(InputError, match="must be (a number|from)"):
        shaft_file.read(path)


def claims(path, shape, kind="<f8", **others):
    """Return an .npz file whose header of M claims a `shape`, although little data follows."""
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        head, {"descr": kind, "fortran_order": False, "shape": shape}
    )
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("M.npy", head.getvalue() + b"\0" * 64)


@pytest.mark.parametrize(
    "shape, kind, message",
    [
        ((40000, 40000), "<f8", "40000 x 40000; it must have at most 6000 rows"),
        ((2, 2, 2), "<f8", "must have"),
        ((2, 2), "|V1000000000", "real numbers"),
        ((2, 2), "|O", "real numbers"),
        ((100, 100), "<f8", "cannot read"),  # there are too few data
    ],
)
def test_matrices_are_refused_by_their_header(tmp_path, shape, kind, message):
    path = tmp_path / "rotor.npz"
    claims(path, shape, kind)
    with pytest.raises(RacewayError, match=message):
        ross_file.read(path)


def test_a_link_stays_and_its_file_is_written(tmp_path):
    target, link = tmp_path / "target.png", tmp_path / "link.png"
    target.write_text("old")
    link.symlink_to(target)
    files.text(link, "new")
    assert link.is_symlink() and target.read_text() == "new"
    (tmp_path / "far").mkdir()
    (tmp_path / "loose").symlink_to("far/made")
    files.text(tmp_path / "loose", "made")
    assert (tmp_path / "far/made").read_text() == "made"
    assert {one.name for one in tmp_path.iterdir()} == {"target.png", "link.png", "far", "loose"}


@pytest.mark.parametrize("kind", ["pipe", "folder", "device", "loop", "below a file"])
def test_what_is_no_regular_file_stays(tmp_path, kind, capsys):
    path = tmp_path / "out.csv"
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "device":
        path.symlink_to("/dev/full")
    elif kind == "loop":
        path.symlink_to(path)
    else:
        path.write_text("")
        path = path / "out.csv"
    before = os.stat("/dev/full")
    assert f"cannot write {path}" in reply(
        capsys, ["stiffness", "--load", "1000", "--out", path], code=1
    )
    assert len(list(tmp_path.iterdir())) == 1
    now = os.stat("/dev/full")
    assert (now.st_ino, now.st_mode) == (before.st_ino, before.st_mode)
    assert stat.S_ISCHR(now.st_mode)


@pytest.mark.parametrize(
    "value",
    ["5000", "mineral", "", "it's", "null", "~", "no", "a: b", "two words", "a\nb", "\u03bc"],
)
@pytest.mark.parametrize("name", ["load", "null", "on"])
def test_yaml_of_texts(name, value):
    """Texts remain texts, whatever YAML makes of them without quotes."""
    values = {name: value, "rpm": "477.5"}
    assert yaml_file.parse(yaml_file.dump(values)) == values


def test_a_file_that_changes(tmp_path):
    """Its data are read again, even if neither its size nor the time of a recent change differs."""
    path, now = tmp_path / "own", time.time_ns()
    for balls, changed in (("8", now), ("9", now), ("8", now - 10**10), ("9", now - 10**10 + 1)):
        path.write_text(f"variable balls index {balls}\n")
        os.utime(path, ns=(changed, changed))
        assert data_file.values(path) == {"balls": balls}
    same = files.version(path)
    assert files.version(path) == same != files.version(tmp_path)
    assert files.version(tmp_path / "absent") is None
