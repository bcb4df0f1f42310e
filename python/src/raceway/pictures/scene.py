# SPDX-License-Identifier: GPL-2.0-or-later
"""Positions of all parts of a bearing at selected samples, with exaggerated small motions.

The reference is the concentric bearing at rest without clearance and load. Every deviation from it
(displacement of the inner ring, distance of a ball from the pitch circle, half the clearance) is
multiplied by the same factor. An overlap or gap between two bodies in the picture is therefore the
actual overlap or gap times this factor.
"""

from dataclasses import dataclass

import numpy as np

from raceway.arrays import Floats, Integers
from raceway.errors import RunError
from raceway.pictures.part import LIGHT, need
from raceway.runs.cage import pockets as cage_pockets
from raceway.runs.record_tables import BALL, CAGE
from raceway.runs.tables import RunTables

COLOURS = {
    "load": ("load", "larger contact load of a ball", "N"),
    "pressure": ("pressure", "larger Hertz pressure of a ball", "Pa"),
    "film": ("h_min", "thinner film of a ball", "m"),
    "capacitance": ("capacitance", "capacitance of a ball", "F"),
}
VISIBLE = 0.12  # largest motion in the picture, as a fraction of the ball radius


@dataclass(frozen=True)
class Scene:
    """n samples of a bearing with Z balls. Lengths are in m and angles in rad; x and y are
    transverse to the axis."""

    samples: Floats  # (n,), sample numbers
    factor: float  # factor by which motions are exaggerated
    balls: Floats  # (n, Z, 3), positions of the balls
    cage: Floats  # (n, C, 3), positions of the cage balls
    pockets: Floats  # (n, P, 3), centres of the pockets of a one-piece cage
    pocket_play: float  # play of the pockets along the pitch circle
    ring: Floats  # (n, 3), displacement of the inner ring
    half_clearance: float
    turned: Floats  # (n, Z), rotation of the balls about z since the first sample
    ring_turned: Floats  # (n,), rotation of the inner ring since the first sample
    # (n, Z), values that determine the colours of the balls; NaN if there is no value
    values: Floats
    load: Floats  # (n, Z), N, larger contact load of each ball, 0 if there is no contact


def scene(
    tables: RunTables, samples: Integers, colour: str = "load", factor: float | None = None
) -> Scene:
    """Return the `Scene` of the run `tables` at `samples`, an array of sample numbers in ascending
    order. The colours of the balls show the quantity `colour`, a key of `COLOURS`. By default,
    `factor` is the `nice` factor for the largest motion.

    Raises `RunError` if the run's files are invalid or lack the columns for `colour`.
    """
    need(tables, COLOURS[colour][0], f"colour {colour}")
    table = tables.balls[tables.balls["sample"] <= samples[-1]].sort_values(
        ["sample", "id"], kind="stable"
    )
    count = table["sample"].nunique()
    axis = _places(table[table["id"] == tables.settings["outer_ring"]], count)[:, 0]
    if not np.isin(samples, np.unique(table["sample"])).all():
        raise RunError(
            f"{tables.record.path}: there is no sample {samples[-1]}, the last is"
            f" {table['sample'].max()}"
        )
    first = int(table["sample"].min())
    kept = samples - first
    pitch, ring = tables.geometry.pitch_radius, table[table["id"] == tables.settings["inner_ring"]]
    balls, cage = table[table["type"] == BALL], table[table["type"] == CAGE]
    shift = _places(ring, count)[:, 0] - axis
    way, cage_way = _places(balls, count) - axis[:, None], _places(cage, count) - axis[:, None]
    holes = cage_pockets(tables, first, int(samples[-1]) + 1)
    centres = np.empty((count, 0, 3)) if holes is None else holes.centre - axis[:, None]
    if factor is None:
        both = np.concatenate([way[..., :2], centres[..., :2]], axis=1)
        off = np.abs(np.hypot(both[..., 0], both[..., 1]) - pitch).max()
        factor = nice(
            VISIBLE * tables.geometry.ball_radius,
            max(
                off,
                np.abs(shift).max(),
                abs(tables.settings["clearance_m"]) / 2,
                np.abs(way[..., 2]).max(),
            ),
        )
    values, load = _values(tables, colour, samples, np.unique(balls["id"]))
    step = tables.settings["sample_s"]
    return Scene(
        samples,
        factor,
        _exaggerated(way[kept], pitch, factor),
        _exaggerated(cage_way[kept], pitch, factor),
        _exaggerated(centres[kept], pitch, factor),
        0.0 if holes is None else holes.play,
        factor * shift[kept],
        factor * tables.settings["clearance_m"] / 2,
        _turned(balls, step)[kept],
        _turned(ring, step)[kept, 0],
        values,
        load,
    )


def nice(seen: float, largest: float) -> float:
    """Return the largest of 1, 2, 5, 10, 20 ... whose product with `largest` is at most `seen`, but
    at least 1.

    >>> nice(0.75e-3, 34.8e-6), nice(0.75e-3, 2e-3), nice(0.75e-3, 0.0)
    (20.0, 1.0, 1.0)
    """
    if not largest > 0 or seen <= largest:
        return 1.0
    power = 10.0 ** np.floor(np.log10(seen / largest))
    return float(max(m * power for m in (1, 2, 5) if m * power <= seen / largest * (1 + 1e-12)))


def _exaggerated(way, pitch, factor):
    radius = np.hypot(way[..., 0], way[..., 1])
    stretch = (pitch + factor * (radius - pitch)) / radius
    return way * np.stack([stretch, stretch, np.full_like(stretch, factor)], axis=-1)


def _places(table, samples):
    return table[["x", "y", "z"]].to_numpy().reshape(samples, len(table) // samples, 3)


def _turned(table, step):
    spin = table["omegaz"].to_numpy().reshape(table["sample"].nunique(), -1)
    return step * np.concatenate(
        [np.zeros((1, spin.shape[1])), np.cumsum((spin[1:] + spin[:-1]) / 2, axis=0)]
    )


def _values(tables, colour, samples, ids):
    """Return the values (n, Z) for `colour` and the loads (n, Z)."""
    contacts = tables.contacts[tables.contacts["sample"].isin(samples)]

    def grid(table, column, how):
        by = table.groupby(["sample", "ball"])[column].agg(how).unstack()
        return by.reindex(index=samples, columns=ids).to_numpy()

    load = np.nan_to_num(grid(contacts, "load", "max"))
    if colour == "load":
        return np.where(load > 0, load, np.nan), load
    if colour == "capacitance":
        return grid(tables.pairs[tables.pairs["sample"].isin(samples)], "capacitance", "max"), load
    if colour == "film":
        return (
            grid(
                contacts[contacts["load"] > LIGHT * tables.contacts["load"].max()], "h_min", "min"
            ),
            load,
        )
    return grid(contacts, "pressure", "max"), load
