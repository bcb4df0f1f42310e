# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the numerical error with the model error, and write build/bench/model_error.rst.

    .venv/bin/python tests/bench/model_error.py

The model error is that of a set of models relative to the full model, both with a fine integration,
as in `raceway needs`. The numerical error is relative to the same set of models with this fine
integration.
"""

import tempfile
from pathlib import Path
from typing import NamedTuple

from deck_runs import MAIN, run_deck
from machine import csv_table, publish
from raceway.runs.run import Run
from raceway.sweeps.scene_parts import FINER, REFERENCE, figures

SCENES = {
    "5 kN, 477.5 rpm": {"load": 5000, "rpm": 477.5},
    "1 kN, 3000 rpm": {"load": 1000, "rpm": 3000},
}
SAME = {"passes": 1, "settle": 1, "surroundings": "flooded", "overwrite": "yes"}
MODELS = ("paper", "film", "full")
FIGURES = {"torque": "friction torque", "capacitance": "capacitance", "load": "largest load"}
TOLERANCES = ("1e-6", "1e-9")  # m, coarse and usual
SAMPLES = 200  # per ball pass
PAGE = """\
The main deck was run with three sets of models and {samples} samples per ball pass. As in
:doc:`needs`, errors of means over a ball pass are divided by the values for ``full`` at 0.01 nm and
800 samples. *model* is the error relative to these values with an equally fine integration;
*numerical* is the error at a tolerance, relative to the same models with the fine integration. With
``paper`` and ``film`` there is no friction torque, so its relative error is 1.

{table}

{machine}
"""


class Curve(NamedTuple):
    """The results of one set of models in a scene, as dicts with the names that `raceway needs`
    uses: for each tolerance, and with the fine integration."""

    runs: dict[str, dict[str, float]]
    fine: dict[str, float]


def played(folder: Path, **variables: object) -> dict[str, float]:
    """Run the main deck once and return its results."""
    run_deck(MAIN, out=folder, **{**REFERENCE, **SAME, **variables})
    return figures(Run(folder).summary())


def curves(scene: dict[str, float], folder: Path) -> dict[str, Curve]:
    """Return a dict that maps each set of models to its `Curve` for a scene."""
    found = {}
    for models in MODELS:
        own = {**scene, "models": models}
        runs = {
            tolerance: played(folder, **own, tolerance=tolerance, samples=SAMPLES)
            for tolerance in TOLERANCES
        }
        found[models] = Curve(runs, played(folder, **{**own, **FINER}))
        print(scene, models, runs, flush=True)
    return found


def error(
    found: dict[str, float], truth: dict[str, float], full: dict[str, float], word: str
) -> float:
    """Return the difference between a result and `truth` as a fraction of the value in `full`."""
    # the paper's model and film have no friction torque
    return abs(found.get(word, 0.0) - truth.get(word, 0.0)) / abs(full[word])


def table(results: dict[str, dict[str, Curve]]) -> list[str]:
    """Tabulate the model errors and the numerical errors."""
    rows = []
    for scene, found in results.items():
        yardstick = found["full"].fine
        for word, name in FIGURES.items():
            for models, curve in found.items():
                model = error(curve.fine, yardstick, yardstick, word)
                numbers = (error(run, curve.fine, yardstick, word) for run in curve.runs.values())
                rows.append(
                    [
                        scene,
                        name,
                        f"``{models}``",
                        f"{model:.0e}" if models != "full" else "the yardstick",
                        *(f"{value:.0e}" for value in numbers),
                    ]
                )
    return csv_table(
        ["scene", "quantity", "models", "model", "numerical, 1 µm", "numerical, 1 nm"], rows
    )


def main() -> None:
    """Measure and write the page."""
    with tempfile.TemporaryDirectory() as name:
        results = {title: curves(scene, Path(name) / "run") for title, scene in SCENES.items()}
    publish("Numerical error and model error", PAGE, samples=SAMPLES, table=table(results))


if __name__ == "__main__":
    main()
