# SPDX-License-Identifier: GPL-2.0-or-later
"""What `raceway needs` may omit or coarsen: the choices of `scene_parts.yaml` as tuples, and sets
of choices as variables of a deck."""

from collections.abc import Iterable, Mapping, Sequence
from importlib.resources import files
from itertools import product
from typing import Any, NamedTuple

import yaml

from raceway import catalogue, inputs
from raceway.errors import RacewayError

_DATA = yaml.safe_load(files("raceway").joinpath("sweeps/scene_parts.yaml").read_text())
REFERENCE = {name: str(value) for name, value in _DATA["reference"].items()}
FINER = {name: str(value) for name, value in _DATA["finer"].items()}
FIGURES = {  # {word of --want: keys of the summary, of which the first one present counts}
    word: tuple(keys) if isinstance(keys, list) else (keys,)
    for word, keys in _DATA["figures"].items()
}


JOINED = ("without", "cage_without")  # variables that list parts, joined by +


class Choice(NamedTuple):
    """Something to omit or coarsen: a part to leave out, or variables to set."""

    name: str
    label: str
    group: str  # a set has at most one choice of a group
    without: tuple[tuple[str, str], ...]  # (variable of `JOINED`, part listed in it)
    settings: tuple[tuple[str, str], ...]
    parts: tuple[str, ...] | None  # parts of these models; None: of the models of the reference


def figures(summary: Mapping[str, Any]) -> dict[str, float]:
    """The figures in a run's `summary`, by word of --want, SI units."""
    found = {
        word: next((summary[key] for key in keys if summary.get(key)), None)
        for word, keys in FIGURES.items()
    }
    return {word: value for word, value in found.items() if value is not None}


def whole_scene(given: Mapping[str, str], lubricated: bool) -> dict[str, str]:
    """The deck's variables of a scene: `given` values, and assumed values for other variables."""
    return {**(_DATA["assumed"] if lubricated else {}), **given}


def choices(
    scene: Mapping[str, str], lubricated: bool, defaults: Mapping[str, str] | None = None
) -> list[Choice]:
    """The choices for contacts with a film or for dry contacts, except choices that the deck's
    variables `scene` already make and choices for parts that the scene lacks; `defaults` are the
    deck's own values."""
    return [
        choice
        for choice in _all_choices(lubricated, {**(defaults or {}), **scene})
        if not choice.settings or not set(choice.settings) <= set(scene.items())
    ]


def _all_choices(lubricated, values):
    return [
        Choice(
            row["name"],
            row["label"],
            row.get("group", row["name"]),
            tuple((name, row[name]) for name in JOINED if name in row),
            tuple((name, str(value)) for name, value in row.get("set", {}).items()),
            tuple(row["parts"]) if "parts" in row else None,
        )
        for row in _DATA["choices"]
        if (lubricated or "only" not in row)
        and all(values.get(name) in of for name, of in row.get("when", {}).items())
    ]


def lubricated(scene: Mapping[str, str], default: str) -> bool:
    """True if contacts with the deck's variables `scene` have a film; `default` is the deck's
    lubricant. Unknown lubricants count as lubricants; the deck reports them."""
    try:
        data = inputs.values(catalogue.find("lubricants", scene.get("lubricant", default)))
    except RacewayError:
        return True
    return data.get("film") != "dry"


def variables(picked: Iterable[Choice]) -> dict[str, str]:
    """The deck's variables of the reference with `picked` omitted or coarsened."""
    result: dict[str, str] = dict(REFERENCE)
    for choice in picked:
        result.update(choice.settings)
        for name, part in choice.without:
            result[name] = f"{result[name]}+{part}" if name in result else part
    return result


def sets(available: Sequence[Choice]) -> list[tuple[Choice, ...]]:
    """All sets of choices that a deck can run: at most one choice per group, and no part that the
    models of the set lack."""
    groups: dict[str, list[Choice | None]] = {}
    for choice in available:
        groups.setdefault(choice.group, [None]).append(choice)
    result = []
    for row in product(*groups.values()):
        picked = tuple(choice for choice in row if choice is not None)
        models = next((choice for choice in picked if choice.parts is not None), None)
        out = [part for choice in picked for name, part in choice.without if name == "without"]
        if models is None or set(out) <= set(models.parts):
            result.append(picked)
    return result
