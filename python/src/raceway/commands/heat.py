# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway heat`: the steady temperature of a bearing, and its consequences."""

import argparse
import json
import sys

from raceway import files
from raceway.commands import Commands, options
from raceway.commands.program import program
from raceway.commands.quantity import number, takes_negative

HELP = "steady temperature, viscosity, clearance, film and friction torque from theory"
DESCRIPTION = """\
Finds the temperature at which cooling balances the heat of friction. Loads, film in the gap and
friction torque are computed as by `raceway static` at that temperature. The lubricant must
have physical data (vg32, vg46, vg68, vg100, pao8, grease110).

Cooling follows ISO 15312 unless --conductance is given. --nodes gives three conductances: inner
ring to ambient, outer ring to ambient, ring to balls. Each part then has its own temperature,
and the clearance follows from the temperatures of the parts.

--runs N takes the friction from at most N short runs of the main deck with the same models, one
after another, each at the temperature that follows from the previous one. The command stops early
when the temperature settles. The runs are in the folder of --out; an interrupted command continues
them."""
EXAMPLES = """\
examples:
  raceway heat --load 5000 --rpm 1910 --lubricant vg46
  raceway heat --load 1000 --rpm 9549 --lubricant vg32 --nodes 0.5 2 3 --clearance 20e-6
  raceway heat --load 1000 5000 --rpm 500 2000 8000       a line for each load and speed
  raceway heat --load 1000 --rpm 15000 --oil-flow 0.5L/min --oil-inlet 45
  raceway heat --load 5000 --rpm 9549 --runs 4 --out build/heat

Exit codes: 0 done, 1 no steady state or unusable data, 2 wrong command line."""


def add(commands: Commands) -> None:
    """Put the command into the parser's `commands`."""
    one = commands.add_parser(
        "heat",
        help=HELP,
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    takes_negative(one)
    options.bearing(one)
    options.grooves(one)
    options.spin_law(one)
    options.lubrication(one)
    options.cage(one)
    options.models(
        one,
        ("full", "eyring"),
        "eyring: Eyring's stress in the film instead of a constant coefficient",
    )
    options.lubricant(one)
    options.point(one, "load")
    options.point(one, "axial")
    options.point(one, "rpm", kind=number(1, 1e5, "rpm"))
    options.point(one, "clearance", "diametral, at ambient temperature, metres (0)")
    one.add_argument(
        "--ambient",
        type=number(-40, 150, "C"),
        default=20.0,
        metavar="C",
        help="ambient temperature, degrees Celsius (20)",
    )
    cooling = one.add_mutually_exclusive_group()
    cooling.add_argument(
        "--conductance",
        type=number(1e-3, 1e5, "W/K"),
        metavar="W/K",
        help="conductance from the bearing to its surroundings (ISO 15312)",
    )
    cooling.add_argument(
        "--nodes",
        type=number(0, 1e5, "W/K"),
        nargs=3,
        metavar=("SHAFT", "HOUSING", "CONTACT"),
        help="conductances in W/K for separate temperatures of rings and balls; HOUSING 0: by ISO"
        " 15312, CONTACT 0: by size and speed of the contacts",
    )
    one.add_argument(
        "--oil-flow",
        type=number(1e-12, 1e-2, "m^3/s"),
        default=0.0,
        metavar="FLOW",
        help="flow of oil that carries heat away, m^3/s at 40 C, or with its unit as 1L/min (none)",
    )
    one.add_argument(
        "--oil-inlet",
        type=number(-40, 150, "C"),
        metavar="C",
        help="temperature of the flowing oil at the inlet, degrees Celsius (ambient)",
    )
    one.add_argument(
        "--runs",
        type=_number_of_runs,
        metavar="N",
        help="friction from at most N runs, 1 to 50, instead of statics",
    )
    one.add_argument(
        "--passes", type=number(1, 1e6, "passes"), metavar="P", help="ball passes of a run (1)"
    )
    one.add_argument(
        "--out", metavar="DIR", help="with --runs: folder of the runs (default: build/heat)"
    )
    one.add_argument(
        "--program",
        metavar="COMMAND",
        help="with --runs: program that runs the deck (default: build/liggghts)",
    )
    one.add_argument(
        "--json", action="store_true", help="one JSON object, a list for several points"
    )
    one.set_defaults(command=run, complain=one.error)


def run(arguments: argparse.Namespace) -> None:
    """Print the figures. Raises `RacewayError`."""
    # loading scipy takes longer than printing --help
    from raceway.theory.steady_heat import curves, table

    points = options.points(arguments)
    if arguments.rpm is None:
        arguments.complain("give --rpm")
    if not all(point.get("load") or point.get("axial") for point in points):
        arguments.complain("a load is needed: give --load or --axial")
    given = [name for name in ("out", "program", "passes") if getattr(arguments, name) is not None]
    if given and arguments.runs is None:
        arguments.complain(f"--{given[0]} is for runs: give --runs")
    if arguments.oil_inlet is not None and not arguments.oil_flow:
        arguments.complain("--oil-inlet applies to flowing oil: give --oil-flow")
    results = [_figures(arguments, point) for point in points]
    if arguments.json:
        print(json.dumps(results if results[1:] else results[0], indent=2, allow_nan=False))
    else:
        print(curves(results) if results[1:] else table(results[0]))


def _figures(arguments, of):
    from raceway.theory.steady_heat import Case, Nodes, figures

    shaft, housing, contact = arguments.nodes or (None, None, None)
    point = dict(
        **of,
        ambient=arguments.ambient,
        conductance=arguments.conductance,
        nodes=arguments.nodes and Nodes(shaft, housing or None, contact or None),
        spin_law=arguments.spin_law,
        models=arguments.models,
        oil_flow=arguments.oil_flow,
        oil_inlet=arguments.oil_inlet,
        supply=options.supply_of(arguments),
        cage=options.cage_of(arguments),
        **options.grooves_of(arguments),
    )
    names = arguments.bearing, arguments.lubricant, arguments.inputs
    if arguments.runs is None:
        return figures(*names, **point)
    from raceway.sweeps.heat_runs import by_runs

    return by_runs(
        Case(*names, **point),
        files.folder(arguments.out or "build/heat"),
        [*program(arguments.program or "build/liggghts"), "-in", "inputs/in.6208"],
        runs=arguments.runs,
        more={"passes": f"{arguments.passes or 1:.10g}"},
        say=lambda line: print(line, file=sys.stderr, flush=True),
    )


def _number_of_runs(text):
    if text.isdecimal() and 1 <= int(text) <= 50:
        return int(text)
    raise argparse.ArgumentTypeError(f"{text!r} must be a whole number from 1 to 50")
