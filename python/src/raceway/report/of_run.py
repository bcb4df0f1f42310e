# SPDX-License-Identifier: GPL-2.0-or-later
"""Report page for a run: results with their errors, pictures, warnings and settings."""

import shlex
import tempfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from raceway.errors import RacewayError, RunError
from raceway.pictures.overview import overview
from raceway.pictures.part import shown as part
from raceway.report.page import Page
from raceway.rows import cells
from raceway.runs.columns import BEARING, CONTACT, LOSSES
from raceway.runs.measured import title
from raceway.runs.statics import statics
from raceway.runs.summary import ring_displacement, summary
from raceway.runs.summary_table import TOPICS, reasons, shown
from raceway.runs.tables import RunTables
from raceway.sweeps.check import variables
from raceway.units import axis

POINTS = 2000  # largest number of points in a line, which is enough for a screen
AROUND = ("load", "h_min", "sliding")  # columns of the contacts
# {chart: columns of the totals that are plotted against time}
CHARTS = {
    "Largest contact loads": ("load_inner", "load_outer"),
    "Largest Hertz pressures": ("pressure_inner", "pressure_outer"),
    "Thinnest film": ("h_min",),
    "Lambda ratio": ("lambda",),
    "Capacitance of the bearing": ("capacitance",),
    "Balls loaded on both raceways": ("loaded_balls",),
    "Cage speed": ("cage_speed",),
    "Power loss by cause": tuple(LOSSES.values()),
}


def page(tables: RunTables) -> Page:
    """Return the page for the run `tables`; raise `RunError` for a broken or unfinished run."""
    figures = summary(tables)
    figures |= statics(tables, figures)
    result = Page(title(tables))
    result.text(f"A run of {figures['host']}, written by raceway report.")
    _warnings(result, figures)
    _figures(result, figures)
    _pictures(result, tables)
    _settings(result, tables)
    return result


def _warnings(page, figures):
    for text in figures["warnings"]:
        page.text(text, "warning")
    if not figures["warnings"]:
        page.text("All results are within the range of validity of their formulas.")


def _figures(page, figures):
    page.heading("Figures")
    ranges = figures["model_ranges"] or {}
    rows = cells(
        shown(figures),
        TOPICS,
        figures.get("numerical_errors"),
        {key: (one["low"], one["high"]) for key, one in ranges.items()},
        figures["statics"],
    )
    head = ("", "run", "statics", "numerical error", "range of the model", "")
    page.table(rows, ("", *["number"] * 4, "source"), head)
    page.text("Equation and figure numbers are those of Farah, Guessasma and Bellenger (2020).")
    if why := figures["statics_absent"]:
        page.text(f"There are no values from statics: {why}")
    if ranges:
        page.text("Known uncertainty of the model:")
    for text in reasons(figures):
        page.text(text)
    if "numerical_errors" not in figures:
        page.text("Numerical errors are not known; raceway check estimates them.")


def _pictures(page, tables):
    page.heading("Pictures")
    page.text("Drag a frame to zoom, double-click to reset, hover to read values.")
    totals, rings = tables.totals, tables.rings
    step = _step(len(totals))
    if step > 1:
        page.text(f"Lines show every {step}th sample; results are computed from all samples.")
    over_time = _axis(tables, totals.index.to_numpy(float))
    for name, columns in CHARTS.items():
        there = [one for one in columns if one in totals and totals[one].fillna(0.0).any()]
        if there:
            lines = {BEARING[one].meaning: totals[one].to_numpy(float) for one in there}
            _chart(page, name, over_time, BEARING[there[0]].unit, lines)
    shift = {"along the load": ring_displacement(tables)}
    _chart(page, "Radial displacement", _axis(tables, rings["sample"].to_numpy(float)), "m", shift)
    try:
        _around(page, tables)
        page.heading("Overview")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "overview.png"
            overview(tables, path)
            page.picture(path.read_bytes(), "Loads, film, pressure and capacitance of the run")
    except RunError as error:  # for instance, a summary record has no contacts
        page.text(f"No picture of the contacts: {error}")


def _around(page, tables):
    """Add charts of load, film and sliding against the azimuth from the load line for each
    raceway."""
    contacts = part(tables).contacts
    angle = np.degrees(tables.angles(contacts))
    x = {"label": "azimuth from the load line (degrees)", "values": angle}
    for name in AROUND:
        if name in contacts:
            lines = {
                side: np.where(contacts["raceway"] == number, contacts[name], np.nan)
                for number, side in enumerate(("inner raceway", "outer raceway"))
            }
            title = f"Around the ring: {CONTACT[name].meaning}"
            _chart(page, title, x, CONTACT[name].unit, lines, points=True)


def _axis(tables, samples):
    return {"label": "time (ball passes)", "values": tables.passes(samples)}


def _step(samples):
    return max(1, -(-samples // POINTS))


def _chart(page, title, x, unit, lines, points=False):
    """Add a chart of `lines`, {name: values in SI units}, with an SI prefix before the `unit`."""
    step = slice(None, None, _step(len(x["values"])))
    known = [np.abs(values[np.isfinite(values)]).max(initial=0.0) for values in lines.values()]
    factor, label = axis(max(known), unit) if unit else (1.0, "")
    page.chart(
        title,
        {
            "x": {"label": x["label"], "values": x["values"][step]},
            "y": label,
            "lines": [
                {"label": name, "values": factor * values[step], "points": points}
                for name, values in lines.items()
            ],
        },
    )


def _settings(page, tables):
    page.heading("Settings")
    try:
        words = variables(tables)
    except RacewayError as error:
        page.text(str(error))
    else:
        page.text("To repeat the run, in the folder of the repository:")
        page.code(repeat(words))
    rows = [
        (name, f"{value:.15g}" if isinstance(value, float) else str(value))
        for name, value in tables.settings.items()
    ]
    page.table([row for row in rows if row[0] != "deck_variables"], ("", ""))


def repeat(words: Mapping[str, str]) -> str:
    """Return the command that runs the main deck with the variables `words`."""
    own = " ".join(f"-var {name} {shlex.quote(str(value))}" for name, value in words.items())
    return f"build/liggghts -in inputs/in.6208 {own}"
