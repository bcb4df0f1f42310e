# SPDX-License-Identifier: GPL-2.0-or-later
"""Measures the speed of the hard cases with host steps as long as their loads allow, with a record
and without output, and the steps chosen by the error control relative to the natural periods."""

import re
import statistics
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr
from host import liggghts

from hard.harness import DECK, coarse, first_samples, judge, least_room, run

RUNS = 3  # number of repeated runs, of which the median is used
# in ascending order, m: the coarsest tolerance that meets the bounds gives the steps needed per
# period
TOLERANCES = (1e-9, 2e-9, 5e-9, 1e-8, 2e-8, 5e-8, 1e-7, 2e-7)


class Speed(NamedTuple):
    factor: float  # simulated time divided by wall time of the host's loop, without set-up
    step: float  # mean internal step, s


def speed(folder, case, writes, control=None):
    """Return the `Speed` of a case with the output `writes` (record or nothing) and the host steps
    specified by `large`."""
    samples, sample = case["variables"]["samples"], float(case["variables"]["sample"])
    within = case["large"]["factor"]
    variables = {
        **case["variables"],
        "control": case.get("control", "") if control is None else control,
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
    step = float(re.search(r"CONTROL mean (\S+)", outcome.text)[1])
    return Speed(variables["samples"] * variables["sample"] / statistics.median(walls), step)


def resonance(folder):
    """Return the shortest period (s), in the record of the last run, of a ball that vibrates on the
    springs of its two contacts."""
    with xr.open_dataset(Path(folder) / "record" / "record.nc") as record:
        load, overlap = record["load"].values, record["overlap"].values
        mass = float(record["ball_mass"].values.flat[0])
        raceways = record["load"].dims.index("raceway")
    closed = (load > 0) & (overlap > 0)
    stiffness = np.divide(1.5 * load, overlap, out=np.zeros_like(load), where=closed)
    return 2 * np.pi * np.sqrt(mass / stiffness.sum(axis=raceways).max())


def nearest(folder, case, control, truths):
    """Return (`Verdict` closest to its bound, mean internal step in s) with the keywords `control`.
    The verdict covers a run with one host step per sample and a run with the host steps of `large`;
    the mean step is that of the run with `large`. Return None if a run stopped."""
    case = dict(case, control=control)
    found, long = run(folder, case), coarse(folder, case)
    if found.error or long.error:
        return None
    factor = case["large"]["factor"]
    truth = first_samples(truths["verlet"], factor * (len(long.load) - 1))
    verdicts = [
        least_room(found, truths, case),
        judge(long, truth, case, case["large"], factor),
    ]
    return max(verdicts, key=lambda verdict: verdict.figure / verdict.bound), long.step


def coarsest(folder, case, truths):
    """Return (tolerance in m, mean internal step in s) for the coarsest of `TOLERANCES` up to which
    all bounds are met."""
    held = None
    for tolerance in TOLERANCES:
        found = nearest(folder, case, f"tolerance {tolerance}", truths)
        if found is None or not found[0].good:
            break
        held = tolerance, found[1]
    return held
