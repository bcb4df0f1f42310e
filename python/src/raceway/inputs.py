# SPDX-License-Identifier: GPL-2.0-or-later
"""The data files of the decks: `variable NAME index VALUE # comment`."""

import math
import re
from pathlib import Path
from typing import NamedTuple

from raceway import data_table
from raceway.errors import InputError
from raceway.files import FilePath
from raceway.theory import life, makers
from raceway.theory.bearing import Bearing, DoubleRow
from raceway.theory.lubricant import Fluid, Lubricant, Vogel, Walther
from raceway.theory.validity import Shoulders

LINE = re.compile(r"\s*variable\s+(\w+)\s+index\s+(\S+)")
REMARK = re.compile(r"\s*variable\s+(\w+)\s+index\s+\S+\s*#\s*(.*\S)")

# variables of a lubricant in the order of `Lubricant`, and those that give a `Fluid` outright
PHYSICAL = (
    "oil_density_40",
    "oil_density_slope",
    "pressure_viscosity_40",
    "pressure_viscosity_100",
    "permittivity_40",
    "oil_conductivity",
    "oil_heat_capacity",
    "eyring_stress",
    "limiting_traction",
)
FLUID = {
    "viscosity": "viscosity",
    "pressure_viscosity": "pressure_viscosity",
    "temperature_viscosity": "temperature_viscosity",
    "density": "oil_density",
    "permittivity": "permittivity",
    "conductivity": "oil_conductivity",
    "heat_capacity": "oil_heat_capacity",
    "eyring_stress": "eyring_stress",
    "limiting_traction": "limiting_traction",
}


# of `Bearing`, and what a bearing given by its usual data may leave out
RADII = ("inner_radius", "outer_radius", "inner_groove", "outer_groove")
STEEL = {"ball_young": 210e9, "ball_poisson": 0.3}


class Oil(NamedTuple):
    """A lubricant at its temperature, and the surfaces it is between."""

    viscosity: float  # Pa s
    pressure_viscosity: float  # 1/Pa
    permittivity: float  # relative, at rest
    roughness: float  # m, composite


def text(path: FilePath) -> str:
    """A data file, or the one that a row of a table in its folder stands for (`data_table`). Raises
    `InputError` when there is neither or it cannot be read."""
    path = Path(path)
    if not path.is_file() and (row := data_table.text(path)):
        return row
    try:
        return path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(
            f"cannot read {path}: {getattr(error, 'strerror', None) or error}"
        ) from None


def values(path: FilePath) -> dict[str, str]:
    """The index variables of a data file as {name: text}. Raises `InputError` when it cannot be
    read."""
    return _matches(path, LINE)


def comments(path: FilePath) -> dict[str, str]:
    """What a data file says behind its index variables, as {name: comment}. Raises `InputError`
    when it cannot be read."""
    return _matches(path, REMARK)


def _matches(path, pattern):
    return dict(m.groups() for m in map(pattern.match, text(path).splitlines()) if m)


def bearing(
    path: FilePath,
    *,
    four_point: float | None = None,
    double_row: DoubleRow | None = None,
    one_groove: str | None = None,
) -> Bearing:
    """`Bearing` of a file of inputs/bearings, of four points where the file or `four_point` (rad)
    says so, with two rows by `double_row`. `one_groove`, a reason, refuses several grooves a ring.
    Raises `InputError`."""
    body = _one_groove(path)
    angle = four_point_angle(path) if four_point is None else four_point
    if one_groove and (angle is not None or double_row is not None):
        raise InputError(f"{path}: a four-point contact bearing; {one_groove}")
    if angle is not None and nominal_angle(path):
        raise InputError(f"{path}: four points need a bearing of contact_angle 0")
    try:
        if angle is not None:
            body = body.four_point(angle)
        return body if double_row is None else body.double_row(double_row, nominal_angle(path))
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def _one_groove(path):
    """`Bearing` of a file with one groove a ring."""
    known = values(path)
    data = _numbers(path, "balls", "ball_diameter")
    if "pitch_diameter" in known:
        data |= _radii(path)
    given = [name for name in RADII if name in known or "pitch_diameter" not in known]
    data |= _numbers(path, *given)
    data["balls"] = int(data["balls"])
    steel = [] if "pitch_diameter" in known else ["ball_young", "ball_poisson"]
    names = steel or [name for name in ("ball_young", "ball_poisson") if name in known]
    elastic = STEEL | _numbers(path, *names)
    young, poisson = elastic["ball_young"], elastic["ball_poisson"]
    try:
        return Bearing(**data, young=young, poisson=poisson)
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def nominal_angle(path: FilePath) -> float:
    """Contact angle (rad) of a file of inputs/bearings, 0 where it states none. Raises
    `InputError`."""
    if "contact_angle" not in values(path):
        return 0.0
    return math.radians(_numbers(path, "contact_angle")["contact_angle"])


def four_point_angle(path: FilePath) -> float | None:
    """Angle (rad) at which balls in the middle are in contact with both grooves of each ring, of a
    file of inputs/bearings; None of a bearing with one groove a ring. Raises `InputError`."""
    if "four_point" not in values(path):
        return None
    angle = _numbers(path, "four_point")["four_point"]
    if not 5 <= angle <= 60:
        raise InputError(f"{path}: four_point = {angle:g} degrees must lie between 5 and 60")
    return math.radians(angle)


def _radii(path):
    """Raceways and grooves from the usual data, as bearing_derive usual_data has them (m)."""
    pitch, ball, inner, outer = _numbers(
        path, "pitch_diameter", "ball_diameter", "inner_conformity", "outer_conformity"
    ).values()
    cosine, radius = math.cos(nominal_angle(path)), ball / 2
    inner, outer = inner * ball, outer * ball
    return {
        "inner_radius": pitch / 2 - inner + (inner - radius) * cosine,
        "outer_radius": pitch / 2 + outer - (outer - radius) * cosine,
        "inner_groove": inner,
        "outer_groove": outer,
    }


