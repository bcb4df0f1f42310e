# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to loads, pressures and load parameters in the runs."""

import numpy as np

from raceway.paper import theory
from raceway.paper.book import Book
from raceway.paper.figures.free import measured
from raceway.paper.figures.loads import distribution_curves
from raceway.paper.reading import GRID, gridded
from raceway.theory import clearance, distribution
from raceway.theory.bearing import INNER, OUTER

SETS = {"distribution": (-45, 45), "clearances": (-35, -20, 0, 20, 35)}  # 1e4 P_d/D of the runs


def measure(book: Book, printed: bool) -> dict[str, float]:
    """Return {name: value}; see `quantities`."""
    form = "_printed" if printed else ""
    run = book.readings.one("pressure" + form)
    result = {
        "p_inner": run.top(INNER, "pressure"),
        "p_outer": run.top(OUTER, "pressure"),
        "shift": run.figures["ring_shift_m"],
    }
    for ratio, name in sorted((ratio, name) for name, some in SETS.items() for ratio in some):
        one = book.readings.one(name + form, clearance_ratio=ratio / 1e4)
        key = f"{'minus' if ratio < 0 else 'plus'}_{abs(ratio)}"
        result[f"epsilon_{key}"] = one.figures["load_parameter"]
        if abs(ratio) in (0, 35):
            balls = one.loaded_balls()
            result |= {
                f"loaded_{key}": balls.mean(),
                f"loaded_least_{key}": balls.min(),
                f"loaded_most_{key}": balls.max(),
            }
    return result if printed else result | _same(book, run)


def _same(book, run):
    b = book.bearing
    psi, rest, _ = theory.loads(b, 5000.0)
    order = np.argsort(psi, axis=None)
    seen = gridded(*run.around(INNER, "load"))
    away = np.abs(seen - np.interp(GRID, psi.flat[order], rest.flat[order], period=360))
    azimuth, load = run.around(INNER, "load")
    some = load > 0.01 * load.max()
    overlap = run.around(INNER, "overlap")[1]
    free, explicit = measured(book), book.readings.one("explicit").figures
    result = {
        "static_difference": away.max() / seen.max(),
        "hertz_power": np.polyfit(np.log(overlap[some]), np.log(load[some]), 1)[0],
        "stribeck_top": run.top(INNER, "load")
        * b.balls
        * distribution.radial_integral(0.5)
        / 5000.0,
        "top_azimuth": abs(azimuth[np.argmax(load)]),
        "explicit_load": abs(explicit["q_max_N"] / run.figures["q_max_N"] - 1),
        "explicit_capacitance": abs(explicit["capacitance_F"] / run.figures["capacitance_F"] - 1),
        "p_outer_unloaded": np.interp(180.0, *run.around(OUTER, "pressure")),
        "implicit_step": run.figures["step_s"],
        "explicit_step": explicit["step_s"],
        "angle_error": (free["angle_deg"] / free["angle_A3_deg"] - 1).abs().max(),
        "endplay_error": (free["endplay_m"] / free["endplay_A4_m"] - 1).abs().max(),
        "least_angle": free["angle_deg"].min(),
    }
    for key, gap in (("stiff", -25.2e-6), ("loose", 25.2e-6)):
        shift = distribution.shift(b, 5000.0, gap)
        result[f"epsilon_{key}_20"] = clearance.load_parameter(gap, shift)
    for ratio, _, simulated, formula, _ in distribution_curves(book):
        key = "zero" if ratio == 0 else "minus" if ratio < 0 else "plus"
        result[f"stribeck_{key}"] = np.abs(simulated - formula).max() / formula.max()
    return result
