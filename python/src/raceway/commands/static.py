# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway static`: compute loads, displacements, film and capacitance of a bearing without a
simulation."""

import argparse
import math
from functools import partial

from raceway.commands import options, output
from raceway.commands.quantity import number, variable
from raceway.theory import models

HELP = "compute loads, tilt, film and capacitance from theory, without a simulation"
DESCRIPTION = """\
Computes the quasi-static equilibrium of a ball bearing in five degrees of freedom (Jones, Harris):
radial and axial load and two moments on the inner ring, free contact angles, and the centrifugal
load of the balls. If a lubricant and a speed are given, the results also include the film
thickness (Masjedi-Khonsari) and capacitance of every contact and the parts of the friction torque,
which is compared with manufacturers' formulas. The balls roll without slip, except under pure
thrust, where friction determines their motion. --models paper uses the laws of the paper, which do
not yield a friction torque.

x points along the radial load and z along the bearing axis. As in a deck, the ring is held along z
unless it has an axial load: at 0, or where the balls touch both raceways at their contact angle. It
is held untilted unless --moment frees its tilts or --tilt prescribes them. The first ball is at the
azimuth --phase, measured from the load line."""
EXAMPLES = """\
examples:
  raceway static --load 5000 --clearance 10e-6
  raceway static --load 2000 --axial 1000 --moment 10 0 --rpm 477.5 --lubricant mineral
  raceway static --load 5000 --tilt 0 20arcmin --json
  raceway static --load 5000 --rpm 1910 --lubricant vg46 --temperature 70
  raceway static --load 500 5000 --rpm 500 1500 4500 --lubricant vg46     a line for each point
  raceway static --load 2000 --rpm 477.5 --lubricant mineral --models paper
  raceway static --load 5kN --rpm 1500 --bearing 6208 --C 32.5kN
  raceway static --spectrum duties.csv --C 32.5kN
  raceway static --spectrum build/sweep/duties/results.csv
  raceway static --axial 1000 --four-point 35 --clearance 20e-6
  raceway static --bearing 7208 --load 1000 --double-row 18e-3 --preload 5e-6 --moment 10 0
  raceway static --bearing my/bearing --axial 500 --hold x=0 --hold y=0

