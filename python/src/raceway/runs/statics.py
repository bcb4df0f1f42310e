# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of statics at the operating point of a run, for comparison with the results of the run.

Statics is solved for the loads, speed, clearance, oil, temperature and models of the run. The
results are means, or largest values, over positions of the balls within a ball pass (`ball_pass`).
For a deck that does not record its variables, the inner ring is held at the measured axial
displacement and tilts.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from raceway import catalogue, inputs
from raceway.errors import InputError, NoEquilibrium
from raceway.runs.cage import ring_of_cage
from raceway.runs.flaws import by_part
from raceway.runs.measured import loading
from raceway.runs.record_tables import ring_place
from raceway.runs.settings import deck_words
from raceway.runs.tables import RunTables
from raceway.runs.turning import changes
from raceway.runs.warming import heated
from raceway.theory import ball_pass, models
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.cage_drag import CageRing

# keys of the results, grouped by how they follow from the values at all positions
MEANS = ("shift_z_m", "load_parameter", "capacitance_F", "friction_torque_N_m", "power_loss_W")
LARGEST = (
    *("q_max_N", "q_inner_max_N", "q_outer_max_N", "p_max_inner_Pa", "p_max_outer_Pa"),
    *("capacitance_top_F", "entrainment_speed_m_s"),
)
AT_LARGEST_LOAD = ("h_min_m", "h_c_m", "lambda", "asperity_share")
RENAMED = {"ring_shift_m": "shift_x_m", "cage_speed_rad_s": "orbital_speed_rad_s"}  # means as well
PLACE = ("shift_z_m", "tilt_x_rad", "tilt_y_rad")
FRICTION = ("friction_torque_N_m", "power_loss_W", "asperity_share")
# data on which the results do not depend
UNUSED = {
    *("none", "inner_shoulder_diameter", "outer_shoulder_diameter", "cage_ball_diameter"),
    *("pocket_play", "inner_mass", "inner_inertia", "inner_inertia_t"),
}
ROUNDING = 1e-9  # fraction of the larger tilt below which the other is a rounding error
SAME = 1e-6  # relative difference below which data of the run and of the file count as equal


class NoStatics(Exception):
    """Raised if statics does not apply to a run; the text is the reason."""


def statics(tables: RunTables, figures: Mapping[str, Any]) -> dict[str, Any]:
    """Return {"statics": {key: result}, "statics_absent": reason or None} for the run `tables`.

    `figures` is the summary of the run, which has the same keys and units. Raise `RunError` in the
    same cases as the summary.
    """
    try:
        return {"statics": _figures(tables, figures), "statics_absent": None}
    except (NoStatics, InputError, NoEquilibrium, ValueError) as why:
        return {"statics": {}, "statics_absent": str(why)}


def _figures(tables, run):
    _applies(tables, run)
    # This imports scipy's elliptic integrals and root finders, which a summary does not need.
    from raceway.theory.operating_point import figures

    words, seat = _point(tables, run)
    over = ball_pass.over(
        lambda phase: figures(**words, phase=phase, exact_circle=True),
        int(tables.settings["balls"]),
        _inner_loads,
        symmetric=not (words["held"].get("rx") or np.any(words.get("moment", 0.0))),
    )
    shares, found = zip(*over)
    _same_oil(found[0], tables)
    for one in found:
        one["power_loss_W"] = sum(one["losses_W"].values()) if one["losses_W"] else None
    result = {key: _mean(shares, found, key) for key in MEANS}
    result |= {key: _mean(shares, found, name) for key, name in RENAMED.items()}
    if result["cage_speed_rad_s"] is not None:  # statics is solved for the magnitude of the speed
        forwards = tables.turning.shaft_speed(tables.first, tables.last).mean() >= 0
        result["cage_speed_rad_s"] *= 1 if forwards else -1
    result |= {key: max(one[key] for one in found) for key in LARGEST if found[0].get(key)}
    top = max(found, key=lambda one: one["q_inner_max_N"])
    result |= {key: top.get(key) for key in AT_LARGEST_LOAD}
    if seat is None:
        result["shift_z_m"] = None
    else:
        result["shift_z_m"] -= seat
        result |= dict(zip(PLACE[1:], _turned(shares, found, tables)))
    left_out = models.absent(run["models"], FRICTION)
    return {k: value for k, value in result.items() if value is not None and k not in left_out}


