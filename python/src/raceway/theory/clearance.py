# SPDX-License-Identifier: GPL-2.0-or-later
"""Effects of the diametral clearance P_d on a bearing (eqs A.2-A.4 and the load parameter)."""

import numpy as np

from raceway.arrays import Numbers
from raceway.theory.bearing import Bearing


def load_parameter(clearance: Numbers, shift: Numbers) -> Numbers:
    """Return the load parameter epsilon = (1 - P_d/(2 delta_r))/2 for lengths in m (appendix A).
    Raises `ValueError` if the shift is zero."""
    if np.any(np.asarray(shift) == 0):
        raise ValueError("the load parameter of a ring that has not moved is undefined")
    return (1 - clearance / (2 * shift)) / 2


def groove_distance(bearing: Bearing) -> float:
    """Return the distance C = r_ci + r_co - D in m between the centres of curvature of the grooves
    (eq A.2)."""
    return bearing.inner_groove + bearing.outer_groove - bearing.ball_diameter


def free_contact_angle(bearing: Bearing, clearance: Numbers) -> Numbers:
    """Return alpha_0 = acos(1 - P_d/(2C)) in rad (eq A.3). Raises `ValueError` unless 0 <= P_d <=
    2C."""
    cosine = 1 - np.asarray(clearance) / (2 * groove_distance(bearing))
    if not np.all((cosine >= 0) & (cosine <= 1)):
        raise ValueError(
            f"clearance = {clearance} m has no free contact angle: it must lie between 0 and "
            f"{2 * groove_distance(bearing)} m"
        )
    return np.arccos(cosine)[()]


def free_endplay(bearing: Bearing, clearance: Numbers) -> Numbers:
    """Return the endplay P_e = 2C sin(alpha_0) in m, from one axial stop to the other (eq A.4)."""
    return 2 * groove_distance(bearing) * np.sin(free_contact_angle(bearing, clearance))
