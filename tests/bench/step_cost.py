# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the cost of one step for each feature, and of a step in a comparable scene in stock
LIGGGHTS, and write build/bench/step_cost.rst.

Every round runs all scenes, so that a drift in the speed of the machine affects all of them. The
ratio to the empty step is formed within each round. The page lists medians and ranges.
"""

from deck_runs import nanoseconds, run_deck
from machine import csv_table, publish, spread

ROUNDS = 7
STEPS = 200_000
PAGE = """\
Each of {rounds} rounds runs all scenes, with {steps} steps each. The bearing is a loaded 6208 (5
kN, 477.5 rpm, mineral oil) with velocity Verlet. The ratio is relative to the empty step in the
same round. The values are medians, with the range over the rounds in brackets.

{table}

The stock scene has no groove, no contact ellipse, no free ring and no film. It is the most similar
scene that an unmodified host can run.

{machine}
"""
SCENES = [  # name, deck, variables, target for the ratio to the empty step
    ("empty LIGGGHTS step, 20 free particles", "in.empty", {}, None),
    (
        "dry: 9 balls, two raceways, friction, free ring",
        "in.cost",
        {"lubricant": "dry", "cage": "no"},
        5,
    ),
    ("+ film, film damping, Stribeck friction", "in.cost", {"cage": "no"}, None),
    ("+ cage: 9 cage balls on two rails", "in.cost", {}, None),
    ("+ capacitance every 100 steps (everything)", "in.cost", {"sample": 100}, 7),
    ("stock: 9 balls between two smooth cylinders", "in.cylinder", {}, None),
]


def main():
    """Measure, print the results and write the page."""
    rounds = []
    for number in range(ROUNDS):
        print(f"round {number + 1} of {ROUNDS}", flush=True)
        texts = [
            run_deck(f"tests/bench/{deck}", steps=STEPS, **variables)
            for _, deck, variables, _ in SCENES
        ]
        rounds.append([nanoseconds(text, STEPS) for text in texts])
    rows = []
    for k, (name, _, _, target) in enumerate(SCENES):
        times, ratios = [row[k] for row in rounds], [row[k] / row[0] for row in rounds]
        limit = f"≤ {target}" if target else ""
        rows.append((name, spread(times, ".0f"), spread(ratios, ".2f"), limit))
    table = csv_table(("scene", "ns per step", "ratio to empty step", "target"), rows)
    publish("Cost of a step", PAGE, rounds=ROUNDS, steps=STEPS, table=table)


if __name__ == "__main__":
    main()
