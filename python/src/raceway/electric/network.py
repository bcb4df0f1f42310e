# SPDX-License-Identifier: GPL-2.0-or-later
"""The voltages of a bearing's floating balls and of its inner ring over time, with the energy
balance (docs/electric_circuit, Network and Energy; src-package/core/electric/circuit.h)."""

from typing import NamedTuple

import numpy as np

from raceway import core
from raceway.arrays import Floats
from raceway.electric.breakdown import ROW, Breakdown, Failure, failure_of
from raceway.electric.films import Films
from raceway.electric.outer import Terms
from raceway.errors import RunError

# {name: meaning} of the energies, in J
ENERGIES = {
    "source_work": "work of the driving voltage since the start",
    "mechanical_work": "work done on the films by moving their plates, since the start",
    "leak_heat": "heat in the conductance of films since the start",
    "resistor_heat": "heat in the resistance of the source since the start",
    "discharge_energy": "heat of discharges since the start",
    "stored_energy": "energy stored in films, beside them and in the coupling",
    "energy_error": "largest error so far in the energy balance of a step",
}
OUTER = ("factor", "coupling", "driving", "edges", "start")


class Solution(NamedTuple):
    """Values at n points of time, after a discharge if there is one."""

    ball: Floats  # (n, Z) V
    bearing: Floats  # (n,) V
    ball_charge: Floats  # (n, Z) C, carried from point to point
    current: Floats  # (n,) A, mean over the step that ends at the point; excludes discharges
    charge_error: Floats  # (n,) C, largest so far
    energies: dict[str, Floats]  # (n,) J, by the names in `ENERGIES`
    failures: list[Failure]


def solve(films: Films, terms: Terms, breakdown: Breakdown | None) -> Solution:
    """Solve the network of `films` and the outer circuit `terms`; films fail by `breakdown`, or
    never if it is None.

    Balls start without charge. Raises `ValueError` for breakdown on a source without resistance,
    `RunError` if a charged ball loses both films.
    """
    if breakdown and terms.stiff:
        raise ValueError("breakdown would short a source without resistance: give it a resistance")
    return _run(films, terms, breakdown)


def _run(films, terms, breakdown, most=4096):
    n, z = len(films.time), len(films.balls)
    made = {name: np.empty((n, z)) for name in ("ball", "ball_charge")}
    made |= {name: np.empty(n) for name in ("bearing", "current", "charge_error")}
    energies = {name: np.empty(n) for name in ENERGIES}
    rows = np.empty((most, len(ROW)))
    count, lost = core.library().call(
        "bearing_circuit",
        points=n,
        balls=z,
        time=films.time,
        capacitance=films.capacitance,
        conductance=films.conductance,
        thickness=films.thickness,
        strength=breakdown.strength if breakdown else 0.0,
        less=breakdown.less(films) if breakdown else 0.0,
        floor=breakdown.floor if breakdown else 0.0,
        beside=terms.capacitance,
        source=terms.conductance,
        edge_count=len(terms.edges),
        **{name: getattr(terms, name) for name in OUTER},
        most=most,
        failures=rows,
        **made,
        **energies,
    )
    if lost.point >= 0:
        point, ball = int(lost.point), int(lost.ball)
        raise RunError(
            f"ball {films.balls[ball]} has a charge of {made['ball_charge'][point, ball]:g} C and"
            f" no film at {films.time[point]:g} s: record capacitance_total, or give a stray"
            " capacitance"
        )
    if count > most:
        return _run(films, terms, breakdown, count)
    failures = [failure_of(row) for row in rows[:count]]
    return Solution(**made, energies=energies, failures=failures)
