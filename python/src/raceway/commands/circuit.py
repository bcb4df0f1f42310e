# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway circuit DIR`: compute bearing voltage, discharges and energy in an outer circuit."""

import argparse
from pathlib import Path

from raceway.commands import one_run, output
from raceway.commands.quantity import each, number, positive

HELP = "compute bearing voltage, discharges and energy in an outer circuit"
DESCRIPTION = """\
Computes the electrical circuit of a bearing during a run: every ball is a floating conductor
between two films, and an outer circuit connects the rings. Choose one outer circuit:
  --motor CWR CRF   capacitances from winding to rotor and from rotor to frame; needs a voltage
  --source OHM      a voltage source with this series resistance; needs a voltage
  --floating V      an isolated inner ring with the charge that this voltage puts on it
The voltage is given by --constant, --sine, --common-mode or --table.

With --strength, a film fails where its voltage exceeds this strength times the local thickness (h
minus three times the roughness). Without --strength no film fails."""
EXAMPLES = """\
examples:
  raceway circuit build/run/6208 --motor 50e-12 1e-9 --common-mode 560 2000 50 0.8 --strength 30e6
  raceway circuit build/run/6208 --source 1e4 --sine 10 50 --resistivity 1e9 --json
  raceway circuit build/run/6208 --source 1e6 --constant 20 --strength 30e6 --out discharges

--out writes circuit.csv, events.csv and, if films can fail, discharges.png into a folder.
Exit codes: 0 done, 1 the run is broken or has no film data, 2 wrong command line."""

FARAD = number(0, 1, "F")


def add(one: argparse.ArgumentParser) -> None:
    one_run.add(one)
    _outer(one)
    _voltage(one)
    one.add_argument(
        "--strength",
        type=number(1e3, 1e12, "V/m"),
        metavar="V/M",
        help="dielectric strength of a film (default: no film fails)",
    )
    one.add_argument(
        "--surfaces",
        choices=("rough", "smooth"),
        default="rough",
        help="rough: the local thickness is h minus three times the roughness; smooth: it is h"
        " (default: rough)",
    )
    one.add_argument(
        "--roughness",
        type=number(0, 1e-4, "m"),
        metavar="M",
        help="composite roughness for the local thickness (default: roughness of the run)",
    )
    one.add_argument(
        "--film-floor",
        type=number(1e-12, 1e-3, "m"),
        default=1e-9,
        metavar="M",
        help="lower limit of the local thickness (default: 1e-9)",
    )
    one.add_argument(
        "--arc",
        type=number(1e-6, 1e12, "ohm"),
        metavar="OHM",
        help="resistance of a failed film; adds discharge currents, durations and current density",
    )
    one.add_argument(
        "--resistivity",
        type=number(1e3, 1e18, "ohm m"),
        metavar="OHM_M",
        help="resistivity of the lubricant (default: infinite, i.e. films do not leak)",
    )
    one.add_argument(
        "--metal",
        type=number(1e-6, 1e12, "ohm"),
        metavar="OHM",
        help="resistance of a film in which asperities carry load (default: asperities do not"
        " conduct)",
    )
    one.add_argument(
        "--metal-share",
        type=number(0, 0.999, ""),
        default=0.0,
        metavar="S",
        help="fraction of the load on asperities above which they conduct (default: 0)",
    )
    one.add_argument(
        "--stray",
        type=FARAD,
        default=0.0,
        metavar="F",
        help="stray capacitance added to every film (default: 0)",
    )
    one.add_argument(
        "--points",
        type=positive,
        metavar="N",
        help="circuit steps per sample (default: 20 per period of the voltage)",
    )
    output.option(one, "print a JSON object instead of a table")
    one.add_argument("--out", metavar="DIR", help="folder for the tables and the picture")


