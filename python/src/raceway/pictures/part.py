# SPDX-License-Identifier: GPL-2.0-or-later
"""The part of a run that is plotted, and the tracks of the balls around the ring.

A curve around the ring consists of the tracks of all balls, drawn on top of each other. The width
of the resulting band shows how strongly the value at one ball depends on the positions of the other
balls.
"""

import warnings
from collections.abc import Iterator

import numpy as np

from raceway.arrays import Floats
from raceway.errors import RunError, RunWarning
from raceway.runs.tables import RunTables

LIGHT = 0.01  # fraction of the largest load; the film thickness of lighter contacts is not shown
# size of a record in bytes above which only some ball passes are plotted, and their number
LARGE, PASSES = (200 << 20, 20)


def shown(tables: RunTables, note: str = "") -> RunTables:
    """Return the part of the run `tables` to plot. This is the whole run unless the number of
    curves would be too large for memory or for a legible plot. In that case a warning is issued,
    with `note` at the end of its text."""
    path = tables.record.path
    if tables.stop is not None or path.stat().st_size < LARGE:
        return tables
    warnings.warn(
        f"{path} is large: the picture shows its first {PASSES} ball passes{note}",
        RunWarning,
        stacklevel=3,
    )
    shown_samples = int(PASSES * tables.settings["samples_per_pass"])
    return tables.window(slice(tables.first, tables.first + shown_samples))


def largest_load(tables: RunTables) -> float:
    """Return the largest contact load of the run `tables` in N. Raises `RunError` if no ball
    carries load."""
    largest = tables.contacts["load"].max()
    if not largest > 0:
        raise RunError(f"{tables.record.path}: no ball carries load in any sample")
    return float(largest)


def filmed(tables: RunTables) -> bool:
    """Return True if the contacts of the run `tables` have films."""
    return tables.lubricated and {"h_min", "h_c"} <= set(tables.contacts)


def need(tables: RunTables, column: str, what: str) -> None:
    """Raise `RunError` unless the contacts of the run `tables` have the `column` that `what`
    needs."""
    if (
        column not in tables.contacts
        or not tables.lubricated
        and column in ("h_min", "h_c", "capacitance")
    ):
        raise RunError(
            f"{tables.folder}: {what} needs the column {column} of the contacts, which "
            + ("this run does not have" if tables.lubricated else "a dry run does not have")
        )


def tracks(
    tables: RunTables, raceway: int, column: str, above: float = 0.0
) -> Iterator[tuple[Floats, Floats]]:
    """Yield (psi, values) for the path of each ball past one raceway. psi is in rad and unwrapped,
    and the values are NaN where the ball has lost contact.

    A contact counts as lost if it carries no more than a fraction `above` of the largest load."""
    contacts = tables.contacts
    rows = contacts[
        (contacts["raceway"] == raceway) & (contacts["load"] > above * contacts["load"].max())
    ]
    for _, ball in rows.groupby("ball"):
        psi = np.unwrap(tables.angles(ball))
        gaps = np.flatnonzero(np.diff(ball["sample"].to_numpy()) > 1) + 1
        yield np.insert(psi, gaps, np.nan), np.insert(ball[column].to_numpy(), gaps, np.nan)


def within_turn(psi: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Return the angles `psi` (rad, unwrapped) in degrees from -180 to 180, and the `values`, with
    NaN in between where the angle jumps back by one turn."""
    turn = 2 * np.pi * np.round(psi / (2 * np.pi))
    breaks = np.flatnonzero(np.diff(turn) != 0) + 1
    return np.insert(np.degrees(psi - turn), breaks, np.nan), np.insert(values, breaks, np.nan)
