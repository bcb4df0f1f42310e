# SPDX-License-Identifier: GPL-2.0-or-later
"""Measures drift and energy balance of a 6208 at 5 kN and 477.5 rpm over many simulated seconds,
with few samples per ball pass."""

import re
from typing import NamedTuple

import numpy as np

from hard.harness import BALLS, Course, run

PER_PASS = 12  # samples per ball pass
PASS = 2 * np.pi / (BALLS * 0.5 * 50 * (1 - 6.3 / 30.3))  # s, kinematic duration of a ball pass
SAMPLE = PASS / PER_PASS
SETTLED = 10  # ball passes before the first second over which means are taken


class Drift(NamedTuple):
    """Means over the first and the last second, and the statistical error of their difference."""

    first: float
    last: float
    error: float

    @property
    def figure(self):
        """The relative difference between the two means."""
        return abs(self.last / self.first - 1)


def long_run(folder, seconds, control="energy yes", substeps=4) -> Course:
    """Return the course of a run that writes every sample and takes `substeps` host steps per
    sample.
    """
    case = {
        "variables": {
            "inner": "x free y free spin speed 50 force 0 -5000 0 ramp 3.0e-3",
            "sample": SAMPLE,
            "samples": round(seconds / PASS) * PER_PASS,
            "control": control,
            "substeps": substeps,
        }
    }
    return run(folder, case)


def drifts(course):
    """Return {quantity: `Drift`}. Each ball pass gives one value; the scatter of these values
    determines the error of the means."""
    size = round(1 / PASS)
    found = {}
    for name, series in {
        "ring along the load (m)": course.ring[:, 1],
        "cage speed (rad/s)": course.orbit.mean(1),
        "capacitance (F)": course.capacitance,
        "largest load (N)": course.load.max((1, 2)),
    }.items():
        passes = series[SETTLED * PER_PASS :][
            : (len(series) - 1 - SETTLED * PER_PASS) // PER_PASS * PER_PASS
        ]
        passes = passes.reshape(-1, PER_PASS).mean(1)
        first, last = passes[:size], passes[-size:]
        found[name] = Drift(
            first.mean(), last.mean(), np.hypot(first.std(ddof=1), last.std(ddof=1)) / np.sqrt(size)
        )
    return found


class Account(NamedTuple):
    """Energies since the start, J."""

    work: float  # work of loads and drives
    own: float  # energy lost by the integrator itself
    dissipated: float  # dissipated in contacts
    stored: float  # increase in the energy of motion and springs

    @property
    def figure(self):
        """Energy lost by the integrator itself, relative to the dissipation."""
        return self.own / self.dissipated


def account(course):
    """Return the `Account` for the energies of a course, from the line ENERGY printed by
    report.implicit."""
    line = r"^ENERGY work (\S+) own (\S+) dissipated (\S+) stored (\S+)"
    return Account(*map(float, re.search(line, course.text, re.MULTILINE).groups()))
