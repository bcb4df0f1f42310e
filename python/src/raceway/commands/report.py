# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway report DIR`: write a report on a run or a sweep as one HTML page."""

import argparse
from pathlib import Path

from raceway.commands import one_run
from raceway.errors import RacewayError

HELP = "write a report on a run or a sweep as one HTML page"
DESCRIPTION = """\
Writes a report on a run or a sweep as one HTML page that can be sent to a colleague. It contains
the results with their errors, plots that can be zoomed and that show values under the cursor,
warnings, settings, and the command that repeats the runs. The page is one self-contained file."""
EXAMPLES = """\
examples:
  raceway report build/run/6208                   build/run/6208/report.html
  raceway report build/sweep/first --out first.html

Exit codes: 0 done, 1 the folder has neither a finished run nor a sweep, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("folder", metavar="DIR", help="folder of the run or of the sweep")
    one.add_argument("--out", metavar="HTML", help="file to write (default: DIR/report.html)")
    one_run.add_number(one)


def run(arguments: argparse.Namespace) -> None:
    from raceway.report import of_run, of_sweep  # matplotlib is slow to import

    folder = Path(arguments.folder)
    if any((folder / name).exists() for name in ("run.yaml", "record.nc")):
        page = of_run.page(one_run.tables(arguments))
    elif any(folder.glob("*/point.yaml")):
        if arguments.bearing is not None:
            arguments.complain(f"--bearing applies to a run, but {folder} contains a sweep")
        page = of_sweep.page(folder)
    else:
        raise RacewayError(f"{folder} contains neither a run (run.yaml) nor a sweep (*/point.yaml)")
    print(page.write(arguments.out or folder / "report.html"))
