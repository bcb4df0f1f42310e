# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the speed and the error of the main deck with its record for several models, speeds and
integrators, and write build/bench/main_deck.rst.

    .venv/bin/python tests/bench/main_deck.py [ROUNDS]

All settings alternate within every round, and the medians over the rounds are used. Errors are
relative to the results of the same deck with a fine tolerance.
"""

import statistics
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr
from deck_runs import MAIN, cost, factor, run_deck
from machine import count_asked, csv_table, publish

MODELS = ("paper", "full")
ASKED = {47.75: 250.0, 477.5: 30.0, 9549.0: 2.0}  # {rpm: required real-time factor}
REFERENCE = {"implicit": 1e-10, "damping": 1e-9}  # m, tolerance
HIGH_SPEED = 9549.0  # rpm; at lower speeds the steps of `damping` would be too short
SAMPLES = 200  # per ball pass
TIMED, COMPARED = 40, 4  # ball passes
SETTLE = 4  # ball passes, also for the reference run, so that balls are at the same positions
LEAST = 0.01  # fraction of the largest load; contacts below it are not in the film error
HEADS = (
    "models",
    "rpm",
    "integrator",
    "real-time factor",
    "required",
    "without output",
    "evaluations per ball pass",
    "loads, one instant",
    "films, one instant",
    "largest load, mean",
    "smallest film, mean",
    "cage speed, mean",
    "friction power, mean",
)
PAGE = """\
The main deck was run with its defaults at 5 kN, with {samples} samples per ball pass. The speeds
are real-time factors over {timed} ball passes, with the full record and without output; they are
medians over {rounds} rounds. The times include writing all samples to the operating system.

Errors are relative, and were computed over {compared} ball passes. The reference run has a
tolerance of 0.1 nm (1 nm with *damping*), also for cage balls. Loads are compared contact by
contact, relative to the largest load. Films are compared for contacts with at least 1 % of the
largest load, and means over all {compared} ball passes.

{table}

Time budget at the required factor
----------------------------------

The real-time factor determines the time that is available per sample. A recorded sample requires
one evaluation of all contacts, the computation of its columns, and writing to the file; the steps
require further evaluations. All times are in microseconds per sample, with the faster integrator:

{budget}

{machine}
"""


class Scene(NamedTuple):
    """One of the settings of the main deck that are measured."""

    models: str
    rpm: float
    integrator: str


def integrators(rpm):
    """Return the integrators to be measured at a speed."""
    return [name for name in REFERENCE if name == "implicit" or rpm >= HIGH_SPEED]


def played(scene, folder, **more):
    """Run a scene with its output in `folder`, and return the folder."""
    run_deck(
        MAIN,
        out=folder,
        overwrite="yes",
        models=scene.models,
        rpm=scene.rpm,
        integrator=scene.integrator,
        settle=SETTLE,
        **more,
    )
    return folder


def recorded(folder):
    """Return the quantities of a run to be compared: (loads, films, {name: mean})."""
    with xr.open_dataset(folder / "record.nc", decode_times=False) as record:
        inner = record.bearing_load_inner
        means = {
            "largest load": inner,
            "least film": record.bearing_h_min,
            "cage speed": record.bearing_cage_speed,
            "friction power": record.bearing_friction_power,
        }
        return (
            np.nan_to_num(record["load"].values),
            record["h_min"].values,
            {name: float(values.mean()) for name, values in means.items()},
        )


def errors(found, truth):
    """Return the errors of loads and films at single instants, followed by the errors of their
    means."""
    largest = truth[0].max()
    both = (found[0] > LEAST * largest) & (truth[0] > LEAST * largest)
    return [
        np.abs(found[0] - truth[0]).max() / largest,
        np.abs(found[1][both] / truth[1][both] - 1).max(),
        *(abs(found[2][name] / mean - 1) for name, mean in truth[2].items()),
    ]


def compared(scene, folder):
    """Return the errors in a scene relative to the same scene with a fine tolerance."""
    fine = REFERENCE[scene.integrator]
    truth = recorded(played(scene, folder, passes=COMPARED, tolerance=fine, cage_tolerance=fine))
    return errors(recorded(played(scene, folder, passes=COMPARED)), truth)


def measured(scenes, folder, rounds):
    """Return ({(scene, record): real-time factor}, {scene: evaluations})."""
    speeds, evaluations = {}, {}
    for number in range(rounds):
        print(f"round {number + 1} of {rounds}", flush=True)
        for scene in scenes:
            for record in ("all", "none"):
                played(scene, folder, passes=TIMED, record=record)
                speeds.setdefault((scene, record), []).append(factor(folder))
                evaluations[scene] = cost(folder)["evaluations"]
    medians = {key: statistics.median(found) for key, found in speeds.items()}
    return medians, evaluations


def main():
    """Measure, print the results and write the page."""
    rounds = count_asked(5)
    scenes = [Scene(m, rpm, i) for m in MODELS for rpm in ASKED for i in integrators(rpm)]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "run"
        wrong = {scene: compared(scene, folder) for scene in scenes}
        speeds, evaluations = measured(scenes, folder, rounds)
        simulated = {}
        for rpm in ASKED:
            played(Scene("paper", rpm, "implicit"), folder, passes=COMPARED)
            simulated[rpm] = cost(folder)["simulated_s"] / (COMPARED * SAMPLES)
    rows = [
        (
            f"``{scene.models}``",
            f"{scene.rpm:g}",
            scene.integrator,
            f"{speeds[scene, 'all']:.3g}",
            f"{ASKED[scene.rpm]:g}",
            f"{speeds[scene, 'none']:.3g}",
            f"{evaluations[scene] / TIMED:.0f}",
            *(f"{error:.0e}" for error in wrong[scene]),
        )
        for scene in scenes
    ]
    budget = []
    for models in MODELS:
        for rpm in ASKED:
            best = max(
                (Scene(models, rpm, i) for i in integrators(rpm)), key=lambda s: speeds[s, "all"]
            )
            whole, steps = (1e6 * simulated[rpm] / speeds[best, r] for r in ("all", "none"))
            left = 1e6 * simulated[rpm] / ASKED[rpm]
            times = (f"{value:.1f}" for value in (left, whole, steps, whole - steps))
            budget.append((f"``{models}``", f"{rpm:g}", *times, best.integrator))
    heads = ("models", "rpm", "available", "total", "steps", "record", "integrator")
    publish(
        "Speed and error of the main deck",
        PAGE,
        samples=SAMPLES,
        timed=TIMED,
        rounds=rounds,
        compared=COMPARED,
        table=csv_table(HEADS, rows),
        budget=csv_table(heads, budget),
    )


if __name__ == "__main__":
    main()
