# SPDX-License-Identifier: GPL-2.0-or-later
"""Options DIR and --bearing, shared by the commands that read one run."""

import argparse
from typing import TYPE_CHECKING, Any

from raceway.commands import options
from raceway.commands.quantity import positive

if TYPE_CHECKING:  # pandas takes longer to load than `--help` should
    from raceway.runs.run import Run
    from raceway.runs.tables import RunTables


def add(to: Any) -> None:
    """Add the options DIR and --bearing."""
    options.run_folder(to)
    add_number(to)


def add_number(to: Any) -> None:
    """Add the option --bearing, the number of a bearing in the folder."""
    to.add_argument(
        "--bearing",
        type=positive,
        metavar="NUMBER",
        help="number of the bearing, if the folder contains several",
    )


def tables(arguments: argparse.Namespace) -> "RunTables":
    """Return the tables of the given run and bearing; raise `RunError` if they cannot be read."""
    from raceway.runs.tables import RunTables

    return RunTables(arguments.folder, bearing=arguments.bearing)


def opened(arguments: argparse.Namespace) -> "Run":
    """Return the given run and bearing as `raceway.open` does; raise `RunError` if this fails."""
    from raceway.runs.run import Run

    return Run(arguments.folder, bearing=arguments.bearing)
