# SPDX-License-Identifier: GPL-2.0-or-later
"""Find the cheapest set of model parts and numerical settings that gives the results of a scene
with the required accuracy.

The scene is run with the full model and fine numerical settings. Then each part is omitted and each
setting is coarsened, one at a time. To find sets that are worth running, the effects of a set are
estimated as the sum of the individual effects, and its cost as the product of the individual costs.
An individual cost is the geometric mean of the ratios of processor times and of evaluations.
The decision is based on the run of the set itself.

All runs are handled like the points of a sweep, in folders named after their variables; finished
runs are not repeated.
"""

import json
import math
import statistics
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.sweeps.point_run import FINISHED, mapping, state
from raceway.sweeps.points import Point, folder_name
from raceway.sweeps.scene_parts import FINER, REFERENCE, Choice, figures, sets, variables
from raceway.sweeps.sweep import sweep

AT_ONCE = 6  # number of sets per round
ROUNDS = 8  # maximum number of rounds
REPEATS = 3  # number of runs that measure the processor times of the reference and the best sets


class Outcome(NamedTuple):
    """Effect of a set of choices on the results and on the cost."""

    picked: tuple[Choice, ...]
    variables: dict[str, str]
    errors: dict[str, float]  # {word of --want: relative error}; inf if the run fails
    cost: float  # processor time of the engine relative to the reference; nan if the run fails
    evaluations: float  # number of force evaluations relative to the reference
    message: str  # error message of a failed run

    @property
    def pays(self) -> bool:
        """True if the saving exceeds the spread of processor times."""
        return self.evaluations < 0.98 or self.cost < 0.95

    def keeps(self, wanted: Mapping[str, float]) -> bool:
        """Return True if all errors are at most as large as `wanted`, {word: relative error}."""
        return all(self.errors[word] <= most for word, most in wanted.items())


class Needs(NamedTuple):
    """Result of `needs` for a scene."""

    scene: dict[str, str]  # variables common to all runs
    wanted: dict[str, float]  # {word: allowed relative error}
    figures: dict[str, float]  # {word: reference value}
    uncertain: dict[str, float]  # relative uncertainty of the reference, from a finer repeat
    single: list[Outcome]
    tried: list[Outcome]  # sets that were run
    best: Outcome
    costs: dict[str, list[float]]  # s, processor times of the runs; keys: reference, picked
    words: dict[str, str]  # variables to set for the cheapest set
    warnings: list[str]  # warnings of the reference run


def needs(
    scene: Mapping[str, str],
    wanted: Mapping[str, float],
    available: Sequence[Choice],
    folder: FilePath,
    command: Sequence[str],
    *,
    jobs: int = 1,
) -> Needs:
    """Find the cheapest set for the deck's variables `scene`.

    `wanted` maps words of `FIGURES` to allowed relative errors; all `available` choices are tried.
    The runs are stored in `folder`; `jobs` of them run at the same time. `command` is a list of
    program, options and deck. Raise `RacewayError` if the reference fails or lacks a wanted result.
    """
    lab = _Lab(Path(folder), dict(scene), list(command), jobs)
    singles = [(choice,) for choice in available]
    lab.run([REFERENCE, {**REFERENCE, **FINER}, *map(variables, singles)])
    reference = lab.reference()
    own = figures(reference)
    if missing := [word for word in wanted if word not in own]:
        raise RacewayError(
            f"the scene does not provide {', '.join(missing)}; it provides {', '.join(own)}"
        )
    single = [lab.outcome(picked) for picked in singles]
    tried: list[Outcome] = []
    kept: list[Outcome] = []
    for outcomes in _rounds(lab, single, wanted):
        tried += outcomes
        kept = [one for one in tried if one.keeps(wanted)]
        if kept:
            break
    last = _finalists(kept or [lab.outcome(())])
    asked = {f"set {k}": one.variables for k, one in enumerate(last)}
    times = lab.repeat({"reference": REFERENCE, **asked})
    name, best = _cheapest(dict(zip(asked, last)), times)
    middle = {key: statistics.median(of) for key, of in times.items()}
    best = best._replace(cost=middle[name] / middle["reference"])
    costs = {"reference": times["reference"], "picked": times[name]}
    return Needs(
        dict(scene),
        dict(wanted),
        own,
        _relative(own, figures(lab.summary({**REFERENCE, **FINER}))),
        single,
        tried,
        best,
        costs,
        best.variables,
        reference["warnings"],
    )


