# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the motion of a ring (orbit, displacement, tilt), the moment that opposes the spin, and the
force on the cage; for a one-piece cage, also its orbit and the pocket forces."""

from collections.abc import Callable
from functools import partial

import numpy as np

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.pictures import style
from raceway.pictures.page import LEFT, RIGHT, against_time, finish, head, key
from raceway.pictures.style import INK, PALETTE
from raceway.runs import record_tables
from raceway.runs.cage import pockets_around
from raceway.runs.losses import opposing_moment
from raceway.runs.record import CAGE_RING
from raceway.runs.tables import RunTables
from raceway.theory.bearing import OUTER
from raceway.units import axis, prefixed


def motion(tables: RunTables, path: FilePath) -> None:
    """Plot the motion of the inner ring in the run `tables`, or of the outer ring if only that
    moves, and write the plot to the PNG file `path`. The panels show the orbit of its centre, its
    displacement and tilt, the moment that opposes the spin of the inner ring relative to the outer
    ring, and the largest force on the cage against time. For a one-piece cage, they also show the
    orbit of the cage and the forces of the balls on their pockets against azimuth.

    Quantities that were not recorded or did not change have no panel. Raises `RunError` if the
    run's files are invalid or do not contain a ring, or if the picture cannot be written.
    """
    rings = tables.rings
    if not len(rings):
        raise RunError(f"{tables.record.path} has no sample of the inner ring")
    name, ring = moving_ring(tables)
    panels: list[Callable[..., None]] = [partial(_orbit, ring=ring)]
    panels.append(partial(_displacement, ring=ring))
    if any(ring[tilt].any() for tilt in ("tilt_1", "tilt_2") if tilt in ring):
        panels.append(partial(_tilt, ring=ring))
    if {"mz", "spin"} <= set(rings):
        panels.append(_torque)
    if np.isfinite(tables.totals.get("cage_force", np.nan)).any():
        panels.append(_cage)
    if CAGE_RING in tables.record.fixed("ring_raceway"):
        panels += [_cage_orbit, _pockets]
    rows = (len(panels) + 1) // 2
    with style.drawing(path, figsize=(12, 1.9 + 4.6 * rows), dpi=130) as figure:
        height = figure.get_figheight()
        grid = figure.add_gridspec(
            rows,
            2,
            left=LEFT + 0.02,
            right=RIGHT,
            bottom=0.65 / height,
            top=1 - 1.6 / height,
            hspace=0.36,
            wspace=0.24,
        )
        head(figure, tables, f"{name} ring, displacement from the initial position")
        for place, panel in zip(grid, panels):
            panel(figure.add_subplot(place), tables)


def moving_ring(tables: RunTables) -> tuple[str, dict[str, Floats]]:
    """Return the name and the columns of the inner ring or, if only the outer ring moves, of the
    outer ring."""
    inner = tables.ring_columns
    if not any(inner[axis].any() for axis in "xyz"):
        outer = record_tables.rings(tables.record, tables.first, tables.last, OUTER)
        if any(outer[axis].any() for axis in "xyz"):
            return "outer", outer
    return "inner", inner


def _orbit(axes, tables, ring):
    _path(axes, ring["x"], ring["y"], "Orbit of the centre")


def _cage_orbit(axes, tables):
    cage = tables.record.fixed("ring_raceway").tolist().index(CAGE_RING)
    data = tables.record.read(["ring_x", "ring_y"], tables.first, tables.stop)
    _path(axes, data["ring_x"][:, cage], data["ring_y"][:, cage], "Orbit of the cage's centre")


def _pockets(axes, tables):
    found = pockets_around(tables)
    psi = np.degrees(found["from_load_line"].to_numpy())
    factor, unit = axis(float(np.nanmax(found["largest"])) or 1.0, "N")
    for name, colour in zip(("largest", "mean"), PALETTE):
        axes.step(psi, found[name] * factor, where="mid", color=colour, lw=1.6)
    axes.set(xlabel="azimuth from the load (°)", ylabel=unit, xlim=(-180, 180))
    axes.set_xticks(range(-180, 181, 60))
    keys = [key(name, color=c, lw=2) for name, c in zip(("largest", "mean"), PALETTE)]
    finish(axes, "Force of a ball on its pocket", None, keys)
    axes.set_ylim(0, 1.22 * axes.get_ylim()[1])


def _path(axes, x, y, title):
    middle = np.array([x.mean(), y.mean()])
    factor, unit = axis(max(np.ptp(x), np.ptp(y), 1e-15), "m")
    axes.plot((x - middle[0]) * factor, (y - middle[1]) * factor, color=INK, lw=1.2)
    axes.set(xlabel=f"x from its mean ({unit})", ylabel=f"y from its mean ({unit})")
    axes.set_aspect("equal", adjustable="datalim")
    where = f"{prefixed(middle[0], 'm', 3)}, {prefixed(middle[1], 'm', 3)}".replace("-", "−")
    finish(axes, f"{title} about {where}", None, [])


def _displacement(axes, tables, ring):
    _lines(axes, tables, {name: ring[name] for name in "xyz"}, "m")
    axes.set_title("Displacement", pad=10)


def _tilt(axes, tables, ring):
    _lines(axes, tables, {"about x": ring["tilt_1"], "about y": ring["tilt_2"]}, "rad")
    axes.set_title("Tilt", pad=10)


def _torque(axes, tables):
    # the mean of this moment, i.e. the friction torque, is much smaller than its ripple, so the
    # summary computes the torque from the losses instead
    _lines(axes, tables, {"balls on the inner ring": opposing_moment(tables)}, "N m")
    axes.set_title("Moment against the spin", pad=10)


def _cage(axes, tables):
    # cage contacts are brief and are recorded only at the ends of the host's steps
    force = tables.totals["cage_force"].dropna()
    factor, unit = axis(force.max() or 1.0, "N")
    time = tables.passes(force.index.to_numpy())
    axes.vlines(time, 0.0, force * factor, color=PALETTE[0], lw=1.2)
    axes.plot(time, force * factor, ".", color=PALETTE[0], ms=3)
    axes.set_ylabel(unit)
    against_time(axes, tables, int(tables.rings["sample"].iloc[-1]) + 1)
    finish(axes, "Largest force of a ball on the cage", None, [])


def _lines(axes, tables, curves, unit):
    moving = {name: values for name, values in curves.items() if np.any(values)} or curves
    factor, shown = axis(max(float(np.abs(v).max()) for v in moving.values()) or 1.0, unit)
    time = tables.passes(tables.rings["sample"])
    for (_, values), colour in zip(moving.items(), PALETTE):
        axes.plot(time, values * factor, color=colour, lw=1.6)
    axes.set_ylabel(shown)
    against_time(axes, tables, int(tables.rings["sample"].iloc[-1]) + 1)
    keys = [key(name, color=colour, lw=2) for name, colour in zip(moving, PALETTE)]
    finish(axes, "", None, keys)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.22 * (high - low))
