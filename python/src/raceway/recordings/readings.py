# SPDX-License-Identifier: GPL-2.0-or-later
"""Readings of a real bearing and the known part of its state, from the file of `raceway
identify`."""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import pandas as pd

from raceway import catalogue, files, inputs, yaml_file
from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.recordings import orders
from raceway.recordings.recording import Recording
from raceway.theory.models import STATICS

# {unknown: (lowest possible value, highest possible value, unit)}
STATE = {
    "clearance": (-50e-6, 200e-6, "m"),
    "load": (0.0, 1e6, "N"),
    "axial": (-1e6, 1e6, "N"),
    "temperature": (-40.0, 200.0, "C"),
    "conductance": (1e-3, 1e4, "W/K"),
}
DEFAULTS = {"clearance": 0.0, "load": 0.0, "axial": 0.0}
QUANTITIES = (*orders.LINES, "capacitance", "temperature")
UNITS = {"capacitance": "F", "temperature": "C"}  # lines are in orders of the shaft speed
LINE = (1e-3, 1e3)  # range of a line in orders
POSSIBLE = {"capacitance": (0.0, 1e-6), "temperature": (-60.0, 300.0)}  # ranges of a reading
FILE = ("file", "line", "rate", "nominal", "channel")

_number = partial(yaml_file.number_within, error=ValueError)


class ReadingsError(RacewayError):
    """Raised if a file of readings cannot be used; the message states the position and the
    value."""


class Point(NamedTuple):
    """Operating point of a reading; values that are given for the whole file are None."""

    rpm: float
    load: float | None = None  # N, radial load
    axial: float | None = None  # N, axial load
    load_more: float = 0.0  # N, added to the radial load
    axial_more: float = 0.0  # N, added to the axial load
    at: float | None = None  # C, temperature of the oil


class Reading(NamedTuple):
    """A measured value."""

    quantity: str  # one of `QUANTITIES`
    value: float  # in orders of the shaft speed, F or C
    within: float  # one standard deviation of the value
    point: Point


class Readings(NamedTuple):
    """Contents of a file of readings in SI units, with temperatures in degrees C."""

    bearing: Path
    lubricant: Path
    models: str
    known: dict[str, float]  # {name in `STATE`: value}
    unknown: dict[str, tuple[float, float]]  # {name in `STATE`: range}
    readings: list[Reading]
    ambient: float = 20.0


class Series(NamedTuple):
    """Readings as a function of time."""

    readings: Readings  # readings at all times, and the known values
    rows: list[tuple[float, list[Reading]]]  # [(time in s, readings)]
    drift: dict[str, float]  # {unknown: standard deviation of its drift after an hour}


def read(path: FilePath, inputs_folder: FilePath | None = None) -> Readings:
    """Read the file of readings at `path`.

    Bearings and lubricants are looked up as in `catalogue.find`, and recordings in the folder of
    the file. Raise `RacewayError` if the file cannot be used.
    """
    data = yaml_file.read(path, ReadingsError)
    try:
        return _readings(data, Path(path).parent, inputs_folder)
    except ValueError as error:
        raise ReadingsError(f"{path}: {error}") from None


def _readings(data: Any, folder: Path, shelf: FilePath | None) -> Readings:
    given = _mapping(data, "the file")
    _only(given, ("bearing", "lubricant", "models", "ambient", "known", "unknown", "readings"), "")
    if missing := [name for name in ("bearing", "lubricant", "readings") if not given.get(name)]:
        raise ValueError(f"{missing[0]} is missing")
    _names(given, ("bearing", "lubricant", "models"))
    models = given.get("models") or "full"
    if models not in STATICS:
        raise ValueError(f"models '{models}' is not one of {', '.join(STATICS)}")
    bearing = catalogue.find("bearings", given["bearing"], shelf)
    known = _state(given.get("known") or {}, "known")
    unknown = _ranges(given.get("unknown") or {})
    if both := sorted(set(known) & set(unknown)):
        raise ValueError(f"{both[0]} is under both known and unknown")
    rows = given["readings"]
    if not isinstance(rows, list):
        raise ValueError("readings must be a list")
    found = [
        one
        for k, row in enumerate(rows)
        for one in _reading(row, f"reading {k + 1}", bearing, folder)
    ]
    result = Readings(
        bearing,
        catalogue.find("lubricants", given["lubricant"], shelf),
        models,
        DEFAULTS | known,
        unknown,
        found,
        _number(given.get("ambient", 20.0), "ambient", -60, 200),
    )
    _complete(result)
    return result


