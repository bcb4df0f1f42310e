# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot a spectrum and mark its kinematic lines. Lines that were found are labelled; the others are
dotted."""

from collections.abc import Sequence
from itertools import cycle

import numpy as np
import xarray as xr

from raceway.files import FilePath
from raceway.pictures.page import quantity
from raceway.pictures.style import FAINT, INK, PALETTE, SOFT, drawing
from raceway.runs.source import Source
from raceway.runs.spectrum import COMPLIANCE, NAMES, OUTER_RING, SHAFT, Line
from raceway.units import axis

COLOUR = dict(zip((*NAMES.values(), SHAFT, OUTER_RING, COMPLIANCE), cycle(PALETTE)))
WIDE, NARROW = 0.075, 0.014  # widths of horizontal and vertical labels, as fractions of the axis
PAPER = {"facecolor": "white", "edgecolor": "none", "pad": 1.5, "alpha": 0.85}
DECADES = 6  # range below the largest amplitude that is shown
ROOM = 9.0  # ratio of the amplitudes at which two adjacent rows of labels are drawn


def of_flaw(line: Line) -> str:
    """Return the name of the line to which a sideband belongs, or the line's own name."""
    return line.name.split("+")[0].split("-")[0]


def levels(places: Sequence[float], width: float) -> list[int]:
    """Return row numbers (0, 1 ...) for labels at `places`, each `width` wide, such that the labels
    do not overlap."""
    ends, rows = [], dict.fromkeys(places, 0)
    for place in sorted(rows):
        row = next((k for k, end in enumerate(ends) if place - end >= width), len(ends))
        ends[row:] = [place, *ends[row + 1 :]]
        rows[place] = row
    return [rows[place] for place in places]


def picture(run: Source, spectrum: xr.DataArray, found: Sequence[Line], path: FilePath) -> None:
    """Plot the `spectrum` of `run` (from `raceway.open`, or a recording) with the lines `found` in
    it, and write the plot to the PNG file `path`.

    Raises `RunError` if the picture cannot be written.
    """
    of = spectrum.dims[0]
    frequency, amplitude = spectrum[of].to_numpy(), spectrum.to_numpy()
    last = min(1.08 * max(line.by_cage for line in found), frequency[-1])
    shown = (frequency > 0) & (frequency <= last)
    factor, unit = axis(amplitude[shown].max(), spectrum.attrs["units"])
    top = amplitude[shown].max() * factor
    row = {}
    for faint, width in ((False, WIDE), (True, NARROW)):
        kind = [line for line in found if bool(line.note) == faint]
        row.update(zip(kind, levels([line.by_cage for line in kind], width * last)))
    above = 1 + max((row[line] for line in found if not line.note), default=0)
    with drawing(path, figsize=(12, 5.6), dpi=130, layout="constrained") as figure:
        axes = figure.subplots()
        axes.semilogy(
            frequency[shown], np.maximum(amplitude[shown] * factor, 1e-30), color=INK, lw=1.1
        )
        axes.set(
            xlim=(0, last),
            ylim=(top / 10**DECADES, 1.3 * top * ROOM**above),
            xlabel="order of the shaft" if of == "order" else "frequency (Hz)",
            ylabel=f"amplitude ({unit})" if unit else "amplitude",
        )
        for line in found:
            axes.axvline(
                line.by_cage,
                color=FAINT if line.note else COLOUR[of_flaw(line)],
                lw=1,
                zorder=0.5,
                ls=(0, (1, 2)) if line.note else "-",
            )
            label = line.name if line.harmonic == 1 else f"{line.harmonic}·{line.name}"
            if line.note:
                axes.annotate(
                    label,
                    (line.by_cage, 1.5 * top / 10**DECADES * ROOM ** row[line]),
                    ha="center",
                    va="bottom",
                    fontsize=8.5,
                    color=SOFT,
                    rotation=90,
                    bbox=PAPER,
                )
            else:
                axes.plot(
                    line.found,
                    line.amplitude * factor,
                    "o",
                    ms=6,
                    mfc="none",
                    mec=COLOUR[of_flaw(line)],
                    mew=2,
                )
                axes.annotate(
                    f"{label}\n{line.difference:+.3%}".replace("-", "−"),
                    (line.by_cage, top * ROOM ** (1 + row[line])),
                    ha="center",
                    va="top",
                    fontsize=9,
                    color=INK,
                    fontweight="bold",
                    bbox=PAPER,
                )
        axes.set_title(quantity(spectrum.attrs["long_name"]), pad=26)
        axes.text(0, 1.02, run.title, transform=axes.transAxes, fontsize=10, color=SOFT)