def _inner_loads(found):
    """Return the loads (Z,) or (grooves, Z) of the inner contacts of all balls in N."""
    return np.transpose(
        [
            [one["q_N"] for one in ball["contacts"] if one["raceway"].startswith("inner")]
            if "contacts" in ball
            else [ball["q_inner_N"]]
            for ball in found["balls"]
        ]
    )


def _mean(shares, found, key):
    values = [one.get(key) for one in found]
    return None if None in values else float(np.average(values, weights=shares))


def _turned(shares, found, tables):
    """Return the mean tilts in rad about the axes of the run, converted from the tilts of statics
    about the axes of the load line."""
    azimuth = tables.settings["load_azimuth_rad"]
    x, y = (_mean(shares, found, key) for key in ("tilt_x_rad", "tilt_y_rad"))
    turned = (
        x * math.cos(azimuth) - y * math.sin(azimuth),
        x * math.sin(azimuth) + y * math.cos(azimuth),
    )
    return [tilt if abs(tilt) > ROUNDING * max(map(abs, turned)) else 0.0 for tilt in turned]


def need_steady_point(tables: RunTables) -> None:
    """Raise `NoStatics` if the run is not at one steady operating point of a bearing without flaws
    whose inner ring alone rotates."""
    load, turning = loading(tables), tables.turning
    if load is None:
        raise NoStatics("the record does not contain the forces on the ring")
    if load.turns or tables.settings.get("unbalance_kg_m"):
        raise NoStatics("the load rotates")
    if changes(turning.shaft_speed(tables.first, tables.last)):
        raise NoStatics("the speed changes")
    if turning.speed(OUTER, tables.first, tables.last).any():
        raise NoStatics("the outer ring rotates")
    if by_part(tables.settings):
        raise NoStatics("raceways or balls have flaws")
    if heated(tables):
        raise NoStatics("temperatures follow the losses of the run")


def _applies(tables, run):
    """Raise `NoStatics` if statics has no equivalent of the run."""
    need_steady_point(tables)
    if run["models"] not in (*models.STATICS, "film"):
        raise NoStatics(f"statics has no equivalent of models {run['models'] or 'without a name'}")