def need_possible(of: Readings) -> None:
    """Raise `ValueError` for a line that no contact angle explains, such as one in Hz."""
    bearing = inputs.bearing(of.bearing)
    for k, one in enumerate(of.readings):
        if one.quantity in orders.LINES:
            try:
                orders.angle(bearing, one.quantity, one.value)
            except ValueError as error:
                raise ValueError(f"reading {k + 1}: {error}") from None


def _complete(of: Readings) -> None:
    """Raise `ValueError` for readings that cannot be predicted."""
    need_possible(of)
    if not of.unknown:
        raise ValueError("unknown is empty: give at least one unknown, with a range")
    state = {*of.known, *of.unknown}
    for k, one in enumerate(of.readings):
        if "temperature" not in state and one.point.at is None and one.quantity != "temperature":
            raise ValueError(
                f"reading {k + 1}: the temperature of the oil is missing: give it as `at`, or put"
                " it under known or unknown"
            )
        if one.quantity == "temperature" and not state & {"temperature", "conductance"}:
            raise ValueError(
                f"reading {k + 1}: a temperature needs a conductance under known or unknown"
            )


def _reading(row: Any, where: str, bearing: Path, folder: Path) -> list[Reading]:
    given = _mapping(row, where)
    point_keys = [name for name in Point._fields if name in given]
    _only(given, (*Point._fields, *QUANTITIES, "within", *FILE), where)
    if "rpm" not in given and "file" not in given:
        raise ValueError(f"{where}: rpm is missing")
    # a recording gives the value and its uncertainty itself
    other = (*QUANTITIES, "within") if "file" in given else FILE
    if strange := [name for name in other if name in given]:
        kind = "with" if "file" in given else "without"
        raise ValueError(f"{where}: {strange[0]} cannot be given {kind} file")
    if "rpm" in given and "nominal" in given:
        raise ValueError(f"{where}: give rpm, the true speed, or nominal, not both")
    values = {name: _number(given[name], f"{where}: {name}", -1e7, 1e7) for name in point_keys}
    if "rpm" in values and not values["rpm"] > 0:
        raise ValueError(f"{where}: rpm {values['rpm']:g} must be positive")
    if "file" in given:
        return _from_file(given, values, where, bearing, folder)
    said = [name for name in QUANTITIES if name in given]
    if len(said) != 1:
        raise ValueError(f"{where}: must have one of {', '.join(QUANTITIES)}, has {len(said)}")
    value = _number(given[said[0]], f"{where}: {said[0]}", *POSSIBLE.get(said[0], LINE))
    if "within" not in given:
        raise ValueError(f"{where}: within, its standard deviation, is missing")
    within = _number(given["within"], f"{where}: within", 1e-30, 1e6)
    return [Reading(said[0], value, within, Point(**values))]


def _from_file(given, values, where, bearing, folder) -> list[Reading]:
    """Return lines of a recording, with orders and uncertainties that follow from the signal."""
    _names(given, ("file", "line", "channel"), f"{where}: ")
    rate, nominal = (
        _number(given[key], f"{where}: {key}", 1, 1e8) if key in given else None
        for key in ("rate", "nominal")
    )
    recording = Recording(
        folder / given["file"],
        inputs.bearing(bearing),
        rpm=values.get("rpm"),
        nominal=nominal,
        rate=rate,
        nominal_angle=inputs.nominal_angle(bearing),
        name=bearing.name,
    )
    if "rpm" not in values and not recording.speed:
        raise ValueError(
            f"{where}: {recording.where} shows no lines of the shaft near"
            f" {recording.nominal_rpm:g} rpm: give its true speed as rpm"
        )
    found = orders.of_recording(recording, given.get("channel") or "")
    wanted = [given["line"]] if "line" in given else list(found)
    if missing := [name for name in wanted if name not in found]:
        raise ValueError(
            f"{where}: {recording.where} has no line {missing[0]};"
            f" it has {', '.join(found) or 'none'}"
        )
    point = Point(**values | {"rpm": recording.rpm})
    return [Reading(name, found[name].value, found[name].uncertainty, point) for name in wanted]


def _mapping(value: Any, where: str) -> Mapping[str, Any]:
    if not isinstance(value, dict):
        raise ValueError(f"{where} must be a mapping of names to values")
    return value


def _only(given, names, where):
    if strange := [name for name in given if name not in names]:
        said = f"{strange[0]} is not one of {', '.join(names)}"
        raise ValueError(f"{where}: {said}" if where else said)


def _names(given, keys, where=""):
    for key in keys:
        if isinstance(given.get(key), (dict, list)):
            raise ValueError(f"{where}{key} must be one name")


