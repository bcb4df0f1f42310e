# SPDX-License-Identifier: GPL-2.0-or-later
"""The `raceway` command. Exit codes: 0 done, 1 a message says why not, 2 wrong command line."""

import argparse
import os
import sys
import warnings
from collections.abc import Sequence

from raceway import __version__, progress
from raceway.commands import (
    animate,
    catalogue,
    check,
    circuit,
    dataset,
    electric,
    export,
    gather,
    heat,
    needs,
    paper,
    plot,
    report,
    shaft,
    spectrum,
    static,
    stiffness,
    summary,
    sweep,
)
from raceway.errors import RacewayError, RunWarning

EXAMPLES = """\
examples:
  build/liggghts -in inputs/in.6208 -var load 2000       run a bearing; results go to build/run/6208
  raceway summary build/run/6208                         its figures
  raceway check build/run/6208                           and their numerical errors
  raceway plot build/run/6208 --kind polar               a picture
  raceway animate build/run/6208                         a film of it
  raceway report build/run/6208                          all of it as one HTML page
  raceway catalogue --bore 40                            the bearings by name
  raceway static --load 2000 --clearance 10e-6           theory, without a run
  raceway stiffness --load 2000 --rpm 1000 3000          stiffness and damping for rotor programs
  raceway shaft inputs/shafts/motor                     bearings on one shaft
  raceway heat --load 2000 --rpm 3000                    its steady temperature
  raceway electric --load 2000 --rpm 3000                its capacitance and breakdown
  raceway sweep points.csv                               many runs, one a row
  raceway dataset inputs/datasets/small.yaml --out DIR   labelled vibration of many runs
  raceway needs inputs/in.6208 --want torque=10%         which parts of the model matter there

`raceway COMMAND --help` says more, with examples. DIR is the folder a run wrote, -var out of the
deck.
Exit codes: 0 done; 1 not done, a message says why; 2 wrong command line; 130 interrupted."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command with `argv` (default: the process's) and return its exit code."""
    arguments = _parser().parse_args(argv)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", RunWarning)
            warnings.showwarning = lambda message, *_, **__: print(
                f"raceway: warning: {message}", file=sys.stderr
            )
            progress.on = True
            arguments.command(arguments)
        sys.stdout.flush()
    except RacewayError as error:
        print(f"raceway: {error}", file=sys.stderr)
        return 1
    except (
        BrokenPipeError
    ):  # the reader had enough: leave nothing for the interpreter to flush at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


def _parser():
    parser = argparse.ArgumentParser(
        prog="raceway",
        description="Ball bearings: figures, spectra and pictures of runs, and theory.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"raceway {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    for module in (
        summary,
        check,
        plot,
        report,
        animate,
        export,
        spectrum,
        circuit,
        catalogue,
        static,
        stiffness,
        shaft,
        heat,
        electric,
        sweep,
        dataset,
        gather,
        needs,
        paper,
    ):
        module.add(commands)
    return parser
