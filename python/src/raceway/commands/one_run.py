# SPDX-License-Identifier: GPL-2.0-or-later
"""DIR of the commands that read one run, and which of its bearings."""

import argparse
from typing import TYPE_CHECKING, Any

from raceway.commands import options
from raceway.commands.quantity import positive

if TYPE_CHECKING:  # pandas takes longer to load than `--help` should
    from raceway.runs.run import Run
    from raceway.runs.tables import RunTables


def add(to: Any) -> None:
    """DIR and --bearing."""
    options.run_folder(to)
    add_number(to)


def add_number(to: Any) -> None:
    """--bearing, the number of one of many."""
    to.add_argument(
        "--bearing", type=positive, metavar="NUMBER", help="one of many bearings in the folder"
    )


def tables(arguments: argparse.Namespace) -> "RunTables":
    """The tables of the run and bearing that were named. Raises `RunError`."""
    from raceway.runs.tables import RunTables

    return RunTables(arguments.folder, bearing=arguments.bearing)


def opened(arguments: argparse.Namespace) -> "Run":
    """The same as `raceway.open` gives it. Raises `RunError`."""
    from raceway.runs.run import Run

    return Run(arguments.folder, bearing=arguments.bearing)
