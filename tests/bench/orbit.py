# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the results and the number of force evaluations of runs with `settle orbit` to those of
runs after long settling, and write build/bench/orbit.rst. The runs are those of the main deck and
of a shaft on two equal bearings, of which the first is evaluated.

    .venv/bin/python tests/bench/orbit.py [SCENE ...]

The results with `settle orbit` are means over one ball pass of the orbit. They are compared with
means over a turn of the cage of a run that has settled for 30 ball passes, or for as many as its
scene requires to become steady. In one turn, each ball passes every position, so uneven spacings of
the balls average out. The evaluations for settling and one measured ball pass are compared with
those of a run that settles for 30 ball passes and of a run that settles until it is steady, each
with one measured ball pass. The number of evaluations does not depend on the load of the machine.
"""

import tempfile
from pathlib import Path
from typing import NamedTuple

from deck_runs import MAIN, cost, run_deck
from machine import csv_table, publish, words_asked
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables

SHAFT = "tests/scenarios/in.shaft_orbit"
SETTLED = 30  # ball passes
TIGHT = {"clearance": "-20e-6"}
THRUST = {"bearing": "7205B", "load": "1e-3"}


class Scene(NamedTuple):
    """Variables of the deck, the number of ball passes after which a conventional run is steady,
    and the deck."""

    words: dict
    steady: int = SETTLED
    deck: str = MAIN


ORBITS = {
    "preload, 2 kN, 1500 rpm": Scene({**TIGHT, "load": 2000, "rpm": 1500}),
    "no clearance, 5 kN, 477.5 rpm": Scene({"load": 5000, "rpm": 477.5}, 100),
    "preload, 2 kN, 1500 rpm, no cage": Scene({**TIGHT, "load": 2000, "rpm": 1500, "cage": "no"}),
    "preload, 1 kN, 200 rpm": Scene({**TIGHT, "load": 1000, "rpm": 200}),
    "preload, 3 kN, 9549 rpm": Scene({**TIGHT, "load": 3000, "rpm": 9549}),
    "preload of 40 um, 5 kN, 477.5 rpm": Scene({"clearance": "-40e-6", "load": 5000, "rpm": 477.5}),
    "7205B, thrust 300 N, 8000 rpm": Scene({**THRUST, "axial": 300, "rpm": 8000}, 400),
    "7205B, thrust 1 kN, 3000 rpm": Scene({**THRUST, "axial": 1000, "rpm": 3000}, 400),
    "7208, 2 kN and thrust 3 kN, 3000 rpm": Scene(
        {"bearing": 7208, "load": 2000, "axial": 3000, "rpm": 3000}
    ),
    "7208, thrust 500 N, 6000 rpm": Scene(
        {"bearing": 7208, "load": "1e-3", "axial": 500, "rpm": 6000}, 400
    ),
    "shaft on two 6208s, preload, 4 kN, 1500 rpm": Scene({}, deck=SHAFT),
    "the same, load off the middle": Scene({"place": 0.15}, deck=SHAFT),
    "shaft on two 7208s, thrust 1 kN, 6000 rpm": Scene(
        {
            **{"bearing": 7208, "clearance": 0, "load": "1e-3", "axial": 1000, "rpm": 6000},
            "freedoms": "x free y free z free rx free ry free",
        },
        400,
        SHAFT,
    ),
}
WITHOUT = {
    "light load, 6000 rpm": {"load": 300, "rpm": 6000},
    "no cage, 1 kN, 1500 rpm": {"load": 1000, "rpm": 1500, "cage": "no"},
    "cage chain, 5 kN, 477.5 rpm": {"load": 5000, "rpm": 477.5, "cage": "chain"},
    "unbalance": {**TIGHT, "load": 2000, "rpm": 1500, "unbalance": "1e-4"},
}
HEADS = (
    *("scene", "ball passes", "evaluations", "ratio to 30 ball passes", "ratio to steady"),
    *("torque", "largest load", "smallest film", "cage speed", "largest multiplier"),
)
PAGE = """\
Runs with ``settle orbit`` are compared with runs that
settle for 30 ball passes and until they are steady. Errors are relative to one turn of the cage in
a steady run.

{table}

Scenes without an orbit
-----------------------

{without}
"""


def figures(folder):
    """Return the mean values of friction torque (N m), largest contact load at an instant (N),
    minimum film thickness at the largest inner load (m), and cage speed (rad/s)."""
    tables = RunTables(folder, bearing=1)
    found = summary(tables)
    largest = tables.contacts.groupby("sample")["load"].max().mean()
    return (
        *(found["friction_torque_N_m"], largest),
        *(found["h_min_m"], found["cage_speed_rad_s"]),
    )


def settled(folder, settle, words, passes=1, deck=MAIN):
    """Return (output of the host, cost of the run, evaluations up to the end of one measured ball
    pass)."""
    given = {"models": "full", **words, "settle": settle, "passes": passes}
    said = run_deck(deck, **given, out=folder, overwrite="yes")
    noted = cost(folder)
    return said, noted, noted["settling_evaluations"] + noted["evaluations"] / passes


def row(name, scene, place):
    words, deck = scene.words, scene.deck
    said, noted, evaluations = settled(place / "orbit", "orbit", words, deck=deck)
    _, _, marched = settled(place / "marched", SETTLED, words, deck=deck)
    turn = int(RunTables(place / "orbit", bearing=1).settings["balls"])
    _, _, longest = settled(place / "steady", scene.steady, words, turn, deck)
    off = [
        own / steady - 1
        for own, steady in zip(figures(place / "orbit"), figures(place / "steady"), strict=True)
    ]
    passes = f"{noted['orbit_passes']:.0f}" if "Orbit after" in said else "none"
    numbers = (f"{evaluations:.0f}", f"{evaluations / marched:.2f}", f"{evaluations / longest:.2f}")
    return (name, passes, *numbers, *(f"{one:.1e}" for one in off), multiplier(noted))


def multiplier(noted):
    if "orbit_multiplier" in noted:
        return f"{noted['orbit_multiplier']:.4f}"
    limit = noted.get("orbit_multiplier_limit")
    return "" if limit is None else f"at most {limit:.2g}"


def without(name, words, place):
    said, _, evaluations = settled(place, "orbit", words)
    why = next((line for line in said.splitlines() if line.startswith("No orbit")), "an orbit")
    return f"* {name} ({evaluations:.0f} evaluations): {why}"


def main():
    chosen = words_asked()
    rows, marched = [], []
    with tempfile.TemporaryDirectory() as work:
        for name, scene in ORBITS.items():
            if not chosen or name in chosen:
                rows.append(row(name, scene, Path(work)))
                print(*rows[-1], sep="  ", flush=True)
        for name, words in WITHOUT.items():
            if not chosen or name in chosen:
                marched.append(without(name, words, Path(work) / "without"))
                print(marched[-1], flush=True)
    title = "Periodic orbit over one ball pass"
    publish(title, PAGE, table=csv_table(HEADS, rows), without=marched)


if __name__ == "__main__":
    main()
