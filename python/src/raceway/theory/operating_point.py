# SPDX-License-Identifier: GPL-2.0-or-later
"""The figures of a bearing at one operating point from theory: `figures` as a mapping, `table` as
text.

The mapping's keys are a promise to scripts; where `summary` has the same figure it has the same
key.
"""

import math
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from raceway import catalogue, inputs
from raceway.files import FilePath
from raceway.rows import Row, lines, row
from raceway.theory import (
    clearance,
    friction_torque,
    life,
    makers,
    many_grooves,
    ring_response,
    validity,
)
from raceway.theory import four_point as contacts_of_grooves
from raceway.theory.contact_law import FilmInGap
from raceway.theory.friction_torque import Surfaces
from raceway.theory.lubrication import lubricate, turning
from raceway.theory.small_motion import response
from raceway.theory.static import FREEDOMS
from raceway.units import prefixed

MODELS = ("paper", "full")
SUPPORT = ("support_x_N", "support_y_N", "support_z_N", "support_rx_N_m", "support_ry_N_m")
TOPICS = {
    "Operating point": (
        row("bearing"),
        row("lubricant"),
        Row("temperature_C", "temperature", "°C", "of the lubricant"),
        row("models"),
        row("load_N", "along x"),
        Row("axial_N", "axial load", "N", "along z"),
        Row("moment_x_N_m", "moment about x", "N m"),
        Row("moment_y_N_m", "moment about y", "N m"),
        row("clearance_m"),
        Row("four_point_rad", "contact angle of four points", "°", "of balls in the middle"),
        row("rpm"),
        Row("orbital_speed_rad_s", "cage speed", "rad/s", "rolling, Harris ch. 10"),
        Row("centrifugal_N", "centrifugal load of a ball", "N", "m r omega^2"),
    ),
    "Inner ring": (
        Row("shift_x_m", "displacement along x", "m", "Harris ch. 7"),
        Row("shift_y_m", "displacement along y", "m", "Harris ch. 7"),
        row("shift_z_m", "Harris ch. 7"),
        row("tilt_x_rad", "Harris ch. 7"),
        row("tilt_y_rad", "Harris ch. 7"),
        row("load_parameter"),
        Row("stiffness_x_N_m", "stiffness along x", "N/m", "d(load)/d(displacement)"),
        Row("stiffness_z_N_m", "stiffness along z", "N/m", "the others held"),
        Row("stiffness_ry_N_m_rad", "tilting stiffness about y", "N m/rad", "the others held"),
    ),
    "What holds the ring": (
        Row("support_x_N", "force along x", "N"),
        Row("support_y_N", "force along y", "N"),
        Row("support_z_N", "force along z", "N"),
        Row("support_rx_N_m", "moment about x", "N m"),
        Row("support_ry_N_m", "moment about y", "N m"),
    ),
    "Loads and pressures": (
        Row("loaded_balls", "balls loaded on both raceways", "", "N_l of eq 12"),
        row("q_inner_max_N"),
        row("q_outer_max_N"),
        row("p_max_inner_Pa"),
        row("p_max_outer_Pa"),
        Row("angle_max_rad", "largest contact angle", "°", "of loaded balls"),
    ),
    "Rating life": (
        Row("static_safety", "static safety", "", "(4.2 GPa/p)^3, ISO 76"),
        Row("equivalent_load_N", "equivalent load", "N", "ISO/TS 16281"),
        Row("life_reference_Mrev", "reference life, 10^6 turns", "", "ISO/TS 16281"),
        Row("life_reference_h", "reference life, hours", "", "90 % survive"),
        Row("viscosity_ratio", "viscosity ratio kappa", "", "ISO 281"),
        Row("life_factor", "life modification factor", "", "a_ISO of ISO 281"),
        Row("life_modified_h", "modified reference life, hours", "", "a_ISO L_10r"),
        Row("minimum_load_N", "minimum radial load", "N", "SKF's k_r, formula from memory"),
    ),
    "Damping of the ring": (
        Row("damping_x_N_s_m", "damping along x", "N s/m", "slow motion, the others held"),
        Row("damping_z_N_s_m", "damping along z", "N s/m", "slow motion, the others held"),
        Row("damping_law", "law of the contacts", None),
    ),
    "Film at the largest inner load": (
        row("viscosity_Pa_s"),
        row("entrainment_speed_m_s", "U_r of eq 6, rolling"),
        row("h_min_m"),
        row("h_c_m"),
        row("lambda"),
        Row("film_factor", "factor of inlet shear", "", "Murch-Wilson"),
        Row("asperity_share", "load share of asperities", "", "Zhou-Hoeprich"),
    ),
    "Friction torque": (
        Row("friction_torque_N_m", "of the inner ring", "N m", "power over speed"),
        Row("torque_skf_N_m", "SKF, oil to the middle of a ball", "N m", "10000 EN 2013"),
        Row("torque_palmgren_N_m", "Palmgren, oil bath", "N m"),
        Row("loss_rolling_W", "hydrodynamic rolling", "W", "Biboulet-Houpert"),
        Row("loss_slip_W", "differential slip", "W", "Heathcote"),
        Row("loss_spin_W", "spin", "W"),
        Row("loss_hysteresis_W", "hysteresis", "W"),
        Row("loss_drag_W", "drag of the balls", "W"),
    ),
    "Capacitance": (
        row("capacitance_F"),
        row("capacitance_top_F"),
    ),
}
COLUMNS = (  # of the table of balls: key, heading, SI unit
    ("azimuth_rad", "azimuth, °", "deg"),
    ("q_inner_N", "Q inner", "N"),
    ("q_outer_N", "Q outer", "N"),
    ("angle_inner_rad", "angle in., °", "deg"),
    ("angle_outer_rad", "angle out., °", "deg"),
    ("p_inner_Pa", "p inner", "Pa"),
    ("p_outer_Pa", "p outer", "Pa"),
    ("h_min_inner_m", "h_min in.", "m"),
    ("lambda_inner", "lambda in.", ""),
    ("h_min_outer_m", "h_min out.", "m"),
    ("lambda_outer", "lambda out.", ""),
    ("capacitance_F", "C", "F"),
)
CONTACT_COLUMNS = (  # of the table of contacts with two grooves a ring
    ("azimuth_rad", "azimuth, °", "deg"),
    ("raceway", "contact", None),
    ("q_N", "Q", "N"),
    ("angle_rad", "angle, °", "deg"),
    ("p_Pa", "p", "Pa"),
    ("h_min_m", "h_min", "m"),
    ("lambda", "lambda", ""),
    ("capacitance_F", "C", "F"),
)


