# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the cost of many bearings in one box, on one rank and on two ranks, and write
build/bench/many.rst.

    .venv/bin/python tests/bench/many.py [ROUNDS] [--print]     --print: do not write the page

The runs of a round are made one after another, so that a drift in the speed of the machine affects
all of them; ratios are formed within each round.
"""

import math
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from deck_runs import ROOT, command, succeed
from machine import count_asked, csv_table, publish, spread

MANY = 1000
ENVIRONMENT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMPI_MCA_mpi_yield_when_idle="0",
)
# time step (s); host steps of the timed run with one bearing and with many; duration (s) of the
# load ramp before the timed run; a ball pass has 140 steps
INTEGRATORS = {
    "verlet": {"step": 4e-7, "steps": (400_000, 1000), "settle": 4e-4},
    "implicit": {"step": 2.5e-4, "steps": (70_000, 140), "settle": 2e-2},
}
ALIKE = {"fleet": "alike", "lubricant": "mineral", "models": "paper", "record": "none"}
HEADS = (
    *("integrator", "bearing-step, one bearing (µs)", f"bearing-step, {MANY} bearings (µs)"),
    *("ratio (at most 1.3)", "efficiency (at least 0.8)", "memory per bearing (kB)"),
)
PAGE = """\
``inputs/in.many`` was run with {many} identical 6208 bearings in a square grid, each under 5 kN at
477.5 rpm, with film, friction and cage. The values are medians over {rounds} rounds, with the range
in brackets. Ratios are formed within each round.

One rank and two ranks
----------------------

*bearing-step*: wall time of the run divided by its numbers of steps and bearings. The steps of
velocity Verlet are 0.4 µs long. The internal steps of the implicit integrator are about 200 µs
long, with host steps of 250 µs and without output. *ratio*: bearing-step for many bearings in a
box, divided by that for a single bearing, both on one rank. *efficiency* of two ranks: time on one
rank divided by twice the time on two ranks.

{table}

There are two effects on the ratio, which act in opposite directions. A single bearing stays in the
caches of its core, whereas many bearings are fetched from main memory once per host step (the table
lists their memory). On the other hand, a single bearing carries the whole fixed cost of a host
step. Identical bearings share the solver of the implicit step, which stays in the caches, so that
only the state of a bearing is fetched.

The final states of {many} bearings that differ in load, speed, azimuth and lubricant were compared
bitwise between runs on 1, 2 and 4 ranks (4 ranks on two cores): {equal}.

Setup time on one rank: {set_ups}. Each ``create_bearing`` command adds its atoms to the host's map,
which is rebuilt after every thousand atoms. The command still searches for the largest tag on its
rank, which takes about a nanosecond for every few atoms.

Larger runs
-----------

All ranks communicate with each other only in two cases: when neighbour lists are checked, and for
output. Otherwise, a rank computes its bearings and exchanges messages with its neighbours.

- Ranks are assigned equal volumes. If the cost differs between bearings (the implicit step refines
  some more than others), the slowest rank determines the speed. A grid that cannot be divided
  evenly among the ranks also increases the cost.
- After every new neighbour list, each rank sends the sizes of its messages, a few bytes for each
  rank, to every other rank. With the implicit step this happens every few host steps; with Verlet,
  every few thousand steps.
- With the implicit step, all ranks exchange lists of the rings that belong together: about 24 bytes
  for each ring and each rank that sees it. For more than about 10\\ :sup:`5` bearings, these lists
  determine the speed, and not the bearings.
- On every rank, the host's map of atoms requires 4 bytes for every atom in the box, i.e. 80 MB for
  10\\ :sup:`6` bearings. Each fix bearing/ring requires 4 bytes for every ring.
- ``thermo`` with compute bearing/total gathers all balls on all ranks. The table of compute
  bearing/ring does not.

