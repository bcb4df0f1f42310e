# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot a bearing as a capacitor in a run: parts of the capacitance against time, fields around the
ring, and impedance against frequency."""

import numpy as np
import xarray as xr

from raceway.files import FilePath
from raceway.pictures.bode import frequencies, impedance_axes
from raceway.pictures.capacitance_parts import stack
from raceway.pictures.electric_page import around_ring
from raceway.pictures.page import LEFT, RIGHT, against_time, head
from raceway.pictures.style import COLOUR, NAME, PALETTE, SIDES, drawing
from raceway.runs import film_figures
from raceway.runs.run import Run
from raceway.units import prefixed

VARIABLES = ("plates", "around", "unloaded")  # in the order of `PARTS`
BINS = 72  # number of sectors around the ring in the picture of the field


def parts(run: Run, data: xr.Dataset, path: FilePath) -> None:
    """Plot the parts of the capacitance in a `run` against time and write the plot to the PNG file
    `path`; `data` is from `film_figures.over_time`. Raises `RunError` if it cannot be written."""
    layers = np.stack([data[name].to_numpy() for name in VARIABLES])
    with drawing(path, figsize=(10, 6), dpi=110) as figure:
        axes = figure.subplots()
        figure.subplots_adjust(left=LEFT + 0.02, right=RIGHT, bottom=0.11, top=0.81)
        head(figure, run.tables, _below("Parts of the bearing capacitance", data), size=15)
        stack(axes, run.tables.passes(np.arange(layers.shape[1])), layers)
        against_time(axes, run.tables, layers.shape[1])


def field(run: Run, fields: xr.Dataset, voltage: float, path: FilePath) -> None:
    """Plot the largest field in the films around the ring during a `run`, for a `voltage` (V)
    across the bearing, and write the plot to the PNG file `path`; `fields` is from
    `whole_capacitance.fields`. Raises `RunError` if it cannot be written."""
    place = run.balls["from_load_line"].sel(time=fields["time"]).transpose("time", "ball")
    edges = np.linspace(-np.pi, np.pi, BINS + 1)
    which = np.clip(np.digitize(place.to_numpy(), edges) - 1, 0, BINS - 1)
    middle = np.append(edges[:-1] + np.pi / BINS, edges[0] + np.pi / BINS)
    with drawing(path, figsize=(10, 9), dpi=110) as figure:
        axes = figure.add_axes((0.12, 0.085, 0.76, 0.68), projection="polar")
        text = f"Largest field in the films at {prefixed(voltage, 'V')} across the bearing"
        head(figure, run.tables, text, size=14)
        largest = {"field": 0.0, "field_peaks": 0.0}
        for side in SIDES:
            for name, dashes, over in (
                ("field", "-", "over the film"),
                ("field_peaks", (0, (3, 2)), "less 3σ"),
            ):
                values = fields[name].isel(raceway=side).transpose("time", "ball")
                shown = _largest(which, np.abs(values.to_numpy()))
                largest[name] = max(largest[name], np.nanmax(shown, initial=0.0))
                axes.plot(
                    middle,
                    1e-6 * np.append(shown, shown[0]),
                    color=COLOUR[side],
                    ls=dashes,
                    lw=2.2,
                    label=f"{NAME[side]}, {over}",
                )
        around_ring(axes, min(max(largest.values()), 6 * largest["field"]))
        figure.legend(
            *axes.get_legend_handles_labels(),
            loc="upper center",
            bbox_to_anchor=(0.5, 0.885),
            ncols=2,
        )


def bode(run: Run, whole: xr.Dataset, resistivity: float, path: FilePath) -> None:
    """Plot magnitude and phase of the impedance in a `run` against frequency, with mean and range
    over time, for an oil with `resistivity` (ohm m), and write the plot to the PNG file `path`.
    `whole` is from `whole_capacitance.over_time`. Raises `RunError` if it cannot be written."""
    frequency = frequencies(resistivity, 120)
    z = film_figures.spectrum(whole, frequency, resistivity).to_numpy()
    with drawing(path, figsize=(10, 7.6), dpi=110) as figure:
        top, bottom = impedance_axes(figure, LEFT + 0.04)
        head(figure, run.tables, _below("Impedance of the bearing", whole), size=15)
        for axes, values in ((top, np.abs(z)), (bottom, np.degrees(np.angle(z)))):
            axes.fill_between(
                frequency, values.min(0), values.max(0), color=PALETTE[4], alpha=0.6, lw=0,
                label="over the run",
            )  # fmt: skip
            axes.plot(frequency, values.mean(0), color=PALETTE[0], lw=1.6, label="mean")
        top.legend(loc="upper right")
        top.set_xlim(frequency[0], frequency[-1])


def _below(text, data):
    return f"{text}  ·  {data.attrs['filling']}"


def _largest(which, values):
    """Return the largest of the `values` in each sector, shape (BINS,); empty sectors are NaN."""
    found = np.full(BINS, -np.inf)
    np.maximum.at(found, which, np.where(np.isfinite(values), values, -np.inf))
    return np.where(np.isfinite(found), found, np.nan)
