# SPDX-License-Identifier: GPL-2.0-or-later
"""Readers for files of plain columns: CSV (including the files of the PRONOSTIA rig, FEMTO), WAV,
and NPZ as distributed for the CWRU recordings."""

import codecs
import io
import math
import re
import warnings
from pathlib import Path

import numpy as np
import pandas as pd
from scipy.io import wavfile

from raceway.errors import RunError
from raceway.recordings.contents import GRAVITY, Contents, channel, reading

FEMTO = re.compile(r"(acc|temp)_\d+\.csv")
FEMTO_RATE = {"acc": 25600.0, "temp": 10.0}  # Hz, as published
NPZ = re.compile(r"(\d{4})_.*?(?:_(DE12|DE48|FE))?\.npz")
NPZ_RATE = {"DE12": 12e3, "DE48": 48e3, "FE": 12e3}
# heading of a column of times: time, t_s, Time (ms), t/s ...
TIME = re.compile(r"(?:time|t|seconds)(?:[\s_/\[(]+(s|sec|seconds|ms|us|µs|μs)[\])]?)?", re.I)
SECONDS = {"ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6}  # s, 1 for other units of time
# heading of a column of accelerations: a_g, a_m_s2, a (g), a [m/s^2], a/g ...
ACCELERATION = re.compile(r"(.+?)\s*[_/(\[]\s*(g|m_s2|m/s\^?2|m/s²)\s*[)\]]?")
EVEN = 1e-3  # largest variation of the time steps in a column, relative to the whole time
STRAIGHT = 1e-4  # largest deviation of times from equal steps, relative to the whole time, or
ROUNDED = 2.0  # in multiples of the longest step, since times may be rounded to it
GAP = 1.5  # a step longer than this many times the others is a gap; times may be rounded coarsely


def read_csv(path: Path) -> Contents:
    """Return the `Contents` of a CSV file with or without a header line.

    A column named time, t or seconds, with or without a unit (time_s, Time (ms)), gives the
    sampling rate. If there are several columns, a first one that rises throughout counts times or
    rows and is not a channel, and neither are columns after it that increase in equal steps.
    Raises `RunError` if the file cannot be read.
    """
    if told := FEMTO.fullmatch(path.name):
        return _femto(path, told[1])
    text = _text(path)
    headed = _table(path, text, None, rows=1).iloc[0].map(lambda one: isinstance(one, str)).any()
    table = _table(path, text, 0 if headed else None)
    table.columns = [
        f"column_{one + 1}" if isinstance(one, int) else str(one).strip() for one in table.columns
    ]
    rate, names = math.nan, list(table.columns)
    while names:
        told, step = TIME.fullmatch(names[0]), _steps(table[names[0]])
        rises = len(step) and (step > 0).all()
        counts = rises and names[1:] and (len(names) == table.shape[1] or _even(step))
        if not told and not counts:
            break
        own = _rate(path, names[0], table[names[0]].to_numpy())
        if told and math.isnan(rate):
            rate = own
        names = names[1:]
    if not names:
        raise RunError(f"{path} has a column of times but no signal")
    found = {name: channel(path, name, table[name], rate, **_unit(name)) for name in names}
    return Contents("csv", found)


def _unit(name):
    """Return the unit at the end of a column name."""
    if not (told := ACCELERATION.fullmatch(name)):
        return {"meaning": name}
    scale = GRAVITY if told[2] == "g" else 1.0
    return {"units": "m/s^2", "scale": scale, "meaning": told[1]}


def _femto(path, kind):
    """Return the contents of a FEMTO file.

    Its columns are hour, minute, second and fractions of a second, followed by accelerations in g
    or a temperature.
    """
    table = _table(path, _text(path), None)
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


def _table(path, text, header, rows=None):
    with reading(path, "a table"), warnings.catch_warnings():
        # rows with more cells than the heading
        warnings.simplefilter("error", pd.errors.ParserWarning)
        mark = _separator(text)
        decimal = "," if mark in (";", "\t") and _commas(text) else "."
        table = pd.read_csv(
            io.StringIO(text),
            sep=mark,
            decimal=decimal,
            header=header,
            index_col=False,
            comment="#",
            nrows=rows,
            low_memory=False,
        )
    if not len(table):
        raise RunError(f"{path} has no rows")
    # a separator at the end of the heading begins a column without a name and values
    nameless = [one for one in table if str(one).startswith("Unnamed: ")]
    return table.drop(columns=[one for one in nameless if table[one].isna().all()])


def _text(path):
    """Return the text of a file in UTF-8, in UTF-16 with a byte order mark, or else in Latin-1."""
    with reading(path, "a table"):
        raw = path.read_bytes()
        if raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
            return raw.decode("utf-16")
        if b"\0" in raw:
            raise ValueError("it has null bytes")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        return raw.decode("latin-1")


def _separator(text):
    """Return the separator of the first line with data: a semicolon, a comma, a tab or blanks. In a
    line with tabs a comma separates only if a tab follows it; otherwise it is a decimal comma."""
    first = next((line for line in text.splitlines() if line.partition("#")[0].strip()), "")
    if "\t" in first and ";" not in first and ",\t" not in first:
        return "\t"
    return next((mark for mark in (";", ",", "\t") if mark in first), r"\s+")


def _commas(text):
    """Return True if numbers have decimal commas, i.e. if there are commas but no points below the
    first line."""
    body = re.sub("#.*", "", text).strip().partition("\n")[2]
    return "," in body and "." not in body


def _rate(path, name, time):
    """Return the rate in Hz of the times in a column, in the unit of its `name`."""
    step = _steps(time)
    if not len(step):
        raise RunError(f"{path}: its times in {name} are not numbers")
    uneven = f"{path}: its times in {name} do not increase in equal steps"
    if not _even(step):
        raise RunError(uneven)
    at = int(step.argmax())
    if step[at] > GAP * np.quantile(step[step > 0], 0.99):
        raise RunError(
            f"{path}: its times in {name} have a gap after row {at + 1} of data, at"
            f" {time[at]:.9g}: give the rows before or after it"
        )
    away = np.ptp(time - np.linspace(time[0], time[-1], len(time)))
    if away > max(ROUNDED * step[at], STRAIGHT * step.sum()):
        raise RunError(uneven)
    told = TIME.fullmatch(name)
    return 1 / step.mean() / SECONDS.get((told and told[1] or "s").lower(), 1.0)


def _even(step):
    whole = step.sum()
    return len(step) > 1 and whole > 0 and step.min() >= 0 and np.ptp(step) <= EVEN * whole


def _steps(column):
    """Return the differences between the numbers of a column; none if these are not numbers."""
    try:
        with np.errstate(invalid="ignore"):  # of two infinite numbers
            return np.diff(np.asarray(column, float))
    except (TypeError, ValueError):
        return np.zeros(0)


def read_wav(path: Path) -> Contents:
    """Return the `Contents` of a WAV file; integers are divided by their largest value. Integers of
    8 bits are unsigned, with silence at 128. Raises `RunError` if the file cannot be read."""
    with reading(path, "a WAV file"), warnings.catch_warnings():
        # warnings about chunks that the reader ignores
        warnings.simplefilter("ignore", wavfile.WavFileWarning)
        warnings.filterwarnings("error", "Reached EOF", wavfile.WavFileWarning)  # incomplete
        rate, values = wavfile.read(path)
    if values.dtype == np.uint8:
        values = (values.astype(np.int16) - 128).astype(np.int8)
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
    """Return the `Contents` of an NPZ file with one channel for each array except times, which have
    a name as in `read_csv`.

    CWRU files contain DE, FE and BA in g, and their names state speed and rate. Raise `RunError` if
    the file cannot be read.
    """
    # np.load would not close the file if it is damaged
    with reading(path, "an NPZ file"), path.open("rb") as opened, np.load(opened) as file:
        data = {name: file[name] for name in file.files}
    told = NPZ.fullmatch(path.name)
    cwru = {"DE", "FE", "BA"} >= set(data) and bool(data)
    rate = NPZ_RATE.get(told[2], math.nan) if told else math.nan
    for name in [name for name in data if TIME.fullmatch(name)]:
        if np.ndim(data[name]) == 1 and np.size(data[name]) > 1:
            rate = _rate(path, name, data.pop(name))
    words = {"scale": GRAVITY, "units": "m/s^2", "meaning": "acceleration"} if cwru else {}
    found = {
        name: channel(path, name, values, rate, **words)
        for name, values in data.items()
        if np.ndim(values) and np.size(values) > 1
    }
    if not found:
        raise RunError(f"{path} has no row of numbers")
    return Contents("CWRU npz" if cwru else "npz", found, float(told[1]) if told else math.nan)
