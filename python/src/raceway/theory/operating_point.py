# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of a bearing at one operating point from theory. `figures` returns them as a dict, and
`table` (`operating_table`) formats that dict as text.

The keys are a public interface for scripts. Quantities that `summary` also returns have the same
keys.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from raceway import catalogue, inputs
from raceway.arrays import plain
from raceway.files import FilePath
from raceway.theory import (
    ball_motion,
    cage_drag,
    clearance,
    equivalent_load,
    excursion,
    friction_torque,
    life,
    makers,
    ring_response,
    thrust_motion,
    validity,
)
from raceway.theory import models as model_names
from raceway.theory.bearing import INNER, DoubleRow, Layout
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubrication import lubricate, turning
from raceway.theory.oil_supply import BATH, Supply
from raceway.theory.operating_balls import balls
from raceway.theory.operating_table import table
from raceway.theory.small_motion import response
from raceway.theory.static import FREEDOMS

__all__ = ("figures", "table")

SUPPORT = ("support_x_N", "support_y_N", "support_z_N", "support_rx_N_m", "support_ry_N_m")

# rotation of a ball about the radial direction, its path and the bearing's axis
ROTATION = ("ball_radial_rad_s", "ball_along_rad_s", "ball_axial_rad_s")


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
    models: str = model_names.DEFAULT,
    spin_law: str = "closed",
    temperature: float | None = None,
    cleanliness: str = "normal",
    dynamic: float | None = None,
    four_point: float | None = None,
    double_row: DoubleRow | None = None,
    supply: Supply = BATH,
    cage: cage_drag.CageRing | None = None,
) -> dict[str, Any]:
    """Return a dict of results in SI units: texts, numbers or None. `balls` is a list with one dict
    per ball.

    `bearing` and `lubricant` are names or paths of data files, which are searched for in the inputs
    `folder` (`catalogue.find`). The other arguments are as in `static.equilibrium`, with the speed
    of the inner ring in `rpm` and the load along x. Degrees of freedom that are not `held` are
    free. `models` is one of `models.STATICS`: "full" includes the film in the gap, inlet shear
    heating and the friction torque, with the `spin_law` of `friction_torque.losses`; "eyring" also
    uses the Eyring stress with its limit in the film. `temperature` is the lubricant temperature in
    degrees C, by default the value in its file. `cleanliness` is a key of
    `cleanliness.CLEANLINESS`. `four_point` in rad makes the bearing a four-point contact bearing
    with that angle; the bearing's file can specify it too, and each of `balls` then has a list of
    `contacts`. `double_row` gives the bearing two rows, which `balls` lists one after the other.
    `dynamic` is C in N of one row and replaces the value in the file. `supply` is the kind of
    lubrication. `cage` is a cage that is one ring; its losses are included in the friction torque.
    Under pure thrust, the balls move with friction (`thrust_motion`), and the result includes their
    rotation. In the result, `absent` maps each key that the models do not compute to the reason.

    As in a deck, the ring is held along z if there is no axial load (`inputs.held`).

    Raises `NoEquilibrium`, or `InputError` for a faulty data file (both are `RacewayError`), and
    `ValueError` if the models or another choice are unknown.
    """
    path = catalogue.find("bearings", bearing, folder)
    if models not in model_names.STATICS:
        raise ValueError(f"models '{models}' is not one of {', '.join(model_names.STATICS)}")
    body = inputs.bearing(path, four_point=four_point, double_row=double_row)
    oil, fluid = _oil(lubricant, folder, temperature)
    spin, nominal = rpm * math.pi / 30, inputs.nominal_angle(path)
    held = inputs.held(path, axial, clearance, double_row) | dict(held or {})
    density = inputs.ball_density(path) if density is None else density
    stated = inputs.four_point_angle(path)
    four_point = stated if four_point is None else four_point
    wet = oil is not None and spin
    film = FilmInGap(fluid, spin) if models != model_names.PAPER and wet else None
    state, orbits = turning(
        body,
        spin,
        load,
        axial,
        moment=moment,
        held=held,
        clearance=clearance,
        phase=phase,
        ball_density=density,
        finite_shift=exact_circle,
        film=film,
    )
    # the equilibrium without friction, in which balls roll
    rolling, orbit_of_rolling, motion = state, orbits, None
    if film is not None:
        surfaces = friction_torque.surfaces(
            body, inputs.size(path), _complete(fluid, models), spin, models, supply
        )
        if "z" not in held and thrust_motion.applies(body, state):
            motion = thrust_motion.find(
                body,
                state,
                oil,
                fluid,
                film,
                surfaces,
                clearance=clearance,
                density=density,
                spin_law=spin_law,
                cage=cage,
            )
            state, orbits = motion.state, motion.orbit
    orbit = float(np.mean(orbits))  # averaged over all rows
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
        clearance_m=clearance + body.play(nominal),
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
    if motion is not None:
        result.update(zip(ROTATION, motion.rotation))
    if double_row is not None:
        result.update(zip(("row_spacing_m", "row_preload_m", "arrangement"), double_row))
    result.update(_ring(state, load, axial, moment, held, clearance, body.pitch_radius))
    if nominal:  # the load zone also depends on the axial load
        result["load_parameter"] = None
    result.update(_loads(state))
    pressure = max(result["p_max_inner_Pa"], result["p_max_outer_Pa"])
    result.update(static_safety=life.static_safety(pressure))
    # the ratings in the file do not apply to a deep groove bearing that is modified by an option
    if four_point == stated or dynamic is not None:
        angle = nominal if four_point is None else four_point
        result.update(_life(path, body, state, rpm, fluid, cleanliness, angle, dynamic))
        if "life_reference_Mrev" in result:
            result.update(_basic_life(body, result, angle))
    films = None
    if wet:
        films = motion and motion.films
        films = films or lubricate(body, state, oil, spin, clearance, film and film.factor)
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
    friction = None
    if film is not None:
        boundary = inputs.boundary(path)
        lost = motion and motion.losses
        lost = lost or friction_torque.losses(
            body,
            state,
            films,
            fluid,
            spin,
            orbits,
            clearance=clearance,
            surfaces=surfaces,
            spin_law=spin_law,
            ball_density=density,
            cage=cage,
        )
        inner = lost.asperity_share[: body.raceways.count(INNER)]
        result.update(
            film_factor=film.factor(films.inner.entrainment.flat[top]),
            **_makers(body, boundary, load, axial, abs(rpm), fluid.kinematic),
            friction_torque_N_m=lost.power / abs(spin),
            losses_W=lost.parts,
            asperity_share=inner.flat[top],
        )
        needed = ball_motion.gyroscopic(body, rolling, spin, orbit_of_rolling, density)
        needed *= np.atleast_2d(rolling.inner.heavy).any(0)
        result.update(gyroscopic_friction=needed.max() if needed.max() > 1e-9 else None)
        friction = lost.friction
    ahead = lost.advance if film is not None else None
    if ahead is None and body.layout == Layout():
        ahead = excursion.excursion(body, rolling, spin, friction, cage and cage.play or None)
    if ahead is not None:
        result.update(ball_excursion_m=ahead.whole, pocket_force_N=ahead.force or None)
    result = plain(result)
    point = dict(load=load, axial=axial, four_point=four_point)
    result["warnings"] = validity.of_statics(body, inputs.shoulders(path), state, films, **point)
    if "life_reference_Mrev" in result:
        result["warnings"] += _wide(body)
    if film is not None:
        result["warnings"] += _sliding(rolling, lost.friction, needed, motion is not None)
        *ends, texts = validity.torque_range(_doubts(rolling, lost.friction, needed, ahead))
        low, high = (end * result["friction_torque_N_m"] for end in ends)
        result["ranges"] = {"friction_torque_N_m": dict(low=low, high=high)}
        result["warnings"] += texts
    if ahead is not None and (text := excursion.warning(ahead)):
        result["warnings"].append(text)
    result["absent"] = model_names.absent(models, result) if wet else {}
    if wet and (assumed := inputs.assumed(_lubricant(lubricant, folder), models)):
        result["assumed_data"] = assumed
    result["balls"] = plain(balls(state, films))
    return result


