# SPDX-License-Identifier: GPL-2.0-or-later
"""Common style of all pictures: colours and fonts, and functions that start and save a figure."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.figure import Figure

from raceway.files import FilePath

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

from raceway import files
from raceway.theory.bearing import INNER, OUTER

# Okabe and Ito's palette, which colour-blind readers can distinguish; the colours of the two
# raceways also differ in lightness
PALETTE = ("#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00")
COLOUR = {INNER: PALETTE[0], OUTER: PALETTE[1]}
NAME = {INNER: "inner raceway", OUTER: "outer raceway"}
SIDES = (INNER, OUTER)
MAP = "cividis"  # a perceptually uniform colour map that is suitable for colour-blind readers
INK, SOFT, FAINT, BALL = "#222222", "#555555", "#bbbbbb", "#009E73"
STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 11,
    "axes.titlesize": 13,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": FAINT,
    "axes.labelcolor": INK,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.solid_capstyle": "round",
}
REGIMES = (
    (0, 1, "boundary", "#f9e3da"),
    (1, 3, "mixed", "#fdf6e0"),
    (3, np.inf, "full film", "#e8f4ee"),
)


FORMATS = {".pdf": "pdf", ".svg": "svg"}  # of pictures, by the ending of the name; others are PNG


@contextmanager
def drawing(path: FilePath, **options: Any) -> Iterator[Figure]:
    """Yield a new figure in the common style, with the `options` of `plt.figure`, and write it to
    `path` at the end of the block (`save`). The figure is closed in any case."""
    with plt.rc_context(STYLE):
        figure = plt.figure(**options)
        try:
            yield figure
            save(figure, path)
        finally:
            plt.close(figure)


def save(figure: Figure, path: FilePath) -> None:
    """Write `figure` to `path` and close it. The format is PDF or SVG if the name ends in .pdf or
    .svg, and PNG otherwise. Raises `RunError` if it cannot be written."""
    try:
        kind = FORMATS.get(Path(path).suffix.lower(), "png")
        files.whole(path, lambda part: figure.savefig(part, format=kind, facecolor="white"))
    finally:
        plt.close(figure)