def _outer(one):
    outer = one.add_mutually_exclusive_group(required=True)
    outer.add_argument(
        "--motor", type=number(1e-15, 1, "F"), nargs=2, metavar=("CWR", "CRF"), help="farads"
    )
    outer.add_argument("--source", type=number(0, 1e15, "ohm"), metavar="OHM", help="ohms")
    outer.add_argument("--floating", type=number(-1e6, 1e6, "V"), metavar="V", help="volts")
    second = one.add_mutually_exclusive_group()
    second.add_argument(
        "--second", type=FARAD, default=0.0, metavar="F", help="capacitance of the other bearing"
    )
    second.add_argument(
        "--second-factor",
        type=number(0, 100, ""),
        default=0.0,
        metavar="X",
        help="capacitance of the other bearing as a multiple of that of this bearing",
    )
    one.add_argument(
        "--background",
        type=FARAD,
        default=0.0,
        metavar="F",
        help="capacitance in parallel with the bearing (default: 0)",
    )


VOLT, HERTZ = number(-1e6, 1e6, "V"), number(1e-9, 1e12, "Hz")


def _voltage(one):
    voltage = one.add_mutually_exclusive_group()
    voltage.add_argument("--constant", type=VOLT, metavar="V", help="volts")
    voltage.add_argument(
        "--sine",
        action=each(VOLT, HERTZ),
        nargs=2,
        metavar=("V", "HZ"),
        help="amplitude and frequency",
    )
    voltage.add_argument(
        "--common-mode",
        action=each(VOLT, HERTZ, HERTZ, number(0, 1, "")),
        nargs=4,
        metavar=("V", "HZ", "HZ", "M"),
        help="common-mode voltage of an inverter: link voltage, carrier and fundamental frequency,"
        " modulation index from 0 to 1",
    )
    voltage.add_argument(
        "--table", metavar="FILE", help="text file with a time (s) and a voltage (V) in each row"
    )


def run(arguments: argparse.Namespace) -> None:
    from raceway.electric import circuit, circuit_figures
    from raceway.electric.breakdown import Breakdown
    from raceway.electric.leak import Leak

    breakdown = leak = None
    if arguments.strength is not None:
        breakdown = Breakdown(
            arguments.strength,
            arguments.surfaces,
            arguments.film_floor,
            arguments.roughness,
            arguments.arc,
        )
    if arguments.resistivity is not None or arguments.metal is not None:
        leak = Leak(arguments.resistivity, arguments.metal, arguments.metal_share)
    opened = one_run.opened(arguments)
    try:  # ValueError if options are incomplete or do not suit the run
        result = circuit.run(
            opened,
            _outer_circuit(arguments),
            breakdown,
            leak,
            points=arguments.points,
            stray=arguments.stray,
        )
    except ValueError as error:
        arguments.complain(str(error))
    if arguments.out:
        circuit_figures.write(result, arguments.out)
        if breakdown:
            # loading matplotlib takes longer than computing the circuit
            from raceway.pictures.discharges import picture

            picture(opened, result, Path(arguments.out) / "discharges.png")
    output.show(arguments, circuit_figures.figures(result), circuit_figures.table)


def _outer_circuit(arguments):
    from raceway.electric import outer

    if arguments.floating is not None:
        if _waveform(arguments):
            arguments.complain("--floating excludes a voltage of an outer circuit")
        return outer.Floating(arguments.floating, arguments.background)
    driving = _waveform(arguments)
    if driving is None:
        arguments.complain("give the voltage: --constant, --sine, --common-mode or --table")
    if arguments.motor:
        return outer.Motor(
            driving,
            *arguments.motor,
            second=arguments.second,
            second_factor=arguments.second_factor,
            capacitance=arguments.background,
        )
    return outer.Source(driving, arguments.source, arguments.background)


def _waveform(arguments):
    """Return the waveform given on the command line, or None if there is none."""
    from raceway.electric import waveforms

    if arguments.constant is not None:
        return waveforms.Constant(arguments.constant)
    if arguments.sine:
        return waveforms.Sine(*arguments.sine)
    if arguments.common_mode:
        return waveforms.CommonMode(*arguments.common_mode)
    return waveforms.read_table(arguments.table) if arguments.table else None
