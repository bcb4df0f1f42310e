# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the film in the gap, against published values, 40-digit arithmetic and finite
differences. Its thickness follows a power law, or is the root of an equation: the formula for all
regimes, and films with Gupta's factor."""

import itertools

import numpy as np
import pytest
from film_scene import OIL, OVERLAPS, ROUNDING, SPEEDS, scene
from raceway import film_gap
from references import film as reference
from scipy.integrate import quad

LAWS = {
    "power": {},
    "moes": {"regimes": True},
    "gupta": {"shear": 3, "sliding": 0.02},
    "moes, gupta": {"regimes": True, "shear": 3, "sliding": 0.02},
}
of_laws = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)


def rounding(law):
    """Return the relative error of a film thickness, which Newton's method increases."""
    return 1e-10 if law else ROUNDING


def theory(gap, law, speed, share=1.0, starvation=1.0):
    """Return the film thickness according to `law` in 40-digit arithmetic."""
    base, cut = (gap.regimes, 0.0) if "regimes" in law else (gap.law, 1.0)
    film_law = base(speed, starvation)
    return gap.heated(film_law, speed, law["sliding"], cut) if "shear" in law else film_law


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


@of_laws
@pytest.mark.parametrize("share, starvation", [(1.0, 1.0), (1.05, 0.7), (0.5, 1.0)])
@pytest.mark.parametrize("speed", SPEEDS)
def test_against_high_precision(gap, law, speed, share, starvation):
    checked = 0
    for overlap in OVERLAPS:
        film = theory(gap, law, speed, share, starvation)
        load, h_c, elastic, slope = reference.in_gap(overlap, gap.stiffness, film, share)
        open_, found = gap.cpp(overlap, speed, share, starvation, **law)
        package = gap.python(law, speed, share, starvation, overlap)
        assert (load == 0) == (package.load == 0)
        # in a run, a film is never thicker than the reach
        within = share * h_c <= found.reach
        assert open_ == (load == 0) or not within
        # near the edge, overlap and film cancel
        worst = rounding(law) * (1 + share * h_c / elastic) if load > 0 else 0.0
        for compression, other in ((found.compression, found), (package.elastic, package)):
            if load == 0 or other is found and not within:
                continue
            assert compression == pytest.approx(elastic, rel=worst)
            assert other.load == pytest.approx(load, rel=1.5 * worst)
            assert other.h_c == pytest.approx(h_c, rel=rounding(law))
            assert other.slope == pytest.approx(slope, rel=1e-7 if law else 3 * worst)
        if load > 0 and not law:
            assert found.stiffness == pytest.approx(found.slope, rel=1e-14)
        checked += load > 0 and within
    assert checked >= 5


def test_digits_of_all_regimes(inner):
    """At zero overlap and 9549 rpm, the load matches a reference value unless it is cut off."""
    assert inner.cpp(0.0, 14.4946, regimes=True)[1].load == pytest.approx(81.56, abs=0.005)


@of_laws
def test_the_equations_hold_everywhere(gap, law):
    """From the edge of the film to a heavy load and from low to high speed, the equations
    delta_H = delta + zeta h and Q = K delta_H^1.5 are satisfied, where h is at most the reach."""
    rel = 10 * rounding(law)
    reach = gap.cpp(0.0, 1.0)[1].reach
    for speed, share in itertools.product(np.geomspace(1e-6, 100, 25), (1e-3, 0.3, 1.0, 2.0)):
        law_there = theory(gap, law, speed)
        edge = reach / share if "regimes" in law else float(law_there(1.0))
        parts = (*np.linspace(-0.999, 0.999, 41), 1e-3, -1e-3, 0.0)
        for overlap in (*(part * share * edge for part in parts), 3e-6, 2e-5, 6e-5):
            open_, found = gap.cpp(overlap, speed, share, **law)
            assert not open_
            film_there = min(float(law_there(found.load)), edge)
            assert found.h_c == pytest.approx(film_there, rel=rel)
            size = abs(overlap) + share * film_there
            assert found.compression == pytest.approx(overlap + share * film_there, abs=rel * size)
            assert found.load == pytest.approx(gap.stiffness * found.compression**1.5, rel=1e-13)


@of_laws
def test_continuous_through_loss_of_contact(gap, law):
    """Neither load nor film thickness jumps between a gap that is wider than the film and a loaded
    contact."""
    for speed in SPEEDS:
        reach = gap.cpp(0.0, speed)[1].reach
        edge = reach if "regimes" in law else float(theory(gap, law, speed)(1.0))
        opens, _ = gap.cpp(-edge * (1 + 1e-9), speed, **law)
        begins, found = gap.cpp(-edge * (1 - 1e-9), speed, **law)
        assert opens and not begins
        assert 0 < found.load < 1.1 * gap.stiffness * (1e-9 * edge) ** 1.5
        overlaps = np.linspace(-edge * (1 - 1e-9), 2e-6, 801)
        contacts = [gap.cpp(d, speed, **law)[1] for d in overlaps]
        loads = np.array([one.load for one in contacts])
        slopes = np.array([one.slope for one in contacts])
        rises = np.diff(loads)
        assert np.all(rises > 0)
        # a jump in the load would exceed the slopes at both ends and the steep rise at the edge
        wall = 1.5 * gap.stiffness * np.sqrt(overlaps[1] - overlaps[0])
        steepest = np.maximum(np.maximum(slopes[1:], slopes[:-1]), 0) * 1.5
        within = rises <= np.maximum(steepest, wall) * (overlaps[1] - overlaps[0])
        assert np.all(within)