def _finalists(kept):
    """Return the sets whose processor times are measured again: the two that took the least time,
    and the one with the fewest evaluations, since a single time can be wrong by a factor."""
    fast = sorted(kept, key=lambda one: one.cost)[:2]
    few = min(kept, key=lambda one: one.evaluations)
    return fast if few in fast else [*fast, few]


def _cheapest(last, times):
    """Return (name, set) of the set with the lowest processor time. If the ranges of times overlap
    because the machine is busy, the number of evaluations decides."""
    by_evaluations = sorted(last.items(), key=lambda item: item[1].evaluations)
    return next(
        (name, one)
        for name, one in by_evaluations
        if all(max(times[other]) >= min(times[name]) for other in last)
    )


def _rounds(lab, single, wanted):
    """Yield the outcomes of the sets with the lowest estimated cost, round by round.

    Each round increases the margin by the error of the last estimate.
    """
    # A choice that is inaccurate alone is also inaccurate in a set, because effects add up.
    good = {one.picked[0].name: one for one in single if one.pays and one.keeps(wanted)}
    candidates = []
    for picked in sets([one.picked[0] for one in good.values()]):
        rows = [good[choice.name] for choice in picked]
        error = max(
            (sum(row.errors[word] for row in rows) / most for word, most in wanted.items()),
            default=0.0,
        )
        # Negative savings of single runs, which are noise, must not accumulate. The number of
        # evaluations does not scatter.
        cost = math.prod(math.sqrt(min(row.cost, 1.0) * min(row.evaluations, 1.0)) for row in rows)
        candidates.append((cost, len(picked), error, picked))
    candidates.sort(key=lambda one: one[:3])
    margin, seen = 1.0, set()
    for _ in range(ROUNDS):
        chosen = [one for one in candidates if one[2] * margin <= 1.0 and one[3] not in seen]
        chosen = chosen[:AT_ONCE]
        if not chosen:
            return
        seen.update(one[3] for one in chosen)
        lab.run([variables(one[3]) for one in chosen])
        outcomes = [lab.outcome(one[3]) for one in chosen]
        yield outcomes
        wrong = [
            max(outcome.errors[word] / most for word, most in wanted.items()) / max(one[2], 1e-3)
            for one, outcome in zip(chosen, outcomes)
            if not outcome.message
        ]
        margin = max(1.5 * margin, min(wrong, default=2.0))


class _Lab:
    """Executes the runs of one scene in a folder and provides their results."""

    def __init__(self, folder, scene, command, jobs):
        self.folder, self.scene, self.command, self.jobs = folder, scene, command, jobs

    def point(self, words):
        full = {**self.scene, **words}
        return Point(folder_name(full), full)

    def run(self, many):
        points = {point.name: point for point in map(self.point, many)}
        sweep(list(points.values()), self.folder, self.command, jobs=self.jobs)

    def reference(self):
        found = self.summary(REFERENCE)
        if not found:
            _, message = state(self.folder / self.point(REFERENCE).name, self.point(REFERENCE)[1])
            raise RacewayError(f"the scene with every part of the model: {message}")
        return found

    def summary(self, words):
        """Return the summary of a run, which is empty if the run failed."""
        point = self.point(words)
        status, _ = state(self.folder / point.name, point.variables)
        if status != FINISHED:
            return {}
        return mapping(self.folder / point.name / "summary.json", json.loads) or {}

    def outcome(self, picked):
        words = variables(picked)
        reference, found = self.reference(), self.summary(words)
        if not found:
            point = self.point(words)
            _, message = state(self.folder / point.name, point.variables)
            lost = dict.fromkeys(figures(reference), math.inf)
            return Outcome(picked, words, lost, math.nan, math.nan, message or "not run")
        return Outcome(
            picked,
            words,
            _relative(figures(reference), figures(found)),
            found["processor_s"] / reference["processor_s"],
            found["evaluations"] / reference["evaluations"],
            "",
        )

    def repeat(self, words):
        """Return {name: processor times in s} of `REPEATS` runs for each entry of `words`.

        The entries are run alternately.
        """
        points, every = {name: [] for name in words}, {}
        for turn in range(REPEATS):
            for name, asked in words.items():
                point = self.point(asked)
                again = {"again": str(turn), **point.variables}
                own = point.name if turn == 0 else folder_name(again)
                points[name].append(own)
                every[own] = Point(own, point.variables)
        sweep(list(every.values()), self.folder, self.command, jobs=self.jobs)
        return {
            name: [
                mapping(self.folder / own / "summary.json", json.loads)["processor_s"]
                for own in rows
            ]
            for name, rows in points.items()
        }


def _relative(of, found):
    return {
        word: abs(found[word] / value - 1) if word in found else math.inf
        for word, value in of.items()
    }
