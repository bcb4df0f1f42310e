# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to the motion of balls and cage, which the printed formulas do not affect."""

import numpy as np

from raceway.paper.book import Book
from raceway.paper.quantities.formulas import CAGE_BALL
from raceway.theory import kinematics


def measure(book: Book, printed: bool) -> dict[str, float | tuple[float, float]]:
    """Return {name: value}; see `quantities`. The orders of lines of rolling balls are part of the
    labels."""
    if printed:
        return {}
    run, b = book.readings.one("pressure"), book.bearing
    shaft, orders = 477.5 * np.pi / 30, kinematics.frequencies(b)
    cage = run.figures["cage_speed_rad_s"] / shaft
    spin = run.spin() / shaft + cage  # spin of a ball relative to the cage
    return {
        "ftf": (cage / orders.cage - 1, orders.cage),
        "bpfo": (b.balls * cage / orders.outer - 1, orders.outer),
        "bpfi": (b.balls * (1 - cage) / orders.inner - 1, orders.inner),
        "bsf": (spin / orders.spin - 1, orders.spin),
        "cage_contact": run.cage_contact_share(b.ball_radius, CAGE_BALL),
        "coulomb": run.coulomb_use(),
        "entrainment_run": run.figures["entrainment_speed_m_s"],
    }
