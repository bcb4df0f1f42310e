# SPDX-License-Identifier: GPL-2.0-or-later
"""Film regimes around the ring: shares of the contacts in boundary, mixed and full-film
lubrication."""

import xarray as xr

from raceway.errors import RunError
from raceway.runs.around import BINS, around
from raceway.runs.run import Run
from raceway.theory import film

REGIMES = ("boundary", "mixed", "full")


def shares(run: Run, bins: int = BINS, boundary: float = 1.0, full: float = 3.0) -> xr.Dataset:
    """Dataset (raceway, from_load_line): `share` (regime, raceway, from_load_line), the share of
    the contacts in each sector of the ring that are in a regime, with the sum 1; the mean lambda
    ratio `lambda`; and `contacts`, the number of contacts.

    `run` is from `raceway.open`; the limits are lambda ratios (eq 7). Raises `RunError` for a run
    without film.
    """
    need_film(run, "lambda")
    quantities = {
        name: lambda table, k=k: film.regime(table["lambda"].to_numpy(), boundary, full) == k
        for k, name in enumerate(REGIMES)
    }
    result = around(run, quantities | {"lambda": lambda table: table["lambda"]}, bins)
    share = xr.concat([result[name] for name in REGIMES], xr.Variable("regime", list(REGIMES)))
    result = result.drop_vars(REGIMES).assign(share=share)
    result["share"].attrs.update(units="1", long_name="share of the contacts in a regime")
    return result


def totals(run: Run, boundary: float = 1.0, full: float = 3.0) -> xr.DataArray:
    """DataArray (regime, raceway): `shares` over the whole ring."""
    return shares(run, 1, boundary, full)["share"].isel(from_load_line=0, drop=True)


def need_film(run: Run, column: str) -> None:
    """Raise `RunError` if the contacts of `run` lack the film's `column`."""
    if not run.tables.lubricated or column not in run.tables.record.contact_columns:
        raise RunError(
            f"{run.tables.folder}: a run without lubricant or without the column {column} has no"
            " film"
        )
