# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the friction torque by statics with the models `full` with SKF's formula at 40 points of
eight bearings, and the heat at the reference speed of five; writes docs/torque_points.rst.

    .venv/bin/python tests/bench/torque_points.py [--no-page]

The bearings meet the conditions for which SKF's formula holds: aligned rings, normal operating
clearance and at least the minimum load. An oil bath reaches the middle of the lowest ball. SKF's
rolling moment includes hysteresis.
"""

import argparse
import math
import textwrap
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

import numpy as np
from machine import csv_table
from raceway import clearance_classes, inputs, makers
from raceway.errors import NoEquilibrium
from raceway.theory import asperity, contact_friction, heat
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
    (0.0, 0.05, 10000.0, 5.0),  # 0.02 C0 of a 7208B is below SKF's minimum load
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
DEEP_GROOVES = (0.518, 0.528)  # give SKF's contact angle (tests/python/test_makers.py)
WEIGHTLESS = 1.0  # kg/m^3, density of balls without centrifugal forces
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


def skf_grooves(name):
    """Return the conformities that SKF's formula implies, or None where it implies none."""
    return None if name.endswith("B") else DEEP_GROOVES


@contextmanager
def data_file(name, conformity):
    """Yield the path of the bearing's data file, with the (inner, outer) `conformity` unless it is
    None."""
    path = INPUTS / "bearings" / name
    if conformity is None:
        yield path
        return
    known = dict(inputs.values(path))
    sizes = (float(share) * float(known["ball_diameter"]) for share in conformity)
    known.update(zip(("inner_groove", "outer_groove"), sizes))
    with TemporaryDirectory() as folder:
        changed = Path(folder) / name
        text = "".join(f"variable {one} index {value}\n" for one, value in known.items())
        changed.write_text(text)
        yield changed


def point(path, radial, axial, rpm, viscosity, held, density=None):
    """Return (our shares, SKF's shares) of the torque of the bearing in a data file, N mm. `held`
    are the held tilts of the ring, and `density` in kg/m^3 replaces that of the balls."""
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
        density=density,
    )
    kinematic = inputs.fluid(INPUTS / "lubricants" / OIL, at).kinematic
    level = 500 * inputs.bearing(path).ball_diameter
    skf = makers.skf(boundary, *loads, rpm, kinematic, level=level)
    wanted = {share: float(getattr(skf, share)) for share in SHARES}
    return shares(one["losses_W"], rpm * math.pi / 30), wanted


def reference(name):
    """Return (reference speed of the catalogue in rpm, heat at this speed without drag in W,
    cooling power in W) for the middle of the normal clearance, as in ISO 15312."""
    with data_file(name, skf_grooves(name)) as path:
        boundary, fluid = inputs.boundary(path), inputs.lubricant(INPUTS / "lubricants/vg32")
        rpm = float(inputs.values(path)["reference_speed"])
        warm = brentq(lambda at: fluid.at(at).kinematic - heat.REFERENCE_VISCOSITY, 40.0, 110.0)
        scene = Scene(
            inputs.bearing(path), fluid, 1e-7, 0.05 * boundary.static_rating, 0.0, rpm,
            size=inputs.size(path),
        )  # fmt: skip
    normal = clearance_classes.of_bore(1e-3 * boundary.bore)["CN"]
    losses = scene.at(warm, sum(normal) / 2)["losses_W"]
    carried = heat.RISE * heat.cooling(boundary.bore, boundary.outside, boundary.width)
    return rpm, sum(losses.values()) - losses["drag"], carried


def rows(grooves=skf_grooves, held=STRAIGHT, density=None):
    """Return [(name, point, our shares, SKF's shares), ...] for all points at which there is an
    equilibrium. `grooves` is a function that returns the conformities of the bearing with a name;
    `held` and `density` are as in `point`."""
    found = []
    for name, points in POINTS.items():
        with data_file(name, grooves(name)) as path:
            for one in points:
                with suppress(NoEquilibrium):
                    found.append((name, one, *point(path, *one, held, density)))
    return found


