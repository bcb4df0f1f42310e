# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction torque and power losses of a run, and values from the formulas of bearing makers."""

import math
from typing import Any

import numpy as np

from raceway import catalogue, inputs
from raceway.arrays import mean
from raceway.runs.columns import LOSSES
from raceway.runs.measured import loading
from raceway.runs.tables import RunTables
from raceway.theory import makers

KEYS = ("friction_torque_N_m", "power_loss_W", "losses_W", *makers.KEYS, "asperity_share")
STILL = 1e-9  # rad/s, relative speed below which the rings count as being at rest


def friction(tables: RunTables) -> dict[str, Any]:
    """Return means over the window in SI units; quantities that the run does not have are None.

    - `friction_torque_N_m`: power loss divided by the relative speed of the rings, which counts as
      positive in both directions; None for speeds below `STILL`, with a warning in the summary
    - `power_loss_W`, `losses_W`: power dissipated in all contacts, in total and for each kind of
      loss (`columns.LOSSES`)
    - `asperity_share`: fraction of the load carried by asperities, at the largest inner load
    - `torque_skf_N_m`, `torque_palmgren_N_m`: values from the makers' formulas for the measured
      forces, if the files of bearing and lubricant are available, or the reason why a formula does
      not apply
    """
    totals = tables.total_columns
    result: dict[str, Any] = dict.fromkeys(KEYS)
    losses = {key: mean(totals[name]) if name in totals else None for key, name in LOSSES.items()}
    known = [loss for loss in losses.values() if loss is not None]
    result["losses_W"] = losses if known else None
    result["power_loss_W"] = sum(known) if known else None
    speed = np.abs(tables.turning.shaft_speed(tables.first, tables.last)[tables.first == 0 :])
    spin = float(speed.mean())
    if known and spin > STILL:
        result["friction_torque_N_m"] = result["power_loss_W"] / spin
    if "asperity_share_top" in totals:
        top = totals["load_inner"].argmax()
        result["asperity_share"] = float(totals["asperity_share_top"][top])
    result.update(_makers(tables))
    return result


def _makers(tables):
    """Return the `makers.torques` at the measured forces."""
    settings = tables.settings
    load = loading(tables)
    if not tables.lubricated or load is None or "fz" not in tables.ring_columns:
        return {}
    try:
        boundary = inputs.boundary(catalogue.find("bearings", settings["bearing"]))
        fluid = inputs.fluid(catalogue.find("lubricants", settings["lubricant"]))
    except inputs.InputError:
        return {}
    if math.isnan(fluid.density):
        return {}
    nu = 1e6 * settings["viscosity_Pa_s"] / fluid.density
    return makers.torques(
        boundary,
        load.radial,
        load.axial,
        abs(settings["rpm"]),
        nu,
        settings["ball_diameter_m"],
        one_groove=not tables.record.two_grooves,
    )
