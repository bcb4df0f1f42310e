# SPDX-License-Identifier: GPL-2.0-or-later
"""Export stiffness and damping of a bearing as functions of load and speed, for rotor dynamics
programs: as a table (CSV, JSON) and for ROSS, which need not be installed.

ROSS (`ross-rotordynamics`) uses the same axes: x and y are transverse, z is along the shaft, and
the tilts alpha = rx and beta = ry are right-handed. Its `BearingElement` accepts only translations,
and no coupling of x and y to z.
"""

import json
import math
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway import catalogue, files, inputs
from raceway.arrays import Floats
from raceway.errors import RacewayError, RunWarning
from raceway.files import FilePath
from raceway.theory.bearing import Bearing, DoubleRow
from raceway.theory.ring_response import LAWS, OverPass, turning_ring
from raceway.theory.shaft import Carried
from raceway.theory.small_motion import SLOW
from raceway.theory.static import FREEDOMS, STRAIGHT

# power of 1/m for each row and column; if two powers add up to 2, the unit is N/m
PER_METRE = (1, 1, 1, 0, 0)
TAKEN = ("xx", "xy", "yx", "yy", "zz")  # entries accepted by ROSS's BearingElement
ROSS_FREEDOMS = 6  # degrees of freedom of a node: `FREEDOMS` and the rotation about z
TILTS = ("held", "free")
# largest rounding error of entries that are 0 by symmetry, as a fraction of the diagonal
NOISE = 1e-9


class Point(NamedTuple):
    """Stiffness and damping of a bearing at one operating point."""

    rpm: float
    load: float  # N, radial load, along x unless `load_azimuth` or `at_rest` is used
    axial: float  # N, axial load
    over: OverPass


def points(
    bearing: str | Bearing,
    load: ArrayLike,
    rpm: ArrayLike,
    *,
    axial: float = 0.0,
    lubricant: str | None = None,
    temperature: float | None = None,
    models: str = "full",
    folder: FilePath | None = None,
    frequency: float | None = None,
    phases: int | None = None,
    four_point: float | None = None,
    double_row: DoubleRow | None = None,
    **options: Any,
) -> list[Point]:
    """Return a `Point` for each combination of a radial `load` (N, along x) and a speed `rpm` of
    the inner ring, ordered by load.

    `bearing` is a `Bearing`, or the name of a file in the inputs `folder` or its path; the same
    names are accepted for `lubricant`. `four_point` and `double_row` are as in `inputs.bearing`. If
    no lubricant is given, there is no damping. `models` is paper or full, and `temperature` is in
    degrees C. `frequency` is the vibration frequency in rad/s; by default it is the shaft speed, as
    rotor programs assume for their tables. `phases` is as in `ring_response.over_pass`. `axial` is
    in N; `options` (clearance, held, moment, ball_density) are passed to `static.equilibrium`. By
    default, the tilts are held at 0. If the bearing comes from a file, so does the density of its
    balls, and the ring is also held along z if there is no axial load (`inputs.held`). Raises
    `RacewayError`, or `ValueError` for a number out of range.
    """
    if models not in LAWS:
        raise ValueError(f"models '{models}' is not one of {', '.join(LAWS)}")
    body = bearing
    if isinstance(bearing, str):
        path = catalogue.find("bearings", bearing, folder)
        body = inputs.bearing(path, four_point=four_point, double_row=double_row)
        free = STRAIGHT if options.get("moment") is None else {}
        held = inputs.held(path, axial, options.get("clearance", 0.0), double_row)
        options["held"] = held | dict(options.get("held", free))
        options = {"ball_density": inputs.ball_density(path)} | options
    oil = fluid = None
    if lubricant is not None:
        path = catalogue.find("lubricants", lubricant, folder)
        oil, fluid = inputs.oil(path, temperature), inputs.fluid(path, temperature)
        lacks = [name for name, value in fluid._asdict().items() if math.isnan(value)]
        if models == "full" and lacks:
            raise inputs.InputError(
                f"{path} has no {', '.join(lacks)}, which models full need, unlike models paper"
            )
    loads, speeds = (np.atleast_1d(np.asarray(one, float)) for one in (load, rpm))
    if not (np.all(np.isfinite(loads)) and np.all(np.isfinite(speeds)) and np.all(speeds >= 0)):
        raise ValueError(f"load {load} N must be finite, and rpm {rpm} must be 0 or more")
    result = []
    for newtons in loads.tolist():
        for speed in speeds.tolist():
            spin = speed * math.pi / 30
            over = turning_ring(
                body,
                newtons,
                axial,
                speed=spin,
                oil=oil,
                fluid=fluid,
                models=models,
                frequency=spin if frequency is None else frequency,
                phases=phases,
                **options,
            )
            result.append(Point(speed, newtons, axial, OverPass(*map(_cleaned, over))))
    return result


