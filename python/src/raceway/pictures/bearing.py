# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the bearing from the front, cut in its central plane so that the grooves are visible, and in
axial section.

The grooves are the simulated tori. Runs contain neither the thickness and width of the rings beyond
the grooves nor the height of the shoulders, so these are drawn in proportion to the size of the
balls.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, Polygon

from raceway.files import FilePath
from raceway.pictures import style
from raceway.pictures.page import fit
from raceway.pictures.part import largest_load, shown, tracks, within_turn
from raceway.pictures.scene import COLOURS, Scene, scene
from raceway.pictures.style import FAINT, INK, MAP, SOFT
from raceway.runs.measured import rpm, speeds, title
from raceway.runs.tables import RunTables
from raceway.runs.turning import changes
from raceway.theory.bearing import INNER, OUTER
from raceway.units import axis, prefixed

# fractions of the ball diameter: ring thickness behind the grooves, half width, shoulder height
THICK, WIDE, SHOULDER = (0.3, 0.72, 0.2)
STEEL, DARK, LIGHT, CAGE, IDLE = "#c9ced6", 0.52, 0.92, "#efe9dc", "#f4f4f4"
SHADES = 12  # number of shades used to draw a groove
MM = 1e3


def bearing(
    tables: RunTables, path: FilePath, colour: str = "load", factor: float | None = None
) -> None:
    """Draw the run `tables` at the sample with the largest contact load and write the picture to
    the PNG file `path`; `colour` and `factor` are as in `scene`.

    Raises `RunError` if the run's files are invalid or the picture cannot be written.
    """
    tables = shown(tables)
    contacts, largest = tables.contacts, largest_load(tables)
    sample = int(contacts.loc[contacts["load"] == largest, "sample"].iloc[0])
    with plt.rc_context(style.STYLE):
        sheet = Sheet(tables, scene(tables, np.array([sample]), colour, factor), colour)
        sheet.show(0)
        style.save(sheet.figure, path)


