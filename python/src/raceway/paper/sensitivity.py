# SPDX-License-Identifier: GPL-2.0-or-later
"""Sensitivity of the results to the data that are missing from the text of the paper: the oils
(table 2) and the roughness, each within its plausible range.

The changes are computed from theory for 5 kN, 0.41 m/s and no clearance; two runs with other oils
show that the simulation changes in the same way.
"""

import itertools
from collections.abc import Callable

import numpy as np
import pandas as pd

from raceway import yaml_file
from raceway.inputs import InputError, Oil
from raceway.paper import passage, theory
from raceway.paper.book import OILS, Book
from raceway.runs.settings import LUBRICANT
from raceway.theory.bearing import INNER

LOAD, SPEED = 5000.0, 0.41
# {property of `Oil`: column of the table}
COLUMN = dict(zip(Oil._fields, LUBRICANT))
FILE = "inputs/paper/ranges.yaml"


def ranges(book: Book) -> dict[str, dict[str, tuple[float, float]]]:
    """Return {oil: {property: (low, high)}} from `FILE`; raise `InputError` if it is invalid."""
    path = book.root / FILE
    try:
        data = yaml_file.read(path)
        return {
            oil: {name: tuple(float(end) for end in data[oil][name]) for name in COLUMN}
            for oil in OILS
        }
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(
            f"{path}: {error!r}; low and high of every property were expected"
        ) from None


def outcome(book: Book, oil: Oil) -> dict[str, float]:
    """Return {name: result in SI units} for one `Oil`."""
    bearing = book.bearing
    inner = theory.contact(bearing, oil, INNER, theory.largest_load(bearing, LOAD), SPEED)
    return {
        "inner_film_m": float(inner.h_min),
        "film_parameter": float(inner.h_min / oil.roughness),
        "ball_capacitance_F": float(
            theory.ball(bearing, oil, theory.largest_load(bearing, LOAD), SPEED)
        ),
        "bearing_capacitance_F": theory.bearing_capacitance(bearing, oil, LOAD, SPEED),
        "speed_at_lambda_1_m_s": passage.speed(bearing, oil, LOAD, oil.roughness),
        "capacitance_at_lambda_1_F": passage.capacitance(bearing, oil, LOAD, oil.roughness),
    }


def table(book: Book) -> pd.DataFrame:
    """Sensitivity to the missing data: oils and roughness.

    DataFrame: oil, property, value, by (theory or simulation), and the columns of `outcome`.
    """
    rows = []
    for name, oil in book.oils.items():
        rows.append(
            {"oil": name, "property": "as used", "value": np.nan, "by": "theory"}
            | outcome(book, oil)
        )
        for what, ends in ranges(book)[name].items():
            rows += [
                {"oil": name, "property": COLUMN[what], "value": end, "by": "theory"}
                | outcome(book, oil._replace(**{what: end}))
                for end in ends
            ]
    for run in book.readings.all("sensitivity"):
        figures = run.figures
        rows.append(
            {
                "oil": run.given["lubricant"],
                "property": COLUMN["pressure_viscosity"],
                "value": run.given["pressure_viscosity"],
                "by": "simulation",
                "inner_film_m": run.top(INNER, "h_min"),
                "film_parameter": run.top(INNER, "lambda"),
                "ball_capacitance_F": run.top_capacitance(),
                "bearing_capacitance_F": figures["capacitance_F"],
            }
        )
    return pd.DataFrame(rows)


def power(book: Book, what: str, ball: Callable[[Oil], float] | None = None) -> float:
    """Return the sensitivity of a ball's capacitance to the property `what` of the mineral oil.

    The sensitivity is d log C/d log property. `ball` returns the capacitance of the ball in F for
    an oil; by default, this is the capacitance of its plates.
    """
    oil, step, of = book.oils["mineral"], 1.01, ball or _plates(book)
    more, less = (
        of(oil._replace(**{what: getattr(oil, what) * factor})) for factor in (step, 1 / step)
    )
    return float(np.log(more / less) / (2 * np.log(step)))


def oils_ratio(
    book: Book, first: str, second: str, ball: Callable[[Oil], float] | None = None
) -> tuple[float, float]:
    """Return the (smallest, largest) ratio of the capacitances of a ball on the load line with the
    two oils.

    All corners of the ranges of the oils are considered; `ball` has the same meaning as in `power`.
    """
    ends, of = ranges(book), ball or _plates(book)

    def corners(name):
        kept = [ends[name][what] for what in ("viscosity", "pressure_viscosity", "permittivity")]
        return np.array([of(Oil(*corner, 1e-7)) for corner in itertools.product(*kept)])

    over, under = corners(first), corners(second)
    return float(over.min() / under.max()), float(over.max() / under.min())


def _plates(book):
    q = theory.largest_load(book.bearing, LOAD)
    return lambda oil: theory.ball(book.bearing, oil, q, SPEED)
