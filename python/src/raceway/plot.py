# SPDX-License-Identifier: GPL-2.0-or-later
"""One picture of a run.

Every ball is drawn as it passes the sampled places, so a curve around the ring is all balls on top of each other; the
width of the band shows how much it matters where the other balls happen to be.
"""

import warnings

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from raceway import style
from raceway.bearing import INNER, OUTER
from raceway.errors import RunWarning
from raceway.run import Run
from raceway.style import BALL, COLOUR, FAINT, INK, NAME, REGIMES, SOFT
from raceway.summary import ring_displacement, summary
from raceway.units import axis, prefixed

LIGHT = 0.01  # of the largest load: below, a film grows as thick as you like, and tells nothing
LARGE, PASSES = 200 << 20, 20  # bytes of contacts.dump from which on only so many ball passes are drawn
LEFT, RIGHT = 0.075, 0.965  # of the figure's width


def overview(run, path):
    """Draw `run` (a `Run`) to the PNG `path`: loads, pressures, and film and capacitance or the ring's path.

    Raises `RunError` when the run's files are broken or the picture cannot be written.
    """
    run, whole = _shown(run), run
    figures = summary(whole)
    film = run.lubricated and {"h_min", "h_c"} <= set(run.contacts)
    with plt.rc_context(style.STYLE):
        figure = plt.figure(figsize=(12, 12) if film else (12, 7.9), dpi=130)
        try:
            _compose(figure, run, figures, film)
            style.save(figure, path)
        finally:
            plt.close(figure)


def _shown(run):
    """The part of `run` that is drawn: all, unless that would be more curves than memory or paper hold."""
    path = run.folder / "contacts.dump"
    if run.stop is not None or not path.exists() or path.stat().st_size < LARGE:
        return run
    warnings.warn(f"{path} is large: the picture shows its first {PASSES} ball passes; the figures are of all", RunWarning,
                  stacklevel=3)
    return Run(run.folder, slice(run.first, run.first + int(PASSES * run.settings["samples_per_pass"])))


def _compose(figure, run, figures, film):
    height = figure.get_figheight()
    title = figure.text(LEFT, 1 - 0.45 / height, _title(figures), fontsize=17, fontweight="bold", va="center")
    room = (RIGHT - LEFT) * figure.bbox.width / title.get_window_extent(figure.canvas.get_renderer()).width
    title.set_fontsize(17 * min(1, room))  # a long name shrinks, it does not run off the page
    figure.text(LEFT, 1 - 0.82 / height, _subtitle(figures), fontsize=11, color=SOFT, va="center")
    edges = {"left": LEFT, "right": RIGHT, "bottom": 0.65 / height}
    if film:
        above = figure.add_gridspec(1, 2, **edges | {"bottom": 5.35 / height}, top=1 - 2.15 / height, wspace=0.16)
        below = figure.add_gridspec(1, 2, **edges, top=4.1 / height, wspace=0.16)
        _loads(figure.add_subplot(above[0], projection="polar"), run)
        _film(figure.add_subplot(above[1], projection="polar"), run)
        _pressures(figure.add_subplot(below[0]), run)
        last = figure.add_subplot(below[1])
    else:
        left = figure.add_gridspec(1, 1, left=LEFT, right=0.5, top=1 - 2.15 / height, bottom=1.0 / height)
        right = figure.add_gridspec(2, 1, left=0.6, right=RIGHT, top=1 - 1.6 / height, bottom=0.65 / height,
                                    hspace=0.46)
        _loads(figure.add_subplot(left[0], projection="polar"), run)
        _pressures(figure.add_subplot(right[0]), run)
        last = figure.add_subplot(right[1])
    (_capacitance if run.lubricated and "capacitance" in run.contacts else _ring)(last, run)


def _title(figures):
    oil = "dry" if figures["viscosity_Pa_s"] is None else f"{figures['lubricant']} lubricant"
    clearance = prefixed(figures["clearance_m"], "m", 3).replace("-", "−")
    return "  ·  ".join((f"{figures['bearing']} ball bearing", f"{prefixed(figures['load_N'], 'N')} radial",
                         f"{figures['rpm']:g} rpm", oil, f"clearance {clearance}"))


