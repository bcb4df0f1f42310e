# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables for the documentation: numbers with units and prefixes, as reStructuredText.

The unit of a column is the end of its name, as in all tables of this package: h_min_m,
capacitance_F.
"""

import re
from collections.abc import Sequence
from typing import Any

import pandas as pd

from raceway.units import prefixed

UNITS = (
    ("_per_Pa", "1/Pa"),
    ("_Pa_s", "Pa s"),
    ("_m_s", "m/s"),
    ("_m", "m"),
    ("_F", "F"),
    ("_deg", "°"),
)


def split(column: str) -> tuple[str, str]:
    """(name in words, SI unit) of a column's name; the unit of a plain number is ""."""
    for end, unit in UNITS:
        if column.endswith(end):
            return column.removesuffix(end).replace("_", " "), unit
    return column.replace("_", " "), ""


def number(value: Any, unit: str) -> str:
    """A cell: four digits and a prefix; nothing for a missing number."""
    if isinstance(value, str):
        return value
    if pd.isna(value):
        return ""
    if unit == "1/Pa":
        text = f"{value * 1e9:.4g} /GPa"
    elif unit == "°":
        text = f"{value:.4g}°"
    else:
        text = prefixed(value, unit)
    return text.replace("-", "−")


def table(data: pd.DataFrame) -> str:
    """`DataFrame` as a list-table. Where rows have a `property` and its `value`, the unit is the
    property's."""
    rows = [[split(column)[0] for column in data.columns]]
    for _, row in data.iterrows():
        cells = {column: number(row[column], split(column)[1]) for column in data.columns}
        if {"property", "value"} <= set(cells):
            cells["property"], unit = split(row["property"])
            cells["value"] = number(row["value"], unit)
        rows.append(list(cells.values()))
    return list_table(rows)


def list_table(rows: Sequence[Sequence[str]], widths: Sequence[int] | None = None) -> str:
    """Rows of cells, the first the head, as reStructuredText."""
    lines = [
        ".. written by `raceway paper`; do not edit",
        "",
        ".. list-table::",
        "   :header-rows: 1",
    ]
    if widths:
        lines.append(f"   :widths: {' '.join(map(str, widths))}")
    for row in rows:
        lines += [""] if row is rows[0] else []
        lines += [("   * - " if at == 0 else "     - ") + cell for at, cell in enumerate(row)]
    return "\n".join(lines) + "\n"


def markup(text: str) -> str:
    """Text with $formulas$ as reStructuredText."""
    text = re.sub(r"([*|`])", r"\\\1", text)
    return re.sub(r"\$([^$]+)\$", r":math:`\1`", text)


def plain(text: Any) -> Any:
    """Text with $formulas$ without the marks."""
    return re.sub(r"[${}]", "", text) if isinstance(text, str) else text
