# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of single balls at an operating point, SI."""

from typing import Any

import numpy as np

from raceway.theory import four_point
from raceway.theory.lubrication import Lubrication
from raceway.theory.static import Equilibrium


def balls(state: Equilibrium, films: Lubrication | None) -> list[dict[str, Any]]:
    """A mapping a ball: loads, angles, pressures and axes, with `films` (or None) these, too."""
    columns = {"azimuth_rad": state.azimuth}
    for name, side in (("inner", state.inner), ("outer", state.outer)):
        live = side.load > 0
        columns[f"q_{name}_N"] = side.load
        columns[f"angle_{name}_rad"] = np.where(live, side.angle, 0.0)
        columns[f"p_{name}_Pa"], columns[f"a_{name}_m"], columns[f"b_{name}_m"] = (
            side.pressure,
            side.a,
            side.b,
        )
    if films is not None:
        for name, side in (("inner", films.inner), ("outer", films.outer)):
            columns[f"h_min_{name}_m"], columns[f"h_c_{name}_m"], columns[f"lambda_{name}"] = (
                side.h_min,
                side.h_c,
                side.ratio,
            )
        columns["capacitance_F"] = films.ball
    return [
        {key: float(values[ball]) for key, values in columns.items()}
        for ball in range(len(state.azimuth))
    ]


def balls_in_grooves(state: Equilibrium, films: Lubrication | None) -> list[dict[str, Any]]:
    """With two grooves a ring: a mapping a ball, with a list of `contacts`."""
    films = (None, None, None) if films is None else films
    found = []
    for ball, azimuth in enumerate(state.azimuth):
        one = {"azimuth_rad": float(azimuth)}
        if films[2] is not None:
            one["capacitance_F"] = float(films[2][ball])
        one["contacts"] = [
            _contact(name, (groove, ball), side, film)
            for names, side, film in zip(four_point.NAMES, (state.inner, state.outer), films)
            for groove, name in enumerate(names)
        ]
        found.append(one)
    return found


def _contact(name, place, side, film):
    values = {
        "q_N": side.load,
        "angle_rad": side.angle,
        "p_Pa": side.pressure,
        "a_m": side.a,
        "b_m": side.b,
    }
    if film is not None:
        values |= {
            "h_min_m": film.h_min,
            "h_c_m": film.h_c,
            "lambda": film.ratio,
            "capacitance_F": film.capacitance,
        }
    return {"raceway": name} | {key: float(value[place]) for key, value in values.items()}
