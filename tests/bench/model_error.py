# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the numerical error and the model error in one diagram, and write
build/bench/model_error.rst and the diagram.

    .venv/bin/python tests/bench/model_error.py

Every set of models is run with a range of tolerances. The total error is relative to the full model
with a fine integration, as in `raceway needs`. The numerical error is relative to the same set of
models with the same fine integration.
"""

import tempfile
from pathlib import Path
from typing import NamedTuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from deck_runs import MAIN, run_deck  # noqa: E402
from machine import bench_file, csv_table, publish  # noqa: E402
from raceway.runs.run import Run  # noqa: E402
from raceway.sweeps.scene_parts import FINER, REFERENCE, figures  # noqa: E402

PICTURE = bench_file("model_error.png")
SCENES = {
    "5 kN, 477.5 rpm": {"load": 5000, "rpm": 477.5},
    "1 kN, 3000 rpm": {"load": 1000, "rpm": 3000},
}
SAME = {"passes": 1, "settle": 1, "surroundings": "flooded", "overwrite": "yes"}
MODELS = {"paper": ("#0072b2", "o"), "film": ("#d55e00", "s"), "full": ("#009e73", "^")}
FIGURES = {"torque": "friction torque", "capacitance": "capacitance", "load": "largest load"}
TOLERANCES = ("1e-6", "3e-7", "1e-7", "3e-8", "1e-8", "3e-9", "1e-9", "3e-10", "1e-10")  # m
SAMPLES = 200  # per ball pass
COARSE, USUAL = "1e-6", "1e-9"  # m, tolerances in the table
PAGE = """\
The main deck was run with three sets of models and {samples} samples per ball pass. Tolerances
range from 1 µm to 0.1 nm. As in :doc:`needs`, errors of means over a ball pass are relative to
``full`` at 0.01 nm and 800 samples. Filled marks show the total error. Open marks show the
numerical error alone, relative to the same models with equally fine integration. All errors are
divided by the values for ``full``.

.. image:: model_error.png
   :alt: error against evaluations, for three sets of models

Where a solid line is level, the model error dominates, and a finer tolerance brings no benefit,
because the numerical error is far smaller. Where the open marks are level, the remaining error is
that of a mean over {samples} samples.

Errors below {least:g} are drawn at {least:g}. With ``paper`` and ``film`` there is hardly any
friction torque, so its relative error is 1. In the table, *model* is the error with the finest
integration.

{table}

{machine}
"""
LEAST = 1e-6  # smaller errors are drawn at this value, which is the accuracy of the reference


class Found(NamedTuple):
    """The results of a run, keyed by the names that `raceway needs` uses, and the number of contact
    evaluations in the run."""

    figures: dict[str, float]
    evaluations: float


class Curve(NamedTuple):
    """Runs with one set of models in a scene, keyed by tolerance, and the run with fine
    integration."""

    runs: dict[str, Found]
    fine: Found


def played(folder: Path, **variables: object) -> Found:
    """Run the main deck once and return its results."""
    run_deck(MAIN, out=folder, **{**REFERENCE, **SAME, **variables})
    summary = Run(folder).summary()
    return Found(figures(summary), summary["evaluations"])


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
        print(scene, models, "evaluations", *(run.evaluations for run in runs.values()), flush=True)
    return found


def error(found: Found, truth: Found, yardstick: Found, word: str) -> float:
    """Return the difference between a result and `truth` as a fraction of the value in
    `yardstick`."""
    # the paper's model and film have no friction torque
    own, wanted = (run.figures.get(word, 0.0) for run in (found, truth))
    return abs(own - wanted) / abs(yardstick.figures[word])


def draw(results: dict[str, dict[str, Curve]]) -> None:
    """Draw the diagram, with a row for each scene and a column for each quantity."""
    figure, axes = plt.subplots(
        len(results), len(FIGURES), figsize=(13, 8), sharex=True, sharey=True
    )
    for line, (scene, found) in zip(axes, results.items()):
        yardstick = found["full"].fine
        for ax, (word, name) in zip(line, FIGURES.items()):
            for models, curve in found.items():
                colour, mark = MODELS[models]
                runs = curve.runs.values()
                cost = [run.evaluations for run in runs]
                for truth, dash, filled in ((yardstick, "-", colour), (curve.fine, ":", "none")):
                    if dash == ":" and models == "full":
                        continue  # equal to the total error, which is already drawn
                    height = [max(error(run, truth, yardstick, word), LEAST) for run in runs]
                    order = sorted(zip(cost, height))
                    label = f"{models}: " + ("numerical error" if dash == ":" else "total error")
                    ax.loglog(
                        *zip(*order),
                        dash,
                        marker=mark,
                        color=colour,
                        markerfacecolor=filled,
                        markersize=5,
                        linewidth=1.2,
                        label=label,
                    )
            ax.set_title(f"{name}, {scene}", fontsize=11)
            ax.grid(True, which="major", color="#eeeeee")
    for ax in axes[-1]:
        ax.set_xlabel("contact evaluations per ball pass")
    for ax in axes[:, 0]:
        ax.set_ylabel("relative error")
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncol=len(labels), frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.95))
    figure.savefig(PICTURE, dpi=100)


def table(results: dict[str, dict[str, Curve]]) -> list[str]:
    """Tabulate the model errors, and the numerical errors at a coarse tolerance and at the usual
    one."""
    rows = []
    for scene, found in results.items():
        yardstick = found["full"].fine
        for word, name in FIGURES.items():
            for models, curve in found.items():
                model = error(curve.fine, yardstick, yardstick, word)
                numbers = (
                    error(curve.runs[x], curve.fine, yardstick, word) for x in (COARSE, USUAL)
                )
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
    """Measure, draw the diagram and write the page."""
    with tempfile.TemporaryDirectory() as name:
        results = {title: curves(scene, Path(name) / "run") for title, scene in SCENES.items()}
    draw(results)
    publish(
        "Numerical error and model error", PAGE, samples=SAMPLES, least=LEAST, table=table(results)
    )


if __name__ == "__main__":
    main()
