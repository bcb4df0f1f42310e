# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway stiffness`: compute stiffness and damping of a bearing for loads and speeds."""

import argparse
import math
from pathlib import Path

from raceway.commands import options
from raceway.commands.quantity import number
from raceway.theory.models import CAPACITANCE

HELP = "compute stiffness and damping for loads and speeds, for ROSS and other programs"
DESCRIPTION = """\
Computes stiffness and damping of the inner ring of a bearing from statics and films: 5 x 5 matrices
in x, y, z, rx, ry, averaged over a ball pass, together with their smallest and largest values. The
table has one row for each radial load and speed. The ring is in equilibrium untilted and, without
an axial load, held along z, as in `raceway static`. Damping includes only the contributions of
films and steel, and requires a lubricant.

--out writes the results in a format that depends on the file name extension:
  .csv   a table with the units in its first line
  .json  all results
  .toml  for ROSS, with a single load: ross.BearingElement.load(FILE); without tilting terms, see
         docs/stiffness.rst"""
EXAMPLES = """\
examples:
  raceway stiffness --load 1000 3000 --rpm 1000 3000
  raceway stiffness --load 3000 --rpm 1000 2000 3000 --lubricant vg46 --temperature 70
  raceway stiffness --load 3000 --rpm 3000 --lubricant vg46 --node 4 --out build/6208.toml

Exit codes: 0 done, 1 no equilibrium or unusable data, 2 wrong command line."""
FORMATS = (".csv", ".json", ".toml")


def add(one: argparse.ArgumentParser) -> None:
    options.bearing(one)
    options.grooves(one)
    options.point(one, "load")
    options.point(one, "axial", several=False)
    options.point(
        one, "rpm", "speed of the inner ring in rpm, or several in ascending order (default: 0)"
    )
    options.point(one, "clearance", several=False)
    one.add_argument(
        "--lubricant", metavar="NAME", help="a file in inputs/lubricants, or a path; adds damping"
    )
    options.point(one, "temperature", several=False)
    one.set_defaults(load=[0.0], axial=0.0, rpm=[0.0], clearance=0.0)
    options.models(
        one,
        CAPACITANCE,
        "full: includes the film in the gap and its damping branch; paper: damping as in the paper",
    )
    one.add_argument(
        "--frequency",
        type=number(0, 1e5, "Hz"),
        metavar="HZ",
        help="vibration frequency at which the damping is evaluated (default: rotational frequency"
        " of the shaft)",
    )
    one.add_argument(
        "--phases",
        type=int,
        choices=range(1, 65),
        metavar="N",
        help="number of evenly spaced ball positions within a ball pass, from 1 to 64 (default:"
        " more where the stiffness changes fast, for errors of at most 0.2 %%)",
    )
    one.add_argument(
        "--node", type=int, default=0, metavar="N", help="for .toml: node of the rotor (default: 0)"
    )
    one.add_argument(
        "--tilts",
        choices=("held", "free"),
        default="held",
        help="for .toml: tilts of the ring are held, or free without moments (default: held)",
    )
    one.add_argument("--out", metavar="FILE", help="write the results to a .csv, .json or .toml")


def run(arguments: argparse.Namespace) -> None:
    ending = Path(arguments.out).suffix if arguments.out else None
    if ending is not None and ending not in FORMATS:
        arguments.complain(f"--out {arguments.out}: the name must end in {', '.join(FORMATS)}")
    if ending == ".toml" and len(arguments.load) > 1:
        arguments.complain(
            f"--out {arguments.out}: ROSS accepts only one load, not {len(arguments.load)}"
        )
    if any(a >= b for a, b in zip(arguments.rpm, arguments.rpm[1:])):
        arguments.complain("--rpm: speeds must be in ascending order")
    if arguments.node < 0:
        arguments.complain(f"--node is {arguments.node}, must be at least 0")
    if arguments.temperature is not None and arguments.lubricant is None:
        arguments.complain("--temperature applies to the lubricant; give --lubricant")
    if arguments.frequency is not None and arguments.lubricant is None:
        arguments.complain("--frequency applies to the damping; give --lubricant")
    if arguments.lubricant is not None and not all(arguments.rpm):
        arguments.complain("--lubricant: a film needs a speed; give --rpm above 0")

    # loading scipy takes longer than printing --help
    from raceway.export import rotor

    found = rotor.points(
        arguments.bearing,
        arguments.load,
        arguments.rpm,
        axial=arguments.axial,
        lubricant=arguments.lubricant,
        temperature=arguments.temperature,
        models=arguments.models,
        folder=arguments.inputs,
        frequency=None if arguments.frequency is None else 2 * math.pi * arguments.frequency,
        phases=arguments.phases,
        clearance=arguments.clearance,
        **options.grooves_of(arguments),
    )
    if ending is None:
        print(table(found))
    elif ending == ".toml":
        tag = Path(arguments.bearing).name
        print(rotor.write_ross(found, arguments.out, arguments.node, tag, arguments.tilts))
    else:
        print({".csv": rotor.write_csv, ".json": rotor.write_json}[ending](found, arguments.out))


def table(points: list) -> str:
    """Return a table of the translational terms of `rotor.Point` objects as text.

    The stiffness along y is shown with its range over a ball pass.
    """
    from raceway.rows import aligned
    from raceway.units import prefixed

    damped = any(one.over.mean.damping.any() for one in points)
    rows = [["rpm", "load", "kxx", "kyy", "kyy least", "most", "kzz"]]
    rows[0] += ["cxx", "cyy", "czz"] if damped else []
    for one in points:
        (k, c), (least, _), (most, _) = one.over
        stiff = (k[0, 0], k[1, 1], least[1, 1], most[1, 1], k[2, 2])
        row = [
            f"{one.rpm:g}",
            prefixed(one.load, "N"),
            *(prefixed(value, "N/m") for value in stiff),
        ]
        rows.append(row + [prefixed(c[axis, axis], "N s/m") for axis in range(3) if damped])
    return "\n".join(aligned(rows, ""))
