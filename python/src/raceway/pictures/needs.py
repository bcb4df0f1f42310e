# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the result of `raceway needs`: the effect of each choice on each quantity, and its cost."""

import math

import numpy as np
from matplotlib.colors import LogNorm

from raceway.files import FilePath
from raceway.pictures.style import INK, MAP, PALETTE, SOFT, drawing
from raceway.sweeps.needs import Needs
from raceway.sweeps.needs_shown import percent

LEAST, MOST = 1e-4, 1.0  # limits of the scale of relative effects


def picture(found: Needs, path: FilePath) -> None:
    """Plot `found` and write it to the PNG file `path`. Raises `RunError` if it cannot be
    written."""
    words = list(found.figures)
    rows = [(one.picked[0].label, one) for one in found.single]
    rows.append(("cheapest set with the required accuracy", found.best))
    size = (15, 0.36 * len(rows) + 2.6)
    with drawing(path, figsize=size, layout="constrained") as figure:
        effect, cost = figure.subplots(1, 2, width_ratios=(3, 1), sharey=True)
        values = np.array([[one.errors[word] for word in words] for _, one in rows])
        shown = effect.imshow(
            np.where(np.isfinite(values), np.clip(values, LEAST, MOST), np.nan),
            norm=LogNorm(LEAST, MOST),
            cmap=MAP,
            aspect="auto",
        )
        for (i, k), value in np.ndenumerate(values):
            bright = math.isfinite(value) and value > 0.02
            colour = INK if bright or not math.isfinite(value) else "white"
            effect.text(k, i, percent(value), ha="center", va="center", fontsize=9, color=colour)
        effect.set_yticks(range(len(rows)), [label for label, _ in rows])
        effect.set_xticks(range(len(words)), [_head(word, found.wanted) for word in words])
        effect.tick_params(length=0)
        effect.spines[:].set_visible(False)
        effect.set_title("relative effect on the results")
        figure.colorbar(shown, ax=effect, location="bottom", shrink=0.5, aspect=40, pad=0.02)
        costs = [100 * one.cost for _, one in rows]
        colours = [PALETTE[0]] * (len(rows) - 1) + [PALETTE[5]]
        cost.barh(range(len(rows)), np.nan_to_num(costs), color=colours)
        for k, value in enumerate(costs):
            text = f"{value:.0f} %" if math.isfinite(value) else "fails"
            cost.text(np.nan_to_num(value) + 1, k, text, va="center", fontsize=9, color=SOFT)
        cost.axvline(100, color=SOFT, linewidth=0.8)
        cost.set(xlabel="processor time (% of the reference)")
        cost.set_title("cost")
        cost.tick_params(labelleft=False, length=0)
        effect.axhline(len(rows) - 1.5, color="white", linewidth=4)


def _head(word, wanted):
    return word.replace("_", "\n") + (
        f"\nwanted\n{percent(wanted[word])}" if word in wanted else ""
    )
