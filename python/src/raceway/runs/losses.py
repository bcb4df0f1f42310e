# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction torque and power losses of a bearing over time and around the ring."""

import numpy as np
import xarray as xr

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.around import BINS, around
from raceway.runs.columns import LOSSES
from raceway.runs.run import Run
from raceway.runs.tables import RunTables


def losses(run: Run) -> xr.Dataset:
    """Return a Dataset (time) for `run` (from `raceway.open`) at the samples that rings and
    contacts have in common.

    - `torque` (N m): moment of the balls on the inner ring that opposes its rotation relative to
      the outer ring
    - `power_in` (W): power supplied by both rings, i.e. moment times spin
    - `friction_power`, `damping_power`, ... (W): dissipated power for each kind of loss that the
      contact law of the run has (`columns.LOSSES`)

    At any time, the supplied and the dissipated power differ by the rate of change of elastic and
    kinetic energy; averaged over whole ball passes, they differ by the energy error of the
    integrator. The torque is the moment about the bearing axis, so the tilt of the ring must be
    small. Raise `RunError` if the run did not record its losses.
    """
    rings, bearing, tables = run.rings, run.bearing, run.tables
    if "mz" not in rings or "spin" not in rings:
        raise RunError(f"{tables.record.path} has no columns mz and spin")
    torque = rings["mz"].copy(data=opposing_moment(tables))
    both = tables.record.read(["ring_mz", "ring_spin"], tables.first, tables.last)
    power = -(both["ring_mz"] * both["ring_spin"]).sum(axis=1)
    data = xr.merge(
        [{"torque": torque, "power_in": torque.copy(data=power)}, bearing[_known(bearing, run)]],
        join="inner",
        combine_attrs="drop_conflicts",
        compat="override",
    )
    data["torque"].attrs = {"units": "N m", "long_name": "friction torque on the inner ring"}
    data["power_in"].attrs = {"units": "W", "long_name": "power supplied by the rings"}
    return data


def opposing_moment(tables: RunTables) -> Floats:
    """Return the moment (N,) in N m of the balls on the inner ring that opposes its rotation
    relative to the outer ring, whose direction may change."""
    way = np.sign(tables.turning.shaft_speed(tables.first, tables.last))
    return -tables.ring_columns["mz"] * way


def losses_around(run: Run, bins: int = BINS) -> xr.Dataset:
    """Return a Dataset (raceway, from_load_line) of mean power losses of a contact (W) in each
    sector of the ring.

    It has a variable for each loss column of the contacts (`friction_power`, `damping_power`, ...)
    and `contacts`, the number of contacts. The run is read in blocks. Raise `RunError` in the same
    cases as `losses`.
    """
    names = _known(run.tables.record.contact_columns, run)
    result = around(run, {name: lambda table, name=name: table[name] for name in names}, bins)
    for name in names:
        result[name].attrs["units"] = "W"
    return result


def _known(columns, run):
    """Return the loss columns among `columns`; raise `RunError` if there are none."""
    if known := [name for name in LOSSES.values() if name in columns]:
        return known
    raise RunError(
        f"{run.tables.record.path} has no column of {', '.join(LOSSES.values())}: run the deck"
        " again"
    )
