# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway paper`: reproduce the figures, tables and checkable statements of the paper that defines
the model."""

import argparse
import os
import sys
from pathlib import Path

from raceway.commands import options
from raceway.errors import RacewayError

HELP = "reproduce figures, tables and statements of the paper"
DESCRIPTION = """\
Runs the cases of S. O. Farah, M. Guessasma, E. Bellenger 2020 (inputs/paper/cases.yaml), draws the
figures, writes the tables, and checks the statements of the paper. Results of runs are kept and
reused as long as the program, the decks and the settings do not change."""
EXAMPLES = """\
examples:
  raceway paper                          everything, into build/paper
  raceway paper --figure 8a --figure 9   two figures, and only the runs that they need
  raceway paper --list                   list of the available products

Exit codes: 0 done, 1 a case failed (the case is named, and products that do not need it are still
made), 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument(
        "--out",
        metavar="DIR",
        type=Path,
        help="folder for figures and tables (default: build/paper)",
    )
    one.add_argument(
        "--runs", metavar="DIR", type=Path, help="folder for the runs (default: build/paper/runs)"
    )
    options.jobs(one)
    one.add_argument(
        "--figure",
        metavar="NAME",
        action="append",
        dest="products",
        default=[],
        help="make only this product, named as in --list; may be repeated",
    )
    one.add_argument(
        "--list", action="store_true", help="list the figures and tables without running anything"
    )


def run(arguments: argparse.Namespace) -> None:
    # matplotlib and scipy take longer to load than `--help` should
    from raceway.paper import cases, press, runner

    tree = runner.root()
    plan = cases.plan(tree)
    if arguments.list:
        for name in plan.products:
            print(f"{name:12} {press.title(name)} ({len(plan.needed([name]))} runs)")
        return
    if unknown := [name for name in arguments.products if name not in plan.products]:
        raise RacewayError(
            f"no figure or table {', '.join(unknown)}; there are {', '.join(plan.products)}"
        )
    products = arguments.products or list(plan.products)
    wanted = plan.needed(products)
    runs = runner.Runner(tree, arguments.runs or tree / "build/paper/runs")
    runs.forget()
    outcome = runs.run_all(wanted, arguments.jobs, _progress(len(wanted)))
    missing = _make(products, plan, tree, outcome, arguments.out or tree / "build/paper")
    if outcome.failures or missing:
        raise RacewayError(
            f"{len(outcome.failures)} of {len(wanted)} cases failed"
            + (f"; not made: {', '.join(missing)}" if missing else "")
        )


def _make(products, plan, tree, outcome, out):
    """Write all products that can be made, and return the names of those that cannot."""
    from raceway.paper import press
    from raceway.paper.book import Book
    from raceway.paper.reading import Readings

    book, missing = Book(tree, Readings(plan, outcome.folders)), []
    for name in products:
        if not book.readings.has(name):
            missing.append(name)
            continue
        try:
            for path in press.make(name, book, out):
                print(os.path.relpath(path))
        except RacewayError as error:
            print(f"raceway: {name}: {error}", file=sys.stderr)
            missing.append(name)
    return missing


def _progress(total):
    """Return a function that reports failures and progress.

    It reports every case if stderr is a terminal, and every tenth case otherwise.
    """
    live = sys.stderr.isatty()
    again = "\r\033[K" if live else ""  # clears the current line

    def tell(done, case, error):
        if error:
            print(f"{again}raceway: {case.label}: {error}", file=sys.stderr)
        if live:
            print(
                f"{again}{done}/{total} {case.label[:70]}",
                end="\n" if done == total else "",
                file=sys.stderr,
                flush=True,
            )
        elif done % 10 == 0 or done == total:
            print(f"{done}/{total} cases", file=sys.stderr, flush=True)

    return tell
