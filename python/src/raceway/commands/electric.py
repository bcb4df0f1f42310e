# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway electric`: compute the total capacitance, breakdown voltage and impedance of a bearing
without a simulation."""

import argparse
import csv
import math
import sys
from contextlib import redirect_stdout
from pathlib import Path

from raceway.commands import electric_run, options, output
from raceway.commands.quantity import each, number
from raceway.theory.models import CAPACITANCE

HELP = "compute total capacitance, breakdown voltage and impedance from theory"
DESCRIPTION = """\
With DIR, the results describe a run as a function of time and come from its record; the options for
an operating point do not apply. Without DIR, they describe an operating point and need no
simulation.

The total capacitance of a bearing is made up of the contact ellipses, the gap around them and the
unloaded balls. The command also prints the smallest voltage at which a film fails, the impedance,
and the bearing voltage ratio of a motor. Loads and films are computed in the same way as in
`raceway static`; docs/electric derives the formulas.

--load, --axial, --rpm, --clearance and --temperature accept several values; one line is printed for
each combination. --measured calculates the film thickness from a measured capacitance.

Pictures (--kind, with --out):
  parts    parts of the capacitance against the quantity with several values, or against time for a
           run
  field    field in the films around the ring, at --voltage
  bode     impedance against frequency, with --resistivity
  reading  film thickness that an instrument would read, and its error; not available for a run"""
EXAMPLES = """\
examples:
  raceway electric --load 3000 --rpm 1500
  raceway electric --load 400 --rpm 6000 --clearance 12e-6 --surroundings cavitated 1
  raceway electric --load 1000 --rpm 100 300 1000 3000 10000 --kind parts --out parts.png
  raceway electric --load 1000 --rpm 3000 --c-wr 50e-12 --c-rf 1e-9 --frequency 1e4 --json
  raceway electric --load 1000 --rpm 3000 --measured 250e-12
  raceway electric build/run/6208 --frequency 1e4 --resistivity 1e9
  raceway electric build/run/6208 --voltage 5 --kind field --out field.png
  raceway electric --load 1000 --rpm 3000 --csv reading.csv --kind reading --out reading.png

