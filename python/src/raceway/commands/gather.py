# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway gather`: the results of a sweep so far as one table."""

import argparse

from raceway.commands import Commands

HELP = "results of a sweep as one CSV table"
EXAMPLES = """\
examples:
  raceway gather build/sweep/points

Exit codes: 0 done, even if points are missing or failed, 1 DIR has no sweep,
2 wrong command line."""


def add(commands: Commands) -> None:
    """Put the command into the parser's `commands`."""
    parser = commands.add_parser(
        "gather",
        help=HELP,
        description=(
            "Write DIR/results.csv: a row per point, with the variables that were set, "
            "all figures of `raceway summary`, and the message of points that failed."
        ),
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("folder", metavar="DIR", help="folder of the sweep")
    parser.set_defaults(command=run)


def run(arguments: argparse.Namespace) -> None:
    """Write the table; print its path and the number of points by status. Raises `RacewayError`
    if there is no sweep."""
    # loading pandas takes longer than printing --help
    from raceway.sweeps.gather import write_results

    path, table = write_results(arguments.folder)
    counts = table["status"].value_counts()
    print(
        f"{path}: "
        + ", ".join(
            f"{counts[status]} {status}"
            for status in ("finished", "failed", "pending")
            if status in counts
        )
    )
