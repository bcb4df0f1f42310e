# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway spectrum DIR`: find the kinematic lines in the motion of a ring."""

import argparse
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raceway.commands import one_run, options, output
from raceway.commands.quantity import number
from raceway.units import prefixed

if TYPE_CHECKING:  # xarray takes longer to load than `--help` should
    import xarray as xr

    from raceway.runs.source import Source
    from raceway.runs.spectrum import Line

HELP = "find kinematic lines (FTF, BSF, BPFO, BPFI) in the motion of a ring"
DESCRIPTION = """\
Computes the spectrum of one column of a ring and finds the kinematic lines in it. Simulate enough
ball passes: -var passes 40 separates all lines except FTF. The record must contain at least 5.5
periods of a line.

--envelope computes the spectrum of the signal's envelope in a band around a resonance. It shows the
rate at which flaws excite the resonance, with the sidebands due to the shaft and the cage.

The kinematics assume that balls roll without slip at the measured contact angle. The orders follow
from the actual speeds of cage and balls in the run, which include slip; the last column gives the
deviation from lines computed with these speeds. If the outer ring rotates, two lines are added: its
rotation and VC, the rate at which balls pass the load; FTF is then the cage speed relative to the
frame.

--kind time draws the signal, or its envelope, as a function of time and frequency. If the speed of
the shaft changes by more than 1 %, frequencies are replaced by orders of the shaft speed (inner
relative to outer ring)."""
EXAMPLES = """\
examples:
  build/liggghts -in inputs/in.6208 -var passes 40 -var out build/run/long
  raceway spectrum build/run/long --signal x --out spectrum.png
  raceway spectrum build/run/long --signal capacitance --harmonics 5 --json
  raceway spectrum build/run/long --ring outer --signal ay --envelope --band 2000 8000
  raceway spectrum build/run/long --ring outer --signal ay --envelope --kind time

Exit codes: 0 done, 1 the run is broken or has no such signal, 2 wrong command line."""
ORDERS = "order: measured cage and balls; kinematics: balls that roll without slip"


def add(one: argparse.ArgumentParser) -> None:
    one_run.add(one)
    one.add_argument(
        "--signal",
        default="shift",
        metavar="NAME",
        help="column of the ring: shift (displacement along the load, the default), x, y, fx, fy,"
        " mz, capacitance ...",
    )
    one.add_argument(
        "--ring",
        choices=("inner", "outer"),
        default="inner",
        help="ring that the signal belongs to; an outer ring in a housing also has ax, ay ..."
        " (default: inner)",
    )
    harmonics(one)
    one.add_argument(
        "--angle",
        type=number(0, 90, "degrees"),
        metavar="DEG",
        help="contact angle for the kinematics (default: the measured angle if there is one,"
        " otherwise the nominal angle, otherwise 0)",
    )
    one.add_argument(
        "--envelope",
        action="store_true",
        help="compute the spectrum of the signal's envelope, with sidebands",
    )
    options.band(one)
    output.option(one, "print a JSON list instead of a table")
    one.add_argument(
        "--kind",
        choices=("lines", "time"),
        default="lines",
        help="lines (default), or time: a picture of the signal as a function of time and"
        " frequency, or order in a run-up",
    )
    one.add_argument(
        "--out",
        metavar="PNG",
        help="plot the spectrum and mark its lines (default for --kind time:"
        " DIR/time_frequency.png)",
    )


def run(arguments: argparse.Namespace) -> None:
    from raceway.runs import envelope
    from raceway.runs.spectrum import lines, of_run

    if arguments.band and not arguments.envelope:
        arguments.complain("--band applies to an envelope; give --envelope")
    if arguments.band and not arguments.band[0] < arguments.band[1]:
        arguments.complain(f"--band: {arguments.band[0]:g} Hz must be below {arguments.band[1]:g}")
    opened = one_run.opened(arguments)
    if arguments.kind == "time":
        _over_time(arguments, opened)
        return
    spectrum = (
        envelope.of_run(opened, arguments.signal, arguments.band, arguments.ring)
        if arguments.envelope
        else of_run(opened, arguments.signal, arguments.ring)
    )
    found = lines(
        opened,
        spectrum,
        arguments.harmonics,
        None if arguments.angle is None else math.radians(arguments.angle),
        sidebands=arguments.envelope,
    )
    if arguments.out:
        # loading matplotlib takes longer than computing a spectrum
        from raceway.pictures.spectrum import picture

        picture(opened, spectrum, found, arguments.out)
    print(
        output.as_json([plain(line, spectrum.attrs["units"]) for line in found])
        if arguments.json
        else table(opened, spectrum, found)
    )


