# SPDX-License-Identifier: GPL-2.0-or-later
"""Compute the results of a circuit, format them as text, and write its tables to files."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from raceway.electric.circuit import Result
from raceway.files import FilePath, folder, whole
from raceway.rows import Row, lines

TOPICS = {
    "Time": (Row("time_s", "simulated", "s"), Row("step_s", "step of the circuit", "s")),
    "Capacitance between the rings": (
        Row("capacitance_mean_F", "mean", "F"),
        Row("capacitance_min_F", "least", "F"),
        Row("capacitance_max_F", "largest", "F"),
    ),
    "Voltages": (
        Row("driving_voltage_max_V", "outer circuit, largest", "V"),
        Row("bearing_voltage_max_V", "bearing, largest", "V", "before discharges"),
        Row("bearing_voltage_rms_V", "bearing, root mean square", "V"),
        Row("film_voltage_max_V", "film, largest", "V", "before discharges"),
        Row("field_max_V_m", "field in a film, largest", "V/m", "local where films can fail"),
        Row("current_max_A", "current into the films, largest", "A", "mean of a step"),
    ),
    "Bearing voltage ratio": (
        Row("bearing_voltage_ratio_mean", "mean", "", "by capacitances"),
        Row("bearing_voltage_ratio_min", "least", ""),
        Row("bearing_voltage_ratio_max", "largest", ""),
    ),
    "Threshold voltage": (
        Row("threshold_mean_V", "mean", "V", "balls without charge", "bridged"),
        Row("threshold_min_V", "least", "V", "", "bridged"),
        Row("floor_share", "bridged films", "", "share; at the film floor"),
    ),
    "Discharges": (
        Row("discharges", "number", ""),
        Row("discharges_per_s", "per second", ""),
        Row("full_discharges", "down to 0 V", ""),
        Row("failed_inner", "films failed, inner raceway", ""),
        Row("failed_outer", "films failed, outer raceway", ""),
        Row("voltage_before_mean_V", "bearing voltage before, mean", "V"),
        Row("energy_mean_J", "energy of one, mean", "J"),
        Row("energy_max_J", "energy of one, largest", "J"),
        Row("arc_current_max_A", "current of a failure, largest", "A", "by the arc's resistance"),
        Row("arc_duration_mean_s", "duration of a failure, mean", "s", "to 1/e"),
        Row("current_density_max_A_m2", "apparent current density, largest", "A/m2"),
        Row("place_rad", "mean angle from the load line", "rad", "by energy"),
    ),
    "Energy since the start": (
        Row("source_work_J", "work of the outer circuit", "J"),
        Row("mechanical_work_J", "work of moving plates", "J"),
        Row("leak_heat_J", "heat in films", "J"),
        Row("resistor_heat_J", "heat in the source's resistance", "J"),
        Row("discharge_energy_J", "heat of discharges", "J"),
        Row("stored_energy_J", "stored at the end", "J"),
    ),
    "Errors": (
        Row("charge_error_C", "charge of a node, largest", "C"),
        Row("energy_error_J", "energy of a step, largest", "J"),
    ),
}


def figures(result: Result) -> dict[str, float | None]:
    """Return the results of a circuit as a dict with the keys of `TOPICS`, whose names include the
    SI units. Quantities that do not exist for the circuit are None."""
    data, events = result
    one, fails = events.groupby("discharge"), "threshold_voltage" in data
    energy, length = one["energy"].sum(), float(data.time[-1] - data.time[0])
    found = {
        "time_s": length,
        "step_s": float(data.time.diff("time").max()),
        "driving_voltage_max_V": _largest(data.driving_voltage),
        "bearing_voltage_max_V": _before(data.bearing_voltage, events.bearing_voltage),
        "bearing_voltage_rms_V": float(np.sqrt((data.bearing_voltage**2).mean())),
        "film_voltage_max_V": _before(data.film_voltage, events.film_voltage),
        "field_max_V_m": _before(data.get("local_field", data.field), events.field),
        "current_max_A": _largest(data.current),
        "charge_error_C": _largest(data.charge_error),
        "energy_error_J": _largest(data.energy_error),
        "stored_energy_J": float(data.stored_energy[-1]),
    }
    for key, name, unit in (
        ("capacitance", "bearing_capacitance", "_F"),
        ("bearing_voltage_ratio", "bearing_voltage_ratio", ""),
        ("threshold", "threshold_voltage", "_V"),
    ):
        values = data.get(name)
        for what in ("mean", "min", "max"):
            found[f"{key}_{what}{unit}"] = (
                None if values is None else _finite(getattr(values, what)())
            )
    if fails and not found["threshold_min_V"]:  # exclude the times at which a film is bridged
        whole = data.threshold_voltage.where(data.threshold_voltage > 0)
        found["threshold_mean_V"] = _finite(whole.mean()) or 0.0
    for name in "source_work mechanical_work leak_heat resistor_heat discharge_energy".split():
        found[f"{name}_J"] = float(data[name][-1])
    found |= {
        "floor_share": _at_the_floor(data.local_thickness) if fails else None,
        "discharges": len(one) if fails else None,
        "discharges_per_s": len(one) / length if fails else None,
        "full_discharges": int((one["bearing_voltage_after"].last() == 0).sum()) if fails else None,
        "failed_inner": int((events.raceway == "inner").sum()) if fails else None,
        "failed_outer": int((events.raceway == "outer").sum()) if fails else None,
        "voltage_before_mean_V": _finite(one["bearing_voltage"].first().abs().mean()),
        "energy_mean_J": _finite(energy.mean()),
        "energy_max_J": _finite(energy.max()),
        "arc_current_max_A": _finite(events["current"].max()),
        "arc_duration_mean_s": _finite(events["duration"].mean()),
        "current_density_max_A_m2": _finite(events["current_density"].max()),
        "place_rad": _place(events),
    }
    return found


def table(figures: dict[str, float | None]) -> str:
    """Format `figures` as text."""
    return "\n".join(lines(figures, TOPICS))


def write(result: Result, out: FilePath) -> list[Path]:
    """Write the tables circuit.csv (one row per point in time) and events.csv (one row per failed
    film) to the folder `out`, and return the paths of both files.

    The headings include units. Raises `RunError` if a file cannot be written.
    """
    out = folder(out)
    return [
        _csv(over_time(result.data), out / "circuit.csv"),
        _csv(
            result.events.rename(columns=_heading(result.events.attrs["units"])), out / "events.csv"
        ),
    ]


def over_time(data: xr.Dataset) -> pd.DataFrame:
    """Return a table with one row per point in time. It contains the variables of the bearing in
    the dataset of a circuit, and the capacitance (F) and voltage (V) of every film. The headings
    include the units."""
    units = {name: variable.attrs["units"] for name, variable in data.data_vars.items()}
    whole_bearing = [name for name in data.data_vars if data[name].dims == ("time",)]
    parts = {"time (s)": data.time.to_numpy()}
    parts |= {f"{name} ({units[name]})": data[name].to_numpy() for name in whole_bearing}
    for name in ("film_capacitance", "film_voltage"):
        for side in data.raceway.to_numpy():
            for ball in data.ball.to_numpy():
                values = data[name].sel(raceway=side, ball=ball)
                parts[f"{name} {side} {ball} ({units[name]})"] = values.to_numpy()
    return pd.DataFrame(parts)


def _heading(units):
    return {name: name if unit == "1" else f"{name} ({unit})" for name, unit in units.items()}


def _csv(frame, path):
    return whole(path, lambda part: frame.to_csv(part, index=False))


def _at_the_floor(thickness):
    """Return the fraction of the films that are at the floor, or None if there are no films."""
    there = thickness.notnull()
    low = there & (thickness <= thickness.attrs["floor"])
    return float(low.sum() / there.sum()) if there.any() else None


def _largest(values):
    return _finite(np.abs(values).max())


def _before(values, events):
    """Return the largest magnitude, including the values just before discharges."""
    return max(_largest(values) or 0.0, _finite(events.abs().max()) or 0.0)


def _finite(value):
    return float(value) if np.isfinite(value) else None


def _place(events):
    """Return the mean direction of the failures, weighted by energy, or None if there are no
    failures or if they are evenly distributed around the ring."""
    weight = events.energy.to_numpy(dtype=float)
    total = (weight * np.exp(1j * events.from_load_line.to_numpy(dtype=float))).sum()
    if not len(events) or not np.abs(total) > 1e-9 * weight.sum():
        return None
    return float(np.angle(total))
