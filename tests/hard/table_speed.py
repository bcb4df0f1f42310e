# SPDX-License-Identifier: GPL-2.0-or-later
"""Times the hard cases with a record and without output, and writes
build/bench/hard_cases_speed.rst.

    python tests/hard/table_speed.py
"""

import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS))  # as pytest.ini does

from bench.machine import csv_table, publish  # noqa: E402

from hard.harness import CASES, truths_of  # noqa: E402
from hard.speed import RUNS, coarsest, nearest, resonance, speed  # noqa: E402
from hard.table import number  # noqa: E402

PAGE = """\
The scenes of :doc:`hard_cases` run with host steps as long as their loads and motions allow. That
page lists the errors of these host steps. *With a record* means :doc:`../fix_bearing_record` with
the samples of that page, taken within the host steps. *Nothing written* is the same motion without
output. A factor is the simulated time divided by the wall time of the host's loop, without set-up.
It is the median of {runs} runs on a shared virtual core. Without output, {below} of {number}
scenes are slower than real time with the default settings.

{table}

Where vibration limits the step
-------------------------------

Balls between two loaded contacts vibrate. *Contact resonance* is the shortest period of a ball on
the springs of its two contacts in the run. The default tolerance follows this motion with more
steps than the bounds require. *Coarsest tolerance* is the largest of the series 1, 2, 5, 10, 20,
50, 100 and 200 nm up to which all bounds are met. The series was run with one host step per sample,
and with the host steps above; the steps per period are given for the latter. Steps as long as the
period damp the vibration, while the loads stay within the bound.

*Words* are the keywords of :doc:`../fix_bearing_implicit` that meet the same bounds faster. The
figure closest to its bound is given, for both lengths of host steps.

{slow}
"""
HEAD = ["case", "host step (s)", "samples in it", "with a record", "nothing written"]
SLOW = [
    "case",
    "contact resonance (s)",
    "steps per period, default",
    "coarsest sufficient tolerance (m)",
    "steps per period there",
    "words",
    "steps per period with it",
    "figure",
    "bound",
    "with a record",
    "nothing written",
]


def times(name, folder):
    """Return (row of the first table, `Speed` without output, period of the contact resonance in
    s)."""
    case, within = CASES[name], CASES[name]["large"]["factor"]
    record = speed(folder, case, "record")
    period = resonance(folder)
    nothing = speed(folder, case, "nothing")
    host_step = within * float(case["variables"]["sample"])
    factors = [f"{one.factor:.2g}" for one in (record, nothing)]
    return [name, number(host_step), str(within), *factors], nothing, period


def fast(name, folder):
    """Return [`Speed` with a record, `Speed` without output] with the faster settings."""
    words = CASES[name]["fast"]
    return [speed(folder, CASES[name], writes, words) for writes in ("record", "nothing")]


def needs(name, folder, default, period, faster):
    """Return a row of the second table."""
    case = CASES[name]
    truths = truths_of(folder, case)
    tolerance, step = coarsest(folder, case, truths)
    verdict, _ = nearest(folder, case, case["fast"], truths)
    return [
        name,
        number(period),
        f"{period / default.step:.1f}",
        number(tolerance),
        f"{period / step:.1f}",
        f"*{case['fast']}*",
        f"{period / faster[1].step:.1f}",
        number(verdict.figure) + ("" if verdict.good else " **misses**"),
        number(verdict.bound),
        *(f"{one.factor:.2g}" for one in faster),
    ]


def main():
    with tempfile.TemporaryDirectory() as folder:
        timed = {name: times(name, folder) for name in CASES}
        faster = {name: fast(name, folder) for name in CASES if "fast" in CASES[name]}
        print("timed", flush=True)
        slow = [needs(name, folder, *timed[name][1:], faster[name]) for name in faster]
    below = sum(nothing.factor < 1 for _, nothing, _ in timed.values())
    table = csv_table(HEAD, [row for row, _, _ in timed.values()])
    numbers = dict(runs=RUNS, below=below, number=len(timed))
    tables = dict(table=table, slow=csv_table(SLOW, slow))
    publish("Speed of the hard cases", PAGE, "hard_cases_speed", **numbers, **tables)


if __name__ == "__main__":
    main()
