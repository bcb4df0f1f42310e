# SPDX-License-Identifier: GPL-2.0-or-later
"""The quantities of figs 8 to 12 computed from total capacitances instead of those of the plates,
and the capacitances of the gap around the plates and of unloaded balls."""

import numpy as np
from scipy.optimize import brentq

from raceway.paper import passage, sensitivity, whole
from raceway.paper.book import Book
from raceway.paper.figures.regime import PASSAGE, curves
from raceway.paper.quantities import capacitance, formulas
from raceway.paper.quantities.oil import SHORT
from raceway.paper.quantity import Quantity
from raceway.paper.reading import GRID, Reading, gridded

SPEED, LOAD = sensitivity.SPEED, sensitivity.LOAD


def measure(book: Book) -> dict[str, Quantity]:
    """Return {name: `Quantity`}, computed with the corrected formulas."""
    result = capacitance.of_runs(book, "", Reading.whole_top_capacitance, Reading.whole_capacitance)
    return result | _around(book) | _one_ball(book) | _oils(book) | _passage(book)


def _around(book):
    """Return the capacitances outside the plates."""
    runs = book.readings.all("loads")
    more = {run.given["load"]: run.whole_top_capacitance() - run.top_capacitance() for run in runs}
    rings = formulas.measure(book, printed=False)["ring_to_ring"].value
    run = book.readings.one("loads", load=5000)
    light, heavy = (
        book.readings.one("loads", load=load).whole_top_capacitance() for load in (1000, 5000)
    )
    return {
        "around_1": Quantity(more[1000], "F", "around the ellipses of a ball at ψ = 0, 1 kN"),
        "around_5": Quantity(more[5000], "F", "5 kN"),
        "around_7": Quantity(more[7000], "F", "7 kN"),
        "around_and_rings": Quantity(
            np.mean(list(more.values())) + rings, "F", "their mean plus ring to ring"
        ),
        "idle_ball": Quantity(
            run.whole_ball_capacitance()[1].min(), "F", "a ball opposite the load, 5 kN"
        ),
        "bearing_more": Quantity(
            run.whole_capacitance() - run.figures["capacitance_F"], "F", "bearing, over its plates"
        ),
        "background_share": Quantity(30e-12 / heavy, "%", "30 pF over one ball at 5 kN, 0.41 m/s"),
        "background_share_light": Quantity(30e-12 / light, "%", "at 1 kN"),
    }


def _one_ball(book):
    psi, value = book.readings.one("loads", load=5000).whole_ball_capacitance()
    around = gridded(psi, value)
    mirrored = np.abs(around - around[::-1]).max() / around.max()
    top = book.readings.one("loads", load=5000).whole_top_capacitance()
    light = book.readings.one("loads", load=1000).whole_top_capacitance()
    other = {
        load: book.readings.one("measured_bearing", load=load).whole_top_capacitance()
        for load in (1000, 5000)
    }
    return {
        "mirror": Quantity(
            mirrored, "%", "deviation of one ball's curve from its mirror image from other balls"
        ),
        "loaded_zone": Quantity(
            np.abs(psi[value > 0]).max(), "°", "largest |ψ| with capacitance, no clearance"
        ),
        "top_place": Quantity(
            abs(GRID[around.argmax()]), "°", "azimuth of the largest capacitance"
        ),
        "other_bearing_1": Quantity(other[1000] / light, "", "6306 over 6208, 1 kN, 0.41 m/s"),
        "other_bearing_5": Quantity(other[5000] / top, "", "6306 over 6208, 5 kN, 0.41 m/s"),
    }


def _oils(book):
    def ball(oil):
        return whole.ball(book.bearing, oil, LOAD, SPEED, book.readings.filling("6208"))

    low, high = sensitivity.oils_ratio(book, "pao48", "mineral", ball)
    return {
        "pao_low": Quantity(
            low, "", "over the plausible ranges of both oils at 5 kN, 0.41 m/s: from"
        ),
        "pao_high": Quantity(high, "", "to"),
        "viscosity_power": Quantity(
            sensitivity.power(book, "viscosity", ball), "", "exponent of the viscosity in C"
        ),
        "permittivity_power": Quantity(
            sensitivity.power(book, "permittivity", ball), "", "of the permittivity"
        ),
    }


def _passage(book):
    """Return quantities at Lambda = 1, and at the capacitance at which the paper's regime
    changes."""
    b, filling = book.bearing, book.readings.filling("6208")
    result, least = {}, []
    for name, rows in curves(book).items():
        runs = book.readings.some("speeds", lubricant=name, load=5000)
        value = [run.whole_capacitance() for run in runs]
        least.append(min(value))
        result[f"passage_capacitance_{name}"] = Quantity(
            np.exp(np.interp(0.0, np.log(rows["lambda"]), np.log(value))),
            "F",
            f"bearing at Λ = 1, {SHORT[name]}",
        )
        oil = book.oils[name]

        def missing(log, oil=oil):
            speed = passage.speed(b, oil, LOAD, np.exp(log))
            return whole.ball(b, oil, LOAD, speed, filling) - PASSAGE

        result[f"roughness_ball_{name}"] = Quantity(
            np.exp(brentq(missing, np.log(1e-8), np.log(1e-5), xtol=1e-6)),
            "m",
            f"corresponding roughness, {SHORT[name]}",
        )
    result["passage_oils"] = Quantity(
        result["passage_capacitance_pao48"].value / result["passage_capacitance_mineral"].value,
        "",
        "PAO over mineral at Λ = 1",
    )
    result["bearing_least"] = Quantity(min(least), "F", "least of the bearing, 5 kN, all speeds")
    return result
