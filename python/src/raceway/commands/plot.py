# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway plot DIR`: a picture of a run."""

import argparse
from pathlib import Path

from raceway.commands import Commands, one_run

KINDS = ("overview", "polar", "waterfall", "bearing", "motion", "warming")
DESCRIPTION = """\
Draw a run to a PNG:
  overview   loads, film, pressure and capacitance on one page
  polar      load and film around the ring, with quasi-static theory as dots
  waterfall  capacitance of every ball over azimuth and time
  bearing    rings, balls and cage at the moment of the largest load
             (`raceway animate` moves them)
  motion     orbit of the inner ring, its displacement, tilt and the moment against its spin;
             force on the cage, orbit and pockets of a cage ring
  warming    temperatures, losses and clearance over thermal time, with fix bearing/heat"""
EXAMPLES = """\
examples:
  raceway plot build/run/6208                            build/run/6208/overview.png
  raceway plot build/run/6208 --kind waterfall --out waterfall.png

Exit codes: 0 done, 1 the run is broken or lacks the data for the picture, 2 wrong command line."""


def add(commands: Commands) -> None:
    """Add the command to the subparsers `commands`."""
    one = commands.add_parser(
        "plot",
        help="a picture of a run",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    one_run.add(one)
    one.add_argument(
        "--kind", choices=KINDS, default="overview", help="what to draw (default: %(default)s)"
    )
    one.add_argument("--out", metavar="PNG", help="where to put it (default: DIR/KIND.png)")
    one.set_defaults(command=run)


def run(arguments: argparse.Namespace) -> None:
    """Draw the picture and print its path."""
    from importlib import import_module  # matplotlib takes longer to load than a summary to compute

    draw = getattr(import_module(f"raceway.pictures.{arguments.kind}"), arguments.kind)
    out = Path(arguments.out or Path(arguments.folder) / f"{arguments.kind}.png")
    draw(one_run.tables(arguments), out)
    print(out)
