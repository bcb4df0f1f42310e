# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to loads, pressures and load parameters in the runs."""

import numpy as np

from raceway.paper import theory
from raceway.paper.book import Book
from raceway.paper.figures.free import measured
from raceway.paper.figures.loads import distribution_curves
from raceway.paper.quantity import Quantity
from raceway.paper.reading import GRID, gridded
from raceway.theory import clearance, distribution
from raceway.theory.bearing import INNER, OUTER


def measure(book: Book, printed: bool) -> dict[str, Quantity]:
    """Return {name: `Quantity`}; see `quantities`."""
    form = "_printed" if printed else ""
    run = book.readings.one("pressure" + form)
    result = {
        "p_inner": Quantity(run.top(INNER, "pressure"), "Pa", "inner pressure at ψ = 0"),
        "p_outer": Quantity(run.top(OUTER, "pressure"), "Pa", "outer pressure at ψ = 0"),
        "shift": Quantity(run.figures["ring_shift_m"], "m", "ring shift"),
    }
    for name, ratio in (
        ("distribution", -0.0045),
        ("clearances", -0.0035),
        ("clearances", -0.002),
        ("clearances", 0),
        ("clearances", 0.002),
        ("clearances", 0.0035),
        ("distribution", 0.0045),
    ):
        one = book.readings.one(name + form, clearance_ratio=ratio)
        key = f"{'minus' if ratio < 0 else 'plus'}_{abs(ratio) * 1e4:.0f}"
        result[f"epsilon_{key}"] = Quantity(one.figures["load_parameter"], "", "ε")
        if abs(ratio) in (0, 0.0035):
            balls, label = one.loaded_balls(), f"{ratio:g}".replace("-", "−")
            result[f"loaded_{key}"] = Quantity(
                balls.mean(), "", f"loaded balls at {label}, mean (out of 9)"
            )
            result[f"loaded_least_{key}"] = Quantity(balls.min(), "", "least")
            result[f"loaded_most_{key}"] = Quantity(balls.max(), "", "most")
    return result if printed else result | _same(book, run)


def _same(book, run):
    b = book.bearing
    psi, rest, _ = theory.loads(b, 5000.0)
    order = np.argsort(psi, axis=None)
    seen = gridded(*run.around(INNER, "load"))
    away = (
        np.abs(seen - np.interp(GRID, psi.flat[order], rest.flat[order], period=360)).max()
        / seen.max()
    )
    load, overlap = run.around(INNER, "load")[1], run.around(INNER, "overlap")[1]
    some = load > 0.01 * load.max()
    free = measured(book)
    explicit = book.readings.one("explicit")
    result = {
        "static_difference": Quantity(
            away, "%", "largest difference from static loads without a cage"
        ),
        "hertz_power": Quantity(
            np.polyfit(np.log(overlap[some]), np.log(load[some]), 1)[0],
            "",
            "exponent of the overlap",
        ),
        "stribeck_top": Quantity(
            run.top(INNER, "load") * b.balls * distribution.radial_integral(0.5) / 5000.0,
            "",
            "$Q_{max} Z J_r/F_r$ of the run",
        ),
        "top_azimuth": Quantity(
            abs(run.around(INNER, "load")[0][np.argmax(run.around(INNER, "load")[1])]),
            "°",
            "azimuth of the largest load",
        ),
        "explicit_load": Quantity(
            abs(explicit.figures["q_max_N"] / run.figures["q_max_N"] - 1),
            "%",
            "largest load, Verlet compared with implicit",
        ),
        "explicit_capacitance": Quantity(
            abs(explicit.figures["capacitance_F"] / run.figures["capacitance_F"] - 1),
            "%",
            "capacitance, Verlet compared with implicit",
        ),
        "p_outer_unloaded": Quantity(
            np.interp(180.0, *run.around(OUTER, "pressure")),
            "Pa",
            "outer pressure opposite the load",
        ),
        "implicit_step": Quantity(run.figures["step_s"], "s", "implicit step"),
        "explicit_step": Quantity(explicit.figures["step_s"], "s", "Verlet step"),
        "angle_error": Quantity(
            (free["angle_deg"] / free["angle_A3_deg"] - 1).abs().max(),
            "%",
            "largest difference from eq A.3",
        ),
        "endplay_error": Quantity(
            (free["endplay_m"] / free["endplay_A4_m"] - 1).abs().max(),
            "%",
            "largest difference from eq A.4",
        ),
        "least_angle": Quantity(free["angle_deg"].min(), "°", "smallest free contact angle"),
        "epsilon_stiff_20": Quantity(
            clearance.load_parameter(-25.2e-6, distribution.shift(b, 5000.0, -25.2e-6)),
            "",
            "ε from Stribeck-Harris",
        ),
        "epsilon_loose_20": Quantity(
            clearance.load_parameter(25.2e-6, distribution.shift(b, 5000.0, 25.2e-6)),
            "",
            "ε from Stribeck-Harris",
        ),
    }
    for ratio, _, simulated, formula, _ in distribution_curves(book):
        key = "zero" if ratio == 0 else "minus" if ratio < 0 else "plus"
        label = f"largest difference from eq A.1 over the largest load, {ratio:g}".replace("-", "−")
        result[f"stribeck_{key}"] = Quantity(
            np.abs(simulated - formula).max() / formula.max(), "%", label
        )
    return result
