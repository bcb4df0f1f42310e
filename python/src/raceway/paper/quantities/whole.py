# SPDX-License-Identifier: GPL-2.0-or-later
"""The quantities of figs 8 to 12 computed from total capacitances instead of those of the plates,
and the capacitances of the gap around the plates and of unloaded balls."""

import numpy as np
from scipy.optimize import brentq

from raceway.paper import passage, sensitivity, whole
from raceway.paper.book import Book
from raceway.paper.figures.regime import PASSAGE, curves
from raceway.paper.quantities import capacitance, formulas
from raceway.paper.quantities.oil import at_passage
from raceway.paper.reading import Reading

SPEED, LOAD = sensitivity.SPEED, sensitivity.LOAD
TOTAL = capacitance.Kind(
    Reading.whole_top_capacitance, Reading.whole_capacitance, Reading.whole_ball_capacitance
)


def measure(book: Book) -> dict[str, float]:
    """Return {name: value}, computed with the corrected formulas."""
    filling = book.readings.filling("6208")
    return (
        capacitance.of_runs(book, "", TOTAL)
        | _around(book)
        | capacitance.one_ball(book, TOTAL)
        | capacitance.of_oils(book, lambda oil: whole.ball(book.bearing, oil, LOAD, SPEED, filling))
        | _passage(book, filling)
    )


def _around(book):
    """Return the capacitances outside the plates."""
    more = {
        run.given["load"]: run.whole_top_capacitance() - run.top_capacitance()
        for run in book.readings.all("loads")
    }
    rings, _ = formulas.measure(book, printed=False)["ring_to_ring"]
    run = book.readings.one("loads", load=5000)
    return {
        "around_1": more[1000],
        "around_5": more[5000],
        "around_7": more[7000],
        "around_and_rings": np.mean(list(more.values())) + rings,
        "idle_ball": run.whole_ball_capacitance()[1].min(),
        "bearing_more": run.whole_capacitance() - run.figures["capacitance_F"],
    }


def _passage(book, filling):
    """Return quantities at Lambda = 1, and at the capacitance at which the paper's regime
    changes."""
    b, result, least = book.bearing, {}, []
    for name, rows in curves(book).items():
        runs = book.readings.some("speeds", lubricant=name, load=5000)
        value = [run.whole_capacitance() for run in runs]
        least.append(min(value))
        result[f"passage_capacitance_{name}"] = at_passage(rows["lambda"], value)

        def missing(log, oil=book.oils[name]):
            speed = passage.speed(b, oil, LOAD, np.exp(log))
            return whole.ball(b, oil, LOAD, speed, filling) - PASSAGE

        log = brentq(missing, np.log(1e-8), np.log(1e-5), xtol=1e-6)
        result[f"roughness_ball_{name}"] = np.exp(log)
    first, second = (result[f"passage_capacitance_{name}"] for name in ("mineral", "pao48"))
    return result | {"passage_oils": second / first, "bearing_least": min(least)}
