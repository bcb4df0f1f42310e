# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway gather`: collect the results that a sweep has so far in one table."""

import argparse

HELP = "collect the results of a sweep in one CSV table"
DESCRIPTION = """\
Writes DIR/results.csv with one row per point, which contains the variables that were set, all
results of `raceway summary`, and the error message if the point failed."""
EXAMPLES = """\
examples:
  raceway gather build/sweep/points

Exit codes: 0 done, even if points are missing or failed, 1 DIR has no sweep,
2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("folder", metavar="DIR", help="folder of the sweep")


def run(arguments: argparse.Namespace) -> None:
    # loading numpy takes longer than printing --help
    from raceway.sweeps.gather import write_results

    path, counts = write_results(arguments.folder)
    print(
        f"{path}: "
        + ", ".join(
            f"{counts[status]} {status}"
            for status in ("finished", "failed", "pending")
            if status in counts
        )
    )