Bearings and lubricants are files in inputs/bearings and inputs/lubricants; a name with a slash is
the path of your own file in the same format.
Exit codes: 0 done, 1 no equilibrium or unusable data, 2 wrong command line."""
KINDS = ("parts", "field", "bode", "reading")
PHASES = 12  # number of ball positions within a ball spacing, for the picture of the field
KEYS = {  # {option: key of the results of `electric_point`}
    "load": "load_N",
    "axial": "axial_N",
    "rpm": "rpm",
    "clearance": "clearance_m",
    "temperature": "temperature_C",
}


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("folder", nargs="?", metavar="DIR", help="folder written by a run")
    _operating_point(one)
    _surroundings(one)
    _electrics(one)
    out = one.add_argument_group("output")
    out.add_argument("--kind", choices=KINDS, help="kind of picture to draw; needs --out")
    out.add_argument("--out", metavar="PNG", help="file for the picture; needs --kind")
    out.add_argument(
        "--csv", metavar="FILE", help="write a table of the points, or the curve of --kind reading"
    )
    output.option(out, "print JSON instead of tables")
    one.set_defaults(unset=one.get_default, ask=_ask, filling=_filling)


def _operating_point(one):
    point = one.add_argument_group("operating point")
    point.add_argument(
        "--bearing",
        metavar="NAME",
        help="a name listed by `raceway catalogue`, or the path of a file (default: 6208); for a"
        " run, the number of the bearing",
    )
    options.lubricant(point)
    options.inputs(point)
    for name in KEYS:
        options.point(point, name, kind=number(1e-3, 1e5, "rpm") if name == "rpm" else None)
    options.grooves(point)
    options.models(
        point,
        CAPACITANCE,
        "full: includes the film in the gap and inlet shear; paper: as in the paper",
    )


def _surroundings(one):
    around = one.add_argument_group("what fills the gaps")
    around.add_argument(
        "--surroundings",
        nargs="+",
        metavar=("KIND", "EPS_OUT"),
        help="flooded, dry, or cavitated EPS_OUT, where EPS_OUT is the relative permittivity of the"
        " outlet (default: flooded; for a run, as in the run)",
    )
    around.add_argument(
        "--shoulders",
        type=number(1e-4, 10, "m"),
        nargs=2,
        metavar=("D_INNER", "D_OUTER"),
        help="diameters of the shoulders in metres (default: from the bearing's file)",
    )
    around.add_argument(
        "--permittivity-at",
        choices=("maximum", "mean", "two_thirds"),
        help="pressure at which the permittivity of the film is evaluated: the maximum, the mean"
        " over the ellipse, or two thirds of the maximum (default: maximum; for a run, as in the"
        " run)",
    )
    around.add_argument(
        "--roughness",
        choices=("none", "gamma"),
        help="roughness in the capacitance of the films: none for smooth surfaces, gamma for a"
        " gamma-distributed film thickness (default: none)",
    )


def _electrics(one):
    electric = one.add_argument_group("voltage, frequency, motor")
    electric.add_argument(
        "--strength",
        type=number(1e5, 1e9, "V/m"),
        default=15e6,
        metavar="V/M",
        help="field at which a film fails (default: 15e6; 15e6 to 60e6 for smooth thin films,"
        " not verified)",
    )
    electric.add_argument(
        "--voltage",
        type=number(1e-6, 1e6, "V"),
        metavar="V",
        help="voltage between the rings; adds the fields in the films to the results",
    )
    electric.add_argument(
        "--frequency", type=number(1e-3, 1e10, "Hz"), metavar="HZ", help="add the impedance"
    )
    electric.add_argument(
        "--resistivity",
        type=number(1e3, 1e16, "ohm m"),
        default=math.inf,
        metavar="OHM_M",
        help="resistivity of the lubricant in ohm metres (default: infinite, i.e. no leakage)",
    )
    electric.add_argument(
        "--c-wr",
        type=number(0, 1e-3, "F"),
        metavar="F",
        help="capacitance from windings to rotor; needs --c-rf",
    )
    electric.add_argument(
        "--c-rf",
        type=number(0, 1e-3, "F"),
        metavar="F",
        help="capacitance from rotor to frame; adds the bearing voltage ratio",
    )
    electric.add_argument(
        "--measured",
        type=number(1e-15, 1e-3, "F"),
        metavar="F",
        help="measured capacitance of the bearing, from which the film thickness is computed",
    )
    electric.add_argument(
        "--measured-impedance",
        action=each(number(1e-3, 1e15, "ohm"), number(-90, 0, "degrees")),
        nargs=2,
        metavar=("OHM", "DEG"),
        help="measured modulus and phase (negative) of the impedance at --frequency, instead of"
        " --measured",
    )


def run(arguments: argparse.Namespace) -> None:
    if arguments.folder is not None:
        return electric_run.run(arguments)
    # loading scipy takes longer than printing --help
    from raceway.theory import electric_point, electric_table

    _check(arguments)
    ask = _ask(arguments)
    points = [_solve(arguments, values) for values in options.points(arguments)]
    try:
        results = [electric_point.figures(point, ask) for point in points]
    except ValueError as error:
        arguments.complain(str(error))
    output.show_each(arguments, results, electric_table.table, electric_table.curves)
    curve = _reading(arguments, points[0]) if arguments.kind == "reading" else None
    with redirect_stdout(sys.stderr if arguments.json else sys.stdout):
        if arguments.csv:
            _table(Path(arguments.csv), results, curve)
        if arguments.kind:
            _picture(arguments, points, results, curve)


def _check(arguments):
    complain = arguments.complain
    if arguments.rpm is None:
        complain("give --rpm: a film needs a speed")
    options.need_load(arguments)
    electric_run.check_pairs(arguments)
    several = _several(arguments)
    if arguments.kind == "parts" and len(several) != 1:
        complain("--kind parts needs several values of one quantity, for example --rpm 100 1000")
    if arguments.kind in ("field", "bode", "reading") and several:
        complain(f"--kind {arguments.kind} applies to a single operating point")
    if arguments.measured_impedance:
        if arguments.measured is not None or arguments.frequency is None:
            complain("--measured-impedance needs --frequency and excludes --measured")
        size, phase = arguments.measured_impedance
        if phase == 0:
            complain(f"--measured-impedance {size:g} 0: the phase of a capacitance is negative")


def _several(arguments):
    """Return the keys of the quantities that have several values."""
    return [key for name, key in KEYS.items() if len(getattr(arguments, name) or ()) > 1]


def _filling(arguments):
    from raceway.theory.capacitance_outside import FILLS
    from raceway.theory.capacitors import Filling
    from raceway.theory.validity import Shoulders

    kind, *rest = words = arguments.surroundings or ["flooded"]
    if kind not in FILLS or len(rest) != (kind == "cavitated"):
        arguments.complain(
            f"--surroundings {' '.join(words)}: give flooded, dry or cavitated EPS_OUT"
        )
    try:
        outlet = number(1, 100, "")(rest[0]) if rest else 1.0
    except argparse.ArgumentTypeError as error:
        arguments.complain(f"--surroundings cavitated: {error}")
    return Filling(
        kind,
        outlet,
        arguments.permittivity_at or "maximum",
        arguments.roughness or "none",
        Shoulders(*(arguments.shoulders or ())),
    )


def _ask(arguments):
    from raceway.theory import impedance
    from raceway.theory.electric_point import Ask

    measured = arguments.measured
    if arguments.measured_impedance:
        size, phase = arguments.measured_impedance
        z = complex(size * math.cos(math.radians(phase)), size * math.sin(math.radians(phase)))
        measured = float(impedance.capacitance_of(z, arguments.frequency))
    motor = None if arguments.c_wr is None else (arguments.c_wr, arguments.c_rf)
    return Ask(
        arguments.strength,
        arguments.voltage,
        arguments.frequency,
        arguments.resistivity,
        motor,
        measured,
    )


def _solve(arguments, values, phase=None):
    from raceway.theory import electric_point

    try:
        return electric_point.solve(
            "6208" if arguments.bearing is None else arguments.bearing,
            arguments.lubricant,
            arguments.inputs,
            models=arguments.models,
            filling=_filling(arguments),
            phase=phase,
            **options.grooves_of(arguments),
            **values,
        )
    except ValueError as error:
        arguments.complain(str(error))


def _reading(arguments, point):
    from raceway.theory import film_reading

    try:
        return film_reading.curve(point)
    except ValueError as error:
        arguments.complain(str(error))


def _table(path, results, curve):
    from raceway import files

    if curve is None:
        keys = [key for key, value in results[0].items() if not isinstance(value, list)]
        rows = [keys, *([one[key] for key in keys] for one in results)]
    else:
        names = ("h_c_m", "capacitance_F", "read_by_plates_m", "read_less_constant_m")
        rows = [names, *(map(float, row) for row in zip(*curve))]

    def write(part):
        with open(part, "w", newline="") as file:
            csv.writer(file).writerows(rows)

    print(files.whole(path, write))


def _picture(arguments, points, results, curve):
    from importlib import import_module  # loading matplotlib takes longer than solving a point

    module = {"parts": "capacitance_parts", "field": "film_field", "reading": "film_reading"}
    kind = arguments.kind
    draw = getattr(import_module(f"raceway.pictures.{module.get(kind, kind)}"), kind)
    out, names = arguments.out, points[0].names
    if kind == "parts":
        draw(results, *_several(arguments), out)
    elif kind == "field":
        turn = 2 * math.pi / points[0].bearing.balls
        (values,) = options.points(arguments)
        alike = [_solve(arguments, values, turn * step / PHASES) for step in range(PHASES)]
        draw(alike, names, arguments.voltage, out)
    elif kind == "bode":
        draw(points[0], names, arguments.resistivity, out)
    else:
        draw(curve, names, out)
    print(out)
