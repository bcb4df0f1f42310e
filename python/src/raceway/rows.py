# SPDX-License-Identifier: GPL-2.0-or-later
"""Format results as text, with one line per value below the heading of its topic."""

import math
from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

from raceway.units import prefixed


class Row(NamedTuple):
    """One line of a table of results."""

    key: str
    label: str
    # SI unit, shown with a prefix; "deg" for radians shown in degrees, "" for a plain number, None
    # for text
    unit: str | None
    source: str = ""
    zero: str | None = None  # text that is shown instead of the value 0


# Quantities that both runs and statics report, with common labels.
FIGURES = {
    row.key: row
    for row in (
        Row("bearing", "bearing", None),
        Row("lubricant", "lubricant", None),
        Row("models", "models", None),
        Row("load_N", "radial load", "N"),
        Row("rpm", "inner ring speed", "rpm"),
        Row("clearance_m", "diametral clearance P_d", "m"),
        Row("viscosity_Pa_s", "viscosity", "Pa s", "eta of eq 6"),
        Row("pressure_viscosity_per_Pa", "pressure-viscosity coefficient", "1/GPa", "xi of eq 6"),
        Row("permittivity", "relative permittivity at rest", "", "eps_r of eq 10"),
        Row("roughness_m", "roughness", "m", "sigma of eq 7"),
        Row("shift_z_m", "axial displacement", "m"),
        Row("tilt_x_rad", "tilt about x", "rad"),
        Row("tilt_y_rad", "tilt about y", "rad"),
        Row(
            "load_parameter",
            "load distribution factor",
            "",
            "1/2 (1 - P_d/(2 displacement)), app. A",
        ),
        Row("q_inner_max_N", "largest load, inner raceway", "N", "eq 2"),
        Row("q_outer_max_N", "largest load, outer raceway", "N", "eq 2"),
        Row("p_max_inner_Pa", "Hertz pressure there, inner", "Pa", "1.5 Q/(pi a b)"),
        Row("p_max_outer_Pa", "Hertz pressure there, outer", "Pa", "1.5 Q/(pi a b)"),
        Row("entrainment_speed_m_s", "entrainment speed", "m/s", "U_r of eq 6, inner"),
        Row("h_min_m", "minimum film thickness", "m", "eq 6"),
        Row("h_c_m", "central film thickness", "m", "eq 9"),
        Row("lambda", "lambda ratio", "", "eq 7"),
        Row("capacitance_F", "plates", "F", "contact ellipses, eq 12"),
        Row("capacitance_top_F", "largest of one ball", "F", "eqs 8, 10-12"),
        Row("cage_speed_rad_s", "cage speed", "rad/s"),
    )
}


# arrangement of the grooves of a bearing, as returned by `bearing.grooves`
GROOVES = (
    Row("four_point_rad", "four-point contact angle", "deg", "of centred balls"),
    Row("row_spacing_m", "distance of the rows", "m"),
    Row("row_preload_m", "preload of each row", "m"),
    Row("arrangement", "arrangement of the rows", None),
)


def row(key: str, source: str | None = None) -> Row:
    """Return the row of `FIGURES` with the given `key`. If a `source` is given, it replaces that of
    the row. Raises `KeyError` for an unknown key."""
    return FIGURES[key] if source is None else FIGURES[key]._replace(source=source)


