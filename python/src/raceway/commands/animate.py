# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway animate DIR`: the bearing in motion."""

import argparse
from pathlib import Path

from raceway.commands import Commands, one_run
from raceway.commands.quantity import number

DESCRIPTION = """\
Animate a run: rings, balls and cage from the front, cut in the middle plane so that the torus
grooves are visible; the most loaded ball in section; the loads around the ring. Balls are coloured
by load. Motions of ring and balls, clearance and overlaps are too small to be seen, so they are
enlarged by a factor, which the picture states. White dots rotate with their balls and with the
inner ring."""
EXAMPLES = """\
examples:
  raceway animate build/run/6208                                 build/run/6208/animation.gif
  raceway animate build/run/6208 --colour film --passes 1 --frames 40 --out film.gif
  raceway animate build/run/6208 --exaggerate 50 --out bearing.mp4    MP4 needs the program ffmpeg

Exit codes: 0 done, 1 the run is broken, lacks what is requested, or ffmpeg is missing,
2 wrong command line."""
COLOURS = ("load", "pressure", "film", "capacitance")


def add(commands: Commands) -> None:
    """Put the command into the parser's `commands`."""
    one = commands.add_parser(
        "animate",
        help="a GIF or MP4 of the bearing in motion",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    one_run.add(one)
    one.add_argument(
        "--colour",
        choices=COLOURS,
        default="load",
        help="quantity shown by the colour of the balls (default: %(default)s)",
    )
    one.add_argument(
        "--passes",
        type=number(0.001, 1e6, "ball passes"),
        metavar="P",
        help="ball passes to show (default: all recorded ones, at most 4)",
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
        help="factor applied to small motions (default: depends on their size)",
    )
    one.add_argument(
        "--width",
        type=_whole(200, 4000),
        default=800,
        metavar="PX",
        help="approximate width (default: %(default)s)",
    )
    one.add_argument("--out", metavar="FILE", help="a .gif or .mp4 (default: DIR/animation.gif)")
    one.set_defaults(command=run)


def run(arguments: argparse.Namespace) -> None:
    """Write the animation and print its path."""
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
