# SPDX-License-Identifier: GPL-2.0-or-later
"""Options shared by several commands. They are added to a parser or to an option group; argparse
has no public type for both."""

import argparse
import itertools
import math
import os
from collections.abc import Sequence
from typing import Any

from raceway.commands.quantity import number, positive
from raceway.theory.cleanliness import CLEANLINESS
from raceway.theory.models import DEFAULT

POINT = {  # {quantity of an operating point: (type, unit in the help, help)}
    "load": (number(0, 1e6, "N"), "N", "radial load, along x, newtons (0)"),
    "axial": (number(-1e6, 1e6, "N"), "N", "axial load, along z, newtons (0)"),
    "rpm": (number(0, 1e5, "rpm"), "R", "speed of the inner ring"),
    "clearance": (
        number(-1e-3, 1e-3, "m"),
        "M",
        "diametral clearance, metres; negative is preload (0)",
    ),
    "temperature": (
        number(-40, 200, "C"),
        "C",
        "temperature of the lubricant, degrees Celsius (from its file, or 40)",
    ),
}


def run_folder(to: Any) -> None:
    """DIR, the folder of a run."""
    to.add_argument("folder", metavar="DIR", help="folder the run wrote")


def deck(to: Any) -> None:
    """--deck and --program: the deck, and the program that runs it."""
    to.add_argument(
        "--deck",
        metavar="FILE",
        default="inputs/in.6208",
        help="deck to run (default: %(default)s)",
    )
    program(to)


def program(to: Any) -> None:
    """--program that runs a deck."""
    to.add_argument(
        "--program",
        metavar="COMMAND",
        default="build/liggghts",
        help="program that runs it, with its own options if any: 'mpirun -np 2 build/liggghts'"
        " (default: %(default)s)",
    )


def jobs(to: Any) -> None:
    """--jobs, number of runs at a time."""
    to.add_argument(
        "--jobs",
        metavar="N",
        type=positive,
        default=len(os.sched_getaffinity(0)),
        help="runs at a time (default: number of cores, %(default)s)",
    )


def variables(to: Any, what: str) -> None:
    """-var and --var; `what` names the variables that they set."""
    to.add_argument(
        "-var",
        "--var",
        nargs=2,
        action="append",
        default=[],
        metavar=("NAME", "VALUE"),
        help=f"{what}; may be repeated",
    )


def bearing(to: Any) -> None:
    """--bearing and --inputs: a bearing by name, and its search folder."""
    to.add_argument(
        "--bearing",
        default="6208",
        metavar="NAME",
        help="a name in inputs/bearings (raceway catalogue), or the path of a file (6208)",
    )
    inputs(to)


def grooves(to: Any) -> None:
    """--four-point and --double-row: several grooves per ring."""
    to.add_argument(
        "--four-point",
        type=number(5, 60, "degrees"),
        metavar="DEGREES",
        help="a four-point contact bearing: two grooves per ring, which centred balls touch at"
        " this angle (the bearing's four_point, or one groove)",
    )
    to.add_argument(
        "--double-row",
        type=number(0, 1, "m"),
        metavar="M",
        help="distance of two rows of balls, metres; loads act midway between them (one row)",
    )
    to.add_argument(
        "--arrangement",
        choices=("back_to_back", "face_to_face"),
        default="back_to_back",
        help="arrangement of the two rows (back_to_back)",
    )
    to.add_argument(
        "--preload",
        type=number(-1e-3, 1e-3, "m"),
        default=0.0,
        metavar="M",
        help="how far each row is pushed along the axis after first contact, metres (0)",
    )


def grooves_of(arguments: argparse.Namespace) -> dict[str, Any]:
    """Arguments of `inputs.bearing` from the options of `grooves`."""
    from raceway.theory.bearing import DoubleRow

    angle, spacing = arguments.four_point, arguments.double_row
    if spacing is None and (arguments.preload or arguments.arrangement != "back_to_back"):
        arguments.complain("--arrangement and --preload apply to two rows; give --double-row")
    rows = (spacing, arguments.preload, arguments.arrangement)
    return {
        "four_point": None if angle is None else math.radians(angle),
        "double_row": None if spacing is None else DoubleRow(*rows),
    }


