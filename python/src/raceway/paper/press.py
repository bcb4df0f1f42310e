# SPDX-License-Identifier: GPL-2.0-or-later
"""Make the products and write them: PNG and CSV files of figures, CSV files of tables, of the
statements and of the values behind them.

A file is either written completely or not at all.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

from raceway import files
from raceway.paper import quantities, statements
from raceway.paper.book import Book
from raceway.paper.figures import FIGURES
from raceway.paper.statements import plain
from raceway.paper.tables import TABLES
from raceway.pictures import style

STATEMENTS = "statements"


def title(product: str) -> str:
    """Return a one-line description of a product."""
    if product == STATEMENTS:
        return "All statements of the paper that can be checked, with their verdicts."
    return (FIGURES | TABLES)[product].__doc__.split("\n")[0]


def make(product: str, book: Book, out: Path) -> list[Path]:
    """Write one product into the folder `out` and return the paths.

    Raise `RacewayError` if it cannot be made.
    """
    if product in FIGURES:
        with plt.rc_context(style.STYLE):
            figure, table = FIGURES[product](book)
            picture = _whole(out / f"fig_{product}.png", lambda path: style.save(figure, path))
        return [picture, _csv(out / f"fig_{product}.csv", table)]
    if product in TABLES:
        return [_csv(out / f"{product.replace('-', '_')}.csv", TABLES[product](book))]
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
    return [_csv(out / "statements.csv", table), _csv(out / "quantities.csv", numbers)]


def _csv(path, table):
    return _text(path, table.to_csv(index=False, float_format="%.7g", lineterminator="\n"))


def _text(path, text):
    return _whole(path, lambda part: part.write_text(text, encoding="utf-8"))


def _whole(path, write):
    files.folder(path.parent)
    return files.whole(path, write)
