# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway identify FILE`: find clearance, loads, oil temperature and cooling from readings."""

import argparse
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from raceway.commands import options, output
from raceway.commands.quantity import number, variable
from raceway.recordings import WITHIN
from raceway.theory.models import STATICS
from raceway.units import prefixed

if TYPE_CHECKING:  # scipy takes longer to load than `--help` should
    from raceway.recordings.identify import Found
    from raceway.recordings.readings import Readings

HELP = "find clearance, thrust, oil temperature and cooling from measured values"
DESCRIPTION = """\
Finds the state of a real bearing from readings. A reading is a line in orders of the shaft speed
(FTF, BPFO, BPFI, BSF), the capacitance of the contacts in F (mean over a ball pass), a temperature
in degrees C, or a recording in which lines are found. Each reading has a standard deviation,
`within`, and an operating point. A least-squares fit of statics, films and friction determines the
`unknown` quantities within the given ranges.

A table of lines (--lines) can be given instead of FILE. The unknowns are then clearance and thrust,
and also load and oil temperature unless they are given.

A single line does not determine clearance and thrust separately; the valley of pairs that fit it is
printed. A capacitance, a second load (`load_more`, `axial_more`) or a temperature with a known
cooling (`conductance`) separates them.

In the model, the film in the gap reduces the clearance by the film thickness, and rolling on curved
grooves speeds up the cage, which shifts a line by up to 1e-3 of its order (models full). If some
balls are unloaded, the pocket play changes the cage speed by an unknown amount, which widens the
confidence limits of the result."""
EXAMPLES = """\
examples:
  raceway identify --bearing 6205 --lines lines.csv --load 10
  raceway identify readings.yaml
  raceway identify readings.yaml --json

A table of lines in hertz for one recording:
  speed_Hz,bpfo_Hz,ftf_Hz
  29.95,107.74,11.971

A file of readings:
  bearing: 6205
  lubricant: vg100
  known: {load: 10, temperature: 40}
  unknown: {clearance: 0 15e-6, axial: 5 200}
  readings:
    - {rpm: 1796, BPFO: 3.5972, within: 2e-4}
    - {rpm: 1796, axial_more: 200, BPFO: 3.6086, within: 2e-4}
    - {file: 130.mat, rate: 12000, line: BPFO}

Exit codes: 0 done, 1 no state explains the loads or the file is invalid, 2 wrong command line."""
NAMES = {
    "clearance": "diametral clearance",
    "load": "radial load",
    "axial": "axial load",
    "temperature": "oil temperature",
    "conductance": "cooling",
}
DECK = ("clearance", "load", "axial", "temperature")  # unknowns that are variables of the deck
OUT = 3.0  # deviations above this multiple of their uncertainty are not explained by the result


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("file", metavar="FILE", nargs="?", help="YAML file of readings; or --lines")
    one.add_argument(
        "--lines",
        metavar="CSV",
        help="table with one row per recording: speed_Hz, any of bpfo_Hz, bpfi_Hz, bsf_Hz and"
        " ftf_Hz, and load_N and temperature_C if they are known",
    )
    lines = one.add_argument_group("with --lines")
    options.bearing(lines)
    options.lubricant(lines)
    options.models(lines, STATICS, "films and cage speed")
    defaults = {name: lines.get_default(name) for name in ("bearing", "lubricant", "models")}
    lines.add_argument(
        "--load",
        type=number(0, 1e6, "N"),
        metavar="N",
        help="radial load in newtons (default: unknown)",
    )
    lines.add_argument(
        "--temperature",
        type=variable("temperature"),
        metavar="C",
        help="oil temperature in degrees Celsius (default: unknown)",
    )
    lines.add_argument(
        "--within",
        type=number(1e-6, 0.1, ""),
        metavar="SHARE",
        help=f"relative standard deviation of a line (default: {WITHIN:g})",
    )
    output.option(one, "print a JSON object instead of text")
    # an option that was not given is None
    defaults["within"] = WITHIN
    one.set_defaults(of_lines=defaults, **dict.fromkeys(defaults))


def run(arguments: argparse.Namespace) -> None:
    from raceway.recordings import line_table, readings
    from raceway.recordings.identify import identify

    if (arguments.file is None) == (arguments.lines is None):
        arguments.complain("give a FILE of readings, or --lines CSV")
    if arguments.lines is None:
        for name in ("load", "temperature"):
            if getattr(arguments, name) is not None:
                arguments.complain(
                    f"--{name} applies to --lines; in a FILE it is listed under `known`"
                )
        for name in arguments.of_lines:
            if getattr(arguments, name) is not None:
                arguments.complain(f"--{name} applies to --lines: a FILE states it itself")
        given = readings.read(arguments.file, arguments.inputs)
    else:
        words = {
            name: default if getattr(arguments, name) is None else getattr(arguments, name)
            for name, default in arguments.of_lines.items()
        }
        given = line_table.read(
            arguments.lines,
            load=arguments.load,
            temperature=arguments.temperature,
            inputs_folder=arguments.inputs,
            **words,
        )
    found = identify(given)
    print(output.as_json(figures(given, found)) if arguments.json else text(given, found))


