# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway catalogue`: list and search the available bearings."""

import argparse
import csv
import sys
from pathlib import Path

from raceway.commands import options, output
from raceway.commands.quantity import number, variable

HELP = "list and search bearings by size, rating and name"
DESCRIPTION = """\
Lists the bearings in inputs/bearings, i.e. its files and the rows of its tables. Their names can be
passed to --bearing and, for a deck, to -var bearing. WORD is searched for in names, titles and
sources.

The columns `balls` and `ratings` state where these data come from; "estimate" means that the balls
were derived from the ratings with ISO 281 and ISO 76. --clearances adds the clearance classes of
ISO 5753 for each deep groove ball bearing."""
EXAMPLES = """\
examples:
  raceway catalogue
  raceway catalogue --bore 40
  raceway catalogue angular --series 72 --dynamic-load-above 30e3
  raceway catalogue 6208 --clearances
  raceway catalogue --series 62 --json
  raceway catalogue --csv > bearings.csv
  raceway catalogue 7205B --file inputs/bearings/mine    a file to edit

JSON and CSV are in SI units.
Exit codes: 0 done, 1 no such bearing or an unusable file, 2 wrong command line."""
# heading, field of an entry, factor, format
COLUMNS = (
    ("name", "name", None, "<9"),
    ("bore mm", "bore_m", 1e3, ">7g"),
    ("outs. mm", "outside_m", 1e3, ">8g"),
    ("width mm", "width_m", 1e3, ">8g"),
    ("angle", "contact_angle_deg", 1, ">5g"),
    ("C kN", "dynamic_load_N", 1e-3, ">6g"),
    ("C0 kN", "static_load_N", 1e-3, ">6g"),
    ("Pu kN", "fatigue_load_N", 1e-3, ">6g"),
    ("lim. rpm", "limiting_speed_rpm", 1, ">8.6g"),
    ("Z", "balls", 1, ">3g"),
    ("D mm", "ball_diameter_m", 1e3, ">7.5g"),
    ("pitch mm", "pitch_diameter_m", 1e3, ">8.5g"),
    ("balls", "balls_from", None, "<11"),
    ("ratings", "ratings_from", None, "<7"),
)


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument(
        "words", nargs="*", metavar="WORD", help="show only bearings that contain this text"
    )
    one.add_argument("--series", metavar="TEXT", help="start of the name: 60, 62, 72")
    for name, size in (("bore", "bore"), ("outside", "outside diameter"), ("width", "width")):
        one.add_argument(
            f"--{name}", type=number(0.1, 3000, "mm"), metavar="MM", help=f"{size} in millimetres"
        )
    one.add_argument(
        "--contact-angle",
        type=variable("contact_angle"),
        metavar="DEG",
        help="nominal contact angle in degrees; 0 selects deep groove ball bearings",
    )
    for name, symbol in (("dynamic", "C"), ("static", "C0")):
        one.add_argument(
            f"--{name}-load-above",
            type=number(0, 1e8, "N"),
            metavar="N",
            help=f"lower limit of {symbol} in newtons",
        )
    one.add_argument("--clearances", action="store_true", help="add the clearance classes C2 to C5")
    options.inputs(one)
    form = one.add_mutually_exclusive_group()
    output.option(form, "print a JSON list in SI units")
    form.add_argument(
        "--file",
        metavar="PATH",
        help="write the data of the bearing WORD and their sources to a file",
    )
    form.add_argument("--csv", action="store_true", help="print comma-separated values in SI units")


def run(arguments: argparse.Namespace) -> None:
    from raceway import catalogue, listing
    from raceway.inputs import InputError

    if arguments.file is not None:
        _write(arguments)
        return
    sizes = {
        name: given and 1e-3 * given
        for name in ("bore", "outside", "width")
        for given in [getattr(arguments, name)]
    }
    found = listing.search(
        listing.entries(arguments.inputs),
        arguments.words,
        series=arguments.series,
        contact_angle=arguments.contact_angle,
        dynamic_load_above=arguments.dynamic_load_above,
        static_load_above=arguments.static_load_above,
        **sizes,
    )
    if not found:
        if len(arguments.words) == 1:
            catalogue.find("bearings", arguments.words[0], arguments.inputs)  # names similar ones
        raise InputError("no bearing matches; `raceway catalogue` lists all of them")
    rows = [one.figures() for one in found]
    if arguments.clearances:
        for row in rows:
            row.update(_clearances(row))
    if arguments.json:
        print(output.as_json(rows))
    elif arguments.csv:
        writer = csv.DictWriter(sys.stdout, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    else:
        print("\n".join(_table(rows)))


def _write(arguments):
    from raceway import catalogue, data_table, files, inputs

    if len(arguments.words) != 1:
        raise inputs.InputError(
            "--file needs exactly one name, as in `raceway catalogue 7205B --file mine`"
        )
    path = Path(arguments.file)
    if path.exists():
        raise inputs.InputError(f"{path} already exists; remove it or choose another file name")
    text = inputs.text(catalogue.find("bearings", arguments.words[0], arguments.inputs))
    files.folder(path.parent)
    files.text(path, data_table.aligned(text))
    print(path)


def _clearances(row):
    """Return {column: clearance in m} for the clearance classes.

    All bearings have the same columns.
    """
    from raceway import clearance_classes

    known = {}
    if row["bore_m"] and not row["contact_angle_deg"]:
        known = clearance_classes.of_bore(row["bore_m"])
    return {
        f"clearance_{name}_{end}_m": known[name][place] if name in known else None
        for name in clearance_classes.NAMES
        for place, end in enumerate(("least", "largest"))
    }


def _table(rows):
    yield "  ".join(f"{heading:{_width(shape)}}" for heading, _, _, shape in COLUMNS).rstrip()
    for row in rows:
        yield "  ".join(
            _cell(row[field], factor, shape) for _, field, factor, shape in COLUMNS
        ).rstrip()
    yield from _classes(rows)


def _width(shape):
    return shape.rstrip("g").partition(".")[0]


def _cell(value, factor, shape):
    if value is None:
        return f"{'-':{_width(shape)}}"
    return f"{value if factor is None else factor * value:{shape}}"


def _classes(rows):
    from raceway.clearance_classes import NAMES

    if "clearance_CN_least_m" not in rows[0]:
        return
    yield "\nDiametral clearance before mounting, µm (ISO 5753); the deck's -var clearance is in m"
    for row in rows:
        ends = [
            (name, row[f"clearance_{name}_least_m"], row[f"clearance_{name}_largest_m"])
            for name in NAMES
        ]
        if ends[1][1] is not None:
            yield f"{row['name']:<9}" + "".join(
                f"  {name} {1e6 * least:.0f} to {1e6 * largest:.0f}"
                for name, least, largest in ends
                if least is not None
            )
