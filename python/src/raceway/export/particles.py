# SPDX-License-Identifier: GPL-2.0-or-later
"""Iterate over the samples of a run, each with its balls, its cage balls and their contact data."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from raceway.arrays import Floats
from raceway.runs.columns import CONTACT
from raceway.runs.record_tables import BALL, CAGE
from raceway.runs.tables import RunTables
from raceway.theory import capacitance

CARRIED = ("load", "pressure", "h_min", "h_c", "lambda", "friction", "sliding", "capacitance")
FRAMES = 200  # largest number of frames by default


class Frame(NamedTuple):
    """One sample of a run with n balls and cage balls, in SI units."""

    sample: int
    time: float  # s
    position: Floats  # (n, 3), m, positions of the balls and cage balls
    data: dict[str, NDArray[Any]]  # {name: array (n,) or (n, 3)}
    ring: Floats  # (3,), position of the inner ring
    ring_turned: float  # rad, rotation of the inner ring about its axis since the first sample


def frames(tables: RunTables, every: int | None = None) -> Iterator[Frame]:
    """Yield every `every`th sample of the run `tables` as a `Frame`, using a bounded amount of
    memory. If `every` is None, at most `FRAMES` samples are yielded.

    `data` contains id, type (1 ball, 2 cage ball), radius, velocity, spin, load (the larger of a
    ball's two loads), capacitance (both contacts in series), and each quantity in `CARRIED` that
    the run records, separately for each raceway (`load_inner` ..., or `load_inner_0` ... for rings
    with two grooves). Where there is no contact, quantities that vanish are 0 and undefined
    quantities are NaN. Raises `RunError` if a file is invalid.
    """
    if every is None:
        every = max(1, -(-(tables.last - tables.first) // FRAMES))
    for (sample, atoms, turned), (_, contacts, _) in zip(
        _samples(tables, "balls", every), _samples(tables, "contacts", every)
    ):
        yield _frame(
            tables,
            sample,
            atoms[atoms["type"].isin((BALL, CAGE))].sort_values("id"),
            contacts,
            _vectors(atoms[_inner(tables, atoms)], "")[0],
            turned,
        )


def _frame(tables, sample, atoms, contacts, ring, turned):
    ids = atoms["id"].to_numpy()
    data = {
        "id": ids,
        "type": atoms["type"].to_numpy(),
        "radius": np.where(
            atoms["type"] == BALL, tables.geometry.ball_radius, tables.cage_ball_radius
        ),
    }
    data["velocity"], data["spin"] = _vectors(atoms, "v"), _vectors(atoms, "omega")
    contacts_of = tables.by_raceway(contacts)
    for name in CARRIED:
        for word, rows in contacts_of.items() if name in contacts else ():
            rows = contacts[rows]
            values = np.full(len(ids), CONTACT[name].absent)
            values[np.searchsorted(ids, rows["ball"])] = rows[name]
            data[f"{name}_{word}"] = values
    data["load"] = np.max([data[f"load_{word}"] for word in contacts_of], axis=0)
    if "capacitance" in contacts:
        each = np.array([data[f"capacitance_{word}"] for word in contacts_of])
        data["capacitance"] = capacitance.ball(*each.reshape(2, -1, len(ids)).sum(1))
    return Frame(
        sample, sample * tables.settings["sample_s"], _vectors(atoms, ""), data, ring, turned
    )


def _samples(tables, name, every):
    """Yield (sample, its rows, rotation angle of the inner ring). The angle is 0 in tables without
    balls."""
    turned = before = 0.0
    for table in tables.blocks(name):
        first, count = table.attrs["first"], table.attrs["samples"]
        angles = np.zeros(count)
        if name == "balls":
            spins = table.loc[_inner(tables, table), "omegaz"].to_numpy(float)
            steps = (np.append(before, spins[:-1]) + spins) / 2 * tables.settings["sample_s"]
            if first == tables.first:
                steps[0] = 0.0
            angles = np.cumsum(np.append(turned, steps))[1:]
            turned, before = angles[-1], spins[-1]
        ends = np.searchsorted(table["sample"], first + np.arange(count + 1))
        for k in range((tables.first - first) % every, count, every):
            yield first + k, table.iloc[ends[k] : ends[k + 1]], float(angles[k])


def _inner(tables, atoms):
    return atoms["id"] == tables.settings["inner_ring"]


def _vectors(table, prefix):
    return table[[f"{prefix}{x}" for x in "xyz"]].to_numpy(float)