def spin_law(to: Any) -> None:
    """--spin-law of the friction torque."""
    to.add_argument(
        "--spin-law",
        choices=("closed", "slices"),
        default="closed",
        help="law of spin in the friction torque: closed fits spin and slip separately, slices"
        " combines them",
    )


def lubrication(to: Any) -> None:
    """--lubrication and --oil-level of the friction torque."""
    kinds = ("bath", "jet", "mist", "grease", "minimal")
    to.add_argument(
        "--lubrication",
        choices=kinds,
        default="bath",
        help="kind of lubrication, for inlets, starvation and drag in the friction torque (bath)",
    )
    to.add_argument(
        "--oil-level",
        type=number(0, 100, "ball diameters"),
        default=0.5,
        metavar="H",
        help="level of an oil bath above the lowest raceway, in ball diameters (0.5)",
    )


def supply_of(arguments: argparse.Namespace) -> Any:
    """`oil_supply.Supply` from the options of `lubrication`."""
    from raceway.theory.oil_supply import Supply

    return Supply(arguments.lubrication, arguments.oil_level)


def cage(to: Any) -> None:
    """--cage and --cage-play of the losses at a cage."""
    to.add_argument(
        "--cage",
        choices=("chain", "ring"),
        default="chain",
        help="ring: the friction torque includes the oil in the pockets and the churning of a cage"
        " that is one ring (chain)",
    )
    to.add_argument(
        "--cage-play",
        type=number(1e-6, 0.1, "m"),
        metavar="M",
        help="with --cage ring: play of its pockets along the pitch circle, metres (estimated)",
    )


def cage_of(arguments: argparse.Namespace) -> Any:
    """`cage_drag.CageRing` from the options of `cage`; None for a chain, whose losses depend on its
    motion."""
    from raceway.theory.cage_drag import CageRing

    if arguments.cage != "ring":
        if arguments.cage_play is not None:
            arguments.complain("--cage-play applies to a cage ring: give --cage ring")
        return None
    return CageRing(play=arguments.cage_play or 0.0)


def models(to: Any, known: Sequence[str], said: str, default: str = DEFAULT) -> None:
    """--models, one of `known`; `said` describes them."""
    to.add_argument("--models", choices=known, default=default, help=f"{said} (default: {default})")


def lubricant(to: Any) -> None:
    """--lubricant of commands that always need one."""
    to.add_argument(
        "--lubricant",
        default="vg46",
        metavar="NAME",
        help="a file of inputs/lubricants, or a path (vg46)",
    )


def cleanliness(to: Any) -> None:
    """--cleanliness, of the lubricant."""
    to.add_argument(
        "--cleanliness",
        choices=CLEANLINESS,
        default="normal",
        metavar="WORD",
        help=f"cleanliness of the oil, for the rating life: {', '.join(CLEANLINESS)} (normal)",
    )


def inputs(to: Any) -> None:
    """--inputs: search folder of bearings and lubricants."""
    to.add_argument(
        "--inputs",
        metavar="DIR",
        help="the inputs folder (default: here or in a parent folder, else in the package)",
    )


def point(to: Any, name: str, said: str = "", kind: Any = None, several: bool = True) -> None:
    """The option --`name` of `POINT`, with one value or `several`; `said` and `kind` replace the
    option's help and type."""
    usual, unit, text = POINT[name]
    to.add_argument(
        f"--{name}",
        type=kind or usual,
        nargs="+" if several else None,
        metavar=unit,
        help=said or text,
    )


def points(arguments: argparse.Namespace) -> list[dict[str, float]]:
    """The operating points that the options of `point` request: every combination of the values of
    the given options."""
    given = {name: found for name in POINT if (found := getattr(arguments, name, None))}
    return [dict(zip(given, values)) for values in itertools.product(*given.values())]
