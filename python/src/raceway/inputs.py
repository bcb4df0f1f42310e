# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the data files of bearings and lubricants that decks use."""

import math
from pathlib import Path
from typing import NamedTuple

from raceway import core
from raceway.data_file import check, numbers, values
from raceway.data_file import comments as comments  # re-exported
from raceway.data_file import text as text
from raceway.errors import InputError
from raceway.files import FilePath
from raceway.sweeps import variable_table
from raceway.theory import life, makers
from raceway.theory.ball_material import BallMaterial, resolve
from raceway.theory.bearing import Bearing, DoubleRow
from raceway.theory.lubricant import Fluid, Lubricant, Vogel, Walther
from raceway.theory.validity import Shoulders

# deck variables for the fields of `Lubricant`, in their order, and for the fields of `Fluid`
PHYSICAL = (
    "oil_density_40 oil_density_slope pressure_viscosity_40 pressure_viscosity_100"
    " permittivity_40 oil_conductivity oil_heat_capacity eyring_stress"
    " limiting_traction"
).split()
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


# variables that a bearing file can omit if it states the pitch diameter and the conformities
RADII = ("inner_radius", "outer_radius", "inner_groove", "outer_groove")
MATERIAL = [
    *(f"ball_{name}" for name in "young poisson density expansion heat_capacity".split()),
    *("ball_conductivity", "ring_young", "ring_poisson", "ring_density"),
]
ELASTIC = ("ball_young", "ball_poisson")


class Oil(NamedTuple):
    """Properties of a lubricant at one temperature, and the roughness of the surfaces."""

    viscosity: float  # Pa s
    pressure_viscosity: float  # 1/Pa
    permittivity: float  # relative permittivity at ambient pressure
    roughness: float  # m, composite roughness


def _named(kind, path):
    """Return the path of a data file. A name without a folder that is not a file in the working
    directory is looked up with `catalogue.find`."""
    from raceway import catalogue  # a module-level import would be circular

    plain = Path(path).name == str(path) and not Path(path).is_file()
    return catalogue.find(kind, str(path)) if plain else path


def bearing(
    path: FilePath,
    *,
    four_point: float | None = None,
    double_row: DoubleRow | None = None,
    one_groove: str | None = None,
) -> Bearing:
    """Return the `Bearing` defined by a file in inputs/bearings or by a name in the catalogue. It
    is a four-point contact bearing if the file or `four_point` (rad) specifies an angle, and has
    two rows if `double_row` is given. If `one_groove` is given, a bearing with several grooves per
    ring is rejected; `one_groove` is the reason given in the message. Raises `InputError`."""
    path = _named("bearings", path)
    body = _one_groove(path)
    angle = four_point_angle(path) if four_point is None else four_point
    if one_groove and (angle is not None or double_row is not None):
        raise InputError(f"{path}: a four-point contact bearing; {one_groove}")
    if angle is not None and nominal_angle(path):
        raise InputError(f"{path}: four-point contact needs a bearing with contact_angle 0")
    try:
        if angle is not None:
            body = body.four_point(angle)
        return body if double_row is None else body.double_row(double_row, nominal_angle(path))
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def _one_groove(path):
    """Return the `Bearing` defined by a file, with one groove per ring."""
    known = values(path)
    data = numbers(path, "balls", "ball_diameter")
    if "pitch_diameter" in known:
        data |= _radii(path)
    given = [name for name in RADII if name in known or "pitch_diameter" not in known]
    data |= numbers(path, *given)
    data["balls"] = int(data["balls"])
    check(path, data)
    numbers(path, *(name for name in variable_table.numbers_of_data() if name in known))
    for side in ("inner", "outer"):
        groove, raceway = data[f"{side}_groove"], data[f"{side}_radius"]
        if groove >= raceway:
            raise InputError(
                f"{path}: {side}_groove = {groove:g} m must be below {side}_radius = {raceway:g} m"
            )
    needed = variable_table.needed("usual data" if "pitch_diameter" in known else "bearing data")
    numbers(path, *(name for name in ELASTIC if name in needed))  # error if they are missing
    ball, ring = _materials(path)
    try:
        return Bearing(
            **data,
            young=ball.young,
            poisson=ball.poisson,
            ring_young=ring.young,
            ring_poisson=ring.poisson,
        )
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def held(
    path: FilePath, axial: float, clearance: float = 0.0, double_row: DoubleRow | None = None
) -> dict[str, float]:
    """Return {"z": position in m}, where z is the axial position at which decks hold the inner ring
    of a single-row bearing if there is no `axial` load (N). At this position, the balls touch at
    the contact angle stated in the file. The dict is empty if there is an axial load or if the
    bearing has two rows. Raises `InputError`, also if decks would reject the `clearance` (m)."""
    angle, body = nominal_angle(path), _one_groove(path)
    if angle and clearance:
        raise InputError(
            f"{path}: clearance {clearance:g} m must be 0: it follows from the contact angle"
        )
    # as in create_bearing: half the preload compresses each contact, by at most 0.02 ball radii
    least, most = -0.08 * body.ball_radius, body.play(math.pi / 2)
    if not least <= clearance <= most:
        raise InputError(
            f"{path}: clearance {clearance:g} m must be from {least:g} to {most:g} m, or the balls"
            " do not fit"
        )
    return {} if axial or double_row is not None else {"z": body.seat(angle)}


