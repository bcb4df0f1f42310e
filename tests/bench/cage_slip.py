# SPDX-License-Identifier: GPL-2.0-or-later
"""Slip of a cage ring compared with measured bearings; writes build/bench/cage_slip.rst.

    .venv/bin/python tests/bench/cage_slip.py [--print] [--guide balls|outer]

Measured values: slip from the outer-race ball pass frequency of MFPT's bearing (NICE, 8 balls), and
medians of the envelope's lines for Paderborn's 6203. Clearance, conformity, oil and play of both
are unpublished: each column assumes one play. Exit code 1 unless slip falls with load in every
column and the cage of a bearing with all balls loaded keeps its kinematic order.
"""

import itertools
import sys
import tempfile
from pathlib import Path

from machine import bench_file, csv_table

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))  # as pytest.ini does

from host import liggghts  # noqa: E402
from raceway.runs.run import Run  # noqa: E402

TARGET = bench_file("cage_slip.rst")
DECK = "inputs/in.cage_ring"
SHARES = (0.02, 0.025, 0.03, 0.035)  # play divided by the ball diameter
# balls, ball and pitch diameter (m), inner and outer conformity, diametral clearance (m)
MFPT = (8, 5.969e-3, 31.62e-3, 0.515, 0.53, 15e-6)
SKF_6203 = (8, 6.75e-3, 28.5e-3, 0.52, 0.53, 5e-6)
SKF_6205 = (9, 7.94e-3, 39.04e-3, 0.515, 0.53, 8e-6)
# N and slip in % of the measured outer-race series
MEASURED = {111: 0.60, 222: 0.48, 445: 0.45, 667: 0.46, 890: 0.28, 1112: 0.05, 1334: -0.22}
PADERBORN = {400: 0.16, 1000: 0.05}
PASSES = 48  # six turns of the cage


def bearing(folder, balls, ball, pitch, inner, outer):
    """A bearing data file: the 6208's with these values replaced."""
    own = dict(
        balls=balls,
        ball_diameter=ball,
        inner_radius=(pitch - ball) / 2,
        outer_radius=(pitch + ball) / 2,
        inner_groove=inner * ball,
        outer_groove=outer * ball,
        inner_shoulder_diameter=pitch - 0.6 * ball,
        outer_shoulder_diameter=pitch + 0.6 * ball,
    )
    lines = [f"variable {name} index {value:.10g}" for name, value in own.items()]
    for line in (ROOT / "inputs/bearings/6208").read_text().splitlines():
        word = line.split()
        if word[:1] == ["variable"] and word[1] not in own:
            lines.append(line)
    file = folder / f"bearing_{balls}_{ball:g}_{inner:g}_{outer:g}"
    file.write_text("\n".join(lines) + "\n")
    return file


def run(folder, data, *, passes=PASSES, **variables):
    *size, clearance = data
    out = folder / "run"
    settings = dict(
        bearing=bearing(folder, *size),
        clearance=clearance,
        passes=passes,
        settle=16,
        viscosity=0.08,
        overwrite="yes",
    )
    outcome = liggghts(DECK, out=out, **settings | variables)
    if outcome.code:
        raise SystemExit(outcome.error)
    return Run(out).summary()


def slips(folder, data, loads, rpm, **variables):
    """% by load and play."""
    play = [share * data[1] for share in SHARES]
    found = {}
    for load in loads:
        found[load] = [
            100 * run(folder, data, load=load, rpm=rpm, cage_play=j, **variables)["cage_slip"]
            for j in play
        ]
        print(load, *(f"{slip:.3f}" for slip in found[load]), flush=True)
    return found


def table(title, rows, measured):
    head = ["load, N", *(f"{share:g} D" for share in SHARES), "measured"]
    body = [
        [f"{load:g}", *(f"{value:.2f}" for value in found), f"{measured[load]:.2f}"]
        for load, found in rows.items()
    ]
    return [title, "", *csv_table(head, body)]


def main(argv):
    guide = argv[argv.index("--guide") + 1] if "--guide" in argv else "balls"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        land = {}
        if guide == "outer":
            land = dict(cage_guide="outer", cage_clearance=0.1e-3, cage_width=1e-3)
        text, good = [], True
        for title, data, measured, rpm in (
            ("Slip, %, MFPT's geometry, 1485 rpm", MFPT, MEASURED, 1485),
            ("Slip, %, 6203, 1500 rpm", SKF_6203, PADERBORN, 1500),
        ):
            if land:
                land["cage_land"] = data[2] / 2 + 0.28 * data[1]
            rows = slips(folder, data, measured, rpm, **land)
            text += table(title, rows, measured)
            first, last = list(rows.values())[0], list(rows.values())[-1]
            good &= all(a > b for a, b in zip(first, last, strict=True))
        order = {}
        for rpm, (axial, load) in itertools.product((1797, 1730), ((20, 10), (50, 30), (50, 100))):
            found = run(folder, SKF_6205, load=load, axial=axial, rpm=rpm)
            order.setdefault((axial, load), []).append(found["cage_slip"])
        change = {key: abs(a - b) for key, (a, b) in order.items()}
        text += ["Slip of a 6205 under thrust, and its change from 1797 to 1730 rpm", ""]
        text += csv_table(
            ["thrust, N", "radial load, N", "slip, 1", "change, 1"],
            [[f"{k[0]}", f"{k[1]}", f"{order[k][0]:.5f}", f"{v:.1e}"] for k, v in change.items()],
        )
        good &= max(change[20, 10], change[50, 30]) < 1e-4
    print("\n".join(text))
    if "--print" not in argv:
        TARGET.write_text("\n".join(text))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
