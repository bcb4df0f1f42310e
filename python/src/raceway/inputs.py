# SPDX-License-Identifier: GPL-2.0-or-later
"""The data files of the decks: `variable NAME index VALUE # comment`."""

import re
from typing import NamedTuple

from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.theory.bearing import Bearing

LINE = re.compile(r"\s*variable\s+(\w+)\s+index\s+(\S+)")


class InputError(RacewayError):
    """A data file is missing, broken or incomplete."""


class Oil(NamedTuple):
    """A lubricant at its temperature, and the surfaces it is between."""

    viscosity: float  # Pa s
    pressure_viscosity: float  # 1/Pa
    permittivity: float  # relative, at rest
    roughness: float  # m, composite


def values(path: FilePath) -> dict[str, str]:
    """The index variables of a data file as {name: text}. Raises `InputError` when it cannot be
    read."""
    try:
        lines = path.read_text().splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(
            f"cannot read {path}: {getattr(error, 'strerror', None) or error}"
        ) from None
    return dict(match.groups() for match in map(LINE.match, lines) if match)


def bearing(path: FilePath) -> Bearing:
    """`Bearing` of a file of inputs/bearings. Raises `InputError`."""
    data = _numbers(
        path,
        "balls",
        "ball_diameter",
        "inner_radius",
        "outer_radius",
        "inner_groove",
        "outer_groove",
        "ball_young",
        "ball_poisson",
    )
    data["balls"] = int(data["balls"])
    young, poisson = data.pop("ball_young"), data.pop("ball_poisson")
    try:
        return Bearing(**data, young=young, poisson=poisson)
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def oil(path: FilePath) -> Oil:
    """`Oil` of a file of inputs/lubricants. Raises `InputError`, for the dry one too."""
    data = _numbers(
        path, "viscosity", "pressure_viscosity", "permittivity", "roughness", "ball_roughness"
    )
    composite = (data.pop("roughness") ** 2 + data.pop("ball_roughness") ** 2) ** 0.5
    return Oil(**data, roughness=composite)


def _numbers(path, *names):
    data = values(path)
    if missing := [name for name in names if name not in data]:
        raise InputError(f"{path} has no variable {', '.join(missing)}")
    try:
        return {name: float(data[name]) for name in names}
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None
