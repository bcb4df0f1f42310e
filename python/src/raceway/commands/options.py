# SPDX-License-Identifier: GPL-2.0-or-later
"""Options shared by several commands.

They can be added to a parser or to an option group. argparse has no public type that covers both.
"""

import argparse
import itertools
import math
import os
from collections.abc import Sequence
from typing import Any

from raceway import core
from raceway.commands.quantity import number, positive, variable
from raceway.theory.cleanliness import CLEANLINESS
from raceway.theory.models import DEFAULT

POINT = {  # {quantity of an operating point: (type, unit in the help, help)}
    "load": (number(0, 1e6, "N"), "N", "radial load along x, in newtons (default: 0)"),
    "axial": (variable("axial"), "N", "axial load along z, in newtons (default: 0)"),
    "rpm": (number(0, 1e5, "rpm"), "R", "speed of the inner ring in rpm"),
    "clearance": (
        variable("clearance"),
        "M",
        "diametral clearance in metres; a negative value is a preload (default: 0)",
    ),
    "temperature": (
        variable("temperature"),
        "C",
        "temperature of the lubricant in degrees Celsius (default: from its file, or 40)",
    ),
}


def run_folder(to: Any) -> None:
    """Add DIR, the folder of a run."""
    to.add_argument("folder", metavar="DIR", help="folder written by the run")


def deck(to: Any) -> None:
    """Add --deck and --program: the deck and the program that runs it."""
    to.add_argument(
        "--deck",
        metavar="FILE",
        default="inputs/in.6208",
        help="deck to run (default: %(default)s)",
    )
    program(to)


def program(to: Any) -> None:
    """Add --program, the program that runs a deck."""
    to.add_argument(
        "--program",
        metavar="COMMAND",
        default="build/liggghts",
        help="program that runs the deck, with its own options if any, for instance"
        " 'mpirun -np 2 build/liggghts' (default: %(default)s)",
    )


def jobs(to: Any) -> None:
    """Add --jobs, the number of concurrent runs."""
    to.add_argument(
        "--jobs",
        metavar="N",
        type=positive,
        default=len(os.sched_getaffinity(0)),
        help="number of concurrent runs (default: number of cores, %(default)s)",
    )


def variables(to: Any, what: str) -> None:
    """Add -var and --var; `what` describes the variables that they set."""
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
    """Add --bearing and --inputs: the name of a bearing, and the folder to search for it."""
    to.add_argument(
        "--bearing",
        default="6208",
        metavar="NAME",
        help="a name listed by `raceway catalogue`, or the path of a file (default: 6208)",
    )
    inputs(to)


def grooves(to: Any) -> None:
    """Add --four-point, --double-row, --arrangement and --preload for several grooves per ring."""
    to.add_argument(
        "--four-point",
        type=variable("four_point"),
        metavar="DEGREES",
        help="a four-point contact bearing with two grooves per ring, which centred balls touch at"
        " this angle (default: four_point in the bearing's file, or one groove)",
    )
    to.add_argument(
        "--double-row",
        type=number(0, 1, "m"),
        metavar="M",
        help="distance between two rows of balls in metres; loads act midway between them"
        " (default: one row)",
    )
    to.add_argument(
        "--arrangement",
        choices=("back_to_back", "face_to_face"),
        default="back_to_back",
        help="arrangement of the two rows (default: back_to_back)",
    )
    to.add_argument(
        "--preload",
        type=number(-1e-3, 1e-3, "m"),
        default=0.0,
        metavar="M",
        help="axial displacement of each row beyond first contact, in metres (default: 0)",
    )


def grooves_of(arguments: argparse.Namespace) -> dict[str, Any]:
    """Return the arguments of `inputs.bearing` that the options of `grooves` give."""
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
    """Add --spin-law, the law of spin in the friction torque."""
    to.add_argument(
        "--spin-law",
        choices=("closed", "slices"),
        default="closed",
        help="law of spin in the friction torque: closed treats spin and slip separately, slices"
        " combines them (default: closed)",
    )


def lubrication(to: Any) -> None:
    """Add --lubrication and --oil-level, which affect the friction torque."""
    kinds = ("bath", "jet", "mist", "grease", "minimal")
    to.add_argument(
        "--lubrication",
        choices=kinds,
        default="bath",
        help="kind of lubrication, which determines inlets, starvation and drag in the friction"
        " torque (default: bath)",
    )
    to.add_argument(
        "--oil-level",
        type=number(0, 100, "ball diameters"),
        default=0.5,
        metavar="H",
        help="level of an oil bath above the lowest raceway, in ball diameters (default: 0.5)",
    )


