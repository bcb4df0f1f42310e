# SPDX-License-Identifier: GPL-2.0-or-later
"""Measures the speed of the hard cases with host steps as long as their loads allow, with a record
and without output, and judges settings with such host steps."""

import re
import statistics

from host import liggghts

from hard.harness import DECK, coarse, judge_coarse, least_room, run

RUNS = 3  # number of repeated runs, of which the median is used


def speed(folder, case, writes):
    """Return the simulated time divided by the wall time of the host's loop for a case with the
    output `writes` (record or nothing) and the host steps specified by `large`."""
    samples, sample = case["variables"]["samples"], float(case["variables"]["sample"])
    within = case["large"]["factor"]
    variables = {
        **case["variables"],
        "control": case.get("control", ""),
        "samples": samples // within,
        "sample": sample * within,
        "within": within,
        "writes": writes,
    }
    walls = []
    for _ in range(RUNS):
        outcome = liggghts(DECK, out=folder, **variables)
        assert outcome.code == 0, outcome.error
        walls.append(float(re.findall(r"Loop time of (\S+) on", outcome.text)[-1]))
    return variables["samples"] * variables["sample"] / statistics.median(walls)


def nearest(folder, case, control, truths):
    """Return (`Verdict` closest to its bound, mean internal step in s) with the keywords `control`.
    The verdict covers a run with one host step per sample and a run with the host steps of `large`;
    the mean step is that of the run with `large`."""
    case = dict(case, control=control)
    found, long = run(folder, case), coarse(folder, case)
    assert not found.error and not long.error, found.error or long.error
    verdicts = least_room(found, truths, case), judge_coarse(long, truths["verlet"], case)
    return max(verdicts, key=lambda verdict: verdict.share), long.step
