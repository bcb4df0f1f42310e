# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot a signal against time and frequency or order, with the names of the kinematic lines on the
right and the shaft speed at the top."""

import numpy as np
import xarray as xr
from matplotlib.colors import LogNorm

from raceway.files import FilePath
from raceway.pictures.page import quantity
from raceway.pictures.spectrum import COLOUR, levels
from raceway.pictures.style import FAINT, INK, MAP, SOFT, drawing
from raceway.runs import spectrum
from raceway.runs.source import Source
from raceway.units import axis

DECADES = 2.5  # range of the colour scale below the largest amplitude, in decades
POWER = 0.98  # fraction of the signal's power below the upper limit of the vertical axis
MOST = 800  # largest number of rows and columns that are plotted
LABEL = 0.036  # height of a name, as a fraction of the axis height
HARMONICS = {"BPFO": (1, 2, 3), "BPFI": (1, 2, 3), "BSF": (2,)}  # for other lines, only the first


def picture(run: Source, found: xr.DataArray, path: FilePath) -> None:
    """Plot `found`, the result of `time_frequency.of_run` for `run`, and write the plot to the PNG
    file `path`.

    Raises `RunError` if the picture cannot be written.
    """
    upright = found.dims[0]
    places = _lines(run, found)
    top = _top(found, places)
    shown = found.isel({upright: (found[upright] > 0) & (found[upright] <= top)})
    shown = shown[:: -(-shown.shape[0] // MOST), :: -(-shown.shape[1] // MOST)]
    factor, unit = axis(float(shown.max()), found.attrs["units"])
    values = np.maximum(shown.to_numpy() * factor, 1e-30)
    with drawing(path, figsize=(12, 7.2), dpi=110, layout="constrained") as figure:
        above, main = figure.subplots(2, 1, sharex=True, height_ratios=(1, 5))
        mesh = main.pcolormesh(
            shown["time"],
            shown[upright],
            values,
            norm=LogNorm(values.max() / 10**DECADES, values.max()),
            cmap=MAP,
            rasterized=True,
            shading="nearest",
        )
        main.set(
            xlabel="time (s)",
            ylabel="order of the shaft" if found.attrs["orders"] else "frequency (Hz)",
            ylim=(0, top),
            xlim=(float(shown["time"][0]), float(shown["time"][-1])),
        )
        _name(main, {key: place for key, place in places.items() if place < top}, top)
        samples, sample_s = found.attrs["samples"], found.attrs["sample_s"]
        time, speed = np.arange(samples) * sample_s, np.abs(run.shaft_speed(samples)) * 30 / np.pi
        thin = slice(None, None, -(-len(time) // MOST))
        above.plot(time[thin], speed[thin], color=INK, lw=1.6)
        above.set(ylabel="shaft (rpm)", ylim=(0, 1.15 * speed.max()))
        above.grid(True)
        above.tick_params(labelbottom=False)
        # at the bottom, because the names of the lines are on the right
        bar = figure.colorbar(mesh, ax=main, location="bottom", shrink=0.4, aspect=40, pad=0.01)
        bar.set_label(f"amplitude ({unit})" if unit else "amplitude")
        bar.outline.set_edgecolor(FAINT)
        above.set_title(_head(found), pad=26)
        above.text(0, 1.1, run.title, transform=above.transAxes, fontsize=10, color=SOFT)


def _lines(run, found):
    """Return {(name, harmonic): position on the vertical axis} for the lines whose frequencies are
    known from the cage speed."""
    which = 0 if found.attrs["orders"] else 1
    return {
        (name, n): place[which]
        for (name, n), place in spectrum.places(run).items()
        if n in HARMONICS.get(name, (1,))
    }


def _top(found, places):
    """Return the upper limit of the vertical axis. For an envelope it is above all lines, and for a
    signal it is above most of the power."""
    upright = found[found.dims[0]].to_numpy()
    if "band" in found.attrs:
        return min(1.1 * max(places.values()), upright[-1])
    power = np.cumsum((found.to_numpy()[1:] ** 2).sum(axis=1))
    most = upright[1 + np.searchsorted(power, POWER * power[-1])]
    return min(1.2 * most, upright[-1])


def _name(axes, places, top):
    """Draw dotted lines, with their names on the right of the plot."""
    if not places or max(places.values()) < 0.15 * top:
        return  # all lines are close to the lower edge of the plot
    row = levels(list(places.values()), LABEL * top)
    for ((name, n), place), level in zip(places.items(), row):
        axes.axhline(place, color="white", lw=0.8, ls=(0, (1, 5)))
        axes.annotate(
            name if n == 1 else f"{n}·{name}",
            (1.0, place),
            xycoords=axes.get_yaxis_transform(),
            xytext=(4 + 44 * level, 0),
            textcoords="offset points",
            va="center",
            fontsize=9,
            color=COLOUR[name],
        )


def _head(found):
    name = quantity(found.attrs["long_name"])
    if "band" not in found.attrs:
        return name
    low, high = found.attrs["band"]
    return f"{name}, {low:g} to {high:g} Hz"