def lines(
    figures: Mapping[str, Any],
    topics: Mapping[str, Sequence[Row]],
    errors: Mapping[str, float] | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
    second: tuple[str, Mapping[str, Any]] | None = None,
) -> list[str]:
    """Return the lines of a table with the given `topics`, {heading: rows}. Quantities whose value
    is None are left out. `errors` {key: error in the unit of the quantity} are shown in a separate
    column, and `ranges` {key: (low, high)} at the end of each line. `second`, i.e. (name, {key:
    value}), adds a second column of values. Its name is shown above the column in each topic for
    which there are values."""
    result = []
    name, others = second or ("", {})
    for topic, rows in topics.items():
        block = cells(figures, {topic: rows}, errors, ranges, others)
        there = any(row.key in others for row in rows if figures[row.key] is not None)
        for head, *cell in block:
            if not cell:
                result += ["", f"{head:<34}{'run':>14}{name:>14}" if there else head]
                continue
            value, other, error, span, source = cell
            value = f"{value:>14}{other:>14}" if there else f"{value:>14}"
            error = "" if errors is None else f"{error:>12}"
            span = f"  range {span}" if span else ""
            source = f"({source})" if source else ""
            result.append(f"  {head:<32}{value}{error}  {source}{span}".rstrip())
    return result[1:]


def several(
    results: Sequence[Mapping[str, Any]],
    columns: Sequence[tuple[str, str, float]],
    optional: Collection[str] = (),
) -> str:
    """Format several dicts of results as a table with one line per dict, followed by their
    warnings. `columns` are (key, heading, factor); a column of `optional` keys is omitted if it is
    0 in all lines."""
    columns = [c for c in columns if c[0] not in optional or any(one[c[0]] for one in results)]
    rows = [[heading for _, heading, _ in columns]]
    rows += [[_plain(one.get(key), scale) for key, _, scale in columns] for one in results]
    said = dict.fromkeys(one for result in results for one in result["warnings"])
    return "\n".join([*aligned(rows, ""), *warning_lines(said)])


def aligned(rows: Sequence[Sequence[str]], indent: str = "  ") -> list[str]:
    """Return the lines of a table whose cells are aligned to the right."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return [indent + "  ".join(cell.rjust(n) for cell, n in zip(one, widths)) for one in rows]


def warning_lines(texts: Collection[str]) -> list[str]:
    """Return the last lines of a table, which contain its warnings; the list may be empty."""
    return ["", "Warnings", *(f"  {text}" for text in texts)] if texts else []


def cells(
    figures: Mapping[str, Any],
    topics: Mapping[str, Sequence[Row]],
    errors: Mapping[str, float] | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
    others: Mapping[str, Any] | None = None,
) -> list[tuple[str, ...]]:
    """Return the rows of a table of results as (label, value, value in `others`, error, range,
    source). The rows of each topic are preceded by a row (topic,)."""
    others = others or {}
    result: list[tuple[str, ...]] = []
    for topic, rows in topics.items():
        block = [
            (
                row.label,
                _value(row, figures[row.key]),
                _value(row, others[row.key]) if row.key in others else "",
                _error(row, errors),
                _range(row, ranges),
                row.source,
            )
            for row in rows
            if figures[row.key] is not None
        ]
        if block:
            result += [(topic,), *block]
    return result


def _plain(value, scale):
    if value is None:
        return "-"
    return f"{scale * value:.0f}" if abs(scale * value) >= 1e4 else f"{scale * value:.4g}"


def _value(row, value):
    if row.zero and value == 0:
        return row.zero
    if row.unit is None or isinstance(value, str):  # text, or the reason why the value is missing
        return value
    return _shown(value, row.unit, 4)


def _range(row, ranges):
    if not ranges or row.key not in ranges:
        return ""
    return " to ".join(_shown(end, row.unit, 3) for end in ranges[row.key])


def _error(row, errors):
    known = errors and errors.get(row.key) and row.unit is not None
    return " ±" + _shown(errors[row.key], row.unit, 3) if known else ""


def _shown(value, unit, digits):
    if unit == "rpm":
        return f"{value:g} rpm"
    if unit == "°C":
        return f"{value:.{digits}g} °C"
    if unit == "deg":
        return f"{math.degrees(value):.{digits}g} °"
    if unit == "1/GPa":
        return f"{value * 1e9:.{digits}g} 1/GPa"
    return prefixed(value, unit, digits) if unit else f"{value:.{digits}g}"
