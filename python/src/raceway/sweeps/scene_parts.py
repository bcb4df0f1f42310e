# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts and settings that `raceway needs` may omit or coarsen.

The choices in `scene_parts.yaml` are provided as tuples, and sets of them as variables of a deck.
"""

from collections.abc import Iterable, Mapping, Sequence
from importlib.resources import files
from itertools import product
from typing import Any, NamedTuple

import yaml

from raceway import catalogue, core, inputs
from raceway.errors import RacewayError

_DATA = yaml.safe_load(files("raceway").joinpath("sweeps/scene_parts.yaml").read_text())
REFERENCE = {name: str(value) for name, value in _DATA["reference"].items()}
FINER = {name: str(value) for name, value in _DATA["finer"].items()}
FIGURES = {  # {word of --want: keys of the summary, of which the first one present is used}
    word: tuple(keys) if isinstance(keys, list) else (keys,)
    for word, keys in _DATA["figures"].items()
}


JOINED = ("without", "cage_without")  # variables that list parts joined by +


class Choice(NamedTuple):
    """A choice to omit or coarsen something: a part to leave out, or variables to set."""

    name: str
    label: str
    group: str  # a set has at most one choice of a group
    without: tuple[tuple[str, str], ...]  # (variable in `JOINED`, part listed in it)
    settings: tuple[tuple[str, str], ...]  # (variable, value)
    parts: tuple[str, ...] | None  # parts that these models have; None: as in the reference


def figures(summary: Mapping[str, Any]) -> dict[str, float]:
    """Return {word of --want: result in SI units} from the `summary` of a run."""
    found = {
        word: next((summary[key] for key in keys if summary.get(key)), None)
        for word, keys in FIGURES.items()
    }
    return {word: value for word, value in found.items() if value is not None}


def whole_scene(
    given: Mapping[str, str], lubricated: bool, defaults: Mapping[str, str]
) -> dict[str, str]:
    """Return the deck's variables of a scene: the `given` values, and assumed values for others.

    `defaults` are the deck's own values. A cage that the deck would choose by models and integrator
    is the one that it chooses for the reference, so that choices of those leave the cage as it is.
    """
    scene = {**(_DATA["assumed"] if lubricated else {}), **given}
    values = {**defaults, **scene, **REFERENCE}
    if values.get("cage") == "auto":
        balls = values.get("cage_ball_diameter") or values.get("pocket_play") or ""
        oil = "" if lubricated else "dry"
        scene["cage"] = core.usual_cage(values["models"], values["integrator"], oil, balls)
    return scene


def choices(
    scene: Mapping[str, str], lubricated: bool, defaults: Mapping[str, str] | None = None
) -> list[Choice]:
    """Return the choices for contacts with a film or for dry contacts.

    Choices that the deck's variables `scene` (`whole_scene`) already make and choices for parts
    that the scene lacks are excluded; `defaults` are the deck's own values.
    """
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
    """Return True if contacts have a film for the deck's variables `scene`.

    `default` is the lubricant of the deck. An unknown lubricant counts as a lubricant, because the
    deck reports it.
    """
    try:
        return not inputs.dry(catalogue.find("lubricants", scene.get("lubricant", default)))
    except RacewayError:
        return True


def variables(picked: Iterable[Choice]) -> dict[str, str]:
    """Return the deck's variables of the reference with the choices `picked` applied."""
    result: dict[str, str] = dict(REFERENCE)
    for choice in picked:
        result.update(choice.settings)
        for name, part in choice.without:
            result[name] = f"{result[name]}+{part}" if name in result else part
    return result


def sets(available: Sequence[Choice]) -> list[tuple[Choice, ...]]:
    """Return all sets of choices that a deck can run.

    A set has at most one choice per group, and omits no part that its models or its cage do not
    have.
    """
    groups: dict[str, list[Choice | None]] = {}
    for choice in available:
        groups.setdefault(choice.group, [None]).append(choice)
    result = []
    for row in product(*groups.values()):
        picked = tuple(choice for choice in row if choice is not None)
        models = next((choice for choice in picked if choice.parts is not None), None)
        out = [part for choice in picked for name, part in choice.without if name == "without"]
        of_ring = any(name == "cage_without" for choice in picked for name, _ in choice.without)
        if of_ring and any(name == "cage" for choice in picked for name, _ in choice.settings):
            continue
        if models is None or set(out) <= set(models.parts):
            result.append(picked)
    return result
