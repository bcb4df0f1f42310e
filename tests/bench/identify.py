# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs with hidden clearance, loads and oil temperature: how often the true values lie inside the
95 % intervals of `identify`. Writes build/bench/identify.rst.

Each state is run at three operating points. `identify` sees only cage speed and capacitance, each
with a random error of one standard deviation. `identify.py N` runs N states (default 30).
"""

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import raceway
from raceway import identify
from raceway.recordings.readings import Point, Reading, Readings

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "build/bench/identify.rst"
POINTS = Point(1797.0), Point(1797.0, axial_more=300.0), Point(3000.0, load_more=100.0)
RANGES = {
    "clearance": (0.0, 15e-6),
    "axial": (20.0, 400.0),
    "load": (5.0, 300.0),
    "temperature": (25.0, 90.0),
}
# standard deviations of the frequency line (absolute) and the capacitance (relative)
ORDER, CAPACITANCE = 1e-4, 0.01
WANTED = 0.9  # ranges of the states


def drawn(random):
    """A state with all balls loaded."""
    axial = float(np.exp(random.uniform(np.log(60), np.log(350))))
    return {
        "clearance": random.uniform(1e-6, 14e-6),
        "axial": axial,
        "load": random.uniform(0.25, 0.5) * axial,
        "temperature": random.uniform(30, 85),
    }


def run(state, point, folder):
    """(BPFO order, mean capacitance) of a run at an operating point."""
    words = dict(
        state,
        axial=state["axial"] + point.axial_more,
        load=state["load"] + point.load_more,
        bearing="6205",
        lubricant="vg100",
        models="full",
        rpm=point.rpm,
        passes=10,
        settle=20,
        record="summary",
        overwrite="yes",
        out=folder,
    )
    variables = [word for name, value in words.items() for word in ("-var", name, str(value))]
    command = ["build/liggghts", "-in", "inputs/in.6208", *variables, "-log", "none"]
    subprocess.run([*command, "-screen", "none"], cwd=ROOT, check=True)
    of = raceway.open(folder)
    return 9 * of.motion.cage / of.motion.inner, float(of.bearing["capacitance"].mean())


def one(number, folder):
    """(true state, `identify.Found`) of a state by its number."""
    random = np.random.default_rng(number)
    state, rows = drawn(random), []
    for point in POINTS:
        order, capacitance = run(state, point, folder)
        error = CAPACITANCE * capacitance
        order += ORDER * random.normal()
        rows.append(Reading("BPFO", order, ORDER, point))
        rows.append(Reading("capacitance", capacitance + error * random.normal(), error, point))
    shelf = ROOT / "inputs"
    paths = shelf / "bearings/6205", shelf / "lubricants/vg100"
    return state, identify.identify(Readings(*paths, "full", {}, RANGES, rows))


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    PAGE.parent.mkdir(parents=True, exist_ok=True)
    lines, good = [], 0
    for number in range(count):
        start = time.perf_counter()
        state, found = one(number, PAGE.parent / "identify")
        inside = all(v.low <= state[name] <= v.high for name, v in found.values.items())
        good += inside
        cells = [
            f"{name} {state[name]:.3g} in {v.low:.3g} to {v.high:.3g}"
            for name, v in found.values.items()
        ]
        took = time.perf_counter() - start
        lines.append(f"* {'inside' if inside else 'OUTSIDE'}: {'; '.join(cells)}")
        print(f"{lines[-1]} (chi {found.chi:.1f}, {took:.0f} s)", flush=True)
    said = f"{good} of {count} states lie inside the stated 95 % in all four unknowns."
    PAGE.write_text(
        "\n".join(["Hidden states of runs", "=====================", "", said, "", *lines, ""])
    )
    print(said)
    sys.exit(good < WANTED * count)


if __name__ == "__main__":
    main()
