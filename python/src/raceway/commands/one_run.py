# SPDX-License-Identifier: GPL-2.0-or-later
"""Options DIR and --bearing of the commands that read one run."""

import argparse
from typing import TYPE_CHECKING, Any

from raceway.commands import options
from raceway.commands.quantity import positive

if TYPE_CHECKING:  # pandas takes longer to load than `--help` should
    from raceway.runs.run import Run
    from raceway.runs.tables import RunTables


def add(to: Any) -> None:
    """Add DIR and --bearing."""
    options.run_folder(to)
    add_number(to)


def add_number(to: Any) -> None:
    """Add --bearing, the number of one bearing."""
    to.add_argument(
        "--bearing", type=positive, metavar="NUMBER", help="one of many bearings in the folder"
    )


def tables(arguments: argparse.Namespace) -> "RunTables":
    """Tables of the given run and bearing. Raises `RunError`."""
    from raceway.runs.tables import RunTables

    return RunTables(arguments.folder, bearing=arguments.bearing)


def opened(arguments: argparse.Namespace) -> "Run":
    """The given run and bearing, as `raceway.open` returns them. Raises `RunError`."""
    from raceway.runs.run import Run

    return Run(arguments.folder, bearing=arguments.bearing)
