# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway dataset`: generate labelled vibration data from many runs."""

import argparse

from raceway.commands import options
from raceway.commands.program import command, end_on_signals

HELP = "generate labelled vibration data (.mat files) for many flaws and conditions"
DESCRIPTION = """\
Runs every flaw in the file SPEC under all of its conditions, with the integrator `vibration` and a
housing. Each run becomes a record, which consists of .mat files with the acceleration of the
housing at the sampling rates given in SPEC, and of a row in DIR/labels.csv. DIR/README.md states
what is simulated and what is assumed.

A data set that was interrupted is continued by the same command. A folder that was made from a
different SPEC is rejected."""
EXAMPLES = """\
examples:
  raceway dataset inputs/datasets/small.yaml --check            number and length of the runs
  raceway dataset inputs/datasets/small.yaml --out build/small
  raceway dataset inputs/datasets/spalls.yaml --out build/spalls --jobs 2

Exit codes: 0 done, 1 a run failed or SPEC cannot be used, 2 wrong command line, 130 and 143
stopped."""


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("spec", metavar="SPEC", help="YAML file with flaws, conditions and rates")
    one.add_argument("--out", metavar="DIR", help="folder for the data set")
    options.jobs(one)
    one.add_argument("--keep", action="store_true", help="keep the records of the runs (large)")
    one.add_argument("--check", action="store_true", help="only check SPEC, without running it")
    options.deck(one)


def run(arguments: argparse.Namespace) -> None:
    from raceway.datasets.spec import read_spec, records
    from raceway.sweeps.points import deck_variables

    spec = read_spec(arguments.spec, deck_variables(arguments.deck))
    wanted = records(spec)
    if arguments.check:
        seconds = len(wanted) * spec.seconds
        print(f"{arguments.spec}: {len(wanted)} records, {seconds:g} s at {spec.run_rate} Hz")
        return
    if not arguments.out:
        arguments.complain("give a folder for the data set with --out")
    runs = command(arguments)
    from raceway.datasets.make import LABELS, make  # scipy and pandas are slow to import

    end_on_signals()
    table = make(spec, arguments.out, runs, jobs=arguments.jobs, keep=arguments.keep)
    print(f"{len(table)} of {len(wanted)} records: {arguments.out}/{LABELS}")
