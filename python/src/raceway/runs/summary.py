# SPDX-License-Identifier: GPL-2.0-or-later
"""Summary of the results of a run: `summary` returns a dict, which `table` formats as text.

The keys are a public interface for scripts: keys may be added, but must never be renamed.
"""

import json
import math
from typing import Any

import numpy as np

from raceway.arrays import Floats, mean
from raceway.errors import RunError
from raceway.runs import warming
from raceway.runs.cage import cage_figures, cage_ranges
from raceway.runs.flaws import by_part
from raceway.runs.friction import STILL as RESTING
from raceway.runs.friction import friction
from raceway.runs.measured import load_parameter, loading, measured
from raceway.runs.model_range import Range, model_ranges
from raceway.runs.rating import rating
from raceway.runs.settings import LUBRICANT
from raceway.runs.settling import settling
from raceway.runs.summary_table import NAME, PERIODIC
from raceway.runs.summary_table import TOPICS as TOPICS
from raceway.runs.summary_table import reasons as reasons
from raceway.runs.summary_table import shown as shown
from raceway.runs.summary_table import table as table
from raceway.runs.tables import RunTables
from raceway.theory import makers, models
from raceway.theory.bearing import OUTER
from raceway.theory.validity import Shoulders, doubts, held, past_shoulder

LOOKS = 1000  # number of samples checked for contact patches that extend beyond the shoulder
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
            "bearing lubricant host integrator models temperature_C load_N rpm clearance_m"
            " step_s passes"
        ).split()
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
    for key in ("load_parameter", *makers.KEYS):
        if isinstance(why := result[key], str):
            result["absent"][key] = why
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
    sample = tables.ring_columns["sample"]
    if not (sample > 0).any():
        count = len(sample)
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
            said = tables.total_columns[f"load_{name}"][first - tables.first : stop - tables.first]
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
    ratio = tables.total_columns.get("lambda")
    thinnest = None if ratio is None else np.fmin.reduce(ratio)
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
    return _along_load(tables, tables.ring_columns["x"], tables.ring_columns["y"])


def _along_load(tables, x, y):
    azimuth = tables.settings["load_azimuth_rad"]
    return x * math.cos(azimuth) + y * math.sin(azimuth)


def _of_bearing(tables):
    """Return the results that follow from sums and extremes over the bearing."""
    table = tables.total_columns
    most = {name: float(np.fmax.reduce(values)) for name, values in table.items()}
    for name in NAME.values():
        if not most[f"load_{name}"] > 0:
            raise RunError(
                f"{tables.record.path}: no ball touches the {name} raceway in any sample"
            )
    top = {name: values[table["load_inner"].argmax()] for name, values in table.items()}
    result = _displacement(tables)
    result["q_max_N"] = max(most[f"load_{name}"] for name in NAME.values())
    for name in NAME.values():
        result[f"q_{name}_max_N"] = most[f"load_{name}"]
    for name in NAME.values():
        result[f"p_max_{name}_Pa"] = most[f"pressure_{name}"]
    result["loaded_balls_mean"] = mean(table["loaded_balls"])
    result["cage_speed_rad_s"] = mean(table["cage_speed"])
    result["entrainment_speed_m_s"] = top["entrainment_top"]
    for key, column in (("h_min_m", "h_min"), ("h_c_m", "h_c"), ("lambda", "lambda")):
        result[key] = top.get(f"{column}_top")
    result["capacitance_F"] = mean(table["capacitance"]) if "capacitance" in table else None
    result["capacitance_top_F"] = most.get("capacitance_top")
    whole = table.get("capacitance_total")
    result["capacitance_total_F"] = None if whole is None else mean(whole)
    return result


def _displacement(tables):
    """Displacement of the inner ring relative to the outer ring, which a load or a soft housing may
    also displace."""
    later = slice(tables.first == 0, None)
    shift = ring_displacement(tables)[later].mean()
    outer = tables.record.fixed("ring_raceway") == OUTER
    if outer.any():
        moved = tables.record.read(["ring_x", "ring_y"], tables.first, tables.last)
        x, y = (moved[f"ring_{axis}"][:, outer][:, 0] for axis in "xy")
        shift -= _along_load(tables, x, y)[later].mean()
    return {"ring_shift_m": shift, "load_parameter": load_parameter(tables, shift)}


def _plain(value):
    """Convert `value` for JSON to text, a finite float, None, or a dict of these."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    return float(value) if math.isfinite(value) else None
