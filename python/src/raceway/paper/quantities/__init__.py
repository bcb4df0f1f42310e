# SPDX-License-Identifier: GPL-2.0-or-later
"""The quantities by which the statements of the paper are judged.

`measure(book, printed)` of every module returns {name: `Quantity`}. With `printed`, the quantities
affected by eqs 2, 3 and 9 follow from the formulas as printed; other quantities do not depend on
`printed`. `measure_whole` returns the quantities that differ if the total capacitance is used, or
that exist only with the total capacitance.
"""

from raceway.paper.book import Book
from raceway.paper.quantities import capacitance, formulas, loads, motion, oil, whole
from raceway.paper.quantity import Quantity

MODULES = (formulas, loads, motion, oil, capacitance)


def measure(book: Book, printed: bool = False) -> dict[str, Quantity]:
    """Return {name: `Quantity`} from all modules."""
    result = {}
    for module in MODULES:
        result |= module.measure(book, printed)
    return result


def measure_whole(book: Book) -> dict[str, Quantity]:
    """Return {name: `Quantity`} for quantities that involve more than the capacitance of the
    plates, using the corrected formulas."""
    return whole.measure(book)
