# SPDX-License-Identifier: GPL-2.0-or-later
"""A one-piece cage (fix bearing/cage/ring) in a run: its slip, orbit and pocket
forces."""

import math
from typing import TYPE_CHECKING

import numpy as np

from raceway.runs.record import CAGE_RING

if TYPE_CHECKING:
    from raceway.runs.tables import RunTables

CAGE_RING_FIGURES = ("cage_slip", "cage_orbit_m", "pocket_force_max_N")


def cage_figures(tables: "RunTables") -> dict[str, float]:
    """`cage_slip`: 1 minus the cage's speed over that of rolling at contact angle 0, both relative
    to the outer ring, means of the measured passes; `cage_orbit_m`: largest distance of the cage's
    centre from its mean position (m); `pocket_force_max_N`: largest force of a ball on its pocket
    at the ends of steps (N). Empty without such a cage."""
    record = tables.record
    side = record.fixed("ring_raceway").tolist()
    if CAGE_RING not in side:
        return {}
    stop = len(record) if tables.stop is None else tables.stop
    start = tables.first
    cage = side.index(CAGE_RING)
    data = record.read(["ring_spin", "ring_x", "ring_y"], start, stop)
    spin = data["ring_spin"].mean(axis=0)
    inner, outer = (float(spin[side.index(k)]) if k in side else 0.0 for k in (0, 1))
    told = tables.settings
    pitch = told["inner_radius_m"] + told["outer_radius_m"]
    rolling = 0.5 * (inner - outer) * (1 - told["ball_diameter_m"] / pitch)
    place = [data[f"ring_{axis}"][:, cage] for axis in "xy"]
    orbit = np.hypot(*(along - along.mean() for along in place)).max()
    slip = 1 - (float(spin[cage]) - outer) / rolling if rolling != 0.0 else math.nan
    force = record.read(["ball_pocket_force"], start, stop)["ball_pocket_force"]
    known = force[np.isfinite(force)]
    most = float(known.max()) if known.size else math.nan
    return dict(zip(CAGE_RING_FIGURES, (slip, float(orbit), most), strict=True))
