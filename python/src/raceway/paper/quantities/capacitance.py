# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to the capacitances in the runs."""

from collections.abc import Callable

import numpy as np

from raceway.arrays import Floats
from raceway.paper import sensitivity, theory
from raceway.paper.book import Book
from raceway.paper.quantity import Quantity
from raceway.paper.reading import GRID, Reading, gridded
from raceway.theory.bearing import INNER
from raceway.theory.capacitance import VACUUM

OfRun = Callable[[Reading], float]
# a ball on the load line and the bearing, as in the paper
PLATES = (Reading.top_capacitance, lambda run: run.figures["capacitance_F"])


def measure(book: Book, printed: bool) -> dict[str, Quantity]:
    """Return {name: `Quantity`}; see `quantities`."""
    form = "_printed" if printed else ""
    result = of_runs(book, form, *PLATES)
    return result if printed else result | _same(book, curves(book, form, *PLATES))


def of_runs(book: Book, form: str, top: OfRun, mean: OfRun) -> dict[str, Quantity]:
    """Return the quantities of figs 8, 10 and 11.

    `top` returns the capacitance in F of a ball on the load line for a run, and `mean` that of the
    bearing; `form` is the suffix of the names of the sets of runs.
    """
    runs = book.readings
    by_load = {run.given["load"]: top(run) for run in runs.all("loads" + form)}
    loads, tops = np.array(list(by_load)), np.array(list(by_load.values()))
    result = {
        "top_1": Quantity(by_load[1000], "F", "one ball at ψ = 0, 1 kN"),
        "top_5": Quantity(by_load[5000], "F", "5 kN"),
        "top_7": Quantity(by_load[7000], "F", "7 kN"),
        "load_step": Quantity(np.diff(tops).min(), "F", "smallest increase per kN"),
        "load_power": Quantity(
            np.polyfit(np.log(loads), np.log(tops), 1)[0], "", "exponent of the load"
        ),
        "ring_mean": Quantity(
            mean(runs.one("loads" + form, load=5000)),
            "F",
            "bearing, 5 kN, 0.41 m/s",
        ),
    }
    curve = curves(book, form, top, mean)
    speed, tops, _, _ = curve["mineral", 5000]
    slopes = np.diff(tops) / np.diff(speed)
    over = [curve["pao48", load][1] / curve["mineral", load][1] for load in (1000, 5000)]
    result |= {
        "speed_step": Quantity(
            max(np.diff(rows[1]).max() for rows in curve.values()),
            "F",
            "largest change between successive speeds (all decrease)",
        ),
        "slow_slope": Quantity(
            -slopes[0], "F s/m", "decrease per m/s from 0.02 to 0.05 m/s, mineral, 5 kN"
        ),
        "fast_slope": Quantity(-slopes[-1], "F s/m", "from 1.0 to 1.2 m/s"),
        "slow_share": Quantity(
            slopes[0] / slopes[-1], "", "ratio of the slopes at low and high speed"
        ),
        "load_ratio": Quantity(
            min((curve[oil, 5000][1] / curve[oil, 1000][1]).min() for oil in book.oils),
            "",
            "smallest ratio of 5 kN to 1 kN",
        ),
        "pao_least": Quantity(
            min(one.min() for one in over), "", "smallest ratio of PAO to mineral"
        ),
        "pao_most": Quantity(max(one.max() for one in over), "", "largest"),
    }
    for load in (1000, 5000):
        _, _, value, thick = curve["mineral", load]
        result[f"film_power_{load}"] = Quantity(
            np.polyfit(np.log(thick), np.log(value), 1)[0],
            "",
            f"exponent of $h_{{min}}$ at {load // 1000} kN",
        )
    result["collapse"] = Quantity(
        _collapse(book, curve), "%", "largest difference between the oils at the same $h_{min}$"
    )
    return result


def curves(book: Book, form: str, top: OfRun, mean: OfRun) -> dict[tuple[str, int], Floats]:
    """Return {(oil, load): array (4, speeds)} for the runs of fig 10 in SI units.

    The rows are the entrainment speed, the capacitance of a ball on the load line, the capacitance
    of the bearing, and the smallest film thickness on the load line.
    """
    curve = {
        (oil, load): [
            (run.given["entrainment"], top(run), mean(run), run.top(INNER, "h_min"))
            for run in book.readings.some("speeds" + form, lubricant=oil, load=load)
        ]
        for oil in book.oils
        for load in (1000, 5000)
    }
    return {key: np.array(rows).T for key, rows in curve.items()}


