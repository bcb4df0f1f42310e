# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes the products and writes them: PNG and CSV of a figure, CSV of a table, CSV and reStructuredText of the statements.

A file appears whole or not at all.
"""

import os
import re
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

from raceway import style
from raceway.errors import RacewayError
from raceway.paper import quantities, statements
from raceway.paper.figures import FIGURES
from raceway.paper.tables import TABLES

STATEMENTS = "statements"
HEAD = (("where", 8), ("the paper says", 24), ("corrected formulas", 26), ("printed formulas", 20), ("why", 24))


def title(product):
    """What a product is, in a line."""
    if product == STATEMENTS:
        return "Every statement of the paper that can be checked, with verdict."
    return (FIGURES | TABLES)[product].__doc__.split("\n")[0]


def make(product, book, out):
    """Write one product into the folder `out`; return the paths. Raises `RacewayError`."""
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
    judged = [statements.judge(one, corrected, printed) for one in statements.read()]
    numbers = pd.DataFrame([(form, name, one.value, one.unit, _plain(one.label))
                            for form, some in (("corrected", corrected), ("printed", printed)) for name, one in some.items()],
                           columns=["formulas", "quantity", "value", "unit", "label"])
    table = pd.DataFrame(judged).map(_plain)
    return [_csv(out / "statements.csv", table), _csv(out / "quantities.csv", numbers),
            _text(out / "statements.rst", rst(judged))]


def rst(judged):
    """The statements as a list-table."""
    lines = [".. written by `raceway paper`; do not edit", "", ".. list-table::", "   :header-rows: 1",
             f"   :widths: {' '.join(str(width) for _, width in HEAD)}", ""]
    rows = [[name for name, _ in HEAD]]
    for one in judged:
        corrected = ": ".join(part for part in (f"**{one.corrected}**", _markup(one.corrected_numbers)) if part)
        printed = ": ".join(part for part in (f"**{one.printed}**" if one.printed != statements.SAME else one.printed,
                                              _markup(one.printed_numbers)) if part)
        rows.append([_markup(one.where), _markup(one.says), corrected, printed, _markup(one.why)])
    for row in rows:
        lines += [("   * - " if at == 0 else "     - ") + cell for at, cell in enumerate(row)]
    return "\n".join(lines) + "\n"


def _markup(text):
    text = re.sub(r"([*|`])", r"\\\1", text)
    return re.sub(r"\$([^$]+)\$", r":math:`\1`", text)


def _plain(text):
    return re.sub(r"[${}]", "", text)


def _csv(path, table):
    return _text(path, table.to_csv(index=False, float_format="%.7g", lineterminator="\n"))


def _text(path, text):
    return _whole(path, lambda part: Path(part).write_text(text, encoding="utf-8"))


def _whole(path, write):
    part = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write(part)
        part.replace(path)
    except OSError as error:
        raise RacewayError(f"cannot write {path}: {error.strerror or error}") from None
    finally:
        part.unlink(missing_ok=True)
    return path
