# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the cost of a step of fix bearing/implicit as a function of the features used and the
number of balls. Write build/bench/implicit_cost.rst.

Every round runs all scenes; ratios and differences are formed within each round. The page lists
their medians and ranges.
"""

import re
from math import log, pi, sin

from deck_runs import nanoseconds, run_deck
from machine import csv_table, publish, spread

ROUNDS = 5
BALLS = 9
STEPS = 20_000
PLAIN = "tolerance 1e-7 order"
SCENES = [  # name, variables of in.implicit_cost, index of the scene to compare with (or None)
    (
        "dry: 9 balls, two raceways, friction, free ring; order 1",
        dict(lubricant="dry", cage="no", control=f"{PLAIN} 1"),
        None,
    ),
    ("+ film, film damping, Stribeck friction", dict(cage="no", control=f"{PLAIN} 1"), 0),
    ("+ cage: 9 cage balls on two rails", dict(control=f"{PLAIN} 1"), 1),
    ("+ capacitance every step", dict(control=f"{PLAIN} 1", sample=1), 2),
    (
        "+ capacitance at 10 instants of every step",
        dict(control=f"{PLAIN} 1", sample=1, within=10),
        3,
    ),
    (
        "+ surroundings of all balls, every step",
        dict(control=f"{PLAIN} 1", sample=1, around="flooded"),
        3,
    ),
    (
        "+ surroundings of all balls at 10 instants of every step",
        dict(control=f"{PLAIN} 1", sample=1, within=10, around="flooded"),
        4,
    ),
    ("order 2 instead of 1 (film, cage)", dict(control=f"{PLAIN} 2"), 2),
    ("five free degrees of freedom instead of two", dict(control=f"{PLAIN} 1", tilts=1), 2),
    ("energy account", dict(control=f"{PLAIN} 1 energy yes"), 2),
]
AROUND = [(3, 5, 1), (4, 6, 10)]  # scenes without and with surroundings, samples per step
FEATURES = (
    *("scene", "ns per host step", "adds (ns)", "internal steps per host step"),
    "corrections per internal step",
)
SIZES = (
    *("balls", "ns per correction", "ns per correction and ball"),
    "corrections per internal step",
)
PAGE = """\
The bearing is a 6208 (5 kN, 477.5 rpm, mineral oil). Each of {rounds} rounds runs all scenes, with
{steps} host steps of 0.1 ms; the tolerance is 0.1 µm. *Adds* is the difference from the scene on
which a row builds, measured in the same round. The values are medians, with the range over the
rounds in brackets.

Feature by feature
------------------

{features}

The surroundings of a ball cost {end} ns per sample at the end of a step, with or without contact.
At ten instants within the step they cost {instants} ns.

Cost against number of balls
----------------------------

Pitch circle, load and number of balls of these bearings are scaled up by the same factor. The scene
includes film, cage and a free ring; the order is 1.

{sizes}

With one correction, the time per host step scales as the number of balls to the power {order}. The
time for the blocks of four balls, for the chain of cage contacts and for the coupling to the rings
is proportional to the number of balls. Part of the host's step does not depend on this number.

{machine}
"""
HOST = ("the host's own step, 20 free particles", dict())
ROWS = (9, 18, 36)


def measure(name, variables):
    """Return (ns per host step, internal steps per host step, corrections per internal step)."""
    text = run_deck(f"tests/bench/{name}", **{"steps": STEPS, **variables})
    control = re.search(r"substeps (\S+) corrections (\S+)", text)
    inside = (float(control.group(1)) / STEPS, float(control.group(2))) if control else (0, 0)
    return nanoseconds(text, STEPS), *inside


def wide(balls):
    """Return the variables for a bearing with 9 k balls on a pitch circle k times as large as that
    of a 6208, with the same contact loads."""
    k = balls / 9
    pitch = 30.3e-3 * k
    cage = 2 * (2 * pitch * sin(pi / (2 * balls)) - 6.3e-3) - 33e-6
    return dict(
        balls=balls,
        inner_radius=pitch - 6.3e-3,
        outer_radius=pitch + 6.3e-3,
        cage_ball_diameter=cage,
        load=5000 * k,
        rpm=477.5,
        control=f"{PLAIN} 1",
    )


def main():
    rounds = []
    for number in range(ROUNDS):
        print(f"round {number + 1} of {ROUNDS}", flush=True)
        rounds.append(
            [measure("in.empty", HOST[1])]
            + [measure("in.implicit_cost", dict(v)) for _, v, _ in SCENES]
            + [measure("in.implicit_cost", wide(balls)) for balls in ROWS]
        )
    empty, scenes, rows = (
        [r[0] for r in rounds],
        [r[1 : 1 + len(SCENES)] for r in rounds],
        [r[1 + len(SCENES) :] for r in rounds],
    )
    body = [(HOST[0], spread([m[0] for m in empty], ".0f"), "", "", "")]
    for k, (name, _, base) in enumerate(SCENES):
        times = [r[k][0] for r in scenes]
        added = spread([r[k][0] - r[base][0] for r in scenes], ".0f") if base is not None else ""
        inside = (f"{value:.2f}" for value in scenes[0][k][1:])
        body.append((name, spread(times, ".0f"), added, *inside))
    around = [[(r[w][0] - r[p][0]) / (BALLS * n) for r in scenes] for p, w, n in AROUND]
    ns = {balls: [r[k][0] / r[k][1] / r[k][2] for r in rows] for k, balls in enumerate(ROWS)}
    sizes = [
        (
            balls,
            spread(ns[balls], ".0f"),
            spread([t / balls for t in ns[balls]], ".1f"),
            f"{rows[0][k][2]:.2f}",
        )
        for k, balls in enumerate(ROWS)
    ]
    orders = [
        log(ns[ROWS[-1]][k] / ns[ROWS[0]][k]) / log(ROWS[-1] / ROWS[0]) for k in range(ROUNDS)
    ]
    publish(
        "Cost of an implicit step",
        PAGE,
        rounds=ROUNDS,
        steps=STEPS,
        features=csv_table(FEATURES, body),
        end=spread(around[0], ".0f"),
        instants=spread(around[1], ".0f"),
        sizes=csv_table(SIZES, sizes),
        order=spread(orders, ".2f"),
    )


if __name__ == "__main__":
    main()