def weightless():
    """Return `rows` without centrifugal forces, neither in statics nor in SKF's formula."""
    still = {
        series: (r1, r2, 0.0, s1, s2, 0.0)
        for series, (r1, r2, _, s1, s2, _) in makers.ANGULAR.items()
    }
    with patch.dict(makers.ANGULAR, still):
        return rows(density=WEIGHTLESS)


def off(own, skf):
    """Return the shares above LEAST of SKF's torque that differ by a factor of more than
    MOST_OFF."""
    large = [share for share in SHARES if skf[share] > LEAST * total(skf)]
    return [share for share in large if not 1 / MOST_OFF <= own[share] / skf[share] <= MOST_OFF]


HEAD = """Friction torque compared with SKF's formula
===========================================

This page is written by ``tests/bench/torque_points.py``. It compares the friction torque from
statics with the models ``full`` and a cage ring to that from SKF's formula. No constant is fitted
to SKF's formula. SKF's model is valid for aligned bearings with normal operating clearance under at
least the minimum load (General Catalogue 6000, 2006, pages 89 and 101 of the Russian edition,
called *GC* below). The inner ring therefore cannot tilt, and there is no clearance (see below). The
rings are rigid, the conformities are 0.518 and 0.528 in deep groove bearings (see below) and 0.52
and 0.53 in angular contact bearings, and the oil is ``vg46`` at the temperature at which it has the
stated viscosity. An oil bath reaches the middle of the lowest ball. SKF's formula is evaluated for
:math:`\\mu_{bl}` = 0.12, :math:`\\mu_{EHL}` = 0.05 and the same oil.

The first table lists torques in N mm: the value from statics, then the value from SKF's formula.
Rolling includes hysteresis; sliding is the sum of slip and spin. SKF's torque includes the friction
at the cage without stating it separately (GC, page 88), so the sum includes the losses of the cage.
A contribution is printed in bold if it differs from SKF's value by a factor of more than 1.5 and
SKF's value is above 10 % of SKF's total torque.
"""

ASSUMED = """What SKF's formula assumes
--------------------------

The first two of these assumptions follow from the constants of the formula
(``tests/python/test_makers.py``).

*No clearance.* In deep groove bearings, a thrust :math:`F_a` counts as a radial load of
:math:`1.7\\,F_a/\\sin\\alpha_F`. If contacts resist rolling in proportion to :math:`Q^{0.54}`,
the power of the load in the formula, this factor is 1.700 for a bearing without clearance, in which
a radial load is carried by half of the balls, and 1.99 for a load parameter of 0.4. The contact
angle :math:`\\alpha_F` = 24.6° :math:`(F_a/C_0)^{0.24}` is that of bearings without clearance if
their groove radii add up to 1.046 ball diameters: from 0.02 to 0.4 :math:`C_0`, the five deep
groove bearings of series 62 and 63 agree within 3 % and the 6010 within 4 %. With a clearance of
13 µm, the angle of a 6208 under 0.02 :math:`C_0` is 12.2° instead of 9.5°.

*Thrust from outside.* In angular contact bearings, a radial load induces a thrust, and the formula
requires the thrust without this part (GC, page 91). A radial load alone stands for a bearing in
which half of the balls are loaded; at a contact angle of 40°, this requires a thrust of 1.02 times
the radial load, and SKF states a factor of 1 (GC, page 417). The formula then agrees within 15 %
with sums of :math:`Q^{0.54}` and :math:`Q^{4/3}` over the balls for any combined load. With the
whole thrust, it would be up to 1.8 times as high as these sums.

*Centrifugal forces.* The formula for deep groove bearings has none. The formula for angular contact
bearings adds a radial load, which is 2460 N for a 7208B at 10,000 rpm, although the centrifugal
forces of its 13 balls add up to 569 N. At 10,000 rpm, rolling is therefore 1.21 to 1.53 times SKF's
value in deep groove bearings and 0.61 to 0.71 times in angular contact bearings. Without
centrifugal forces on both sides, it is 1.03 to 1.11 and 0.88 to 0.92 times SKF's value.

*Minimum load.* A 7208B at 10,000 rpm requires a thrust of 0.92 kN (GC, page 414). According to
statics, its balls skid below about 0.98 kN (:doc:`tribology`).

Remaining differences
---------------------
"""

