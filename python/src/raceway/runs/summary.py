# SPDX-License-Identifier: GPL-2.0-or-later
"""The figures of a run: `summary` as a mapping, `table` as text.

The mapping's keys are a promise to scripts outside this package; add, never rename.
"""

import math
from collections.abc import Mapping
from typing import Any

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.rows import Row, lines
from raceway.runs.settings import LUBRICANT
from raceway.runs.tables import BALL, RunTables
from raceway.runs.totals import pairs
from raceway.theory import clearance, kinematics
from raceway.theory.bearing import INNER, OUTER

NAME = {INNER: "inner", OUTER: "outer"}
FILM = ("h_min_m", "h_c_m", "lambda", "capacitance_F", "capacitance_top_F")


TOPICS = {
    "Operating point": (
        Row("bearing", "bearing", None),
        Row("lubricant", "lubricant", None),
        Row("load_N", "radial load", "N", "as set"),
        Row("rpm", "inner ring speed", "rpm", "as set"),
        Row("clearance_m", "diametral clearance P_d", "m", "as set"),
        Row("viscosity_Pa_s", "viscosity", "Pa s", "eta of eq 6"),
        Row("pressure_viscosity_per_Pa", "pressure-viscosity coefficient", "1/GPa", "xi of eq 6"),
        Row("permittivity", "relative permittivity at rest", "", "eps_r of eq 10"),
        Row("roughness_m", "roughness", "m", "sigma of eq 7"),
    ),
    "Loads and pressures": (
        Row("ring_shift_m", "ring shift along the load", "m", "mean, delta_r of fig A.1"),
        Row("load_parameter", "load parameter", "", "1/2 (1 - P_d/(2 shift)), appendix A"),
        Row("q_max_N", "largest contact load", "N", "eq 2"),
        Row("q_inner_max_N", "  inner raceway", "N", "eq 2"),
        Row("q_outer_max_N", "  outer raceway", "N", "eq 2"),
        Row("p_max_inner_Pa", "Hertz pressure there, inner", "Pa", "1.5 Q/(pi a b)"),
        Row("p_max_outer_Pa", "Hertz pressure there, outer", "Pa", "1.5 Q/(pi a b)"),
        Row("loaded_balls_mean", "balls loaded on both raceways", "", "mean, N_l of eq 12"),
    ),
    "Film at the largest inner load": (
        Row("h_min_m", "smallest thickness", "m", "eq 6"),
        Row("h_c_m", "central thickness", "m", "eq 9"),
        Row("lambda", "lambda", "", "eq 7"),
    ),
    "Capacitance": (
        Row("capacitance_F", "bearing, mean", "F", "eq 12"),
        Row("capacitance_top_F", "largest of one ball", "F", "eqs 8, 10-12"),
    ),
    "Kinematics": (
        Row(
            "cage_speed_rad_s", "orbital speed of the balls", "rad/s", "mean of (x v_y - y v_x)/r^2"
        ),
        Row(
            "entrainment_speed_m_s", "entrainment at the largest load", "m/s", "U_r of eq 6, inner"
        ),
    ),
    "Cost": (
        Row("host", "host", None),
        Row("integrator", "integrator", None),
        Row("step_s", "mean time step", "s", "as run"),
        Row("passes", "ball passes measured", "", "as set"),
        Row("simulated_s", "simulated", "s", "measured passes"),
        Row("wall_s", "wall time", "s", "measured passes"),
        Row("real_time_factor", "real-time factor", "", "simulated/wall"),
    ),
}


def summary(tables: RunTables) -> dict[str, str | float | None]:
    """The figures of the run `tables` by name, SI units, text or numbers; None where the run has
    none.

    Reads the files once, in blocks: memory does not grow with the run. Raises `RunError` when the
    run has not finished, a file is broken or no ball ever touched a raceway.
    """
    tables.need_finished()
    settings = tables.settings
    result = {
        key: settings.get(key)
        for key in (
            "bearing",
            "lubricant",
            "host",
            "integrator",
            "load_N",
            "rpm",
            "clearance_m",
            "step_s",
            "passes",
        )
    }
    result.update({key: settings[key] if tables.lubricated else None for key in LUBRICANT})
    if tables.record:
        result.update(_of_record(tables))
    else:
        contacts = _Contacts(tables)
        result.update(_mechanics(tables, contacts))
        result["cage_speed_rad_s"] = _cage_speed(tables)
        result.update(_film(tables, contacts))
    result.update(
        wall_s=settings["wall_s"],
        simulated_s=settings["simulated_s"],
        real_time_factor=settings["simulated_s"] / settings["wall_s"],
    )
    return {key: _plain(value) for key, value in result.items()}


