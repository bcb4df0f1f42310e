# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot a shaft at rest: its displacement in both planes, and the positions of the bearings."""

import numpy as np

from raceway.files import FilePath
from raceway.pictures.style import FAINT, INK, PALETTE, SOFT, drawing
from raceway.shaft_file import Case
from raceway.theory.shaft import Rest
from raceway.units import axis, prefixed

POINTS = 20  # number of points per cubic segment


def line(z: np.ndarray, moved: np.ndarray, slope: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (z, displacement) along a smooth line through nodes at `z` (N,) with the displacements
    `moved` (N,) and the slopes `slope` (N,)."""
    s = np.linspace(0, 1, POINTS)
    places, values = [], []
    for k in range(len(z) - 1):
        length = z[k + 1] - z[k]
        places.append(z[k] + s * length)
        values.append(
            moved[k] * (1 - 3 * s**2 + 2 * s**3)
            + slope[k] * length * (s - 2 * s**2 + s**3)
            + moved[k + 1] * (3 * s**2 - 2 * s**3)
            + slope[k + 1] * length * (s**3 - s**2)
        )
    return np.concatenate(places), np.concatenate(values)


def picture(case: Case, rest: Rest, path: FilePath) -> None:
    """Plot `rest` of `case` and write the plot to the PNG file `path`. Raises `RunError` if the
    file cannot be written."""
    places = rest.place
    planes = (("x", places[:, 0], places[:, 4]), ("y", places[:, 1], -places[:, 3]))
    factor, unit = axis(np.abs(places[:, :2]).max(), "m")
    with drawing(path, figsize=(11, 6.4), dpi=130, layout="constrained") as figure:
        axes = figure.subplots(2, 1, height_ratios=(3, 1), sharex=True)
        for (name, moved, slope), colour in zip(planes, PALETTE):
            axes[0].plot(*_scaled(line(rest.z, moved, slope), factor), color=colour, label=name)
        axes[0].axhline(0, color=FAINT, lw=1, zorder=0)
        axes[0].set(ylabel=f"transverse displacement ({unit})")
        axes[0].legend(loc="best")
        axes[0].set_title(f"Shaft on {len(case.seats)} bearings", pad=34)
        start = 0.0
        for section in case.shaft.sections:
            for side in (1, -1):
                axes[1].fill_between(
                    1e3 * np.array([start, start + section.length]),
                    side * 5e2 * section.bore,
                    side * 5e2 * section.diameter,
                    color=FAINT,
                    lw=0,
                )
            start += section.length
        for name, one in zip(case.names, rest.bearings):
            at, carried = 1e3 * one.seat.at, float(np.hypot(*one.load[:2]))
            axes[1].axvline(at, color=INK, lw=5, alpha=0.6)
            axes[0].axvline(at, color=SOFT, lw=1, ls=":")
            axes[0].annotate(
                f"{name}\n{prefixed(carried, 'N', 3)}",
                (at, 1.01),
                xycoords=("data", "axes fraction"),
                ha="center",
                va="bottom",
                fontsize=9,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5, "alpha": 0.85},
            )
        axes[1].set(xlabel="z (mm)", ylabel="radius (mm)")


def _scaled(points, factor):
    return 1e3 * points[0], factor * points[1]