def _subtitle(figures):
    parts = (("largest contact load", "q_max_N", "N"), ("inner pressure", "p_max_inner_Pa", "Pa"),
             ("ring shift", "ring_shift_m", "m"), ("inner $h_{min}$", "h_min_m", "m"), ("Λ", "lambda", ""),
             ("mean capacitance", "capacitance_F", "F"))
    return "    ".join(f"{name} {prefixed(figures[key], unit, 3)}" for name, key, unit in parts
                       if figures[key] is not None)


def _tracks(run, raceway, column, above=0.0):
    """(psi, values) of each ball's way past one raceway; psi in rad, unwrapped; NaN where it lost contact.

    Contacts that carry no more than `above` of the largest load count as lost."""
    contacts = run.contacts
    rows = contacts[(contacts["raceway"] == raceway) & (contacts["load"] > above * contacts["load"].max())]
    for _, ball in rows.groupby("ball"):
        psi = np.unwrap(run.from_load_line(ball["azimuth"].to_numpy()))
        gaps = np.flatnonzero(np.diff(ball["sample"].to_numpy()) > 1) + 1
        yield np.insert(psi, gaps, np.nan), np.insert(ball[column].to_numpy(), gaps, np.nan)


def _polar(axes, title, unit, edge):
    axes.set_title(title, pad=54, x=-0.06)
    axes.set_theta_zero_location("S")  # the load line points down, as a weight does
    axes.set_thetagrids(range(0, 360, 45), [f"{angle}°".replace("-", "−")
                                            for angle in (0, 45, 90, 135, 180, -135, -90, -45)])
    axes.tick_params(axis="x", pad=3, labelcolor=SOFT)
    axes.spines["polar"].set_color(FAINT)
    axes.set_ylim(0, edge)
    ticks = [tick for tick in MaxNLocator(4).tick_values(0, edge) if 0 < tick <= edge]
    axes.set_rgrids(ticks, [""] * len(ticks))
    for tick in ticks:  # written over the curves, not under them
        if tick < 0.97 * edge:
            axes.text(np.radians(157.5), tick, f"{tick:g} {unit}", ha="center", va="center", fontsize=10, color=SOFT,
                      zorder=5, bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.75})


def _above(axes, handles):
    return axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(-0.06, 1.075), ncols=len(handles),
                       handlelength=1.5, handletextpad=0.5, columnspacing=1.3, borderaxespad=0, borderpad=0)


def _line(label, **style):
    return Line2D([], [], label=label, **style)


def _loads(axes, run):
    largest = run.contacts["load"].max()
    factor, unit = axis(largest, "N")
    # outer first and wider: without much centrifugal load the inner curve lies on it
    width = {OUTER: 5, INNER: 1.6}
    for side in (OUTER, INNER):
        for psi, load in _tracks(run, side, "load"):
            axes.plot(psi, load * factor, color=COLOUR[side], lw=width[side])
    _polar(axes, "Contact load around the ring", unit, 1.08 * largest * factor)
    _above(axes, [_line(NAME[side], color=COLOUR[side], lw=width[side]) for side in (INNER, OUTER)])
    axes.annotate("", (0.5, -0.155), (0.5, -0.075), xycoords="axes fraction",
                  arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 1.8})
    axes.text(0.525, -0.115, "load on the inner ring", transform=axes.transAxes, ha="left", va="center")


