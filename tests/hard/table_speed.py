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

from hard.harness import CASES  # noqa: E402
from hard.speed import RUNS, speed  # noqa: E402
from hard.table import number  # noqa: E402

PAGE = """\
The scenes of :doc:`hard_cases` run with host steps as long as their loads and motions allow. That
page lists the errors of these host steps. *With a record* means :doc:`../fix_bearing_record` with
the samples of that page, taken within the host steps. *Nothing written* is the same motion without
output. A factor is the simulated time divided by the wall time of the host's loop, without set-up.
It is the median of {runs} runs on a shared virtual core. Without output, {below} of {number}
scenes are slower than real time with the default settings.

{table}
"""
HEAD = ["case", "host step (s)", "samples in it", "with a record", "nothing written"]


def times(name, folder):
    """Return (row of the table, speed without output)."""
    case, within = CASES[name], CASES[name]["large"]["factor"]
    record, nothing = (speed(folder, case, writes) for writes in ("record", "nothing"))
    host_step = within * float(case["variables"]["sample"])
    return [name, number(host_step), str(within), f"{record:.2g}", f"{nothing:.2g}"], nothing


def main():
    with tempfile.TemporaryDirectory() as folder:
        timed = [times(name, folder) for name in CASES]
    below = sum(nothing < 1 for _, nothing in timed)
    table = csv_table(HEAD, [row for row, _ in timed])
    numbers = dict(runs=RUNS, below=below, number=len(timed))
    publish("Speed of the hard cases", PAGE, "hard_cases_speed", **numbers, table=table)


if __name__ == "__main__":
    main()