WHY = """*Rolling.* SKF's rolling torque grows with the load to the power 0.54. The hydrodynamic
resistance of a contact grows with the power 0.41 between 200 N and 1 kN (6208, 3000 rpm, 20 mPa s),
and hysteresis with the power 4/3. Apart from the points at 10,000 rpm, rolling is 0.72 to 1.02
times SKF's value.

*Sliding in deep groove bearings.* If the balls spin at one raceway, Coulomb friction resists a
thrust with the torque :math:`\\tfrac38\\mu a\\bar EF_a`, since the spins at both raceways differ by
:math:`\\omega\\sin\\alpha` and the load on each ball is :math:`F_a/(Z\\sin\\alpha)`. SKF's sliding
torque is 1.08 to 1.09 times this value for the two angular contact bearings under 0.1 and 0.3
:math:`C_0`, but 1.7 to 2.1 times for the deep groove bearings under 0.1 :math:`C_0`. That of
statics, which also includes differential slip, is 0.91 to 1.01 and 1.2 to 1.6 times this value. The
closed-form laws of statics are within 4 % of the sums over slices (``--spin-law slices``). Sliding
grows with the width of the contacts and thus depends on the conformities, which no catalogue
states. Under radial loads, for which it grows with the square of the width, it is 0.62 to 0.84
times SKF's value at 250 and 3000 rpm.

*Other formulas.* At the 18 points with a radial load alone, Palmgren's torque is 0.55 to 2.39 times
SKF's, with a spread of ×/÷ 1.60.

*Rings that tilt.* Under a combined load, a ring that is free to tilt makes the balls of a 7205B and
a 7208B run 1.4 to 2.1 mm ahead of and behind one another in pockets with a play of 0.2 and 0.3 mm
(:doc:`cage`). The cage restrains them, and the torque is 5.3 to 7.3 times SKF's. A 7208B under 0.05
and 0.1 :math:`C_0` then has a torque of 596 N mm in statics, 423 N mm of it at the cage, and of 608
N mm in a run (381 N mm).
"""

OTHERS = """Other assumptions
-----------------

With conformities of 0.51 and 0.52, the balls of the 7208B skid at 10,000 rpm. The
last two rows show the effect of constants and laws that :doc:`tribology` mentions but whose sources
were not available to us: the loss factor that corresponds to Houpert's formula if the shape of the
contact ellipse is disregarded, and the asperity law of Olver and Spikes.
"""

