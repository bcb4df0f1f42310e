# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the friction torque by statics with the models `full` with SKF's formula at 40 points of
eight bearings, and the heat at the reference speed of five; write the tables and the mean ratios
of docs/torque_points.rst.

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


def tables(found, others, heats):
    """Return the rows of the tables of the page, in their order."""
    points = []
    for name, (radial, axial, rpm, viscosity), own, skf in found:
        wrong = off(own, skf)
        cells = [f"{own[one]:.3g} / {skf[one]:.3g}" for one in SHARES]
        cells = [f"**{cell}**" if one in wrong else cell for one, cell in zip(SHARES, cells)]
        totals = total(own), total(skf)
        points.append(
            [name, f"{radial:g}, {axial:g}", f"{rpm:g}, {viscosity:g}", *cells, f"{own[CAGE]:.3g}",
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
        new = page(PAGE.read_text(), summary(found), tables(found, others, heats))
        PAGE.write_text(new)


if __name__ == "__main__":
    main()
