# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the electric field in the films around the ring, computed from statics."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from raceway.files import FilePath
from raceway.pictures.electric_page import around_ring, head
from raceway.pictures.style import COLOUR, NAME, SOFT, drawing
from raceway.theory import film_voltage
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.electric_point import Point
from raceway.units import prefixed


def field(
    points: Sequence[Point], names: Mapping[str, Any], voltage: float, path: FilePath
) -> None:
    """Plot the field in every film around the ring for a `voltage` (V) across the bearing and write
    the plot to the PNG file `path`. The `points` differ only in the positions of the balls; `names`
    is from `electric_point.figures`. Raises `RunError` if the file cannot be written."""
    azimuth = np.concatenate([np.mod(point.state.azimuth, 2 * np.pi) for point in points])
    order = np.argsort(azimuth)
    found = [point.capacitors() for point in points]
    sigma = points[0].oil.roughness
    curves = {}
    for index, side in enumerate((INNER, OUTER)):
        share, gap = (
            np.concatenate(values)[order]
            for values in zip(
                *(
                    (
                        film_voltage.divided(voltage, one.inner.total, one.outer.total)[index],
                        (one.inner, one.outer)[index].separation,
                    )
                    for one in found
                )
            )
        )
        curves[side] = [
            film_voltage.field(share, film_voltage.local_gap(gap, rough)) for rough in (0.0, sigma)
        ]
    smooth = max(curves[side][0].max() for side in curves)
    rough = [values[1][np.isfinite(values[1])].max(initial=0.0) for values in curves.values()]
    edge = min(max([smooth, *rough]), 6 * smooth)
    around = np.append(azimuth[order], azimuth[order][0] + 2 * np.pi)
    with drawing(path, figsize=(9.5, 8.6), dpi=110) as figure:
        axes = figure.add_axes((0.1, 0.085, 0.8, 0.7), projection="polar")
        head(figure, names, f"Field in the films at {prefixed(voltage, 'V')} across the bearing")
        for side in (OUTER, INNER):
            for values, dashes, text in zip(
                curves[side], ("-", (0, (3, 2))), ("over $h_c$", "over $h_c - 3σ$")
            ):
                if not np.isfinite(values).any() or (dashes != "-" and sigma == 0):
                    continue
                shown = np.where(values <= edge, values, np.nan) * 1e-6
                axes.plot(
                    around,
                    np.append(shown, shown[0]),
                    color=COLOUR[side],
                    lw=3.2 if side == OUTER else 1.6,
                    ls=dashes,
                    label=f"{NAME[side]}, {text}",
                )
        around_ring(axes, edge)
        axes.tick_params(axis="y", labelsize=9, labelcolor=SOFT)
        for label in axes.get_yticklabels():  # a curve may pass behind a label
            label.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 1, "alpha": 0.8})
            label.set_zorder(5)
        handles, labels = axes.get_legend_handles_labels()
        figure.legend(
            handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0.885), ncols=2,
            frameon=False,
        )  # fmt: skip
