# SPDX-License-Identifier: GPL-2.0-or-later
"""Fraction L_a of the contact load carried by asperities, as a function of the lambda ratio Lambda.

The predictions differ considerably between laws: L_a is 0.26 to 0.67 at Lambda = 0.30, and 0.05 to
0.17 at Lambda = 1.41.
"""

from raceway.arrays import Numbers
from raceway.core import laws

CONDUCTS = 0.01  # if L_a is larger, a contact conducts instead of acting as a capacitor


def zhou_hoeprich(ratio: Numbers) -> Numbers:
    """Return L_a = exp(-2.1 Lambda^0.85) for a composite roughness of 0.1 um (Zhou and Hoeprich
    1991, in Schwarz et al., Lubricants 2023, 11, 369)."""
    return laws.asperity_share(ratio, 2.1, 0.85)


def olver_spikes(ratio: Numbers) -> Numbers:
    """Return L_a = 1/(1 + Lambda)^2 (Olver and Spikes 1998; from memory, unchecked)."""
    return 1 / (1 + ratio) ** 2


def clarke(ratio: Numbers) -> Numbers:
    """Return L_a = 1 - erf(Lambda) (Clarke et al. 2016), accurate to 1.5e-7. It is used if
    `models` is full."""
    return laws.complementary_error(ratio)
