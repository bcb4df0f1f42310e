# SPDX-License-Identifier: GPL-2.0-or-later
"""Reader for MATLAB files of Case Western Reserve University (and of `raceway dataset`), the
Machinery Failure Prevention Technology society and Paderborn University.

Each kind of file is recognised by its variables. Accelerations in g are converted to m/s^2, and
loads in pounds to N.
"""

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from scipy import io

from raceway.errors import RunError
from raceway.recordings.contents import GRAVITY, POUND, Channel, Contents, channel, reading

CWRU = re.compile(r"X(\d+)_(DE|FE|BA)_time")
PADERBORN = re.compile(r"N(\d\d)_M(\d\d)_F(\d\d)_")  # units: 100 rpm, 0.1 N m, 100 N
AT = {"DE": "drive end", "FE": "fan end", "BA": "base"}
SHOWN = 8  # number of variables listed in a message


def read(path: Path) -> Contents:
    """Return the `Contents` of a .mat file.

    Raise `RunError` if the file is damaged or has only unknown variables.
    """
    with reading(path, "a MATLAB file up to version 7"):
        found = io.loadmat(path, simplify_cells=True)
    data = {name: value for name, value in found.items() if not name.startswith("__")}
    if any(CWRU.fullmatch(name) for name in data):
        return _cwru(path, data)
    if "bearing" in data and _has(data["bearing"], "gs", "sr"):
        return _mfpt(path, data["bearing"])
    for value in data.values():
        if _has(value, "X", "Y"):
            return _paderborn(path, value)
    names = ", ".join([*data][:SHOWN]) or "nothing"
    raise RunError(
        f"{path} has {names}: only X..._DE_time (CWRU), bearing.gs (MFPT) and a structure of X and"
        " Y (Paderborn) can be read; convert other files to csv"
    )


def _has(value, *names):
    return isinstance(value, Mapping) and set(names) <= set(value)


def _cwru(path, data):
    """Return the contents of one record, because a few files have two records.

    It is the record whose number is the name of the file or, if there is none, the record with the
    lowest number.
    """
    numbers = sorted({m[1] for m in map(CWRU.fullmatch, data) if m}, key=int)
    stem = path.stem.lstrip("0")
    number = next((one for one in numbers if one.lstrip("0") == stem), numbers[0])
    si = data.get("unit") == "m/s^2"
    rate = _number(path, data, "sampling_Hz")
    found = {
        end: channel(
            path,
            f"X{number}_{end}_time",
            data[f"X{number}_{end}_time"],
            rate,
            scale=1.0 if si else GRAVITY,
            units="m/s^2",
            meaning=f"acceleration, {words}",
        )
        for end, words in AT.items()
        if f"X{number}_{end}_time" in data
    }
    rpm, load = (_number(path, data, name) for name in (f"X{number}RPM", "load_N"))
    # `raceway dataset` alone states a unit; its speed is that of the run, i.e. exact
    return Contents("CWRU", found, rpm, load, measured=si)


def _mfpt(path, data: Mapping[str, Any]):
    rate, turns, load = (_number(path, data, name) for name in ("sr", "rate", "load"))
    words = {"scale": GRAVITY, "units": "m/s^2", "meaning": "acceleration"}
    found = {"gs": channel(path, "gs", data["gs"], rate, **words)}
    return Contents("MFPT", found, 60 * turns, POUND * load)


def _number(path, data: Mapping[str, Any], name):
    """The number `name` in `data`; NaN if it is missing or empty."""
    value = np.ravel(data.get(name, ()))
    try:
        return float(value.item()) if value.size else math.nan
    except (TypeError, ValueError):
        raise RunError(f"{path}: {name} is not one number") from None


def _paderborn(path, data: Mapping[str, Any]):
    """Return the contents with all channels. Their rates follow from the time base that has the
    same raster or, if there is none, the same length."""
    bases = [one for one in _list(data["X"]) if _has(one, "Data")]
    found: dict[str, Channel] = {}
    for one in _list(data["Y"]):
        if not _has(one, "Name", "Data"):
            continue
        size = np.size(one["Data"])
        own = [base for base in bases if base.get("Raster", "") == one.get("Raster", "?")]
        fit = [base for base in own or bases if np.size(base["Data"]) == size > 1]
        time = np.ravel(fit[0]["Data"]) if fit else np.zeros(0)
        rate = (size - 1) / (time[-1] - time[0]) if size > 1 and len(time) else math.nan
        name = str(one["Name"])
        words = _words_of_paderborn(name)
        found[name] = channel(path, name, one["Data"], rate, **words)
    if not found:
        raise RunError(f"{path}: Y has no channel with Name and Data")
    # The vibration of the bearing is the first channel.
    found = dict(sorted(found.items(), key=lambda item: item[0] != "vibration_1"))
    told = PADERBORN.match(path.name)
    rpm = 100.0 * int(told[1]) if told else math.nan
    measured = "speed" in found
    if measured:
        rpm = float(found["speed"].values.mean())
    load = 100.0 * int(told[3]) if told else math.nan
    return Contents("Paderborn", found, rpm, load, measured)


def _words_of_paderborn(name):
    if name.startswith("vibration"):
        return {"meaning": "acceleration, as recorded"}
    if name.startswith("temp"):
        return {"units": "°C", "meaning": "temperature"}
    return {"units": "rpm" if name == "speed" else "", "meaning": name.replace("_", " ")}


def _list(value):
    return [value] if isinstance(value, Mapping) else list(np.ravel(value))
