# SPDX-License-Identifier: GPL-2.0-or-later
"""Cleanliness of the lubricant, as used for the rating life: the classes of ISO 281 and their
values of e_C."""

from collections.abc import Mapping

# ranges of e_C (ISO 281:2007, table 13) for pitch diameters below 100 mm, and for larger ones
CLEANLINESS: Mapping[str, tuple[tuple[float, float], tuple[float, float]]] = {
    "extreme": ((1.0, 1.0), (1.0, 1.0)),
    "high": ((0.6, 0.8), (0.8, 0.9)),
    "normal": ((0.5, 0.6), (0.6, 0.8)),
    "slight": ((0.3, 0.5), (0.4, 0.6)),
    "typical": ((0.1, 0.3), (0.2, 0.4)),
    "severe": ((0.0, 0.1), (0.0, 0.1)),
    "very severe": ((0.0, 0.0), (0.0, 0.0)),
}


def contamination(cleanliness: str, pitch_diameter: float) -> float:
    """Return e_C, taken as the middle of the range for a class in `CLEANLINESS`; `pitch_diameter`
    is in m. Raises `ValueError` for an unknown class."""
    if cleanliness not in CLEANLINESS:
        raise ValueError(f"cleanliness '{cleanliness}' is not one of {', '.join(CLEANLINESS)}")
    return sum(CLEANLINESS[cleanliness][pitch_diameter >= 0.1]) / 2