def _over_time(arguments, opened):
    """Draw the picture of time and frequency, and print its path."""
    from raceway.pictures.time_frequency import picture
    from raceway.runs import envelope, time_frequency

    if arguments.json:
        arguments.complain("--json applies to --kind lines")
    name, ring, band = arguments.signal, arguments.ring, arguments.band
    if arguments.envelope and band is None:
        band = envelope.of_run(opened, name, None, ring).attrs["band"]
    found = time_frequency.of_run(opened, name, ring, band=band)
    out = Path(arguments.out or Path(arguments.folder) / "time_frequency.png")
    picture(opened, found, out)
    print(out)


def table(run: "Source", spectrum: "xr.DataArray", found: Sequence["Line"]) -> str:
    """Return the `Line` objects `found` in the `spectrum` of a run or recording as text.

    If the cage speed is known, the orders follow from it, and the last column is the deviation from
    the lines that follow from it.
    """
    unit, resolution, of = spectrum.attrs["units"], spectrum.attrs["resolution"], spectrum.dims[0]
    fine = prefixed(resolution, "Hz", 3) if of == "frequency" else f"{resolution:.3g} orders"
    rows = [f"{spectrum.attrs['long_name']}; resolution {fine}"]
    if "band" in spectrum.attrs:
        low, high = spectrum.attrs["band"]
        rows.append(f"band {prefixed(low, 'Hz')} to {prefixed(high, 'Hz')}")
    if of == "order":
        rows.append(f"{run.title}: lines in orders of the shaft")
    heading = (
        f"  {'line':<14}{'order':>9}{'kinematics':>14}"
        f"{'found':>12}{'difference':>12}{'amplitude':>12}"
    )
    cage = math.isfinite(run.motion.cage)
    rows += ["", heading + f"{'to cage':>10}" * cage]
    sign = "Hz" if of == "frequency" else "  "
    for line in found:
        name = line.name if line.harmonic == 1 else f"{line.name} x{line.harmonic}"
        order = f"{line.order:.4f}" if math.isfinite(line.order) else "-"
        start = f"  {name:<14}{order:>9}{line.expected:>11.4f} {sign}"
        if line.note:
            rows.append(f"{start}  {line.note}")
            continue
        rows.append(
            f"{start}{line.found:>9.4f} {sign}{line.difference:>+10.4%} "
            f" {prefixed(line.amplitude, unit, 3):>12}"
        )
        if cage:
            rows[-1] += f"{line.found / line.by_cage - 1:>+10.4%}"
    rows += ["", "  " + ORDERS] if cage else []
    return "\n".join(rows)


def plain(line: "Line", unit: str) -> dict[str, Any]:
    """Return a `Line` of a signal in `unit` for JSON; values that were not found are None."""
    from raceway import arrays

    places = ("expected", "found", "by_cage")
    values = line._replace(unit=unit)._asdict()  # the unit of the amplitude
    return arrays.plain(
        {f"{key}_{line.unit}" if key in places else key: one for key, one in values.items()}
    )


def count(text: str) -> int:
    """Convert `text` to a number of harmonics; for use as an argparse type."""
    value = int(text)
    if not 1 <= value <= 50:
        raise ValueError
    return value


count.__name__ = "number from 1 to 50"  # argparse prints this name in its error message


def harmonics(to: Any) -> None:
    """Add the option --harmonics to a parser or group of options."""
    to.add_argument(
        "--harmonics",
        type=count,
        default=3,
        metavar="N",
        help="number of harmonics per line (default: 3)",
    )