Bearings and lubricants are files in inputs/bearings and inputs/lubricants; a name with a slash is
the path of your own file in the same format.
Exit codes: 0 done, 1 no equilibrium or unusable data, 2 wrong command line."""
HOLD = {
    "x": number(-1e-2, 1e-2, "m"),
    "y": number(-1e-2, 1e-2, "m"),
    "z": number(-1e-2, 1e-2, "m"),
    "rx": number(-0.2, 0.2, "rad"),
    "ry": number(-0.2, 0.2, "rad"),
}


def add(one: argparse.ArgumentParser) -> None:
    options.bearing(one)
    loads = one.add_argument_group("loads on the inner ring")
    options.point(loads, "load")
    options.point(
        loads, "axial", "axial load along z in newtons; 0 holds the ring along z (default: 0)"
    )
    loads.add_argument(
        "--spectrum",
        metavar="FILE",
        help="instead of loads: CSV table with the columns load, axial, rpm and share (fraction of"
        " the time), or results.csv of a sweep; computes life and equivalent load of all its points"
        " together",
    )
    loads.add_argument(
        "--moment",
        type=variable("moment_x"),
        nargs=2,
        metavar=("MX", "MY"),
        help="moments about x and y in newton metres; frees the tilts, even if they are 0 0",
    )
    ring = one.add_argument_group("the ring")
    options.point(ring, "clearance")
    options.grooves(ring)
    ring.add_argument(
        "--tilt",
        type=number(-0.2, 0.2, "rad"),
        nargs=2,
        metavar=("RX", "RY"),
        help="hold the ring at these tilts about x and y, in rad or with a unit (20arcmin, 0.3deg,"
        " 5mrad)",
    )
    ring.add_argument(
        "--hold",
        type=_hold,
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="hold a degree of freedom: x, y or z in metres, rx or ry with the units of --tilt; may"
        " be repeated",
    )
    ring.add_argument(
        "--exact-circle",
        action="store_true",
        help=(
            "shift and tilt the groove as a rigid circle, as a simulation does (default: use only"
            " the components in the plane of each ball, as in Jones and Harris)"
        ),
    )
    balls = one.add_argument_group("balls, speed, film")
    balls.add_argument(
        "--phase",
        type=number(-2 * math.pi, 2 * math.pi, "rad"),
        default=0.0,
        metavar="ANGLE",
        help="azimuth of the first ball measured from the load line, in rad or with a unit (20deg)"
        " (default: 0)",
    )
    options.point(
        balls,
        "rpm",
        "speed of the inner ring in rpm, which causes the centrifugal load of the balls"
        " (default: 0)",
    )
    balls.add_argument(
        "--density",
        type=variable("ball_density"),
        metavar="RHO",
        help="density of the balls in kg/m^3 (default: ball_density in the bearing's file, or"
        " 7800)",
    )
    balls.add_argument(
        "--lubricant", metavar="NAME", help="a file in inputs/lubricants, or a path; needs --rpm"
    )
    options.point(balls, "temperature")
    options.models(
        one,
        models.STATICS,
        "full: includes the film in the gap, inlet shear and friction torque; eyring: full with the"
        " Eyring stress in the film; paper: as in the paper, without friction torque",
    )
    options.spin_law(one)
    options.lubrication(one)
    options.cage(one)
    one.add_argument(
        "--C",
        type=number(1, 1e8, "N"),
        metavar="N",
        dest="dynamic",
        help="dynamic load rating of one row in newtons, for the rating life (default: from the"
        " bearing's file)",
    )
    options.cleanliness(one)
    output.option(one, output.POINTS)


def run(arguments: argparse.Namespace) -> None:
    # loading scipy takes longer than printing --help
    from raceway.theory import load_spectrum
    from raceway.theory.operating_point import figures
    from raceway.theory.operating_table import curves, table

    points, spectrum = options.points(arguments), arguments.spectrum is not None
    for name in ("load", "axial", "rpm"):
        if spectrum and name in points[0]:
            arguments.complain(f"--{name}: the table of --spectrum has loads and speeds")
    if spectrum and points[1:]:
        arguments.complain("--spectrum: give one value of --clearance and of --temperature")
    if arguments.moment and arguments.tilt:
        arguments.complain(
            "--moment and --tilt: a tilt is either free under a moment or held; give one of them,"
            " or --hold"
        )
    speeds = spectrum or all(point.get("rpm") for point in points)
    if arguments.lubricant not in (None, "dry") and not speeds:
        arguments.complain("--lubricant: a film needs a speed; give --rpm")
    if arguments.spin_law != "closed" and arguments.models == models.PAPER:
        arguments.complain("--spin-law applies only to the friction torque; give --models full")
    dry = arguments.lubricant in (None, "dry")
    if arguments.cage == "ring" and (dry or arguments.models == models.PAPER):
        arguments.complain(
            "--cage applies to the friction torque of oil; give --lubricant and --models full"
        )
    if arguments.temperature is not None and dry:
        arguments.complain("--temperature applies to the lubricant; give --lubricant")
    names = [name for name, _ in arguments.hold]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        arguments.complain(f"--hold: {twice[0]} is given twice")
    held = {} if arguments.moment else dict(zip(("rx", "ry"), arguments.tilt or (0.0, 0.0)))
    held.update(arguments.hold)
    evaluate = partial(
        figures,
        arguments.bearing,
        arguments.lubricant,
        arguments.inputs,
        moment=arguments.moment or (0.0, 0.0),
        held=held,
        phase=arguments.phase,
        density=arguments.density,
        exact_circle=arguments.exact_circle,
        models=arguments.models,
        spin_law=arguments.spin_law,
        cleanliness=arguments.cleanliness,
        dynamic=arguments.dynamic,
        supply=options.supply_of(arguments),
        cage=options.cage_of(arguments),
        **options.grooves_of(arguments),
    )
    if not spectrum:
        results = [evaluate(**point) for point in points]
        result = results if results[1:] else results[0]
        table = curves if results[1:] else table
    else:
        duties, runs = load_spectrum.read(arguments.spectrum)
        result = (
            load_spectrum.of_sweep(duties, runs, arguments.dynamic)
            if runs
            else load_spectrum.of_points(
                duties,
                lambda duty: evaluate(**points[0], load=duty.load, axial=duty.axial, rpm=duty.rpm),
            )
        )
        table = load_spectrum.table
    output.show(arguments, result, table)


def _hold(text):
    name, equals, value = text.partition("=")
    if not equals or name not in HOLD:
        raise argparse.ArgumentTypeError(
            f"'{text}' is not NAME=VALUE with NAME one of {', '.join(HOLD)}"
        )
    return name, HOLD[name](value)