{machine}
"""


def run(ranks, steps, folder, **variables):
    """Return the results of one run of in.many: the wall times (s) of a bearing-step and of all
    loops, and the memory (kB)."""
    implicit = variables["integrator"] == "implicit"
    settle = INTEGRATORS[variables["integrator"]]["settle"]
    deck = folder / "in.bench"
    # the load is applied during the first run; only the last run is timed
    deck.write_text(
        f"include inputs/in.many\nundump table\nrun {steps}\n"
        + ('variable made equal f_move[3]\nprint "internal steps ${made}"\n' if implicit else "")
    )
    times = dict(time=settle, sample=settle, ramp=settle / 4)
    words = command(deck, out=folder, overwrite="yes", **times, **variables)
    if ranks > 1:
        words = ["mpirun.openmpi", "--oversubscribe", "-np", str(ranks), *words]
    with open(folder / "said", "w", encoding="utf-8") as said:
        process = subprocess.Popen(
            words,
            cwd=ROOT,
            env=ENVIRONMENT,
            stdin=subprocess.DEVNULL,
            stdout=said,
            stderr=subprocess.STDOUT,
        )
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    text = (folder / "said").read_text(errors="replace")
    if process.returncode:
        sys.exit(f"failed: {' '.join(words)}\n{text[-2000:]}")
    loops = [float(number) for number in re.findall(r"Loop time of (\S+) on", text)]
    made = steps * variables["bearings"]
    if implicit:
        made = float(re.search(r"internal steps (\S+)$", text, re.M)[1])
    return {"cost": loops[-1] / made, "loops": sum(loops), "memory": usage.ru_maxrss}


def state(ranks, folder, **variables):
    """Return the final state, with all digits, of many bearings that differ."""
    succeed("tests/hosts/in.many_bits", ranks=ranks, out=folder, **variables)
    # rows of tables, sorted by step; the order of the rows, but not their values, may depend on the
    # number of ranks
    return (
        sorted((folder / "bearings.dump").read_text().splitlines()),
        (folder / "last.dump").read_text(),
    )


def measure(rounds, folder):
    """Return a dict for each round and integrator that contains the seconds per bearing and host
    step, and the other results."""
    results = {}
    for name, how in INTEGRATORS.items():
        one, many = how["steps"]
        case = {**ALIKE, "integrator": name, "step": how["step"]}
        columns = math.ceil(math.sqrt(MANY))
        results[name] = []
        for number in range(rounds):
            print(f"{name}, round {number + 1} of {rounds}", flush=True)
            single = run(1, one, folder, bearings=1, columns=1, **case)
            serial = run(1, many, folder, bearings=MANY, columns=columns, **case)
            double = run(2, many, folder, bearings=MANY, columns=columns, **case)
            results[name].append(
                {
                    "single": single["cost"],
                    "many": serial["cost"],
                    "ratio": serial["cost"] / single["cost"],
                    "efficiency": serial["cost"] / (2 * double["cost"]),
                    "memory": (serial["memory"] - single["memory"]) / (MANY - 1),
                }
            )
    return results


def set_up(folder):
    """Return a list of (number of bearings, wall seconds before the first step)."""
    rows = []
    for n in (1, 1000, 4000, 16_000):
        begin, case = time.monotonic(), dict(ALIKE, integrator="implicit", step=2.5e-4)
        loops = run(1, 1, folder, bearings=n, columns=math.ceil(math.sqrt(n)), **case)["loops"]
        rows.append((n, time.monotonic() - begin - loops))
    return rows


def main():
    """Measure, print the results and write the page."""
    rounds = count_asked(5)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        results = measure(rounds, folder)
        equal = {}
        for integrator, how in INTEGRATORS.items():
            length = 1e-3 if integrator == "implicit" else 2e-5
            case = {
                "bearings": MANY,
                "columns": math.ceil(math.sqrt(MANY)),
                "integrator": integrator,
                "time": length,
                "sample": length,
                "step": how["step"],
                "ramp": length / 2,
                "models": "paper",
                "overwrite": "yes",
            }
            print(f"{integrator}: comparing results on 1, 2 and 4 ranks", flush=True)
            states = []
            for ranks in (1, 2, 4):
                (folder / str(ranks)).mkdir(exist_ok=True)
                states.append(state(ranks, folder / str(ranks), **case))
            equal[integrator] = all(one == states[0] for one in states)
        set_ups = [f"{n} bearings {seconds:.2g} s" for n, seconds in set_up(folder)]
    rows = []
    for name, got in results.items():
        each = {key: [one[key] for one in got] for key in got[0]}
        steps = (spread([1e6 * one for one in each[key]]) for key in ("single", "many"))
        ratios = (spread(each[key]) for key in ("ratio", "efficiency"))
        memory = statistics.median(each["memory"])
        rows.append([name, *steps, *ratios, f"{memory:.0f}"])
    said = {name: "identical" if same else "**different**" for name, same in equal.items()}
    publish(
        "Many bearings",
        PAGE,
        many=MANY,
        rounds=rounds,
        table=csv_table(HEADS, rows),
        equal="; ".join(f"{name}: {one}" for name, one in said.items()),
        set_ups="; ".join(set_ups),
    )


if __name__ == "__main__":
    main()
