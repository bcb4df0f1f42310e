# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the hard cases with relative tolerances, with smoothed friction and with the models `full`,
and writes build/bench/relative_tolerance.rst.

    python tests/hard/table_relative.py
"""

import re
import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS))  # as pytest.ini does

from bench.machine import csv_table, publish  # noqa: E402

from hard import harness  # noqa: E402
from hard.harness import CASES, least_room, truths_of  # noqa: E402
from hard.table import number  # noqa: E402

PAGE = """\
The scenes of :doc:`hard_cases` and :doc:`hard_cases_full` with *relative* R of
:doc:`../fix_bearing_implicit`. The tolerance is the larger of 1 nm and R times the largest overlap.
Corrections in rejected steps are included. The figure is the largest difference in contact load
relative to the peak load, compared with the reference closest to its bound.

{parts}
"""
SHARES = (0.0, 2e-4, 5e-4)
HEAD = ["case", "corrections", *(f"fewer by, R = {share:g}" for share in SHARES[1:])]
HEAD += ["bound", *(f"figure, R = {share:g}" for share in SHARES)]


def corrections(course):
    """Return the number of corrections in the whole run, including rejected steps."""
    found = re.search(r"CONTROL .* substeps (\S+) corrections (\S+)", course.text)
    return float(found[1]) * float(found[2])


def by_smoothed_friction(name, folder):
    """Yield (course, verdict closest to its bound) for each value of R."""
    case = CASES[name]
    truths = truths_of(folder, case)
    for share in SHARES:
        words = f"{case.get('control', '')} relative {share}"
        course = harness.run(folder, case, control=words)
        yield course, least_room(course, truths, case)


def by_full(name, folder):
    """Yield (course, verdict) for each value of R with the models `full`, compared with velocity
    Verlet."""
    truth = None
    for share in SHARES:
        case = dict(CASES[name])
        case["control"] = f"{case.get('control', '')} relative {share}"
        if truth is None:
            course, truth, verdict = harness.full(folder, case)
        else:
            course, _, verdict = harness.full(folder, case, truth)
        yield course, verdict


def compared(by, folder):
    """Return table rows and, for each value of R, the number of cases that save a third and the
    number of cases that miss their bound."""
    rows, halves, misses = [], [0] * len(SHARES), [0] * len(SHARES)
    for name in CASES:
        found = list(by(name, folder))
        print(name, [corrections(course) for course, _ in found], flush=True)
        counts = [corrections(course) for course, _ in found]
        verdicts = [verdict for _, verdict in found]
        for k, verdict in enumerate(verdicts):
            halves[k] += counts[0] >= 1.5 * counts[k]
            misses[k] += not verdict.good
        rows.append(
            [
                name,
                f"{counts[0]:.0f}",
                *(f"{counts[0] / count:.2f}" for count in counts[1:]),
                number(verdicts[0].bound),
                *(number(one.figure) + ("" if one.good else " **misses**") for one in verdicts),
            ]
        )
    return rows, halves, misses


def sentence(halves, misses):
    return [
        f"R = {share:g} saves at least a third of the corrections in {half} of {len(CASES)} cases."
        f" {missed} are outside their bound."
        for share, half, missed in zip(SHARES[1:], halves[1:], misses[1:])
    ]


def main():
    with tempfile.TemporaryDirectory() as folder:
        smoothed, full = (compared(by, folder) for by in (by_smoothed_friction, by_full))
    parts = []
    for title, (rows, halves, misses) in (
        ("Smoothed friction", smoothed),
        ("Models full, compared with velocity Verlet", full),
    ):
        parts += [title, "-" * len(title), "", *sentence(halves, misses), ""]
        parts += csv_table(HEAD, rows)
    publish("Relative tolerance", PAGE, "relative_tolerance", parts=parts)


if __name__ == "__main__":
    main()
