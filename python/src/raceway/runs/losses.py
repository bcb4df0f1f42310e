# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction torque and power losses of the bearing."""

import numpy as np
import xarray as xr

from raceway.errors import RunError
from raceway.runs.around import BINS, around
from raceway.runs.columns import LOSSES
from raceway.runs.run import Run


def losses(run: Run) -> xr.Dataset:
    """Dataset (time) of `run` (from `raceway.open`), at the samples common to rings and contacts:

    - `torque` (N m): moment of the balls on the inner ring, opposite to its rotation relative to
      the outer ring
    - `power_in` (W): power supplied by both rings, moment times spin
    - the power lost (W), by kind of loss: `friction_power`, `damping_power`, ... if the
      contact law of the run has them (`columns.LOSSES`)

    At any moment, power in and power lost differ by the rate of change of elastic and kinetic
    energy; averaged over whole ball passes, they differ by the energy error of the integrator. The
    torque is the moment about the bearing's axis, so the tilt of the ring must be small. Raises
    `RunError` if the run did not record its losses.
    """
    rings, bearing = run.rings, run.bearing
    if "mz" not in rings or "spin" not in rings:
        raise RunError(f"{run.tables.record.path} has no columns mz and spin")
    tables = run.tables
    torque = -rings["mz"] * np.sign(tables.turning.shaft_speed(tables.first, tables.last))
    both = tables.record.read(["ring_mz", "ring_spin"], tables.first, tables.last)
    power = -(both["ring_mz"] * both["ring_spin"]).sum(axis=1)
    data = xr.merge(
        [
            {"torque": torque, "power_in": torque.copy(data=power)},
            bearing[_known(bearing, run)],
        ],
        join="inner",
        combine_attrs="drop_conflicts",
        compat="override",
    )
    data["torque"].attrs = {"units": "N m", "long_name": "friction torque on the inner ring"}
    data["power_in"].attrs = {"units": "W", "long_name": "power supplied by the rings"}
    return data


def losses_around(run: Run, bins: int = BINS) -> xr.Dataset:
    """Dataset (raceway, from_load_line): mean power loss of a contact (W) in each sector of the
    ring, for each loss column of the contacts (`friction_power`, `damping_power`, ...), and
    `contacts`, the number of contacts. Reads in blocks. Raises as `losses` does."""
    names = _known(run.tables.record.contact_columns, run)
    result = around(run, {name: lambda table, name=name: table[name] for name in names}, bins)
    for name in names:
        result[name].attrs["units"] = "W"
    return result


def _known(columns, run):
    """Loss columns among `columns`. Raises `RunError`, which names the file, if there are none."""
    if known := [name for name in LOSSES.values() if name in columns]:
        return known
    raise RunError(
        f"{run.tables.record.path} has no column of {', '.join(LOSSES.values())}: run the deck"
        " again"
    )
