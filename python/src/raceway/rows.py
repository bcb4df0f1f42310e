# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures as text: a line for each, under the headings of their topics."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from raceway.units import prefixed


class Row(NamedTuple):
    """One line of the table."""

    key: str
    label: str
    unit: str | None  # SI unit, shown with a prefix; "" a plain number; None text
    source: str = ""


def lines(figures: Mapping[str, Any], topics: Mapping[str, Sequence[Row]]) -> list[str]:
    """The lines of a table of `topics` (`Row`s by heading); figures that are None are left out."""
    result = []
    for topic, rows in topics.items():
        block = [_line(row, figures[row.key]) for row in rows if figures[row.key] is not None]
        if block:
            result += ["", topic, *block]
    return result[1:]


def _line(row, value):
    if row.unit is None:
        shown = value
    elif row.unit == "rpm":
        shown = f"{value:g} rpm"
    elif row.unit == "°C":
        shown = f"{value:.4g} °C"
    elif row.unit == "1/GPa":
        shown = f"{value * 1e9:.4g} 1/GPa"
    else:
        shown = prefixed(value, row.unit) if row.unit else f"{value:.4g}"
    source = f"({row.source})" if row.source else ""
    return f"  {row.label:<32}{shown:>14}  {source}".rstrip()