def _wide(body):
    """Return a list with a warning that the rating used for the life applies only to narrower
    grooves, which is empty if the grooves are narrow enough."""
    if min(wide := life.wide_grooves(body)) >= 1 - 1e-9:
        return []
    return [
        "groove radii above {:g} (inner) and {:g} (outer) of the ball diameter reduce the load"
        " ratings of the balls to {:.0%} and {:.0%} of those that follow from C in the file".format(
            *life.CONFORMITY, *wide
        )
    ]


def _doubts(state, friction, needed, ahead):
    """Return the values on which the accuracy of the friction torque depends, with the names in
    `validity.TORQUE`."""
    sides = (state.inner, state.outer)
    tilted = any(np.any(np.abs(one.angle[one.heavy]) > 1e-3) for one in sides)
    return dict(
        pockets=0.0 if ahead is None else ahead.needed / ahead.play,
        gyroscopic=(needed / _available(state, friction)).max(),
        unloaded=np.mean(~np.atleast_2d(state.inner.heavy).any(0)) if tilted else 0.0,
    )


def _available(state, friction):
    """Return the mean friction coefficient (Z,) of the contacts of each ball."""
    load = np.vstack([state.inner.load, state.outer.load])
    return np.maximum((friction * load).sum(0), 1e-300) / np.maximum(load.sum(0), 1e-300)


