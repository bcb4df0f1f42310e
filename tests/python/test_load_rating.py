# SPDX-License-Identifier: GPL-2.0-or-later
"""Load ratings are computed from a row of balls, and balls are found from given ratings."""

import math

import pytest
from raceway import load_rating
from raceway.theory.load_rating import Balls

# C and C0 in N of JTEKT's 7208 at 15, 30 and 40 degrees
SIZES = {15: (36400, 25200), 30: (33600, 23300), 40: (30600, 21300)}


@pytest.mark.parametrize("angle", SIZES)
def test_ratings_of_a_size(angle):
    """13 balls of 15/32 in, which is the diameter that GMN states for a spindle bearing of this
    size, give the ratings at all three contact angles."""
    dynamic, static = SIZES[angle]
    ball, pitch, angle = 25.4e-3 * 15 / 32, 60e-3, math.radians(angle)
    assert load_rating.dynamic(13, ball, pitch, angle) == pytest.approx(dynamic, rel=2e-3)
    assert load_rating.static(13, ball, pitch, angle) == pytest.approx(static, rel=4e-3)
    found = load_rating.balls(dynamic, static, pitch, angle)
    assert found == pytest.approx(Balls(13, ball))


def test_factors():
    """The factors f_0, and 1.3 f_c for one ball of 1 mm at zero angle, agree with the tables."""
    for ratio, static, dynamic in ((0.09, 16.5, 54.3), (0.2, 14.0, 59.9), (0.4, 9.4, 48.4)):
        assert load_rating.static_factor(1e-3, 1e-3 / ratio) == pytest.approx(static)
        assert load_rating.dynamic(1, 1e-3, 1e-3 / ratio) == pytest.approx(1.3 * dynamic)


def test_power_changes_without_a_jump():
    at = [load_rating.dynamic(9, size, 6 * size) for size in (25.4e-3, 25.4001e-3)]
    # the ratings are larger because the diameter is larger by 4e-6, not because of the constants
    assert at[1] / at[0] - 1 == pytest.approx(0, abs=1e-4)
    assert load_rating.dynamic(9, 30e-3, 0.2) / load_rating.dynamic(9, 28e-3, 0.2 * 28 / 30) == (
        pytest.approx((30 / 28) ** 1.4)
    )


@pytest.mark.parametrize("number, ball, pitch", [(7, 12.7e-3, 60e-3), (9, 9.525e-3, 46e-3)])
def test_balls_are_found_again(number, ball, pitch):
    ratings = [rate(number, ball, pitch) for rate in (load_rating.dynamic, load_rating.static)]
    assert load_rating.balls(*ratings, pitch) == pytest.approx((number, ball))
    # for a maker whose ratings are 5 % higher
    assert load_rating.balls(1.05 * ratings[0], ratings[1], pitch, 0.0, 1.05) == pytest.approx(
        (number, ball)
    )


def test_errors():
    with pytest.raises(ValueError, match="must lie between 0.01 and 0.4"):
        load_rating.dynamic(9, 20e-3, 40e-3)
    with pytest.raises(ValueError, match="no balls on a pitch circle of 0.06 m"):
        load_rating.balls(1e6, 1e6, 60e-3)
    with pytest.raises(ValueError, match="contact angle 40 rad must lie between 0 and pi/2"):
        load_rating.balls(30600.0, 21300.0, 60e-3, 40.0)
