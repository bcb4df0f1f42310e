# SPDX-License-Identifier: GPL-2.0-or-later
"""Rating life of a bearing at one operating point, with the keys of `operating_point`."""

import math
from typing import Any

from raceway import inputs
from raceway.files import FilePath
from raceway.theory import equivalent_load, life
from raceway.theory.bearing import Bearing, Layout
from raceway.theory.lubricant import Fluid
from raceway.theory.static import Equilibrium


def figures(
    path: FilePath,
    body: Bearing,
    state: Equilibrium,
    fluid: Fluid | None,
    *,
    load: float,
    axial: float,
    rpm: float,
    angle: float,
    cleanliness: str,
    dynamic: float | None,
) -> dict[str, Any]:
    """Return the results for a bearing with the `dynamic` load rating in N, by default the one in
    its file at `path`, and the nominal contact `angle` in rad. They lack the life if there is no
    rating or if the inner raceway carries no load. `cleanliness` is a key of
    `cleanliness.CLEANLINESS`."""
    result: dict[str, Any] = {}
    stated, rows = inputs.minimum_load(path), len(body.layout.rows)
    if rows == 1 and stated and rpm and fluid is not None and not math.isnan(fluid.kinematic):
        factor, mean = stated
        result["minimum_load_N"] = life.minimum_load(factor, fluid.kinematic, rpm, mean)
    rated = inputs.ratings(path)
    unloaded = not state.inner.load.any()  # centrifugal loads alone load the outer raceway
    if unloaded or (rated is None and dynamic is None):
        return result
    if rated is None:
        rated = life.Ratings(dynamic, math.nan, math.nan)
    elif dynamic is not None:
        rated = rated._replace(dynamic=dynamic)
    # convert the ratings of one row to those of all rows
    rated = life.Ratings(rated.dynamic * rows**0.7, rated.static * rows, rated.fatigue * rows)
    known = fluid is not None and not math.isnan(fluid.kinematic + rated.fatigue)
    found = life.of_loads(
        body,
        rated,
        state.inner.load,
        state.outer.load,
        angle=angle,
        rpm=rpm,
        viscosity=fluid.kinematic if known else None,
        cleanliness=cleanliness,
    )
    result.update(dynamic_rating_N=rated.dynamic)
    result.update(equivalent_load_N=found.equivalent, life_reference_Mrev=found.reference)
    if rpm:
        result.update(life_reference_h=_hours(found.reference, rpm))
    if not math.isnan(found.factor):
        result.update(
            viscosity_ratio=found.viscosity_ratio,
            life_factor=found.factor,
            life_modified_h=_hours(found.modified, rpm),
        )
    return result | _basic(body, rated.dynamic, load, axial, rpm, angle)


def _basic(body, dynamic, load, axial, rpm, angle):
    """Return L_10 of ISO 281 and the load for which it is computed. The standard's table of load
    factors is valid for one row and one groove per ring."""
    if axial and body.layout != Layout():
        return {}
    equivalent = equivalent_load.equivalent(
        load, axial, angle=angle, balls=body.balls, ball_diameter=body.ball_diameter
    )
    if not equivalent:
        return {}
    basic = float(life.basic(dynamic, equivalent))
    result = dict(equivalent_load_basic_N=equivalent, life_L10_Mrev=basic)
    return result | dict(life_L10_h=_hours(basic, rpm)) if rpm else result


def _hours(revolutions, rpm):
    """Return the time in h in which a ring makes millions of `revolutions`."""
    return revolutions * 1e6 / (60 * abs(rpm))
