# SPDX-License-Identifier: GPL-2.0-or-later
"""Common parts of the pictures: title with the settings of the run, legends and axes."""

from collections.abc import Sequence
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator

from raceway.pictures.style import SOFT
from raceway.runs.measured import title
from raceway.runs.tables import RunTables

LEFT, RIGHT = 0.075, 0.965  # fractions of the figure width


def quantity(meaning: str) -> str:
    """Return the `meaning` of a signal, for use as a title, without the explanation after the first
    comma."""
    return meaning.partition(",")[0]


def head(figure: Figure, tables: RunTables, below: str, size: float = 17) -> None:
    """Write the title of the run `tables` and, below it, the text `below` at the top of
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
    """Shrink `text` to the fraction `share` of the figure width if it is wider than that."""
    width = text.get_window_extent(text.figure.canvas.get_renderer()).width
    text.set_fontsize(text.get_fontsize() * min(1, share * text.figure.bbox.width / width))


def key(label: str, **style: Any) -> Line2D:
    """Return a legend handle with a `label`."""
    return Line2D([], [], label=label, **style)


def against_time(axes: Axes, tables: RunTables, samples: int) -> None:
    """Set up the x axis for `samples` samples, with the time in ball passes."""
    axes.set(xlabel="time (ball passes)", xlim=(0, float(tables.passes(samples - 1)) or 1.0))
    axes.xaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 5, 10]))


def finish(axes: Axes, title: str, top: float | None, handles: Sequence[Artist]) -> None:
    """Set the title, the grid, the legend and, unless `top` is None, the range of the y axis, which
    then starts at zero."""
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
