# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway plot DIR`: draw a picture of a run."""

import argparse
from pathlib import Path

from raceway.commands import one_run

KINDS = ("overview", "polar", "waterfall", "bearing", "motion", "warming")
HELP = "draw a picture of a run"
DESCRIPTION = """\
Draws a picture of a run as a PNG file:
  overview   loads, film, friction torque and capacitance on one page
  polar      load and film around the ring, with quasi-static theory as dots
  waterfall  capacitance of every ball as a function of azimuth and time
  bearing    rings, balls and cage at the time of the largest load
             (`raceway animate` shows them in motion)
  motion     orbit, displacement and tilt of the inner ring (of the outer ring if only that moves),
             the moment that opposes the spin, force on the cage; orbit and pockets of a cage ring
  warming    temperatures, losses and clearance against thermal time, for fix bearing/heat"""
EXAMPLES = """\
examples:
  raceway plot build/run/6208                            build/run/6208/overview.png
  raceway plot build/run/6208 --kind waterfall --out waterfall.png

Exit codes: 0 done, 1 the run is broken or lacks the data for the picture, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one_run.add(one)
    one.add_argument(
        "--kind", choices=KINDS, default="overview", help="what to draw (default: %(default)s)"
    )
    one.add_argument("--out", metavar="PNG", help="file to write (default: DIR/KIND.png)")


def run(arguments: argparse.Namespace) -> None:
    from importlib import import_module  # loading matplotlib takes longer than printing --help

    draw = getattr(import_module(f"raceway.pictures.{arguments.kind}"), arguments.kind)
    out = Path(arguments.out or Path(arguments.folder) / f"{arguments.kind}.png")
    draw(one_run.tables(arguments), out)
    print(out)