def boundary(path: FilePath) -> makers.Boundary | None:
    """`makers.Boundary` of a file of inputs/bearings, None when it has no maker's data. Raises
    `InputError`."""
    names = ("bore_diameter", "outside_diameter", "bearing_width", "basic_static_load")
    if "series" not in values(path):
        return None
    bore, outside, width, static = _numbers(path, *names).values()
    try:
        series = values(path)["series"]
        return makers.Boundary(1e3 * bore, 1e3 * outside, 1e3 * width, series, static)
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def ratings(path: FilePath) -> life.Ratings | None:
    """`life.Ratings` of a file of inputs/bearings, None when it does not state both load ratings.
    Raises `InputError` for a rating that is none."""
    names = ("basic_dynamic_load", "basic_static_load")
    if not values(path).keys() >= set(names):
        return None
    numbers = _numbers(path, *names)
    for name, value in numbers.items():
        if not 0 < value < math.inf:
            raise InputError(f"{path}: {name} = {value:g} N must be above 0")
    estimate = life.ratings(*numbers.values(), 2 * _one_groove(path).pitch_radius)
    if "fatigue_load_limit" in values(path):
        limit = _numbers(path, "fatigue_load_limit")["fatigue_load_limit"]
        if not 0 < limit < numbers["basic_static_load"]:
            raise InputError(
                f"{path}: fatigue_load_limit = {limit:g} N must lie between 0 and the static rating"
            )
        return estimate._replace(fatigue=limit)
    return estimate


def minimum_load(path: FilePath) -> tuple[float, float] | None:
    """(k_r, mean of bore and outside diameter in m) of a file of inputs/bearings for
    `life.minimum_load`, None when it does not state the factor. Raises `InputError`."""
    if "minimum_load_factor" not in values(path):
        return None
    names = ("minimum_load_factor", "bore_diameter", "outside_diameter")
    factor, bore, outside = _numbers(path, *names).values()
    if not 0 < factor < 1:
        raise InputError(f"{path}: minimum_load_factor = {factor:g} must lie between 0 and 1")
    return factor, (bore + outside) / 2


def shoulders(path: FilePath) -> Shoulders:
    """`Shoulders` of a file of inputs/bearings, NaN for what it does not say. Raises `InputError`
    for a diameter that is none."""
    data = _one_groove(path)
    bottoms = {"inner": 2 * data.inner_radius, "outer": 2 * data.outer_radius}
    found = {}
    for name, bottom in bottoms.items():
        key = f"{name}_shoulder_diameter"
        if key not in values(path):
            continue
        found[name] = _numbers(path, key)[key]
        groove = data.inner_groove if name == "inner" else data.outer_groove
        least, most = sorted((bottom, bottom + (2 if name == "inner" else -2) * groove))
        if not least < found[name] <= most:
            raise InputError(
                f"{path}: {key} = {found[name]:g} m must be between {least:g} and {most:g} m"
            )
    return Shoulders(**found)


def oil(path: FilePath, temperature: float | None = None) -> Oil:
    """`Oil` of a file of inputs/lubricants at a `temperature` in degrees C, the file's own unless
    given. Raises `InputError`, for the dry one too."""
    at = fluid(path, temperature)
    data = _numbers(path, "roughness", "ball_roughness")
    return Oil(
        at.viscosity,
        at.pressure_viscosity,
        at.permittivity,
        (data["roughness"] ** 2 + data["ball_roughness"] ** 2) ** 0.5,
    )


def fluid(path: FilePath, temperature: float | None = None) -> Fluid:
    """`Fluid` of a file of inputs/lubricants at a `temperature` in degrees C, the file's own unless
    given.

    A file has physical data, from which the fluid follows at any temperature, or the fluid
    outright, at one. A value given outright goes before physical data, as in a deck. What an older
    file does not say is NaN. Raises `InputError`, also for a temperature a file has no values for.
    """
    data = values(path)
    own = float(data.get("temperature", "nan"))
    if physical(path):
        try:
            result = lubricant(path).at(own if temperature is None else temperature)
        except ValueError as error:
            raise InputError(f"{path}: {error}") from None
    else:
        _numbers(path, "viscosity", "pressure_viscosity", "permittivity")
        if temperature not in (None, own):
            raise InputError(
                f"{path} has values for {own:g} C only and none for {temperature:g} C: take a file "
                "with physical data, vg46 for example"
            )
        result = Fluid(own, *[math.nan] * (len(Fluid._fields) - 1))
    given = {field: key for field, key in FLUID.items() if key in data}
    return result._replace(**dict(zip(given, _numbers(path, *given.values()).values())))


def physical(path: FilePath) -> bool:
    """True if a file of inputs/lubricants has physical data, for any temperature."""
    return "oil_density_40" in values(path)


def lubricant(path: FilePath) -> Lubricant:
    """`Lubricant` of a file with physical data. Raises `InputError`."""
    law, names = (
        (Vogel, ("vogel_viscosity", "vogel_slope", "vogel_temperature"))
        if "vogel_viscosity" in values(path)
        else (Walther, ("kinematic_viscosity_40", "kinematic_viscosity_100"))
    )
    try:
        return Lubricant(law(*_numbers(path, *names).values()), *_numbers(path, *PHYSICAL).values())
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def _numbers(path, *names):
    data = values(path)
    if missing := [name for name in names if name not in data]:
        raise InputError(f"{path} has no variable {', '.join(missing)}")
    try:
        return {name: float(data[name]) for name in names}
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None