def _point(tables, run):
    """Return (keyword arguments of `operating_point.figures`, axial position of the inner ring).

    The run measures displacement from this position (m), at which the balls touch both raceways. It
    is None if statics does not determine it.
    """
    settings, deck = tables.settings, deck_words(tables.settings)
    given = str(settings.get("given_data", "none")).split(",")
    if own := [word for word in given if word.partition("=")[0] not in UNUSED]:
        raise NoStatics(f"the run has its own data: {', '.join(own)}")
    for name, usual in (("without", "none"), ("gap_film", "power"), ("inlet_shear", "murch")):
        if deck.get(name, usual) != usual:
            raise NoStatics(f"statics has no equivalent of -var {name} {deck[name]}")
    path = catalogue.find("bearings", str(settings["bearing"]))
    body, angle = inputs.bearing(path), inputs.nominal_angle(path)
    four_point = _four_point(tables, deck, path)
    if four_point is not None:
        body = inputs.bearing(path, four_point=four_point)
    _same_bearing(body, tables)
    azimuth = settings["load_azimuth_rad"]
    words = dict(
        bearing=str(path),
        lubricant=str(settings["lubricant"]) if tables.lubricated else None,
        models="full" if run["models"] == "film" else run["models"],
        clearance=0.0 if angle else float(settings["clearance_m"]),
        rpm=abs(float(settings["rpm"])),
        four_point=four_point,
        spin_law=deck.get("spin_law", "closed"),
        cage=_cage(tables.record, deck),
    )
    if tables.lubricated:
        words["temperature"] = settings.get("temperature_C")
    if "lubrication" in deck:
        from raceway.theory.oil_supply import Supply

        words["supply"] = Supply(deck["lubrication"], float(deck["oil_level"]))
    if not deck:  # only the main deck records which degrees of freedom are held
        z, *tilt = _place(tables)
        held = {"z": z}  # includes the displacement in which the balls start
        held.update(zip(("rx", "ry"), _about_load_line(*tilt, azimuth)))
        return words | dict(load=loading(tables).radial, held=held), None
    load, axial = float(settings["load_N"]), float(settings["axial_N"])
    seat = None if four_point and axial else math.copysign(body.seat(angle), axial)
    moment = [float(settings[f"moment_{axis}_N_m"]) for axis in "xy"]
    held = {} if any(moment) else {"rx": 0.0, "ry": 0.0}
    moment = _about_load_line(*moment, azimuth)
    return words | dict(load=load, axial=axial, moment=moment, held=held), seat


def _cage(record, deck):
    """Return the one-piece cage of a record with data from the `deck`, or None for other cages."""
    if (found := ring_of_cage(record)) is None:
        return None
    cage = CageRing(without=frozenset(deck.get("cage_without", "none").split("+")))
    if not math.isnan(found[1]):
        cage = cage._replace(play=found[1])
    for name in ("filled", "friction"):
        if f"cage_{name}" in deck:
            cage = cage._replace(**{name: float(deck[f"cage_{name}"])})
    if (guide := deck.get("cage_guide", "balls")) != "balls":
        radius, clearance, width = (
            float(deck[f"cage_{name}"]) for name in ("land", "clearance", "width")
        )
        cage = cage._replace(land=(radius, clearance, 2 * width), inner=guide == "inner")
    return cage


def _place(tables):
    """Return the mean axial displacement (m) and the mean tilts (rad) of the inner ring relative to
    the outer ring."""
    first = max(tables.first, 1)
    inner, outer = (
        np.array(ring_place(tables.record, side, first, tables.last)[2:]).mean(axis=1)
        for side in (INNER, OUTER)
    )
    return (inner - outer).tolist()


def _about_load_line(x, y, azimuth):
    """Convert components along the axes of the run to components along and across the load line."""
    return (
        x * math.cos(azimuth) + y * math.sin(azimuth),
        y * math.cos(azimuth) - x * math.sin(azimuth),
    )


def _four_point(tables, deck, path):
    """Return the contact angle in rad for two grooves per ring, or None for one groove."""
    if not tables.record.two_grooves:
        return None
    angle = float(deck.get("four_point", 0)) or math.degrees(inputs.four_point_angle(path) or 0)
    if not angle:
        raise NoStatics("the record has two grooves per ring but not their contact angle")
    return math.radians(angle)


def _same_bearing(body, tables):
    names = ("balls", "ball_diameter", "inner_groove", "outer_groove", "young", "poisson")
    own = tables.geometry
    for name in names:
        if not math.isclose(getattr(body, name), getattr(own, name), rel_tol=SAME):
            raise NoStatics(
                f"{name} is {getattr(own, name):g} in the run but {getattr(body, name):g} in the"
                " bearing's file"
            )


def _same_oil(found, tables):
    for key in ("viscosity_Pa_s", "pressure_viscosity_per_Pa", "roughness_m"):
        own = tables.settings.get(key)
        if key in found and own and not math.isclose(found[key], own, rel_tol=SAME):
            raise NoStatics(
                f"{key} is {own:g} in the run but {found[key]:g} in the lubricant's file"
            )
