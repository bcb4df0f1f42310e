# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes the bearings of inputs/catalogue as files of inputs/bearings: `make bearings`.

A file has the maker's data. Of balls the maker states, the number follows from C0; others are those
that `raceway.load_rating.balls` finds for the ratings.
"""

import csv
import math
import sys
from pathlib import Path

import yaml
from raceway.theory import load_rating

ROOT = Path(__file__).resolve().parents[1]
TABLES = ROOT / "inputs" / "catalogue"
BEARINGS = ROOT / "inputs" / "bearings"
TYPES = {
    "deep_groove": "deep groove ball bearing",
    "angular_contact": "angular contact ball bearing",
    "four_point": "four-point contact ball bearing",
}
# column of a table: variable, factor to SI, what and unit
STATED = {
    "inner_shoulder": ("inner_shoulder_diameter", 1e-3, "m; d1"),
    "outer_shoulder": ("outer_shoulder_diameter", 1e-3, "m; D1"),
    "dynamic": ("basic_dynamic_load", 1.0, "N; C"),
    "static": ("basic_static_load", 1.0, "N; C0"),
    "fatigue": ("fatigue_load_limit", 1.0, "N; Pu"),
    "reference_speed": ("reference_speed", 1.0, "rpm, thermal, ISO 15312"),
    "limiting_speed": ("limiting_speed", 1.0, "rpm"),
    "limiting_speed_grease": ("limiting_speed_grease", 1.0, "rpm"),
    "mass": ("bearing_mass", 1.0, "kg"),
    "minimum_load_factor": ("minimum_load_factor", 1.0, "k_r of the minimum load"),
}


def files() -> dict[str, str]:
    """{name: text} of every bearing of the tables."""
    sources = yaml.safe_load((TABLES / "sources.yaml").read_text())
    return {
        row["name"]: _text(kind, row, sources)
        for kind in TYPES
        for row in csv.DictReader((TABLES / f"{kind}.csv").read_text().splitlines())
    }


def _text(kind, row, sources):
    source = row["source"]
    four_point = row.get("four_point")
    angle = float(four_point or row.get("contact_angle") or 0)
    bore, outside, width = (1e-3 * float(row[name]) for name in ("bore", "outside", "width"))
    stated = bool(row.get("ball"))
    pitch = 1e-3 * float(row["pitch"]) if row.get("pitch") else (bore + outside) / 2
    if stated:
        ball = 1e-3 * float(row["ball"])
        number = load_rating.number(float(row["static"]), ball, pitch, math.radians(angle))
    else:
        number, ball = load_rating.balls(
            float(row["dynamic"]),
            float(row["static"]),
            pitch,
            math.radians(angle),
            sources[source]["dynamic_factor"],
            rows=2 if four_point else 1,
        )
    sizes = " x ".join(row[name] for name in ("bore", "outside", "width"))
    lines = [
        f"# {row['name']} {TYPES[kind]}, {sizes} mm",
        "# Written by `make bearings` from inputs/catalogue. Boundary dimensions: ISO 15.",
        f"# {source}: {sources[source]['text']}",
        "# Number of balls: follows from C0 and their diameter (raceway.load_rating.number)"
        if stated
        else "# Balls: estimated from C and C0 by raceway.load_rating.balls; not the maker's",
        _line("balls", number, "from C0" if stated else "estimate"),
        _line("ball_diameter", _metres(round(ball, 6)), f"m; {source if stated else 'estimate'}"),
        _line(
            "pitch_diameter",
            _metres(pitch),
            f"m; {source if row.get('pitch') else '(bore + outside diameter)/2'}",
        ),
        _line("inner_conformity", 0.52, "usual value"),
        _line("outer_conformity", 0.53, "usual value"),
    ]
    if angle:
        name = "four_point" if four_point else "contact_angle"
        lines.append(_line(name, f"{angle:g}", f"degrees, nominal; {source}"))
    lines += [
        _line("pocket_play", _metres(round(0.01 * ball, 5)), "m, along the pitch circle; estimate"),
        _line("bore_diameter", _metres(bore), "m; ISO 15"),
        _line("outside_diameter", _metres(outside), "m; ISO 15"),
        _line("bearing_width", _metres(width), "m; ISO 15"),
    ]
    if kind == "deep_groove":
        lines.append(_line("series", row["name"][:2], "of SKF's friction torque"))
    for column, (name, factor, what) in STATED.items():
        if row.get(column):
            value = float(row[column])
            said = _metres(factor * value) if factor != 1 else f"{value:g}"
            lines.append(_line(name, said, f"{what}, {source}"))
    return "\n".join([*lines, "include ${inputs}/modules/bearing.usual"]) + "\n"


def _metres(value):
    return f"{1e3 * value:.6g}e-3"


def _line(name, value, comment):
    return f"variable {name:<23} index {value!s:<10} # {comment}"


if __name__ == "__main__":
    for name, text in files().items():
        (BEARINGS / name).write_text(text)
    print(f"Wrote {len(files())} files into {BEARINGS.relative_to(ROOT)}", file=sys.stderr)
