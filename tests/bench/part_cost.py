# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the cost of each part of the contact law on its own (part_cost.cpp) and the cost of
complete runs with the models `paper`, `film` and `full`, and write build/bench/part_cost.rst."""

import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from implicit_cost import measure
from machine import ROOT, csv_table, publish, spread

ROUNDS = 3
MODELS = ("paper", "film", "full")
CONTROL = {"paper": "tolerance 1e-9", "film": "tolerance 1e-9 cage_tolerance 1e-7"}
CONTROL["full"] = CONTROL["film"]
PAGE = """\
The laws are evaluated on their own, for 4096 loaded contacts of a 6208, in {rounds} rounds. *Adds*
is the difference from the law on which a row builds, measured in the same round. *Explicit* is one
evaluation in doubles; *implicit* is an evaluation with derivatives, for four contacts at a time.
*Fraction* is the time of a part for nine contacts (explicit) divided by that of a velocity-Verlet
step with ``full``. The values are medians, with the range over the rounds in brackets.

{parts}

Whole runs
----------

The bearing is a 6208 with a cage, under 5 kN at 477.5 rpm. The implicit step has a tolerance of 1
nm (0.1 µm for cage balls with ``film`` and ``full``) and host steps of 0.1 ms.

{whole}

{machine}
"""
PARTS = (
    *("part", "explicit (ns per contact)", "adds", "implicit (ns per contact)", "adds"),
    "fraction (%)",
)
WHOLE = (
    *("models", "velocity Verlet (ns per step)", "over ``paper``"),
    *("implicit (ns per host step)", "over ``paper``"),
    *("internal steps per host step", "corrections per internal step"),
)


def build(folder):
    program = Path(folder) / "part_cost"
    words = "-std=c++17 -O3 -fno-math-errno -fno-trapping-math -ffp-contract=off -Wno-psabi"
    source = ROOT / "tests/bench/part_cost.cpp"
    built = ROOT / "build/obj"
    units = ("tables", "bodies", "geometry", "numbers", "step")
    core = [*built.glob("core/*/*.o"), *(built / f"units/core_{unit}.o" for unit in units)]
    subprocess.run(["g++", *words.split(), source, *core, "-o", program], check=True)
    return program


def parts(program):
    """Return a list of (name, base, explicit, implicit), where the times are in ns per contact."""
    text = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    rows = [line.split("|") for line in text.splitlines()]
    return [(name, int(base), float(one), float(four)) for name, base, one, four in rows]


def whole():
    """Return a dict that maps each set of models to (ns per step of velocity Verlet, ns per
    simulated ms of the implicit integrator)."""
    found = {}
    for models in MODELS:
        verlet = measure("in.cost", dict(models=models))[0]
        implicit, steps, corrections = measure(
            "in.implicit_cost", dict(models=models, control=CONTROL[models])
        )
        found[models] = verlet, implicit, steps, corrections
    return found


def main():
    with tempfile.TemporaryDirectory() as folder:
        program = build(folder)
        rounds = []
        for number in range(ROUNDS):
            print(f"round {number + 1} of {ROUNDS}", flush=True)
            rounds.append((parts(program), whole()))
    step = statistics.median(runs["full"][0] for _, runs in rounds)
    body = []
    for k, (name, base, *_) in enumerate(rounds[0][0]):
        added = [
            [law[k][i] - (law[base][i] if base >= 0 else 0) for law, _ in rounds] for i in (2, 3)
        ]
        cells = []
        for i in (2, 3):
            cells += [spread([law[k][i] for law, _ in rounds], ".0f"), spread(added[i - 2], ".0f")]
        body.append((name, *cells, f"{9 * statistics.median(added[0]) / step * 100:.1f}"))
    whole_runs = []
    for models in MODELS:
        runs = [runs[models] for _, runs in rounds]
        cells = []
        for i in (0, 1):
            ratio = [found[models][i] / found["paper"][i] for _, found in rounds]
            cells += [spread([r[i] for r in runs], ".0f"), spread(ratio, ".2f")]
        whole_runs.append((f"``{models}``", *cells, *(f"{one:.2f}" for one in runs[0][2:])))
    publish(
        "Cost of each part of the contact law",
        PAGE,
        rounds=ROUNDS,
        parts=csv_table(PARTS, body),
        whole=csv_table(WHOLE, whole_runs),
    )


if __name__ == "__main__":
    sys.exit(main())
