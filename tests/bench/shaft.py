# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the speed and error for a shaft on two 6208s at 3000 rpm; write build/bench/shaft.rst.

    .venv/bin/python tests/bench/shaft.py [--print]     --print: do not write the page
    .venv/bin/python tests/bench/shaft.py --against DIR     compare with a7b5052 built in DIR

The deck is docs/decks/in.shaft at twice its usual speed. Every round runs all settings. At each
instant, loads are compared with those of a run with a tolerance of 0.1 nm.
"""

import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr
from deck_runs import ROOT, cost
from machine import csv_table, publish

ROUNDS = 5
SETTLE, MEASURE, SAMPLE = 0.06, 0.06, 2e-4  # s
REFERENCE, FINE_STEP = "tolerance 1e-10 cage_tolerance 1e-10 control bound", 5e-5
TOLERANCES = ("tolerance 1e-8", "tolerance 3e-8", "tolerance 1e-7")
# `paper` uses bounds of the errors by default
CONTROLS = {
    "paper": ["", *TOLERANCES, *(f"{one} control estimate" for one in TOLERANCES)],
    "full": ["", *TOLERANCES],
}
SHAFTS = "rigid", "flexible"
# The keywords that the decks of commit a7b5052 used for the models `full` at this speed
OLD_FULL = (
    "friction mixed 0.12 0.05 heathcote 1.0e-4 spin 1"
    " rolling 0.0455053444225571 0.15 0.906834624600571 rolling_hysteresis 0.01 drag 862.9 0.1"
    " gap 1 gap_film power film_damping branch inlet_shear murch 0.0455053444225571 0.15"
)
OLD_TOLERANCES = ("tolerance 1e-8", "tolerance 3e-8")
HEADS = (
    "version", "models", "shaft", "``fix bearing/implicit``", "evaluations", "real-time factor",
    "mean of a ball", "mean of the largest", "one instant",
)  # fmt: skip
PAGE = """\
Two 6208s carry the motor shaft of :doc:`../tutorial_shafts` at 3000 rpm, with unbalance, thrust,
belt pull and one-piece cages. A ball pass takes 5.6 ms. The table lists the number of force
evaluations and the real-time factor, i.e. the ratio of simulated time to processor time on one
core, with a record of loads and films every {sample:g} ms. The values are medians over {rounds}
rounds. The reference run has a tolerance of 0.1 nm. Errors are fractions of the largest load:

* *mean of a ball*: mean load over {measure:g} s, for the ball with the largest error;
* *mean of the largest*: mean over time of the largest load;
* *one instant*: load at one instant, for the ball and the instant with the largest error.

{table}

