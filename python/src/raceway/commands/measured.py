# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway measured FILE`: find speed, levels and lines in a recording of a real bearing."""

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raceway.commands import output, recorded
from raceway.commands.quantity import number
from raceway.commands.spectrum import harmonics, plain, table
from raceway.rows import warning_lines
from raceway.units import prefixed

if TYPE_CHECKING:  # scipy takes longer to load than `--help` should
    from raceway.recordings.recording import Recording

HELP = "find speed, levels and kinematic lines in a recording of a real bearing"
DESCRIPTION = """\
Analyses a recording in the same way as `raceway spectrum` analyses a run. Prints the channels with
their levels, the speed of the shaft, which is found from its own lines, and the lines of the
bearing in the envelope spectrum.

Supported files: .mat from Case Western Reserve University (X..._DE_time), the MFPT society
(bearing.gs), Paderborn University (structure of X and Y) and `raceway dataset`; .npz with one row
for each name, one of which may contain times; .csv from PRONOSTIA (acc_00001.csv), or with columns,
the first of which may contain times (`time_s`, `Time (ms)`) without gaps, or row numbers, which are
ignored; .wav. The .mat files from CWRU do not state their sampling rate: give --rate 12000 or
48000. Accelerations in g (`a_g`, `a (g)`) are converted to m/s^2.

The nominal speed often differs from the true speed by more than the cage slip. The true speed is
searched for within 1.5 % of the nominal speed, by means of shaft lines that agree with each other.
--nominal gives the nominal speed for a file that does not state it; --rpm sets the true speed.

A warning names channels whose signal exceeded the range of the recorder: its largest or smallest
value occurs at least six times as often as the next level."""
EXAMPLES = """\
examples:
  raceway measured 105.mat --bearing 6205 --rate 12000
  raceway measured vibration.csv --bearing 6208 --rate 48000 --nominal 1500 --out lines.png
  raceway measured 0002.mat --bearing 6205 --raw --kind time --out motion.png

Exit codes: 0 done, 1 the file cannot be read or has too little data, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    recorded.add(one)
    one.add_argument("--raw", action="store_true", help="use the signal, not its envelope")
    harmonics(one)
    one.add_argument(
        "--angle",
        type=number(0, 90, "degrees"),
        metavar="DEG",
        help="contact angle for the kinematics (default: nominal angle of the bearing, or 0)",
    )
    one.add_argument(
        "--within",
        type=number(1e-4, 0.05, "of the frequency"),
        default=0.01,
        metavar="SHARE",
        help="relative width of the range searched around a line (default: 0.01)",
    )
    one.add_argument(
        "--kind",
        choices=("lines", "time"),
        default="lines",
        help="kind of picture: the spectrum with its lines (default), or time and frequency",
    )
    one.add_argument("--out", metavar="PNG", help="draw the picture to this file")
    output.option(one)


def run(arguments: argparse.Namespace) -> None:
    from raceway.runs import envelope, spectrum

    if arguments.raw and arguments.band:
        arguments.complain("--band applies to an envelope; leave out --raw")
    if arguments.kind == "time" and not arguments.out:
        arguments.complain("--kind time draws a picture; give --out")
    opened = recorded.opened(arguments)
    of = spectrum.of_run if arguments.raw else envelope.of_run
    more = () if arguments.raw else (arguments.band,)
    found = of(opened, arguments.channel, *more, orders=False)
    angle = None if arguments.angle is None else math.radians(arguments.angle)
    lines = spectrum.lines(
        opened, found, arguments.harmonics, angle, arguments.within, sidebands=not arguments.raw
    )
    if arguments.out and arguments.kind == "time":
        _over_time(arguments, opened, found)
    elif arguments.out:
        # loading matplotlib takes longer than computing a spectrum
        from raceway.pictures.spectrum import picture

        picture(opened, found, lines, arguments.out)
    figures = _figures(opened)
    said = warning_lines(figures["warnings"])
    if arguments.json:
        figures["lines"] = [plain(line, found.attrs["units"]) for line in lines]
        print(output.as_json(figures))
    else:
        print(_text(figures), "", table(opened, found, lines), *said, sep="\n")


def _over_time(arguments, opened, found):
    from raceway.pictures.time_frequency import picture
    from raceway.runs import time_frequency

    band = None if arguments.raw else found.attrs["band"]
    over = time_frequency.of_run(opened, arguments.channel, band=band, orders=False)
    picture(opened, over, Path(arguments.out))


def _figures(opened: "Recording") -> dict[str, Any]:
    """Return file, speed, levels and warnings for JSON."""
    from raceway import arrays
    from raceway.recordings import clipping
    from raceway.recordings.recording import level
    from raceway.runs.source import Signal

    channels = [
        {
            "name": name,
            "values": len(one.values),
            "rate_Hz": one.rate,
            "unit": one.units,
            "mean": float(one.values.mean()),
            **level(Signal(one.values, 1 / one.rate, {}))._asdict(),
            "clipped_share": clipping.share(one.values),
        }
        for name, one in opened.channels.items()
    ]
    found = opened.speed
    return {
        "file": opened.where,
        "kind": opened.kind,
        "rpm": opened.rpm,
        "rpm_uncertainty": 60 * found.uncertainty if found else None,
        "rpm_nominal": opened.nominal_rpm,
        "rpm_from": opened.speed_from,
        "load_N": arrays.plain(opened.load),
        "channels": arrays.plain(channels),
        "warnings": [
            f"{one['name']} is clipped: {one['clipped_share']:.2g} of its values are at a limit of"
            " the recorder, so levels are too low and lines have additional harmonics"
            for one in channels
            if one["clipped_share"]
        ],
    }


def _text(figures):
    rows = [f"{figures['file']} ({figures['kind']})"]
    shaft = f"  shaft {figures['rpm']:.6g} rpm"
    if figures["rpm_uncertainty"] is not None:
        shaft += f" +- {figures['rpm_uncertainty']:.2g}, from its lines; nominal"
        shaft += (
            f" {figures['rpm_nominal']:g} rpm ({figures['rpm'] / figures['rpm_nominal'] - 1:+.3%})"
        )
    elif figures["rpm_from"] == "file":
        shaft += ", as stated in the file"
    elif figures["rpm_from"] == "nominal":
        shaft += ", nominal: the true speed is unknown, because no lines of the shaft agree"
    rows.append(shaft)
    if figures["load_N"] is not None:
        rows.append(f"  load {figures['load_N']:.4g} N radial")
    heads = ("values", "rate", "mean", "rms", "peak", "kurtosis")
    rows += ["", f"  {'channel':<24}" + "".join(f"{head:>16}" for head in heads)]
    for one in figures["channels"]:
        rate = "-" if one["rate_Hz"] is None else prefixed(one["rate_Hz"], "Hz", 5)
        cells = [str(one["values"]), rate]
        cells += [_cell(one[key], one["unit"]) for key in ("mean", "rms", "peak")]
        cells.append(_cell(one["kurtosis"], ""))
        rows.append(f"  {one['name']:<24}" + "".join(f"{cell:>16}" for cell in cells))
    return "\n".join(rows)


def _cell(value, units):
    return "-" if value is None else f"{value:.4g} {units}".rstrip()