def ball_density(path: FilePath) -> float:
    """Return the density of the balls (kg/m^3) stated in a file in inputs/bearings; the default is
    the density of steel. Raises `InputError`."""
    return ball_material(path).density


def ball_material(path: FilePath) -> BallMaterial:
    """Return the material of the balls stated in a file in inputs/bearings; the default is steel.
    Raises `InputError`."""
    return _materials(path)[0]


def _materials(path):
    """Return the `BallMaterial` and the `Steel` of the rings. Raises `InputError`."""
    known = values(path)
    stated = [name for name in MATERIAL if name in known]
    material = known.get("ball_material", variable_table.default("ball_material"))
    if wrong := core.wrong_value("ball_material", material):
        raise InputError(f"{path}: {wrong}")
    return resolve(numbers(path, *stated), material)


def nominal_angle(path: FilePath) -> float:
    """Return the nominal contact angle (rad) stated in a file in inputs/bearings; the default is 0.
    Raises `InputError`."""
    if "contact_angle" not in values(path):
        return 0.0
    return math.radians(numbers(path, "contact_angle")["contact_angle"])


def four_point_angle(path: FilePath) -> float | None:
    """Return the angle (rad) at which centred balls touch both grooves of each ring, as stated in a
    file in inputs/bearings, or None for a bearing with one groove per ring. Raises `InputError`."""
    if "four_point" not in values(path):
        return None
    return math.radians(numbers(path, "four_point")["four_point"]) or None


