# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway animate DIR`: animate the bearing of a run."""

import argparse
from pathlib import Path

from raceway.commands import one_run
from raceway.commands.quantity import number

HELP = "animate a run as a GIF or MP4"
DESCRIPTION = """\
Animates a run. The pictures show the rings, balls and cage from the front, cut in the middle plane
so that the torus grooves are visible, the most heavily loaded ball in section, and the loads around
the ring. Balls are coloured by load. The motions of ring and balls, the clearance and the overlaps
are too small to be visible, so they are enlarged by a factor, which is shown in the picture. White
dots rotate with the balls and with the inner ring."""
EXAMPLES = """\
examples:
  raceway animate build/run/6208                                 build/run/6208/animation.gif
  raceway animate build/run/6208 --colour film --passes 1 --frames 40 --out film.gif
  raceway animate build/run/6208 --exaggerate 50 --out bearing.mp4    MP4 needs the program ffmpeg

Exit codes: 0 done, 1 the run is broken or lacks the requested data, or ffmpeg is missing,
2 wrong command line."""
COLOURS = ("load", "pressure", "film", "capacitance")


def add(one: argparse.ArgumentParser) -> None:
    one_run.add(one)
    one.add_argument(
        "--colour",
        choices=COLOURS,
        default="load",
        help="quantity by which the balls are coloured (default: %(default)s)",
    )
    one.add_argument(
        "--passes",
        type=number(0.001, 1e6, "ball passes"),
        metavar="P",
        help="number of ball passes to show (default: all that were recorded, at most 4)",
    )
    one.add_argument(
        "--frames",
        type=_whole(1, 2000),
        default=80,
        metavar="N",
        help="total number of frames (default: %(default)s)",
    )
    one.add_argument(
        "--rate",
        type=number(1, 60, "pictures a second"),
        default=20,
        metavar="R",
        help="frames per second (default: %(default)s)",
    )
    one.add_argument(
        "--exaggerate",
        type=number(1, 1e6, ""),
        metavar="X",
        help="factor by which small motions are enlarged (default: chosen by their size)",
    )
    one.add_argument(
        "--width",
        type=_whole(200, 4000),
        default=800,
        metavar="PX",
        help="approximate width in pixels (default: %(default)s)",
    )
    one.add_argument(
        "--out", metavar="FILE", help="a .gif or .mp4 file (default: DIR/animation.gif)"
    )


def run(arguments: argparse.Namespace) -> None:
    # loading matplotlib takes longer than printing --help
    from raceway.pictures.animation import animation

    out = Path(arguments.out or Path(arguments.folder) / "animation.gif")
    print(
        animation(
            one_run.tables(arguments),
            out,
            arguments.colour,
            arguments.passes,
            arguments.frames,
            arguments.rate,
            arguments.exaggerate,
            arguments.width,
        )
    )


def _whole(low, high):
    convert = number(low, high, "")

    def whole(text):
        value = convert(text)
        if value != int(value):
            raise argparse.ArgumentTypeError(f"{text} is not a whole number")
        return int(value)

    return whole
