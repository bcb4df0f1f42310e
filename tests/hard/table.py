# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the hard cases and their references, the references also with half their step, and writes
build/bench/hard_cases.rst.

    python tests/hard/table.py          # all
    python tests/hard/table.py last     # only the last part
"""

import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS))  # as pytest.ini does

from bench.machine import bench_file, csv_table, publish  # noqa: E402

from hard import harness, longrun  # noqa: E402
from hard.harness import BOUNDS, CASES, EXPLICIT, judge, reference  # noqa: E402

TARGET = bench_file("hard_cases.rst")
PAGE = """\
These scenes are hard to integrate; they run with :doc:`../fix_bearing_implicit` and its default
settings, one host step per sample. The bearing is a 6208, in mineral oil unless stated otherwise.
``tests/hard/cases.yaml`` lists the scenes, the bounds with their reasons, and the cases that miss
their bound. Of {number} figures, {missed} are outside their bound.

The figure is the largest difference in contact load over balls, raceways and samples, relative to
the peak load, starting from the sample that the case specifies. *Whole course* is the same figure
starting from the first sample. Remarks give the largest differences in cage speed and film.

Quasi-static cases are compared with statics, transients over their whole course. A chaotic case is
compared up to a whirl of the ring (:ref:`known-limits`), by time averages and their statistical
errors. :doc:`hard_cases_speed` lists the speeds.

{table}
Bounds:

{bounds}

Deliberately large steps
------------------------

The control refines a host step that is too large, or the run stops with an error. Verlet runs
at 30 and 100 times the step of its reference: the package must reject it, or the result must
remain sensible.

{large}
{last}
"""
LAST = "Thirty seconds"  # heading of the last part
NAMES = {
    "statics": "statics",
    "verlet": "Verlet, same friction",
    "fine": "itself, 0.1 nm",
    "history": "Verlet, history spring",
}
HEAD = [
    "case",
    "scene",
    "reference (change with half its step)",
    "figure",
    "bound",
    "whole course",
    "mean internal step (s)",
    "remark",
]
LARGE = ["case", "host step (s)", "internal step (s)", "figure", "remark"]
LARGE += [f"Verlet x {k}" for k in EXPLICIT]


def number(value):
    return f"{value:.1e}"


def rows_of(name, folder):
    """Return the table rows of one case, one row for each reference, and the names of references
    that have not converged."""
    case, unsure, rows = CASES[name], [], []
    found = harness.run(folder, case)
    print(name, found.error, flush=True)
    misses = case.get("misses", {})
    if found.error:
        return [[name, case["scene"], "", "refused", "", "", "", found.error]], []
    for kind, words in case["references"].items():
        whole = own = ""
        if kind == "statics":
            verdict = harness.judge_statics(found, case)
        else:
            truth = reference(kind, folder, case)
            verdict = judge(found, truth, case, words)
            if not case.get("chaotic"):
                finer = reference(kind, folder, case, refine=2)
                change = judge(truth, finer, case, words).figure
                own, whole = f" ({number(change)})", number(harness.compare(found, truth).load)
                if change > 0.1 * verdict.bound:
                    unsure.append(
                        f"{name}, {kind}: halving its step changes it by {change:.1e}, with a bound"
                        f" of {verdict.bound:.1e}"
                    )
        remark = [verdict.remark] if verdict.remark else []
        if verdict.orbit == verdict.orbit:
            remark.append(
                f"cage speed {number(verdict.orbit)}"
                + (f", film {number(verdict.film)}" if verdict.film == verdict.film else "")
            )
        if not verdict.good:
            remark.append(f"**misses**: {misses.get(kind, 'not known before')}")
        rows.append(
            [
                name,
                case["scene"],
                NAMES[kind] + own,
                number(verdict.figure),
                number(verdict.bound),
                whole,
                number(found.step),
                "; ".join(remark),
            ]
        )
    return rows, unsure


def too_large(name, folder):
    """Return the results of a case with host steps and velocity Verlet steps that are deliberately
    too large."""
    case = CASES[name]
    truth_kind, kind = harness.yardsticks(case)
    found, truth = harness.coarse(folder, case), reference(truth_kind, folder, case)
    cells = [name, number(case["large"]["factor"] * float(case["variables"]["sample"]))]
    if found.error:
        cells += ["", "", found.error]
    else:
        cells += [number(found.step), str(harness.judge_coarse(found, truth, case)), ""]
    if "large" in case.get("misses", {}):
        cells[-1] = f"**misses**: {case['misses']['large']}"
    truth = truth if kind == truth_kind else reference(kind, folder, case)
    for factor in EXPLICIT:
        course = reference(kind, folder, case, refine=1 / factor)
        if course.error:
            cells.append("refused")
            continue
        verdict = judge(course, truth, case, dict(case["references"][kind], bound="nonsense"))
        cells.append(
            f"{number(verdict.figure)}{', warned' if 'WARNING: timestep' in course.text else ''}"
            f"{'' if verdict.good else ', **nonsense**'}"
        )
    return cells


def thirty_seconds(folder):
    """Return the lines of the last part of the page, on drift and energy of a long run."""
    course = longrun.long_run(folder, 30)
    if course.error:
        return [LAST, "-" * len(LAST), "", f"The run of 30 s stopped: {course.error}", ""]
    rows = [
        [
            name,
            f"{d.first:.8g}",
            f"{d.last:.8g}",
            number(d.figure),
            number(abs(3 * d.error / d.first)),
        ]
        for name, d in longrun.drifts(course).items()
    ]
    energy = longrun.account(course)
    said = (
        f" Loads and drives did {energy.work:.4g} J of work. Contacts dissipated"
        f" {energy.dissipated:.4g} J. The integrator itself lost {energy.own:.3g} J,"
        f" {abs(energy.figure):.1e} of the dissipation."
    )
    return [
        LAST,
        "-" * len(LAST),
        "",
        "The bearing is a 6208 at 5 kN and 477.5 rpm."
        f" {course.simulated:.1f} s took {course.wall:.1f} s of wall time"
        f" ({course.simulated / course.wall:.0f} times real time), with {longrun.PER_PASS}"
        f" samples written per ball pass. The mean internal step was {number(course.step)} s."
        f" {course.refused} steps were rejected.{said}",
        "",
        *csv_table(
            ["mean over a second", "first", "last", "relative difference", "3 statistical errors"],
            rows,
        ),
    ]


def last_part():
    """Rewrite the last part of the page."""
    page = TARGET.read_text()
    with tempfile.TemporaryDirectory() as folder:
        part = thirty_seconds(folder)
    TARGET.write_text(page[: page.index(LAST)] + "\n".join(part))


def main():
    rows, large, unsure = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        for name in CASES:
            more, doubts = rows_of(name, folder)
            rows, unsure = rows + more, unsure + doubts
            large.append(too_large(name, folder))
        last = thirty_seconds(folder)
    missed = sum("**misses**" in row[-1] for row in rows)
    bounds = [f"* {name}, {number(one['value'])}: {one['why']}." for name, one in BOUNDS.items()]
    publish(
        "Hard cases",
        PAGE,
        TARGET.stem,
        number=len(rows),
        missed=missed,
        table=csv_table(HEAD, rows),
        bounds=bounds,
        large=csv_table(LARGE, large),
        last=last,
    )
    if unsure:
        sys.exit("References that are not converged:\n" + "\n".join(unsure))


if __name__ == "__main__":
    last_part() if sys.argv[1:] == ["last"] else main()