def figures(
    bearing: str,
    lubricant: str | None = None,
    folder: FilePath | None = None,
    *,
    load: float = 0.0,
    axial: float = 0.0,
    moment: ArrayLike = (0.0, 0.0),
    held: Mapping[str, float] | None = None,
    clearance: float = 0.0,
    rpm: float = 0.0,
    phase: float = 0.0,
    density: float | None = None,
    exact_circle: bool = False,
    models: str = "paper",
    spin_law: str = "closed",
    temperature: float | None = None,
    cleanliness: str = "normal",
    four_point: float | None = None,
) -> dict[str, Any]:
    """Figures by name in SI units, text, numbers or None; `balls` is a list of one mapping a ball.

    `bearing` and `lubricant` are names or paths of data files, looked up in the inputs `folder`
    (`catalogue.find`); the other arguments are those of `static.equilibrium`, with `rpm` of the
    inner ring and the load along x. What is not `held` is free. `models` is one of `MODELS`: "full"
    has the film in the gap, inlet shear and the friction torque, with the `spin_law` of
    `friction_torque.losses`. `temperature` of the lubricant is in degrees C, its file's unless
    given. `cleanliness` is a word of `cleanliness.CLEANLINESS`. `four_point` in rad makes it a
    four-point contact bearing with that angle, as its file may, too. Each of `balls` then has a
    list of `contacts`.

    Raises `RacewayError`: `NoEquilibrium`, or `InputError` for a data file, and for four points
    with `exact_circle` or the models "full", which need one groove a ring; `ValueError` for other
    models or another word.
    """
    path = catalogue.find("bearings", bearing, folder)
    if models not in MODELS:
        raise ValueError(f"models '{models}' is none of {', '.join(MODELS)}")
    body, (oil, fluid) = inputs.bearing(path, four_point=True), _oil(lubricant, folder, temperature)
    spin, held = rpm * math.pi / 30, held or {}
    density = float(inputs.values(path).get("ball_density", 7800.0)) if density is None else density
    if four_point is None:
        four_point = inputs.four_point_angle(path)
    find: dict[str, Any] = {"finite_shift": exact_circle}
    if four_point is not None:
        body, find = _four_point(path, body, four_point, clearance, models, exact_circle)
    film = FilmInGap(fluid, spin) if models == "full" and oil is not None and spin else None
    if film is not None:
        find["film"] = film
    state, orbit = turning(
        body,
        spin,
        load,
        axial,
        moment=moment,
        held=held,
        clearance=clearance,
        phase=phase,
        ball_density=density,
        **find,
    )
    result = dict(
        bearing=path.name,
        lubricant=None if oil is None else str(lubricant),
        temperature_C=None if oil is None or math.isnan(fluid.temperature) else fluid.temperature,
        models=models,
        friction_torque_N_m=None,
        losses_W=None,
        damping=None,
        load_N=load,
        axial_N=axial,
        moment_x_N_m=moment[0],
        moment_y_N_m=moment[1],
        clearance_m=clearance,
        rpm=rpm,
        four_point_rad=four_point,
        orbital_speed_rad_s=orbit,
        exact_circle=exact_circle,
        centrifugal_N=4
        / 3
        * math.pi
        * body.ball_radius**3
        * density
        * body.pitch_radius
        * orbit**2,
    )
    result.update(_ring(state, load, axial, moment, held, clearance, body.pitch_radius))
    result.update(_loads(state))
    result.update(_life(path, body, state, rpm, fluid, cleanliness, four_point))
    films = None
    if oil is not None and spin:
        films = lubricate(body, state, oil, spin, clearance, film and film.factor)
        top = int(np.argmax(state.inner.load))
        result.update(
            viscosity_Pa_s=oil.viscosity,
            pressure_viscosity_per_Pa=oil.pressure_viscosity,
            permittivity=oil.permittivity,
            roughness_m=oil.roughness,
            entrainment_speed_m_s=films.inner.entrainment.flat[top],
            h_min_m=films.inner.h_min.flat[top],
            h_c_m=films.inner.h_c.flat[top],
            capacitance_F=films.total,
            capacitance_top_F=films.ball.max(),
        )
        result["lambda"] = films.inner.ratio.flat[top]
        result.update(_damping(body, state, films, oil, models, clearance))
    if film is not None:
        boundary = inputs.boundary(path)
        result.update(film_factor=film.factor(films.inner.entrainment[top]))
        result.update(
            _friction(
                body, boundary, state, films, fluid, spin, orbit, clearance, load, axial, spin_law
            )
        )
    result = {key: _plain(value) for key, value in result.items()}
    result["warnings"] = _warnings(result, body, inputs.shoulders(path), state, films)
    of_balls = _balls if four_point is None else _balls_in_grooves
    result["balls"] = of_balls(state, films)
    return result


