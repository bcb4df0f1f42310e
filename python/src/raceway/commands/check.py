# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway check DIR`: the numerical error of a run's figures."""

import argparse
import shlex
import shutil

from raceway.commands import Commands
from raceway.commands.quantity import takes_negative
from raceway.errors import RacewayError

DESCRIPTION = """\
Repeats a run of the main deck with a tenth of the tolerance (velocity Verlet: half the step), and
with twice the samples. The difference of a figure is its error. The repeats are in DIR/check, the
errors in DIR/check.json. `raceway summary DIR` then shows the sum of both beside each figure.

This is the error of the numbers, not of the model."""
EXAMPLES = """\
examples:
  build/liggghts -in inputs/in.6208 -var load 2000 -var out build/run/own
  raceway check build/run/own

Exit codes: 0 done, 1 the run cannot be repeated, 2 wrong command line."""


def add(commands: Commands) -> None:
    """Put the command into the parser's `commands`."""
    one = commands.add_parser(
        "check",
        help="the numerical error of a run's figures, by repeating it finer",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    one.add_argument("folder", metavar="DIR", help="folder the run wrote")
    one.add_argument(
        "--var",
        nargs=2,
        action="append",
        default=[],
        metavar=("NAME", "VALUE"),
        help="what the run was given of a bearing's or a lubricant's own data; may be repeated",
    )
    one.add_argument(
        "--deck", metavar="FILE", default="inputs/in.6208", help="deck (default: %(default)s)"
    )
    one.add_argument(
        "--program",
        metavar="COMMAND",
        default="build/liggghts",
        help="program that runs it, with its own words if any (default: %(default)s)",
    )
    takes_negative(one)
    one.set_defaults(command=run)


def run(arguments: argparse.Namespace) -> None:
    """Repeat the run and print its figures with their errors. Raises `RacewayError`."""
    from raceway.runs.summary import summary, table
    from raceway.runs.tables import RunTables
    from raceway.sweeps.check import check

    program = shlex.split(arguments.program)
    if not program or shutil.which(program[0]) is None:
        raise RacewayError(
            f"there is no program {arguments.program!r}: `make build` makes build/liggghts; start"
            " from the repository's root"
        )
    check(arguments.folder, [*program, "-in", arguments.deck], dict(arguments.var))
    print(table(summary(RunTables(arguments.folder))))
