# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the closed-form expression for the total capacitance of a contact with numerical
integrals at both raceways, for various ball sizes, conformities, loads and films, and write
build/bench/capacitance_error.rst.

    .venv/bin/python tests/bench/capacitance_error.py [--print]     --print: do not write the page

The exit code is 1 if the error in a row exceeds the stated limit.
"""

import sys
from typing import NamedTuple

import numpy as np
from machine import ROOT, csv_table, publish
from raceway import capacitance, capacitance_outside, groove_width, hertz
from raceway.theory.bearing import INNER, OUTER, Bearing

sys.path.insert(0, str(ROOT / "tests"))  # as pytest.ini does
from references import capacitance_integral  # noqa: E402

SIZES = {"12.6 mm": 60.6e-3, "7.938 mm": 39.04e-3, "3.968 mm": 15e-3}  # {ball: pitch diameter (m)}
CONFORMITIES = (0.505, 0.51, 0.52, 0.53, 0.54)
SEPARATIONS = np.geomspace(20e-9, 2e-6, 7)  # m
LOADS = (0.1, 1.0, 10.0, 100.0, 300.0, 1000.0, 2000.0, 3000.0)  # N; at zero load, the gap is rigid
PLAYS = np.array([5e-6, 10e-6, 20e-6])  # m
PERMITTIVITY = 2.2
PROMISE = 0.015
PAGE = """\
:doc:`../electric` gives a closed-form expression for the capacitance of a contact and its
surroundings. Here it is compared with numerical integrals. The error refers to the sum of the
capacitances of plates and surroundings. The oil has a relative permittivity of {permittivity} at
ambient pressure. Each row covers {count} points: loads of {loads} N at seven film thicknesses from
20 nm to 2 µm. At zero load, the gap is rigid and has the same separations.

* *arc*: the reference is the integral over a circular groove with a depth of {depth:g} ball
  diameters.
* *parabola*: the reference is the integral that the closed-form expression approximates, over a
  parabola of the same half-width.
* *rigid*: the gap at zero load is compared with the arc.
* *play*: the gap at zero load, with a play of 5, 10 and 20 µm, is compared with the arc.
* *left out*: loads at which the contact reaches the shoulder and is no longer an ellipse
  (:doc:`../scope`).

The largest error in the first three columns is {worst:.2f} %; the stated limit is {promise:.1f} %.

The largest errors in per cent are:

{table}
"""
HEADS = ("ball diameter", "conformity", "raceway", "arc", "parabola", "rigid", "play", "left out")


class Errors(NamedTuple):
    """The largest relative errors for one row of the table."""

    arc: float
    parabola: float
    rigid: float
    play: float
    left: tuple[float, ...]  # N, loads that are excluded

    @property
    def inside(self) -> float:
        """The largest error in the range that the stated limit covers."""
        return max(self.arc, self.parabola, self.rigid)


def bearing(size: str, conformity: float) -> Bearing:
    """Return a bearing with one of the ball sizes listed on the page."""
    ball, pitch = 1e-3 * float(size.split()[0]), SIZES[size]
    groove = conformity * ball
    return Bearing(9, ball, (pitch - ball) / 2, (pitch + ball) / 2, groove, groove)


def errors(size: str, conformity: float, raceway: int) -> Errors:
    """Return the `Errors` for one row."""
    one = bearing(size, conformity)
    depth = groove_width.USUAL_DEPTH * one.ball_diameter
    r_x, r_y = (float(radius) for radius in one.effective_radii(raceway))
    ellipse, modulus = hertz.exact(r_x, r_y), one.effective_modulus
    widths = groove_width.half_widths(one, raceway, depth)
    half_angle = groove_width.shoulder_angle(one.groove(raceway), one.ball_radius, depth)
    arc, parabola, left = [0.0], [0.0], []
    for load in LOADS:
        a, b = hertz.semi_axes(ellipse, modulus, load)
        if a > one.ball_radius * half_angle:
            left.append(load)
            continue
        around = groove_width.half_widths(one, raceway, depth, semi_axis=a)
        pressed = capacitance.permittivity(PERMITTIVITY, 1.5 * load / (np.pi * a * b))
        plates = pressed * np.pi * a * b / SEPARATIONS
        form = capacitance_outside.loaded(ellipse, modulus, r_x, load, SEPARATIONS, around)
        groove = capacitance_integral.arc(one, raceway, load, SEPARATIONS, depth)
        plane = capacitance_integral.parabola(r_x, r_y, modulus, load, SEPARATIONS, around.near)
        off = [
            float(np.abs((form - exact) / (plates / PERMITTIVITY + exact)).max())
            for exact in (groove, plane)
        ]
        arc.append(off[0])
        parabola.append(off[1])
    return Errors(
        max(arc),
        max(parabola),
        *(_rigid(one, raceway, r_x, depth, widths, gaps) for gaps in (SEPARATIONS, PLAYS)),
        tuple(left),
    )


def _rigid(one, raceway, r_x, depth, widths, gaps):
    ellipse = hertz.exact(r_x, one.effective_radii(raceway)[1])
    form = capacitance_outside.rigid(
        ellipse, r_x, one.ball_radius, one.groove(raceway), gaps, widths
    )
    return float(np.abs(form / capacitance_integral.rigid_arc(one, raceway, gaps, depth) - 1).max())


def row(size: str, conformity: float, raceway: int, found: Errors) -> tuple[str, ...]:
    """Return one row of the table."""
    left = ", ".join(f"{load:g} N" for load in found.left)
    percent = (f"{100 * error:.2f}" for error in found[:4])
    return (size, f"{conformity:g}", ("inner", "outer")[raceway], *percent, left or "none")


def main() -> int:
    """Compute the errors and write the page."""
    places = [(size, f, side) for size in SIZES for f in CONFORMITIES for side in (INNER, OUTER)]
    found = {place: errors(*place) for place in places}
    worst = max(one.inside for one in found.values())
    publish(
        "Error of the closed-form capacitance",
        PAGE,
        permittivity=PERMITTIVITY,
        count=len(SEPARATIONS) * (1 + len(LOADS)),
        loads=", ".join(f"{load:g}" for load in LOADS),
        depth=groove_width.USUAL_DEPTH,
        worst=100 * worst,
        promise=100 * PROMISE,
        table=csv_table(HEADS, [row(*place, one) for place, one in found.items()]),
    )
    return worst >= PROMISE


if __name__ == "__main__":
    sys.exit(main())
