# SPDX-License-Identifier: GPL-2.0-or-later
"""Collect the points in the folder of a sweep in one tidy table."""

import json
from collections.abc import Iterable
from pathlib import Path

import pandas as pd

from raceway import files, yaml_file
from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.sweeps.point_run import FAILED, FINISHED, mapping, state
from raceway.sweeps.points import SHARE, Point

KEYS = ("point", "status", "message")
SHARES = "shares.json"  # {point: fraction of the time}, from the latest table that has shares


def write_shares(folder: FilePath, points: Iterable[Point]) -> None:
    """Write the time shares of `points`, if they have any, to the `folder` of the sweep."""
    if shares := {point.name: point.share for point in points if point.share}:
        files.text(Path(folder) / SHARES, json.dumps(shares, indent=2))


def gather(folder: FilePath) -> pd.DataFrame:
    """Return a table with one row for each point of the sweep in `folder`.

    The columns are `point`, `status` (finished, failed, pending), `message`, the variables that
    were set, every key of `raceway.summary.summary` (in SI units), and the time `share` if the
    table of the sweep has it. Losses have names such as `loss_rolling_W`; if there are several
    bearings, keys have prefixes such as `bearing_1_`. Rows are sorted by the variables, whose names
    are in `attrs["variables"]`. Raise `RacewayError` if there are no points.
    """
    rows, variables = [], {}
    shares = mapping(Path(folder) / SHARES, json.loads)
    for path in sorted(Path(folder).glob("*/point.yaml")):
        asked = mapping(path, yaml_file.parse)
        if asked is None:
            broken = f"{path} is broken: remove the folder and run the sweep again"
            rows.append({"point": path.parent.name, "status": FAILED, "message": broken})
            continue
        variables.update(asked)
        status, message = state(path.parent, asked)
        figures = mapping(path.parent / "summary.json", json.loads) if status == FINISHED else {}
        several = figures.pop("bearings", ())
        figures = _flat(figures)
        for number, one in enumerate(several, 1):
            figures.update({f"bearing_{number}_{key}": v for key, v in _flat(one).items()})
        share = {SHARE: shares.get(path.parent.name, "")} if shares else {}
        names = {"point": path.parent.name, "status": status, "message": message}
        rows.append({**names, **asked, **share, **figures})
    if not rows:
        raise RacewayError(f"{folder} contains no points of a sweep (no */point.yaml)")
    table = pd.DataFrame(rows)
    for name in variables:  # convert to numbers where possible, so that 5e3 comes after 600
        try:
            table[name] = pd.to_numeric(table[name])
        except (ValueError, TypeError):
            pass
    rest = [name for name in table if name not in KEYS and name not in variables]
    table = table.sort_values(list(variables), kind="stable", ignore_index=True)
    table = table[[*KEYS, *variables, *rest]]
    table.attrs["variables"] = list(variables)
    return table


def _flat(figures):
    """Return the cells of the table row for `figures`."""
    losses = figures.pop("losses_W", None) or {}
    for nested in ("model_ranges", "absent", "assumed_data"):
        figures.pop(nested, None)
    return figures | {f"loss_{part}_W": loss for part, loss in losses.items()}


def write_results(folder: FilePath) -> tuple[Path, pd.DataFrame]:
    """Write `gather(folder)` to `results.csv` in the folder, and return the path and the table."""
    table = gather(folder)
    path = files.whole(Path(folder) / "results.csv", lambda part: table.to_csv(part, index=False))
    return path, table
