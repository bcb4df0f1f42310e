# SPDX-License-Identifier: GPL-2.0-or-later
"""Displacement, support, stiffness and damping of the ring of a bearing at one operating point, and
its contact loads, with the keys of `operating_point`."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from raceway.inputs import Oil
from raceway.theory import clearance, ring_response
from raceway.theory.bearing import Bearing
from raceway.theory.lubrication import Lubrication
from raceway.theory.small_motion import response
from raceway.theory.static import FREEDOMS, Equilibrium

SUPPORT = ("support_x_N", "support_y_N", "support_z_N", "support_rx_N_m", "support_ry_N_m")


def displacement(
    state: Equilibrium,
    load: float,
    axial: float,
    moment: ArrayLike,
    held: Mapping[str, float],
    play: float,
    reach: float,
) -> dict[str, Any]:
    """Return the displacement of the ring, the forces that support it where it is `held`, and its
    stiffness. Loads are in N, `moment` is in N m, and `play`, the diametral clearance, and `reach`,
    the radius of the pitch circle, are in m."""
    result = dict(zip(("shift_x_m", "shift_y_m", "shift_z_m"), _rounded(state.shift)))
    result.update(zip(("tilt_x_rad", "tilt_y_rad"), _rounded(state.tilt)))
    radial = load and not (result["shift_z_m"] or result["tilt_x_rad"] or result["tilt_y_rad"])
    moved = radial and result["shift_x_m"]
    result["load_parameter"] = clearance.load_parameter(play, state.shift[0]) if moved else None
    support = -np.array([load, 0.0, axial, *moment]) - [*state.force, *state.moment[:2]]
    rounding = 1e-9 * state.inner.load.sum() * np.array([1, 1, 1, reach, reach])
    support[np.abs(support) <= rounding] = 0.0
    for key, name, value in zip(SUPPORT, FREEDOMS, support):
        result[key] = value if name in held else None
    result.update(
        stiffness_x_N_m=state.stiffness[0, 0],
        stiffness_z_N_m=state.stiffness[2, 2],
        stiffness_ry_N_m_rad=state.stiffness[4, 4],
        stiffness=state.stiffness.tolist(),
        residual_N=state.residual,
    )
    return result


def damping(
    body: Bearing, state: Equilibrium, films: Lubrication, oil: Oil, models: str, play: float
) -> dict[str, Any]:
    """Return the damping of the ring, for the diametral clearance `play` in m."""
    beside = ring_response.dampers(body, state, films, oil, models, clearance=play)
    matrix = response(state.linear, beside.damping).damping
    return dict(
        damping_x_N_s_m=matrix[0, 0],
        damping_z_N_s_m=matrix[2, 2],
        damping=matrix.tolist(),
        damping_law=ring_response.LAWS[models],
    )


def loads(state: Equilibrium) -> dict[str, Any]:
    """Return the largest loads, pressures and contact angle."""
    live = np.logical_and(
        *(np.atleast_2d(one.load > 0).any(0) for one in (state.inner, state.outer))
    )
    angles = np.abs(np.concatenate([one.angle[one.heavy] for one in (state.inner, state.outer)]))
    return dict(
        loaded_balls=int(live.sum()),
        q_max_N=max(state.inner.load.max(), state.outer.load.max()),
        q_inner_max_N=state.inner.load.max(),
        q_outer_max_N=state.outer.load.max(),
        p_max_inner_Pa=state.inner.pressure.max(),
        p_max_outer_Pa=state.outer.pressure.max(),
        angle_max_rad=angles.max() if len(angles) else 0.0,
    )


def _rounded(values):
    """Set values below 1e-9 of the largest value to zero, because by symmetry they are rounding
    errors."""
    return np.where(np.abs(values) > 1e-9 * np.abs(values).max(), values, 0.0)
