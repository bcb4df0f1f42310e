# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare four methods of estimating the length of a spall from the time between entry and impact
in the signal of a sensor on the housing, and write build/bench/spall_length.rst.

    .venv/bin/python tests/bench/spall_length.py [--print]     --print: do not write the page

The exit code is 1 if the result of raceway.spall deviates by more than 5 %.
"""

import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from deck_runs import MAIN, succeed
from machine import csv_table, publish
from raceway import hertz, kinematics, passages, spall, static
from raceway.runs.run import Run
from raceway.theory.bearing import INNER, OUTER

MODE = dict(lubricant="vg46", integrator="vibration", housing="springs")
SCENES = (  # bearing, load (N), rpm, mass of the inner ring (kg; inputs/bearings)
    ("6205", 500, 1797, 0.055),
    ("6205", 1000, 3000, 0.055),
    ("6208", 2000, 1500, 0.2),
)
LENGTHS = (1e-3, 2e-3)  # m
SIDES = {"outer": (OUTER, 8), "inner": (INNER, 16)}  # {name: (raceway, ball passes)}
EDGE = 5e-5  # m
ALLOWED = 0.05
WAYS = ("half-way", "static rate", "two masses", "the ball's own fall")
PAGE = """\
The first column is the true length of the spall. The other lengths are determined from the time
between entry and impact in the acceleration of the housing, at 192 kHz and without noise
(``raceway.passages``). They are medians over the balls that pass through the load zone, in mm:

{table}

* *half-way*: the ball keeps its load and strikes half-way along the spall, as assumed in
  ``raceway.kinematics.spall_length``.
* *static rate*: the ball leaves the raceway at the rate of the static drop, and the ring does not
  move.
* *two masses*: both ball and ring move, as in ``raceway.spall.length``.
* *the ball's own fall*: the length follows from the distance that the ball has fallen when it
  strikes, which is read from the record. No sensor measures this distance.

All methods except the first account for the edge radius of 0.05 mm: the signal of a ball that keeps
its load appears 0.05 mm before the middle. The largest error of *two masses* is {error:.1f} %.
"""


def at_static_rate(bearing, raceway, seconds, spin, load):
    """Return the lengths (m) as if the balls left the raceway at the rate of the static drop."""
    orbit = spin * kinematics.frequencies(bearing).cage
    speed = kinematics.entrainment(bearing, spin)
    full = static.equilibrium(bearing, load, orbital_speed=orbit)
    less = replace(bearing, balls=int(bearing.balls) - 1)
    without = static.equilibrium(less, load, orbital_speed=orbit, phase=full.azimuth[1:])
    radii = [bearing.effective_radii(side) for side in (INNER, OUTER)]
    soft = [
        hertz.stiffness(hertz.exact(*one), bearing.effective_modulus) ** (-2 / 3) for one in radii
    ]
    rolling, share = radii[raceway][0], soft[1 - raceway] / sum(soft)
    lost = np.sqrt(2 * rolling * without.shift[0])
    on = speed * seconds
    curve = (1 if raceway == OUTER else -1) * bearing.pitch_radius * (orbit / speed) ** 2
    away = np.maximum(on - lost, 0.0)
    drop = without.shift[0] + share * lost / rolling * away + 0.5 * curve * away**2
    flown = on + np.sqrt(2 * rolling * np.maximum(drop, 0.0))
    return np.where(on > lost, flown, 2 * (on + EDGE))


def by_own_fall(run, side, raceway, found, spin):
    """Return the lengths (m) that follow from how far the balls have fallen in the `Passages`
    `found`."""
    bearing = run.tables.geometry
    speed, rolling = kinematics.entrainment(bearing, spin), bearing.effective_radii(raceway)[0]
    load, overlap = (
        run.contacts[name].sel(raceway=side).transpose("time", "ball").to_numpy()
        for name in ("load", "overlap")
    )
    x, y = (run.balls[name].transpose("time", "ball").to_numpy() for name in "xy")
    turned = 0.0
    if side == "inner":  # the fall is relative to the ring with the spall
        x, y = (one - run.rings[k].to_numpy()[:, None] for one, k in ((x, "x"), (y, "y")))
        turned = run.rings["angle"].to_numpy()[:, None]
    radius, way = np.hypot(x, y), np.arctan2(y, x) - turned + np.pi / 2
    sample_s, lengths = run.settings["sample_s"], []
    for entry, blow in zip(found.entry, found.blow):
        start, stop = int(entry / sample_s), int(np.ceil(blow / sample_s))
        ball = np.argmin(np.abs(np.angle(np.exp(1j * way[start]))))
        gone = np.flatnonzero(load[start:stop, ball] == 0)
        if not len(gone):  # the ball kept its load
            lengths.append(2 * (speed * (blow - entry) + EDGE))
            continue
        back = start + gone[0] + np.argmax(load[start + gone[0] :, ball] > 0)
        fall = abs(radius[back, ball] - radius[start, ball]) + overlap[start, ball]
        lengths.append(speed * (back * sample_s - entry) + np.sqrt(2 * rolling * fall))
    return np.array(lengths)


def main() -> int:
    """Compute the results and write the page."""
    rows, worst = [], 0.0
    with tempfile.TemporaryDirectory() as place:
        for name, load, rpm, mass in SCENES:
            for side, (raceway, passes) in SIDES.items():
                for length in LENGTHS:
                    folder = Path(place) / f"{name}_{load}_{side}_{length}"
                    flaw = {f"flaw_{side}": f"notch {-np.pi / 2} {length} full 1e-3 {EDGE}"}
                    words = dict(bearing=name, load=load, rpm=rpm, passes=passes, **MODE, **flaw)
                    succeed(MAIN, out=folder, timeout=1200, **words)
                    run, spin = Run(folder), rpm * np.pi / 30
                    bearing, found = run.tables.geometry, passages.of_run(run, side).strong
                    given = (bearing, raceway, found.seconds, spin, load)
                    read = (
                        kinematics.spall_length(bearing, spin, found.seconds),
                        at_static_rate(*given),
                        spall.length(*given, mass, heard=OUTER, edge=EDGE),
                        by_own_fall(run, side, raceway, found, spin),
                    )
                    medians = [float(np.median(one)) for one in read]
                    worst = max(worst, abs(medians[2] / length - 1))
                    where = f"{name}, {load} N, {rpm} rpm"
                    rows.append(
                        [where, side, f"{1e3 * length:g}", *(f"{1e3 * one:.2f}" for one in medians)]
                    )
                    print(rows[-1], len(found.entry), flush=True)
    table = csv_table(["run", "raceway", "length", *WAYS], rows)
    publish("Length of a spall", PAGE, table=table, error=100 * worst)
    return worst > ALLOWED


if __name__ == "__main__":
    sys.exit(main())
