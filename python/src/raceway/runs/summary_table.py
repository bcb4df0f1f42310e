# SPDX-License-Identifier: GPL-2.0-or-later
"""The summary of a run as text: its rows by topic, and what is too small to be shown."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from raceway.rows import Row, lines, row, warning_lines
from raceway.runs import warming
from raceway.runs.cage import CageFigures
from raceway.runs.columns import BEARING, LOSSES
from raceway.runs.rating import ROWS as RATING
from raceway.runs.settling import ORBIT
from raceway.sweeps import variable_table
from raceway.theory import models
from raceway.theory.bearing import INNER, OUTER

NAME = {INNER: "inner", OUTER: "outer"}

TOPICS = {
    "Operating point": (
        row("bearing"),
        row("lubricant"),
        Row("temperature_C", "temperature", "°C", "of the lubricant"),
        row("load_N", "as set, or measured"),
        Row("axial_N", "axial load", "N", "as set, or measured"),
        Row("rpm", "speed of inner relative to outer", "rpm", "as set, or measured"),
        Row("rpm_inner", "  inner ring", "rpm", "mean"),
        Row("rpm_outer", "  outer ring", "rpm", "mean"),
        Row("rpm_least", "  lowest", "rpm"),
        Row("rpm_most", "  highest", "rpm"),
        row("clearance_m", "as set, or from the contact angle"),
        row("viscosity_Pa_s"),
        row("pressure_viscosity_per_Pa"),
        row("permittivity"),
        row("roughness_m"),
        Row("flaw_inner", "flaws, inner raceway", None, "fix bearing/profile"),
        Row("flaw_outer", "flaws, outer raceway", None, "fix bearing/profile"),
        Row("flaw_ball", "flaws, balls", None, "fix bearing/profile"),
    ),
    "Inner ring, measured": (
        Row("force_x_N", "force of the balls along x", "N", "mean"),
        Row("force_y_N", "force of the balls along y", "N", "mean"),
        Row("force_z_N", "force of the balls along z", "N", "mean"),
        Row("ring_shift_m", "radial displacement", "m", "mean along the load, fig A.1"),
        row("shift_z_m", "mean, relative to the start"),
        row("tilt_x_rad", "mean"),
        row("tilt_y_rad", "mean"),
        row("load_parameter"),
    ),
    "Loads and pressures": (
        Row("q_max_N", "largest contact load", "N", "eq 2"),
        row("q_inner_max_N"),
        row("q_outer_max_N"),
        row("p_max_inner_Pa"),
        row("p_max_outer_Pa"),
        Row("loaded_balls_mean", "balls loaded on both raceways", "", "mean, N_l of eq 12"),
    ),
    "Rating life": RATING,
    "Film at the largest inner load": (
        Row("rpm_top", "at the speed", "rpm"),
        row("h_min_m"),
        row("h_c_m"),
        row("lambda"),
    ),
    "Capacitance": (
        row("capacitance_F", "contact ellipses, eq 12, mean"),
        row("capacitance_top_F"),
        Row("capacitance_total_F", "bearing", "F", "with surroundings of the ellipses, mean"),
    ),
    "Kinematics": (
        row("cage_speed_rad_s", "mean of (x v_y - y v_x)/r^2"),
        Row("cage_slip", "slip of the cage", "", "relative to rolling at contact angle 0"),
        Row("cage_slip_angle", "  due to contact angles", "", "rolling at these angles"),
        Row("cage_slip_groove", "  due to groove curvature", "", "Heathcote"),
        Row("cage_slip_play", "  due to pocket play", "", "remainder, with creep under drag"),
        Row("cage_orbit_m", "orbit of the cage", "m", "largest, from its mean position"),
        Row("cage_whirl", "whirl of the cage", None),
        Row("cage_whirl_order", "  speed relative to the cage", ""),
        Row("pocket_play_m", "play of the pockets", "m", "along the pitch circle"),
        Row("pocket_force_max_N", "largest pocket force", "N", "at ends of steps"),
        Row("pocket_force_mean_N", "mean pocket force", "N", "all balls, at ends of steps"),
        row("entrainment_speed_m_s", "U_r of eq 6, largest inner load"),
    ),
    "Friction torque": (
        Row("friction_torque_N_m", "of the inner ring", "N m", "power over speed"),
        Row("torque_skf_N_m", "SKF, oil to the middle of a ball", "N m", "10000 EN 2013"),
        Row("torque_palmgren_N_m", "Palmgren, oil bath", "N m"),
        Row("asperity_share", "load share of asperities", "", "largest inner load"),
        Row("power_loss_W", "power loss", "W", "mean"),
        *(
            Row(f"loss_{key}_W", BEARING[name].meaning.replace("power dissipated", " "), "W")
            for key, name in LOSSES.items()
        ),
    ),
    "Temperatures": warming.ROWS,
    "Settling": (
        Row("settled_torque", "friction torque, change", "", "last two ball passes, relative"),
        Row("remaining_torque", "  in all further ball passes", "", "estimated"),
        Row("settled_load", "largest loads, change", "", "larger value of both raceways"),
        Row("remaining_load", "  in all further ball passes", ""),
        Row("settled_cage_speed", "cage speed, change", ""),
        Row("remaining_cage_speed", "  in all further ball passes", ""),
        Row("settled_spin_axis_rad", "spin axis of the balls, change", "rad", "load-weighted mean"),
        Row("remaining_spin_axis_rad", "  in all further ball passes", "rad"),
        Row(ORBIT, "orbit of the cage, change", "", "relative to half the play"),
        Row("orbit", "periodic orbit", None, "settle orbit"),
        Row("orbit_stability", "  stability", None),
        Row("orbit_multiplier", "  left of a disturbance", "", "largest Floquet multiplier"),
        Row("orbit_multiplier_limit", "  left of a disturbance, at most", ""),
    ),
    "Cost": (
        Row("host", "host", None),
        Row("integrator", "integrator", None),
        row("models"),
        Row("step_s", "mean time step", "s", "as run"),
        Row("passes", "ball passes measured", "", "as set, or measured"),
        Row("simulated_s", "simulated", "s", "measured passes"),
        Row("wall_s", "wall time", "s", "measured passes"),
        Row("real_time_factor", "real-time factor", "", "simulated/wall"),
        Row("processor_s", "processor time", "s", "measured passes"),
        Row("evaluations", "evaluations of the forces", "", "measured passes"),
    ),
}
# Smaller values are rounding errors or ball-pass ripple and are not shown in the table.
# fractions of the largest force
SHOWN = dict.fromkeys(("force_x_N", "force_y_N", "force_z_N"), 1e-2)
STILL = dict.fromkeys(("shift_z_m", "tilt_x_rad", "tilt_y_rad"), 1e-9)  # m, rad
STEADY = 1e-3  # fraction of the speed by which a steady speed may vary
PERIODIC = (
    "orbit orbit_passes orbit_stability orbit_multiplier orbit_multiplier_error"
    " orbit_multiplier_limit orbit_multipliers"
).split()


def table(figures: Mapping[str, Any]) -> str:
    """Return the result of `summary` as text with one block per topic.

    Missing and negligible results are not shown. If `figures` contains results of
    `statics.statics`, they are shown in a separate column. Warnings come last.
    """
    ranges = figures.get("model_ranges") or {}
    text = lines(
        shown(figures),
        TOPICS,
        figures.get("numerical_errors"),
        {key: (one["low"], one["high"]) for key, one in ranges.items()},
        ("statics", figures["statics"]) if figures.get("statics") else None,
    )
    if why := figures.get("statics_absent"):
        text += ["", "Statics", f"  not available for this run: {why}"]
    if assumed := figures.get("assumed_data"):
        text += variable_table.block(assumed)
    if ranges:
        text += ["", "Known ranges of the model"]
        text += [f"  {one}" for one in reasons(figures)]
    return "\n".join(text + warning_lines(figures["warnings"]))


def reasons(figures: Mapping[str, Any]) -> list[str]:
    """Return the reasons for the ranges of the results, with one text for all results of a topic
    that have the same reason."""
    places = {
        row.key: (topic[0].lower() + topic[1:], row.label.strip())
        for topic, rows in TOPICS.items()
        for row in rows
    }
    by_reason: dict[tuple[str, str], list[str]] = {}
    for key, one in (figures.get("model_ranges") or {}).items():
        topic, label = places[key]
        by_reason.setdefault((topic, one["why"]), []).append(label)
    return [f"{', '.join(names)} ({topic}): {why}" for (topic, why), names in by_reason.items()]


def shown(figures: Mapping[str, Any]) -> dict[str, Any]:
    """Return the results with the keys of `TOPICS`; negligible results are None."""
    result = {key: None if _nothing(key, figures) else value for key, value in figures.items()}
    losses = figures["losses_W"] or dict.fromkeys(LOSSES)
    flaws = figures.get("flaws", {})
    return {
        **dict.fromkeys((*CageFigures._fields, ORBIT, *PERIODIC)),
        **dict.fromkeys(row.key for row in warming.ROWS),
        **result,
        **{key: why for key, why in figures["absent"].items() if key in models.HEADLINES},
        **{key: figures[key] and Path(figures[key]).name for key in ("bearing", "lubricant")},
        **{f"loss_{part}_W": loss or None for part, loss in losses.items()},
        **{f"flaw_{name}": flaws.get(name) for name in NAME.values()},
        "flaw_ball": "; ".join(f"{at}: {w}" for at, w in flaws.items() if at.startswith("ball"))
        or None,
    }


def _nothing(key, figures):
    value = figures[key]
    if value is None:
        return True
    if key in SHOWN:
        return abs(value) < SHOWN[key] * max(abs(figures[name] or 0.0) for name in SHOWN)
    if key in STILL:
        return abs(value) < STILL[key]
    if key == "axial_N":
        return not value
    if key == "temperature_C":  # not that of the films if temperatures follow from the losses
        return "temperature_oil_C" in figures
    if key in ("rpm_least", "rpm_most", "rpm_top"):
        return figures["rpm_most"] - figures["rpm_least"] < STEADY * figures["rpm_most"]
    if key in ("rpm_inner", "rpm_outer"):
        return not figures["rpm_outer"]
    return False
