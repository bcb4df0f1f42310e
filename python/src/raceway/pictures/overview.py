# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot an overview of a run in one picture."""

import numpy as np

from raceway.arrays import Floats
from raceway.files import FilePath
from raceway.pictures import around_ring, style
from raceway.pictures.page import LEFT, RIGHT, against_time, finish, head, key
from raceway.pictures.part import filmed, shown, tracks, within_turn
from raceway.pictures.style import BALL, COLOUR, INK, NAME, PALETTE
from raceway.runs.columns import LOSSES
from raceway.runs.summary import ring_displacement, summary
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER
from raceway.units import axis, prefixed

PARTS = 3  # number of torque components with their own colour; more do not fit into the legend
SLOW = 0.01  # fraction of the largest speed; a loss at a lower speed is not shown as a torque


def overview(tables: RunTables, path: FilePath) -> None:
    """Plot an overview of the run `tables` and write it to the PNG file `path`. The panels show the
    loads; the friction torque by component, or the pressures; and the film and the capacitance, or
    the motion of the ring.

    Raises `RunError` if the run's files are invalid or the picture cannot be written.
    """
    tables, whole = shown(tables, "; the results are for all of them"), tables
    figures = summary(whole)
    film = filmed(tables)
    with style.drawing(path, figsize=(12, 12) if film else (12, 7.9), dpi=130) as figure:
        _compose(figure, tables, figures, film)


def _compose(figure, tables, figures, film):
    height = figure.get_figheight()
    head(figure, tables, _subtitle(figures))
    edges = {"left": LEFT, "right": RIGHT, "bottom": 0.65 / height}
    if film:
        above = figure.add_gridspec(
            1, 2, **edges | {"bottom": 5.35 / height}, top=1 - 2.15 / height, wspace=0.16
        )
        below = figure.add_gridspec(1, 2, **edges, top=4.1 / height, wspace=0.16)
        around_ring.loads(figure.add_subplot(above[0], projection="polar"), tables)
        around_ring.film(figure.add_subplot(above[1], projection="polar"), tables)
        middle, last = (figure.add_subplot(place) for place in below)
    else:
        left = figure.add_gridspec(
            1, 1, left=LEFT, right=0.5, top=1 - 2.15 / height, bottom=1.0 / height
        )
        right = figure.add_gridspec(
            2, 1, left=0.6, right=RIGHT, top=1 - 1.6 / height, bottom=0.65 / height, hspace=0.46
        )
        around_ring.loads(figure.add_subplot(left[0], projection="polar"), tables)
        middle, last = (figure.add_subplot(place) for place in right)
    if figures["friction_torque_N_m"]:
        _torque(middle, tables)
    else:
        _pressures(middle, tables)
    (_capacitance if tables.lubricated and "capacitance" in tables.contacts else _ring)(
        last, tables
    )


def _subtitle(figures):
    parts = (
        ("largest contact load", "q_max_N", "N"),
        ("inner pressure", "p_max_inner_Pa", "Pa"),
        ("radial displacement", "ring_shift_m", "m"),
        *([("axial displacement", "shift_z_m", "m")] if figures["axial_N"] else []),
        ("inner $h_{min}$", "h_min_m", "m"),
        ("Λ", "lambda", ""),
        ("friction torque", "friction_torque_N_m", "N m"),
        ("plates", "capacitance_F", "F"),
    )
    return "    ".join(
        f"{name} {prefixed(figures[field], unit, 3)}"
        for name, field, unit in parts
        if figures[field] is not None
    )


def torque_by_part(tables: RunTables) -> dict[str, Floats]:
    """Return {component: (N,)}, the power losses in W divided by the relative speed of the rings at
    that time, in N m. They are NaN while the rings are nearly at rest.

    Only the `PARTS` largest components are separate, and only if they exceed one hundredth of the
    total; all others are combined.
    """
    speed = np.abs(tables.turning.shaft_speed(tables.first, tables.last))
    speed[speed < SLOW * speed.max()] = np.nan
    lost = {name: tables.totals[key] for name, key in LOSSES.items() if key in tables.totals}
    # the loss at the cage is known only at the ends of steps
    full = {name: values.interpolate(limit_direction="both") for name, values in lost.items()}
    lost = {name: values.to_numpy(float) / speed for name, values in full.items()}
    whole, means = sum(lost.values()), {name: np.nanmean(one) for name, one in lost.items()}
    order = sorted(lost, key=lambda name: -means[name])[:PARTS]
    large = {name: lost[name] for name in order if means[name] > 0.01 * np.nanmean(whole)}
    if len(large) < len(lost):
        large["other"] = np.maximum(whole - sum(large.values()), 0.0)
    return large


def _torque(axes, tables):
    large = torque_by_part(tables)
    most, samples = np.nanmax(sum(large.values())), np.arange(len(tables.totals))
    factor, unit = axis(most, "N m")
    colours = [PALETTE[k % len(PALETTE)] for k in range(len(large))]
    layers = [values * factor for values in large.values()]
    axes.stackplot(tables.passes(samples), layers, colors=colours, lw=0)
    axes.set_ylabel(f"friction torque ({unit})")
    against_time(axes, tables, len(samples))
    finish(
        axes,
        "Friction torque by part",
        1.22 * most * factor,
        [key(name, color=colour, lw=6) for name, colour in zip(large, colours)],
    )


def _pressures(axes, tables):
    largest = tables.contacts["pressure"].max()
    factor, unit = axis(largest, "Pa")
    for side in (OUTER, INNER):
        for psi, pressure in tracks(tables, side, "pressure"):
            axes.plot(*within_turn(psi, pressure * factor), color=COLOUR[side], lw=2)
    axes.set(
        xlabel="azimuth from the load line (°)",
        ylabel=f"largest contact pressure ({unit})",
        xlim=(-180, 180),
        xticks=range(-180, 181, 45),
    )
    finish(
        axes,
        "Hertz pressure",
        1.22 * largest * factor,
        [key(NAME[side], color=COLOUR[side], lw=2.2) for side in (INNER, OUTER)],
    )


def _capacitance(axes, tables):
    total = tables.bearing_capacitance
    factor, unit = axis(total.max(), "F")
    samples = np.arange(len(total))
    each = tables.pairs.pivot(index="sample", columns="ball", values="capacitance").reindex(samples)
    axes.plot(tables.passes(samples), each * factor, color=BALL, lw=1.5)
    axes.plot(tables.passes(samples), total * factor, color=INK, lw=2.4)
    axes.set_ylabel(f"capacitance ({unit})")
    against_time(axes, tables, len(total))
    finish(
        axes,
        "Capacitance of the contact ellipses",
        1.22 * total.max() * factor,
        [
            key("all balls", color=INK, lw=2.4),
            key("one ball, inner and outer in series", color=BALL, lw=1.6),
        ],
    )


def _ring(axes, tables):
    shift = ring_displacement(tables)
    factor, unit = axis(np.abs(shift).max(), "m")
    axes.plot(tables.passes(tables.rings["sample"]), shift * factor, color=INK, lw=2)
    axes.set_ylabel(f"inner ring ({unit})")
    against_time(axes, tables, len(shift))
    finish(axes, "Radial displacement along the load", None, [])
    low, high = shift.min() * factor, shift.max() * factor
    # a variation of less than one per cent is drawn as almost constant
    half = max(0.75 * (high - low), 0.01 * abs(high)) or 1
    axes.set_ylim((low + high) / 2 - half, (low + high) / 2 + half)
