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
WHOLE_HEAD = (
    ("where", 8),
    ("the paper says", 26),
    ("plates alone", 22),
    ("all of the capacitance", 24),
    ("why", 20),
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
    whole = quantities.measure_whole(book)
    judged = [statements.judge(one, corrected, printed, whole) for one in statements.read()]
    numbers = pd.DataFrame(
        [
            (form, name, one.value, one.unit, plain(one.label))
            for form, some in (("corrected", corrected), ("printed", printed), ("whole", whole))
            for name, one in some.items()
        ],
        columns=["formulas", "quantity", "value", "unit", "label"],
    )
    table = pd.DataFrame(judged).map(plain)
    return [
        _csv(out / "statements.csv", table),
        _csv(out / "quantities.csv", numbers),
        _text(out / "statements.inc", rst(judged)),
        _text(out / "statements_whole.inc", whole_rst(judged)),
    ]


def rst(judged: Sequence[Judged]) -> str:
    """The statements as a list-table."""
    rows = [[name for name, _ in HEAD]]
    for one in judged:
        verdicts = [
            _cell(one.corrected, one.corrected_numbers),
            _cell(one.printed, one.printed_numbers),
        ]
        rows.append([markup(one.where), markup(one.says), *verdicts, markup(one.why)])
    printed = [one.corrected if one.printed == statements.SAME else one.printed for one in judged]
    count = (
        f"{len(judged)} statements. From the corrected formulas "
        + _listing(one.corrected for one in judged)
        + "; from the formulas as printed "
        + _listing(printed)
        + "."
    )
    return f"{count}\n\n" + list_table(rows, [width for _, width in HEAD])


def whole_rst(judged: Sequence[Judged]) -> str:
    """Those statements as a list-table that see more than the plates of the capacitance."""
    rows = [[name for name, _ in WHOLE_HEAD]]
    some = [one for one in judged if one.whole != statements.SAME]
    for one in some:
        verdicts = [
            _cell(one.corrected, one.corrected_numbers),
            _cell(one.whole, one.whole_numbers),
        ]
        rows.append([markup(one.where), markup(one.says), *verdicts, markup(one.whole_why)])
    count = (
        f"{len(some)} statements. With plates alone "
        + _listing(one.corrected for one in some)
        + "; with all of the capacitance "
        + _listing(one.whole for one in some)
        + "."
    )
    return f"{count}\n\n" + list_table(rows, [width for _, width in WHOLE_HEAD])


def _cell(verdict, numbers):
    name = verdict if verdict == statements.SAME else f"**{verdict}**"
    return " – ".join(part for part in (name, markup(numbers)) if part)


def _listing(verdicts):
    totals = Counter(verdicts)
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
