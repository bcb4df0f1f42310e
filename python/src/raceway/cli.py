# SPDX-License-Identifier: GPL-2.0-or-later
"""The `raceway` command. Exit codes: 0 done, 1 a message says why not, 2 wrong command line."""

import argparse
import json
import os
import sys
import warnings
from pathlib import Path

from raceway import __version__, progress
from raceway.commands import gather, paper, spectrum, static, sweep
from raceway.errors import RacewayError, RunWarning
from raceway.run import Run
from raceway.summary import summary, table


def main(argv=None):
    """Run the command with `argv` (default: the process's) and return its exit code."""
    arguments = _parser().parse_args(argv)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", RunWarning)
            warnings.showwarning = lambda message, *_, **__: print(f"raceway: warning: {message}", file=sys.stderr)
            progress.on = True
            arguments.command(arguments)
        sys.stdout.flush()
    except RacewayError as error:
        print(f"raceway: {error}", file=sys.stderr)
        return 1
    except BrokenPipeError:  # the reader had enough: leave nothing for the interpreter to flush at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


def _parser():
    parser = argparse.ArgumentParser(prog="raceway", description="Ball bearings: figures, spectra and pictures of runs, and theory.")
    parser.add_argument("--version", action="version", version=f"raceway {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    one = commands.add_parser("summary", help="the figures of a run, with units and equations")
    one.add_argument("folder", metavar="DIR", help="folder the run wrote")
    one.add_argument("--json", action="store_true", help="one JSON object instead of a table")
    one.set_defaults(command=_summary)
    one = commands.add_parser("plot", help="one picture of a run")
    one.add_argument("folder", metavar="DIR", help="folder the run wrote")
    one.add_argument("--out", metavar="PNG", help="where to put it (default: DIR/overview.png)")
    one.set_defaults(command=_plot)
    for module in (spectrum, static, sweep, gather, paper):
        module.add(commands)
    return parser


def _summary(arguments):
    figures = summary(Run(arguments.folder))
    print(json.dumps(figures, indent=2, ensure_ascii=False, allow_nan=False) if arguments.json else table(figures))


def _plot(arguments):
    from raceway.plot import overview  # matplotlib takes longer to load than a summary to compute

    out = Path(arguments.out or Path(arguments.folder) / "overview.png")
    overview(Run(arguments.folder), out)
    print(out)
