# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the cost of recording a single bearing and fleets of bearings, and write
build/bench/fleet_record.rst.

    .venv/bin/python tests/bench/fleet_record.py [ROUNDS] [--print]     --print: write no page

Runs of in.many that record all contacts at several instants of every host step alternate with the
same runs without output; the page lists the cost ratios. The cost of a run refers to its last 90 %,
because the cost of a run with a tenth of the steps is subtracted. The script opens each record to
check that it contains the expected number of samples, and checks that runs without output do not
write a record.
"""

import sys
import tempfile
from pathlib import Path

import against
import raceway
from machine import count_asked, csv_table, publish

WITHIN = 5  # samples per host step
STEP = 8.75e-4  # s; at this step, there are 200 samples per ball pass, as in the main deck
STEPS = {1: 4000, 100: 80, 1000: 20}  # {number of bearings: host steps}
MODELS = ("paper", "full")
PAGE = """\
Cost of a run that records all contacts at {within} instants per host step of {step:g} ms (200
samples per ball pass), divided by the cost of the same run without output: median (range) over
{rounds} rounds.

{table}

{machine}
"""
DECK = """include inputs/in.many
undump table
unfix record
{record}

run {steps}
"""
RECORD = "fix record all bearing/record 1 {out} within {within} overwrite yes"


def run(folder, bearings, models, steps, recorded, instructions):
    """Run the deck once, check its record, and return (seconds, instructions or None)."""
    out = folder / ("record" if recorded else "nothing")
    record = RECORD.format(out=out, within=WITHIN) if recorded else ""
    deck = folder / "in.fleet"
    deck.write_text(DECK.format(record=record, steps=steps))
    variables = {
        "bearings": bearings,
        "columns": max(1, round(bearings**0.5)),
        "models": models,
        "record": "none",
        "lubricant": "mineral",
        "step": STEP,
        "sample": STEP,
        "time": 40 * STEP,
        "overwrite": "yes",
        "out": out,
    }
    cost = against.program(against.ROOT, deck, variables, instructions)
    file = out / "record.nc"
    if file.exists() != recorded:
        sys.exit(f"{out}: a record {'is missing' if recorded else 'was written'}")
    if recorded:
        found = raceway.open(out).select(1).bearing.sizes["time"]
        if found != WITHIN * steps + 1:  # the initial state is an additional sample
            sys.exit(f"{out} has {found} samples, not {WITHIN * steps + 1}")
    return cost


def ratios(folder, bearings, models, rounds, instructions):
    """Return ([ratios of seconds], [ratios of instructions]), i.e. the costs of runs with a record
    divided by those of runs without one."""
    found = ([], [])
    steps = STEPS[bearings]
    for n in range(rounds):
        cost = {}
        for recorded in (True, False) if n % 2 else (False, True):
            long, short = (
                run(folder, bearings, models, count, recorded, instructions)
                for count in (steps, steps // 10)
            )
            cost[recorded] = [a - b for a, b in zip(long, short) if a is not None]
        for k, (with_record, without) in enumerate(zip(cost[True], cost[False])):
            found[k].append(with_record / without)
    return found


def main():
    rounds = count_asked(5)
    instructions = against.counts()
    rows = []
    for models in MODELS:
        for bearings in STEPS:
            with tempfile.TemporaryDirectory() as folder:
                found = ratios(Path(folder), bearings, models, rounds, instructions)
            rows.append((models, bearings, *map(against.spread, found)))
            print(*rows[-1], flush=True)
    table = csv_table(("models", "bearings", "user seconds", "instructions"), rows)
    step = STEP * 1e3
    publish("Recording fleets", PAGE, within=WITHIN, step=step, rounds=rounds, table=table)


if __name__ == "__main__":
    main()