def _film(axes, run):
    loaded = run.contacts[run.contacts["load"] > 5 * LIGHT * run.contacts["load"].max()]  # these set the scale
    factor, unit = axis(loaded["h_c"].max(), "m")
    unity = run.settings["roughness_m"] * factor  # the thickness at which lambda is one
    edge = thickest = 1.12 * loaded["h_c"].max() * factor
    for mark in (1, 3):  # show a limit that is near; do not squash the film for one that is far
        if mark * unity < 3 * thickest:
            edge = max(edge, 1.12 * mark * unity)
    around = np.linspace(0, 2 * np.pi, 361)
    regimes = [(low, high, name, colour) for low, high, name, colour in REGIMES if low * unity < edge]
    for low, high, name, colour in regimes:
        axes.fill_between(around, low * unity, min(high * unity, edge), color=colour, lw=0, zorder=0.1)
        if low:
            axes.plot(around, np.full_like(around, low * unity), color=SOFT, lw=1.2, ls=(0, (1, 1.6)))
            axes.text(np.radians(225), low * unity, f"Λ = {low}", ha="center", va="center", fontweight="bold",
                      zorder=5, bbox={"facecolor": "white", "edgecolor": "none", "pad": 1, "alpha": 0.75})
    width = {"h_c": 3.2, "h_min": 1.3}  # not dashes: those of many balls would fill each other's gaps
    for column in width:
        for side in (OUTER, INNER):
            for psi, thickness in _tracks(run, side, column, above=LIGHT):
                axes.plot(psi, thickness * factor, color=COLOUR[side], lw=width[column])
    _polar(axes, "Film thickness around the ring", unit, edge)
    _above(axes, [_line(f"{side} ${column[0]}_{{{column[2:]}}}$", color=COLOUR[raceway], lw=width[column])
                  for raceway, side in ((INNER, "inner"), (OUTER, "outer")) for column in width])
    axes.add_artist(axes.get_legend())
    axes.legend(handles=[Patch(fc=colour, ec=FAINT, label=name) for *_, name, colour in regimes], loc="upper center",
                bbox_to_anchor=(0.5, -0.085), ncols=len(regimes), handlelength=1.2, columnspacing=1.5,
                borderaxespad=0)
    axes.text(0.5, -0.165, f"contacts above {LIGHT:.0%} of the largest load", transform=axes.transAxes, ha="center",
              va="center", fontsize=9.5, color=SOFT)


def _pressures(axes, run):
    largest = run.contacts["pressure"].max()
    factor, unit = axis(largest, "Pa")
    for side in (OUTER, INNER):
        for psi, pressure in _tracks(run, side, "pressure"):
            turn = 2 * np.pi * np.round(psi / (2 * np.pi))  # back to one turn, without a line across the panel
            breaks = np.flatnonzero(np.diff(turn) != 0) + 1
            axes.plot(np.insert(np.degrees(psi - turn), breaks, np.nan),
                      np.insert(pressure * factor, breaks, np.nan), color=COLOUR[side], lw=2)
    axes.set(xlabel="azimuth from the load line (°)", ylabel=f"largest contact pressure ({unit})", xlim=(-180, 180),
             xticks=range(-180, 181, 45))
    _below(axes, "Hertz pressure", 1.22 * largest * factor,
           [_line(NAME[side], color=COLOUR[side], lw=2.2) for side in (INNER, OUTER)])


def _capacitance(axes, run):
    total = run.bearing_capacitance
    factor, unit = axis(total.max(), "F")
    samples = np.arange(len(total))
    each = run.pairs.pivot(index="sample", columns="ball", values="capacitance").reindex(samples)
    axes.plot(run.passes(samples), each * factor, color=BALL, lw=1.5)
    axes.plot(run.passes(samples), total * factor, color=INK, lw=2.4)
    axes.set_ylabel(f"capacitance ({unit})")
    _against_time(axes, run, len(total))
    _below(axes, "Capacitance", 1.22 * total.max() * factor,
           [_line("bearing", color=INK, lw=2.4), _line("one ball, inner and outer in series", color=BALL, lw=1.6)])


def _ring(axes, run):
    shift = ring_displacement(run)
    factor, unit = axis(np.abs(shift).max(), "m")
    axes.plot(run.passes(run.rings["sample"]), shift * factor, color=INK, lw=2)
    axes.set_ylabel(f"inner ring ({unit})")
    _against_time(axes, run, len(shift))
    _below(axes, "Ring shift along the load", None, [])
    low, high = shift.min() * factor, shift.max() * factor
    half = max(0.75 * (high - low), 0.01 * abs(high)) or 1  # steady to a per cent looks steady
    axes.set_ylim((low + high) / 2 - half, (low + high) / 2 + half)


def _against_time(axes, run, samples):
    axes.set(xlabel="time (ball passes)", xlim=(0, run.passes(max(samples - 1, 1))))
    axes.xaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 5, 10]))


def _below(axes, title, top, handles):
    axes.set_title(title, pad=10)
    axes.grid(True)
    if top is not None:
        axes.set_ylim(0, top or 1)
    if handles:
        axes.legend(handles=handles, loc="upper left", ncols=len(handles), handlelength=1.6, borderaxespad=0.2,
                    frameon=True, facecolor="white", edgecolor="none", framealpha=1)
