# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of `raceway needs` as text and as JSON."""

import math
import shlex
import statistics
from typing import Any

from raceway.rows import warning_lines
from raceway.sweeps.needs import Needs, Outcome
from raceway.sweeps.scene_parts import REFERENCE

NOTHING = 1e-12  # smaller relative effects are rounding errors
SURE = 0.5  # largest uncertainty of a reference that can be used, relative to the allowed error


def table(found: Needs) -> str:
    """Return a table of the effect of each choice on each result, of its cost, and of the cheapest
    set."""
    words = list(found.figures)
    head = f"  {'omitted or coarsened':<50}" + "".join(f"{word[:12]:>13}" for word in words)
    lines = [
        "Relative effect of each change alone; the reference has all parts and fine settings",
        f"{head}{'cost':>8}{'evaluations':>13}",
        *(_line(one.picked[0].label, one, words) for one in found.single),
        "",
        _row("uncertainty of the reference", found.uncertain, words),
        _row("wanted", found.wanted, words),
        *_doubts(found),
        "",
        f"Cheapest set with the required accuracy among {len(found.tried)} that were run",
        _line("all of these together", found.best, words),
        *(f"    {choice.label}" for choice in found.best.picked),
        *([] if found.best.picked else ["    nothing omitted, nothing coarsened"]),
        "",
        "Processor time of the measured passes: " + _spread(found),
        *warning_lines(found.warnings),
        "",
        command(found),
    ]
    return "\n".join(lines)


def command(found: Needs) -> str:
    """Return the -var options of the scene and of the cheapest set for the deck."""
    return " ".join(
        f"-var {name} {shlex.quote(value)}"
        for name, value in {**found.scene, **found.words}.items()
    )


def as_json(found: Needs) -> dict[str, Any]:
    """Return all results as numbers and texts; values of failed runs are infinite or NaN."""
    return {
        "scene": found.scene,
        "reference": REFERENCE,
        "wanted": found.wanted,
        "figures": found.figures,
        "uncertain": found.uncertain,
        "single": [_outcome(one) for one in found.single],
        "tried": [_outcome(one) for one in found.tried],
        "best": _outcome(found.best),
        "processor_s": found.costs,
        "words": found.words,
        "warnings": found.warnings,
    }


def _outcome(one: Outcome) -> dict[str, Any]:
    return {
        "names": [choice.name for choice in one.picked],
        "errors": one.errors,
        "cost": one.cost,
        "evaluations": one.evaluations,
        **({"message": one.message} if one.message else {}),
    }


def percent(value: float) -> str:
    """Return a relative value as text, for example 12 % or 0.03 %."""
    if not math.isfinite(value):
        return "-"
    if NOTHING <= value < 1e-5:
        return "<0.001 %"
    if value < 0.0995:
        return "0 %" if value < NOTHING else f"{100 * value:.2g} %"
    return f"{100 * value:.0f} %"


def _line(label, one, words):
    if one.message:
        return f"  {label:<50} {one.message}"
    return f"{_row(label, one.errors, words)}{percent(one.cost):>8}{percent(one.evaluations):>13}"


def _row(label, values, words):
    cells = (percent(values[word]) if word in values else "" for word in words)
    return f"  {label:<50}" + "".join(f"{cell:>13}" for cell in cells)


def _doubts(found):
    return [
        f"  {word}: the uncertainty of the reference exceeds half of the allowed error"
        for word, most in found.wanted.items()
        if found.uncertain[word] > SURE * most
    ]


def _spread(found):
    texts = []
    names = {"reference": "reference", "picked": "cheapest set"}
    for key, times in found.costs.items():
        middle = statistics.median(times)
        texts.append(
            f"{names[key]} {1e3 * middle:.3g} ms ({1e3 * min(times):.3g} to {1e3 * max(times):.3g})"
        )
    return ", ".join(texts) + f", {len(times)} runs each"
