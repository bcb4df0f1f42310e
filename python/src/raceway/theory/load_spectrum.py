# SPDX-License-Identifier: GPL-2.0-or-later
"""Life and equivalent load under a load spectrum, i.e. a list of points with time shares.

Damage accumulates with revolutions (Palmgren-Miner, as in ISO 281 and ISO/TS 16281): 1/L is the sum
of u_i/L_i, where u_i is the fraction of the revolutions made at point i. The equivalent load is the
steady load that gives the same life, (sum q_i n_i P_i^p/sum q_i n_i)^(1/p), with time shares q_i,
speeds n_i and p = 3 for ball bearings (makers' catalogues: NSK, average of fluctuating load; SEED
guide, 4.4).
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from raceway import files
from raceway.errors import InputError, RacewayError
from raceway.files import FilePath
from raceway.rows import aligned
from raceway.theory import life
from raceway.units import prefixed

# {column: (smallest, largest, unit, default)} for the columns of a sweep's table and the time share
COLUMNS = {
    "load": (0.0, 1e6, "N", 0.0),
    "axial": (-1e6, 1e6, "N", 0.0),
    "rpm": (1e-3, 1e5, "rpm", None),
    "share": (1e-12, 1e12, "", 1.0),
}
LIFE = "life_reference_Mrev"
KEYS = ("equivalent_load_N", LIFE, "dynamic_rating_N")
# {column of a sweep's table: result of the run that is used if the table lacks the column}
OF_RUN = {"load": "load_N", "rpm": "rpm"}


class Duty(NamedTuple):
    """One point of a load spectrum."""

    load: float  # N, radial load
    axial: float  # N, axial load
    rpm: float
    share: float  # share of the time, in any unit


def read(path: FilePath) -> tuple[list[Duty], list[dict[str, float]]]:
    """Read the points in the CSV file `path`, and return them with a list of dicts. If the file is
    the `results.csv` of a sweep, the list contains the equivalent load and the rating of each
    point, keyed by `KEYS`; otherwise it is empty.

    The first line contains names from `COLUMNS`, including rpm, and each point has a row. The table
    of a sweep has additional columns. Raises `InputError` with the offending point and value, and
    also if a point of a sweep is unfinished or has no equivalent load."""
    rows = [row for _, row in files.csv_rows(path, InputError)]
    head = [name.strip() for name in rows[0]] if rows else []
    swept = {"point", "status"} <= set(head)
    if not swept and (unknown := [name for name in head if name not in COLUMNS]):
        raise InputError(f"{path}: there is no column {unknown[0]}; columns: {', '.join(COLUMNS)}")
    if "rpm" not in head or len(set(head)) < len(head) or len(rows) < 2:
        raise InputError(f"{path}: give each column once, including rpm, and one row per point")
    for number, row in enumerate(rows[1:], 1):
        if len(row) != len(head):
            raise InputError(f"{path}: point {number} has {len(row)} cells, not {len(head)}")
    points = [dict(zip(head, row)) for row in rows[1:]]
    found = [_run(path, number, one) for number, one in enumerate(points, 1)] if swept else []
    return [_duty(path, number, one) for number, one in enumerate(points, 1)], found


def _run(path, number, point):
    """Return the results of one point of a sweep; the rating may be missing."""
    where = f"{path}: point {number} ({point['point']})"
    if point["status"] != "finished":
        why = f": {point['message']}" if point.get("message") else ""
        raise InputError(
            f"{where} has the status {point['status']}{why}. `raceway sweep --retry` runs it;"
            " if its folder is removed, `raceway gather` omits it"
        )
    if not point.get(KEYS[0]):
        raise InputError(
            f"{where} has no {KEYS[0]}, which needs a record with contacts, an inner ring that"
            " turns and a steady load; a table of load, axial, rpm and share needs no runs"
        )
    return {key: float(point[key]) for key in KEYS if point.get(key)}


def _duty(path, number, point):
    found = {}
    for name, (low, high, unit, default) in COLUMNS.items():
        text = point.get(name) or point.get(OF_RUN.get(name, name))
        if text is None:
            found[name] = default
            continue
        try:
            found[name] = float(text)
        except ValueError:
            found[name] = float("nan")
        if not low <= found[name] <= high:
            span = f"from {low:g} to {high:g} {unit}".rstrip()
            raise InputError(f"{path}: point {number}: {name} is {text.strip()!r}, must be {span}")
    return Duty(**found)


def of_sweep(
    duties: Sequence[Duty], runs: Sequence[Mapping[str, float]], dynamic: float | None = None
) -> dict[str, Any]:
    """Return the same results as `of_points` for the points of a sweep, but from the results of
    their `runs`, which are computed from the ball loads. `dynamic` is C in N of all rows; by
    default it is taken from the runs. Raises `InputError` if there is no rating or more than
    one."""
    known = {one["dynamic_rating_N"] for one in runs if "dynamic_rating_N" in one}
    rated = known if dynamic is None else {dynamic}
    if len(rated) != 1:
        said = " and ".join(f"{one:g} N" for one in sorted(rated)) or "none"
        raise InputError(f"the points need one dynamic load rating but have {said}: give --C")
    (rating,) = rated
    loads = iter(runs)

    def figures(_):
        load = next(loads)["equivalent_load_N"]
        return {KEYS[0]: load, LIFE: float(life.basic(rating, load)), KEYS[2]: rating}

    return of_points(duties, figures)


def of_points(
    duties: Sequence[Duty], figures: Callable[[Duty], Mapping[str, Any]]
) -> dict[str, Any]:
    """Return a dict of results for the spectrum `duties` in SI units; `points` contains the results
    for each point.

    `figures` returns the results at a point (`operating_point.figures`). Raises `InputError` if
    they do not include a life because the bearing has no rating, and with the number of a point
    that has no results.
    """
    points: list[dict[str, Any]] = []
    for number, duty in enumerate(duties, 1):
        try:
            found = figures(duty)
        except RacewayError as error:
            raise InputError(f"point {number} of the spectrum: {error}") from None
        if LIFE not in found:
            raise InputError("the bearing's file states no load ratings: give --C")
        names = {"load_N": duty.load, "axial_N": duty.axial, "rpm": duty.rpm, "share": duty.share}
        points.append(names | {key: found[key] for key in KEYS})
    times = np.array([duty.share for duty in duties])
    turns = times * [duty.rpm for duty in duties]
    rpm = float(turns.sum() / times.sum())
    shares = turns / turns.sum()
    total = life.of_duties([one[LIFE] for one in points], shares)
    return dict(
        equivalent_load_N=points[0]["dynamic_rating_N"] / total ** (1 / 3),
        life_reference_Mrev=total,
        life_reference_h=total * 1e6 / (60 * rpm),
        rpm_mean=rpm,
        points=[
            dict(
                one,
                revolutions_share=share,
                damage_share=share * total / one["life_reference_Mrev"],
            )
            for one, share in zip(points, shares.tolist())
        ],
    )


def table(found: Mapping[str, Any]) -> str:
    """Format the result of `of_points` as text."""
    rows = [["load", "axial", "rpm", "time", "turns", "damage", "P", "L_10r, 10^6"]]
    whole = sum(one["share"] for one in found["points"])
    for one in found["points"]:
        parts = (one["share"] / whole, one["revolutions_share"], one["damage_share"])
        rows.append(
            [
                *(prefixed(one[key], "N") for key in ("load_N", "axial_N")),
                f"{one['rpm']:g}",
                *(f"{100 * part:.3g} %" for part in parts),
                prefixed(one["equivalent_load_N"], "N"),
                f"{one[LIFE]:.4g}",
            ]
        )
    return "\n".join(
        [
            "Points",
            *aligned(rows),
            "",
            "Spectrum",
            f"  {'equivalent load':<32}{prefixed(found['equivalent_load_N'], 'N'):>14}"
            "  (ISO/TS 16281)",
            f"  {'mean speed':<32}{found['rpm_mean']:>10.4g} rpm",
            f"  {'reference life, 10^6 turns':<32}{found['life_reference_Mrev']:>14.4g}",
            f"  {'reference life, hours':<32}{found['life_reference_h']:>14.4g}",
        ]
    )
