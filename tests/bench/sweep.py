# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a sweep of 200 points to measure the throughput of two processes relative to one, and to
check that no point is lost if the sweep is killed half-way. Write build/bench/sweep.rst.

    .venv/bin/python tests/bench/sweep.py [--print]     --print: do not write the page
    .venv/bin/python tests/bench/sweep.py --against DIR     only compare with another built tree

Runs with one process and with two processes alternate, so that a drift in the speed of the machine
affects both. The exit code is 1 if a point was lost or run twice.
"""

import csv
import itertools
import os
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pandas as pd
from machine import ROOT, csv_table, publish, spread

LOADS, SPEEDS = (1000, 2000, 5000, 10000, 20000), (100, 250, 477.5, 1000, 2000)
CLEARANCES, OILS = (-2e-5, 0, 1e-5, 2e-5), ("mineral", "pao48")
# more ball passes per point than by default, so that light loads settle even at high speed
PASSES, SETTLE, SAMPLES = (4, 3, 100)
ROUNDS = 3
WANTED = 1.8
HEADS = ("processes", "wall time (s)", "points per second")
PAGE = """\
The sweep has {points} points: {loads} loads from {load_low} to {load_high} N,
{speeds} speeds from {rpm_low:g} to {rpm_high:g} rpm,
{clearances} clearances from {clearance_low:g} to {clearance_high:g} m, and {oils} lubricants.
Each point has {passes} ball passes, with all output and results (:doc:`../sweep`). Runs with one
process and with two processes alternated, on {cores} cores. Number of rounds: {rounds}.

{rows}

Two processes do {ratio:.2f} times the work of one process (individual rounds: {ratios}). At least
{wanted} is required.

A sweep was killed half-way (``kill -9`` with {killed} points finished and two running) and then
restarted. {finished} of {points} points finished; none was lost. Of the points that had finished,
{again} were run again. {same} result tables contain the same values as those of the undisturbed
sweep.

{machine}
"""


def write_table(path, models=None):
    """Write the points to a CSV file, and return the number of points. Without `models` they have
    the models that are the default of the main deck."""
    points = list(itertools.product(LOADS, SPEEDS, CLEARANCES, OILS))
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        heads = ["load", "rpm", "clearance", "lubricant", "passes", "settle", "samples"]
        same = [PASSES, SETTLE, SAMPLES] + ([models] if models else [])
        writer.writerow(heads + (["models"] if models else []))
        writer.writerows((*point, *same) for point in points)
    return len(points)


def command(table, folder, jobs, tree=ROOT):
    words = [table, "--out", folder, "--jobs", jobs]
    return [tree / ".venv/bin/python", "-m", "raceway", "sweep", *map(str, words)]


def timed(table, folder, jobs, tree=ROOT):
    begun = time.monotonic()
    done = subprocess.run(
        command(table, folder, jobs, tree),
        cwd=tree,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    if done.returncode:
        sys.exit(done.stdout[-3000:])
    return time.monotonic() - begun


def finished(folder):
    """Return a dict that maps each finished point to the time at which it was completed."""
    return {path.parent.name: path.stat().st_mtime_ns for path in folder.glob("*/summary.json")}


def figures(folder):
    """Return the table of results without the columns that contain wall-clock times."""
    return pd.read_csv(folder / "results.csv").drop(
        columns=["wall_s", "processor_s", "real_time_factor"]
    )


def killed_half_way(table, folder, points):
    """Return the number of points that had finished when the sweep was killed, the number that had
    finished after the restart, and the number of points that were run twice."""
    process = subprocess.Popen(
        command(table, folder, 2), cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    while len(finished(folder)) < points // 2:
        if process.poll() is not None:
            sys.exit(f"the sweep ended by itself with exit code {process.returncode}")
        time.sleep(0.02)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    time.sleep(1.0)  # the processes of the running points stop a little later
    before = finished(folder)
    timed(table, folder, 2)
    after = finished(folder)
    return len(before), len(after), sum(after.get(name) != when for name, when in before.items())


def against(tree):
    """Print how many times as fast this tree runs the points as another one, with the same models.
    The trees alternate, with one sweep on two cores at a time."""
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for models in ("paper", "full"):
            points = write_table(folder / "points.csv", models)
            seconds = {ROOT: [], tree: []}
            for _ in range(ROUNDS):
                for one, times in seconds.items():
                    times.append(timed(folder / "points.csv", folder / "out", 2, one))
                    shutil.rmtree(folder / "out")
            ratios = [other / own for own, other in zip(*seconds.values())]
            speeds = [points / statistics.median(times) for times in seconds.values()]
            print(f"{models}: {spread(ratios, '.2f')} times as fast, {speeds[0]:.1f} and"
                  f" {speeds[1]:.1f} points per second", flush=True)  # fmt: skip


def main():
    if "--against" in sys.argv:
        return against(Path(sys.argv[sys.argv.index("--against") + 1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        table = folder / "points.csv"
        points = write_table(table)
        seconds = {1: [], 2: []}
        for turn in range(ROUNDS):
            for jobs in (1, 2) if turn % 2 == 0 else (2, 1):
                seconds[jobs].append(timed(table, folder / f"{jobs}.{turn}", jobs))
                if turn:
                    shutil.rmtree(folder / f"{jobs}.{turn}")  # half a gigabyte for each process
                print(f"{jobs} at a time: {points} points in {seconds[jobs][-1]:.1f} s", flush=True)
        before, after, again = killed_half_way(table, folder / "killed", points)
        same = figures(folder / "killed").equals(figures(folder / "1.0")) and figures(
            folder / "2.0"
        ).equals(figures(folder / "1.0"))
    ratios = [one / two for one, two in zip(seconds[1], seconds[2])]
    medians = {jobs: statistics.median(times) for jobs, times in seconds.items()}
    ratio = medians[1] / medians[2]
    rows = [
        (jobs, spread(times, ".1f"), f"{points / medians[jobs]:.2f}")
        for jobs, times in seconds.items()
    ]
    publish(
        "A sweep on two cores",
        PAGE,
        cores=len(os.sched_getaffinity(0)),
        points=points,
        loads=len(LOADS),
        load_low=LOADS[0],
        load_high=LOADS[-1],
        speeds=len(SPEEDS),
        rpm_low=SPEEDS[0],
        rpm_high=SPEEDS[-1],
        clearances=len(CLEARANCES),
        clearance_low=CLEARANCES[0],
        clearance_high=CLEARANCES[-1],
        oils=len(OILS),
        passes=PASSES,
        rounds=ROUNDS,
        rows=csv_table(HEADS, rows),
        ratio=ratio,
        ratios=", ".join(f"{r:.2f}" for r in ratios),
        wanted=WANTED,
        killed=before,
        finished=after,
        again=again or "none",
        same="both" if same else "NOT both",
    )
    return 0 if after == points and not again and same else 1


if __name__ == "__main__":
    sys.exit(main())
