# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway export DIR --format vtk|xyz|spice`: export a run to ParaView, OVITO or SPICE."""

import argparse
from pathlib import Path

from raceway.commands import one_run
from raceway.commands.quantity import number, positive
from raceway.errors import RacewayError

HELP = "write files for ParaView, OVITO and SPICE"
DESCRIPTION = """\
Writes a run as files for other programs:
  vtk   for ParaView: bearing.pvd, a time series of the balls (points with radius, velocity, spin,
        load, film, capacitance) and of the raceway tori (surfaces)
  xyz   for OVITO: bearing.xyz (extended XYZ, the same columns), inner_raceway.obj,
        outer_raceway.obj
  spice for SPICE: bearing.cir (subcircuits of capacitances that follow the run), bearing.pwl (a
        table of time, capacitance and leakage resistance)
Positions are not exaggerated. All values are in SI units."""
EXAMPLES = """\
examples:
  raceway export build/run/6208 --format vtk              build/run/6208/vtk/bearing.pvd
  raceway export build/run/6208 --format xyz --every 1 --out for_ovito
  raceway export build/run/6208 --format spice --resistivity 1e9

In ParaView, open bearing.pvd and click Apply. To show the balls, add a Glyph filter with type
Sphere, Scale Array radius and Scale Factor 2.
Exit codes: 0 done, 1 the run is broken or the folder cannot be written, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one_run.add(one)
    one.add_argument(
        "--format",
        choices=("vtk", "xyz", "spice"),
        required=True,
        help="vtk for ParaView, xyz for OVITO, spice for SPICE",
    )
    one.add_argument(
        "--every",
        type=positive,
        metavar="N",
        help="write every Nth sample (default: at most 200 samples in total; spice: all samples)",
    )
    one.add_argument(
        "--resistivity",
        type=number(1e3, 1e18, "ohm m"),
        metavar="OHM_M",
        help="for spice: resistivity of the lubricant (default: films do not leak)",
    )
    one.add_argument("--out", metavar="DIR", help="folder to write into (default: DIR/FORMAT)")


def run(arguments: argparse.Namespace) -> None:
    out = arguments.out or Path(arguments.folder) / arguments.format
    if arguments.format == "spice":
        print(_element(arguments, out))
        return
    if arguments.resistivity is not None:
        arguments.complain("--resistivity applies to --format spice")
    from raceway.export import ovito, paraview

    write = {"vtk": paraview.write, "xyz": ovito.write}[arguments.format]
    print(write(one_run.tables(arguments), out, arguments.every))


def _element(arguments, out):
    from raceway.electric import spice
    from raceway.electric.films import of_run
    from raceway.electric.leak import Leak

    leak = Leak(arguments.resistivity) if arguments.resistivity else None
    films = of_run(one_run.opened(arguments), leak)
    try:
        films = films.every(arguments.every or 1)
    except ValueError as error:
        raise RacewayError(f"--every {arguments.every}: {error}") from None
    return spice.write(films, out)
