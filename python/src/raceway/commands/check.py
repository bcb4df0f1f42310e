# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway check DIR`: estimate the numerical error of the results of a run."""

import argparse

from raceway.commands import options
from raceway.commands.program import command

HELP = "estimate the numerical error of a run by repeating it with finer settings"
DESCRIPTION = """\
Repeats a run of the main deck three times: with a tenth of the tolerance (velocity Verlet: half the
time step), with twice as many samples, and with 100 additional ball passes of settling. The change
of a result in each repeat is taken as its error. Torque and cage speed may wander in a run that has
settled, for example because the cage whirls; their largest change in the last half of the longer
settling is a fourth error. The repeats are written to DIR/check and the errors to DIR/check.json.
`raceway summary DIR` then shows the sum of the errors next to each result.

This is the numerical error, not the error of the model."""
EXAMPLES = """\
examples:
  build/liggghts -in inputs/in.6208 -var load 2000 -var out build/run/own
  raceway check build/run/own

Exit codes: 0 done, 1 the run cannot be repeated, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    options.run_folder(one)
    options.variables(one, "bearing or lubricant data that were given to the run")
    options.deck(one)


def run(arguments: argparse.Namespace) -> None:
    from raceway.runs.summary import summary
    from raceway.runs.summary_table import table
    from raceway.runs.tables import RunTables
    from raceway.sweeps.check import check

    check(arguments.folder, command(arguments), dict(arguments.var))
    print(table(summary(RunTables(arguments.folder))))
