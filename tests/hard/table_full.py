# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the hard cases with the models `full` with both integrators, and writes
build/bench/hard_cases_full.rst.

    python tests/hard/table_full.py
"""

import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS))  # as pytest.ini does

from bench.machine import csv_table, publish  # noqa: E402

from hard.harness import CASES, full  # noqa: E402
from hard.table import number  # noqa: E402

TITLE = "Hard cases with the models full"
PAGE = """\
The scenes of :doc:`hard_cases` with film in the gap, film branch, mixed friction, differential
slip, spin, rolling resistance and drag. The implicit step with its defaults is compared with
velocity Verlet with the same law and steps of 0.5 µs, or steps from ``tests/hard/cases.yaml``. The
figure is the largest difference in contact load over balls, raceways and samples, relative to the
peak load. For cage speed and film, the largest relative differences are given.
{missed} of {number} are outside their bound.

{table}
"""
HEAD = ["case", "figure", "bound", "cage speed", "film", "mean internal step (s)", "remark"]


def row_of(name, folder):
    case = CASES[name]
    found, truth, verdict = full(folder, case)
    if verdict is None:
        return [name, "refused", "", "", "", "", found.error or truth.error]
    remark = [verdict.remark, case.get("full", {}).get("why", "")]
    return [
        name,
        number(verdict.figure),
        number(verdict.bound),
        number(verdict.orbit) if verdict.orbit == verdict.orbit else "",
        number(verdict.film) if verdict.film == verdict.film else "",
        number(found.step),
        "; ".join(text for text in remark if text) + ("" if verdict.good else " **misses**"),
    ]


def main():
    with tempfile.TemporaryDirectory() as folder:
        rows = [row_of(name, folder) for name in CASES]
    missed = sum("**misses**" in row[-1] or row[1] == "refused" for row in rows)
    page = "hard_cases_full"
    publish(TITLE, PAGE, page, missed=missed, number=len(rows), table=csv_table(HEAD, rows))


if __name__ == "__main__":
    main()
