# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the friction torque by statics with the models `full` with SKF's formula at 40 points of
eight bearings, and the heat at the reference speed of five; writes docs/torque_points.rst.

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


HEAD = """Friction torque compared with SKF's formula
===========================================

This page is written by ``tests/bench/torque_points.py``. It compares the friction torque from
statics with the models ``full`` to that from SKF's formula. Statics assumes conformities of 0.52
and 0.53 (unless the bearing's file specifies others), no clearance, rigid rings, an inner ring that
is free to tilt, and the oil
``vg46`` at the temperature at which it has the stated viscosity. SKF's formula is evaluated for
:math:`\\mu_{bl}` = 0.12, :math:`\\mu_{EHL}` = 0.05 and the same oil. An oil bath reaches the middle
of the lowest ball. No constant is fitted to SKF's formula. The first table lists torques in N mm:
the value from statics, then the value from SKF's formula. Rolling includes hysteresis; sliding is
the sum of slip and spin. A contribution is printed in bold if it differs from SKF's value by a
factor of more than 1.5 and SKF's value is above 10 % of SKF's total torque.
"""

WHY = """*Light load and high speed* (0.02 :math:`C_0`, 10,000 rpm): the rolling torque of deep
groove bearings is 1.17 to 1.51 times SKF's. Friction cannot hold the balls of a 7208B against their
gyroscopic moment. They skid, so they orbit at 0.54 times the speed of the ring instead of 0.42
times, and their drag is 2.5 times SKF's. Statics solves for this motion (:doc:`tribology`), and a
run whose inner ring is held in its plane has the same torque within 0.5 % (153 N mm with a cage
ring; ``tests/scenarios/test_thrust_motion.py``). In a run whose ring is free in its plane, the
skidding balls make the ring whirl, and the mean torque is 201 N mm. With Eyring's stress in the
film (``eyring``) the torque is 133 N mm instead of 147 N mm without the cage's losses, and the mean
coefficient of friction is 0.002 to 0.01 instead of 0.05. The balls of a 7205B slide only slowly;
the torque is 16.6 N mm in statics and in a run and 25.3 N mm according to SKF's formula.

*High load and low speed, combined and axial loads*: rolling is 0.66 to 1.04 times SKF's value, and
sliding 0.55 to 1.0 times unless the cage restrains balls; both ratios are lowest for balls with
spin. SKF's formula adds the radial
load to about twice the axial load. A thrust, however, loads all balls, and a radial load then only
moves load from one half of them to the other: if a radial load of 0.05 :math:`C_0` is added to a
thrust of 0.1 :math:`C_0` on a 7208B at 1000 rpm, SKF's rolling torque rises by 13 %, whereas that
in statics falls by 4 %, as it grows more slowly than the load. Runs whose ring cannot tilt have the
same torque as statics within 1 % (``tests/scenarios/test_statics_and_runs.py``). Sliding grows with
the square of the contact width and thus depends on the conformity of the grooves, which no
catalogue states (see below).

*Balls restrained by the cage*: under a combined load, a ring that is free to tilt makes the balls
of a 7205B and a 7208B run 1.4 to 2.1 mm ahead of and behind one another in pockets with a play of
0.2 and 0.3 mm (:doc:`cage`). They slip, and sliding is 1.9 to 2.0 times SKF's value in these four
points. With a cage ring, which the shares leave out, a 7208B under 0.05 and 0.1 :math:`C_0` has a
torque of 596 N mm in statics, 423 N mm of it at the cage, and of 608 N mm in a run (381 N mm).
"""

CONFORMITY = """Conformity of the grooves
-------------------------

Manufacturers do not publish the groove radii of their bearings. Our defaults are 0.52 and 0.53
times the ball diameter (:doc:`catalogue`). If all bearings are assumed to have the same
conformities, the 40 points give these ratios. With 0.51 and 0.52, the skidding balls of the 7205B
and the 7208B climb over the shoulder of the inner raceway under 0.02 :math:`C_0`, as in a run, and
these two points are left out:
"""


def wrapped(text):
    """Return `text` with its paragraphs wrapped at WIDTH; headings and tables stay as they are."""
    blocks = text.split("\n\n")
    return "\n\n".join(
        block
        if block.startswith((".. ", "   ")) or block.endswith(("===", "---"))
        else textwrap.fill(block, WIDTH, break_long_words=False, break_on_hyphens=False)
        for block in blocks
    )


def page(found, straight, others, heats):
    lines = []
    for name, (radial, axial, rpm, viscosity), own, skf in found:
        wrong = off(own, skf)
        cells = [f"{own[one]:.3g} / {skf[one]:.3g}" for one in SHARES]
        cells = [f"**{cell}**" if one in wrong else cell for one, cell in zip(SHARES, cells)]
        totals = total(own), total(skf)
        lines.append(
            [name, f"{radial:g}, {axial:g}", f"{rpm:g}, {viscosity:g}", *cells,
             "{:.3g} / {:.3g}".format(*totals), f"{totals[0] / totals[1]:.2f}"]
        )  # fmt: skip
    header = ("bearing", "radial, axial load over :math:`C_0`", "rpm, mPa s", *SHARES, "sum",
              "ratio")  # fmt: skip
    heat_lines = [
        [name, f"{rpm:g}", f"{own:.1f}", f"{carried:.1f}", f"{own / carried:.2f}"]
        for name, (rpm, own, carried) in heats.items()
    ]
    text = "\n".join(
        [HEAD, summary(found, straight), "", WHY, *csv_table(header, lines), CONFORMITY,
         *csv_table(("conformities", "points", "geometric mean", "spread", "lowest", "highest",
                     "with a bold contribution"), [others_line(*one) for one in others.items()]),
         "Reference speed", "---------------",
         "",
         "The table compares the heat generated in statics without drag (catalogue's reference"
         " speed, 0.05 :math:`C_0`, vg32 at 12 mm²/s) with the cooling power according to ISO"
         " 15312 at 50 K.", "",
         *csv_table(("bearing", "rpm", "own W", "ISO 15312 W", "ratio"), heat_lines)]
    )  # fmt: skip
    return f"{wrapped(text.rstrip())}\n"


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
        PAGE.write_text(page(found, straight, others, heats))


if __name__ == "__main__":
    main()
