# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway electric DIR`: compute the electrical quantities of a run from its record."""

import argparse
import math
import sys
from contextlib import redirect_stdout
from pathlib import Path

from raceway.commands import output

STATIC = (  # options that apply only to an operating point
    "load", "axial", "rpm", "clearance", "temperature", "models", "lubricant", "inputs",
    "measured", "measured_impedance",
)  # fmt: skip


def run(arguments: argparse.Namespace) -> None:
    """Print the results of the run `arguments.folder` and write the picture and the table.

    Raise `RacewayError` if the run cannot be used.
    """
    import raceway
    from raceway.runs import film_figures, film_table, whole_capacitance

    _check(arguments)
    of = raceway.open(arguments.folder)
    if arguments.bearing is not None:
        of = of.select(_number(arguments))
    ask = arguments.ask(arguments)
    try:  # ValueError if shoulders are outside the groove
        whole = whole_capacitance.over_time(of, _filling(arguments, of))
    except ValueError as error:
        arguments.complain(str(error))
    data = film_figures.over_time(of, whole, ask)
    fields = whole_capacitance.fields(of, whole, ask.voltage or 1.0, ask.strength)
    found = film_table.figures(of, data, fields, ask.frequency)
    output.show(arguments, found, film_table.table)
    with redirect_stdout(sys.stderr if arguments.json else sys.stdout):
        if arguments.csv:
            print(_table(data, Path(arguments.csv)))
        if arguments.kind:
            _picture(arguments, of, whole, data, fields)


def _check(arguments):
    complain = arguments.complain
    for name in STATIC:
        if getattr(arguments, name) != arguments.unset(name):
            option = f"--{name.replace('_', '-')}"
            complain(f"{option} is part of the run; leave out this option or DIR")
    check_pairs(arguments)
    if arguments.kind == "reading":
        complain("--kind reading applies to an operating point, not to a run")


def check_pairs(arguments: argparse.Namespace) -> None:
    """Check the options that are needed together, for a run or an operating point."""
    complain = arguments.complain
    if (arguments.c_wr is None) != (arguments.c_rf is None):
        complain("--c-wr and --c-rf must be given together")
    if (arguments.kind is None) != (arguments.out is None):
        complain("--kind and --out must be given together")
    if arguments.kind == "field" and arguments.voltage is None:
        complain("--kind field: give --voltage")
    if arguments.kind == "bode" and math.isinf(arguments.resistivity):
        complain("--kind bode: give --resistivity")


def _number(arguments):
    try:
        return int(arguments.bearing)
    except ValueError:
        arguments.complain(f"--bearing is {arguments.bearing}, must be a number for a run")


def _filling(arguments, of):
    """Return the filling of the gaps in the run with the requested changes, or None if there are
    none."""
    from raceway.runs import whole_capacitance

    names = ("surroundings", "shoulders", "permittivity_at", "roughness")
    if all(getattr(arguments, name) is None for name in names):
        return None
    own, given = whole_capacitance.filling_of(of), arguments.filling(arguments)
    if arguments.surroundings is not None:
        own = own._replace(kind=given.kind, outlet=given.outlet)
    for name in names[1:]:
        if getattr(arguments, name) is not None:
            own = own._replace(**{name: getattr(given, name)})
    return own


def _table(data, path):
    from raceway import files

    return files.whole(path, lambda part: data.to_dataframe().to_csv(part))


def _picture(arguments, of, whole, data, fields):
    from raceway.pictures import electric_run  # loading matplotlib takes longer than the rest

    if arguments.kind == "parts":
        electric_run.parts(of, data, arguments.out)
    elif arguments.kind == "field":
        electric_run.field(of, fields, arguments.voltage, arguments.out)
    else:
        electric_run.bode(of, whole, arguments.resistivity, arguments.out)
    print(arguments.out)