def supply_of(arguments: argparse.Namespace) -> Any:
    """Return the `oil_supply.Supply` that the options of `lubrication` describe."""
    from raceway.theory.oil_supply import Supply

    return Supply(arguments.lubrication, arguments.oil_level)


def cage(to: Any) -> None:
    """Add --cage and --cage-play, which determine the losses at the cage."""
    to.add_argument(
        "--cage",
        choices=("auto", "ring", "chain"),
        default="auto",
        help="ring: the friction torque includes the oil in the pockets and the churning of a cage"
        " that is a single ring; auto: ring with a lubricant and --models full (default: auto)",
    )
    to.add_argument(
        "--cage-play",
        type=variable("cage_play"),
        metavar="M",
        help="play of the pockets of a cage ring along the pitch circle in metres (default:"
        " estimated)",
    )


def cage_of(arguments: argparse.Namespace) -> Any:
    """Return the `cage_drag.CageRing` that the options of `cage` describe, or None for a chain,
    whose losses depend on its motion."""
    from raceway.theory.cage_drag import CageRing

    kind = arguments.cage
    if kind == "auto":
        kind = core.usual_cage(arguments.models, "implicit", arguments.lubricant or "dry")
    if kind == "chain":
        if arguments.cage_play is not None:
            arguments.complain("--cage-play applies to a cage ring: give --cage ring")
        return None
    return CageRing(play=arguments.cage_play or 0.0)


def models(to: Any, known: Sequence[str], said: str, default: str = DEFAULT) -> None:
    """Add --models, which must be one of `known`; `said` describes them."""
    to.add_argument("--models", choices=known, default=default, help=f"{said} (default: {default})")


def lubricant(to: Any) -> None:
    """Add --lubricant, for commands that always need a lubricant."""
    to.add_argument(
        "--lubricant",
        default="vg46",
        metavar="NAME",
        help="a file in inputs/lubricants, or a path (default: vg46)",
    )


def cleanliness(to: Any) -> None:
    """Add --cleanliness, the cleanliness of the lubricant."""
    to.add_argument(
        "--cleanliness",
        choices=CLEANLINESS,
        default="normal",
        metavar="WORD",
        help="cleanliness of the oil, which affects the rating life:"
        f" {', '.join(CLEANLINESS)} (default: normal)",
    )


def band(to: Any) -> None:
    """Add --band, the frequency range of an envelope."""
    to.add_argument(
        "--band",
        type=number(1e-3, 1e8, "Hz"),
        nargs=2,
        metavar=("LOW", "HIGH"),
        help="band of the envelope in hertz (default: the most impulsive band)",
    )


def inputs(to: Any) -> None:
    """Add --inputs, the folder in which bearings and lubricants are searched for."""
    to.add_argument(
        "--inputs",
        metavar="DIR",
        help="the inputs folder (default: search this folder and its parents, then the package)",
    )


def point(to: Any, name: str, said: str = "", kind: Any = None, several: bool = True) -> None:
    """Add the option --`name` of `POINT` with one value, or any number if `several` is true.

    `said` and `kind` replace the help text and the type given in `POINT`.
    """
    usual, unit, text = POINT[name]
    to.add_argument(
        f"--{name}",
        type=kind or usual,
        nargs="+" if several else None,
        metavar=unit,
        help=said or text,
    )


def need_load(arguments: argparse.Namespace) -> None:
    """Complain unless a load or a preload determines the position of the ring at every point."""
    for one in points(arguments):
        preloaded = one.get("clearance", 0.0) < 0 or arguments.preload > 0
        if not (one.get("load") or one.get("axial") or preloaded):
            arguments.complain(
                "a load or a preload is needed: give --load, --axial, a negative --clearance, or"
                " --double-row with --preload"
            )


def points(arguments: argparse.Namespace) -> list[dict[str, float]]:
    """Return the operating points that the options of `point` request, i.e. all combinations of the
    given values."""
    given = {name: found for name in POINT if (found := getattr(arguments, name, None))}
    return [dict(zip(given, values)) for values in itertools.product(*given.values())]
