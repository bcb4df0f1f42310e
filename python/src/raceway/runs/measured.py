# SPDX-License-Identifier: GPL-2.0-or-later
"""Forces, displacement, tilt and speed of the inner ring, measured over the window of a run, and
the load distribution factor if it is defined."""

import math
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, mean
from raceway.runs.tables import RunTables
from raceway.runs.turning import changes
from raceway.runs.warming import warm_clearance
from raceway.theory import clearance
from raceway.theory.bearing import INNER, OUTER
from raceway.units import prefixed

FEW = 0.05  # fraction of the radial load or displacement above which the load is not purely radial
LITTLE = 0.01  # fraction of a load below which another one is only ripple
TURNED = 0.1  # rad; a load whose direction varies by more than this does not count as steady


def measured(tables: RunTables) -> dict[str, float | None]:
    """Return means over the window in SI units; quantities that the run did not record are None.

    - `axial_N`: `axial_load`
    - `force_x_N`, `force_y_N`, `force_z_N`: force of balls and cage on the inner ring
    - `moment_x_N_m`, `moment_y_N_m`: moment of these forces on the ring
    - `shift_z_m`, `tilt_x_rad`, `tilt_y_rad`: axial displacement and tilt of the ring
    - `rpm_inner`, `rpm_outer`: speeds of the rings, positive about the axis
    - `rpm_least`, `rpm_most`: lowest and highest relative speed of the rings
    - `rpm_top`: relative speed at the largest load on the inner raceway
    """
    rings = _window(tables)
    result = {
        key: mean(rings[name]) if name in rings else None
        for key, name in (
            ("force_x_N", "fx"),
            ("force_y_N", "fy"),
            ("force_z_N", "fz"),
            ("moment_x_N_m", "mx"),
            ("moment_y_N_m", "my"),
            ("shift_z_m", "z"),
            ("tilt_x_rad", "tilt_1"),
            ("tilt_y_rad", "tilt_2"),
        )
    }
    result["axial_N"] = axial_load(tables)
    inner, outer = rpm(tables)
    against = np.abs(inner - outer)
    kept = _kept(tables)
    means = {"rpm_inner": inner, "rpm_outer": outer}
    result |= {key: float(values[kept].mean()) for key, values in means.items()}
    result |= {"rpm_least": float(against[kept].min()), "rpm_most": float(against[kept].max())}
    result["rpm_top"] = float(against[tables.total_columns["load_inner"].argmax()])
    return result


def rpm(tables: RunTables) -> tuple[Floats, Floats]:
    """Return the speeds (N,) of the inner and the outer ring at the samples in rpm, positive about
    the axis."""
    of, window = tables.turning, (tables.first, tables.last)
    return tuple(of.speed(side, *window) * 30 / math.pi for side in (INNER, OUTER))


def speeds(tables: RunTables) -> str:
    """Return the shaft speed, or its range if it changes, as text.

    If the outer ring rotates, the text contains the speeds of both rings.
    """
    inner, outer = (speed[_kept(tables)] for speed in rpm(tables))
    if outer.any():
        return f"inner {_range(inner)}, outer {_range(outer)}"
    return _range(np.abs(inner)) if changes(inner) else f"{tables.settings['rpm']:g} rpm"


def _range(speed):
    if changes(speed):
        return f"{speed.min():.4g} to {speed.max():.4g} rpm"
    return f"{speed.mean():.4g} rpm"


class Loading(NamedTuple):
    """Load on the balls in N.

    `radial` is the mean magnitude of the radial force, `axial` the force along the axis; `turns` is
    true if the radial force rotates.
    """

    radial: float
    axial: float
    turns: bool


def loading(tables: RunTables) -> Loading | None:
    """Return the measured load on the inner ring, which is opposite to the force of the balls, or
    None if the run did not record forces."""
    rings = _window(tables)
    if "fx" not in rings or "fy" not in rings or not len(rings["fx"]):
        return None
    force = rings["fx"] + 1j * rings["fy"]
    radial = float(np.abs(force).mean())
    axial = -mean(rings["fz"]) if "fz" in rings else 0.0
    # The ball-pass ripple rotates the direction of a steady load by less than this angle.
    return Loading(radial, axial, bool(abs(force.mean()) < math.cos(TURNED) * radial))


def axial_load(tables: RunTables) -> float | None:
    """Return the axial load in N, as set or as measured, or None if it is unknown. A measured load
    that is only ripple counts as 0."""
    if (told := tables.settings.get("axial_N")) is not None:
        return float(told)
    load = loading(tables)
    if load is None or "fz" not in _window(tables):
        return None
    return load.axial if abs(load.axial) > LITTLE * load.radial else 0.0


def load_parameter(tables: RunTables, displacement: float) -> float | str | None:
    """Return the load distribution factor of a run with the mean radial `displacement` (m).

    Return None where it is undefined, i.e. if there is no displacement, if the ring is tilted, or
    if the load rotates or is not radial. Return the reason as text if the balls do not carry the
    load in the mean position of the ring, as in a run that has not settled.
    """
    rings, load = _window(tables), loading(tables)
    if not displacement:
        return None
    if load and (load.turns or abs(load.axial) > FEW * load.radial):
        return None
    tilts = [mean(rings[name]) for name in ("tilt_1", "tilt_2") if name in rings]
    if math.hypot(*tilts) * tables.geometry.pitch_radius > FEW * abs(displacement):
        return None
    if displacement < 0:
        return "the ring has moved against the load"
    factor = clearance.load_parameter(warm_clearance(tables), displacement)
    return factor if factor > 0 else "the ring has moved by less than half the clearance"


def _kept(tables):
    """Return the samples of the window without the first sample, unless it is the only one."""
    return slice(int(tables.first == 0 and tables.last > 1), None)


def _window(tables):
    """Return the columns of the inner ring without the start of the record."""
    return {name: values[tables.first == 0 :] for name, values in tables.ring_columns.items()}


def title(tables: RunTables) -> str:
    """Return a one-line description of the run `tables` with the measured load and speed."""
    settings = tables.settings
    oil = f"{settings['lubricant']} lubricant" if tables.lubricated else "dry"
    clearance = prefixed(settings["clearance_m"], "m", 3).replace("-", "−")
    return "  ·  ".join(
        (
            f"{settings['bearing']} ball bearing",
            *_loads(tables),
            speeds(tables),
            oil,
            f"clearance {clearance}",
        )
    )


def _loads(tables):
    load = loading(tables)
    if load is None:
        return [f"{prefixed(tables.settings['load_N'], 'N')} radial"]
    largest = max(load.radial, abs(load.axial))
    if largest == 0.0:
        return ["no load"]
    parts = (
        (load.radial, "turning radial load" if load.turns else "radial"),
        (load.axial, "axial"),
    )
    return [
        f"{prefixed(value, 'N', 3).replace('-', '−')} {name}"
        for value, name in parts
        if abs(value) > LITTLE * largest
    ]
