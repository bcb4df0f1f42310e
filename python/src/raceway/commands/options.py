# SPDX-License-Identifier: GPL-2.0-or-later
"""Options that several commands have: one text for each. They are added to a parser, or to a group
of its options, for which argparse has no public type."""

from typing import Any

from raceway.commands.quantity import number


def bearing(to: Any) -> None:
    """--bearing and --inputs: a bearing by name, and where to look for it."""
    to.add_argument(
        "--bearing",
        default="6208",
        metavar="NAME",
        help="a file of inputs/bearings, or a path (6208)",
    )
    to.add_argument(
        "--inputs",
        metavar="DIR",
        help="the inputs folder (default: here or above, else what comes with raceway)",
    )


def temperature(to: Any) -> None:
    """--temperature of the lubricant."""
    to.add_argument(
        "--temperature",
        type=number(-40, 200, "C"),
        metavar="C",
        help="of the lubricant, degrees Celsius (that of its file, 40)",
    )
