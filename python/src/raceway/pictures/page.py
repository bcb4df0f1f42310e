# SPDX-License-Identifier: GPL-2.0-or-later
"""Common parts of a picture's page: title with the run's settings, legends, axes."""

from collections.abc import Sequence
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator

from raceway.pictures.style import SOFT
from raceway.runs.measured import loading, speeds
from raceway.runs.tables import RunTables
from raceway.units import prefixed

LEFT, RIGHT = 0.075, 0.965  # fractions of the figure's width
LITTLE = 0.01  # fraction of a load; smaller values are not in the title


def title(tables: RunTables) -> str:
    """The run `tables` in one line, with measured load and speed."""
    settings = tables.settings
    oil = f"{settings['lubricant']} lubricant" if tables.lubricated else "dry"
    clearance = prefixed(settings["clearance_m"], "m", 3).replace("-", "−")
    return "  ·  ".join(
        (
            f"{settings['bearing']} ball bearing",
            *_loads(tables),
            speeds(tables),
            oil,
            f"clearance {clearance}",
        )
    )


def quantity(meaning: str) -> str:
    """The `meaning` of a signal for a title: without what explains it, after the first comma."""
    return meaning.partition(",")[0]


def _loads(tables):
    load = loading(tables)
    if load is None:
        return [f"{prefixed(tables.settings['load_N'], 'N')} radial"]
    largest = max(load.radial, abs(load.axial))
    if largest == 0.0:
        return ["no load"]
    parts = (
        (load.radial, "turning radial load" if load.turns else "radial"),
        (load.axial, "axial"),
    )
    return [
        f"{prefixed(value, 'N', 3).replace('-', '−')} {name}"
        for value, name in parts
        if abs(value) > LITTLE * largest
    ]


def head(figure: Figure, tables: RunTables, below: str, size: float = 17) -> None:
    """Write the title of the run `tables` and, under it, the text `below` at the top of
    `figure`."""
    height, scale = figure.get_figheight(), size / 17
    fit(
        figure.text(
            LEFT,
            1 - 0.45 * scale / height,
            title(tables),
            fontsize=size,
            fontweight="bold",
            va="center",
        ),
        RIGHT - LEFT,
    )
    fit(
        figure.text(LEFT, 1 - 0.82 * scale / height, below, fontsize=11, color=SOFT, va="center"),
        RIGHT - LEFT,
    )


def fit(text: Text, share: float) -> None:
    """Let a long `text` shrink to that `share` of its figure's width: it does not run off the
    page."""
    width = text.get_window_extent(text.figure.canvas.get_renderer()).width
    text.set_fontsize(text.get_fontsize() * min(1, share * text.figure.bbox.width / width))


def key(label: str, **style: Any) -> Line2D:
    """A line of a legend."""
    return Line2D([], [], label=label, **style)


def against_time(axes: Axes, tables: RunTables, samples: int) -> None:
    """The x axis of `samples` samples: time in ball passes."""
    axes.set(xlabel="time (ball passes)", xlim=(0, float(tables.passes(samples - 1)) or 1.0))
    axes.xaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 5, 10]))


def finish(axes: Axes, title: str, top: float | None, handles: Sequence[Artist]) -> None:
    """Title, grid, legend and, unless None, the top of a y axis from zero."""
    axes.set_title(title, pad=10)
    axes.grid(True)
    if top is not None:
        axes.set_ylim(0, top or 1)
    if handles:
        axes.legend(
            handles=handles,
            loc="upper left",
            ncols=len(handles),
            handlelength=1.6,
            borderaxespad=0.2,
            frameon=True,
            facecolor="white",
            edgecolor="none",
            framealpha=1,
        )
