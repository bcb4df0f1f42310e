# SPDX-License-Identifier: GPL-2.0-or-later
"""Report page for a sweep: its points, failures, and a chart of any result against any other."""

from pathlib import Path

import pandas as pd

from raceway.report.page import Page
from raceway.sweeps.gather import gather
from raceway.sweeps.point_run import FAILED, FINISHED

LONGEST = 500  # maximum number of rows in the table; the chart shows all points


def page(folder: Path) -> Page:
    """Return the page for the sweep in `folder`; raise `RacewayError` if it has no points."""
    table = gather(folder)
    finished = table[table["status"] == FINISHED]
    result = Page(f"Sweep {Path(folder).name}: {len(table)} points, {len(finished)} finished")
    for _, row in table[table["status"] == FAILED].iterrows():
        result.text(f"{row['point']}: {row['message']}", "warning")
    numbers = _numbers(finished)
    if len(numbers.columns) > 1:
        varied = [name for name in table.attrs["variables"] if name in numbers]
        figures = [name for name in numbers if name not in varied]
        result.heading("Figures")
        result.text("Select the axes. Drag a frame to zoom, double-click to reset.")
        result.chart(
            "One result against another",
            {
                "table": {name: numbers[name].to_list() for name in [*varied, *figures]},
                "names": finished["point"].to_list(),
                "x": (varied or figures)[0],
                "y": "capacitance_F" if "capacitance_F" in figures else figures[0],
            },
        )
    result.heading("Points")
    head = [name for name in table if name != "point" and table[name].notna().any()]
    rows = [[_cell(row[name]) for name in head] for _, row in table[:LONGEST].iterrows()]
    result.table(rows, ["number"] * len(head), head)
    if len(table) > LONGEST:
        result.text(f"The first {LONGEST} of {len(table)} points; results.csv contains all points.")
    result.heading("Command that repeats the sweep")
    tables = _tables(table[table.attrs["variables"]])
    result.text("For this table:" if len(tables) == 1 else "For each of these tables:")
    for names, rows in tables.items():
        result.code("\n".join([",".join(names), *rows]))
    result.code("raceway sweep TABLE.csv --out DIR")
    return result


def _numbers(table):
    numbers = table.select_dtypes("number")
    return numbers.loc[:, numbers.nunique() > 1]


def _tables(asked):
    """Return the distinct rows, grouped by the names of the variables that their points set."""
    tables = {}
    for _, row in asked.astype(object).iterrows():
        given = row.dropna()
        tables.setdefault(tuple(given.index), {})[",".join(map(_exact, given))] = None
    return tables


def _exact(value):
    return value if isinstance(value, str) else f"{value:.15g}"


def _cell(value):
    if isinstance(value, float):
        return "" if pd.isna(value) else f"{value:.5g}"
    return str(value)
