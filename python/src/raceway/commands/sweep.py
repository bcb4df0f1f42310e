# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway sweep`: run a deck for every row of a table, or write a job array that does so."""

import argparse
import re
import shlex
import sys
from pathlib import Path

from raceway import files
from raceway.commands import options
from raceway.commands.program import command, end_on_signals
from raceway.commands.quantity import positive
from raceway.errors import RacewayError
from raceway.sweeps.points import check_ranges, deck_variables, read_points

HELP = "run a deck for every row of a table"
DESCRIPTION = """\
Each row of the CSV file TABLE is a point, and each column a variable of the deck: load, rpm,
clearance, lubricant, ... Every point has its own folder in DIR, named after its values. Finished
points are not run again, so a sweep that was stopped (by Ctrl-C, kill or a time limit) continues
when the command is repeated; two sweeps started on the same DIR share the work. If a point fails,
its error message is kept and the other points continue. At the end, DIR/results.csv has one row per
point.

A column `share` is not a variable; it contains the fraction of the time that a load spectrum spends
at each point. `raceway static --spectrum DIR/results.csv` computes the life under all points
together.
"""
EXAMPLES = """\
examples:
  raceway sweep points.csv                          into build/sweep/points
  raceway sweep points.csv --out here --jobs 2
  raceway sweep points.csv --slurm job.sh           then: sbatch job.sh

A table of four points has a first line such as load,rpm,lubricant and four lines such as
5000,477.5,mineral.
Exit codes: 0 all points finished, 1 a point failed or the table cannot be used, 2 wrong command
line, 130 and 143 stopped."""
SLURM = """\
#!/bin/bash
# A sweep as a Slurm job array, written by `raceway sweep`. Submit it from the folder in which
# `raceway sweep` was called:
#   sbatch {script}
# Submit it again to run the missing points; `raceway gather {folder}` shows the finished ones.
#SBATCH --job-name=raceway-sweep
#SBATCH --array=1-{tasks}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=TERM@60
#SBATCH --output={folder}/slurm-%A_%a.txt
exec {command} --jobs "${{SLURM_CPUS_PER_TASK:-1}}" --part "${{SLURM_ARRAY_TASK_ID:?}}/{tasks}"
"""


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument(
        "table",
        metavar="TABLE",
        help="CSV file with variables of the deck in the first line and one point in each further"
        " line",
    )
    one.add_argument(
        "--out", metavar="DIR", help="folder for the sweep (default: build/sweep/NAME for NAME.csv)"
    )
    options.jobs(one)
    options.deck(one)
    one.add_argument("--retry", action="store_true", help="run failed points again")
    one.add_argument(
        "--part",
        metavar="I/N",
        type=_part,
        default=(1, 1),
        help="run only the points I, I+N, I+2N, ... of the table",
    )
    one.add_argument("--check", action="store_true", help="only check the table, with its ranges")
    one.add_argument(
        "--slurm", metavar="SCRIPT", help="write a Slurm job array to SCRIPT instead of running it"
    )
    one.add_argument(
        "--tasks",
        metavar="N",
        type=positive,
        help="with --slurm: number of tasks in the array (default: one per point, at most 1000)",
    )


def run(arguments: argparse.Namespace) -> None:
    points = read_points(arguments.table, deck_variables(arguments.deck))
    runs = command(arguments)
    out = Path(arguments.out or Path("build/sweep") / Path(arguments.table).stem)
    if arguments.check:
        check_ranges(arguments.table, points, arguments.deck)
        print(f"{arguments.table}: {len(points)} points")
    elif arguments.slurm:
        _write_array(arguments, out, len(points))
    else:
        from raceway.sweeps.gather import write_shares  # numpy is slow to import
        from raceway.sweeps.point_run import FINISHED, state
        from raceway.sweeps.sweep import sweep

        first, step = arguments.part
        files.folder(out)
        write_shares(out, points)
        end_on_signals()
        part = points[first - 1 :: step]
        try:
            counts, before, path = sweep(
                part, out, runs, jobs=arguments.jobs, retry=arguments.retry
            )
        except (KeyboardInterrupt, SystemExit):
            states = [state(out / point.name, point.variables)[0] for point in part]
            print(
                f"raceway: stopped with {states.count(FINISHED)} of {len(part)} points finished;"
                " the same command continues",
                file=sys.stderr,
            )
            raise
        print(
            ", ".join(
                f"{number} {what}"
                + (f" ({before} before)" if what == "finished" and before else "")
                for what, number in counts.items()
            )
            + f": {path}"
        )
        if counts.get("failed"):
            several = "s" if counts["failed"] > 1 else ""
            raise RacewayError(
                f"{counts['failed']} point{several} failed: see the column message of {path}."
                " --retry runs failed points again; a point that is no longer in the table is kept"
                " until its folder is removed"
            )


def _write_array(arguments, out, points):
    tasks = min(arguments.tasks or 1000, points)
    for name in (str(out), arguments.slurm, arguments.table, arguments.deck, arguments.program):
        if not name.isprintable():  # a line break would start a new #SBATCH line
            raise RacewayError(f"{name!r} contains a line break or another control character")
    words = [
        sys.executable,
        "-m",
        "raceway",
        "sweep",
        arguments.table,
        "--out",
        str(out),
        "--deck",
        arguments.deck,
        "--program",
        arguments.program,
    ]
    text = SLURM.format(
        script=shlex.quote(arguments.slurm),
        folder=shlex.quote(str(out)),
        tasks=tasks,
        command=shlex.join(words + ["--retry"] * arguments.retry),
    )
    files.folder(out)  # Slurm does not create its output folder
    files.text(arguments.slurm, text)
    print(f"{arguments.slurm}: {points} points in {tasks} tasks")


def _part(text):
    match = re.fullmatch(r"([1-9][0-9]*)/([1-9][0-9]*)", text)
    if not match or int(match[1]) > int(match[2]):
        raise argparse.ArgumentTypeError(f"'{text}' is not I/N with 1 <= I <= N")
    return int(match[1]), int(match[2])