class Sheet:
    """A figure that shows the `Scene` `what` of the run `tables`; `show(k)` moves all parts to
    their positions at the k-th sample of the scene."""

    def __init__(self, tables: RunTables, what: Scene, colour: str, dpi: int = 110) -> None:
        self.tables, self.scene, self.geometry = tables, what, tables.geometry
        inner, outer = rpm(tables)
        self.speed = np.abs(inner - outer)
        self.factor, self.unit = axis(np.nanmax(what.values, initial=0.0), COLOURS[colour][2])
        # the scale of the film thickness does not start at zero, because values near zero do not
        # occur
        low = np.nanmin(what.values, initial=np.inf) if colour == "film" else 0.0
        self.norm = plt.Normalize(
            low * self.factor if np.isfinite(low) else 0,
            np.nanmax(what.values, initial=0.0) * self.factor or 1,
        )
        self.map = plt.get_cmap(MAP).with_extremes(bad=IDLE)
        self.figure = plt.figure(figsize=(9.6, 6.0), dpi=dpi)
        self._head()
        self._front(self.figure.add_axes((0.01, 0.02, 0.56, 0.85)))
        bar = self.figure.colorbar(
            plt.cm.ScalarMappable(self.norm, self.map),
            cax=self.figure.add_axes((0.60, 0.12, 0.014, 0.62)),
        )
        bar.set_label(f"{COLOURS[colour][1]} ({self.unit})", fontsize=9.5)
        bar.ax.tick_params(labelsize=9)
        bar.outline.set_edgecolor(FAINT)
        self._section(self.figure.add_axes((0.715, 0.46, 0.26, 0.40)))
        self._around(self.figure.add_axes((0.755, 0.115, 0.21, 0.25)))

    def _head(self):
        fit(
            self.figure.text(
                0.03, 0.955, title(self.tables), fontsize=12.5, fontweight="bold", va="center"
            ),
            0.94,
        )
        self.figure.text(
            0.03,
            0.91,
            f"motions, clearance and overlaps drawn × {self.scene.factor:g}",
            fontsize=9.5,
            color=SOFT,
            va="center",
        )
        self.clock = self.figure.text(0.03, 0.03, "", fontsize=9.5, color=SOFT, va="bottom")

    # ---- from the front
    # -----------------------------------------------------------------------------
    def _front(self, axes):
        geometry, what, size = self.geometry, self.scene, self.geometry.ball_diameter
        outside = geometry.outer_radius + THICK * size + max(what.half_clearance, 0)
        axes.set(
            xlim=np.array([-1.04, 1.04]) * outside * MM,
            ylim=np.array([-1.04, 1.04]) * outside * MM,
            aspect="equal",
        )
        axes.axis("off")
        race = geometry.outer_radius + what.half_clearance
        _disc(axes, outside, STEEL, INK)
        for radius, shade in _groove(race, -1, geometry, OUTER):
            _disc(axes, radius, shade)
        _disc(axes, race, "none", INK)
        _disc(axes, race - SHOULDER * size, "white", SOFT)
        self.inner = [
            _disc(axes, radius, shade)
            for radius, shade in reversed(list(_groove(geometry.inner_radius, 1, geometry, INNER)))
        ]
        self.inner += [
            _disc(axes, geometry.inner_radius + SHOULDER * size, "none", SOFT),
            _disc(axes, geometry.inner_radius, STEEL, INK),
            _disc(axes, geometry.inner_radius - THICK * size, "white", INK),
        ]
        self.mark = _mark(axes)
        self.cage = [
            _disc(axes, self.tables.cage_ball_radius, CAGE, SOFT) for _ in range(what.cage.shape[1])
        ]
        hole = geometry.ball_radius + what.pocket_play / 2
        self.pockets = [_disc(axes, 1.08 * hole, CAGE, SOFT) for _ in range(what.pockets.shape[1])]
        self.pockets += [_disc(axes, hole, "white", SOFT) for _ in range(what.pockets.shape[1])]
        self.balls = [
            _disc(axes, geometry.ball_radius, IDLE, INK) for _ in range(what.balls.shape[1])
        ]
        self.marks = [_mark(axes) for _ in self.balls]
        bore = (geometry.inner_radius - THICK * size) * MM
        way = self._down()
        axes.annotate(
            "",
            0.72 * bore * way,
            -0.05 * bore * way,
            arrowprops={
                "arrowstyle": "-|>",
                "color": INK,
                "lw": 2.2,
                "mutation_scale": 18,
                "shrinkA": 0,
                "shrinkB": 0,
            },
        )
        axes.text(
            *(-0.32 * bore * way),
            f"{prefixed(self.tables.settings['load_N'], 'N')}\n{speeds(self.tables)}",
            ha="center",
            va="center",
            fontsize=11,
        )

    def _down(self):
        azimuth = self.tables.settings["load_azimuth_rad"]
        return np.array([np.cos(azimuth), np.sin(azimuth)])

    # ---- in section
    # ---------------------------------------------------------------------------------
    def _section(self, axes):
        geometry, size = self.geometry, self.geometry.ball_diameter
        axes.set_title(
            "section through the most loaded ball",
            fontsize=9.5,
            fontweight="normal",
            loc="center",
            pad=4,
        )
        outside = geometry.outer_radius + (THICK + 0.06) * size
        inside = geometry.inner_radius - (THICK + 0.06) * size
        # the outward direction points down
        axes.set(
            xlim=np.array([-0.8, 0.8]) * size * MM,
            ylim=(-outside * MM, -inside * MM),
            aspect="equal",
        )
        axes.axis("off")
        self.profiles = []
        for race, sign, groove in (
            (geometry.inner_radius, 1, geometry.inner_groove),
            (geometry.outer_radius + self.scene.half_clearance, -1, geometry.outer_groove),
        ):
            half = np.arccos(max(1 - SHOULDER * size / groove, -1.0))
            angle = np.linspace(-half, half, 41)
            z, r = groove * np.sin(angle), race + sign * groove * (1 - np.cos(angle))
            back = race - sign * THICK * size
            profile = np.column_stack(
                [
                    np.concatenate([[-WIDE * size], z, [WIDE * size, WIDE * size, -WIDE * size]]),
                    np.concatenate([[r[0]], r, [r[-1], back, back]]),
                ]
            )
            self.profiles.append(
                (profile, axes.add_patch(Polygon(profile, fc=STEEL, ec=INK, lw=1)))
            )
        self.cut = axes.add_patch(
            Circle((0, 0), geometry.ball_radius * MM, fc=IDLE, ec=INK, lw=1, zorder=3)
        )

    # ---- around the ring
    # ------------------------------------------------------------------------------
    def _around(self, axes):
        top = largest_load(self.tables)
        factor, unit = axis(top, "N")
        for psi, load in tracks(self.tables, OUTER, "load"):
            axes.plot(*within_turn(psi, load * factor), color=FAINT, lw=2.5)
        self.dots = axes.scatter(
            [], [], s=42, edgecolors=INK, linewidths=1, zorder=3, clip_on=False
        )
        self.load_factor = factor
        axes.set(xlim=(-180, 180), xticks=(-180, -90, 0, 90, 180), ylim=(0, 1.1 * top * factor))
        axes.set_xlabel("azimuth from the load line (°)", fontsize=9.5)
        axes.set_ylabel(f"load ({unit})", fontsize=9.5)
        axes.tick_params(labelsize=9)
        axes.grid(True)

    def show(self, k: int) -> None:
        """Move all parts to their positions at the k-th sample."""
        what, radius = self.scene, self.geometry.ball_radius
        colours = self.map(self.norm(np.ma.masked_invalid(what.values[k] * self.factor)))
        shift = what.ring[k] * MM
        for disc in self.inner:
            disc.set_center(shift[:2])
        turn = what.ring_turned[k]
        middle = (self.geometry.inner_radius - THICK / 2 * 2 * radius) * MM
        self.mark.set_data([shift[0] + middle * np.cos(turn)], [shift[1] + middle * np.sin(turn)])
        places = [*what.cage[k], *what.pockets[k], *what.pockets[k]]
        for disc, place in zip(self.cage + self.pockets, places):
            disc.set_center(place[:2] * MM)
        for disc, mark, place, angle, colour in zip(
            self.balls, self.marks, what.balls[k], what.turned[k], colours
        ):
            disc.set_center(place[:2] * MM)
            disc.set_facecolor(colour)
            spot = place[:2] + 0.6 * radius * np.array([np.cos(angle), np.sin(angle)])
            mark.set_data(*(spot[:, None] * MM))
        azimuth = np.arctan2(what.balls[k, :, 1], what.balls[k, :, 0])
        heaviest = int(np.argmax(what.load[k]))
        self._show_section(k, heaviest, azimuth[heaviest], colours[heaviest])
        self.dots.set_offsets(
            np.column_stack(
                [np.degrees(self.tables.from_load_line(azimuth)), what.load[k] * self.load_factor]
            )
        )
        self.dots.set_facecolors(colours)
        time = what.samples[k] * self.tables.settings["sample_s"]
        now = int(what.samples[k]) - self.tables.first
        speed = f", {self.speed[now]:.4g} rpm" if changes(self.speed) else ""
        self.clock.set_text(
            f"{prefixed(time, 's', 3)},"
            f" {float(self.tables.passes(what.samples[k])):.2f} ball passes{speed}"
        )

    def _show_section(self, k, ball, azimuth, colour):
        what = self.scene
        outwards = np.array([np.cos(azimuth), np.sin(azimuth)])
        inner = np.array([what.ring[k, 2], what.ring[k, :2] @ outwards])
        for (profile, patch), shift in zip(self.profiles, (inner, np.zeros(2))):
            patch.set_xy((profile + shift) * MM * [1, -1])
        self.cut.set_center((what.balls[k, ball, 2] * MM, -np.hypot(*what.balls[k, ball, :2]) * MM))
        self.cut.set_facecolor(colour)


def _disc(axes, radius, face, edge="none"):
    return axes.add_patch(Circle((0, 0), radius * MM, fc=face, ec=edge, lw=1))


def _mark(axes):
    return axes.plot([], [], "o", ms=5, mfc="white", mec=INK, mew=1.1, zorder=4)[0]


def _groove(race, sign, geometry, side):
    """Yield (radius, shade) along the wall of a groove as seen from the front, from its bottom at
    the radius `race` to the shoulder. `sign` is 1 if the shoulder is outside the bottom, and -1
    otherwise."""
    groove = geometry.groove(side)
    for height in np.linspace(0, SHOULDER * geometry.ball_diameter, SHADES):
        # component of the wall's normal in the direction of the viewer
        facing = np.sqrt(1 - (1 - min(height / groove, 1)) ** 2)
        yield race + sign * height, str(DARK + (LIGHT - DARK) * facing)
