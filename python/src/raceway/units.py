# SPDX-License-Identifier: GPL-2.0-or-later
"""Convert numbers with units and SI prefixes to text and back."""

import math
import re

PREFIX = {-15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}


def prefixed(value: float, unit: str, digits: int = 4) -> str:
    """Format `value` in `unit` with `digits` significant digits and an SI prefix. For example,
    2.571e9 and "Pa" give 2.571 GPa.

    No prefix is used for values without a unit, in degrees or in m³/s, or for angles below 1
    µrad.

    >>> prefixed(2.571e9, "Pa"), prefixed(3.4867e-05, "m"), prefixed(1.4, "")
    ('2.571 GPa', '34.87 µm', '1.4')
    >>> prefixed(2.22e-16, "rad"), prefixed(3e-6, "rad"), prefixed(-0.54, "°")
    ('2.22e-16 rad', '3 µrad', '-0.54 °')
    """
    if unit in ("", "°", "m³/s") or value == 0 or not math.isfinite(value):
        return f"{value:.{digits}g} {unit}".strip()
    value = float(f"{value:.{digits - 1}e}")  # round first, so that 999.99 m becomes 1 km
    power = _power(value)
    if abs(value) < (1e-6 if unit == "rad" else 1e-18):  # smaller than the smallest prefix allows
        return f"{value:.{digits}g} {unit}"
    return f"{value / 10.0**power:.{digits}g} {PREFIX[power]}{unit}"


# {requested unit: {accepted unit: factor}}; units in `SCALED` are also accepted with SI prefixes.
# For all other units, such as passes, only plain numbers are accepted.
SPELLED = {
    "C": {"C": 1.0, "°C": 1.0, "degC": 1.0},
    "degrees": {"deg": 1.0, "°": 1.0, "degrees": 1.0, "arcmin": 1 / 60, "rad": 180 / math.pi},
    "rad": {
        "deg": math.pi / 180,
        "°": math.pi / 180,
        "arcmin": math.pi / 10800,
        "'": math.pi / 10800,
    },
    "kg/m^3": {"kg/m^3": 1.0, "kg/m3": 1.0, "g/cm3": 1e3, "g/cm^3": 1e3},
    "m^3/s": {
        "m^3/s": 1.0,
        "m3/s": 1.0,
        "L/min": 1e-3 / 60,
        "l/min": 1e-3 / 60,
        "mL/min": 1e-6 / 60,
        "L/h": 1e-3 / 3600,
    },
    "rpm": {"rpm": 1.0, "krpm": 1e3, "1/min": 1.0, "Hz": 60.0},
}
SCALED = {"N", "N m", "m", "Hz", "V", "V/m", "F", "W/K", "ohm", "ohm m", "rad"}
MILLI = {"mm": "m"}  # units that are thousandths of another unit
NUMBER = re.compile(r"([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)(.*)", re.DOTALL)


def read(text: str, unit: str) -> float:
    """Convert `text` to a value in `unit`. The text is a plain number or a number with a unit, such
    as 5kN or 10um.

    Both u and µ mean micro. Raises `ValueError` if the text is not a number or has an incompatible
    unit.

    >>> read("5kN", "N"), read("0.05", "mm"), read("50um", "mm"), read("2krpm", "rpm")
    (5000.0, 0.05, 0.05, 2000.0)
    """
    try:
        return float(text)
    except ValueError:
        pass
    match = NUMBER.fullmatch(text.strip())
    factor = match and _factor(match[2], unit)
    if factor is None:
        raise ValueError(f"'{text}' is not a number{_hint(unit)}")
    value, power = float(match[1]), math.log10(factor)
    # parse the decimal text 10e-6, so that 10um equals 1e-05 exactly
    if abs(power - round(power)) < 1e-12 and "e" not in match[1].lower():
        return float(f"{match[1]}e{round(power)}")
    return value * factor


def _factor(written, unit):
    spelling = written.strip()
    if unit in SPELLED and spelling in SPELLED[unit]:
        return SPELLED[unit][spelling]
    if unit in MILLI:
        factor = _factor(written, MILLI[unit])
        return factor and 1e3 * factor
    if unit not in SCALED:
        return None
    plain, base = (re.sub(r"[ *·]", "", one) for one in (spelling, unit))
    plain = plain.replace("Ω", "ohm").replace("μ", "µ")  # replace Greek mu by the micro sign
    prefix = plain.removesuffix(base)
    if prefix == plain or prefix == "":
        return 1.0 if prefix == "" else None
    powers = {sign: power for power, sign in PREFIX.items() if sign} | {"u": -6}
    return 10.0 ** powers[prefix] if prefix in powers else None


def _hint(unit):
    """Return the part of an error message that gives an example of a value in `unit`."""
    example = {"rpm": "3000rpm", "C": "60C", "degrees": "40deg", "kg/m^3": "7.8g/cm3"}
    example["m^3/s"] = "1.5L/min"
    example |= {"m": "10um", "mm": "80mm", "N": "5kN", "rad": "20arcmin, 0.3deg or 5mrad"}
    if unit in example or unit in SCALED:
        return f" in {unit}: give 12.5 or, with its unit, {example.get(unit, f'5k{unit}')}"
    return ""


def axis(largest: float, unit: str) -> tuple[float, str]:
    """Return (factor, unit with prefix) for an axis whose largest value is `largest` in `unit`.

    >>> axis(2436, "N"), axis(12.0, "m/s^2")
    ((0.001, 'kN'), (1.0, 'm/s²'))
    """
    power = _power(abs(largest)) if largest and math.isfinite(largest) else 0
    return 10.0**-power, PREFIX[power] + unit.replace("^2", "²")


def _power(value):
    power = 3 * math.floor(math.log10(abs(value)) / 3 + 1e-12)
    return min(max(power, min(PREFIX)), max(PREFIX))
