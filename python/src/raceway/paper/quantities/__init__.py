# SPDX-License-Identifier: GPL-2.0-or-later
"""The quantities by which the statements of the paper are judged.

`measure(book, printed)` of every module returns {name: value}, for the names in quantities.yaml.
With `printed`, the quantities affected by eqs 2, 3 and 9 follow from the formulas as printed; other
quantities do not depend on `printed`.
"""

from raceway.paper.book import Book
from raceway.paper.quantities import capacitance, formulas, loads, motion, oil, whole
from raceway.paper.quantity import Quantity, labelled

MODULES = (formulas, loads, motion, oil, capacitance)


def measure(book: Book, printed: bool = False) -> dict[str, Quantity]:
    """Return {name: `Quantity`} from all modules."""
    result = {}
    for module in MODULES:
        result |= module.measure(book, printed)
    return labelled(result)


def measure_whole(book: Book) -> dict[str, Quantity]:
    """Return {name: `Quantity`} for quantities that differ if the total capacitance is used, or
    that exist only with it, using the corrected formulas."""
    return labelled(whole.measure(book))
