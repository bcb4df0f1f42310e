# SPDX-License-Identifier: GPL-2.0-or-later
"""Results for individual balls at an operating point, in SI units."""

from typing import Any

import numpy as np

from raceway.theory.lubrication import Lubrication
from raceway.theory.static import Equilibrium


def balls(state: Equilibrium, films: Lubrication | None) -> list[dict[str, Any]]:
    """Return a list with one dict per ball, which contains loads, contact angles, pressures,
    semi-axes and, unless `films` is None, the films. If the rings have several grooves, each ball
    has a list of `contacts` instead, with the same key names as in a record."""
    found = [{"azimuth_rad": float(one)} for one in state.azimuth]
    if films is not None:
        for ball, value in zip(found, films.ball):
            ball["capacitance_F"] = float(value)
    wet = (None, None) if films is None else (films.inner, films.outer)
    if state.inner.load.ndim == state.outer.load.ndim == 1:
        for name, side, film in zip(("inner", "outer"), (state.inner, state.outer), wet):
            for key, values in _columns(side, film).items():
                symbol, _, unit = key.rpartition("_")
                named = f"{symbol}_{name}_{unit}" if symbol else f"{key}_{name}"
                for ball, value in zip(found, values):
                    ball[named] = float(value)
        return found
    for ball in found:
        ball["contacts"] = []
    for name, side, film in zip(("inner", "outer"), (state.inner, state.outer), wet):
        columns = {key: np.atleast_2d(value) for key, value in _columns(side, film).items()}
        if film is not None:
            columns["capacitance_F"] = np.atleast_2d(film.capacitance)
        for groove in range(len(columns["q_N"])):
            for k, ball in enumerate(found):
                values = {key: float(value[groove, k]) for key, value in columns.items()}
                ball["contacts"].append({"raceway": f"{name} {groove}"} | values)
    return found


def _columns(side, film):
    found = {
        "q_N": side.load,
        "angle_rad": np.where(side.load > 0, side.angle, 0.0),
        "p_Pa": side.pressure,
        "a_m": side.a,
        "b_m": side.b,
    }
    if film is not None:
        found |= {"h_min_m": film.h_min, "h_c_m": film.h_c, "lambda": film.ratio}
    return found