def ring_displacement(tables: RunTables) -> Floats:
    """Displacement of the inner ring along the load in m, one value a sample."""
    azimuth = tables.settings["load_azimuth_rad"]
    return (
        tables.rings["x"] * math.cos(azimuth) + tables.rings["y"] * math.sin(azimuth)
    ).to_numpy()


def _of_record(tables):
    """The figures of a record: its sums and extremes over the bearing have them."""
    table = tables.totals
    for name in NAME.values():
        if not table[f"load_{name}"].max() > 0:
            raise RunError(
                f"{tables.source['contacts']}: no ball touches the {name} raceway in any sample"
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
    return result


class _Contacts:
    """What the figures need of the contacts."""

    def __init__(self, tables):
        self.top = {}  # raceway: row of the contact with the largest load
        self.samples = self.pairs = 0
        self.total = self.best = (
            None  # capacitance of all pairs and of the best, F; None without the column
        )
        for block in tables.blocks("contacts"):
            self._add(block)
        for side, name in NAME.items():
            if side not in self.top:
                raise RunError(
                    f"{tables.source['contacts']}: no ball touches the {name} raceway in any sample"
                )

    def _add(self, block):
        for side in NAME:
            loads = block.loc[block["raceway"] == side, "load"]
            if len(loads) and (side not in self.top or loads.max() > self.top[side]["load"]):
                self.top[side] = block.loc[loads.idxmax()]
        both = pairs(block)
        self.samples += block.attrs["samples"]
        self.pairs += len(both)
        if "capacitance" in block:
            self.total = (self.total or 0.0) + both["capacitance"].sum()
            self.best = max(self.best or 0.0, both["capacitance"].max() if len(both) else 0.0)


def _displacement(tables):
    # LAMMPS prints the start of the window as well, LIGGGHTS does not
    shift = ring_displacement(tables)[tables.rings["sample"] > 0].mean()
    play = tables.settings["clearance_m"]
    return {
        "ring_shift_m": shift,
        "load_parameter": clearance.load_parameter(play, shift) if shift else None,
    }


def _mechanics(tables, contacts):
    result = _displacement(tables)
    result["q_max_N"] = max(top["load"] for top in contacts.top.values())
    for side, name in NAME.items():
        result[f"q_{name}_max_N"] = contacts.top[side]["load"]
    for side, name in NAME.items():
        result[f"p_max_{name}_Pa"] = contacts.top[side]["pressure"]
    result["loaded_balls_mean"] = contacts.pairs / contacts.samples
    return result


def _cage_speed(tables):
    ring, total, count = tables.settings["outer_ring"], 0.0, 0
    for balls in tables.blocks("balls"):
        rings = balls.loc[balls["id"] == ring].set_index("sample")
        rolling = balls[balls["type"] == BALL]
        if rings.empty or rolling.empty:
            raise RunError(
                f"{tables.source['balls']} has no "
                f"{'atom ' + str(ring) if rings.empty else 'ball (type 1)'}"
            )
        axis = rings.loc[rolling["sample"], ["x", "y", "vx", "vy"]].to_numpy()
        relative = rolling[["x", "y", "vx", "vy"]].to_numpy() - axis
        total += kinematics.orbital_speed(*relative.T).sum()
        count += len(rolling)
    return total / count


def _film(tables, contacts):
    top, result = contacts.top[INNER], dict.fromkeys(("entrainment_speed_m_s", *FILM))
    result["entrainment_speed_m_s"] = top.get("entrainment")
    if not tables.lubricated:
        return result
    for key, column in (("h_min_m", "h_min"), ("h_c_m", "h_c"), ("lambda", "lambda")):
        result[key] = top.get(column)
    if contacts.best is not None:
        result["capacitance_F"] = contacts.total / contacts.samples
        result["capacitance_top_F"] = contacts.best
    return result


def _plain(value):
    """Something JSON has: text, a finite float, or None."""
    if value is None or isinstance(value, str):
        return value
    return float(value) if math.isfinite(value) else None


def table(figures: Mapping[str, Any]) -> str:
    """The mapping of `summary` as text, a topic a block; figures the run has none of are left
    out."""
    return "\n".join(lines(figures, TOPICS))
