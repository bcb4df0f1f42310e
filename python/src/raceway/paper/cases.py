# SPDX-License-Identifier: GPL-2.0-or-later
"""The runs of `raceway paper`, i.e. the cases of inputs/paper/cases.yaml with lists expanded and
with names converted to those of deck variables."""

import itertools
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from raceway import inputs
from raceway.errors import InputError, unreadable
from raceway.sweeps.points import deck_variables
from raceway.theory import kinematics
from raceway.theory.bearing import Bearing
from raceway.theory.models import PAPER

FILE = Path("inputs/paper/cases.yaml")
OF_THE_PAPER = {"models": PAPER, "settle": 1}


@dataclass(frozen=True)
class Case:
    """A run, given by a deck and its `-var` settings.

    Cases with the same settings are the same run.
    """

    deck: str
    settings: tuple[tuple[str, str], ...]  # (name, text), sorted
    given: dict[str, Any] = field(compare=False)  # settings as in the file, for searching

    @property
    def label(self) -> str:
        """Human-readable description of the case."""
        given = {key: value for key, value in self.given.items() if key != "passes"}
        return f"{Path(self.deck).name} " + " ".join(
            f"{key}={value}" for key, value in given.items()
        )


@dataclass(frozen=True)
class Plan:
    """The cases of each set, and the sets that each product needs."""

    cases: dict[str, list[Case]]  # {name of the set: cases}
    products: dict[str, list[str]]  # {name of the product: names of the sets}
    root: Path  # the source tree

    def needed(self, products: Iterable[str]) -> list[Case]:
        """Return the cases that these products need, without duplicates."""
        sets = dict.fromkeys(name for product in products for name in self.products[product])
        return list(dict.fromkeys(case for name in sets for case in self.cases[name]))


def plan(root: Path) -> Plan:
    """Return the `Plan` for the source tree `root`.

    Raise `InputError` if the file of cases is invalid.
    """
    path = root / FILE
    try:
        data = yaml.safe_load(path.read_text())
        sets = {
            name: [_case(root, entry["deck"], one) for one in _combinations(entry["with"])]
            for name, entry in data["cases"].items()
        }
        products = {str(name): list(needs) for name, needs in data["products"].items()}
    except OSError as error:
        raise InputError(unreadable(path, error)) from None
    except yaml.YAMLError as error:
        raise InputError(f"{path}: {error}") from None
    except (KeyError, TypeError, AttributeError) as error:
        raise InputError(
            f"{path}: {error!r}; cases (deck, with) and products were expected"
        ) from None
    if unknown := sorted({need for needs in products.values() for need in needs} - set(sets)):
        raise InputError(f"{path}: products refer to unknown cases: {', '.join(unknown)}")
    return Plan(sets, products, root)


def _combinations(settings):
    lists = [value if isinstance(value, list) else [value] for value in settings.values()]
    return [dict(zip(settings, chosen)) for chosen in itertools.product(*lists)]


def _case(root, deck, given):
    """Convert entrainment, clearance_ratio and total_curvature to variables of the decks."""
    known = deck_variables(root / deck)
    own = {name: value for name, value in OF_THE_PAPER.items() if name in known} | given
    ours = {
        name: own.pop(name)
        for name in ("entrainment", "clearance_ratio", "total_curvature")
        if name in own
    }
    bearing = inputs.bearing(root / "inputs/bearings" / str(own.get("bearing", 6208)))
    if "entrainment" in ours:
        own["rpm"] = rpm(bearing, ours["entrainment"])
    if ours.get("clearance_ratio"):  # 0 is the default, so it gives the same run as no ratio
        own["clearance"] = ours["clearance_ratio"] * bearing.ball_diameter
    if "total_curvature" in ours:
        own["inner_groove"] = own["outer_groove"] = groove(bearing, ours["total_curvature"])
    settings = tuple(
        sorted(
            (name, f"{value:.12g}" if isinstance(value, float) else str(value))
            for name, value in own.items()
        )
    )
    return Case(deck, settings, given)


def rpm(bearing: Bearing, entrainment: float) -> float:
    """Return the inner ring speed in rpm at which rolling balls have the entrainment speed
    `entrainment` in m/s."""
    return entrainment / kinematics.entrainment(bearing, 1.0) * 30 / np.pi


def groove(bearing: Bearing, total_curvature: float) -> float:
    """Return the radius r_c in m of both grooves for B = 2 r_c/D - 1 (eq A.2)."""
    return bearing.ball_diameter * (total_curvature + 1) / 2
