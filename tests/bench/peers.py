# SPDX-License-Identifier: GPL-2.0-or-later
"""What others make of a 6208 under 5 kN: python tests/bench/peers.py [rounds]. Writes
docs/performance/peers.rst.

Stock LIGGGHTS with smooth cylinders and with triangle meshes (decks in tests/bench/peers), Exudyn's
ball bearing, and Raceway for comparison. All take turns in every round, so that a drift of the
machine hits them alike.
"""

import statistics
import sys
from datetime import date
from importlib.metadata import PackageNotFoundError, version

import numpy as np
import torus_stl
from machine import machine
from peer_runs import (
    BEARING,
    BOTH_ALIKE,
    DECKS,
    LOAD,
    OUT,
    ROOT,
    SPEED,
    SPHERE_ON_PLANE,
    STIFFNESS,
    Failure,
    Outcome,
    cylinders,
    exact_shift,
    exudyn,
    host,
    raceway,
    tori,
)
from raceway.theory.bearing import INNER, OUTER

ROUNDS = 3
MESHES = {"180x8": (180, 8), "360x16": (360, 16), "720x32": (720, 32)}
# of the meshed groove to either side; the contact reaches 18 degrees at 5 kN
REACH = np.radians(40)
SECANT = BOTH_ALIKE * (exact_shift() / 2) ** 0.5  # N/m, of two like linear contacts
FITTED = BEARING.young * BOTH_ALIKE / SPHERE_ON_PLANE
SHARP, SMOOTH = "curvature 0.25", "curvature 20 curvature_tolerant yes"
# On the tori a ball passes two to four facets, whatever their size; with longer steps balls fly off
# in that time.
SCENES = [  # name, call
    ("stock LIGGGHTS, smooth cylinders", lambda: cylinders(BEARING.young)),
    (
        f"the same, modulus raised to {FITTED / 1e9:.0f} GPa to fit the exact stiffness",
        lambda: cylinders(FITTED),
    ),
    ("stock LIGGGHTS, STL tori, 180 by 8 facets a ring", lambda: tori("180x8", 16000, SHARP)),
    ("STL tori, 360 by 16 facets", lambda: tori("360x16", 8000, SHARP)),
    ("STL tori, 720 by 32 facets", lambda: tori("720x32", 4000, SHARP, step=2e-7)),
    ("STL tori, 360 by 16 facets, edges switched off", lambda: tori("360x16", 8000, SMOOTH)),
    (
        "Exudyn, linear contact of its own bearing test (5e6 N/m)",
        lambda: exudyn(5e6, 1.0, 0.2, 1e-4),
    ),
    (
        f"Exudyn, linear contact of {SECANT:.3g} N/m, exact at the largest load",
        lambda: exudyn(SECANT, 1.0, 0.1, 1e-5),
    ),
    (
        "Exudyn, exponent 1.5, exact stiffness given, no friction",
        lambda: exudyn(BOTH_ALIKE, 1.5, 0.0, 1e-5),
    ),
    ("Raceway, dry, with cage", lambda: raceway("dry", lubricant="dry")),
    ("Raceway, film, cage, capacitance", lambda: raceway("film")),
]
ATTEMPTS = [  # what was tried, call; run once
    (
        "stock LIGGGHTS, a servo that holds 5 kN on a mesh whose surface turns",
        lambda: host("liggghts", DECKS / "in.servo", folder=OUT),
    ),
    (
        "stock LIGGGHTS, STL tori, 360 by 16 facets with a step of 1e-6 s",
        lambda: tori("360x16", 2000, SHARP, step=1e-6),
    ),
    (
        "Exudyn, exponent 1.5, exact stiffness given, and friction 0.1",
        lambda: exudyn(BOTH_ALIKE, 1.5, 0.1, 1e-5),
    ),
]


def attempt(call):
    """One sentence on how the call ended."""
    try:
        found = call()
    except Failure as failure:
        return f"stopped: ``{failure}``"
    if isinstance(found, Outcome):
        return (
            f"ran; {found.left} of {BEARING.balls} balls left, load error at the same displacement "
            f"{percent(found.same_shift)} ({percent(found.low)} to {percent(found.high)})"
        )
    return "ran"


def percent(part):
    """A part of one in per cent, two digits after the point where small."""
    return f"{100 * part:+.{2 if abs(part) < 0.1 else 1 if abs(part) < 1 else 0}f} %".replace(
        "-0.00", "+0.00"
    )


def number(value):
    """Two digits, or all before the point."""
    return f"{value:.0f}" if value >= 100 else f"{value:.2g}"


def row(name, outcomes):
    """Lines of one row of the table."""
    if any(isinstance(o, Failure) for o in outcomes):
        why = next(o for o in outcomes if isinstance(o, Failure))
        return [f"   * - {name}", "     -", "     -", f"     - failed: {why}", "     -", "     -"]
    costs, o = [each.cost for each in outcomes], outcomes[-1]
    lost = f"; {o.left} balls left" if o.left < BEARING.balls else ""
    return [
        f"   * - {name}",
        f"     - {number(o.step * 1e6)}",
        f"     - {number(o.simulated * 1e3)}",
        f"     - {number(statistics.median(costs))} ({number(min(costs))} to {number(max(costs))})",
        f"     - {percent(o.same_shift)} ({percent(o.low)} to {percent(o.high)}){lost}",
        f"     - {percent(o.same_load)}",
    ]


def exudyn_version():
    try:
        return version("exudyn")
    except PackageNotFoundError:
        return "not installed"


def page(rounds, attempts):
    """The page's text: peers/page.txt with what was measured."""
    facts = [*machine(), f"Exudyn {exudyn_version()} from PyPI, one thread"]
    table = [
        line
        for k, (name, _) in enumerate(SCENES)
        for line in row(name, [each[k] for each in rounds])
    ]
    tried = [f"- {name}: {end}" for (name, _), end in zip(ATTEMPTS, attempts)]
    return (
        (ROOT / DECKS / "page.txt")
        .read_text()
        .format(
            date=date.today(),
            rounds=len(rounds),
            facts="\n".join(f"- {fact}" for fact in facts),
            load=LOAD,
            speed=SPEED,
            table="\n".join(table),
            tried="\n".join(tried),
            shift=exact_shift() * 1e6,
            sphere=SPHERE_ON_PLANE / 1e10,
            inner=STIFFNESS[INNER] / 1e10,
            outer=STIFFNESS[OUTER] / 1e10,
            both=BOTH_ALIKE / 1e10,
        )
    )


def measured(call):
    try:
        return call()
    except Failure as failure:
        return failure


def main():
    """Measure, print, write."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else ROUNDS
    (ROOT / OUT).mkdir(parents=True, exist_ok=True)
    for name, (around, across) in MESHES.items():
        for side, ring in ((INNER, "inner"), (OUTER, "outer")):
            torus_stl.write(
                ROOT / OUT / f"{ring}-{name}.stl",
                torus_stl.triangles(BEARING, side, around, across, REACH),
            )
    rounds = []
    for number in range(count):
        rounds.append([])
        for name, call in SCENES:
            rounds[-1].append(measured(call))
            print(f"round {number + 1} of {count}: {name}: {rounds[-1][-1]}", flush=True)
    attempts = []
    for name, call in ATTEMPTS:
        attempts.append(attempt(call))
        print(f"{name}: {attempts[-1]}", flush=True)
    text = page(rounds, attempts)
    (ROOT / "docs" / "performance" / "peers.rst").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
