# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to films and lubrication regimes in the runs. The printed eq 9 affects only
the central film thickness."""

import numpy as np

from raceway.arrays import Floats
from raceway.paper import passage, sensitivity
from raceway.paper.book import Book
from raceway.paper.figures.regime import PASSAGE, curves
from raceway.theory.bearing import INNER, OUTER


def at_passage(ratio: Floats, values: Floats) -> float:
    """Return the value at Lambda = 1, between the given values at increasing lambda ratios."""
    return np.exp(np.interp(0.0, np.log(ratio), np.log(values)))


def measure(book: Book, printed: bool) -> dict[str, float]:
    """Return {name: value}; see `quantities`."""
    b, oils, runs = book.bearing, book.oils, book.readings
    form, bound = "_printed" if printed else "", curves(book, printed)
    fast = runs.some("speeds" + form, lubricant="mineral", load=5000)[-1]
    every = [run.top(side, "h_c") for run in runs.all("speeds" + form) for side in (INNER, OUTER)]
    result = {
        "thickest": max(every),
        "h_inner": fast.top(INNER, "h_min"),
        "h_outer": fast.top(OUTER, "h_min"),
    }
    for name, rows in bound.items():
        oil, ratio = oils[name], rows["lambda"]
        rough = sensitivity.ranges(book)[name]["roughness"][1]
        result |= {
            f"lambda_least_{name}": ratio.min(),
            f"lambda_most_{name}": ratio.max(),
            f"passage_speed_{name}": at_passage(ratio, rows["entrainment_m_s"]),
            f"passage_capacitance_{name}": at_passage(ratio, rows["capacitance_F"]),
            f"roughness_bearing_{name}": passage.roughness(b, oil, 5000.0, PASSAGE, True, printed),
            f"roughness_ball_{name}": passage.roughness(b, oil, 5000.0, PASSAGE, False, printed),
            f"passage_rough_{name}": passage.capacitance(b, oil, 5000.0, rough, printed=printed),
        }
    first, second = (result[f"passage_capacitance_{name}"] for name in ("mineral", "pao48"))
    result |= {
        "passage_oils": second / first,
        "lambda_oils": (bound["mineral"]["lambda"] / bound["pao48"]["lambda"]).min(),
        "lambda_growth": min(np.diff(rows["lambda"]).min() for rows in bound.values()),
    }
    return result if printed else result | _same(runs, b, oils, result["roughness_bearing_mineral"])


def _same(runs, bearing, oils, roughness):
    heavy, light = (runs.some("speeds", lubricant="pao48", load=load) for load in (5000, 1000))
    soft, stiff = (
        runs.one("sensitivity", pressure_viscosity=xi).top(INNER, "h_min") for xi in (20e-9, 25e-9)
    )
    mineral, pao = oils["mineral"], oils["pao48"]
    return {
        "piezo_film": stiff / soft,
        "lambda_heavy_slow": heavy[0].top(INNER, "lambda"),
        "lambda_light_slow": light[0].top(INNER, "lambda"),
        "lambda_light_fast": light[-1].top(INNER, "lambda"),
        "friction_slow": heavy[0].top(INNER, "mu"),
        "friction_fast": light[-1].top(INNER, "mu"),
        "viscosity_ratio": mineral.viscosity / pao.viscosity,
        "pressure_viscosity_ratio": mineral.pressure_viscosity / pao.pressure_viscosity,
        "passage_60_speed": passage.speed(bearing, mineral, 5000.0, roughness),
    }
