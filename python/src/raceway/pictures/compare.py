# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the envelope spectra of a run and a recording against shaft order, and mark their lines."""

import numpy as np

from raceway.files import FilePath
from raceway.pictures.spectrum import COLOUR, PAPER
from raceway.pictures.style import INK, SOFT, drawing
from raceway.recordings.compare import Comparison
from raceway.units import axis

DECADES = 4  # range below the largest amplitude that is shown


def picture(found: Comparison, path: FilePath) -> None:
    """Plot `found` and write it to the PNG file `path`. Raises `RunError` if it cannot be
    written."""
    last = 1.08 * max(one.nominal for one in found.lines)
    with drawing(path, figsize=(12, 8), dpi=120, layout="constrained") as figure:
        axes = figure.subplots(2, 1, sharex=True)
        for own, side, which in zip(axes, (found.run, found.recording), ("run", "recording")):
            order, amplitude = side.spectrum["order"].to_numpy(), side.spectrum.to_numpy()
            shown = (order > 0.1) & (order <= last)
            factor, unit = axis(amplitude[shown].max(), side.units)
            top = factor * amplitude[shown].max()
            own.semilogy(order[shown], np.maximum(factor * amplitude[shown], 1e-30), color=INK)
            for line in found.lines:
                place = getattr(line, which)
                if np.isfinite(place):
                    label = line.name if line.harmonic == 1 else f"{line.harmonic}·{line.name}"
                    own.axvline(place, color=COLOUR[line.name], lw=1, zorder=0.5)
                    own.annotate(
                        f"{label}\n{place:.4f}",
                        (place, 2 * top),
                        ha="center",
                        fontsize=8,
                        bbox=PAPER,
                    )
            own.set(
                ylim=(top / 10**DECADES, 12 * top),
                ylabel=f"envelope ({unit})" if unit else "envelope",
            )
            own.set_title(side.title, fontsize=10, color=SOFT)
        axes[1].set(xlabel="order of the shaft", xlim=(0, last))
