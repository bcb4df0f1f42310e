# SPDX-License-Identifier: GPL-2.0-or-later
"""Temperatures of a run with fix bearing/heat: the transient, and results for the measured
window."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from raceway.arrays import Floats, mean
from raceway.core import laws
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.rows import Row
from raceway.runs.columns import HEAT
from raceway.runs.tables import RunTables
from raceway.theory.ball_material import STEEL as STEEL_BALLS

if TYPE_CHECKING:
    import xarray as xr

FILE = "heat.txt"  # in the run's folder
PARTS = ("inner", "balls", "outer", "housing", "oil")
ROWS = (
    Row("thermal_time_s", "thermal time", "s", "covered in jumps"),
    Row("thermal_speed", "thermal time over simulated time", ""),
    Row("temperature_inner_C", "inner ring", "°C", "mean of the measured passes"),
    Row("temperature_balls_C", "balls", "°C"),
    Row("temperature_outer_C", "outer ring", "°C"),
    Row("temperature_housing_C", "housing", "°C"),
    Row("temperature_oil_C", "oil in the contacts", "°C"),
    Row("temperature_outlet_C", "oil at the outlet", "°C", "of the last jump"),
    Row("clearance_warm_m", "diametral clearance, warm", "m"),
    Row("heat_gain", "gain of losses with temperature", "", "1: thermal runaway"),
    Row("heat_booked_J", "heat of the losses", "J", "over the thermal time"),
    Row("heat_carried_J", "carried to ambient and by flowing oil", "J"),
    Row("heat_stored_J", "stored in rings, balls, housing", "J"),
)


def transient(folder: FilePath) -> "xr.Dataset":
    """Return the temperatures of the run in `folder` at each jump.

    The result is a Dataset indexed by `thermal_time` in s, with units and meanings in `attrs`.
    Raise `RunError` if the run has no temperatures.
    """
    import xarray as xr  # importing it takes longer than computing a summary

    path = Path(folder) / FILE
    try:
        lines = path.read_text().splitlines()
    except FileNotFoundError:
        raise RunError(f"{path} is missing: the run has no fix bearing/heat with a file") from None
    names = lines[0].removeprefix("#").split() if lines else []
    try:
        values = np.array([[float(word) for word in line.split()] for line in lines[1:]])
        values = values.reshape(-1, len(names))
    except ValueError as error:
        raise RunError(f"{path} is damaged: {error}") from None
    if not names or set(names) - set(HEAT):
        raise RunError(
            f"{path} is not a table of fix bearing/heat: the names in its first line differ"
        )
    data = {
        name: ("thermal_time", values[:, k], _attributes(name))
        for k, name in enumerate(names)
        if name != "thermal_time"
    }
    time = ("thermal_time", values[:, names.index("thermal_time")], _attributes("thermal_time"))
    return xr.Dataset(data, {"thermal_time": time})


def _attributes(name):
    return {"units": HEAT[name].unit or "1", "long_name": HEAT[name].meaning}


def heated(tables: RunTables) -> bool:
    """Return True if the temperatures of the bearing follow from its losses. Another bearing of the
    same run may be at constant temperature."""
    inner = tables.total_columns.get("temperature_inner")
    return inner is not None and bool(np.isfinite(inner).any())


def warm_clearance(tables: RunTables) -> float:
    """Return the mean diametral clearance of the run in m.

    If the run has temperatures, it is the clearance of the warm parts; otherwise it is the
    clearance that was set.
    """
    cold = tables.settings["clearance_m"]
    if not heated(tables):
        return cold
    bearing, ambient = tables.geometry, tables.settings["heat_ambient_C"]
    rises = [mean(tables.total_columns[f"temperature_{part}"]) - ambient for part in PARTS[:3]]
    radii = bearing.inner_radius, bearing.outer_radius, bearing.ball_radius
    return cold + float(laws.clearance_change(*radii, *rises, _ball_expansion(tables)))


def strains(tables: RunTables) -> tuple[Floats, Floats, Floats]:
    """Return the thermal strains of inner ring, balls and outer ring, with one value per sample,
    relative to the ambient temperature. They are 0 in a run without temperatures."""
    if not heated(tables):
        still = np.zeros(len(tables.total_columns["pressure"]))
        return still, still, still
    ring, ball = float(laws.steel_of_bearings().expansion), _ball_expansion(tables)
    inner, balls, outer = (
        tables.total_columns[f"temperature_{part}"] - tables.settings["heat_ambient_C"]
        for part in PARTS[:3]
    )
    return ring * inner, ball * balls, ring * outer


def _ball_expansion(tables):
    """Return the coefficient of thermal expansion of the balls in 1/K, which records of steel balls
    need not state."""
    return tables.settings.get("ball_expansion_per_K", STEEL_BALLS.expansion)


def _last_jump(tables):
    """Return the last row of the table of the fix. It is None if there is no such table, or if the
    run has several bearings and the table is that of another one."""
    if not (tables.folder / FILE).exists():
        return None
    last = transient(tables.folder).isel(thermal_time=-1)
    parts = PARTS[:3]
    at = [float(last[f"temperature_{part}"]) for part in parts]
    end = [float(tables.total_columns[f"temperature_{part}"][-1]) for part in parts]
    # the record contains the temperatures of the table with single precision or better
    own = len(tables.record.bearings) == 1 or np.allclose(at, end, rtol=1e-6, atol=0)
    return last if own else None


def figures(tables: RunTables) -> dict[str, float]:
    """Return the results with the keys of `ROWS` in SI units and degrees C.

    The dict is empty for a run without heat. Results for the transient require the table of the
    fix.
    """
    if not heated(tables):
        return {}
    columns = tables.total_columns
    found = {f"temperature_{part}_C": mean(columns[f"temperature_{part}"]) for part in PARTS}
    found["clearance_warm_m"] = warm_clearance(tables)
    last = _last_jump(tables)
    if last is not None:
        time = float(last["thermal_time"])
        found |= {
            "thermal_time_s": time,
            "thermal_speed": time / float(last["run_time"]),
            "heat_gain": float(last["gain"]),
            **{f"heat_{k}_J": float(last[k]) for k in ("booked", "carried", "stored")},
        }
        if (outlet := float(last["temperature_outlet"])) != float(last["temperature_oil"]):
            found["temperature_outlet_C"] = outlet  # only for flowing oil
    return found
