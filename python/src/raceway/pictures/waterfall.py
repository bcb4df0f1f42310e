# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the capacitance against azimuth and time, with one band for each ball. The total capacitance
of the bearing is shown next to the bands, and above them the capacitance of each ball against its
azimuth."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Patch

from raceway.arrays import Floats, Integers
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.pictures import style
from raceway.pictures.page import head
from raceway.pictures.part import need, shown
from raceway.pictures.style import BALL, FAINT, INK, MAP
from raceway.runs.record_tables import BALL as BALL_TYPE
from raceway.runs.tables import RunTables
from raceway.units import axis

WIDTH = 0.5  # width of a band, as a fraction of the ball pitch
ROWS = 600  # number of samples that a page can resolve; if there are more, some are skipped
IDLE = "#ececec"  # colour of a ball unless it is loaded on both raceways


def waterfall(tables: RunTables, path: FilePath) -> None:
    """Plot the capacitance of every ball in the run `tables` against azimuth and time, and write
    the plot to the PNG file `path`.

    Raises `RunError` if the run has no capacitance or its files are invalid, or if the picture
    cannot be written.
    """
    need(tables, "capacitance", "the waterfall")
    tables = shown(tables)
    samples, psi, each = bands(tables)
    if len(samples) < 2:
        raise RunError(
            f"{tables.folder}: a picture over time needs at least 2 samples, not {len(samples)}"
        )
    total = tables.bearing_capacitance[samples - tables.first]
    factor, unit = axis(np.nanmax(each, initial=0.0), "F")
    times = tables.passes(samples)
    with style.drawing(path, figsize=(12, 8.4), dpi=110) as figure:
        head(
            figure,
            tables,
            "capacitance of the Hertz areas; both contacts of a ball are in series, the balls"
            " in parallel",
            size=15,
        )
        grid = figure.add_gridspec(
            2,
            3,
            left=0.075,
            right=0.94,
            bottom=0.085,
            top=0.86,
            width_ratios=(1, 0.3, 0.022),
            height_ratios=(0.3, 1),
            wspace=0.09,
            hspace=0.1,
        )
        main = figure.add_subplot(grid[1, 0])
        mesh = _bands(main, times, psi, each * factor, tables.settings["balls"])
        main.set(
            xlabel="azimuth from the load line (°)",
            ylabel="time (ball passes)",
            xlim=(-180, 180),
            ylim=(times[0], times[-1]),
            xticks=range(-180, 181, 45),
        )
        figure.legend(
            handles=[Patch(fc=IDLE, ec=FAINT, label="none: not loaded\non both raceways")],
            loc="upper right",
            bbox_to_anchor=(0.965, 0.87),
            handlelength=1.4,
        )
        above = figure.add_subplot(grid[0, 0], sharex=main)
        _around(above, psi, each * factor)
        above.set(
            ylim=(0, 1.12 * np.nanmax(each, initial=0.0) * factor or 1),
            ylabel=f"one ball ({unit})",
        )
        above.tick_params(labelbottom=False)
        beside = figure.add_subplot(grid[1, 1], sharey=main)
        factor, unit_all = axis(total.max(), "F")
        beside.plot(total * factor, times, color=INK, lw=1.8)
        # choose the range so that a ripple of one per cent is visible but small
        half = max(0.6 * np.ptp(total), 0.025 * total.max()) * factor or 1
        beside.set(
            xlabel=f"bearing ({unit_all})",
            xlim=(total.min() + total.max()) / 2 * factor + np.array([-half, half]),
        )
        beside.tick_params(labelleft=False)
        for axes in (above, beside):
            axes.grid(True)
        figure.colorbar(
            mesh, cax=figure.add_subplot(grid[1, 2]), label=f"one ball ({unit})"
        ).outline.set_edgecolor(FAINT)


def bands(tables: RunTables) -> tuple[Integers, Floats, Floats]:
    """Return (samples (n,), psi (n, Z), capacitance (n, Z)) for the balls of the run `tables`. psi
    is the unwrapped azimuth from the load line in rad. The capacitance is in F, or NaN for a ball
    that is not loaded on both raceways. There are at most about `ROWS` evenly spaced samples.
    """
    there = tables.balls
    table = there[there["type"] == BALL_TYPE].sort_values(["sample", "id"])
    ids, samples = np.unique(table["id"]), np.unique(table["sample"])
    centre = (
        there[there["id"] == tables.settings["outer_ring"]]
        .sort_values("sample")[["x", "y"]]
        .to_numpy()
    )
    x, y = (
        table[name].to_numpy().reshape(len(samples), len(ids)) - centre[:, [k]]
        for k, name in enumerate("xy")
    )
    each = tables.pairs.pivot(index="sample", columns="ball", values="capacitance").reindex(
        index=samples, columns=ids
    )
    kept = slice(None, None, -(-len(samples) // ROWS))
    psi = np.unwrap(tables.from_load_line(np.arctan2(y, x)), axis=0)
    return samples[kept], psi[kept], each.to_numpy()[kept]


def _bands(axes, times, psi, each, balls):
    half = WIDTH * 180 / balls
    norm = plt.Normalize(0, np.nanmax(each, initial=0.0) or 1)
    colours = plt.get_cmap(MAP).with_extremes(bad=IDLE)
    rows = np.repeat(_edges(times)[:, None], 2, 1)
    for way, values in zip(np.degrees(psi).T, np.ma.masked_invalid(each).T):
        for turn in range(
            round(way.min() / 360), round(way.max() / 360) + 1
        ):  # the same ball, after a full turn
            columns = _edges(way)[:, None] - 360 * turn + [-half, half]
            mesh = axes.pcolormesh(
                columns, rows, values[:, None], norm=norm, cmap=colours, rasterized=True
            )
    return mesh


def _edges(values):
    """Return the edges (n + 1,) of cells centred on `values` (n,)."""
    inner = (values[1:] + values[:-1]) / 2
    return (
        np.concatenate(
            [[1.5 * values[0] - 0.5 * values[1]], inner, [1.5 * values[-1] - 0.5 * values[-2]]]
        )
        if len(inner)
        else values[0] + np.array([-0.5, 0.5])
    )


def _around(axes, psi, each):
    degrees = np.degrees(psi)
    for way, values in zip(degrees.T, each.T):
        turn = 360 * np.round(way / 360)
        breaks = np.flatnonzero(np.diff(turn)) + 1
        axes.plot(
            np.insert(way - turn, breaks, np.nan),
            np.insert(np.nan_to_num(values), breaks, np.nan),
            color=BALL,
            lw=1.6,
        )