def at_rest(carried: Carried, rpm: ArrayLike, **options: Any) -> list[Point]:
    """Return the `points` of a bearing for each `rpm`, under the loads and at the tilts that it has
    when the shaft is at rest (`shaft.rest`). The matrices are therefore expressed in the axes of
    the shaft, whatever the direction of the load. `options` such as lubricant and temperature are
    passed to `points`."""
    x, y, z = carried.load[:3].tolist()
    tilts = dict(zip(FREEDOMS[3:], carried.place[3:].tolist()))
    seat = carried.seat
    place = dict(load_azimuth=math.atan2(y, x), held=tilts, clearance=seat.clearance)
    place["ball_density"] = seat.ball_density
    return points(seat.bearing, math.hypot(x, y), rpm, axial=z, **place, **options)


def ross(
    bearing: str, load: float, rpm: ArrayLike, *, tilts: str = "held", **options: Any
) -> dict[str, float | list[float]]:
    """Return the keyword arguments of ROSS's `BearingElement` except the node: kxx, kyy, kxy, kyx,
    kzz, the corresponding cxx to czz and, if there are several `rpm`, `frequency` in rad/s. All
    values are Python floats or lists of floats.

    `load` is the radial load in N along x; `options` are passed to `points`. If `tilts` is "held",
    the arguments are entries of the 5 x 5 matrices, and `add_rest` adds the remaining entries. If
    it is "free", they are the stiffness and damping of the ring if only the bearing restrains its
    tilts, and `add_rest` is not needed. Warns if ROSS's smoothing of a table with more than four
    speeds changes an entry by more than 1 %.

    >>> one = ross("6208", 3000.0, 0.0, clearance=10e-6, phases=1)
    >>> [f"{one[name]:.4g}" for name in ("kxx", "kyy", "kzz")]
    ['1.805e+08', '8.339e+07', '6.556e+06']
    """
    return ross_of(points(bearing, load, rpm, **options), tilts)


def ross_of(points: Sequence[Point], tilts: str = "held") -> dict[str, float | list[float]]:
    """Return the same arguments as `ross`, from `points` at one load in order of increasing speed.
    Raises `ValueError` if the points have different loads or are not in this order."""
    speeds = [one.rpm for one in points]
    if len({(one.load, one.axial) for one in points}) != 1 or np.any(np.diff(speeds) <= 0):
        raise ValueError("ROSS needs points at one load, in order of increasing speed")
    result: dict[str, Any] = {}
    frequency = [speed * math.pi / 30 for speed in speeds]
    pairs = [translations(one, tilts) for one in points]
    for letter, row in (("k", 0), ("c", 1)):
        for entry in TAKEN:
            at = tuple("xyz".index(axis) for axis in entry)
            result[letter + entry] = [float(pair[row][at]) for pair in pairs]
    if len(points) == 1:
        return {name: values[0] for name, values in result.items()}
    _warn_of_smoothing(frequency, result)
    return {**result, "frequency": frequency}


def translations(point: Point, tilts: str = "held") -> tuple[Floats, Floats]:
    """Return the matrices K in N/m and C in N s/m, both (3, 3), for the translations of the ring,
    with `tilts` as in `ross`. Raises `ValueError` for an unknown value of `tilts`, or if the tilts
    are free and no stiffness restrains them."""
    if tilts not in TILTS:
        raise ValueError(f"tilts '{tilts}' is not one of {', '.join(TILTS)}")
    mean = point.over.mean
    if tilts == "held":
        return mean.stiffness[:3, :3], mean.damping[:3, :3]
    whole = mean.stiffness + 1j * SLOW * mean.damping
    if np.linalg.eigvalsh(mean.stiffness[3:, 3:])[0] <= 0:
        raise ValueError("the tilts are free, but no stiffness restrains them")
    seen = whole[:3, :3] - whole[:3, 3:] @ np.linalg.solve(whole[3:, 3:], whole[3:, :3])
    return seen.real, seen.imag / SLOW


def rest(point: Point) -> tuple[Floats, Floats]:
    """Return (K, C), both (6, 6), for a node in ROSS, with the entries for which `BearingElement`
    has no arguments."""
    result = []
    for matrix in point.over.mean:
        whole = np.zeros((ROSS_FREEDOMS, ROSS_FREEDOMS))
        whole[:5, :5] = matrix
        for entry in TAKEN:
            whole[tuple("xyz".index(axis) for axis in entry)] = 0.0
        result.append(whole)
    return result[0], result[1]


def add_rest(rotor: Any, node: int, point: Point) -> None:
    """Add the matrices of `rest` to K0 and C0 of a ROSS `rotor`. This must be done before the first
    analysis, because the rotor caches its results. In ROSS these entries do not change with speed,
    so choose a `point` in the middle of the speed range.

    Raises `RacewayError` if the nodes of the rotor do not have six degrees of freedom (ROSS before
    2.0).
    """
    if rotor.number_dof != ROSS_FREEDOMS:
        raise RacewayError(
            f"this rotor has {rotor.number_dof} degrees of freedom per node, but needs"
            f" {ROSS_FREEDOMS}: use ROSS 2.0 or later"
        )
    at = slice(ROSS_FREEDOMS * node, ROSS_FREEDOMS * (node + 1))
    stiffness, damping = rest(point)
    rotor.K0[at, at] += stiffness
    rotor.C0[at, at] += damping


