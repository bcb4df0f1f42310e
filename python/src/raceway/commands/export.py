# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway export DIR --format vtk|xyz`: a run for ParaView or OVITO."""

import argparse
from pathlib import Path

from raceway.commands import Commands

DESCRIPTION = """\
Write a run as files that other programs open as they are:
  vtk   for ParaView: bearing.pvd, a time series of the balls (points with radius, velocity, spin,
        load, film, capacitance) and of the raceway tori (surfaces)
  xyz   for OVITO: bearing.xyz (extended XYZ, the same columns), inner_raceway.obj,
        outer_raceway.obj
Real positions, nothing exaggerated; SI units."""
EXAMPLES = """\
examples:
  raceway export build/run/6208 --format vtk              build/run/6208/vtk/bearing.pvd
  raceway export build/run/6208 --format xyz --every 1 --out for_ovito

In ParaView: open bearing.pvd, Apply; Glyph of type Sphere, Scale Array radius, Scale Factor 2,
shows the balls.
Exit codes: 0 done, 1 the run is broken or the folder cannot be written, 2 wrong command line."""


def add(commands: Commands) -> None:
    """Put the command into the parser's `commands`."""
    one = commands.add_parser(
        "export",
        help="files for ParaView and OVITO",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    one.add_argument("folder", metavar="DIR", help="folder the run wrote")
    one.add_argument(
        "--format", choices=("vtk", "xyz"), required=True, help="vtk for ParaView, xyz for OVITO"
    )
    one.add_argument(
        "--every",
        type=_every,
        metavar="N",
        help="every Nth sample (default: so that at most 200 are left)",
    )
    one.add_argument("--out", metavar="DIR", help="folder to write into (default: DIR/FORMAT)")
    one.set_defaults(command=run)


def run(arguments: argparse.Namespace) -> None:
    """Write the files and print the one to open."""
    from raceway.export import ovito, paraview
    from raceway.runs.tables import RunTables

    write = {"vtk": paraview.write, "xyz": ovito.write}[arguments.format]
    print(
        write(
            RunTables(arguments.folder),
            arguments.out or Path(arguments.folder) / arguments.format,
            arguments.every,
        )
    )


def _every(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


_every.__name__ = "whole number from 1"  # what argparse calls it in its error
