# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to the motion of balls and cage, which the printed formulas do not affect."""

import numpy as np

from raceway.paper.book import Book
from raceway.paper.quantities.formulas import CAGE_BALL
from raceway.paper.quantity import Quantity
from raceway.theory import kinematics


def measure(book: Book, printed: bool) -> dict[str, Quantity]:
    """Return {name: `Quantity`}; see `quantities`."""
    if printed:
        return {}
    run, b = book.readings.one("pressure"), book.bearing
    shaft, orders = 477.5 * np.pi / 30, kinematics.frequencies(b)
    cage = run.figures["cage_speed_rad_s"] / shaft
    spin = run.spin() / shaft + cage  # spin of a ball relative to the cage
    return {
        "ftf": Quantity(cage / orders.cage - 1, "%", f"FTF relative to {orders.cage:.4f} orders"),
        "bpfo": Quantity(
            b.balls * cage / orders.outer - 1, "%", f"BPFO relative to {orders.outer:.4f}"
        ),
        "bpfi": Quantity(
            b.balls * (1 - cage) / orders.inner - 1, "%", f"BPFI relative to {orders.inner:.4f}"
        ),
        "bsf": Quantity(spin / orders.spin - 1, "%", f"BSF relative to {orders.spin:.4f}"),
        "cage_contact": Quantity(
            run.cage_contact_share(b.ball_radius, CAGE_BALL),
            "%",
            "neighbouring balls and cage balls in contact",
        ),
        "coulomb": Quantity(run.coulomb_use(), "", "largest friction over μ $F_n$"),
        "entrainment_run": Quantity(
            run.figures["entrainment_speed_m_s"], "m/s", "$U_r$ of the run at 477.5 rpm"
        ),
    }
