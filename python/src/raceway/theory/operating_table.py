# SPDX-License-Identifier: GPL-2.0-or-later
"""Text tables of the results of `operating_point`."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from raceway.rows import GROOVES, Row, aligned, lines, row, several, warning_lines
from raceway.sweeps import variable_table
from raceway.theory import models
from raceway.units import prefixed

LOSSES = (
    Row("loss_rolling_W", "hydrodynamic rolling", "W", "Biboulet-Houpert"),
    Row("loss_slip_W", "differential slip", "W", "Heathcote"),
    Row("loss_spin_W", "spin", "W"),
    Row("loss_hysteresis_W", "hysteresis", "W"),
    Row("loss_drag_W", "drag of the balls", "W"),
    Row("loss_cage_W", "cage", "W", "oil in its pockets, churning, friction"),
)
TOPICS = {
    "Operating point": (
        row("bearing"),
        row("lubricant"),
        Row("temperature_C", "temperature", "°C", "of the lubricant"),
        row("models"),
        row("load_N", "along x"),
        Row("axial_N", "axial load", "N", "along z"),
        Row("moment_x_N_m", "moment about x", "N m"),
        Row("moment_y_N_m", "moment about y", "N m"),
        row("clearance_m"),
        *GROOVES,
        row("rpm"),
        Row("orbital_speed_rad_s", "cage speed", "rad/s", "rolling, Harris ch. 10"),
        Row("sliding_orbit_rad_s", "cage speed", "rad/s", "balance of the balls with friction"),
        Row("ball_radial_rad_s", "rotation of a ball, radial", "rad/s", "the same balance"),
        Row("ball_along_rad_s", "rotation of a ball, along its path", "rad/s", "the same balance"),
        Row("ball_axial_rad_s", "rotation of a ball, axial", "rad/s", "the same balance"),
        Row("ball_excursion_m", "excursion of balls in the cage", "m", "free, from contact angles"),
        Row("pocket_force_N", "largest pocket force, about", "N", "traction of restrained balls"),
        Row("centrifugal_N", "centrifugal load of a ball", "N", "m r omega^2"),
    ),
    "Inner ring": (
        Row("shift_x_m", "displacement along x", "m", "Harris ch. 7"),
        Row("shift_y_m", "displacement along y", "m", "Harris ch. 7"),
        row("shift_z_m", "from the middle, Harris ch. 7"),
        row("tilt_x_rad", "Harris ch. 7"),
        row("tilt_y_rad", "Harris ch. 7"),
        row("load_parameter"),
        Row("stiffness_x_N_m", "stiffness along x", "N/m", "the others held"),
        Row("stiffness_z_N_m", "stiffness along z", "N/m", "the others held"),
        Row("stiffness_ry_N_m_rad", "tilting stiffness about y", "N m/rad", "the others held"),
    ),
    "Restraint of the ring": (
        Row("support_x_N", "force along x", "N"),
        Row("support_y_N", "force along y", "N"),
        Row("support_z_N", "force along z", "N", "held: no axial load, or --hold"),
        Row("support_rx_N_m", "moment about x", "N m"),
        Row("support_ry_N_m", "moment about y", "N m"),
    ),
    "Loads and pressures": (
        Row("loaded_balls", "balls loaded on both raceways", "", "N_l of eq 12"),
        row("q_inner_max_N"),
        row("q_outer_max_N"),
        row("p_max_inner_Pa"),
        row("p_max_outer_Pa"),
        Row("angle_max_rad", "largest contact angle", "deg", "of balls above 1 % of that load"),
    ),
    "Rating life": (
        Row("static_safety", "static safety", "", "(4.2 GPa/p)^3, ISO 76"),
        Row("equivalent_load_basic_N", "equivalent load X F_r + Y F_a", "N", "ISO 281, unchecked"),
        Row("life_L10_Mrev", "basic life, 10^6 turns", "", "ISO 281, (C/P)^3"),
        Row("life_L10_h", "basic life, hours", "", "90 % survive"),
        Row("equivalent_load_N", "equivalent load", "N", "ISO/TS 16281"),
        Row("life_reference_Mrev", "reference life, 10^6 turns", "", "ISO/TS 16281"),
        Row("life_reference_h", "reference life, hours", "", "90 % survive"),
        Row("viscosity_ratio", "viscosity ratio kappa", "", "ISO 281"),
        Row("life_factor", "life modification factor", "", "a_ISO of ISO 281"),
        Row("life_modified_h", "modified reference life, hours", "", "a_ISO L_10r"),
        Row("minimum_load_N", "minimum radial load", "N", "SKF's k_r, formula from memory"),
    ),
    "Damping of the ring": (
        Row("damping_x_N_s_m", "damping along x", "N s/m", "slow motion, the others held"),
        Row("damping_z_N_s_m", "damping along z", "N s/m", "slow motion, the others held"),
        Row("damping_law", "law of the contacts", None),
    ),
    "Film at the largest inner load": (
        row("viscosity_Pa_s"),
        row("entrainment_speed_m_s", "U_r of eq 6"),
        row("h_min_m"),
        row("h_c_m"),
        row("lambda"),
        Row("film_factor", "factor of inlet shear", "", "Murch-Wilson"),
        Row("asperity_share", "load share of asperities", "", "Clarke"),
    ),
    "Friction torque": (
        Row("friction_torque_N_m", "of the inner ring", "N m", "power over speed"),
        Row("torque_skf_N_m", "SKF, oil to the middle of a ball", "N m", "10000 EN 2013"),
        Row("torque_palmgren_N_m", "Palmgren, oil bath", "N m"),
        *LOSSES,
        Row("gyroscopic_friction", "friction coefficient needed", "", "against gyroscopic sliding"),
    ),
    "Capacitance": (row("capacitance_F"), row("capacitance_top_F")),
}
CURVES = (  # columns of the table for several points: key, heading, scale
    ("load_N", "load N", 1),
    ("axial_N", "axial N", 1),
    ("rpm", "rpm", 1),
    ("temperature_C", "T °C", 1),
    ("clearance_m", "P_d µm", 1e6),
    ("shift_x_m", "x µm", 1e6),
    ("shift_z_m", "z µm", 1e6),
    ("q_max_N", "Q max N", 1),
    ("h_min_m", "h_min nm", 1e9),
    ("lambda", "lambda", 1),
    ("friction_torque_N_m", "torque N mm", 1e3),
    ("capacitance_F", "plates pF", 1e12),
)
COLUMNS = (  # columns of the table of balls: key, heading, SI unit
    ("azimuth_rad", "azimuth, °", "deg"),
    ("q_inner_N", "Q inner", "N"),
    ("q_outer_N", "Q outer", "N"),
    ("angle_inner_rad", "angle in., °", "deg"),
    ("angle_outer_rad", "angle out., °", "deg"),
    ("p_inner_Pa", "p inner", "Pa"),
    ("p_outer_Pa", "p outer", "Pa"),
    ("h_min_inner_m", "h_min in.", "m"),
    ("lambda_inner", "lambda in.", ""),
    ("h_min_outer_m", "h_min out.", "m"),
    ("lambda_outer", "lambda out.", ""),
    ("capacitance_F", "C", "F"),
)
CONTACT_COLUMNS = (  # columns of the table of contacts if the rings have several grooves
    ("azimuth_rad", "azimuth, °", "deg"),
    ("raceway", "contact", None),
    ("q_N", "Q", "N"),
    ("angle_rad", "angle, °", "deg"),
    ("p_Pa", "p", "Pa"),
    ("h_min_m", "h_min", "m"),
    ("lambda", "lambda", ""),
    ("capacitance_F", "C", "F"),
)


def curves(results: Sequence[Mapping[str, Any]]) -> str:
    """Format several results of `figures` as text, with one line per result."""
    return several(results, CURVES)


def table(result: Mapping[str, Any]) -> str:
    """Format the result of `figures` as text, with one block per topic and then one row per
    ball."""
    filled = {row.key: result.get(row.key) for rows in TOPICS.values() for row in rows}
    filled.update({key: why for key, why in result["absent"].items() if key in models.HEADLINES})
    filled.update({f"loss_{part}_W": loss for part, loss in (result["losses_W"] or {}).items()})
    for axis in "xy":  # the moment on a tilt that is held is the one that holds it
        if filled[f"support_r{axis}_N_m"] is not None:
            filled[f"moment_{axis}_N_m"] = None
    if not filled["rpm"]:
        filled.update(orbital_speed_rad_s=None, centrifugal_N=None)
    if filled["ball_axial_rad_s"] is not None:
        filled.update(sliding_orbit_rad_s=filled["orbital_speed_rad_s"], orbital_speed_rad_s=None)
    block = _table_of_balls(result["balls"])
    spans = result.get("ranges", {})
    ranges = {key: (span["low"], span["high"]) for key, span in spans.items()}
    text = [*lines(filled, TOPICS, ranges=ranges), "", "Balls", *block]
    if assumed := result.get("assumed_data"):
        text += variable_table.block(assumed)
    return "\n".join(text + warning_lines(result["warnings"]))


def _table_of_balls(balls):
    """Return one row per ball or, if the rings have several grooves, one row per loaded contact."""
    if "contacts" in balls[0]:
        columns = CONTACT_COLUMNS
        found = [
            (str(number), ball | one)
            for number, ball in enumerate(balls, 1)
            for one in ball["contacts"]
            if one["q_N"] > 0
        ]
    else:
        columns = COLUMNS
        found = [(str(number), ball) for number, ball in enumerate(balls, 1)]
    shown = [column for column in columns if found and found[0][1].get(column[0]) is not None]
    rows = [["ball", *(heading for _, heading, _ in shown)]]
    for number, one in found:
        rows.append([number, *(_cell(one[key], unit) for key, _, unit in shown)])
    return aligned(rows)


def _cell(value, unit):
    if unit is None:
        return value
    if unit == "deg":
        return f"{math.degrees(value) + 0.0:.3f}"
    return prefixed(value, unit) if value else "-"
