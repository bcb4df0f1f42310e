# SPDX-License-Identifier: GPL-2.0-or-later
"""Verdicts on the paper's statements (statements.yaml) from numbers (`quantities`)."""

import re
from collections.abc import Mapping
from importlib import resources
from typing import NamedTuple

import yaml

from raceway.paper.quantity import Quantity

AGREE, DIFFER, UNKNOWN, SAME = "agree", "differ", "cannot be known", "as corrected"
RULE = re.compile(r"(\w+)\s*([<>=])\s*(\S+)(?:\s+within\s+(\S+))?$")


class Statement(NamedTuple):
    """A statement of the paper, and what decides it."""

    where: str
    says: str
    about: str  # "print" when the printed formulas decide both columns
    rules: tuple[str, ...]
    show: tuple[str, ...]
    why: str


class Judged(NamedTuple):
    """A statement with its verdicts: from the corrected and from the printed formulas."""

    where: str
    says: str
    corrected: str
    corrected_numbers: str
    printed: str
    printed_numbers: str
    why: str


def read() -> list[Statement]:
    """The `Statement`s, in the order of the paper."""
    text = resources.files("raceway.paper").joinpath("statements.yaml").read_text(encoding="utf-8")
    return [
        Statement(
            str(one["where"]),
            one["says"],
            one.get("about", ""),
            tuple(one.get("rules", ())),
            tuple(one.get("show", ())),
            one["why"],
        )
        for one in yaml.safe_load(text)
    ]


def holds(rule: str, numbers: Mapping[str, float]) -> bool:
    """Whether a rule, "name > number or name" or "name = number or name within tolerance", holds
    for {name: value}.

    Raises `ValueError` for a rule of another form and `KeyError` for an unknown name."""
    match = RULE.match(rule)
    if not match or (match[2] == "=") != bool(match[4]):
        raise ValueError(f"not a rule: {rule!r}")
    name, sign, other, tolerance = match.groups()
    left, right = numbers[name], _number(other, numbers)
    if sign == "=":
        return abs(left - right) <= float(tolerance)
    return left < right if sign == "<" else left > right


def names(rule: str) -> tuple[str, ...]:
    """The quantities a rule speaks of."""
    name, _, other, _ = RULE.match(rule).groups()
    return (name,) if _is_number(other) else (name, other)


def judge(
    statement: Statement, corrected: Mapping[str, Quantity], printed: Mapping[str, Quantity]
) -> Judged:
    """`Judged` of a statement, from {name: `Quantity`} of the corrected and of the printed
    formulas."""
    used = {name for rule in statement.rules for name in names(rule)} | set(statement.show)
    words = {name: quantity.text for name, quantity in corrected.items()}
    first, shown = _verdict(statement, corrected)
    if used & set(printed):
        second, other = _verdict(statement, corrected | printed)
    else:
        second, other = SAME, ""
    if statement.about == "print":
        first = second
    return Judged(
        statement.where,
        statement.says,
        first,
        shown,
        second,
        other,
        statement.why.format_map(words),
    )


def _verdict(statement, quantities):
    numbers = {name: quantity.value for name, quantity in quantities.items()}
    if statement.rules:
        verdict = AGREE if all(holds(rule, numbers) for rule in statement.rules) else DIFFER
    else:
        verdict = UNKNOWN
    return verdict, "; ".join(
        f"{quantities[name].label}: {quantities[name].text}" for name in statement.show
    )


def _number(text, numbers):
    return float(text) if _is_number(text) else numbers[text]


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True
