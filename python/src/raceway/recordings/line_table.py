# SPDX-License-Identifier: GPL-2.0-or-later
"""Reader for a table of bearing lines in hertz, i.e. the file of `raceway identify --lines`."""

from pathlib import Path

import pandas as pd

from raceway import catalogue, clearance_classes, inputs
from raceway.errors import InputError
from raceway.files import FilePath
from raceway.recordings import WITHIN, readings
from raceway.recordings.readings import STATE, Point, Reading, Readings, ReadingsError
from raceway.theory.models import STATICS

LINES = {"bpfo_Hz": "BPFO", "bpfi_Hz": "BPFI", "bsf_Hz": "BSF", "ftf_Hz": "FTF"}
KNOWN = {"load_N": "load", "temperature_C": "temperature"}
COLUMNS = ("speed_Hz", *LINES, *KNOWN)
LIGHT, HEAVY = 1e-4, 0.1  # range of an unknown load, as fractions of the static load rating
OIL = (20.0, 100.0)  # C, range of an unknown oil temperature


def read(
    path: FilePath,
    bearing: str,
    *,
    lubricant: str = "vg46",
    models: str = "full",
    load: float | None = None,
    temperature: float | None = None,
    within: float = WITHIN,
    inputs_folder: FilePath | None = None,
) -> Readings:
    """Read the CSV file at `path` and return its `Readings`.

    The file has a row for each recording, with the shaft speed `speed_Hz`, any of `bpfo_Hz`,
    `bpfi_Hz`, `bsf_Hz` (rotations of a ball relative to the cage) and `ftf_Hz`, and optionally the
    radial load `load_N` and the oil temperature `temperature_C`. Empty cells are skipped.

    `within` is the relative standard deviation of a line. The unknowns are thrust, clearance unless
    the bearing has a contact angle, and load (N) and oil temperature (C) unless they are given.
    Raise `RacewayError` if the file cannot be used.
    """
    if models not in STATICS:
        raise ReadingsError(f"models '{models}' is not one of {', '.join(STATICS)}")
    found, table = catalogue.find("bearings", bearing, inputs_folder), _table(path)
    unknown, known = _ranges(found), {"clearance": 0.0}
    for column, (name, value) in zip(KNOWN, (("load", load), ("temperature", temperature))):
        if column in table and value is not None:
            raise ReadingsError(f"{path} has the column {column}: leave out the {name} {value:g}")
        if value is not None:
            known[name] = value
        if column in table or value is not None:
            unknown.pop(name)
    rows = [one for row in table.to_dict("records") for one in _row(row, within)]
    if not rows:
        raise ReadingsError(f"{path} has no line: give one of {', '.join(LINES)}")
    oil = catalogue.find("lubricants", lubricant, inputs_folder)
    known = {name: value for name, value in known.items() if name not in unknown}
    result = Readings(found, oil, models, known, unknown, rows)
    try:
        readings.need_possible(result)
    except ValueError as error:
        raise ReadingsError(f"{path}: {error}") from None
    return result


def _table(path):
    table = readings.table(path, COLUMNS, ("speed_Hz",))
    for column in table:
        low, high = _limits(column)
        values = table[column].dropna() if column in LINES else table[column]
        if len(bad := values[~values.between(low, high)]):
            raise ReadingsError(
                f"{path}: {column} {bad.iloc[0]:g} must lie between {low:g} and {high:g}"
            )
    return table


def _limits(column):
    if column in KNOWN:
        return STATE[KNOWN[column]][:2]
    return (1e-3, 1e5)  # Hz


def _row(row, within):
    speed = row["speed_Hz"]
    point = Point(60 * speed, load=row.get("load_N"), at=row.get("temperature_C"))
    return [
        Reading(line, row[column] / speed, within * row[column] / speed, point)
        for column, line in LINES.items()
        if pd.notna(row.get(column))
    ]


def _ranges(path: Path):
    """Return the ranges of the unknowns of a bearing."""
    maker = inputs.boundary(path)
    static = maker.static_rating if maker else 1e4
    ranges = {
        "axial": (LIGHT * static, HEAVY * static),
        "load": (LIGHT * static, HEAVY * static),
        "temperature": OIL,
    }
    if inputs.nominal_angle(path):
        return ranges
    return {"clearance": _clearances(path)} | ranges


def _clearances(path):
    """Return the range of the clearance in m.

    It extends from an interference as large as the largest normal clearance to the largest
    clearance of all classes. For bores without classes, it is proportional to the ball diameter.
    """
    try:
        classes = clearance_classes.of_bore(inputs.numbers(path, "bore_diameter")["bore_diameter"])
    except (ValueError, InputError):
        ball = inputs.bearing(path).ball_diameter
        return (-2e-3 * ball, 6e-3 * ball)
    return (-classes["CN"][1], max(high for _, high in classes.values()))
