# SPDX-License-Identifier: GPL-2.0-or-later
"""Options shared by the commands that read a recording of a real bearing."""

import argparse
from typing import TYPE_CHECKING, Any

from raceway.commands import options
from raceway.commands.quantity import number

if TYPE_CHECKING:  # scipy takes longer to load than `--help` should
    from raceway.recordings.recording import Recording


def add(to: Any, bearing: bool = True) -> None:
    """Add the options FILE, --rate, --rpm, --nominal, --channel and --band, and --bearing if
    `bearing` is true."""
    to.add_argument(
        "file",
        metavar="FILE",
        help=".mat (CWRU, MFPT, Paderborn, raceway dataset), .npz, .csv (FEMTO, or named columns)"
        " or .wav",
    )
    if bearing:
        options.bearing(to)
    to.add_argument(
        "--rate",
        type=number(1e-3, 1e8, "Hz"),
        metavar="HZ",
        help="sampling rate in hertz (default: from the file)",
    )
    speed = to.add_mutually_exclusive_group()
    speed.add_argument(
        "--rpm",
        type=number(1, 1e6, "rpm"),
        metavar="R",
        help="true speed of the inner ring in rpm (relative to an outer ring that also rotates)",
    )
    speed.add_argument(
        "--nominal",
        type=number(1, 1e6, "rpm"),
        metavar="R",
        help="nominal speed in rpm; the true speed must be within 1.5 %% of it (default: from the"
        " file)",
    )
    to.add_argument(
        "--channel", default="", metavar="NAME", help="channel of the file (default: the first)"
    )
    options.band(to)


def opened(arguments: argparse.Namespace) -> "Recording":
    """Return the given recording; raise `RacewayError` if it cannot be read."""
    from raceway import catalogue, inputs
    from raceway.recordings.recording import Recording

    path = catalogue.find("bearings", arguments.bearing, arguments.inputs)
    return Recording(
        arguments.file,
        inputs.bearing(path),
        rpm=arguments.rpm,
        nominal=arguments.nominal,
        rate=arguments.rate,
        nominal_angle=inputs.four_point_angle(path) or inputs.nominal_angle(path),
        name=path.name,
    )
