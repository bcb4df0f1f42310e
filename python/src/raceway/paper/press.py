# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes the products and writes them: PNG and CSV of a figure, CSV and reStructuredText of a table,
CSV and reStructuredText of the statements.

A file appears whole or not at all.
"""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

from raceway import files
from raceway.paper import quantities, statements
from raceway.paper.book import Book
from raceway.paper.figures import FIGURES
from raceway.paper.shown import list_table, markup, plain
from raceway.paper.shown import table as shown_table
from raceway.paper.statements import Judged
from raceway.paper.tables import TABLES
from raceway.pictures import style

STATEMENTS = "statements"
HEAD = (
    ("where", 8),
    ("the paper says", 24),
    ("corrected formulas", 26),
    ("printed formulas", 20),
    ("why", 24),
)


def title(product: str) -> str:
    """What a product is, in a line."""
    if product == STATEMENTS:
        return "Every statement of the paper that can be checked, with verdict."
    return (FIGURES | TABLES)[product].__doc__.split("\n")[0]


def make(product: str, book: Book, out: Path) -> list[Path]:
    """Write one product into the folder `out`; return the paths. Raises `RacewayError`."""
    if product in FIGURES:
        with plt.rc_context(style.STYLE):
            figure, table = FIGURES[product](book)
            picture = _whole(out / f"fig_{product}.png", lambda path: style.save(figure, path))
        return [picture, _csv(out / f"fig_{product}.csv", table)]
    if product in TABLES:
        data, stem = TABLES[product](book), product.replace("-", "_")
        return [_csv(out / f"{stem}.csv", data), _text(out / f"{stem}.inc", shown_table(data))]
    return _statements(book, out)


def _statements(book, out):
    corrected, printed = quantities.measure(book), quantities.measure(book, printed=True)
    judged = [statements.judge(one, corrected, printed) for one in statements.read()]
    numbers = pd.DataFrame(
        [
            (form, name, one.value, one.unit, plain(one.label))
            for form, some in (("corrected", corrected), ("printed", printed))
            for name, one in some.items()
        ],
        columns=["formulas", "quantity", "value", "unit", "label"],
    )
    table = pd.DataFrame(judged).map(plain)
    return [
        _csv(out / "statements.csv", table),
        _csv(out / "quantities.csv", numbers),
        _text(out / "statements.inc", rst(judged)),
    ]


def rst(judged: Sequence[Judged]) -> str:
    """The statements as a list-table."""
    rows = [[name for name, _ in HEAD]]
    for one in judged:
        verdicts = [
            " – ".join(
                part
                for part in (name if name == statements.SAME else f"**{name}**", markup(numbers))
                if part
            )
            for name, numbers in (
                (one.corrected, one.corrected_numbers),
                (one.printed, one.printed_numbers),
            )
        ]
        rows.append([markup(one.where), markup(one.says), *verdicts, markup(one.why)])
    return f"{_count(judged)}\n\n" + list_table(rows, [width for _, width in HEAD])


def _count(judged):
    totals = Counter(one.corrected for one in judged)
    printed = Counter(
        one.corrected if one.printed == statements.SAME else one.printed for one in judged
    )
    return (
        f"{len(judged)} statements. From the corrected formulas "
        + _listing(totals)
        + "; from the formulas as printed "
        + _listing(printed)
        + "."
    )


def _listing(totals):
    return ", ".join(
        f"{totals[name]} {name}"
        for name in (statements.AGREE, statements.DIFFER, statements.UNKNOWN)
    )


def _csv(path, table):
    return _text(path, table.to_csv(index=False, float_format="%.7g", lineterminator="\n"))


def _text(path, text):
    return _whole(path, lambda part: Path(part).write_text(text, encoding="utf-8"))


def _whole(path, write):
    files.folder(path.parent)
    return files.whole(path, write)