{machine}
"""


class Case(NamedTuple):
    """One row of the table."""

    tree: Path
    models: str
    shaft: str  # rigid or flexible
    control: str  # keywords of fix bearing/implicit

    def deck(self, step, out, modes):
        """Return the text of the deck with a host step of `step` (s)."""
        text = (self.tree / "docs" / "decks" / "in.shaft").read_text()
        record = f"fix record all bearing/record {round(SAMPLE / step)} ${{out}} overwrite yes"
        edits = {
            r"^variable out .*$": f"variable out index {out}",
            r"^(fix move all bearing/implicit).*$": rf"\1 {self.control}",
            r"^timestep .*$": f"timestep {step}",
            r"^thermo 200$": "thermo 100000",
            r"^run 1000$": f"run {round(SETTLE / step)}",
            r"^fix record .*$": f"{record} contacts load h_min",
            r"^run 1600$": f"run {round(MEASURE / step)}",
        }
        if self.tree == ROOT:
            edits[r"^variable rpm .*$"] = "variable rpm index 3000"
            edits["models full"] = f"models {self.models}"
        else:
            edits[r"2\*PI\*1500/60"] = "2*PI*3000/60"
            edits[r"^neighbor .*$"] = "neighbor 5.0e-3 nsq"
            edits["contacts load h_min$"] = "contacts load h_min text bearing 6208"
            if self.models == "full":
                edits["friction stribeck 0.12 0.05"] = OLD_FULL
        if self.shaft == "flexible":
            edits[r"^variable body .*$"] = f'variable body index "flexible {modes}"'
        for pattern, new in edits.items():
            text, count = re.subn(pattern, new, text, flags=re.M)
            if not count:
                sys.exit(f"{self.tree}: docs/decks/in.shaft has no line '{pattern}'")
        return text

    def run(self, folder, step=SAMPLE):
        """Return the cost of a run, and the loads of all contacts in N (samples, contacts)."""
        out, deck = folder / "run", folder / "in.shaft"
        deck.write_text(self.deck(step, out, folder / "motor.modes"))
        program = self.tree / "build" / "liggghts"
        words = [program, "-in", deck, "-log", "none", "-screen", "none"]
        subprocess.run(words, cwd=self.tree, check=True)
        with xr.open_dataset(out / "record.nc", decode_times=False) as record:
            loads = np.nan_to_num(record["load"].values)
        return cost(out), loads.reshape(len(loads), -1)


def errors(loads, truth):
    """Return the errors (mean of a ball, mean of the largest, one instant) as fractions of the
    largest load."""
    largest = truth.max()
    return (
        np.abs(loads.mean(axis=0) - truth.mean(axis=0)).max() / largest,
        abs(loads.max(axis=1).mean() - truth.max(axis=1).mean()) / largest,
        np.abs(loads - truth).max() / largest,
    )


def write_modes(folder):
    """Write the reduced model of the flexible shaft."""
    raceway = Path(sys.executable).with_name("raceway")
    words = ["shaft", ROOT / "inputs" / "shafts" / "motor", "--reduced", folder / "motor.modes"]
    words += ["--places", "0.1", "0.1874", "0.27", "--damping", "0.01"]
    subprocess.run([raceway, *words], check=True, stdout=subprocess.DEVNULL)


def cases(other):
    """Return the rows of the table, with those of the tree `other` unless it is None."""
    found = []
    for shaft in SHAFTS:
        for models, controls in CONTROLS.items():
            found += [Case(ROOT, models, shaft, control) for control in controls]
            # as its decks set it: the cage's tolerance of `full` is 1 um
            cage = " cage_tolerance 1e-6" if models == "full" else ""
            if other:
                found += [Case(other, models, shaft, one + cage) for one in OLD_TOLERANCES]
    return found


def main(other=None):
    """Measure, print the results and write the page."""
    rows, measured = cases(other), {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_modes(folder)
        truth = {}
        for case in rows:
            control = REFERENCE if case.tree == ROOT else REFERENCE.replace(" control bound", "")
            fine = case._replace(control=control)
            if fine not in truth:
                truth[fine] = fine.run(folder, FINE_STEP)[1]
            measured[case] = truth[fine], []
        for number in range(ROUNDS):
            print(f"round {number + 1} of {ROUNDS}", flush=True)
            for case in rows:
                measured[case][1].append(case.run(folder))
    lines = []
    for case in rows:
        right, runs = measured[case]
        factors = [one["simulated_s"] / one["processor_s"] for one, _ in runs]
        spent, loads = runs[0]
        version = "this" if case.tree == ROOT else "a7b5052"
        missed = (f"{value:.1e}" for value in errors(loads, right))
        control = f"``{case.control}``" if case.control else "defaults"
        work = f"{spent['evaluations']:.0f}", f"{statistics.median(factors):.2f}"
        lines.append((version, case.models, case.shaft, control, *work, *missed))
    sizes = dict(sample=1e3 * SAMPLE, rounds=ROUNDS, measure=MEASURE)
    publish("Speed and error of a shaft", PAGE, table=csv_table(HEADS, lines), **sizes)


if __name__ == "__main__":
    place = sys.argv.index("--against") + 1 if "--against" in sys.argv else None
    main(Path(sys.argv[place]).resolve() if place else None)
