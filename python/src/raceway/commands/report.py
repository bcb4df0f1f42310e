# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway report DIR`: a run or a sweep as one HTML page."""

import argparse
from pathlib import Path

from raceway.commands import Commands, one_run
from raceway.errors import RacewayError

DESCRIPTION = """\
Writes a run or a sweep as one HTML page to send to a colleague: figures with their errors, pictures
that can be zoomed and read off, warnings, settings, and the command that repeats the runs. The page
is one self-contained file."""
EXAMPLES = """\
examples:
  raceway report build/run/6208                   build/run/6208/report.html
  raceway report build/sweep/first --out first.html

Exit codes: 0 done, 1 the folder holds no finished run and no sweep, 2 wrong command line."""


def add(commands: Commands) -> None:
    """Add the command to the subparsers `commands`."""
    one = commands.add_parser(
        "report",
        help="a run or a sweep as one HTML page",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    one.add_argument("folder", metavar="DIR", help="folder of the run or of the sweep")
    one.add_argument("--out", metavar="HTML", help="where to put it (default: DIR/report.html)")
    one_run.add_number(one)
    one.set_defaults(command=run, complain=one.error)


def run(arguments: argparse.Namespace) -> None:
    """Write the page and print its path. Raises `RacewayError`."""
    from raceway.report import of_run, of_sweep  # matplotlib is slow to import

    folder = Path(arguments.folder)
    if any((folder / name).exists() for name in ("run.yaml", "record.nc")):
        page = of_run.page(one_run.tables(arguments))
    elif any(folder.glob("*/point.yaml")):
        if arguments.bearing is not None:
            arguments.complain(f"--bearing applies to a run, but {folder} holds a sweep")
        page = of_sweep.page(folder)
    else:
        raise RacewayError(f"{folder} holds no run (run.yaml) and no sweep (*/point.yaml)")
    print(page.write(arguments.out or folder / "report.html"))