def _sliding(state, friction, needed, included):
    """Return a list with a warning if friction cannot hold balls against their gyroscopic moment;
    `included` says whether the state of these balls was solved for."""
    slide = needed > _available(state, friction)
    if not slide.any():
        return []
    where = "around a ring that is free in its plane" if included else "in a run"
    return [
        f"the friction of {slide.sum()} balls is below the coefficient of {needed.max():.2g} that"
        f" their gyroscopic moment requires: they slide across their grooves, and {where} they may"
        " skid and dissipate more"
    ]


def _oil(lubricant, folder, temperature):
    """Return (`Oil`, `Fluid`), or (None, None) if there is no lubricant or it is dry."""
    if lubricant is None:
        return None, None
    path = _lubricant(lubricant, folder)
    if inputs.values(path).get("film") == "dry":
        return None, None
    return inputs.oil(path, temperature), inputs.fluid(path, temperature)


def _lubricant(name, folder):
    return catalogue.find("lubricants", name, folder)


def _complete(fluid, models):
    known = fluid._asdict()
    if models == "full":
        del known["eyring_stress"], known["limiting_traction"]
    if missing := [name for name, value in known.items() if math.isnan(value)]:
        raise inputs.InputError(
            f"models {models} need {', '.join(missing)} of the lubricant, which its file lacks"
        )
    return fluid


def _makers(body, boundary, load, axial, rpm, viscosity):
    """Return the torque by the makers' formulas, which are valid for one groove per ring, if the
    file has the required data."""
    if boundary is None or body.layout != Layout():
        return dict(torque_skf_N_m=None, torque_palmgren_N_m=None)
    level = 500 * body.ball_diameter  # mm above the lowest raceway, i.e. at the middle of a ball
    return dict(
        torque_skf_N_m=1e-3 * makers.skf(boundary, load, axial, rpm, viscosity, level=level).total,
        torque_palmgren_N_m=1e-3 * sum(makers.palmgren(boundary, load, rpm, viscosity)),
    )


def _basic_life(body, figures, angle):
    """Return L_10 of ISO 281 and the load for which it is computed. The standard's table of load
    factors is valid for one row and one groove per ring."""
    axial, layout = figures["axial_N"], body.layout
    if axial and layout != Layout():
        return {}
    load = equivalent_load.equivalent(
        figures["load_N"], axial, angle=angle, balls=body.balls, ball_diameter=body.ball_diameter
    )
    if not load:
        return {}
    basic = float(life.basic(figures["dynamic_rating_N"], load))
    result = dict(equivalent_load_basic_N=load, life_L10_Mrev=basic)
    if figures["rpm"]:
        result.update(life_L10_h=basic * 1e6 / (60 * abs(figures["rpm"])))
    return result


def _life(path, body, state, rpm, fluid, cleanliness, angle, dynamic):
    """Return the life of a bearing with the `dynamic` load rating in N, by default the one in its
    file."""
    result = {}
    stated, rows = inputs.minimum_load(path), len(body.layout.rows)
    if rows == 1 and stated and rpm and fluid is not None and not math.isnan(fluid.kinematic):
        factor, mean = stated
        result["minimum_load_N"] = life.minimum_load(factor, fluid.kinematic, rpm, mean)
    rated = inputs.ratings(path)
    if rated is None and dynamic is None:
        return result
    if rated is None:
        rated = life.Ratings(dynamic, math.nan, math.nan)
    elif dynamic is not None:
        rated = rated._replace(dynamic=dynamic)
    # convert the ratings of one row to those of all rows
    rated = life.Ratings(rated.dynamic * rows**0.7, rated.static * rows, rated.fatigue * rows)
    known = fluid is not None and not math.isnan(fluid.kinematic + rated.fatigue)
    viscosity = fluid.kinematic if known else None
    found = life.of_loads(
        body,
        rated,
        state.inner.load,
        state.outer.load,
        angle=angle,
        rpm=rpm,
        viscosity=viscosity,
        cleanliness=cleanliness,
    )
    result.update(dynamic_rating_N=rated.dynamic)
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
    radial = load and not (result["shift_z_m"] or result["tilt_x_rad"] or result["tilt_y_rad"])
    moved = radial and result["shift_x_m"]
    result["load_parameter"] = clearance.load_parameter(play, state.shift[0]) if moved else None
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
    angles = np.abs(np.concatenate([one.angle[one.heavy] for one in (state.inner, state.outer)]))
    return dict(
        loaded_balls=int(live.sum()),
        q_max_N=max(state.inner.load.max(), state.outer.load.max()),
        q_inner_max_N=state.inner.load.max(),
        q_outer_max_N=state.outer.load.max(),
        p_max_inner_Pa=state.inner.pressure.max(),
        p_max_outer_Pa=state.outer.pressure.max(),
        angle_max_rad=angles.max() if len(angles) else 0.0,
    )


def _rounded(values):
    """Set values below 1e-9 of the largest value to zero, because by symmetry they are rounding
    errors."""
    return np.where(np.abs(values) > 1e-9 * np.abs(values).max(), values, 0.0)
