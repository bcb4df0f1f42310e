# SPDX-License-Identifier: GPL-2.0-or-later
"""Clearance classes C2, CN, C3, C4 and C5 of deep groove ball bearings with a cylindrical bore (ISO
5753:1991, as reproduced in SKF General Catalogue 6000, Russian edition, 2006, page 297; taken from
the text layer of the catalogue in github.com/ArtemFilin1990/Mar)."""

import csv
from pathlib import Path

TABLE = Path(__file__).with_suffix(".csv")  # bores in mm, clearances in um
NAMES = ("C2", "CN", "C3", "C4", "C5")


def of_bore(bore: float) -> dict[str, tuple[float, float]]:
    """Return {class: (smallest, largest)}, the limits in m of the diametral clearance of an
    unmounted and unloaded bearing at uniform temperature, for a `bore` in m. There are no classes
    C4 and C5 for bores up to 6 mm. Raises `ValueError` unless the bore is above 0 and at most 0.12
    m.

    >>> of_bore(40e-3)["C3"]
    (1.5e-05, 3.3e-05)
    """
    for row in csv.DictReader(TABLE.read_text().splitlines()):
        # rounded to 9 digits so that 40e-3 m is exactly 40 mm despite rounding errors
        if float(row["bore_above"]) < round(1e3 * bore, 9) <= float(row["bore_to"]):
            return {
                name: tuple(round(1e-6 * float(row[f"{name}_{end}"]), 12) for end in ("min", "max"))
                for name in NAMES
                if row[f"{name}_min"]
            }
    raise ValueError(f"bore = {bore:g} m: the classes of ISO 5753 are known for 0 to 0.12 m")
