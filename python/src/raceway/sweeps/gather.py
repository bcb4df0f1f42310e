# SPDX-License-Identifier: GPL-2.0-or-later
"""Collect the points in the folder of a sweep in one tidy table."""

import csv
import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from raceway import files, yaml_file
from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.sweeps.point_run import FAILED, mapping, outcome
from raceway.sweeps.points import SHARE, Point

if TYPE_CHECKING:
    import pandas as pd

KEYS = ("point", "status", "message")
SHARES = "shares.json"  # {point: fraction of the time}, from the latest table that has shares


def write_shares(folder: FilePath, points: Iterable[Point]) -> None:
    """Write the time shares of `points`, if they have any, to the `folder` of the sweep."""
    if shares := {point.name: point.share for point in points if point.share}:
        files.text(Path(folder) / SHARES, json.dumps(shares, indent=2))


def gather(folder: FilePath) -> "pd.DataFrame":
    """Return a table with one row for each point of the sweep in `folder`.

    The columns are `point`, `status` (finished, failed, pending), `message`, the variables that
    were set, every key of `raceway.summary.summary` (in SI units), and the time `share` if the
    table of the sweep has it. Losses have names such as `loss_rolling_W`; if there are several
    bearings, keys have prefixes such as `bearing_1_`. Rows are sorted by the variables, whose names
    are in `attrs["variables"]`. Raise `RacewayError` if there are no points.
    """
    import pandas as pd  # loading it takes longer than writing the table

    variables, columns, rows = _rows(folder)
    table = pd.DataFrame(rows, columns=columns)
    table.attrs["variables"] = variables
    return table


def _rows(folder):
    """Return the names of the variables and of the columns, and the rows as dicts."""
    rows, names = [], {}
    shares = mapping(Path(folder) / SHARES, json.loads)
    for path in sorted(Path(folder).glob("*/point.yaml")):
        asked = mapping(path, yaml_file.parse)
        if asked is None:
            broken = f"{path} is broken: remove the folder and run the sweep again"
            rows.append({"point": path.parent.name, "status": FAILED, "message": broken})
            continue
        names.update(asked)
        status, message, figures = outcome(path.parent)
        several = figures.pop("bearings", ())
        figures = _flat(figures)
        for number, one in enumerate(several, 1):
            figures.update({f"bearing_{number}_{key}": v for key, v in _flat(one).items()})
        share = {SHARE: shares.get(path.parent.name, "")} if shares else {}
        place = {"point": path.parent.name, "status": status, "message": message}
        rows.append({**place, **asked, **share, **figures})
    if not rows:
        raise RacewayError(f"{folder} contains no points of a sweep (no */point.yaml)")
    variables = list(names)
    for name in variables:
        _make_numbers(rows, name)
    rows.sort(key=lambda row: [_order(row.get(name)) for name in variables])
    columns = dict.fromkeys([*KEYS, *variables, *(name for row in rows for name in row)])
    return variables, list(columns), rows


def _make_numbers(rows, name):
    """Convert a variable to numbers if all its values are, so that 5e3 comes after 600."""
    given = [row for row in rows if name in row]
    try:
        numbers = [yaml_file.number(row[name]) for row in given]
    except ValueError:
        return
    whole = all(str(row[name]).removeprefix("-").isdecimal() for row in given)
    for row, number in zip(given, numbers):
        row[name] = int(number) if whole else number


def _order(value):
    """Return the sort key of the value of a variable: numbers, then texts, then missing values."""
    return value is None, isinstance(value, str), value


def _flat(figures):
    """Return the cells of the table row for `figures`."""
    losses = figures.pop("losses_W", None) or {}
    for nested in ("model_ranges", "absent", "assumed_data"):
        figures.pop(nested, None)
    return figures | {f"loss_{part}_W": loss for part, loss in losses.items()}


def write_results(folder: FilePath) -> tuple[Path, dict[str, int]]:
    """Write the table of `gather` to `results.csv` in the folder. Return the path and the number of
    points of each status."""
    _, columns, rows = _rows(folder)

    def write(part):
        with open(part, "w", newline="", encoding="utf-8") as file:
            table = csv.DictWriter(file, columns, lineterminator="\n")
            table.writeheader()
            table.writerows(rows)

    path = files.whole(Path(folder) / "results.csv", write)
    return path, Counter(row["status"] for row in rows)
