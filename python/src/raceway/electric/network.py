# SPDX-License-Identifier: GPL-2.0-or-later
"""The voltages of a bearing's floating balls and of its inner ring over time
(docs/electric_circuit, Network).

The unknowns are the charges of every ball and of the inner ring. Resistances change them from point
to point; the integrator is the L-stable two-stage SDIRK method of second order. Without resistances
the charges are constant, and the voltages follow from them at every point separately
(src-package/core/electric/circuit.h).
"""

from typing import NamedTuple

import numpy as np

from raceway import core
from raceway.arrays import Floats
from raceway.electric.breakdown import ROW, Discharge, failure_of
from raceway.electric.films import Films
from raceway.electric.outer import Terms
from raceway.errors import RunError

ACCOUNT = (  # of each point: J, and C at last
    *("stored_energy", "source_work", "mechanical_work", "leak_heat", "resistor_heat"),
    *("discharge_energy", "energy_error", "charge_error"),
)
ROUNDING = 1e-12  # fraction of a film's charge; less on a ball is rounding


class Solution(NamedTuple):
    """n points; `before` is the state before a discharge at the same point."""

    ball_voltage: Floats  # (n, Z) V
    bearing_voltage: Floats  # (n,) V
    ball_voltage_before: Floats
    bearing_voltage_before: Floats
    ball_charge: Floats  # (n, Z) C, carried from point to point
    ring_charge: Floats  # (n,) C
    leaked: Floats  # (n, 2, Z) C through the conductance of each film in the step that ends here
    supplied: Floats  # (n,) C from the driving voltage through its conductance, likewise
    current: Floats  # (n,) A, mean into the inner ring's films in the step that ends here
    account: Floats  # (n, 8) of `ACCOUNT`
    discharges: dict[int, Discharge]  # by point


def solve(films: Films, terms: Terms, limit: Floats | None) -> Solution:
    """The network of `films` and the outer circuit `terms`; a film fails at `limit` (n, 2, Z) V,
    None: never.

    Balls start without charge. Raises `ValueError` for breakdown on a source without resistance,
    `RunError` where a ball with charge loses both films.
    """
    if limit is not None and terms.stiff:
        raise ValueError("breakdown would short a source without resistance: give it a resistance")
    made, work, rows = _run(films, terms, limit)
    solution = Solution(*made, _discharges(rows, work))
    _refuse_lost_charge(films, solution)
    return solution


def _run(films, terms, limit, most=4096):
    """(arrays of `Solution`, work of the driving voltage in discharges (n,), rows of failures)."""
    n, z = len(films.time), len(films.balls)
    shapes = dict(
        ball=(n, z),
        bearing=n,
        ball_before=(n, z),
        bearing_before=n,
        ball_charge=(n, z),
        ring_charge=n,
        leaked=(n, 2, z),
        supplied=n,
        current=n,
        account=(n, len(ACCOUNT)),
    )
    made = {name: np.empty(shape) for name, shape in shapes.items()}
    work, rows = np.empty(n), np.empty((most, len(ROW)))
    outer = np.broadcast_arrays(terms.capacitance, terms.coupling, terms.conductance, terms.driving)
    count, _ = core.library().call(
        "bearing_circuit",
        points=n,
        balls=z,
        time=films.time,
        capacitance=films.capacitance,
        conductance=films.conductance,
        limit=np.full((n, 2, z), np.inf) if limit is None else limit,
        outer=np.stack(outer, axis=1),
        start=terms.start,
        discharge_work=work,
        most=most,
        failures=rows,
        **made,
    )
    if count > most:
        return _run(films, terms, limit, count)
    return made.values(), work, rows[:count]


def _discharges(rows, work):
    found = {}
    for row in rows:
        point = int(row[0])
        found.setdefault(point, Discharge([], work[point])).failures.append(failure_of(row))
    return found


def _refuse_lost_charge(films, solution):
    charge = np.abs(solution.ball_charge)
    film = np.abs(films.capacitance * solution.bearing_voltage_before[:, None, None]).max()
    lost = ~films.capacitance.any(axis=1) & (charge > ROUNDING * film)
    if lost.any():
        point, ball = np.argwhere(lost)[0]
        raise RunError(
            f"ball {films.balls[ball]} has a charge of {solution.ball_charge[point, ball]:g} C and"
            f" no film at {films.time[point]:g} s: record capacitance_total, or give a stray"
            " capacitance"
        )
