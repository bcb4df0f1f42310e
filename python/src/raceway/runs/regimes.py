# SPDX-License-Identifier: GPL-2.0-or-later
"""Film regimes around the ring: fractions of the contacts in boundary, mixed and full-film
lubrication."""

import xarray as xr

from raceway.errors import RunError
from raceway.runs.around import BINS, around
from raceway.runs.run import Run
from raceway.theory import film

REGIMES = ("boundary", "mixed", "full")


def shares(run: Run, bins: int = BINS, boundary: float = 1.0, full: float = 3.0) -> xr.Dataset:
    """Return the fractions of the contacts in each film regime for each sector of the ring.

    The result is a Dataset (raceway, from_load_line) with `share` (regime, raceway,
    from_load_line), the fraction of the contacts in a sector that are in a regime (the fractions
    add up to 1), the mean lambda ratio `lambda`, and `contacts`, the number of contacts. `run` is
    from `raceway.open`; the limits `boundary` and `full` are lambda ratios (eq 7). Raise `RunError`
    for a run without film.
    """
    need_film(run, "lambda")
    quantities = {
        name: lambda table, k=k: film.regime(table["lambda"].to_numpy(), boundary, full) == k
        for k, name in enumerate(REGIMES)
    }
    result = around(run, quantities | {"lambda": lambda table: table["lambda"]}, bins)
    share = xr.concat([result[name] for name in REGIMES], xr.Variable("regime", list(REGIMES)))
    result = result.drop_vars(REGIMES).assign(share=share)
    result["share"].attrs.update(units="1", long_name="fraction of the contacts in a regime")
    return result


def totals(run: Run, boundary: float = 1.0, full: float = 3.0) -> xr.DataArray:
    """Return the `shares` for the whole ring as a DataArray (regime, raceway)."""
    return shares(run, 1, boundary, full)["share"].isel(from_load_line=0, drop=True)


def need_film(run: Run, column: str) -> None:
    """Raise `RunError` if the contacts of `run` lack the film quantity `column`."""
    if not run.tables.lubricated or column not in run.tables.record.contact_columns:
        raise RunError(
            f"{run.tables.folder}: a run without lubricant or without the column {column} has no"
            " film"
        )
