# SPDX-License-Identifier: GPL-2.0-or-later
"""Predict the lines measured in nine setups of the motor bearing of Case Western Reserve University
(cwru/lines.csv). For each setup and one value of the thrust, the script finds the clearance that
explains the line measured at the first speed, and predicts the lines at the other speeds with this
clearance. It also runs the main deck with this clearance and the flaw at the first speed, and finds
the clearances for other values of the thrust. It writes build/bench/cwru.rst and
docs/images/cwru.png.

    .venv/bin/python tests/bench/cwru.py [--no-runs]
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import matplotlib
import numpy as np
import raceway
from raceway import envelope, identify, spectrum
from raceway.recordings.prediction import Model
from raceway.recordings.readings import Point, Reading, Readings

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
INPUTS = ROOT / "inputs"
TABLE = Path(__file__).with_suffix("") / "lines.csv"
PAGE, PICTURE = ROOT / "build/bench/cwru.rst", ROOT / "docs/images/cwru.png"
THRUST, LOAD, OIL, TEMPERATURE = 30.0, 10.0, "vg68", 40.0  # N, N, -, C; unknown for this motor
THRUSTS = np.array([20.0, 25.0, 30.0, 40.0, 50.0])
CLEARANCES = -5e-6, 20e-6  # m, range of the clearance
WITHIN = 2e-4  # relative standard deviation of the orders


class Setup(NamedTuple):
    """One setup of the bearing, i.e. one row of the table."""

    name: str
    line: str  # BPFI or BPFO
    orders: dict[float, float]  # keyed by nominal rpm


def setups():
    rows = csv.reader(one for one in TABLE.read_text().splitlines() if not one.startswith("#"))
    head = [float(rpm) for rpm in next(rows)[2:]]
    return [
        Setup(name, line, {rpm: float(order) for rpm, order in zip(head, orders) if order})
        for name, line, *orders in rows
    ]


def readings(setup, speeds, unknown, axial=THRUST):
    """Return the `Readings` for a setup at some of its speeds."""
    known = dict(clearance=0.0, load=LOAD, axial=axial, temperature=TEMPERATURE)
    for name in unknown:
        del known[name]
    rows = [Reading(setup.line, setup.orders[rpm], WITHIN, Point(rpm)) for rpm in speeds]
    bearing, oil = INPUTS / "bearings/6205", INPUTS / "lubricants" / OIL
    return Readings(bearing, oil, "full", known, unknown, rows)


def clearance(setup, axial=THRUST):
    """Return (clearance (`identify.Value`), state), determined from the first speed alone."""
    first = next(iter(setup.orders))
    found = identify.identify(readings(setup, [first], {"clearance": CLEARANCES}, axial))
    return found.values["clearance"], found.state


def predicted(setup, state):
    """Return the order of the line at each speed of the setup for a given `state`."""
    return np.array([one.value for one in Model(readings(setup, setup.orders, {})).predict(state)])


def flaw(setup):
    """Return the deck's variable for the flaw of a setup, and its value: a spall as long as the
    flaw's diameter, and across the groove. 6 o'clock is the direction of the load."""
    ring, mil, _, *where = setup.name.split()
    azimuth = np.deg2rad(90 - 30 * float(where[1] if where else 6))
    return f"flaw_{ring}", f"notch {azimuth:.4f} {25.4e-6 * float(mil):.4g} full 1.0e-3 2.0e-5"


def of_a_run(setup, play, folder):
    """Return the order of the line in a run with the flaw at the first speed. As in the recordings,
    the line is that of the envelope of the housing's acceleration."""
    words = dict(
        bearing="6205", lubricant=OIL, models="full", rpm=next(iter(setup.orders)), load=LOAD,
        axial=THRUST, clearance=play, passes=100, settle=10, record="summary", out=folder,
        overwrite="yes", integrator="vibration", housing="springs",
    )  # fmt: skip
    words |= [flaw(setup)]
    variables = [word for name, value in words.items() for word in ("-var", name, str(value))]
    command = ["build/liggghts", "-in", "inputs/in.6208", *variables, "-log", "none"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(done.stdout[-2000:])
    run = raceway.open(folder)
    heard = envelope.of_run(run, "ay", ring="outer")
    return next(
        one.order * one.found / one.by_cage
        for one in spectrum.lines(run, heard)
        if (one.name, one.harmonic) == (setup.line, 1)
    )


def picture(found, ridges):
    """Plot the measured minus the predicted orders, and the clearances against the thrust."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 4.2), layout="constrained")
    for k, (setup, _, orders, _) in enumerate(found.values()):
        measured = np.array(list(setup.orders.values()))
        style = dict(color=f"C{k}", marker="o" if setup.line == "BPFI" else "s", ms=4)
        left.plot(list(setup.orders), 1e4 * (measured / orders - 1), label=setup.name, **style)
        right.plot(THRUSTS, 1e6 * ridges[setup.name], label=setup.name, **style)
    left.axhspan(-3, 3, color="0.92")
    left.set(xlabel="nominal speed, rpm", ylabel="measured minus predicted, 1e-4 of the order")
    right.set(xlabel="thrust, N", ylabel="clearance from the line at 1797 rpm, µm")
    figure.legend(*right.get_legend_handles_labels(), fontsize=8, loc="outside right center")
    PICTURE.parent.mkdir(exist_ok=True)
    figure.savefig(PICTURE, dpi=110)


def main(argv):
    found, ridges = {}, {}
    head = ["set-up", "clearance, µm", "95 %", "largest error at the other speeds", "run"]
    lines = [
        f"Thrust {THRUST:g} N, {LOAD:g} N radial, {OIL} at {TEMPERATURE:g} C",
        "",
        "; ".join(head),
    ]
    with tempfile.TemporaryDirectory() as folder:
        for setup in setups():
            value, state = clearance(setup)
            orders = predicted(setup, state)
            measured = np.array(list(setup.orders.values()))
            off = np.abs(orders / measured - 1)[1:].max()
            ran = (
                np.nan if "--no-runs" in argv else of_a_run(setup, value.best, Path(folder) / "run")
            )
            found[setup.name] = setup, value, orders, ran
            ridges[setup.name] = np.array([clearance(setup, axial)[0].best for axial in THRUSTS])
            lines.append(
                f"{setup.name}; {1e6 * value.best:.1f}; {1e6 * value.low:.1f} to"
                f" {1e6 * value.high:.1f}; {off:.1e}; {ran / measured[0] - 1:+.1e}"
            )
            print(lines[-1], flush=True)
    lines += [
        "",
        "Clearance in µm for a thrust in N of " + ", ".join(f"{one:g}" for one in THRUSTS),
    ]
    lines += [f"{name}: " + ", ".join(f"{1e6 * one:.1f}" for one in ridge)
              for name, ridge in ridges.items()]  # fmt: skip
    print("\n".join(lines))
    PAGE.parent.mkdir(parents=True, exist_ok=True)
    PAGE.write_text("\n".join([*lines, ""]))
    picture(found, ridges)


if __name__ == "__main__":
    main(sys.argv[1:])