@of_laws
def test_slope_is_the_difference(gap, law):
    checked = 0
    for overlap, speed in itertools.product(OVERLAPS, SPEEDS):
        open_, found = gap.cpp(overlap, speed, **law)
        step = 1e-4 * found.compression
        if open_ or found.h_c >= gap.cpp(0.0, 1.0)[1].reach:
            continue
        loads = [gap.cpp(overlap + s * step, speed, **law)[1].load for s in (-2, -1, 1, 2)]
        if (loads[0] - 1) * (loads[3] - 1) < 0:
            continue  # skip the kink where a power law is cut off
        difference = (loads[0] - 8 * loads[1] + 8 * loads[2] - loads[3]) / (12 * step)
        assert found.slope == pytest.approx(difference, rel=1e-6 if law else 1e-8)
        checked += 1
    assert checked > 20


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
    assert film_gap.REACH * 6.3e-3 == reach
    assert gap.cpp(-reach * (1 + 1e-12), 1e9)[0]
    open_, found = gap.cpp(-reach * (1 - 1e-9), 1e9)
    assert not open_ and found.load < 1e-6


@of_laws
@pytest.mark.parametrize("speed", SPEEDS)
def test_energy_is_the_work(gap, law, speed):
    """The change in stored energy equals the work done between two overlaps at constant speed. A
    power law's contact is followed from its edge, where it stores no energy."""
    edge, reach = float(gap.law(speed)(1.0)), gap.cpp(0.0, speed)[1].reach
    first = -0.3 * reach if "regimes" in law else -1e-8 if law else -edge
    if law and gap.cpp(first, speed, **law)[0]:
        first = 0.0
    before = gap.stored(first, speed, **law) if law else 0.0
    kink = gap.stiffness ** (-2 / 3) - edge  # the load is 1 N at this overlap of a power law
    for end in (0.5e-6, 17e-6):
        inside = {kink, -1e-5, -3e-6, -1e-6, -3e-7, 0.0, 1e-7}
        pieces = [first, *sorted(p for p in inside if first < p), end]
        work = sum(
            quad(lambda d: gap.cpp(d, speed, **law)[1].load, a, b, epsrel=1e-10, limit=200)[0]
            for a, b in itertools.pairwise(pieces)
        )
        gained = gap.stored(end, speed, **law) - before
        assert gained == pytest.approx(work, rel=1e-6 if law else 1e-7)


@of_laws
def test_lanes_have_the_bits_of_a_double(gap, law):
    """Four contacts of various kinds evaluated in lanes are bitwise identical to the same contacts
    evaluated alone, because the number of iterations for one contact does not affect the others."""
    random = np.random.default_rng(1)
    for _ in range(200):
        speed = np.exp(random.uniform(np.log(1e-3), np.log(30), 4))
        overlap = random.choice(OVERLAPS, 4) + random.normal(0, 1e-8, 4)
        assert (
            gap.call(
                "film_lanes",
                p=gap.raceway._handle,
                scene=scene(**law),
                overlap=overlap,
                speed=speed,
            )
            == 0
        )


@of_laws
@pytest.mark.parametrize("speed", [0.0, 1e-12])
def test_contact_at_rest_is_dry(gap, law, speed):
    """Without entrainment, a gap carries no load, and a contact with overlap is purely elastic."""
    for overlap in OVERLAPS:
        open_, found = gap.cpp(overlap, speed, **law)
        if overlap:
            assert open_ == (overlap < 0)
        if overlap <= 0:
            continue
        thin = 1e-7 * overlap  # under a power law, a film with a thickness of 1e-13 m remains
        assert found.compression == pytest.approx(overlap, abs=thin)
        load = gap.stiffness * overlap**1.5
        assert found.load == pytest.approx(load, rel=2e-7)
        assert 0 <= found.h_c <= thin
        assert gap.stored(overlap, speed, **law) == pytest.approx(0.4 * load * overlap, rel=1e-6)


def test_smallest_film_is_cut_at_the_same_load(gap):
    for overlap in (-1.9e-6, 17e-6):
        _, found = gap.cpp(overlap, 14.4946)
        groups = reference.groups(*OIL, gap.modulus, gap.r_x, 14.4946, max(found.load, 1.0))
        h_min, _ = reference.masjedi_khonsari(gap.r_x, *groups, gap.kappa)
        assert found.h_min == pytest.approx(float(h_min), rel=ROUNDING)
