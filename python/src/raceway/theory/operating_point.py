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
    cage_drag,
    contact_friction,
    life,
    makers,
    operating_life,
    operating_ring,
    operating_warnings,
    running,
    validity,
)
from raceway.theory import models as model_names
from raceway.theory.bearing import INNER, DoubleRow, Layout, grooves
from raceway.theory.contact_law import FilmInGap
from raceway.theory.oil_supply import BATH, Supply
from raceway.theory.operating_balls import balls
from raceway.theory.operating_table import table
from raceway.theory.running import Friction

__all__ = ("figures", "table")

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
    film = friction = None
    if models != model_names.PAPER and wet:
        film = FilmInGap(fluid, spin)
        surfaces = contact_friction.surfaces(
            body, inputs.size(path), _complete(fluid, models), spin, models, supply
        )
        friction = Friction(surfaces, spin_law, cage)
    found = running.find(
        body,
        spin,
        load,
        axial,
        oil=oil if wet else None,
        fluid=fluid,
        film=film,
        friction=friction,
        clearance=clearance,
        density=density,
        moment=moment,
        held=held,
        phase=phase,
        finite_shift=exact_circle,
    )
    state, films = found.state, found.films
    orbit = float(np.mean(found.orbit))  # averaged over all rows
    result = dict(
        bearing=path.name,
        lubricant=None if oil is None else _lubricant(lubricant, folder).name,
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
        orbital_speed_rad_s=orbit,
        **grooves(four_point, double_row),
        exact_circle=exact_circle,
        centrifugal_N=4
        / 3
        * math.pi
        * body.ball_radius**3
        * density
        * body.pitch_radius
        * orbit**2,
    )
    if found.motion is not None:
        result.update(zip(ROTATION, found.motion.rotation))
    result.update(
        operating_ring.displacement(state, load, axial, moment, held, clearance, body.pitch_radius)
    )
    if nominal:  # the load zone also depends on the axial load
        result["load_parameter"] = None
    result.update(operating_ring.loads(state))
    pressure = max(result["p_max_inner_Pa"], result["p_max_outer_Pa"])
    result.update(static_safety=life.static_safety(pressure))
    # the ratings in the file do not apply to a deep groove bearing that is modified by an option
    if four_point == stated or dynamic is not None:
        result.update(
            operating_life.figures(
                path,
                body,
                state,
                fluid,
                load=load,
                axial=axial,
                rpm=rpm,
                angle=nominal if four_point is None else four_point,
                cleanliness=cleanliness,
                dynamic=dynamic,
            )
        )
    if films is not None:
        result.update(_films(oil, films, state))
        result.update(operating_ring.damping(body, state, films, oil, models, clearance))
    lost = doubts = None
    if friction is not None:
        lost = found.losses()
        inner = lost.asperity_share[: body.raceways.count(INNER)]
        result.update(
            film_factor=film.factor(result["entrainment_speed_m_s"]),
            **makers.torques(
                inputs.boundary(path),
                math.hypot(*state.force[:2]),
                -state.force[2],
                abs(rpm),
                fluid.kinematic,
                body.ball_diameter,
                one_groove=body.layout == Layout(),
            ),
            friction_torque_N_m=lost.power / abs(spin),
            losses_W=lost.parts,
            asperity_share=inner.flat[np.argmax(state.inner.load)],
        )
    ahead = operating_warnings.advance(found, lost, cage)
    if lost is not None:
        doubts = operating_warnings.of_friction(found, lost, ahead)
        needed = doubts.gyroscopic
        result.update(gyroscopic_friction=needed if needed > 1e-9 else None)
    if ahead is not None:
        result.update(ball_excursion_m=ahead.whole, pocket_force_N=ahead.force or None)
    result = plain(result)
    point = dict(load=load, axial=axial, four_point=four_point)
    result["warnings"] = validity.of_statics(body, inputs.shoulders(path), state, films, **point)
    if "life_reference_Mrev" in result:
        result["warnings"] += operating_warnings.wide_grooves(body)
    if doubts is not None:
        result["warnings"] += doubts.warnings
        low, high = (end * result["friction_torque_N_m"] for end in doubts.ends)
        result["ranges"] = {"friction_torque_N_m": dict(low=low, high=high)}
    result["warnings"] += operating_warnings.restrained(ahead)
    result["absent"] = model_names.absent(models, result) if wet else {}
    for key in makers.KEYS:
        if isinstance(why := result.get(key), str):
            result["absent"][key], result[key] = why, None
    if wet and (assumed := inputs.assumed(_lubricant(lubricant, folder), models)):
        result["assumed_data"] = assumed
    result["balls"] = plain(balls(state, films))
    return result


def _films(oil, films, state):
    """Return the data of the oil, and the films and the capacitance at the largest inner load."""
    top = int(np.argmax(state.inner.load))
    return {
        "viscosity_Pa_s": oil.viscosity,
        "pressure_viscosity_per_Pa": oil.pressure_viscosity,
        "permittivity": oil.permittivity,
        "roughness_m": oil.roughness,
        "entrainment_speed_m_s": films.inner.entrainment.flat[top],
        "h_min_m": films.inner.h_min.flat[top],
        "h_c_m": films.inner.h_c.flat[top],
        "capacitance_F": films.total,
        "capacitance_top_F": films.ball.max(),
        "lambda": films.inner.ratio.flat[top],
    }


def _oil(lubricant, folder, temperature):
    """Return (`Oil`, `Fluid`), or (None, None) if there is no lubricant or it is dry."""
    if lubricant is None:
        return None, None
    path = _lubricant(lubricant, folder)
    if inputs.dry(path):
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
