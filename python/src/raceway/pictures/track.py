# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot a tracked state, i.e. each unknown with its uncertainty band against time."""

from collections.abc import Mapping

from raceway.files import FilePath
from raceway.pictures.style import INK, PALETTE, drawing
from raceway.recordings.readings import STATE
from raceway.recordings.track import HOUR, Track
from raceway.units import axis


def picture(found: Track, names: Mapping[str, str], path: FilePath) -> None:
    """Plot `found` and write the plot to the PNG file `path`; `names` maps each unknown to its name
    in words. Raises `RunError` if the file cannot be written."""
    size = len(found.names)
    with drawing(path, figsize=(10, 1.2 + 2.1 * size), dpi=120, layout="constrained") as figure:
        all_axes = figure.subplots(size, 1, sharex=True)
        for k, (name, axes) in enumerate(zip(found.names, [all_axes] if size == 1 else all_axes)):
            unit = STATE[name][2]
            factor, shown = (1.0, "°C") if unit == "C" else axis(abs(found.best[:, k]).max(), unit)
            time, colour = found.time / HOUR, PALETTE[k % len(PALETTE)]
            low, high = factor * found.low[:, k], factor * found.high[:, k]
            axes.fill_between(time, low, high, color=colour, alpha=0.25, lw=0)
            axes.plot(time, factor * found.best[:, k], color=INK, lw=1.6)
            axes.set(ylabel=f"{names[name]} ({shown})")
            axes.grid(True)
        axes.set(xlabel="time (h)", xlim=(time[0], time[-1] if len(time) > 1 else time[0] + 1))
