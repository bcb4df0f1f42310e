# SPDX-License-Identifier: GPL-2.0-or-later
"""Damping by the film of a rolling contact, modelled as a Maxwell branch in parallel with the Hertz
spring.

The model is the linear response of a steady EHL line contact, applied to an elliptical contact:
df/dt = k_m d(delta)/dt - f/tau, F_n = max(0, Q + f), k_m = 0.44 k h_c/delta_H, tau = 1.33 b/u. Its
error is 10 to 30 % for omega b/u below 1.2. Functions accept numbers or arrays of equal shape in SI
units.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws


class Branch(NamedTuple):
    """A spring and a dashpot in series."""

    stiffness: Numbers  # k_m, N/m
    time: Numbers  # tau, s; infinite at zero speed


def branch(k: Numbers, h_c: Numbers, elastic: Numbers, b: Numbers, speed: Numbers) -> Branch:
    """Return the `Branch` of a contact with slope k = 1.5 Q/delta_H in N/m; h_c, `elastic` =
    delta_H and the semi-axis b along rolling are in m, and u is in m/s.

    The ratio h_c/delta_H is limited to 1, because the fit applies to thin films.
    """
    stiffness, rate = laws.film_branch(k, h_c, elastic, b, np.abs(speed))
    with np.errstate(divide="ignore"):
        return Branch(stiffness, 1 / rate)


def advance(
    force: Numbers, branch: Branch, approach: Numbers, step: Numbers
) -> tuple[Numbers, Numbers]:
    """Return the force f in N after `step` in s at a constant `approach` d(delta)/dt in m/s, and
    its derivative with respect to the approach in N s/m. The solution is exact."""
    left, slope = laws.film_branch_step(branch.stiffness, 1 / branch.time, step, False)
    return left * force + slope * approach, slope
