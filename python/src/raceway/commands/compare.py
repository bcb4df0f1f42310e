# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway compare DIR FILE`: compare a run with a recording of the real bearing."""

import argparse
import math
from typing import TYPE_CHECKING, Any

from raceway.commands import one_run, output, recorded
from raceway.commands.spectrum import harmonics
from raceway.units import prefixed

if TYPE_CHECKING:  # scipy takes longer to load than `--help` should
    from raceway.recordings.compare import Comparison

HELP = "compare the levels and lines of a run with those of a recording"
DESCRIPTION = """\
Compares the levels and the lines of the envelope spectrum of a run with those of a recording of the
bearing that it represents. Lines are given in orders of the respective shaft speed. Levels are
computed at the sampling rate of the recording; a run with a higher rate is low-pass filtered. Both
envelopes use the same band.

Levels depend on the path from the bearing to the sensor, which the run does not model; orders do
not depend on it."""
EXAMPLES = """\
examples:
  raceway compare build/run/twin 130.mat --rate 12000
  raceway compare build/run/twin 130.mat --rate 12000 --band 2000 5000 --out twin.png

Exit codes: 0 done, 1 the run or the file cannot be used, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one_run.add(one)
    recorded.add(one, bearing=False)
    one.add_argument(
        "--signal", default="ay", metavar="NAME", help="column of the run (default: ay)"
    )
    one.add_argument(
        "--ring",
        choices=("inner", "outer"),
        default="outer",
        help="ring that the column belongs to (default: outer)",
    )
    harmonics(one)
    one.add_argument("--out", metavar="PNG", help="plot both spectra to this file")
    output.option(one)


def run(arguments: argparse.Namespace) -> None:
    from raceway.recordings.compare import compare
    from raceway.recordings.recording import Recording

    simulated = one_run.opened(arguments)
    recording = Recording(
        arguments.file,
        simulated.geometry,
        rpm=arguments.rpm,
        nominal=arguments.nominal,
        rate=arguments.rate,
        nominal_angle=simulated.nominal_angle,
        name=str(simulated.settings["bearing"]),
    )
    found = compare(
        simulated,
        recording,
        arguments.signal,
        arguments.ring,
        arguments.channel,
        arguments.band,
        arguments.harmonics,
    )
    if arguments.out:
        # loading matplotlib takes longer than computing a spectrum
        from raceway.pictures.compare import picture

        picture(found, arguments.out)
    print(output.as_json(figures(found)) if arguments.json else text(found))


def figures(found: "Comparison") -> dict[str, Any]:
    """Return the results of run and recording for JSON; values that were not found are None."""
    from raceway.arrays import plain

    sides = {
        name: {"title": side.title, "rate_Hz": side.rate, "shaft_Hz": side.shaft}
        | {"unit": side.units}
        | side.level._asdict()
        for name, side in (("run", found.run), ("recording", found.recording))
    }
    orders = ("nominal", "run", "recording")
    lines = [
        {f"{key}_order" if key in orders else key: value for key, value in one._asdict().items()}
        | {f"{key}_amplitude_unit": sides[key]["unit"] for key in sides}
        for one in found.lines
    ]
    return plain(sides | {"band_Hz": list(found.band), "lines": lines})


def text(found: "Comparison") -> str:
    """Return the results of run and recording as text."""
    rows = [f"run        {found.run.title}", f"recording  {found.recording.title}", ""]
    rows.append(f"  {'':<16}{'run':>16}{'recording':>16}")
    for key in ("rms", "peak", "kurtosis"):
        cells = [
            f"{getattr(side.level, key):.4g} {side.units if key != 'kurtosis' else ''}".rstrip()
            for side in (found.run, found.recording)
        ]
        rows.append(f"  {key:<16}{cells[0]:>16}{cells[1]:>16}")
    low, high = (prefixed(one, "Hz") for one in found.band)
    rows += ["", f"Envelope, {low} to {high}; orders of the shaft", ""]
    heads = ("nominal", "run", "recording", "run over it", "amplitudes", "")
    rows.append(f"  {'line':<12}" + "".join(f"{head:>14}" for head in heads))
    for one in found.lines:
        name = one.name if one.harmonic == 1 else f"{one.name} x{one.harmonic}"
        cells = [f"{one.nominal:.4f}", *(_order(value) for value in (one.run, one.recording))]
        cells.append(
            f"{one.run / one.recording - 1:+.3%}"
            if math.isfinite(one.run) and math.isfinite(one.recording)
            else "-"
        )
        for place, value, side in (
            (one.run, one.run_amplitude, found.run),
            (one.recording, one.recording_amplitude, found.recording),
        ):
            cells.append(prefixed(value, side.units, 3) if math.isfinite(place) else "-")
        rows.append(f"  {name:<12}" + "".join(f"{cell:>14}" for cell in cells))
    return "\n".join(rows)


def _order(value):
    return f"{value:.4f}" if math.isfinite(value) else "-"
