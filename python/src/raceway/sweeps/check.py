# SPDX-License-Identifier: GPL-2.0-or-later
"""Estimate the numerical error of a run by repeating it with finer integration, with more samples,
and with longer settling, during which the results may wander.

The repeats are handled like the points of a sweep, in the folder `check` of the run; they can be
stopped and resumed. `check.json` contains the results.
"""

import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from raceway import files
from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.runs.flaws import by_ball, by_raceway
from raceway.runs.settings import deck_words
from raceway.runs.settling import KEYS, ORBIT
from raceway.runs.summary import CHECK, identity, summary
from raceway.runs.tables import RunTables
from raceway.runs.warming import heated
from raceway.sweeps.point_run import FAILED, FINISHED, run_point

FINER = 0.1  # factor on the tolerance; for velocity Verlet, the time step is halved instead
MORE = 2  # factor on the number of samples
LONGER = 100  # additional ball passes of settling; slow drifts of light balls take this long
IMPLICIT = ("implicit", "damping", "vibration")  # integrators with a tolerance
TOLERANCES = ("tolerance", "relative_tolerance", "cage_tolerance")
OF_IMPLICIT = (*TOLERANCES, "step_error", "step_control")
# keys of costs and settings, for which no error is computed
LEFT_OUT = (
    *("wall_s", "real_time_factor", "processor_s", "evaluations"),
    *("step_s", "simulated_s", "passes"),
    *("load_N", "axial_N", "rpm", "clearance_m", "viscosity_Pa_s"),
    *("pressure_viscosity_per_Pa", "permittivity", "roughness_m"),
    *KEYS.values(),
    ORBIT,
)
# results that may wander although the run has settled, with the setting that says how far they do,
# relative to their value
WANDERING = {
    "friction_torque_N_m": "wander_torque",
    "power_loss_W": "wander_torque",
    "cage_speed_rad_s": "wander_cage_speed",
}
# settings that must be the same in a repeat; if they differ, the run did not record some -var value
SAME = (
    *("load_N", "rpm", "load_azimuth_rad", "axial_N", "moment_x_N_m", "moment_y_N_m"),
    *("unbalance_kg_m", "clearance_m", "balls", "ball_diameter_m", "inner_radius_m"),
    *("outer_radius_m", "inner_groove_m", "outer_groove_m", "inner_shoulder_diameter_m"),
    *("outer_shoulder_diameter_m", "cage_ball_diameter_m", "ball_mass_kg", "ball_young_Pa"),
    *("ball_poisson", "ring_young_Pa", "ring_poisson", "viscosity_Pa_s"),
    *("pressure_viscosity_per_Pa", "permittivity", "roughness_m", "flaws"),
)
# results, not data, of a run whose temperatures follow from its losses
OF_HEAT = ("viscosity_Pa_s", "pressure_viscosity_per_Pa", "permittivity")


def variables(tables: RunTables) -> dict[str, str]:
    """Return the main deck's variables of the run `tables`.

    Raise `RacewayError` if the run did not record them.
    """
    known = deck_words(tables.settings)
    if not known:
        raise RacewayError(
            f"{tables.folder} does not have the deck's variables: only runs of inputs/in.6208 with"
            " a record can be repeated"
        )
    given = str(tables.settings.get("given_data", "none"))  # bearing or lubricant data
    known |= dict(word.split("=", 1) for word in given.split(",") if given != "none")
    for raceway, words in by_raceway(tables.settings).items():
        known[f"flaw_{raceway}"] = words
    if balls := by_ball(tables.settings):
        known["flaw_ball"] = next(iter(balls.values()))
        known["flawed_ball"] = " ".join(map(str, balls))
    if tables.settings.get("orbit") == "found":
        known["settle"] = "orbit"
        return {**known, "passes": f"{tables.settings['passes']:.15g}"}
    known.pop("settled", None)  # the repeats settle for the same time as the run
    if known.get("settle") in ("auto", "orbit"):
        known["settle"] = f"{tables.settings['settled_passes']:.15g}"
    return {**known, "passes": f"{tables.settings['passes']:.15g}"}


def repeats(tables: RunTables) -> dict[str, dict[str, str]]:
    """Return {"integration": ..., "sampling": ..., "settling": ...} with the variables of the
    repeats."""
    own = variables(tables)
    finer = dict(own)
    if own["integrator"] in IMPLICIT:
        for name in TOLERANCES:
            if name in own:
                finer[name] = f"{FINER * float(own[name]):.15g}"
    else:
        finer["step"] = f"{0.5 * tables.settings['step_s']:.15g}"
        for name in OF_IMPLICIT:
            finer.pop(name, None)
    # The integrator `vibration` has one step per sample, so more samples also mean a finer step.
    count = "oversampling" if "oversampling" in own else "samples"
    sampled = {**own, count: f"{MORE * int(float(own[count]))}"}
    if own["integrator"] not in IMPLICIT:
        for name in OF_IMPLICIT:
            sampled.pop(name, None)
    settled = dict(sampled)
    settled[count] = own[count]
    if own["settle"] == "orbit":
        settled["settled"] = f"{FINER * float(own['settled']):.15g}"
    else:
        settled["settle"] = f"{float(own['settle']) + LONGER:.15g}"
    return {"integration": finer, "sampling": sampled, "settling": settled}


def check(folder: FilePath, command: Sequence[str], more: Mapping[str, str]) -> dict[str, Any]:
    """Return the numerical errors of the results of a run in SI units.

    The errors are returned as {key: {"integration": error, "sampling": error, "settling": error}}
    and also written to `check.json` in `folder`. `command` is a list of program, options and deck.
    `more` contains variables of the run in addition to those that it recorded. An error is the
    difference of a result between the run and its repeat. For the results in `WANDERING`, there is
    also the error "wandering", the largest difference between two means over as many ball passes as
    the run measures, in the last half of the longer settling. Raise `RacewayError` if a repeat
    fails or if its settings differ from those of the run.
    """
    tables = RunTables(folder)
    variables(tables)  # raises an error for a run without variables, which cannot be repeated
    figures, errors = summary(tables), {}
    same = [key for key in SAME if not (key in OF_HEAT and heated(tables))]
    for name, words in repeats(tables).items():
        place = Path(folder) / "check" / name
        status, message = run_point(place, {**words, **more}, command, retry=True)
        if status != FINISHED:
            why = message if status == FAILED else f"{status}: {message}"
            raise RacewayError(f"{place}: {why}")
        again = RunTables(place)
        for key in same:
            before, now = (one.settings.get(key) for one in (tables, again))
            if before != now:
                raise RacewayError(
                    f"{place} has {key} {now}, but {folder} has {before}: give --var for data that"
                    " were given to the run"
                )
        for key, value in summary(again).items():
            if key in LEFT_OUT or not _number(value) or not _number(figures.get(key)):
                continue
            errors.setdefault(key, {})[name] = abs(value - figures[key])
            if name == "settling" and (wander := again.settings.get(WANDERING.get(key, ""))):
                errors[key]["wandering"] = wander * abs(value)
    result = {"run": identity(tables), "errors": errors}
    files.text(Path(folder) / CHECK, json.dumps(result, indent=2, allow_nan=False))
    return errors


def _number(value):
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
