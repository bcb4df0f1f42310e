# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of settling_rest.h, which estimates the remaining change of a decay from the means over
ball passes."""

import numpy as np
import pytest

S = 1e-2  # accuracy required by `settled`


def rest(physics, passes, window=0, **series):
    """Return the remaining changes after `passes` ball passes, whose means are `series`, or how far
    means over `window` ball passes wander. Any means that are not given are 1, or 0 for the pitch.
    """
    given = dict(
        torque=np.ones(passes),
        load=np.ones((passes, 2)),
        cage_speed=np.ones(passes),
        pocket_force=np.ones(passes),
        pitch=np.zeros(passes),
        cage_orbit=np.ones(passes),
    )
    return physics.call("settling_rest", passes=passes, window=window, **{**given, **series})


def of_torque(physics, means):
    return rest(physics, len(means), torque=np.array(means)).torque


def decay(passes, ratio, start=0.2):
    return 1 + start * ratio ** np.arange(passes)


@pytest.mark.parametrize("ratio", [0.2, 0.5, 0.9, 0.97])
@pytest.mark.parametrize("passes", [3, 4, 7, 12, 19])
def test_a_decay_has_its_rest(physics, ratio, passes):
    """The estimate is at least the true remaining change. It is at most the remaining change one
    span earlier, or the change per ball pass averaged over three spans."""
    means = decay(passes, ratio)
    found, left = of_torque(physics, means) * means[-1], means[-1] - 1
    span = max(1, passes // 4)
    steps = min(3, passes // span - 1)
    before = means[passes - (steps + 1) * span : passes - steps * span].mean()
    change = (before - means[-span:].mean()) / steps / span
    assert (1 - 1e-6) * left < found < 1.01 * max(left / ratio ** (span - 1), change)


def test_each_figure_has_its_own(physics):
    means = decay(4, 0.9)
    loads = np.stack([means, np.ones(4)], axis=-1)
    left = (means[-1] - 1) / means[-1]
    for series, name in (
        (dict(cage_speed=means), "cage_speed"),
        (dict(load=loads), "load"),
        (dict(load=loads[:, ::-1]), "load"),
    ):
        found = vars(rest(physics, 4, **series))
        assert found.pop(name) == pytest.approx(left, rel=1e-6)
        assert set(found.values()) == {0.0}
    assert rest(physics, 4, pitch=means).spin_axis == pytest.approx(means[-1] - 1, rel=0.05)


def test_a_drift_that_does_not_decay(physics):
    """The estimate for a steady drift is the remaining change of the slowest mode that can be
    distinguished from it; the estimate is larger only if the drift grows."""
    steady = of_torque(physics, 1 + 1e-3 * np.arange(4))
    assert steady == pytest.approx(0.049, rel=1e-2)
    assert of_torque(physics, 1 + 1e-3 * np.cumsum(1.2 ** np.arange(4))) > 0.049


def test_a_small_change_in_the_middle_of_a_decay(physics):
    """The end of a drift is not inferred from a single ball pass that repeats the previous one."""
    means = decay(8, 0.9)
    means[-1] = means[-2]
    assert of_torque(physics, means) > 3 * S


def test_noise_ends_as_early_as_the_change_of_a_pass(physics):
    """If there is no drift, the estimate is the change per ball pass over the longest span, apart
    from random variation. The median number of ball passes is therefore about the same as if the
    change alone were the criterion. The noise is a third of the limit, equal to the limit, and
    three times the limit."""
    draw = np.random.default_rng(3)
    for noise in (S / 3, S, 3 * S):
        ends, changes = [], []
        for _ in range(300):
            means = 1 + noise * draw.standard_normal(60)

            def change(n, means=means):
                span = max(1, n // 4)
                last, before = means[n - span : n].mean(), means[n - 2 * span : n - span].mean()
                return abs(last / before - 1) / span

            count = range(2, 61)
            ends.append(next(n for n in count if of_torque(physics, means[:n]) <= S))
            changes.append(next(n for n in count if change(n) <= S))
        assert np.median(ends) <= np.median(changes) + 1, noise
        assert np.mean(ends) <= np.mean(changes) + 2, noise


def test_a_slow_mode_shows_in_noise(physics):
    """A change of 1 % per ball pass with a time constant of 50 ball passes is detected in noise of
    0.1 %. If the change alone were the criterion, settling would end at once, and 40 % would
    remain.
    """
    draw = np.random.default_rng(4)
    left = []
    for _ in range(100):
        means = decay(500, 0.98, start=0.5) + 1e-3 * draw.standard_normal(500)
        end = next(n for n in range(3, 501) if of_torque(physics, means[:n]) <= S)
        left.append(decay(500, 0.98, start=0.5)[end - 1] - 1)
    assert np.median(left) < 2 * S
    assert np.quantile(left, 0.9) < 5 * S


def test_one_pass_has_no_rest(physics):
    assert np.isinf(rest(physics, 1).torque)


def test_pocket_forces_fall(physics):
    """A decrease in the pocket forces over a span counts as a change; an increase does not."""
    force = np.array([100.0, 100.0, 40.0, 20.0])
    assert rest(physics, 4, pocket_force=force).pocket_fall == pytest.approx(0.5)
    assert rest(physics, 4, pocket_force=force[::-1].copy()).pocket_fall == 0.0


@pytest.mark.parametrize("passes", [4, 9, 40])
def test_an_orbit_that_repeats_is_settled(physics, passes):
    """The orbit of a cage is compared between the last two quarters of all ball passes."""
    span = passes // 4
    orbit = np.random.default_rng(passes).uniform(0, 1, passes)
    change = abs(orbit[-span:].mean() - orbit[-2 * span : -span].mean())
    assert rest(physics, passes, cage_orbit=orbit).cage_orbit == pytest.approx(change)
    orbit[-2 * span : -span] = orbit[-span:]
    assert rest(physics, passes, cage_orbit=orbit).cage_orbit < 1e-15


@pytest.mark.parametrize("window", [1, 2, 7])
@pytest.mark.parametrize("passes", [16, 101])
def test_wandering_is_the_range_of_means_in_the_last_half(physics, passes, window):
    means = 1 + 1e-3 * np.random.default_rng(passes).standard_normal(passes).cumsum()
    half = passes // 2
    spans = np.convolve(means[-half:], np.ones(window) / window, mode="valid")
    assert len(spans) > 1
    for series, name, value in (
        (dict(torque=means), "torque", means[-1]),
        (dict(load=np.stack([means, np.ones(passes)], axis=-1)), "load", means[-1]),
        (dict(cage_speed=means), "cage_speed", means[-1]),
    ):
        found = vars(rest(physics, passes, window, **series))
        assert found.pop("pocket_fall") == found.pop("cage_orbit") == np.inf  # not determined
        assert found.pop(name) == pytest.approx(np.ptp(spans) / value, rel=1e-9)
        assert max(found.values()) < 1e-15


def test_wandering_of_few_ball_passes(physics):
    """If the last half is not longer than the window, the means cover all but one ball pass."""
    means = np.array([5.0, 5.0, 5.0, 5.0, 1.0, 2.0, 4.0, 9.0])
    for window in (3, 4, 100):
        assert rest(physics, 8, window, torque=means).torque == pytest.approx((5 - 7 / 3) / 9)
    assert np.isinf(rest(physics, 3, 1).torque) and np.isfinite(rest(physics, 4, 1).torque)
