# SPDX-License-Identifier: GPL-2.0-or-later
"""Verdicts on the statements of the paper (statements.yaml), based on values from `quantities`."""

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from raceway.paper.quantity import Quantity, data

AGREE, DIFFER, UNKNOWN, SAME = "agree", "differ", "cannot be known", "as corrected"
RULE = re.compile(r"(\w+)\s*([<>=])\s*(\S+)(?:\s+within\s+(\S+))?$")


class Statement(NamedTuple):
    """A statement of the paper, and the rules for its verdict."""

    where: str
    says: str
    about: str  # "print" if the printed formulas decide both columns of verdicts
    rules: tuple[str, ...]
    show: tuple[str, ...]
    why: str
    whole: Mapping[str, Any] = MappingProxyType({})  # rules and show for the total capacitance
    found: tuple[str, str, str] = (UNKNOWN, SAME, SAME)  # corrected, printed, whole in `Judged`


class Judged(NamedTuple):
    """A statement with its verdicts for the corrected formulas, for the printed formulas, and for
    the total capacitance."""

    where: str
    says: str
    corrected: str
    corrected_numbers: str
    printed: str
    printed_numbers: str
    whole: str
    whole_numbers: str
    why: str
    whole_why: str


def read() -> list[Statement]:
    """Return the `Statement` objects in the order of the paper."""
    return [
        Statement(
            str(one["where"]),
            one["says"],
            one.get("about", ""),
            tuple(one.get("rules", ())),
            tuple(one.get("show", ())),
            one["why"],
            one.get("whole", {}),
            _found(one["found"]),
        )
        for one in data("statements")
    ]


def _found(verdicts):
    given = [verdicts] if isinstance(verdicts, str) else verdicts
    return (*given, *[SAME] * (3 - len(given)))


def holds(rule: str, numbers: Mapping[str, float]) -> bool:
    """Return True if a rule is satisfied for {name: value}.

    A rule has the form "name > number or name" or "name = number or name within tolerance". Raise
    `ValueError` for any other form and `KeyError` for an unknown name.
    """
    match = RULE.match(rule)
    if not match or (match[2] == "=") != bool(match[4]):
        raise ValueError(f"not a rule: {rule!r}")
    name, sign, other, tolerance = match.groups()
    left, right = numbers[name], _number(other, numbers)
    if sign == "=":
        return abs(left - right) <= float(tolerance)
    return left < right if sign == "<" else left > right


def names(rule: str) -> tuple[str, ...]:
    """Return the names of the quantities that a rule uses."""
    name, _, other, _ = RULE.match(rule).groups()
    return (name,) if _is_number(other) else (name, other)


def judge(
    statement: Statement,
    corrected: Mapping[str, Quantity],
    printed: Mapping[str, Quantity],
    whole: Mapping[str, Quantity] = MappingProxyType({}),
) -> Judged:
    """Judge a statement and return the result.

    The arguments are {name: `Quantity`} for the corrected formulas, for the printed formulas, and
    for the total capacitance; the latter contains only quantities that differ from `corrected`.
    `statement.whole` contains the rules and quantities for the total capacitance if they differ.
    """
    words = {name: quantity.text for name, quantity in {**whole, **corrected}.items()}
    first, shown = _verdict(statement, corrected)
    second, other = _other(statement, corrected, printed)
    full = statement
    if whole and statement.whole:
        full = statement._replace(
            rules=tuple(statement.whole.get("rules", ())),
            show=tuple(statement.whole.get("show", ())),
        )
    third, more = _other(full, corrected, whole)
    if statement.about == "print":
        first = second
    return Judged(
        statement.where,
        statement.says,
        first,
        shown,
        second,
        other,
        third,
        more,
        statement.why.format_map(words),
        "" if third == SAME else statement.whole.get("why", "").format_map(words),
    )


def _other(statement, corrected, others):
    """Return the verdict and the values if `others` replace some of the quantities that `statement`
    uses, and otherwise (`SAME`, "")."""
    used = {name for rule in statement.rules for name in names(rule)} | set(statement.show)
    if used & set(others):
        return _verdict(statement, {**corrected, **others})
    return SAME, ""


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


def markup(text: str) -> str:
    """Convert text with $formulas$ to reStructuredText."""
    text = re.sub(r"([*|`])", r"\\\1", text)
    return re.sub(r"\$([^$]+)\$", r":math:`\1`", text)


def plain(text: Any) -> Any:
    """Return the text without the markup of $formulas$."""
    return re.sub(r"[${}]", "", text) if isinstance(text, str) else text