def _radii(path):
    """Compute the raceway and groove radii (m) from catalogue data, as the command `bearing`
    does."""
    pitch, ball, inner, outer = numbers(
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
    """Return the `makers.Boundary` of a bearing from its file in inputs/bearings, or None if the
    file states no series of `makers.SERIES`. Raises `InputError`."""
    names = ("bore_diameter", "outside_diameter", "bearing_width", "basic_static_load")
    if (series := values(path).get("series")) not in makers.SERIES:
        return None
    bore, outside, width, static = numbers(path, *names).values()
    try:
        return makers.Boundary(1e3 * bore, 1e3 * outside, 1e3 * width, series, static)
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None


def size(path: FilePath) -> makers.Size | None:
    """Return the `makers.Size` of a bearing from its file in inputs/bearings, or None if the file
    does not state both bore and outside diameter. Raises `InputError`."""
    names = ("bore_diameter", "outside_diameter")
    if not values(path).keys() >= set(names):
        return None
    bore, outside = numbers(path, *names).values()
    slender = makers.K_Z_ANGULAR if nominal_angle(path) else makers.K_Z
    return makers.Size(bore, outside, slender) if outside > bore else None


def ratings(path: FilePath) -> life.Ratings | None:
    """Return the `life.Ratings` of a bearing from its file in inputs/bearings, or None if the file
    does not state both load ratings. Raises `InputError` for an invalid rating."""
    names = ("basic_dynamic_load", "basic_static_load")
    if not values(path).keys() >= set(names):
        return None
    rated = numbers(path, *names)
    for name, value in rated.items():
        if not 0 < value < math.inf:
            raise InputError(f"{path}: {name} = {value:g} N must be above 0")
    estimate = life.ratings(*rated.values(), 2 * _one_groove(path).pitch_radius)
    if "fatigue_load_limit" in values(path):
        limit = numbers(path, "fatigue_load_limit")["fatigue_load_limit"]
        if not 0 < limit < rated["basic_static_load"]:
            raise InputError(
                f"{path}: fatigue_load_limit = {limit:g} N must lie between 0 and the static rating"
            )
        return estimate._replace(fatigue=limit)
    return estimate


def minimum_load(path: FilePath) -> tuple[float, float] | None:
    """Return (k_r, mean of bore and outside diameter in m) for `life.minimum_load` from a file in
    inputs/bearings. The result is None if the file does not state the factor k_r. Raises
    `InputError`."""
    if "minimum_load_factor" not in values(path):
        return None
    names = ("minimum_load_factor", "bore_diameter", "outside_diameter")
    factor, bore, outside = numbers(path, *names).values()
    if not 0 < factor < 1:
        raise InputError(f"{path}: minimum_load_factor = {factor:g} must lie between 0 and 1")
    return factor, (bore + outside) / 2


def shoulders(path: FilePath) -> Shoulders:
    """Return the `Shoulders` of a bearing from its file in inputs/bearings. Diameters that the file
    does not state are NaN. Raises `InputError` for an invalid diameter."""
    data = _one_groove(path)
    bottoms = {"inner": 2 * data.inner_radius, "outer": 2 * data.outer_radius}
    found = {}
    for name, bottom in bottoms.items():
        key = f"{name}_shoulder_diameter"
        # 0 means that the diameter is unknown, as in a deck
        if key not in values(path) or not (diameter := numbers(path, key)[key]):
            continue
        found[name] = diameter
        groove = data.inner_groove if name == "inner" else data.outer_groove
        least, most = sorted((bottom, bottom + (2 if name == "inner" else -2) * groove))
        if not least < found[name] <= most:
            raise InputError(
                f"{path}: {key} = {found[name]:g} m must be between {least:g} and {most:g} m"
            )
    return Shoulders(**found)


def dry(path: FilePath) -> bool:
    """Return True if the data of a lubricant state that there is none (`film dry`)."""
    return values(_named("lubricants", path)).get("film") == "dry"


def oil(path: FilePath, temperature: float | None = None) -> Oil:
    """Return the `Oil` for a lubricant, given by its name or by a file in inputs/lubricants, at a
    `temperature` in degrees C (default: the temperature stated in the file). Raises `InputError`,
    also if the lubricant is dry."""
    path = _named("lubricants", path)
    at = fluid(path, temperature)
    data = _constants(path, "roughness", "ball_roughness")
    return Oil(
        at.viscosity,
        at.pressure_viscosity,
        at.permittivity,
        (data["roughness"] ** 2 + data["ball_roughness"] ** 2) ** 0.5,
    )


def fluid(path: FilePath, temperature: float | None = None) -> Fluid:
    """Return the `Fluid` for a lubricant, given by its name or by a file in inputs/lubricants, at a
    `temperature` in degrees C (default: the temperature stated in the file).

    A file contains either physical data, from which the properties can be computed at any
    temperature, or the properties of the fluid at one temperature. As in a deck, properties that
    are given directly take precedence over physical data. Properties that older files lack are NaN.
    Raises `InputError`, also for a temperature at which there are no values.
    """
    path = _named("lubricants", path)
    data = values(path)
    own = numbers(path, "temperature")["temperature"] if "temperature" in data else math.nan
    if physical(path) and "temperature" not in data:
        own = float(variable_table.default("temperature"))
    if physical(path):
        try:
            result = lubricant(path).at(own if temperature is None else temperature)
        except ValueError as error:
            raise InputError(f"{path}: {error}") from None
    else:
        if "viscosity" not in data:
            raise InputError(
                f"{path} has no viscosity: give kinematic_viscosity_40, kinematic_viscosity_100"
                " (mm2/s) and oil_density_40 (kg/m3) for all temperatures, or viscosity (Pa s) for"
                f" one; it has {', '.join(data) or 'nothing'}"
            )
        numbers(path, "viscosity")
        if temperature not in (None, own):
            raise InputError(
                f"{path} has values for {own:g} C only, not for {temperature:g} C: use a file "
                "with physical data, for example vg46"
            )
        result = Fluid(own, *[math.nan] * (len(Fluid._fields) - 1))
    given = {field: key for field, key in FLUID.items() if key in data}
    result = result._replace(**dict(zip(given, numbers(path, *given.values()).values())))
    usual = assumed(path)
    return result._replace(**{field: usual[key] for field, key in FLUID.items() if key in usual})


def assumed(path: FilePath, models: str | None = None) -> dict[str, float]:
    """Return {name: value} for the constants of an oil that its file does not state, with the
    defaults that decks and statics use instead. If `models` is given, only the constants that these
    models need are returned. Raises `InputError`."""
    data, over, table = values(path), physical(path), variable_table.oil()
    return {
        name: float(row["default"])
        for name, row in table.items()
        if name not in data
        and (models is None or not row["models"] or models in row["models"].split())
        # the file gives either constants for all temperatures or constants for one temperature
        and (over if row["of"] == "oil over temperature" else not (over and f"{name}_40" in table))
    }


def _constants(path, *names):
    """Return the constants `names` of an oil, with defaults for those that its file lacks."""
    usual = {name: value for name, value in assumed(path).items() if name in names}
    found = numbers(path, *(name for name in names if name not in usual)) | usual
    return {name: found[name] for name in names}


def physical(path: FilePath) -> bool:
    """Return True if a file in inputs/lubricants has physical data, which hold at any
    temperature."""
    return not {"kinematic_viscosity_40", "vogel_viscosity"}.isdisjoint(values(path))


def lubricant(path: FilePath) -> Lubricant:
    """Return the `Lubricant` with physical data that is specified by a name or a file. Raises
    `InputError` if the data are missing or invalid."""
    path = _named("lubricants", path)
    law, names = (
        (Vogel, ("vogel_viscosity", "vogel_slope", "vogel_temperature"))
        if "vogel_viscosity" in values(path)
        else (Walther, ("kinematic_viscosity_40", "kinematic_viscosity_100"))
    )
    try:
        return Lubricant(
            law(*numbers(path, *names).values()), *_constants(path, *PHYSICAL).values()
        )
    except ValueError as error:
        raise InputError(f"{path}: {error}") from None
