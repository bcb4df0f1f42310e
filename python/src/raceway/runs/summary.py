# SPDX-License-Identifier: GPL-2.0-or-later
"""Summary of the results of a run: `summary` returns a dict, and `table` formats it as text.

The keys are a public interface for scripts: keys may be added, but must never be renamed.
"""

import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.rows import Row, lines, row, warning_lines
from raceway.runs import warming
from raceway.runs.cage import CageFigures, cage_figures, cage_ranges
from raceway.runs.columns import BEARING, LOSSES
from raceway.runs.flaws import by_part
from raceway.runs.friction import STILL as RESTING
from raceway.runs.friction import friction
from raceway.runs.measured import load_parameter, loading, measured
from raceway.runs.model_range import Range, model_ranges
from raceway.runs.rating import ROWS as RATING
from raceway.runs.rating import rating
from raceway.runs.settings import LUBRICANT
from raceway.runs.settling import ORBIT, settling
from raceway.runs.tables import RunTables
from raceway.sweeps import variable_table
from raceway.theory import models
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.validity import Shoulders, doubts, held, past_shoulder

NAME = {INNER: "inner", OUTER: "outer"}


TOPICS = {
    "Operating point": (
        row("bearing"),
        row("lubricant"),
        row("load_N", "as set, or measured"),
        Row("rpm", "speed of inner relative to outer", "rpm", "as set, or measured"),
        Row("rpm_inner", "  inner ring", "rpm", "mean"),
        Row("rpm_outer", "  outer ring", "rpm", "mean"),
        Row("rpm_least", "  lowest", "rpm"),
        Row("rpm_most", "  highest", "rpm"),
        row("clearance_m", "as set"),
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
        row("shift_z_m", "mean"),
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
        row("capacitance_F", "mean, eq 12"),
        row("capacitance_top_F"),
        Row("capacitance_total_F", "including surroundings", "F", "mean"),
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
    "Settling, estimated change in all further ball passes": (
        Row("settled_torque", "friction torque", "", "relative"),
        Row("settled_load", "largest loads", "", "larger value of both raceways"),
        Row("settled_cage_speed", "cage speed", ""),
        Row("settled_spin_axis_rad", "spin axis of the balls", "rad", "load-weighted mean"),
        Row(ORBIT, "orbit of the cage", "", "latest change, relative to half the play"),
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
LOOKS = 1000  # number of samples checked for contact patches that extend beyond the shoulder
# of a run with `settle orbit`
PERIODIC = tuple(
    f"orbit{name}"
    for name in (
        *("", "_passes", "_stability", "_multiplier", "_multiplier_error", "_multiplier_limit"),
        "_multipliers",
    )
)
CHECK = "check.json"  # in the run's folder, written by `raceway check`


def summary(tables: RunTables) -> dict[str, Any]:
    """Return the results of the run `tables` as text or numbers in SI units, keyed by name.

    Results that the run does not have are None. `absent` maps keys to the reason why the models or
    the state of the run do not provide the result. `warnings` is a list of texts about absent
    results and about values outside the range of validity (`theory.validity`).

    The record is read in blocks; the memory grows by one row of numbers per sample. Raise
    `RunError` if the run has not finished, if the record is broken, if there is no sample after the
    start, or if there is no contact in any sample.
    """
    tables.need_finished()
    _need_window(tables)
    _need_agreement(tables)
    settings = tables.settings
    result = {
        key: settings.get(key)
        for key in (
            "bearing",
            "lubricant",
            "host",
            "integrator",
            "models",
            "temperature_C",
            "load_N",
            "rpm",
            "clearance_m",
            "step_s",
            "passes",
        )
    }
    result.update({key: settings[key] if tables.lubricated else None for key in LUBRICANT})
    result.update(_of_bearing(tables))
    result.update(
        wall_s=settings["wall_s"],
        simulated_s=settings["simulated_s"],
        real_time_factor=settings["simulated_s"] / settings["wall_s"],
        processor_s=settings.get("processor_s"),
        evaluations=settings.get("evaluations"),
        **measured(tables),
        **friction(tables),
        **settling(tables),
        **rating(tables),
    )
    result = {key: _plain(value) for key, value in result.items()}
    result["absent"] = models.absent(result["models"], result)
    if isinstance(why := result["load_parameter"], str):
        result["absent"]["load_parameter"] = why
    result.update(dict.fromkeys(result["absent"]))
    result["warnings"] = _warnings(tables, result)
    if (cage := cage_figures(tables)) is not None:
        result |= {key: _plain(value) for key, value in cage._asdict().items()}
    ranges = model_ranges(tables, result)
    ranges |= {key: Range(*one) for key, one in cage_ranges(tables, result).items()}
    result["model_ranges"] = {key: one._asdict() for key, one in ranges.items()} or None
    result |= warming.figures(tables)
    if assumed := str(settings.get("assumed_data") or ""):
        pairs = (word.split("=", 1) for word in assumed.split(","))
        result["assumed_data"] = {name: float(value) for name, value in pairs}
    result |= {key: settings[key] for key in PERIODIC if key in settings}
    if flaws := by_part(settings):
        result["flaws"] = flaws
    if errors := numerical_errors(tables):
        result["numerical_errors"] = errors
    return result


def _need_window(tables):
    count = len(tables.rings)
    if not (tables.rings["sample"] > 0).any():
        raise RunError(
            f"{tables.record.path} has {count} sample{'s' * (count != 1)}: results are means over"
            " the samples after the start, but there are none"
        )


def _need_agreement(tables):
    """Check that the largest loads of the bearing agree with the loads of its contacts.

    A record with checksums does not need this check.
    """
    record = tables.record
    if record.checked or "load" not in record.contact_columns:
        return
    grooves = len(record.raceways) // 2
    for first, stop in record.blocks(tables.first, tables.last):
        read = record.read(["load"], first, stop)["load"]
        for raceway, name in NAME.items():
            own = read[:, raceway * grooves : (raceway + 1) * grooves].max(axis=(1, 2))
            said = tables.totals[f"load_{name}"].loc[first : stop - 1].to_numpy()
            if len(wrong := np.flatnonzero(~np.isclose(own, said, rtol=1e-6, atol=0))):
                raise RunError(
                    f"{record.path} is damaged: in sample {first + wrong[0] + 1} the largest load"
                    f" on the {name} raceway is {own[wrong[0]]:g} N according to the contacts, but"
                    f" {said[wrong[0]]:g} N according to the bearing"
                )


def identity(tables: RunTables) -> list[float]:
    """Return the fingerprint of a run: wall time, time step and simulated time."""
    return [tables.settings[key] for key in ("wall_s", "step_s", "simulated_s")]


def numerical_errors(tables: RunTables) -> dict[str, float]:
    """Return {key: error in the unit of the result} for a run that `raceway check` has repeated.

    An error is the sum of the changes due to finer integration, more samples and longer settling.
    For other runs the dict is empty.
    """
    try:
        found = json.loads((tables.folder / CHECK).read_text())
        if found["run"] != identity(tables):  # the file belongs to an earlier run in this folder
            return {}
        return {key: sum(parts.values()) for key, parts in found["errors"].items()}
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise RunError(
            f"{tables.folder / CHECK} is not a result of raceway check: {error}"
        ) from None


def _warnings(tables, figures):
    thinnest = tables.totals["lambda"].min() if "lambda" in tables.totals else None
    return doubts(
        {
            "pressure": max(figures["p_max_inner_Pa"], figures["p_max_outer_Pa"]),
            "lambda": figures["lambda"],
            "conducts": None if figures["capacitance_F"] is None else thinnest,
        }
    ) + [
        *_past_shoulder(tables),
        *_held(tables, figures),
        *_still(figures),
        *_left_out(figures["absent"]),
    ]


def _held(tables, figures):
    """Return the warning about a ring held along its axis, for runs that record the axial load."""
    load, axial = loading(tables), tables.settings.get("axial_N")
    if load is None or axial is None:
        return []
    return held(load.axial - axial, load.radial, figures["q_max_N"])


def _still(figures):
    if figures["power_loss_W"] is None or figures["friction_torque_N_m"] is not None:
        return []
    return [f"no friction torque: the relative speed of the rings is at most {RESTING:g} rad/s"]


def _left_out(absent):
    reasons = dict.fromkeys(why for key, why in absent.items() if key in models.LOSSES)
    return [
        f"friction torque and losses: {why}; models {models.DEFAULT} include them"
        for why in reasons
    ]


def _past_shoulder(tables):
    """Return warnings about contact patches that extend beyond a shoulder.

    They require a record with shoulder diameters and are based on at most `LOOKS` of its samples.
    """
    known = [tables.settings.get(f"{name}_shoulder_diameter_m") for name in NAME.values()]
    record, columns = tables.record, ("load", "angle", "a")
    if not any(known) or not set(columns) <= set(record.contact_columns):
        return []
    stop = tables.stop or len(record)
    some = slice(tables.first, stop, max(2, (stop - tables.first) // LOOKS))
    load, angle, a = (record.pick(name, (some, slice(None), slice(None))) for name in columns)
    live = [load[:, raceway] > 0 for raceway in (0, 1)]
    return past_shoulder(
        tables.geometry,
        Shoulders(*(diameter or math.nan for diameter in known)),
        tuple(angle[:, raceway][live[raceway]] for raceway in (0, 1)),
        tuple(a[:, raceway][live[raceway]] for raceway in (0, 1)),
    )


def ring_displacement(tables: RunTables) -> Floats:
    """Return the displacement of the inner ring along the load in m, with one value per sample."""
    return _along_load(tables, tables.rings["x"].to_numpy(), tables.rings["y"].to_numpy())


def _along_load(tables, x, y):
    azimuth = tables.settings["load_azimuth_rad"]
    return x * math.cos(azimuth) + y * math.sin(azimuth)


def _of_bearing(tables):
    """Return the results that follow from sums and extremes over the bearing."""
    table = tables.totals
    for name in NAME.values():
        if not table[f"load_{name}"].max() > 0:
            raise RunError(
                f"{tables.record.path}: no ball touches the {name} raceway in any sample"
            )
    top = table.loc[table["load_inner"].idxmax()]
    result = _displacement(tables)
    result["q_max_N"] = max(table[f"load_{name}"].max() for name in NAME.values())
    for name in NAME.values():
        result[f"q_{name}_max_N"] = table[f"load_{name}"].max()
    for name in NAME.values():
        result[f"p_max_{name}_Pa"] = table[f"pressure_{name}"].max()
    result["loaded_balls_mean"] = table["loaded_balls"].mean()
    result["cage_speed_rad_s"] = table["cage_speed"].mean()
    result["entrainment_speed_m_s"] = top["entrainment_top"]
    for key, column in (("h_min_m", "h_min"), ("h_c_m", "h_c"), ("lambda", "lambda")):
        result[key] = top.get(f"{column}_top")
    wet = "capacitance" in table
    result["capacitance_F"] = table["capacitance"].mean() if wet else None
    result["capacitance_top_F"] = table["capacitance_top"].max() if wet else None
    whole = table.get("capacitance_total")
    result["capacitance_total_F"] = None if whole is None else whole.mean()
    return result


def _displacement(tables):
    """Displacement of the inner ring relative to the outer ring, which a load or a soft housing may
    also displace."""
    later = tables.rings["sample"] > 0
    shift = ring_displacement(tables)[later].mean()
    outer = tables.record.fixed("ring_raceway") == OUTER
    if outer.any():
        moved = tables.record.read(["ring_x", "ring_y"], tables.first, tables.last)
        x, y = (moved[f"ring_{axis}"][:, outer][:, 0] for axis in "xy")
        shift -= _along_load(tables, x, y)[later].mean()
    return {
        "ring_shift_m": shift,
        "load_parameter": load_parameter(tables, shift),
    }


def _plain(value):
    """Convert `value` for JSON to text, a finite float, None, or a dict of these."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    return float(value) if math.isfinite(value) else None


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
    if key in ("rpm_least", "rpm_most", "rpm_top"):
        return figures["rpm_most"] - figures["rpm_least"] < STEADY * figures["rpm_most"]
    if key in ("rpm_inner", "rpm_outer"):
        return not figures["rpm_outer"]
    return False
