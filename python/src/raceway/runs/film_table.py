# SPDX-License-Identifier: GPL-2.0-or-later
"""Electrical results of a run, computed from `film_figures` over time, as a dict and as text."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from raceway.rows import Row, lines, row
from raceway.runs.run import Run
from raceway.theory.electric_table import PARTS, PLATES, shown
from raceway.theory.film_voltage import STATES

TOPICS = {
    "Run": (
        row("bearing"),
        row("lubricant"),
        row("load_N"),
        row("clearance_m"),
        row("rpm")._replace(label="speed of inner relative to outer"),
        Row("surroundings", "surroundings", None),
        Row("source", "capacitances from", None),
        Row("samples", "samples", ""),
    ),
    "Capacitance, mean over the run": (
        *PARTS,
        Row("capacitance_total_min_F", "bearing, least", "F"),
        Row("capacitance_total_max_F", "bearing, largest", "F"),
        *PLATES,
    ),
    "Breakdown": (
        Row("threshold_V", "smallest voltage, smooth", "V", "minimum over the run"),
        Row("threshold_mean_V", "smallest voltage, smooth, mean", "V"),
        Row(
            "threshold_peaks_V",
            "smallest voltage, rough",
            "V",
            "minimum; over h_c - 3 sigma",
            "bridged",
        ),
        Row("threshold_azimuth_deg", "azimuth of that ball", "°", "from the load line"),
        Row("stored_energy_J", "energy of that discharge", "J", "smooth"),
        Row("field_V_m", "largest field, smooth", "V/m"),
        Row("field_peaks_V_m", "largest field, rough", "V/m"),
        Row("metallic_share", "metallic contacts", "", "fraction; asperities carry over 1 %"),
    ),
    "Impedance": (
        Row("leak_ohm", "leak", "Ω", "direct current, mean"),
        Row("frequency_Hz", "frequency", "Hz"),
        Row("impedance_ohm", "impedance", "Ω", "mean"),
        Row("impedance_min_ohm", "impedance, least", "Ω"),
        Row("impedance_max_ohm", "impedance, largest", "Ω"),
        Row("phase_deg", "phase", "°", "mean"),
    ),
    "Motor": (
        Row("bearing_voltage_ratio", "bearing voltage ratio", "", "mean; two such bearings"),
        Row("bearing_voltage_ratio_min", "least", ""),
        Row("bearing_voltage_ratio_max", "largest", ""),
    ),
}


def figures(
    run: Run, data: xr.Dataset, fields: xr.Dataset, frequency: float | None = None
) -> dict[str, Any]:
    """Return the electrical results of a `run` in SI units (angles in degrees), keyed by name.

    Results that were not requested are None. `data` is from `film_figures.over_time`, `fields` from
    `whole_capacitance.fields`. Keys that `electric_point.figures` also has have the same meaning,
    but refer to the whole run.
    """
    first = int(data["threshold"].to_numpy().argmin())
    state = fields["state"].to_numpy() == STATES.index("metallic")
    plates = float(data["plates"].mean())
    whole = data["bearing"]
    known = ("bearing", "lubricant", "load_N", "clearance_m", "rpm")
    found: dict[str, Any] = {key: run.settings.get(key) for key in known}
    found |= dict(
        surroundings=data.attrs["filling"],
        source=data.attrs["source"],
        samples=data.sizes["time"],
        capacitance_F=plates,
        capacitance_surroundings_F=float(data["around"].mean()),
        capacitance_unloaded_F=float(data["unloaded"].mean()),
        capacitance_total_F=float(whole.mean()),
        capacitance_total_min_F=float(whole.min()),
        capacitance_total_max_F=float(whole.max()),
        plates_factor=float(whole.mean()) / plates if plates else None,
        hertz_area_m2=float(data["hertz_area"].mean()),
        threshold_V=float(data["threshold"][first]),
        threshold_mean_V=float(data["threshold"].mean()),
        threshold_peaks_V=float(data["threshold_peaks"].min()),
        threshold_azimuth_deg=_azimuth(run, data["time"][first], data["weakest"][first]),
        stored_energy_J=float(data["energy"][first]),
        field_V_m=_finite(data.get("field"), "max"),
        field_peaks_V_m=_finite(data.get("field_peaks"), "max"),
        metallic_share=float(state.mean()),
        leak_ohm=_finite(data.get("leak"), "mean"),
        frequency_Hz=frequency,
    )
    for key, name, whats in (
        ("impedance{}_ohm", "impedance", ("mean", "min", "max")),
        ("bearing_voltage_ratio{}", "bearing_voltage_ratio", ("mean", "min", "max")),
    ):
        for what in whats:
            end = "" if what == "mean" else f"_{what}"
            found[key.format(end)] = _finite(data.get(name), what)
    phase = _finite(data.get("phase"), "mean")
    found["phase_deg"] = None if phase is None else math.degrees(phase)
    return found


def table(figures: Mapping[str, Any]) -> str:
    """Return `figures` as text."""
    return "\n".join(lines(shown(figures), TOPICS))


def _azimuth(run, time, ball):
    line = run.balls["from_load_line"].sel(time=time, ball=int(ball))
    return math.degrees(float(line))


def _finite(values, what):
    if values is None:
        return None
    found = float(getattr(values, what)())
    return found if np.isfinite(found) else None
