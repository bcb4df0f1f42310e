# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the netCDF writer: its files can be read, also while they grow and after truncation.
test_live.py tests them with other readers and after the writer has been killed."""

import ctypes
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

HERE = Path(__file__).resolve().parent


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    path = tmp_path_factory.mktemp("netcdf") / "netcdf.so"
    flags = ["-std=c++17", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared"]
    subprocess.run(["g++", *flags, HERE / "netcdf_c.cpp", "-o", path], check=True)
    return path


class Writer:
    """A writer that uses the C interface of netcdf_c.cpp."""

    def __init__(self, library, path, batch=4, records=-1, temperature=40.0):
        self.c = ctypes.CDLL(str(library))
        self.c.begin.restype = ctypes.c_void_p
        self.c.begin.argtypes = [ctypes.c_char_p, ctypes.c_int, ctypes.c_long, ctypes.c_double]
        self.c.why.restype = ctypes.c_char_p
        for name in ("record_bytes", "header_bytes"):
            getattr(self.c, name).restype = ctypes.c_long
        for name in ("why", "record_bytes", "header_bytes", "settle", "finish", "leave"):
            getattr(self.c, name).argtypes = [ctypes.c_void_p]
        self.c.write_record.argtypes = [ctypes.c_void_p, ctypes.c_long]
        self.at = self.c.begin(str(path).encode(), batch, records, temperature)

    def __getattr__(self, name):
        return lambda *more: getattr(self.c, name)(self.at, *more)

    @property
    def complaint(self):
        return self.c.why(self.at).decode()

    def write(self, first, last):
        for k in range(first, last):
            self.write_record(k)
            assert self.complaint == ""


def expected(n):
    """Return (time, x, load) of n records."""
    k = np.arange(n)
    x = 1e-9 * k[:, None] + 0.1 * np.arange(6)
    x[:, 5] = np.nan
    load = (k[:, None] + np.arange(3) / 3.0).astype(np.float32)
    return k / 8.0, x.reshape(n, 2, 3), load


def holds(path, n):
    """Check that the file contains n records with the expected values when it is read with
    xarray.
    """
    with xr.open_dataset(path, engine="scipy") as data:
        for found, wanted in zip((data["time"], data["x"], data["load"]), expected(n)):
            assert np.array_equal(found.to_numpy(), wanted, equal_nan=True)
        return data.load()


@pytest.fixture
def path(tmp_path):
    return tmp_path / "record.nc"


def test_xarray(library, path):
    writer = Writer(library, path)
    writer.write(0, 10)
    writer.leave()
    data = holds(path, 10)
    assert re.fullmatch(r"sum [0-9a-f]{8} of \d{10} header bytes", data.attrs.pop("checksum"))
    assert data.attrs == {"title": "a test", "temperature": 40.0}
    assert data["raceway"].values.tolist() == ["inner", "outer"]
    assert data["ball"].values.tolist() == [4, 5, 70000]
    assert float(data["pitch"]) == 0.0303 and data["pitch"].attrs == {"units": "m"}
    assert data["x"].dims == ("time", "raceway", "ball")


def test_growing(library, path):
    """A reader never sees more than has been written, and sees everything once writing has
    stopped.
    """
    writer, seen = Writer(library, path, batch=3), 0
    for k in range(30):
        writer.write(k, k + 1)
        with xr.open_dataset(path, engine="scipy") as data:
            n = data.sizes["time"]
        assert seen <= n <= k // 3 * 3 + 3
        seen = n
        holds(path, n)
    writer.settle()
    holds(path, 30)
    writer.leave()


def test_batches_leave_the_same_bytes(library, tmp_path):
    for batch in (1, 4, 64):
        writer = Writer(library, tmp_path / f"{batch}.nc", batch=batch)
        writer.write(0, 21)
        writer.leave()
    first, *others = ((tmp_path / f"{batch}.nc").read_bytes() for batch in (1, 4, 64))
    assert all(other == first for other in others)


def test_go_on(library, tmp_path):
    """If a file is truncated to an earlier record, complete or not, and then continued, it has the
    same bytes as an uninterrupted file."""
    whole, cut = tmp_path / "whole.nc", tmp_path / "cut.nc"
    for path in (whole, cut):
        writer = Writer(library, path)
        writer.write(0, 20)
        writer.leave()
    with open(cut, "ab") as file:
        file.write(b"a part of a record")
    writer = Writer(library, cut, batch=7, records=11)
    assert writer.complaint == ""
    holds(cut, 11)
    writer.write(11, 20)
    writer.leave()
    assert cut.read_bytes() == whole.read_bytes()


def test_go_on_after_the_end(library, path):
    writer = Writer(library, path)
    writer.write(0, 5)
    writer.finish()
    writer.leave()
    writer = Writer(library, path, records=5)
    assert writer.complaint == ""
    writer.leave()


@pytest.mark.parametrize(
    "change, says",
    [
        (lambda path: path.write_bytes(b"CDF\2"), "it has no whole header"),
        (lambda path: os.truncate(path, path.stat().st_size - 1), "fewer than 5 samples"),
    ],
)
def test_nothing_to_go_on_from(library, path, change, says):
    writer = Writer(library, path)
    writer.write(0, 5)
    writer.leave()
    change(path)
    writer = Writer(library, path, records=5)
    assert says in writer.complaint
    writer.leave()


def test_other_settings(library, path):
    writer = Writer(library, path)
    writer.write(0, 5)
    writer.leave()
    before = path.read_bytes()
    writer = Writer(library, path, records=5, temperature=41.0)
    assert writer.complaint == "it was written with other settings"
    writer.leave()
    assert path.read_bytes() == before


def test_one_writer(library, path):
    first, second = Writer(library, path), Writer(library, path)
    assert first.complaint == "" and second.complaint == "another run is writing it"
    first.write(0, 8)
    second.leave()
    first.leave()
    holds(path, 8)


def test_no_room(library):
    writer = Writer(library, "/dev/full")
    assert "No space left" in writer.complaint or "Invalid argument" in writer.complaint
    writer.leave()
