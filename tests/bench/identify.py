# SPDX-License-Identifier: GPL-2.0-or-later
"""Count how often the 95 % intervals from `identify` contain the true values, for runs whose
clearance, loads and oil temperature are hidden from it. Write build/bench/identify.rst.

The input of `identify` is one of two sets of readings, each reading with a normally distributed
error: cage speed and capacitance at three operating points, or four lines at one point. In every
second state of the latter, the load and the oil temperature are given, too. `identify.py N` runs N
states for each set (default: 30).
"""

import sys

import numpy as np
import pandas as pd
import raceway
from deck_runs import MAIN, ROOT, run_deck
from machine import bench_file, count_asked, publish
from raceway import identify
from raceway.recordings import line_table
from raceway.recordings.readings import Point, Reading, Readings

POINTS = Point(1797.0), Point(1797.0, axial_more=300.0), Point(3000.0, load_more=100.0)
RANGES = {
    "clearance": (0.0, 15e-6),
    "axial": (20.0, 400.0),
    "load": (5.0, 300.0),
    "temperature": (25.0, 90.0),
}
# standard deviations: of the cage line (absolute), and of capacitance and other lines (relative)
ORDER, CAPACITANCE, LINE = 1e-4, 0.01, 2e-4
WANTED = 0.9  # required fraction of the true values that lie inside their intervals
LUBRICANT = "vg100"


def drawn(random, least):
    """Draw a state in which all balls are loaded; `least` is the lower limit of the ratio of radial
    load to thrust."""
    axial = float(np.exp(random.uniform(np.log(60), np.log(350))))
    return {
        "clearance": random.uniform(1e-6, 14e-6),
        "axial": axial,
        "load": random.uniform(least, least + 0.25) * axial,
        "temperature": random.uniform(30, 85),
    }


def run(state, point, folder):
    """Run the main deck for a state at an operating point."""
    loads = dict(axial=state["axial"] + point.axial_more, load=state["load"] + point.load_more)
    run_deck(
        MAIN,
        **{**state, **loads},
        bearing="6205",
        lubricant=LUBRICANT,
        models="full",
        rpm=point.rpm,
        passes=10,
        settle=20,
        record="all",
        overwrite="yes",
        out=folder,
    )
    return raceway.open(folder)


def capacitances(number, folder):
    """Return (true state, `identify.Found`), where the latter is determined from cage speed and
    capacitance at `POINTS`."""
    random = np.random.default_rng(number)
    state, rows = drawn(random, 0.25), []
    for point in POINTS:
        of = run(state, point, folder)
        order = 9 * of.motion.cage / of.motion.inner + ORDER * random.normal()
        capacitance = float(of.bearing["capacitance"].mean())
        error = CAPACITANCE * capacitance
        rows.append(Reading("BPFO", order, ORDER, point))
        rows.append(Reading("capacitance", capacitance + error * random.normal(), error, point))
    shelf = ROOT / "inputs"
    paths = shelf / "bearings/6205", shelf / "lubricants" / LUBRICANT
    return state, identify.identify(Readings(*paths, "full", {}, RANGES, rows))


def lines(number, folder):
    """Return (true state including its contact angle, `identify.Found`), where the latter is
    determined from four lines."""
    random = np.random.default_rng(1000 + number)
    state, speed = drawn(random, 0.1), POINTS[0].rpm / 60
    of = run(state, POINTS[0], folder)
    motion, contacts = of.motion, of.contacts
    angle = np.arccos(np.average(np.cos(contacts["angle"]), weights=contacts["load"]))
    cage, spin = motion.cage / motion.inner, motion.spin / motion.inner
    orders = {"bpfo_Hz": 9 * cage, "bpfi_Hz": 9 * (1 - cage), "bsf_Hz": spin, "ftf_Hz": cage}
    row = {"speed_Hz": speed}
    row |= {name: speed * one * (1 + LINE * random.normal()) for name, one in orders.items()}
    if number % 2:
        row |= {"load_N": state["load"], "temperature_C": state["temperature"]}
    table = folder.parent / "identify.csv"
    pd.DataFrame([row]).to_csv(table, index=False)
    given = line_table.read(table, "6205", lubricant=LUBRICANT, within=LINE)
    return {**state, "angle": float(angle)}, identify.identify(given)


def inside(state, found):
    """Return a dict that states for each quantity whether its true value is within its interval."""
    result = {name: one.low <= state[name] <= one.high for name, one in found.values.items()}
    if "angle" in state:
        result["angle"] = found.angle.low <= state["angle"] <= found.angle.high
    return result


def main():
    count = count_asked(30)
    page, missed = [], False
    for title, one in (
        ("Cage speed and capacitance at three points", capacitances),
        ("Four lines at one point", lines),
    ):
        page += [title, "-" * len(title), ""]
        score, rows = {}, []
        for number in range(count):
            state, found = one(number, bench_file("identify"))
            for name, right in inside(state, found).items():
                score.setdefault(name, []).append(right)
            cells = [
                f"{name} {state[name]:.3g} in {v.low:.3g} to {v.high:.3g}"
                for name, v in found.values.items()
            ]
            rows.append(f"* {'; '.join(cells)}")
            print(f"{rows[-1]} (chi {found.chi:.1f})", flush=True)
        said = [f"{name} {sum(rights)} of {len(rights)}" for name, rights in score.items()]
        page += [f"True values inside the 95 % intervals: {', '.join(said)}.", "", *rows, ""]
        print(page[-len(rows) - 3])
        missed |= any(np.mean(rights) < WANTED for rights in score.values())
    publish("Hidden states of runs", "{page}", page=page)
    sys.exit(missed)


if __name__ == "__main__":
    main()
