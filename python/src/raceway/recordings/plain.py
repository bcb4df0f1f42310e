# SPDX-License-Identifier: GPL-2.0-or-later
"""Readers for files of plain columns: CSV (including the files of the PRONOSTIA rig, FEMTO), WAV,
and NPZ as distributed for the CWRU recordings."""

import math
import re
import warnings
import zipfile
from pathlib import Path

import numpy as np
import pandas as pd
from scipy.io import wavfile

from raceway.errors import RunError
from raceway.recordings.contents import GRAVITY, Contents, channel

FEMTO = re.compile(r"(acc|temp)_\d+\.csv")
FEMTO_RATE = {"acc": 25600.0, "temp": 10.0}  # Hz, as published
NPZ = re.compile(r"(\d{4})_.*?(?:_(DE12|DE48|FE))?\.npz")
NPZ_RATE = {"DE12": 12e3, "DE48": 48e3, "FE": 12e3}
TIMES = ("time", "time_s", "t", "t_s", "seconds")
EVEN = 1e-3  # largest variation of the time steps in a column, relative to their mean


def read_csv(path: Path) -> Contents:
    """Return the `Contents` of a CSV file with or without a header line.

    A first column with a name such as time, time_s, t or seconds gives the sampling rate. Raise
    `RunError` if the file cannot be read.
    """
    if told := FEMTO.fullmatch(path.name):
        return _femto(path, told[1])
    table = _table(path, None)
    if table.iloc[0].map(lambda one: isinstance(one, str)).any():
        table = _table(path, 0)
    table.columns = [
        f"column_{one + 1}" if isinstance(one, int) else str(one).strip() for one in table.columns
    ]
    rate, names = math.nan, list(table.columns)
    if names[0].lower() in TIMES:
        rate = _rate(path, table[names[0]].to_numpy())
        names = names[1:]
    if not names:
        raise RunError(f"{path} has a column of times but no signal")
    found = {name: channel(path, name, table[name], rate, **_unit(name)) for name in names}
    return Contents("csv", found)


def _unit(name):
    """Return the unit at the end of a column name, in the form that raceway itself writes."""
    for end, units in (("_m_s2", "m/s^2"), ("_g", "g")):
        if name.endswith(end):
            scale = GRAVITY if units == "g" else 1.0
            return {"units": "m/s^2", "scale": scale, "meaning": name.removesuffix(end)}
    return {"meaning": name}


def _femto(path, kind):
    """Return the contents of a FEMTO file.

    Its columns are hour, minute, second and fractions of a second, followed by accelerations in g
    or a temperature.
    """
    table = _table(path, None)
    if table.shape[1] != {"acc": 6, "temp": 5}[kind]:
        raise RunError(f"{path} has {table.shape[1]} columns, unlike the {kind} files of PRONOSTIA")
    rate = FEMTO_RATE[kind]
    if kind == "temp":
        words = {"units": "°C", "meaning": "temperature beside the outer ring"}
        return Contents(
            "FEMTO", {"temperature": channel(path, "temperature", table[4], rate, **words)}
        )
    found = {}
    for column, name in ((4, "horizontal"), (5, "vertical")):
        words = {"scale": GRAVITY, "units": "m/s^2", "meaning": f"acceleration, {name}"}
        found[name] = channel(path, name, table[column], rate, **words)
    return Contents("FEMTO", found)


def _table(path, header):
    try:
        mark = _separator(path)
        decimal = "," if mark == ";" and _commas(path) else "."
        table = pd.read_csv(path, sep=mark, decimal=decimal, header=header, comment="#")
    except (ValueError, OSError, UnicodeDecodeError, pd.errors.ParserError) as error:
        raise RunError(f"cannot read {path}: {error}") from None
    if not len(table):
        raise RunError(f"{path} has no rows")
    return table


def _separator(path):
    """Return the separator of the first line with data: a semicolon, a comma, a tab or blanks."""
    with path.open(encoding="utf-8") as lines:
        first = next((line for line in lines if line.partition("#")[0].strip()), "")
    return next((mark for mark in (";", ",", "\t") if mark in first), r"\s+")


def _commas(path):
    """Return True if numbers have decimal commas, i.e. if the last line has commas but no point."""
    last = path.read_text(encoding="utf-8").rstrip().rpartition("\n")[2]
    return "," in last and "." not in last


def _rate(path, time):
    try:
        step = np.diff(np.asarray(time, float))
    except ValueError:
        raise RunError(f"{path}: its times are not numbers") from None
    if len(step) < 2 or not step.mean() > 0 or np.ptp(step) > EVEN * len(step) * step.mean():
        raise RunError(f"{path}: its times do not increase in equal steps")
    return 1 / step.mean()


def read_wav(path: Path) -> Contents:
    """Return the `Contents` of a WAV file; integers are divided by their largest value.

    Raise `RunError` if the file cannot be read.
    """
    try:
        with warnings.catch_warnings():
            # warnings about chunks that the reader ignores
            warnings.simplefilter("ignore", wavfile.WavFileWarning)
            rate, values = wavfile.read(path)
    except (ValueError, OSError) as error:
        raise RunError(f"cannot read {path}: {error}") from None
    scale = 1 / np.iinfo(values.dtype).max if values.dtype.kind in "iu" else 1.0
    words = {"scale": scale, "meaning": "signal, full scale 1"}
    rows = np.atleast_2d(np.transpose(values))
    return Contents(
        "wav",
        {
            f"channel_{k + 1}": channel(path, f"channel {k + 1}", row, rate, **words)
            for k, row in enumerate(rows)
        },
    )


def read_npz(path: Path) -> Contents:
    """Return the `Contents` of an NPZ file with one channel for each array.

    CWRU files contain DE, FE and BA in g, and their names state speed and rate. Raise `RunError` if
    the file cannot be read.
    """
    try:
        with np.load(path) as file:
            data = {name: file[name] for name in file.files}
    except (ValueError, OSError, EOFError, zipfile.BadZipFile) as error:
        raise RunError(f"cannot read {path}: {error}") from None
    told = NPZ.fullmatch(path.name)
    cwru = {"DE", "FE", "BA"} >= set(data) and bool(data)
    rate = NPZ_RATE.get(told[2], math.nan) if told else math.nan
    words = {"scale": GRAVITY, "units": "m/s^2", "meaning": "acceleration"} if cwru else {}
    found = {
        name: channel(path, name, values, rate, **words)
        for name, values in data.items()
        if np.ndim(values) and np.size(values) > 1
    }
    if not found:
        raise RunError(f"{path} has no row of numbers")
    return Contents("CWRU npz" if cwru else "npz", found, float(told[1]) if told else math.nan)
