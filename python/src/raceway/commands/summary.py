# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway summary DIR`: print the results of a run."""

import argparse

from raceway.commands import one_run, output

HELP = "print the results of a run with units and equations"
DESCRIPTION = """\
Prints loads, pressures, film, capacitance and speed of a finished run, each with its unit and
equation, next to the results of `raceway static` for the load, speed, clearance and models of the
run."""
EXAMPLES = """\
examples:
  raceway summary build/run/6208
  raceway summary build/run/6208 --json | python3 -m json.tool

Exit codes: 0 done, 1 the folder has no finished run or a broken one, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one_run.add(one)
    output.option(one, "print a JSON object in SI units instead of a table")


def run(arguments: argparse.Namespace) -> None:
    from raceway.runs.statics import statics
    from raceway.runs.summary import summary
    from raceway.runs.summary_table import table

    tables = one_run.tables(arguments)
    figures = summary(tables)
    figures |= statics(tables, figures)
    output.show(arguments, figures, table)