def element(node: int, *arguments: Any, tag: str | None = None, **options: Any) -> Any:
    """Create ROSS's `BearingElement` at `node` from `ross`(*arguments, **options). Raises
    `RacewayError` if ROSS is not installed."""
    try:
        from ross import BearingElement
    except ImportError as error:
        raise RacewayError(
            f"cannot load ROSS ({error}): pip install ross-rotordynamics 'plotly<7', or"
            " use the keyword arguments of raceway.export.ross"
        ) from None
    return BearingElement(int(node), tag=tag, **ross(*arguments, **options))


def columns() -> list[str]:
    """Return the column headings of `write_csv`, with units."""
    names = ["speed [rpm]", "radial load [N]", "axial load [N]"]
    for letter, second in (("k", ""), ("c", " s")):
        for a in range(5):
            names += [
                f"{letter}{FREEDOMS[a]}{FREEDOMS[b]} [{_unit(a, b, second)}]" for b in range(5)
            ]
    for word in ("least", "most"):
        names += [f"{word} k{one}{one} [{_unit(a, a)}]" for a, one in enumerate(FREEDOMS)]
    return names


def write_csv(points: Sequence[Point], path: FilePath) -> Path:
    """Write a CSV file with one row per point, in SI units. A row contains the means of K and C
    over the ball pass, matrix row by matrix row in the order x, y, z, rx, ry, and the smallest and
    largest values of the diagonal of K."""
    lines = [",".join(columns())]
    for one in points:
        mean, least, most = one.over
        numbers = [one.rpm, one.load, one.axial, *mean.stiffness.ravel(), *mean.damping.ravel()]
        numbers += [*np.diag(least.stiffness), *np.diag(most.stiffness)]
        lines.append(",".join(f"{number:.9g}" for number in numbers))
    return files.text(path, "\n".join(lines) + "\n")


def write_json(points: Sequence[Point], path: FilePath) -> Path:
    """Write `points` as one JSON object, with each matrix as a list of rows, and with the smallest
    and largest values of all entries."""
    return files.text(path, json.dumps(as_mapping(points), indent=1, allow_nan=False) + "\n")


def as_mapping(points: Sequence[Point]) -> dict[str, Any]:
    """Return the content of the file written by `write_json`, in SI units."""
    rows = []
    for one in points:
        row: dict[str, Any] = dict(rpm=one.rpm, load_N=one.load, axial_N=one.axial)
        for word, part in zip(("", "_least", "_most"), one.over):
            row[f"stiffness{word}"], row[f"damping{word}"] = (m.tolist() for m in part)
        rows.append(row)
    return dict(order=list(FREEDOMS), points=rows)


def write_ross(
    points: Sequence[Point], path: FilePath, node: int, tag: str = "bearing", tilts: str = "held"
) -> Path:
    """Write a TOML file that `ross.BearingElement.load` reads."""
    lines = [f"[BearingElement_{tag}]", f"n = {int(node)}", f'tag = "{tag}"']
    for name, value in ross_of(points, tilts).items():
        numbers = value if isinstance(value, list) else [value]
        text = ", ".join(repr(float(number)) for number in numbers)
        lines.append(f"{name} = [{text}]" if isinstance(value, list) else f"{name} = {text}")
    return files.text(path, "\n".join(lines) + "\n")


def _unit(a: int, b: int, second: str = "") -> str:
    """Return the unit of the matrix entry in row `a` and column `b`, i.e. of a force or moment per
    displacement or tilt."""
    power = PER_METRE[a] + PER_METRE[b]
    return {2: f"N{second}/m", 1: f"N{second}/rad", 0: f"N m{second}/rad"}[power]


def _cleaned(one):
    """Return the matrices with rounding errors removed from entries that are 0 by symmetry."""
    result = []
    for matrix in one:
        scale = np.sqrt(np.abs(np.diag(matrix)))
        keep = np.abs(matrix) > NOISE * np.outer(scale, scale)
        result.append(np.where(keep, matrix, 0.0))
    return type(one)(*result)


def _warn_of_smoothing(frequency, table):
    if len(frequency) <= 4:
        return
    from scipy.interpolate import UnivariateSpline

    changed = []
    for name, values in table.items():
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            seen = UnivariateSpline(frequency, values)(frequency)
        off, largest = np.abs(seen - values).max(), np.abs(values).max()
        if off > 0.01 * largest:
            changed.append(f"{name} by {off:.3g} of {largest:.3g}")
    if changed:
        warnings.warn(
            "ROSS smooths a table of more than four speeds, and changes"
            f" {', '.join(changed)}; give four speeds or fewer",
            RunWarning,
            stacklevel=3,
        )
