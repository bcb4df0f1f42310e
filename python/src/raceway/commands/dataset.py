# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway dataset`: vibration of many runs as labelled files."""

import argparse

from raceway.commands import Commands, options
from raceway.commands.program import command, end_on_signals

DESCRIPTION = """\
Runs every flaw in the file SPEC under all of its conditions, with integrator vibration and a
housing. Each run becomes a record: .mat files with the housing's acceleration at the rates of
SPEC, and a row of DIR/labels.csv. DIR/README.md states what is simulated and what is assumed.

After a stop the same command continues. A folder made from another SPEC is refused."""
EXAMPLES = """\
examples:
  raceway dataset inputs/datasets/small.yaml --check            how many runs, how long
  raceway dataset inputs/datasets/small.yaml --out build/small
  raceway dataset inputs/datasets/spalls.yaml --out build/spalls --jobs 2

Exit codes: 0 done, 1 a run failed or SPEC cannot be used, 2 wrong command line, 130 and 143
stopped."""


def add(commands: Commands) -> None:
    """Put the command into the parser's `commands`."""
    one = commands.add_parser(
        "dataset",
        help="labelled vibration data: a sweep over flaws and conditions as .mat files",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    one.add_argument("spec", metavar="SPEC", help="YAML file: flaws, conditions, rates")
    one.add_argument("--out", metavar="DIR", help="folder of the data set")
    options.jobs(one)
    one.add_argument("--keep", action="store_true", help="keep the records of the runs (large)")
    one.add_argument("--check", action="store_true", help="check SPEC, run nothing")
    options.deck(one)
    one.set_defaults(command=run, complain=one.error)


def run(arguments: argparse.Namespace) -> None:
    """Make the data set, or only check its specification. Raises `RacewayError`."""
    from raceway.datasets.spec import read_spec, records
    from raceway.sweeps.points import deck_variables

    spec = read_spec(arguments.spec, deck_variables(arguments.deck))
    wanted = records(spec)
    if arguments.check:
        seconds = len(wanted) * spec.seconds
        print(f"{arguments.spec}: {len(wanted)} records, {seconds:g} s at {spec.run_rate} Hz")
        return
    if not arguments.out:
        arguments.complain("--out: give a folder for the data set")
    runs = command(arguments)
    from raceway.datasets.make import LABELS, make  # scipy and pandas are slow to import

    end_on_signals()
    table = make(spec, arguments.out, runs, jobs=arguments.jobs, keep=arguments.keep)
    print(f"{len(table)} of {len(wanted)} records: {arguments.out}/{LABELS}")
