# SPDX-License-Identifier: GPL-2.0-or-later
"""Text tables of the electrical results of `electric_point`: `table` for one operating point,
`curves` for several."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from raceway.rows import GROOVES, Row, aligned, lines, row, several, warning_lines
from raceway.units import prefixed

PARTS = (
    row("capacitance_F"),
    Row("capacitance_surroundings_F", "around the ellipses", "F", "loaded balls"),
    Row("capacitance_unloaded_F", "balls without load", "F"),
    Row("capacitance_total_F", "bearing", "F", "sum"),
)
PLATES = (
    Row("plates_factor", "bearing over plates", ""),
    Row("hertz_area_m2", "Hertz area, both raceways", None),
)
TOPICS = {
    "Operating point": (
        row("bearing"),
        row("lubricant"),
        Row("temperature_C", "temperature", "°C", "of the lubricant"),
        row("models"),
        row("load_N"),
        Row("axial_N", "axial load", "N"),
        row("clearance_m"),
        *GROOVES,
        row("rpm"),
        row("h_c_m", "largest inner load"),
        row("lambda", "largest inner load"),
        Row("surroundings", "surroundings", None),
    ),
    "Capacitance": (*PARTS, *PLATES),
    "Breakdown": (
        Row("threshold_V", "smallest voltage, smooth", "V", "field over h_c"),
        Row("threshold_peaks_V", "smallest voltage, rough", "V", "over h_c - 3 sigma", "bridged"),
        Row("threshold_azimuth_deg", "azimuth of that ball", "°"),
        Row("stored_energy_J", "energy of that discharge", "J", "smooth"),
        Row("field_V_m", "largest field, smooth", "V/m", "over h_c"),
        Row("field_peaks_V_m", "largest field, rough", "V/m", "over h_c - 3 sigma"),
        Row("metallic_contacts", "metallic contacts", "", "asperities carry over 1 %"),
    ),
    "Impedance": (
        Row("leak_ohm", "leak", "Ω", "direct current"),
        Row("frequency_Hz", "frequency", "Hz"),
        Row("impedance_ohm", "impedance", "Ω"),
        Row("phase_deg", "phase", "°"),
    ),
    "Motor": (Row("bearing_voltage_ratio", "bearing voltage ratio", "", "two such bearings"),),
    "Film from measured capacitance": (
        Row("measured_F", "measured", "F"),
        Row("measured_h_c_m", "central film thickness", "m", "from the whole model"),
        Row("measured_plates_m", "central film thickness", "m", "from the plates alone"),
    ),
}
COLUMNS = (  # columns of `curves`: key, heading, factor
    ("load_N", "load N", 1),
    ("axial_N", "axial N", 1),
    ("rpm", "rpm", 1),
    ("temperature_C", "T °C", 1),
    ("clearance_m", "P_d µm", 1e6),
    ("h_c_m", "h_c nm", 1e9),
    ("capacitance_F", "plates pF", 1e12),
    ("capacitance_surroundings_F", "around pF", 1e12),
    ("capacitance_unloaded_F", "unloaded pF", 1e12),
    ("capacitance_total_F", "all pF", 1e12),
    ("threshold_V", "smooth V", 1),
    ("threshold_peaks_V", "rough V", 1),
)


def shown(figures: Mapping[str, Any]) -> dict[str, Any]:
    """Return electrical results with the Hertz area in mm², angles with two decimals, and grooves
    that do not exist as None."""
    area = f"{1e6 * figures['hertz_area_m2']:.4g} mm²"
    found = dict.fromkeys(one.key for one in GROOVES) | dict(figures, hertz_area_m2=area)
    for key in ("threshold_azimuth_deg", "phase_deg"):
        found[key] = found[key] and round(found[key], 2) + 0.0
    return found


def table(result: Mapping[str, Any]) -> str:
    """Format the result of `figures` as text, with one block per topic and then one row per
    ball."""
    rows = [["ball", "azimuth, °", "Q inner", "C inner", "C outer", "C", "h inner", "threshold"]]
    for number, ball in enumerate(result["balls"], 1):
        rows.append(
            [
                str(number),
                f"{math.degrees(ball['azimuth_rad']):.1f}",
                *(
                    prefixed(ball[key], unit) if ball[key] else "-"
                    for key, unit in (
                        ("q_inner_N", "N"),
                        ("capacitance_inner_F", "F"),
                        ("capacitance_outer_F", "F"),
                        ("capacitance_F", "F"),
                        ("separation_inner_m", "m"),
                        ("threshold_V", "V"),
                    )
                ),
            ]
        )
    text = [*lines(shown(result), TOPICS), "", "Balls", *aligned(rows)]
    return "\n".join(text + warning_lines(result["warnings"]))


def curves(results: Sequence[Mapping[str, Any]]) -> str:
    """Format several results of `figures` as text, with one line per result."""
    return several(results, COLUMNS, optional=("axial_N",))