def _collapse(book, curve):
    """Return the relative difference of C/eps_r between the oils at equal film thickness and 5 kN,
    in the range in which both oils have films."""
    lines = {
        oil: (
            np.log(curve[oil, 5000][3]),
            np.log(curve[oil, 5000][2] / book.oils[oil].permittivity),
        )
        for oil in book.oils
    }
    (x, y), (u, v) = lines["mineral"], lines["pao48"]
    inside = (x >= u.min()) & (x <= u.max())
    return float(np.abs(np.expm1(y[inside] - np.interp(x[inside], u, v))).max())


def _same(book, curve):
    runs, b = book.readings, book.bearing
    run = runs.one("loads", load=5000)
    psi, value = run.ball_capacitance()
    around = gridded(psi, value)
    area = np.pi * run.around(INNER, "a")[1] * run.around(INNER, "b")[1]
    plates = (
        run.around(INNER, "capacitance")[1]
        * run.around(INNER, "h_c")[1]
        / (
            VACUUM
            * theory.contact(
                b, book.oils["mineral"], INNER, run.around(INNER, "load")[1], 0.41
            ).permittivity
            * area
        )
    )
    # All balls in one pass form the curve against azimuth; other balls form its mirror image.
    mirrored = np.abs(around - around[::-1]).max() / around.max()
    other = {
        load: runs.one("measured_bearing", load=load).top_capacitance() for load in (1000, 5000)
    }
    pair = [
        runs.one("speeds", lubricant=oil, load=5000, entrainment=0.41)
        for oil in ("pao48", "mineral")
    ]
    oils = {
        run.given["lubricant"]: theory.contact(
            b, book.oils[run.given["lubricant"]], INNER, run.top(INNER, "load"), 0.41
        )
        for run in pair
    }
    low, high = sensitivity.oils_ratio(book, "pao48", "mineral")
    swept = [
        (run, book.oils[run.given["lubricant"]], float(run.given["load"]), run.given["entrainment"])
        for run in runs.all("speeds")
    ]
    tops = [
        run.top_capacitance() / float(theory.ball(b, oil, theory.largest_load(b, load), speed)) - 1
        for run, oil, load, speed in swept
    ]
    means = [
        run.figures["capacitance_F"] / theory.bearing_capacitance(b, oil, load, speed) - 1
        for run, oil, load, speed in swept
    ]
    return {
        "theory_ball": Quantity(
            np.abs(tops).max(), "%", "one ball at ψ = 0, largest deviation from static theory"
        ),
        "theory_bearing": Quantity(
            np.abs(means).max(), "%", "bearing, largest deviation from static theory"
        ),
        "pao_low": Quantity(
            low, "", "over the plausible ranges of both oils at 5 kN, 0.41 m/s: from"
        ),
        "viscosity_power": Quantity(
            sensitivity.power(book, "viscosity"), "", "exponent of the viscosity in C"
        ),
        "permittivity_power": Quantity(
            sensitivity.power(book, "permittivity"), "", "of the permittivity"
        ),
        "pao_high": Quantity(high, "", "to"),
        "plates": Quantity(
            np.abs(plates - 1).max(), "%", "largest deviation of $C h_c/(ε_0 ε_r π a b)$ from one"
        ),
        "mirror": Quantity(
            mirrored, "%", "deviation of one ball's curve from its mirror image from other balls"
        ),
        "loaded_zone": Quantity(
            np.abs(psi[value > 0]).max(), "°", "largest |ψ| with capacitance, no clearance"
        ),
        "top_place": Quantity(
            abs(GRID[around.argmax()]), "°", "azimuth of the largest capacitance"
        ),
        "other_bearing_1": Quantity(
            other[1000] / curve["mineral", 1000][1][5], "", "6306 over 6208, 1 kN, 0.41 m/s"
        ),
        "other_bearing_5": Quantity(
            other[5000] / curve["mineral", 5000][1][5], "", "6306 over 6208, 5 kN, 0.41 m/s"
        ),
        "from_permittivity": Quantity(
            oils["pao48"].permittivity / oils["mineral"].permittivity,
            "",
            "PAO over mineral from $ε_r$",
        ),
        "from_film": Quantity(oils["mineral"].h_c / oils["pao48"].h_c, "", "from the thinner film"),
        "background_share": Quantity(
            30e-12 / curve["mineral", 5000][1][5], "%", "30 pF over one ball at 5 kN, 0.41 m/s"
        ),
        "background_share_light": Quantity(30e-12 / curve["mineral", 1000][1][5], "%", "at 1 kN"),
    }
