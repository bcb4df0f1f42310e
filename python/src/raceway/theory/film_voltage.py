# SPDX-License-Identifier: GPL-2.0-or-later
"""Voltages across films: division of a voltage between two films, electric field in a film,
breakdown voltage, and energy of a discharge. Functions accept numbers or arrays of equal shape in
SI units.

A smooth thin film fails at 15 to 60 V/um (from memory, unchecked). In measurements, bearings first
fail at 1.5 to 6 V across two films (Lubricants 2024, 12, 1, table A1). This is far below the
strength of smooth films, because roughness reduces the local gap to the film thickness minus three
standard deviations of the roughness.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, Integers, Numbers
from raceway.theory.asperity import CONDUCTS

STRENGTH = 15e6  # V/m, lower end of the range for smooth thin films (from memory, unchecked)
PEAKS = 3.0  # local reduction of the film thickness, in standard deviations of the roughness
# A/m^2, limits for the peak current divided by the Hertz area (from memory, unchecked)
HARMLESS, HARMFUL = 0.1e6, 0.7e6
STATES = ("capacitive", "leaking", "metallic")


class Shares(NamedTuple):
    """A voltage across a ball, divided between its two films."""

    inner: Numbers  # V
    outer: Numbers


def divided(voltage: Numbers, inner: Numbers, outer: Numbers) -> Shares:
    """Divide a `voltage` between the rings according to the capacitances of the films: V_i = V
    C_o/(C_i + C_o). Raises `ValueError` unless both capacitances are positive.

    >>> [round(float(one), 6) for one in divided(3.0, 2e-10, 1e-10)]
    [1.0, 2.0]
    """
    inner, outer = _positive("capacitance", inner), _positive("capacitance", outer)
    return Shares(*(voltage * share for share in shares(inner, outer)))


def shares(inner: Numbers, outer: Numbers) -> Shares:
    """Return, for each film, the fraction of the voltage between the rings that drops across it,
    computed from the capacitances. Both fractions are zero if both films are open."""
    both = np.asarray(inner + outer, float)
    over = np.divide(1.0, both, out=np.zeros_like(both), where=both != 0)
    return Shares((outer * over)[()], (inner * over)[()])


def local_gap(separation: Numbers, roughness: float = 0.0, floor: float = 0.0) -> Numbers:
    """Return the local gap h - 3 sigma in m, or `floor` (m) where asperities touch."""
    return np.maximum(separation - PEAKS * roughness, floor)


def field(voltage: Numbers, gap: Numbers) -> Numbers:
    """Return the field in V/m for a `voltage` across a `gap` (m), which is the film thickness or a
    `local_gap`. The field has the sign of the voltage and is infinite if the gap is zero."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return (np.asarray(voltage, float) / np.asarray(gap, float))[()]


def ring_voltages(limits: tuple[Numbers, Numbers], inner: Numbers, outer: Numbers) -> Floats:
    """Return the voltages (2, ...) in V between the rings at which the inner and the outer film
    reach the voltages `limits`: V_i (C_i + C_o)/C_o and V_o (C_i + C_o)/C_i, where `inner` and
    `outer` are the capacitances. A result is infinite if there is no voltage across that film."""
    share = np.stack(shares(inner, outer))
    limit = np.stack([np.broadcast_to(one, share.shape[1:]) for one in limits])
    return np.divide(limit, share, out=np.full(share.shape, np.inf), where=share > 0)


class Threshold(NamedTuple):
    """The smallest voltage between the rings at which a film fails."""

    bearing: Numbers  # (...), V, threshold of the weakest ball
    ball: Floats  # (..., Z), V, threshold of each ball
    weakest: Integers  # (...), index of the weakest ball
    # (..., Z), film that fails first, 0 (inner) or 1 (outer); the other film fails next
    first: Integers


def threshold(
    separation: tuple[Numbers, Numbers],
    capacitance: tuple[Numbers, Numbers],
    strength: float = STRENGTH,
    roughness: float = 0.0,
) -> Threshold:
    """Compute the `Threshold` of a bearing from the gaps (m) and capacitances (F) of inner and
    outer films, which are arrays (..., Z). A film fails when the field in its local gap reaches
    `strength` (V/m).

    The threshold of a ball is the smaller of E h_i (C_i + C_o)/C_o and E h_o (C_i + C_o)/C_i; the
    threshold of the bearing is the minimum over all balls. Raises `ValueError` if a capacitance or
    the strength is not positive.

    >>> found = threshold(([1e-7], [2e-7]), ([2e-10], [1e-10]), 15e6)
    >>> round(float(found.bearing), 3), found.first.tolist()
    (4.5, [0])
    """
    _positive("strength", strength)
    inner, outer = (_positive("capacitance", one) for one in capacitance)
    limits = strength * local_gap(np.asarray(separation, float), roughness)
    own = ring_voltages(limits, inner, outer)
    ball = own.min(0)
    return Threshold(ball.min(-1), ball, ball.argmin(-1), own.argmin(0))


def stored_energy(capacitance: Numbers, voltage: Numbers) -> Numbers:
    """Return the energy C V^2/2 in J, all of which a discharge may dissipate. C includes the
    capacitances in parallel with the bearing."""
    return capacitance * np.square(voltage) / 2


def apparent_current_density(current: Numbers, area: Numbers) -> Numbers:
    """Return the peak `current` (A) divided by the Hertz area (m^2) of all contacts through which
    the current may flow, in A/m^2. Values up to 0.1 A/mm^2 are considered harmless, and values
    above 0.7 A/mm^2 harmful (from memory, unchecked)."""
    return current / _positive("area", area)


def states(asperity_share: Numbers, loss: Numbers = 0.0) -> Numbers:
    """Return indices into `STATES`. A contact is metallic if asperities carry more than `CONDUCTS`
    of the load. Otherwise it is leaking if `loss` = 1/(omega R C), the ratio of conduction current
    to displacement current, is above one.

    >>> states([0.0, 0.0, 0.3], [0.1, 5.0, 0.0]).tolist()
    [0, 1, 2]
    """
    return np.where(np.asarray(asperity_share) > CONDUCTS, 2, np.where(np.asarray(loss) > 1, 1, 0))[
        ()
    ]


def _positive(name, value):
    value = np.asarray(value, float)[()]
    if not np.all(value > 0):
        raise ValueError(f"{name} = {value} must be positive")
    return value