def figures(given: "Readings", found: "Found") -> dict[str, Any]:
    """Return the result for JSON, in SI units except for temperatures, which are in degrees C.

    The values of the first keys are [value, low, high] with 95 % limits, or None for quantities
    that are known or that the readings do not determine.
    """
    from raceway.recordings.readings import STATE, UNITS

    def key(name):
        return f"{name}_{STATE[name][2].replace('/', '_')}"

    def named(values):
        """Return `values` with keys that include the units."""
        return {key(name): one for name, one in values.items()}

    def three(one, unit=1.0):
        return one and [unit * one.best, unit * one.low, unit * one.high]

    return {
        "contact_angle_deg": three(found.angle, math.degrees(1)),
        "slip": three(found.slip),
        **{key(name): three(found.values.get(name)) for name in STATE},
        "ridge": [[one["clearance"], one["axial"]] for one in found.valley],
        "unknown": {
            name: dict(one._asdict(), told_apart=one.determined)
            for name, one in named(found.values).items()
        },
        "state": named(found.state),
        "readings": [
            {
                "quantity": one.quantity,
                "unit": UNITS.get(one.quantity, "order"),
                "rpm": one.point.rpm,
                "value": one.value,
                "within": one.within,
                "predicted": float(value),
                "residual": float(rest),
            }
            for one, value, rest in zip(given.readings, found.predicted, found.residuals)
        ],
        "chi_squared": found.chi,
        "valley": [named(one) for one in found.valley],
        "idle_balls": found.idle,
        "deck": deck(given, found),
    }


def deck(given: "Readings", found: "Found") -> str:
    """Return the deck variables that simulate the first reading (its twin)."""
    point, state = given.readings[0].point, dict(found.state)
    for name, own, more in (
        ("load", point.load, point.load_more),
        ("axial", point.axial, point.axial_more),
    ):
        state[name] = (state[name] if own is None else own) + more
    if point.at is not None:
        state["temperature"] = point.at
    words = {
        "bearing": _word(given.bearing, "bearings"),
        "lubricant": _word(given.lubricant, "lubricants"),
    }
    words |= {"models": given.models, "rpm": f"{point.rpm:.8g}"}
    words |= {name: f"{state[name]:.6g}" for name in DECK if name in state}
    return " ".join(f"-var {name} {value}" for name, value in words.items())


def _word(path, kind):
    """The name of a data file of a `kind` in the decks' folder, otherwise its path."""
    from raceway import catalogue

    if path.parent == catalogue.folder() / kind:
        return path.name
    return str(path) if path.parent.name else f"./{path}"


def text(given: "Readings", found: "Found") -> str:
    """Return the result as text."""
    from raceway.recordings.readings import STATE, UNITS

    rows = [f"{given.bearing.name}, {given.lubricant.name}, models {given.models}", ""]
    rows.append(f"  {'unknown':<24}{'best':>12}{'95 % from':>14}{'to':>12}")
    for name, one in found.values.items():
        cells = [_shown(value, STATE[name][2]) for value in (one.best, one.low, one.high)]
        row = f"  {NAMES[name]:<24}{cells[0]:>12}{cells[1]:>14}{cells[2]:>12}"
        rows.append(row if one.determined else f"{row}  not determined")
    for name, one, unit, shown in (
        ("contact angle", found.angle, math.degrees(1), "{:.3f}°"),
        ("cage slip", found.slip, 100.0, "{:.3f} %"),
    ):
        if one:
            cells = [shown.format(unit * value) for value in (one.best, one.low, one.high)]
            rows.append(f"  {name:<24}{cells[0]:>12}{cells[1]:>14}{cells[2]:>12}")
    rows += ["", f"  {'reading':<24}{'read':>12}{'+-':>12}{'predicted':>12}{'off by (+-)':>13}"]
    for one, value, rest in zip(given.readings, found.predicted, found.residuals):
        unit = UNITS.get(one.quantity)
        cells = [
            _shown(number, unit, digits) if unit else f"{number:.{digits}g}"
            for number, digits in ((one.value, 6), (one.within, 2), (float(value), 6))
        ]
        row = f"  {f'{one.quantity} at {one.point.rpm:.5g} rpm':<24}"
        rows.append(f"{row}{''.join(f'{c:>12}' for c in cells)}{round(rest, 2) + 0.0:>+13.2f}")
    rows += _remarks(given, found)
    return "\n".join([*rows, "", f"  {deck(given, found)}"])


def _remarks(given, found) -> Sequence[str]:
    rows = []
    if found.valley:
        names = list(found.values)
        rows += ["", "These readings do not separate the unknowns. Each of these states fits them:"]
        from raceway.recordings.readings import STATE

        rows.append("  " + "".join(f"{NAMES[name]:>22}" for name in names))
        rows += [
            "  " + "".join(f"{_shown(one[name], STATE[name][2]):>22}" for name in names)
            for one in found.valley
        ]
    if (abs(found.residuals) > OUT).any():
        rows += [
            "",
            f"No state explains all readings: some are off by more than {OUT:g} times their",
        ]
        rows.append("uncertainty. A reading, a known value or the model is wrong.")
    if found.idle and given.models != "paper":
        rows += [
            "",
            f"Up to {found.idle} balls are unloaded, so the pocket play changes the cage speed",
        ]
        rows.append("by an unknown amount, which is included in the uncertainty of the lines.")
    return rows


def _shown(value, unit, digits=4):
    if unit == "C":
        return f"{value:.{digits}g} °C"
    return prefixed(value, unit, digits) if math.isfinite(value) else "-"
