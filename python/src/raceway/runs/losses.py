# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction torque of the bearing and where its power goes."""

import numpy as np
import xarray as xr

from raceway.errors import RunError
from raceway.runs.around import BINS, around
from raceway.runs.columns import LOSSES
from raceway.runs.run import Run


def losses(run: Run) -> xr.Dataset:
    """Dataset (time) of `run` (from `raceway.open`), from the samples that both rings and contacts
    have:

    - `torque` (N m): what the balls hold against the inner ring's spin
    - `power_in` (W): torque times spin
    - the power lost (W), by kind of loss: `friction_power`, `damping_power`, ... as far as the
      contact law of the run has them (`columns.LOSSES`)

    Power in and power lost differ at any moment by what springs and moving balls store, and on
    average over whole ball passes by what the integrator adds or takes. The bearing's axis is z and
    the ring not tilted much: the torque is the moment about z. Raises `RunError` when the run did
    not record its losses.
    """
    rings, bearing = run.rings, run.bearing
    if "mz" not in rings or "spin" not in rings:
        raise RunError(f"{run.tables.record.path} has no columns mz and spin")
    torque = -rings["mz"] * np.sign(rings["spin"])
    data = xr.merge(
        [
            {"torque": torque, "power_in": -rings["mz"] * rings["spin"]},
            bearing[_known(bearing, run)],
        ],
        join="inner",
        combine_attrs="drop_conflicts",
        compat="override",
    )
    data["torque"].attrs = {"units": "N m", "long_name": "friction torque on the inner ring"}
    data["power_in"].attrs = {"units": "W", "long_name": "power the shaft puts in"}
    return data


def losses_around(run: Run, bins: int = BINS) -> xr.Dataset:
    """Dataset (raceway, from_load_line): mean power lost of a contact (W) in each part of the ring,
    by the columns that the contacts of the run have (`friction_power`, `damping_power`, ...), and
    `contacts`. Read in blocks. Raises as `losses` does."""
    names = _known(run.settings["contact_columns"].split(), run)
    result = around(run, {name: lambda table, name=name: table[name] for name in names}, bins)
    for name in names:
        result[name].attrs["units"] = "W"
    return result


def _known(columns, run):
    """The loss columns among `columns`; error naming the file where there is none."""
    if known := [name for name in LOSSES.values() if name in columns]:
        return known
    raise RunError(
        f"{run.tables.record.path} has no column of {', '.join(LOSSES.values())}: run the deck"
        " again"
    )
