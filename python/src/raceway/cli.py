# SPDX-License-Identifier: GPL-2.0-or-later
"""The `raceway` command. Its exit codes are 0 for success, 1 for a failure with a message, and 2
for a wrong command line."""

import argparse
import os
import pkgutil
import sys
import warnings
from collections.abc import Iterator, Sequence
from importlib import import_module
from types import ModuleType

import raceway
from raceway import commands, progress
from raceway.commands.parser import Parser, grouped
from raceway.errors import RacewayError, RunWarning

EXAMPLES = """\
examples:
  build/liggghts -in inputs/in.6208 -var load 2000       run a bearing; results go to build/run/6208
  raceway summary build/run/6208                         print its results
  raceway plot build/run/6208 --kind polar               draw a picture
  raceway static --load 2000 --clearance 10e-6           compute the statics, without a run

`raceway COMMAND --help` has details and examples. Numbers may have a unit: 5kN, 10um, 60C. DIR is
the folder that a run wrote; its name is given to the deck by -var out.
Exit codes: 0 done; 1 not done, with a message; 2 wrong command line; 130 interrupted."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command with `argv` (default: the process's arguments), and return its exit code."""
    words = sys.argv[1:] if argv is None else list(argv)
    parser = _parser()
    if not words:
        parser.print_help()
        return 0
    arguments, unknown = parser.parse_known_args(words)
    if unknown:
        arguments.parser.refuse(unknown)
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
    except BrokenPipeError:
        # the reader has closed the pipe; redirect stdout, because the interpreter flushes it at
        # exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as error:
        print(f"raceway: {error.filename or ''}: {error.strerror or error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


def modules() -> Iterator[ModuleType]:
    """Yield the subcommands, i.e. the modules in `raceway.commands` that define `add` and `run`, in
    alphabetical order. Modules whose names begin with an underscore are helpers that load large
    packages; they are skipped without being imported."""
    for found in pkgutil.iter_modules(commands.__path__):
        if found.name.startswith("_"):
            continue
        module = import_module(f"{commands.__name__}.{found.name}")
        if hasattr(module, "add") and hasattr(module, "run"):
            yield module


def _parser():
    parser = Parser(
        prog="raceway",
        usage="%(prog)s [-h] [--version] COMMAND ...",
        description="Ball bearings: results, spectra and pictures of runs, and theory.",
    )
    parser.add_argument("--version", action="version", version=f"raceway {raceway.__version__}")
    parsers = parser.add_subparsers(
        prog="raceway", required=True, metavar="COMMAND", help=argparse.SUPPRESS
    )
    for module in modules():
        one = parsers.add_parser(
            module.__name__.rpartition(".")[2],
            help=module.HELP,
            description=module.DESCRIPTION,
            epilog=module.EXAMPLES,
        )
        module.add(one)
        one.set_defaults(command=module.run, complain=one.error, parser=one)
    helps = {action.dest: action.help for action in parsers._choices_actions}
    parser.epilog = f"{grouped(helps)}\n\n{EXAMPLES}"
    return parser
