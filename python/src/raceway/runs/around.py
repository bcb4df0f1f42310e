# SPDX-License-Identifier: GPL-2.0-or-later
"""Means of contact quantities around the ring, for each raceway and azimuth.

The run is read in blocks, so it may be of any size.
"""

from collections.abc import Callable, Mapping

import numpy as np
import pandas as pd
import xarray as xr
from numpy.typing import ArrayLike

from raceway.runs.run import Run

SIDES = ("inner", "outer")
BINS = 72


def around(
    run: Run, quantities: Mapping[str, Callable[[pd.DataFrame], ArrayLike]], bins: int = BINS
) -> xr.Dataset:
    """Return the means of `quantities` over the contacts of `run` (from `raceway.open`) in each of
    `bins` equal sectors of the ring, as a Dataset (raceway, from_load_line).

    `quantities` maps a name to a function that takes a table of contacts (a `DataFrame` with the
    columns of the record) and returns an array with one value per row. `from_load_line` is the
    middle of a sector in rad, relative to the centre of the load zone. `contacts` is the number of
    contacts summed over all samples; where it is 0, the means are NaN. Raise `ValueError` for fewer
    than one bin.
    """
    if bins < 1:
        raise ValueError(f"bins = {bins} must be at least 1")
    shape = (len(SIDES), bins)
    counts, sums = np.zeros(shape, dtype=int), {name: np.zeros(shape) for name in quantities}
    for table in run.tables.blocks("contacts"):
        psi = run.tables.angles(table)
        part = np.minimum(((psi + np.pi) / (2 * np.pi) * bins).astype(int), bins - 1)
        place = table["raceway"].to_numpy() * bins + part
        counts += np.bincount(place, minlength=counts.size).reshape(shape)
        for name, function in quantities.items():
            weights = np.asarray(function(table), dtype=float)
            sums[name] += np.bincount(place, weights=weights, minlength=counts.size).reshape(shape)
    dims = ("raceway", "from_load_line")
    middle = (np.arange(bins) + 0.5) / bins * 2 * np.pi - np.pi
    result = xr.Dataset(
        {"contacts": (dims, counts)}, coords={"raceway": list(SIDES), "from_load_line": middle}
    )
    result["from_load_line"].attrs.update(
        units="rad", long_name="azimuth from the centre of the load zone"
    )
    for name, total in sums.items():
        result[name] = (
            dims,
            np.divide(total, counts, out=np.full(shape, np.nan), where=counts > 0),
        )
    return result