REFERENCE_SPEED = """Reference speed
---------------

The table compares the heat generated in statics without drag and cage (catalogue's reference speed,
0.05 :math:`C_0`, vg32 at 12 mm²/s, the middle of the normal clearance) with the cooling power
according to ISO 15312 at 50 K. The standard requires normal clearance (GC, page 108).
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


def page(found, others, heats):
    lines = []
    for name, (radial, axial, rpm, viscosity), own, skf in found:
        wrong = off(own, skf)
        cells = [f"{own[one]:.3g} / {skf[one]:.3g}" for one in SHARES]
        cells = [f"**{cell}**" if one in wrong else cell for one, cell in zip(SHARES, cells)]
        totals = total(own), total(skf)
        lines.append(
            [name, f"{radial:g}, {axial:g}", f"{rpm:g}, {viscosity:g}", *cells, f"{own[CAGE]:.3g}",
             "{:.3g} / {:.3g}".format(*totals), f"{totals[0] / totals[1]:.2f}"]
        )  # fmt: skip
    header = ("bearing", "radial, axial load over :math:`C_0`", "rpm, mPa s", *SHARES, CAGE, "sum",
              "ratio")  # fmt: skip
    heat_lines = [
        [name, f"{rpm:g}", f"{own:.1f}", f"{carried:.1f}", f"{own / carried:.2f}"]
        for name, (rpm, own, carried) in heats.items()
    ]
    text = "\n".join(
        [HEAD, summary(found), "", *csv_table(header, lines), ASSUMED, WHY, OTHERS,
         *csv_table(("what differs", "points", "geometric mean", "spread", "lowest", "highest",
                     "with a bold contribution"), [others_line(*one) for one in others.items()]),
         REFERENCE_SPEED,
         *csv_table(("bearing", "rpm", "own W", "ISO 15312 W", "ratio"), heat_lines)]
    )  # fmt: skip
    return f"{wrapped(text.rstrip())}\n"


def total(torques):
    return sum(torques.values())


def numbers(found):
    """Return (geometric mean, spread, least, most) of the ratios between our sums and SKF's sums,
    and the number of points with a share that is too far off."""
    ratio = np.array([total(own) / total(skf) for _, _, own, skf in found])
    log = np.log(ratio)
    wrong = sum(bool(off(own, skf)) for _, _, own, skf in found)
    return np.exp(log.mean()), np.exp(log.std(ddof=1)), ratio.min(), ratio.max(), wrong


def others_line(what, found):
    mean, spread, *ends, wrong = numbers(found)
    return [what, len(found), f"{mean:.3f}", f"×/÷ {spread:.3f}",
            *(f"{one:.2f}" for one in ends), wrong]  # fmt: skip


def summary(found):
    mean, spread, least, most, wrong = numbers(found)
    return (
        f"Ratio of the {len(found)} sums: geometric mean {mean:.3f}, spread ×/÷ {spread:.3f}, from"
        f" {least:.2f} to {most:.2f}. {wrong} points have a contribution in bold."
    )


def with_hysteresis(loss):
    """Return `rows` with another hysteresis loss factor."""
    own = contact_friction.surfaces
    changed = patch.object(
        contact_friction, "surfaces", lambda *args: replace(own(*args), loss=loss)
    )
    with changed:
        return rows()


def with_olver_spikes():
    """Return `rows` with the law of Olver and Spikes for the load on asperities."""
    with patch.object(asperity, "clarke", lambda ratio: 1 / (1 + np.asarray(ratio)) ** 2):
        return rows()


def variants():
    """Return {what differs: `rows`} for other assumptions."""
    return {
        "the grooves of the data files": rows(lambda name: None),
        **{
            "conformities {:g} and {:g} in all bearings".format(*one): rows(
                lambda name, own=one: own
            )
            for one in CONFORMITIES
        },
        "the inner ring is free to tilt": rows(held=None),
        "no centrifugal forces in statics": rows(density=WEIGHTLESS),
        "no centrifugal forces in statics and SKF's formula": weightless(),
        "a hysteresis loss factor of 0.039": with_hysteresis(0.039),
        "the asperity law of Olver and Spikes": with_olver_spikes(),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--no-page", action="store_true", help="print only")
    given = parser.parse_args()
    found, heats = rows(), {name: reference(name) for name in REFERENCE}
    for name, (radial, axial, rpm, viscosity), own, skf in found:
        cells = "  ".join(f"{own[one]:8.2f} {skf[one]:8.2f}" for one in SHARES)
        ratio = total(own) / total(skf)
        print(f"{name:6} {radial:5g} {axial:5g} {rpm:6g} {viscosity:4g}  {cells} {own[CAGE]:7.2f}"
              f"  {ratio:5.2f}", *off(own, skf))  # fmt: skip
    for name, (rpm, own, carried) in heats.items():
        print(f"{name:6} {rpm:6g} rpm {own:7.2f} W of {carried:7.2f} W {own / carried:.2f}")
    print(summary(found))
    others = variants()
    for what, points in others.items():
        print(*others_line(what, points))
    if not given.no_page:
        PAGE.write_text(page(found, others, heats))


if __name__ == "__main__":
    main()