def _state(given, where):
    _only(_mapping(given, where), STATE, where)
    return {
        name: _number(value, f"{where}: {name}", *STATE[name][:2]) for name, value in given.items()
    }


def _ranges(given):
    _only(_mapping(given, "unknown"), STATE, "unknown")
    found = {}
    for name, text in given.items():
        parts = text if isinstance(text, list) else str(text).split()
        if len(parts) != 2:
            raise ValueError(f"unknown: {name} needs a range of two numbers, has '{text}'")
        low, high = (_number(one, f"unknown: {name}", *STATE[name][:2]) for one in parts)
        if not low < high:
            raise ValueError(f"unknown: {name}: {low:g} must be below {high:g}")
        found[name] = (low, high)
    return found


def series(path: FilePath, inputs_folder: FilePath | None = None) -> Series:
    """Read the file of a series at `path`.

    It has the same format as in `read`, but instead of `readings` it contains `series`, the name of
    a CSV file in the same folder; `within`, the standard deviation of each quantity; and `drift`,
    the standard deviation of each unknown after an hour. Raise `RacewayError` if the file cannot be
    used.
    """
    data = yaml_file.read(path, ReadingsError)
    try:
        data = dict(_mapping(data, "the file"))
        own = {name: data.pop(name, None) for name in ("series", "within", "drift")}
        if missing := [name for name in ("series", "within") if not own[name]]:
            raise ValueError(f"{missing[0]} is missing")
        _names(own, ("series",))
        within = _mapping(own["within"], "within")
        _only(within, QUANTITIES, "within")
        known = ("time_s", *Point._fields, *QUANTITIES)
        read = table(Path(path).parent / own["series"], known, ("time_s", "rpm"))
        rows, times = _rows(read, within), [float(one) for one in read["time_s"]]
        readings = [dict(one) for row in rows for one in row]
        result = _readings(dict(data, readings=readings), Path(path).parent, inputs_folder)
        drift = _mapping(own["drift"] or {}, "drift")
        drift = {name: _number(value, f"drift: {name}", 0, 1e9) for name, value in drift.items()}
    except (ValueError, AttributeError) as error:
        raise ReadingsError(f"{path}: {error}") from None
    taken = iter(result.readings)
    found = [(time, [next(taken) for _ in row]) for time, row in zip(times, rows)]
    return Series(result, [one for one in found if one[1]], drift)


def table(path: FilePath, known: Sequence[str], needed: Sequence[str]) -> pd.DataFrame:
    """Read the CSV file at `path`, which has rows of numbers in `known` columns.

    The `needed` columns must be present, and every row must have as many cells as the heading;
    empty cells are NaN. Raise `ReadingsError` if the file cannot be used.
    """
    (_, head), *rows = files.csv_rows(path, ReadingsError) or [(0, [])]
    names = [name.strip() for name in head]
    if strange := [name for name in names if name not in known]:
        raise ReadingsError(f"{path}: column {strange[0]} is not one of {', '.join(known)}")
    if twice := [name for name in names if names.count(name) > 1]:
        raise ReadingsError(f"{path}: column {twice[0]} occurs {names.count(twice[0])} times")
    if not rows:
        raise ReadingsError(f"{path} has no rows of numbers")
    if missing := [name for name in needed if name not in names]:
        raise ReadingsError(f"{path} has no column {missing[0]}")
    found = []
    for line, cells in rows:
        if len(cells) != len(names):
            raise ReadingsError(
                f"{path}, line {line}: {len(cells)} cells, must be {len(names)} as in the heading"
            )
        found.append(
            [
                _cell(cell.strip(), f"{path}, line {line}: {name}")
                for cell, name in zip(cells, names)
            ]
        )
    return pd.DataFrame(found, columns=names)


def _cell(text, what):
    """Return the number in a cell, or NaN for an empty one."""
    try:
        value = yaml_file.number(text or "nan")
    except ValueError:
        value = math.inf
    if math.isinf(value):
        raise ReadingsError(f"{what} is '{text}', must be a finite number")
    return value


def _rows(table, within):
    """Return the readings of each row as dicts; empty cells are skipped."""
    found = []
    for row in table.to_dict("records"):
        known = {name: value for name, value in row.items() if value == value}
        point = {name: known[name] for name in Point._fields if name in known}
        said = [name for name in QUANTITIES if name in known]
        if missing := [name for name in said if name not in within]:
            raise ValueError(f"within: {missing[0]} is missing")
        found.append([{**point, name: known[name], "within": within[name]} for name in said])
    return found
