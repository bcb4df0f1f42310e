# SPDX-License-Identifier: GPL-2.0-or-later
"""Functions that return samples of a record as `DataFrame` objects or as dicts of columns.

Each function takes the `record` and a range of samples from `start` to `stop`. The column `sample`
counts from the start of the record. All values are in SI units. A summary uses the columns, because
loading pandas takes longer than computing it.
"""

from typing import TYPE_CHECKING

import numpy as np

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.columns import ATOM
from raceway.runs.record import CAGE_RING, Record
from raceway.theory.bearing import INNER

if TYPE_CHECKING:
    import pandas as pd

# Atom types. An inner ring has the type RINGS, an outer ring RINGS + 1, a one-piece cage RINGS + 2.
BALL, CAGE, RINGS = 1, 2, 3
MOTION = list(ATOM)[2:]  # position, velocity and spin


def contacts(record: Record, start: int, stop: int) -> "pd.DataFrame":
    """Return a table with one row for each active contact and sample.

    It has a column `groove` if rings have two grooves. Its `attrs` contain the `first` sample and
    the number of `samples`. Raise `RunError` if the record has no loads.
    """
    import pandas as pd

    record.need_contacts()
    if "load" not in record.contact_columns:
        raise RunError(f"{record.path} has no column load: record it with the other columns")
    data = record.read(record.contact_columns, start, stop)
    live = data["load"].transpose(0, 2, 1) > 0
    sample, ball, place = np.nonzero(live)
    raceway, groove = np.divmod(place, len(record.raceways) // 2)
    table = pd.DataFrame(
        {
            "ball": record.fixed("ball")[ball].astype(int),
            "ring": _rings_of_balls(record)[raceway, ball],
            "raceway": raceway,
            **({"groove": groove} if record.two_grooves else {}),
            **{name: values.transpose(0, 2, 1)[live] for name, values in data.items()},
            "sample": sample + start,
        }
    )
    table.attrs.update(first=start, samples=len(live))
    return table


def _rings_of_balls(record):
    """Return the atom numbers (2, balls) of the inner and the outer ring of every ball."""
    number = np.zeros((2, max(record.bearings) + 1), dtype=int)
    side, owner = (record.fixed(f"ring_{name}") for name in ("raceway", "bearing"))
    guides = side != CAGE_RING
    number[side[guides], owner[guides]] = record.fixed("ring")[guides]
    return number[:, record.fixed("ball_bearing")]


def atoms(record: Record, start: int, stop: int) -> "pd.DataFrame":
    """Return a table with one row for each sample and ball, cage ball or ring.

    The spin of a ring is about its own axis. The `attrs` of the table contain the `first` sample
    and the number of `samples`. Raise `RunError` if the record has no ball motion.
    """
    import pandas as pd

    if "ball_x" not in record.variables:
        raise RunError(f"{record.path} is a summary: it does not contain the motion of the balls")
    parts = []
    for kind, prefix, dimension in ((BALL, "ball_", "ball"), (CAGE, "cage_", "cage_ball")):
        if dimension in record.variables:
            data = record.read([prefix + name for name in MOTION], start, stop)
            parts.append((kind, record.fixed(dimension), list(data.values())))
    data = record.read([f"ring_{name}" for name in (*MOTION[:6], "spin")], start, stop)
    *motion, about_axis = data.values()
    origin = [record.fixed(f"ring_origin_{axis}") for axis in "xyz"]
    place = [value + at for value, at in zip(motion[:3], origin)]
    spin = [np.zeros_like(about_axis) for _ in range(3)]
    spin[2] = about_axis
    kinds = RINGS + record.fixed("ring_raceway")
    parts.append((kinds, record.fixed("ring"), place + motion[3:] + spin))
    samples = len(about_axis)
    ids = np.concatenate([part[1] for part in parts]).astype(int)
    types = np.concatenate([np.broadcast_to(kind, len(tags)) for kind, tags, _ in parts])
    table = pd.DataFrame(
        {
            "id": np.tile(ids, samples),
            "type": np.tile(types, samples),
            **{
                name: np.concatenate([part[2][k] for part in parts], axis=1).ravel()
                for k, name in enumerate(MOTION)
            },
            "sample": np.repeat(np.arange(start, start + samples), len(ids)),
        }
    )
    table.attrs.update(first=start, samples=samples)
    return table


def ring_place(record: Record, side: int, start: int, stop: int) -> list[Floats]:
    """Return the position x, y, z (m) of the centre of the ring on one `side`, and its tilts about
    x and y (rad), as five arrays (N,)."""
    record.need_one()
    here = int(np.flatnonzero(record.fixed("ring_raceway") == side)[0])
    names = [f"ring_{name}" for name in ("x", "y", "z", "tilt_1", "tilt_2")]
    found = [values[:, here] for values in record.read(names, start, stop).values()]
    origin = [record.fixed(f"ring_origin_{axis}")[here] for axis in "xyz"]
    return [value + at for value, at in zip(found, [*origin, 0.0, 0.0])]


def rings(record: Record, start: int, stop: int, side: int = INNER) -> dict[str, Floats]:
    """Return columns with one value for each sample: step, time, motion of the inner ring and the
    forces on it. `side` selects another ring of the bearing."""
    record.need_one()
    ring = int(np.flatnonzero(record.fixed("ring_raceway") == side)[0])
    for axis in "xyz":
        record.variables[f"ring_{axis}"]  # raises an error if the ring is missing
    names = record.timed("ring_")
    data = record.read(["step", "time", *names], start, stop)
    columns = {"step": data["step"], "time": data["time"]}
    columns |= {name.removeprefix("ring_"): data[name][:, ring] for name in names}
    if (name := "bearing_capacitance") in record.variables:
        columns["capacitance"] = record.read([name], start, stop)[name][:, 0]
    columns["sample"] = np.arange(start, start + len(data["time"]))
    return columns


def totals(record: Record, start: int, stop: int) -> dict[str, Floats]:
    """Return columns of sums and extremes over the bearing, with one value for each sample."""
    record.need_one()
    for name in ("contacts", "loaded_balls", "pressure_inner", "pressure_outer", "cage_speed"):
        record.variables[f"bearing_{name}"]  # raises an error if it is missing
    data = record.read(record.timed("bearing_"), start, stop)
    columns = {name.removeprefix("bearing_"): values[:, 0] for name, values in data.items()}
    columns |= {name: columns[name].astype(int) for name in ("contacts", "loaded_balls")}
    columns["pressure"] = np.fmax(columns["pressure_inner"], columns["pressure_outer"])
    return columns
