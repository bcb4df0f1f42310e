# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the film in the gap when it follows a power law, against published values, 40-digit
arithmetic and finite differences."""

import itertools

import numpy as np
import pytest
from film_scene import OIL, OVERLAPS, ROUNDING, SPEEDS
from references import film as reference
from scipy.integrate import quad


@pytest.mark.parametrize(
    "speed, overlap, load, h_c, slope",
    [
        (0.72481, 17e-6, 2310.20, 160.897e-9, 2.01739e8),
        (14.4946, 17e-6, 2545.22, 1305.87e-9, 2.07066e8),
        (14.4946, 0.0, 69.735, None, 5.7107e7),
        (14.4946, -1e-6, 22.947, None, None),
    ],
)
def test_digits_of_the_gap(inner, speed, overlap, load, h_c, slope):
    open_, found = inner.cpp(overlap, speed)
    assert not open_
    assert found.load == pytest.approx(load, abs=0.5 * 10.0 ** (-2 if load > 100 else -3))
    if h_c:
        assert found.h_c == pytest.approx(h_c, abs=0.005e-9 if h_c > 1e-6 else 0.0005e-9)
    if slope:
        assert found.slope == pytest.approx(slope, rel=5e-6)


@pytest.mark.parametrize("overlap, speed", list(itertools.product(OVERLAPS, SPEEDS)))
@pytest.mark.parametrize("share, starvation", [(1.0, 1.0), (1.05, 0.7), (0.5, 1.0)])
def test_against_high_precision(gap, overlap, speed, share, starvation):
    law = gap.law(speed, starvation)
    load, h_c, elastic, slope = reference.in_gap(overlap, gap.stiffness, law, share)
    open_, found = gap.cpp(overlap, speed, share, starvation)
    package = gap.python({}, speed, share, starvation, overlap)
    assert open_ == (load == 0) == (package.load == 0)
    if open_:
        return
    # near the edge, overlap and film cancel, so the rounding error is that of the exponents of the
    # film
    worst = ROUNDING * (1 + share * h_c / elastic)
    for compression, other in ((found.compression, found), (package.elastic, package)):
        assert compression == pytest.approx(elastic, rel=worst)
        assert other.load == pytest.approx(load, rel=1.5 * worst)
        assert other.h_c == pytest.approx(h_c, rel=ROUNDING)
        assert other.slope == pytest.approx(slope, rel=3 * worst)
    assert found.stiffness == pytest.approx(found.slope, rel=1e-14)


def test_the_equation_holds_everywhere(gap):
    """On a coarse grid of films and overlaps, delta_H = delta + zeta h_c(Q) and Q = K delta_H^1.5
    are satisfied everywhere."""
    radial = gap.raceway.radial()
    for speed, share in itertools.product(np.geomspace(1e-4, 100, 25), (1e-3, 0.3, 1.0, 2.0)):
        edge = share * np.exp(radial.central_lnA + radial.central_p * np.log(speed))
        for part in (*np.linspace(-0.999, 0.999, 41), 5.0, 100.0, 1e4):
            open_, found = gap.cpp(part * edge, speed, share)
            assert not open_
            assert found.load == pytest.approx(gap.stiffness * found.compression**1.5, rel=1e-13)
            thin = max(found.load, 1.0) ** radial.central_m
            film_there = np.exp(radial.central_lnA + radial.central_p * np.log(speed)) * thin
            assert found.h_c == pytest.approx(film_there, rel=1e-12)
            assert found.compression == pytest.approx(
                part * edge + share * film_there, abs=1e-12 * (abs(part) + 1) * edge
            )


def test_slope_is_the_difference(gap):
    for overlap, speed in itertools.product(OVERLAPS, SPEEDS):
        open_, found = gap.cpp(overlap, speed)
        step = 1e-5 * found.compression
        ends = [gap.cpp(overlap + s * step, speed) for s in (-1, 1)]
        if open_ or any(end[0] for end in ends):
            continue
        loads = [end[1].load for end in ends]
        if (loads[0] - 1) * (loads[1] - 1) < 0:
            continue  # skip the kink where the film is cut off
        difference = (loads[1] - loads[0]) / (2 * step)
        assert found.slope == pytest.approx(difference, rel=1e-8)


def test_continuous_through_loss_of_contact(gap):
    """Neither load nor film thickness jumps between a gap that is wider than the film and a loaded
    contact."""
    for speed in SPEEDS:
        edge = float(gap.law(speed)(1.0))
        opens, _ = gap.cpp(-edge * (1 + 1e-9), speed)
        begins, found = gap.cpp(-edge * (1 - 1e-9), speed)
        assert opens and not begins
        assert 0 < found.load < 1.1 * gap.stiffness * (1e-9 * edge) ** 1.5
        overlaps = np.linspace(-edge * (1 - 1e-9), 2 * edge, 2001)
        loads = np.array([gap.cpp(d, speed)[1].load for d in overlaps])
        assert np.all(np.diff(loads) > 0)
        # the slope is largest at the end of the range, so a jump in the load would exceed it
        steepest = gap.cpp(2 * edge, speed)[1].slope
        assert np.diff(loads).max() <= 1.01 * steepest * (overlaps[1] - overlaps[0])


def test_at_rest_it_is_hertz(gap):
    for share in (0.0, 1.0):
        open_, found = gap.cpp(17e-6, 0.0 if share else 3.0, share)
        assert not open_
        assert found.load == pytest.approx(gap.stiffness * 17e-6**1.5, rel=ROUNDING)
    assert gap.cpp(-1e-9, 0.0)[0]


def test_a_film_beyond_the_reach_is_held_there(gap):
    """At 1e9 m/s, the contact begins with zero load at the reach of the film."""
    reach = gap.cpp(0.0, 1.0)[1].reach
    assert reach == pytest.approx(0.01 * 6.3e-3, rel=1e-14)
    assert gap.cpp(-reach * (1 + 1e-12), 1e9)[0]
    open_, found = gap.cpp(-reach * (1 - 1e-9), 1e9)
    assert not open_ and found.load < 1e-6


def test_energy_is_the_work(gap):
    """The stored energy equals the work done between the edge of the film and an overlap, at
    constant speed."""
    for speed in SPEEDS:
        edge = float(gap.law(speed)(1.0))
        for end in (0.5e-6, 17e-6):
            kink = gap.stiffness ** (-2 / 3) - edge  # the load is 1 N at this overlap
            cut = [d for d in (-edge * 0.9, kink, 0.0) if -edge < d < end]
            work, _ = quad(
                lambda d, speed=speed: gap.cpp(d, speed)[1].load,
                -edge,
                end,
                points=cut,
                epsrel=1e-10,
                limit=400,
            )
            assert gap.stored(end, speed) == pytest.approx(work, rel=1e-7)


def test_smallest_film_is_cut_at_the_same_load(gap):
    for overlap in (-1.9e-6, 17e-6):
        _, found = gap.cpp(overlap, 14.4946)
        groups = reference.groups(*OIL, gap.modulus, gap.r_x, 14.4946, max(found.load, 1.0))
        h_min, _ = reference.masjedi_khonsari(gap.r_x, *groups, gap.kappa)
        assert found.h_min == pytest.approx(float(h_min), rel=ROUNDING)
