# SPDX-License-Identifier: GPL-2.0-or-later
"""Read a shaft with its bearings and loads from a YAML file (`docs/shaft.rst`)."""

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

from raceway import catalogue, inputs, yaml_file
from raceway.files import FilePath
from raceway.inputs import InputError
from raceway.sweeps import variable_table
from raceway.theory import life
from raceway.theory.beam import Disc, Section, Steel
from raceway.theory.shaft import Load, Seat, Shaft
from raceway.theory.steel import STEEL

# {section of the file: {name: (default, or None if required; smallest, largest value)}}
NUMBERS: Mapping[str, Mapping[str, tuple[float | None, float, float]]] = {
    "file": {"rpm": (0.0, 0.0, 1e5)},
    "steel": {  # within the ranges of the steel of balls
        name: (default, *variable_table.limits(f"ball_{name}"))
        for name, default in STEEL._asdict().items()
    },
    "sections": {
        "length": (None, 1e-6, 100.0),
        "diameter": (None, 1e-4, 10.0),
        "bore": (0.0, 0.0, 10.0),
    },
    "bearings": {
        "at": (None, 0.0, 1e3),
        "clearance": (0.0, -1e-3, 1e-3),
        "phase": (0.0, -2 * math.pi, 2 * math.pi),
        "spring": (0.0, -1e6, 1e6),
    },
    "loads": {"at": (None, 0.0, 1e3)},
    "discs": {
        "at": (None, 0.0, 1e3),
        "mass": (None, 0.0, 1e5),
        "axial": (0.0, 0.0, 1e6),
        "transverse": (0.0, 0.0, 1e6),
    },
}
LISTS = {  # {name: (length, largest magnitude of an element)}
    "file": {"gravity": (3, 1e3)},
    "bearings": {"offset": (5, 0.1)},
    "loads": {"force": (3, 1e7), "moment": (2, 1e6)},
}
OTHERS = {
    "file": ("steel", "sections", "bearings", "loads", "discs", "lubricant"),
    "bearings": ("name", "floating"),
}
FLOATING = {"yes": True, "true": True, "no": False, "false": False}


class Case(NamedTuple):
    """Contents of a shaft file."""

    shaft: Shaft
    names: list[str]  # names of the bearings
    seats: list[Seat]
    ratings: list[life.Ratings | None]
    angles: list[float]  # rad, nominal contact angles
    loads: list[Load]
    rpm: float
    lubricant: str | None


def read(path: FilePath, folder: FilePath | None = None) -> Case:
    """Read the YAML file at `path` and return it as a `Case`. Bearings are searched for in the
    inputs `folder` (`catalogue.find`). Raises an `InputError` that states the location of an
    invalid value and its allowed range."""
    whole = _part(yaml_file.read(path), str(path), "file")
    steel = Steel(**_part(whole.get("steel", {}), f"{path}: steel", "steel"))
    sections = [Section(**one) for one in _parts(whole, path, "sections")]
    for k, one in enumerate(sections, 1):
        if one.bore >= one.diameter:
            raise InputError(
                f"{path}: sections {k}: bore {one.bore:g} m must be below the diameter"
                f" {one.diameter:g} m"
            )
    names, seats, ratings, angles = [], [], [], []
    for one in _parts(whole, path, "bearings"):
        name, floating = one.pop("name", None), one.pop("floating", "no")
        if not isinstance(name, str) or floating not in FLOATING:
            raise InputError(
                f"{path}: bearings {len(seats) + 1}: needs a name, and floating must be yes or no"
            )
        found = catalogue.find("bearings", name, folder)
        inputs.held(found, 0.0, one["clearance"])  # refuses a clearance as all commands do
        names.append(found.name)
        seats.append(
            Seat(
                bearing=inputs.bearing(found),
                floating=FLOATING[floating],
                ball_density=inputs.ball_density(found),
                **one,
            )
        )
        ratings.append(inputs.ratings(found))
        angles.append(inputs.four_point_angle(found) or inputs.nominal_angle(found))
    lubricant = whole.get("lubricant")
    if not isinstance(lubricant, str | None):
        raise InputError(f"{path}: lubricant must be one name")
    loads = [Load(**one) for one in _parts(whole, path, "loads")]
    discs = [Disc(**one) for one in _parts(whole, path, "discs")] if "discs" in whole else []
    return Case(
        Shaft(sections, steel, whole["gravity"], discs),
        names,
        seats,
        ratings,
        angles,
        loads,
        whole["rpm"],
        lubricant,
    )


def _parts(whole: Mapping[str, Any], path: FilePath, kind: str) -> list[dict[str, Any]]:
    entries = whole.get(kind)
    if not isinstance(entries, list) or not entries:
        raise InputError(f"{path}: needs a list of {kind}")
    return [_part(one, f"{path}: {kind} {k}", kind) for k, one in enumerate(entries, 1)]


def _part(data: Any, where: str, kind: str) -> dict[str, Any]:
    """Check the values in one part of the file, and fill in defaults for missing values."""
    numbers, lists, others = NUMBERS[kind], LISTS.get(kind, {}), OTHERS.get(kind, ())
    if not isinstance(data, Mapping):
        raise InputError(f"{where}: must consist of names and values")
    known = [*numbers, *lists, *others]
    if unknown := [name for name in data if name not in known]:
        raise InputError(f"{where}: unknown '{unknown[0]}'; known: {', '.join(known)}")
    result = {name: data[name] for name in others if name in data}
    for name, (default, least, most) in numbers.items():
        if name in data:
            result[name] = yaml_file.number_within(data[name], f"{where}: {name}", least, most)
        elif default is None:
            raise InputError(f"{where}: needs {name}")
        else:
            result[name] = default
    for name, (length, most) in lists.items():
        values = data.get(name, ["0"] * length)
        if not isinstance(values, list) or len(values) != length:
            raise InputError(f"{where}: {name} must be a list of {length} numbers")
        result[name] = tuple(
            yaml_file.number_within(one, f"{where}: {name}", -most, most) for one in values
        )
    return result
