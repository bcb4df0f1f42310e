# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the friction torque by statics with the models `full` with SKF's formula at 40 points of
eight bearings, and the heat at the reference speed of five; write the tables and the mean ratios
of docs/torque_points.rst.

    .venv/bin/python tests/bench/torque_points.py [--no-page]

In statics and in SKF's formula an oil bath reaches the middle of the lowest ball. SKF's rolling
moment includes hysteresis.
"""

import argparse
import math
import textwrap
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from machine import csv_table
from raceway import inputs, makers
from raceway.errors import NoEquilibrium
from raceway.theory import heat
from raceway.theory.cage_drag import CageRing
from raceway.theory.heat_scene import Scene
from raceway.theory.operating_point import figures
from raceway.theory.static import STRAIGHT
from scipy.optimize import brentq

ROOT = Path(__file__).resolve().parents[2]
INPUTS = ROOT / "inputs"
OIL = "vg46"
PAGE = ROOT / "docs/torque_points.rst"
# radial and axial load over C0, rpm, viscosity in mPa s
DEEP = [
    (0.02, 0.0, 10000.0, 5.0),
    (0.1, 0.0, 3000.0, 20.0),
    (0.3, 0.0, 250.0, 100.0),
    (0.1, 0.1, 1500.0, 40.0),
    (0.0, 0.1, 1000.0, 20.0),
]
ANGULAR = [
    (0.0, 0.02, 10000.0, 5.0),
    (0.0, 0.1, 3000.0, 20.0),
    (0.0, 0.3, 250.0, 100.0),
    (0.1, 0.2, 1500.0, 40.0),
    (0.05, 0.1, 1000.0, 20.0),
]
POINTS = {
    **dict.fromkeys(("6010", "6204", "6205", "6208", "6308", "6310"), DEEP),
    **dict.fromkeys(("7205B", "7208B"), ANGULAR),
}
REFERENCE = ("6204", "6205", "6208", "6306", "6310")
SHARES, CAGE = ("rolling", "sliding", "drag"), "cage"
CONFORMITIES = ((0.51, 0.52), (0.515, 0.525), (0.52, 0.53))
MOST_OFF = 1.5  # largest acceptable factor between shares above LEAST of SKF's torque
LEAST = 0.1
WIDTH = 120  # of a line of text on a page


def temperature(viscosity):
    """Return the temperature in C at which the oil has a `viscosity` in Pa s."""
    path = INPUTS / "lubricants" / OIL
    return brentq(lambda at: inputs.fluid(path, at).viscosity - viscosity, -10.0, 180.0, xtol=1e-9)


def shares(parts, speed):
    """Return {share or CAGE: torque in N mm} for the losses `parts` in W at a `speed` in rad/s."""
    torque = {part: 1e3 * power / speed for part, power in parts.items()}
    return {
        "rolling": torque["rolling"] + torque["hysteresis"],
        "sliding": torque["slip"] + torque["spin"],
        "drag": torque["drag"],
        CAGE: torque["cage"],
    }


def with_grooves(name, folder, conformity):
    """Write a data file of the bearing with (inner, outer) `conformity` and return its path."""
    known = dict(inputs.values(INPUTS / "bearings" / name))
    sizes = (float(share) * float(known["ball_diameter"]) for share in conformity)
    known.update(zip(("inner_groove", "outer_groove"), sizes))
    path = Path(folder) / name
    path.write_text("".join(f"variable {one} index {value}\n" for one, value in known.items()))
    return path


def point(path, radial, axial, rpm, viscosity, held=None):
    """Return (our shares, SKF's shares) of the torque of the bearing in a data file, N mm. The ring
    is free to tilt unless its tilts are `held`."""
    at, boundary = temperature(1e-3 * viscosity), inputs.boundary(path)
    loads = [share * boundary.static_rating for share in (radial, axial)]
    one = figures(
        str(path),
        OIL,
        INPUTS,
        load=loads[0],
        axial=loads[1],
        rpm=rpm,
        temperature=at,
        models="full",
        cage=CageRing(),
        held=held,
    )
    kinematic = inputs.fluid(INPUTS / "lubricants" / OIL, at).kinematic
    level = 500 * inputs.bearing(path).ball_diameter
    skf = makers.skf(boundary, *loads, rpm, kinematic, level=level)
    wanted = {share: float(getattr(skf, share)) for share in SHARES}
    return shares(one["losses_W"], rpm * math.pi / 30), wanted


def reference(name):
    """Return (reference speed of the catalogue in rpm, heat at this speed without drag in W,
    cooling power in W)."""
    path = INPUTS / "bearings" / name
    boundary, fluid = inputs.boundary(path), inputs.lubricant(INPUTS / "lubricants/vg32")
    rpm = float(inputs.values(path)["reference_speed"])
    warm = brentq(lambda at: fluid.at(at).kinematic - heat.REFERENCE_VISCOSITY, 40.0, 110.0)
    scene = Scene(
        inputs.bearing(path), fluid, 1e-7, 0.05 * boundary.static_rating, 0.0, rpm,
        size=inputs.size(path),
    )  # fmt: skip
    losses = scene.at(warm, 0.0)["losses_W"]
    carried = heat.RISE * heat.cooling(boundary.bore, boundary.outside, boundary.width)
    return rpm, sum(losses.values()) - losses["drag"], carried


def rows(conformity=None, held=None):
    """Return [(name, point, our shares, SKF's shares), ...] for all points at which there is an
    equilibrium. A `conformity` replaces the grooves in the files; `held` is as in `point`."""
    found = []
    with TemporaryDirectory() as folder:
        for name, points in POINTS.items():
            path = (
                with_grooves(name, folder, conformity) if conformity else INPUTS / "bearings" / name
            )
            for one in points:
                with suppress(NoEquilibrium):
                    found.append((name, one, *point(path, *one, held)))
    return found


def off(own, skf):
    """Return the shares above LEAST of SKF's torque that differ by a factor of more than
    MOST_OFF."""
    large = [share for share in SHARES if skf[share] > LEAST * total(skf)]
    return [share for share in large if not 1 / MOST_OFF <= own[share] / skf[share] <= MOST_OFF]


def tables(found, others, heats):
    """Return the rows of the tables of the page, in their order."""
    points = []
    for name, (radial, axial, rpm, viscosity), own, skf in found:
        wrong = off(own, skf)
        cells = [f"{own[one]:.3g} / {skf[one]:.3g}" for one in SHARES]
        cells = [f"**{cell}**" if one in wrong else cell for one, cell in zip(SHARES, cells)]
        totals = total(own), total(skf)
        points.append(
            [name, f"{radial:g}, {axial:g}", f"{rpm:g}, {viscosity:g}", *cells,
             "{:.3g} / {:.3g}".format(*totals), f"{totals[0] / totals[1]:.2f}"]
        )  # fmt: skip
    heat_lines = [
        [name, f"{rpm:g}", f"{own:.1f}", f"{carried:.1f}", f"{own / carried:.2f}"]
        for name, (rpm, own, carried) in heats.items()
    ]
    return points, [others_line(*one) for one in others.items()], heat_lines


def page(text, first, rows):
    """Return the `text` of the page with `first` as the paragraph that begins with its first words,
    and with new rows below the headings of its tables."""
    start = first[:12]
    blocks = iter(rows)
    found = []
    for block in text.split("\n\n"):
        if block.startswith(start):
            block = textwrap.fill(first, WIDTH, break_long_words=False, break_on_hyphens=False)
        elif block.startswith("   ") and not block.startswith("   :"):
            heading = block.split("\n")[0]
            block = "\n".join([heading, *csv_table((), next(blocks))[4:-1]])
        found.append(block)
    return "\n\n".join(found).rstrip() + "\n"


def total(torques, names=SHARES):
    return sum(torques[name] for name in names)


def numbers(found, names=SHARES):
    """Return (geometric mean, spread, least, most) of the ratios between the sums of our torques
    `names` and SKF's sums, and the number of points with a share that is too far off."""
    ratio = np.array([total(own, names) / total(skf) for _, _, own, skf in found])
    log = np.log(ratio)
    wrong = sum(bool(off(own, skf)) for _, _, own, skf in found)
    return np.exp(log.mean()), np.exp(log.std(ddof=1)), ratio.min(), ratio.max(), wrong


def others_line(conformity, found):
    mean, spread, *ends, wrong = numbers(found)
    return ["{:g}, {:g}".format(*conformity), len(found), f"{mean:.3f}", f"×/÷ {spread:.3f}",
            *(f"{one:.2f}" for one in ends), wrong]  # fmt: skip


def summary(found, straight):
    mean, spread, least, most, wrong = numbers(found)
    with_cage, held = numbers(found, (*SHARES, CAGE)), numbers(straight)
    return (
        f"Ratio of the {len(found)} sums: geometric mean {mean:.3f}, spread ×/÷ {spread:.3f}, from"
        f" {least:.2f} to {most:.2f}. {wrong} points have a contribution in bold. With the losses"
        " of a cage ring, which ``raceway static`` includes by default, the mean is"
        f" {with_cage[0]:.3f} and the spread ×/÷ {with_cage[1]:.3f}. If the ring cannot tilt, as by"
        f" default in ``raceway static`` and in runs, the mean is {held[0]:.3f}, the spread ×/÷"
        f" {held[1]:.3f} and the range {held[2]:.2f} to {held[3]:.2f}, and {held[4]} points have a"
        " contribution that would be in bold."
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--no-page", action="store_true", help="print only")
    found, heats = rows(), {name: reference(name) for name in REFERENCE}
    straight = rows(held=STRAIGHT)
    for name, (radial, axial, rpm, viscosity), own, skf in found:
        cells = "  ".join(f"{own[one]:8.2f} {skf[one]:8.2f}" for one in SHARES)
        ratio = total(own) / total(skf)
        print(f"{name:6} {radial:5g} {axial:5g} {rpm:6g} {viscosity:4g}  {cells}  {ratio:5.2f}",
              *off(own, skf))  # fmt: skip
    for name, (rpm, own, carried) in heats.items():
        print(f"{name:6} {rpm:6g} rpm {own:7.2f} W of {carried:7.2f} W {own / carried:.2f}")
    print(summary(found, straight))
    others = {one: rows(one) for one in CONFORMITIES}
    for conformity, points in others.items():
        print(*others_line(conformity, points))
    if not parser.parse_args().no_page:
        new = page(PAGE.read_text(), summary(found, straight), tables(found, others, heats))
        PAGE.write_text(new)


if __name__ == "__main__":
    main()
