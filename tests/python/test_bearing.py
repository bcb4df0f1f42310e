# SPDX-License-Identifier: GPL-2.0-or-later
"""The geometry of a bearing agrees with its curvature sums, and bearings with impossible dimensions
are rejected."""

import dataclasses

import pytest
from raceway.theory.bearing import INNER, OUTER, Bearing


def test_clearance_opens_the_outer_groove_only(bearing):
    assert bearing.groove_circle(INNER, 40e-6) == bearing.groove_circle(INNER)
    assert bearing.groove_circle(OUTER, 40e-6) - bearing.groove_circle(OUTER) == pytest.approx(
        20e-6, rel=1e-11
    )


def test_touches_both_grooves_without_clearance(bearing):
    apart = bearing.groove_circle(INNER) - bearing.groove_circle(OUTER)
    assert apart == pytest.approx(bearing.groove_gap(INNER) + bearing.groove_gap(OUTER), rel=1e-11)


@pytest.mark.parametrize(
    "change, name",
    [
        ({"inner_groove": 6.3e-3}, "inner_groove"),
        ({"outer_groove": 6e-3}, "outer_groove"),
        ({"balls": 0}, "balls"),
        ({"young": -1.0}, "young"),
        ({"poisson": 0.5}, "poisson"),
        ({"ball_diameter": float("nan")}, "ball_diameter"),
        ({"balls": 16}, "overlapping balls: 16 balls of diameter 0.0126 m"),
        ({"outer_radius": 20e-3}, "outer_radius"),
    ],
)
def test_impossible_sizes_are_named(bearing, change, name):
    with pytest.raises(ValueError, match=name):
        dataclasses.replace(bearing, **change)


def test_mapping(bearing):
    data = dataclasses.asdict(bearing)
    del data["layout"]
    assert Bearing.from_mapping(data) == bearing
    with pytest.raises(ValueError, match="unknown bearing data: seals"):
        Bearing.from_mapping(data | {"seals": 2})
    with pytest.raises(ValueError, match="missing bearing data: balls"):
        Bearing.from_mapping({key: value for key, value in data.items() if key != "balls"})
