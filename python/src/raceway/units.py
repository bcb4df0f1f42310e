# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers for people: SI prefixes."""

import math

PREFIX = {-15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}


def prefixed(value: float, unit: str, digits: int = 4) -> str:
    """`value` in `unit` as text with `digits` significant digits and an SI prefix: 2.571e9, "Pa" ->
    2.571 GPa.

    A value without a unit gets no prefix either.

    >>> prefixed(2.571e9, "Pa"), prefixed(3.4867e-05, "m"), prefixed(1.4, "")
    ('2.571 GPa', '34.87 µm', '1.4')
    """
    if not unit or value == 0 or not math.isfinite(value):
        return f"{value:.{digits}g} {unit}".strip()
    value = float(f"{value:.{digits - 1}e}")  # first, so that 999.99 m becomes 1 km and not 1000 m
    power = _power(value)
    if abs(value) < 1e-18:  # of no prefix
        return f"{value:.{digits}g} {unit}"
    return f"{value / 10.0**power:.{digits}g} {PREFIX[power]}{unit}"


def axis(largest: float, unit: str) -> tuple[float, str]:
    """(factor, unit with prefix) of an axis that reaches `largest`.

    >>> axis(2436, "N")
    (0.001, 'kN')
    """
    power = _power(abs(largest)) if largest and math.isfinite(largest) else 0
    return 10.0**-power, PREFIX[power] + unit


def _power(value):
    power = 3 * math.floor(math.log10(abs(value)) / 3 + 1e-12)
    return min(max(power, min(PREFIX)), max(PREFIX))