def _warnings(figures, body, shoulders, state, films):
    sides = (state.inner, state.outer)
    loaded = [side.load > 0 for side in sides]
    pressure = max(figures["p_max_inner_Pa"], figures["p_max_outer_Pa"])
    found = {"pressure": pressure}
    if films is not None:
        wet = ((films.inner, loaded[0]), (films.outer, loaded[1]))
        ratios = np.concatenate([side.ratio[live] for side, live in wet])
        thick = [side.h_c[live] / one.b[live] for (side, live), one in zip(wet, sides)]
        if len(ratios):
            found["thick_film"] = np.concatenate(thick).max()
            found["lambda"], found["conducts"] = ratios.max(), ratios.min()
    angle = tuple(side.angle[live] for side, live in zip(sides, loaded))
    semi_axis = tuple(side.a[live] for side, live in zip(sides, loaded))
    texts = validity.doubts(found) + validity.past_shoulder(body, shoulders, angle, semi_axis)
    if figures["four_point_rad"] is not None:
        texts += validity.past_middle(body, figures["four_point_rad"], angle, semi_axis)
    return texts


def table(result: Mapping[str, Any]) -> str:
    """The mapping of `figures` as text: a topic a block, then a row a ball."""
    filled = {row.key: result.get(row.key) for rows in TOPICS.values() for row in rows}
    filled.update({f"loss_{part}_W": loss for part, loss in (result["losses_W"] or {}).items()})
    for key in ("angle_max_rad", "four_point_rad"):
        filled[key] = None if filled[key] is None else math.degrees(filled[key])
    if not filled["rpm"]:
        filled.update(orbital_speed_rad_s=None, centrifugal_N=None)
    block = _table_of_balls(result["balls"])
    text = [*lines(filled, TOPICS), "", "Balls", *block]
    if result["warnings"]:
        text += ["", "Warnings", *(f"  {one}" for one in result["warnings"])]
    return "\n".join(text)


