# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway check DIR`: the numerical error of a run's figures."""

import argparse

from raceway.commands import Commands, options
from raceway.commands.program import command
from raceway.commands.quantity import takes_negative

DESCRIPTION = """\
Repeats a run of the main deck with a tenth of the tolerance (velocity Verlet: half the step), with
twice as many samples, and after 100 more ball passes of settling. The change of a figure is its
error. The repeats are in DIR/check, the errors in DIR/check.json. `raceway summary DIR` then shows
the sum of the errors beside each figure.

This is the numerical error, not the error of the model."""
EXAMPLES = """\
examples:
  build/liggghts -in inputs/in.6208 -var load 2000 -var out build/run/own
  raceway check build/run/own

Exit codes: 0 done, 1 the run cannot be repeated, 2 wrong command line."""


def add(commands: Commands) -> None:
    """Put the command into the parser's `commands`."""
    one = commands.add_parser(
        "check",
        help="the numerical error of a run's figures, found by finer repeats of the run",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    options.run_folder(one)
    options.variables(one, "data of the bearing or lubricant that were given to the run")
    options.deck(one)
    takes_negative(one)
    one.set_defaults(command=run)


def run(arguments: argparse.Namespace) -> None:
    """Repeat the run and print its figures with their errors. Raises `RacewayError`."""
    from raceway.runs.summary import summary, table
    from raceway.runs.tables import RunTables
    from raceway.sweeps.check import check

    check(arguments.folder, command(arguments), dict(arguments.var))
    print(table(summary(RunTables(arguments.folder))))
