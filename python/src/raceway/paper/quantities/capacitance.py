# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to the capacitances in the runs."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.inputs import Oil
from raceway.paper import sensitivity, theory
from raceway.paper.book import Book
from raceway.paper.reading import GRID, Reading, gridded
from raceway.theory.bearing import INNER


class Kind(NamedTuple):
    """A kind of capacitance, in F: of the plates alone, as in the paper, or the total."""

    top: Callable[[Reading], float]  # of a ball on the load line of a run
    mean: Callable[[Reading], float]  # of the bearing
    around: Callable[[Reading], tuple[Floats, Floats]]  # (psi in degrees, capacitance) of a ball


PLATES = Kind(
    Reading.top_capacitance, lambda run: run.figures["capacitance_F"], Reading.ball_capacitance
)


def measure(book: Book, printed: bool) -> dict[str, float]:
    """Return {name: value}; see `quantities`."""
    form = "_printed" if printed else ""
    result = of_runs(book, form, PLATES)
    if printed:
        return result
    return result | one_ball(book, PLATES) | of_oils(book, None) | _same(book)


def of_runs(book: Book, form: str, kind: Kind) -> dict[str, float]:
    """Return the quantities of figs 8, 10 and 11; `form` is the suffix of the names of the sets of
    runs."""
    runs = book.readings
    by_load = {run.given["load"]: kind.top(run) for run in runs.all("loads" + form)}
    loads, tops = np.array(list(by_load)), np.array(list(by_load.values()))
    curve = _curves(book, form, kind)
    speed, slow_to_fast, *_ = curve["mineral", 5000]
    slopes = np.diff(slow_to_fast) / np.diff(speed)
    over = [curve["pao48", load][1] / curve["mineral", load][1] for load in (1000, 5000)]
    powers = {
        f"film_power_{load}": np.polyfit(*np.log(curve["mineral", load][[3, 2]]), 1)[0]
        for load in (1000, 5000)
    }
    return {
        "top_1": by_load[1000],
        "top_5": by_load[5000],
        "top_7": by_load[7000],
        "load_step": np.diff(tops).min(),
        "load_power": np.polyfit(np.log(loads), np.log(tops), 1)[0],
        "ring_mean": kind.mean(runs.one("loads" + form, load=5000)),
        "speed_step": max(np.diff(rows[1]).max() for rows in curve.values()),
        "slow_slope": -slopes[0],
        "fast_slope": -slopes[-1],
        "slow_share": slopes[0] / slopes[-1],
        "load_ratio": min((curve[oil, 5000][1] / curve[oil, 1000][1]).min() for oil in book.oils),
        "pao_least": min(one.min() for one in over),
        "pao_most": max(one.max() for one in over),
        **powers,
        "collapse": _collapse(book, curve),
    }


def _curves(book, form, kind):
    """Return {(oil, load): array (4, speeds)} for the runs of fig 10 in SI units.

    The rows are the entrainment speed, the capacitance of a ball on the load line, the capacitance
    of the bearing, and the smallest film thickness on the load line.
    """
    curve = {
        (oil, load): [
            (run.given["entrainment"], kind.top(run), kind.mean(run), run.top(INNER, "h_min"))
            for run in book.readings.some("speeds" + form, lubricant=oil, load=load)
        ]
        for oil in book.oils
        for load in (1000, 5000)
    }
    return {key: np.array(rows).T for key, rows in curve.items()}


def _collapse(book, curve):
    """Return the relative difference of C/eps_r between the oils at equal film thickness and 5 kN,
    in the range in which both oils have films."""
    lines = [
        (np.log(curve[oil, 5000][3]), np.log(curve[oil, 5000][2] / book.oils[oil].permittivity))
        for oil in ("mineral", "pao48")
    ]
    (x, y), (u, v) = lines
    inside = (x >= u.min()) & (x <= u.max())
    return float(np.abs(np.expm1(y[inside] - np.interp(x[inside], u, v))).max())


def one_ball(book: Book, kind: Kind) -> dict[str, float]:
    """Return the quantities of one ball at 0.41 m/s around the ring, in another bearing, and
    relative to the background that the paper adds."""
    light, heavy = (
        book.readings.one("speeds", lubricant="mineral", load=load, entrainment=0.41)
        for load in (1000, 5000)
    )
    other = [book.readings.one("measured_bearing", load=load) for load in (1000, 5000)]
    psi, value = kind.around(book.readings.one("loads", load=5000))
    around = gridded(psi, value)
    return {
        # all balls in one pass form the curve against azimuth; other balls form its mirror image
        "mirror": np.abs(around - around[::-1]).max() / around.max(),
        "loaded_zone": np.abs(psi[value > 0]).max(),
        "top_place": abs(GRID[around.argmax()]),
        "other_bearing_1": kind.top(other[0]) / kind.top(light),
        "other_bearing_5": kind.top(other[1]) / kind.top(heavy),
        "background_share": 30e-12 / kind.top(heavy),
        "background_share_light": 30e-12 / kind.top(light),
    }


def of_oils(book: Book, ball: Callable[[Oil], float] | None) -> dict[str, float]:
    """Return the sensitivities to the data of the oils; `ball` is as in `sensitivity.power`."""
    low, high = sensitivity.oils_ratio(book, "pao48", "mineral", ball)
    return {
        "pao_low": low,
        "pao_high": high,
        "viscosity_power": sensitivity.power(book, "viscosity", ball),
        "permittivity_power": sensitivity.power(book, "permittivity", ball),
    }


def _same(book):
    runs, b = book.readings, book.bearing
    run = runs.one("loads", load=5000)
    load, mineral = run.around(INNER, "load")[1], book.oils["mineral"]
    eps = theory.contact(b, mineral, INNER, load, 0.41).permittivity
    tops, means = [], []
    for one in runs.all("speeds"):
        oil, radial = book.oils[one.given["lubricant"]], float(one.given["load"])
        point = b, oil, radial, one.given["entrainment"]
        top = theory.ball(b, oil, theory.largest_load(b, radial), one.given["entrainment"])
        tops.append(one.top_capacitance() / float(top) - 1)
        means.append(one.figures["capacitance_F"] / theory.bearing_capacitance(*point) - 1)
    films = {}
    for name, oil in book.oils.items():
        pair = runs.one("speeds", lubricant=name, load=5000, entrainment=0.41)
        films[name] = theory.contact(b, oil, INNER, pair.top(INNER, "load"), 0.41)
    return {
        "theory_ball": np.abs(tops).max(),
        "theory_bearing": np.abs(means).max(),
        "plates": np.abs(run.permittivity(INNER)[1] / eps - 1).max(),
        "from_permittivity": films["pao48"].permittivity / films["mineral"].permittivity,
        "from_film": films["mineral"].h_c / films["pao48"].h_c,
    }
