# SPDX-License-Identifier: GPL-2.0-or-later
"""The tables of the paper. Each is a function that takes a `Book` and returns a DataFrame."""

import pandas as pd

from raceway.paper import cases, sensitivity
from raceway.paper.book import OILS, Book
from raceway.paper.figures.free import measured
from raceway.paper.figures.loads import stribeck

EPSILON = {-0.0035: 1.32, -0.002: 0.75, 0: 0.5, 0.002: 0.39, 0.0035: 0.32}  # table 3 of the paper
GROOVES = {0.08: 6.804e-3, 0.10: 6.93e-3, 0.12: 7.056e-3, 0.14: 7.182e-3}  # table A.1, m


def oils(book: Book) -> pd.DataFrame:
    """Table 2, which is lost: the oils used instead, and their plausible ranges."""
    rows = []
    for name, oil in book.oils.items():
        low, high = zip(*sensitivity.ranges(book)[name].values())
        rows += [
            (OILS[name], "as used", *oil),
            (OILS[name], "low end of the plausible range", *low),
            (OILS[name], "high end", *high),
        ]
    return pd.DataFrame(rows, columns=["oil", "values", *sensitivity.COLUMN.values()])


def load_parameters(book: Book) -> pd.DataFrame:
    """Table 3: clearance and load parameter from paper, simulation, theory, printed formulas."""
    rows = []
    for run, printed in zip(
        book.readings.all("clearances"), book.readings.all("clearances_printed")
    ):
        ratio = run.given["clearance_ratio"]
        gap = ratio * book.bearing.ball_diameter
        rows.append(
            (
                gap,
                ratio,
                EPSILON[ratio],
                run.figures["load_parameter"],
                stribeck(book.bearing, 5000.0, gap, 0.0)[1],
                printed.figures["load_parameter"],
            )
        )
    return pd.DataFrame(
        rows,
        columns=[
            "clearance_m",
            "P_d/D",
            "paper",
            "simulation",
            "stribeck_harris",
            "simulation_printed",
        ],
    )


def grooves(book: Book) -> pd.DataFrame:
    """Table A.1: grooves for each total curvature, with free contact angle and endplay."""
    free, diameter = measured(book), book.bearing.ball_diameter
    free = free[(free["clearance_m"] / diameter - 0.0035).abs() < 1e-9].copy()
    radius = [cases.groove(book.bearing, curvature) for curvature in free["total_curvature"]]
    free.insert(1, "groove_m", radius)
    free.insert(2, "groove_paper_m", [GROOVES[curvature] for curvature in free["total_curvature"]])
    free.insert(3, "conformity", [one / diameter for one in radius])
    return free


TABLES = {
    "table-2": oils,
    "table-3": load_parameters,
    "table-A.1": grooves,
    "sensitivity": sensitivity.table,
}