def _table_of_balls(balls):
    """A row a ball; of two grooves a ring, a row for each that is loaded."""
    if "contacts" in balls[0]:
        columns = CONTACT_COLUMNS
        found = [
            (str(number), ball | one)
            for number, ball in enumerate(balls, 1)
            for one in ball["contacts"]
            if one["q_N"] > 0
        ]
    else:
        columns = COLUMNS
        found = [(str(number), ball) for number, ball in enumerate(balls, 1)]
    shown = [column for column in columns if found and found[0][1].get(column[0]) is not None]
    rows = [["ball", *(heading for _, heading, _ in shown)]]
    for number, one in found:
        rows.append([number, *(_cell(one[key], unit) for key, _, unit in shown)])
    widths = [max(map(len, column)) for column in zip(*rows)]
    return ["  " + "  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows]


def _oil(lubricant, folder, temperature):
    """(`Oil`, `Fluid`), or (None, None) for no lubricant or a dry one."""
    if lubricant is None:
        return None, None
    path = catalogue.find("lubricants", lubricant, folder)
    if inputs.values(path).get("film") == "dry":
        return None, None
    return inputs.oil(path, temperature), inputs.fluid(path, temperature)


def _four_point(path, body, angle, clearance, models, exact_circle):
    """(`Bearing`, options of `turning`) of the bearing with two grooves a ring."""
    if inputs.nominal_angle(path):
        raise inputs.InputError(f"{path}: four points need a bearing of contact_angle 0")
    for asked, what in ((models == "full", "models full"), (exact_circle, "an exact circle")):
        if asked:
            raise inputs.InputError(f"{what}: only of one groove a ring, not of four points")
    (row,) = many_grooves.four_point(body, angle, clearance)
    return row.bearing, {"rest": partial(contacts_of_grooves.equilibrium, angle=angle)}


def _friction(body, boundary, state, films, fluid, spin, orbit, clearance, load, axial, spin_law):
    """Torque and losses; the makers' torque where the bearing's file has their data."""
    if missing := [name for name, value in fluid._asdict().items() if math.isnan(value)]:
        raise inputs.InputError(
            f"models full need {', '.join(missing)} of the lubricant, and its file has none"
        )
    result, surfaces = dict(torque_skf_N_m=None, torque_palmgren_N_m=None), Surfaces()
    if boundary is not None:
        rpm, nu = abs(spin) * 30 / math.pi, fluid.kinematic
        level = 500 * body.ball_diameter  # mm above the lowest raceway: the middle of a ball
        own = makers.skf(boundary, load, axial, rpm, nu, level=level)
        surfaces = Surfaces(starvation=float(own.starvation))
        result = dict(
            torque_skf_N_m=1e-3 * own.total,
            torque_palmgren_N_m=1e-3 * sum(makers.palmgren(boundary, load, rpm, nu)),
        )
    found = friction_torque.losses(
        body,
        state,
        films,
        fluid,
        spin,
        orbit,
        clearance=clearance,
        surfaces=surfaces,
        spin_law=spin_law,
    )
    top = int(np.argmax(state.inner.load))
    return dict(
        result,
        friction_torque_N_m=found.power / abs(spin),
        losses_W=found.parts,
        asperity_share=found.asperity_share[0, top],
    )


def _life(path, body, state, rpm, fluid, cleanliness, four_point):
    """Static safety, and the life of a bearing whose file states its load ratings; not those of a
    deep groove bearing for one of four points."""
    pressure = max(state.inner.pressure.max(), state.outer.pressure.max())
    result = dict(static_safety=life.static_safety(pressure))
    if four_point != inputs.four_point_angle(path):
        return result
    stated = inputs.minimum_load(path)
    if stated is not None and rpm and fluid is not None and not math.isnan(fluid.kinematic):
        factor, mean = stated
        result["minimum_load_N"] = life.minimum_load(factor, fluid.kinematic, rpm, mean)
    rated, nominal = inputs.ratings(path), inputs.nominal_angle(path)
    if rated is None:
        return result
    viscosity = None if fluid is None or math.isnan(fluid.kinematic) else fluid.kinematic
    found = life.of_loads(
        body,
        rated,
        state.inner.load,
        state.outer.load,
        angle=nominal if four_point is None else four_point,
        rpm=rpm,
        viscosity=viscosity,
        cleanliness=cleanliness,
        grooves=1 if four_point is None else 2,
    )
    result.update(equivalent_load_N=found.equivalent, life_reference_Mrev=found.reference)
    if rpm:
        result.update(life_reference_h=found.reference * 1e6 / (60 * abs(rpm)))
    if not math.isnan(found.factor):
        result.update(
            viscosity_ratio=found.viscosity_ratio,
            life_factor=found.factor,
            life_modified_h=found.modified * 1e6 / (60 * abs(rpm)),
        )
    return result


def _ring(state, load, axial, moment, held, play, reach):
    result = dict(zip(("shift_x_m", "shift_y_m", "shift_z_m"), _rounded(state.shift)))
    result.update(zip(("tilt_x_rad", "tilt_y_rad"), _rounded(state.tilt)))
    radial = load and not axial and not (result["tilt_x_rad"] or result["tilt_y_rad"])
    result["load_parameter"] = clearance.load_parameter(play, state.shift[0]) if radial else None
    given, carried = (
        np.array([load, 0.0, axial, *moment]),
        np.array([*state.force, *state.moment[:2]]),
    )
    support = -(given + carried)
    for part, scale in (
        (slice(3), state.inner.load.sum()),
        (slice(3, 5), state.inner.load.sum() * reach),
    ):
        support[part] = np.where(np.abs(support[part]) > 1e-9 * scale, support[part], 0.0)
    for key, name, value in zip(SUPPORT, FREEDOMS, support):
        result[key] = value if name in held else None
    result.update(
        stiffness_x_N_m=state.stiffness[0, 0],
        stiffness_z_N_m=state.stiffness[2, 2],
        stiffness_ry_N_m_rad=state.stiffness[4, 4],
        stiffness=state.stiffness.tolist(),
        residual_N=state.residual,
    )
    return result


def _damping(body, state, films, oil, models, play):
    beside = ring_response.dampers(body, state, films, oil, models, clearance=play)
    matrix = response(state.linear, beside.damping).damping
    return dict(
        damping_x_N_s_m=matrix[0, 0],
        damping_z_N_s_m=matrix[2, 2],
        damping=matrix.tolist(),
        damping_law=ring_response.LAWS[models],
    )


def _loads(state):
    live = np.logical_and(
        *(np.atleast_2d(one.load > 0).any(0) for one in (state.inner, state.outer))
    )
    angles = np.abs(
        np.concatenate([side.angle[side.load > 0] for side in (state.inner, state.outer)])
    )
    return dict(
        loaded_balls=int(live.sum()),
        q_max_N=max(state.inner.load.max(), state.outer.load.max()),
        q_inner_max_N=state.inner.load.max(),
        q_outer_max_N=state.outer.load.max(),
        p_max_inner_Pa=state.inner.pressure.max(),
        p_max_outer_Pa=state.outer.pressure.max(),
        angle_max_rad=angles.max() if len(angles) else 0.0,
    )


def _balls(state, films):
    columns = {"azimuth_rad": state.azimuth}
    for name, side in (("inner", state.inner), ("outer", state.outer)):
        live = side.load > 0
        columns[f"q_{name}_N"] = side.load
        columns[f"angle_{name}_rad"] = np.where(live, side.angle, 0.0)
        columns[f"p_{name}_Pa"], columns[f"a_{name}_m"], columns[f"b_{name}_m"] = (
            side.pressure,
            side.a,
            side.b,
        )
    if films is not None:
        for name, side in (("inner", films.inner), ("outer", films.outer)):
            columns[f"h_min_{name}_m"], columns[f"h_c_{name}_m"], columns[f"lambda_{name}"] = (
                side.h_min,
                side.h_c,
                side.ratio,
            )
        columns["capacitance_F"] = films.ball
    return [
        {key: float(values[ball]) for key, values in columns.items()}
        for ball in range(len(state.azimuth))
    ]


def _balls_in_grooves(state, films):
    films = (None, None, None) if films is None else films
    balls = []
    for ball, azimuth in enumerate(state.azimuth):
        one = {"azimuth_rad": float(azimuth)}
        if films[2] is not None:
            one["capacitance_F"] = float(films[2][ball])
        one["contacts"] = [
            _contact(name, (groove, ball), side, film)
            for names, side, film in zip(
                contacts_of_grooves.NAMES, (state.inner, state.outer), films
            )
            for groove, name in enumerate(names)
        ]
        balls.append(one)
    return balls


def _contact(name, place, side, film):
    values = {
        "q_N": side.load,
        "angle_rad": side.angle,
        "p_Pa": side.pressure,
        "a_m": side.a,
        "b_m": side.b,
    }
    if film is not None:
        values |= {
            "h_min_m": film.h_min,
            "h_c_m": film.h_c,
            "lambda": film.ratio,
            "capacitance_F": film.capacitance,
        }
    return {"raceway": name} | {key: float(value[place]) for key, value in values.items()}


def _rounded(values):
    """Without what rounding left of components that are zero by symmetry: 1e-9 of the largest."""
    return np.where(np.abs(values) > 1e-9 * np.abs(values).max(), values, 0.0)


def _plain(value):
    return value.item() if isinstance(value, np.generic) else value


def _cell(value, unit):
    if unit is None:
        return value
    if unit == "deg":
        return f"{math.degrees(value) + 0.0:.3f}"
    return prefixed(value, unit) if value else "-"
