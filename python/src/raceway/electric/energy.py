# SPDX-License-Identifier: GPL-2.0-or-later
"""Energy balance of a circuit (docs/electric_circuit, Energy).

The energy of every element in a step from 0 to 1 is its charge times the mean of its voltages. For
a capacitance C this is exactly the change of its energy less the mechanical work on its plates,
-1/2 V0 V1 (C1 - C0). The charges of a node add up to zero, so the sum over all elements is an
identity. Each term has a second-order error in the step.
"""

import numpy as np
import xarray as xr

from raceway.arrays import Floats
from raceway.electric.films import Films
from raceway.electric.network import Solution
from raceway.electric.outer import Terms

MEANINGS = {
    "stored_energy": "energy stored in films, beside them and in the coupling",
    "source_work": "work of the driving voltage since the start",
    "mechanical_work": "work that moving the plates of the films put in since the start",
    "leak_heat": "heat in the conductance of films since the start",
    "resistor_heat": "heat in the resistance of the source since the start",
    "discharge_energy": "heat of discharges since the start",
    "energy_error": "what the balance of energy lacks, in the step and discharge that end here",
}


def account(films: Films, terms: Terms, solution: Solution) -> xr.Dataset:
    """Dataset (time) of the names in `MEANINGS`, J."""
    s = solution
    after = np.stack([s.bearing_voltage[:, None] - s.ball_voltage, s.ball_voltage], axis=1)
    before = np.stack(
        [s.bearing_voltage_before[:, None] - s.ball_voltage_before, s.ball_voltage_before], axis=1
    )
    stored = _stored(films, terms, after, s.bearing_voltage)
    ring, ring_end = s.bearing_voltage[:-1], s.bearing_voltage_before[1:]
    moved = (after[:-1] * before[1:] * np.diff(films.capacitance, axis=0)).sum(axis=(1, 2))
    mechanical = -0.5 * (moved + ring * ring_end * np.diff(terms.capacitance))
    leak = (0.5 * (after[:-1] + before[1:]) * s.leaked[1:]).sum(axis=(1, 2))
    driving = 0.5 * (terms.driving[:-1] + terms.driving[1:])
    resistor = np.zeros_like(leak)
    if not terms.stiff:
        resistor = (driving - 0.5 * (ring + ring_end)) * s.supplied[1:]
    coupled = terms.coupling * (np.diff(terms.driving) - (ring_end - ring))
    source = driving * (s.supplied[1:] + coupled)
    lost, given = _discharged(solution)
    lacks = source + given[1:] + mechanical - leak - resistor - lost[1:] - np.diff(stored)
    start = _stored(films, terms, before[:1], s.bearing_voltage_before[:1])
    lacks_first = start + given[:1] - lost[:1] - stored[:1]
    steps = {
        "stored_energy": stored,
        "source_work": _summed(source, given),
        "mechanical_work": _summed(mechanical),
        "leak_heat": _summed(leak),
        "resistor_heat": _summed(resistor),
        "discharge_energy": np.cumsum(lost),
        "energy_error": np.concatenate([lacks_first, lacks]),
    }
    data = xr.Dataset({name: ("time", values) for name, values in steps.items()})
    for name, meaning in MEANINGS.items():
        data[name].attrs = {"units": "J", "long_name": meaning}
    return data


def _stored(films, terms, film_voltage, ring) -> Floats:
    """Values at the first points, as many as in `ring`."""
    n = len(ring)
    coupled = terms.coupling * (ring - terms.driving[:n]) ** 2
    inside = (films.capacitance[:n] * film_voltage**2).sum(axis=(1, 2))
    return 0.5 * (inside + terms.capacitance[:n] * ring**2 + coupled)


def _discharged(solution):
    """(heat, work of the driving voltage) of the discharge at each point."""
    lost, given = np.zeros((2, len(solution.bearing_voltage)))
    for point, one in solution.discharges.items():
        lost[point] = sum(failure.energy for failure in one.failures)
        given[point] = one.source_work
    return lost, given


def _summed(steps, at_points=0.0):
    return np.cumsum(np.concatenate([[0.0], steps]) + at_points)
