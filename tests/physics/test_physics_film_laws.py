# SPDX-License-Identifier: GPL-2.0-or-later
"""Film factors, film in the gap and film branch: against TRIBOLOGY's numbers, raceway.theory, and
differences."""

import itertools

import numpy as np
import pytest
from physics_c import INNER, OUTER
from raceway import film, film_damping, film_factors, film_gap, hertz
from scipy.integrate import quad
from scipy.linalg import expm

OIL = (0.04, 22e-9)
SPEEDS = (0.0725, 0.72481, 2.899, 14.4946)
SHEAR = {1: film_factors.murch_wilson, 2: film_factors.wilson}
# forty roundings in exponents of at most 50
ROUNDING = 1e-12


@pytest.fixture(scope="module", params=[INNER, OUTER], ids=["inner", "outer"])
def side(request):
    return request.param


class Gap:
    """A contact of a 6208 with its film, in C++ and in Python."""

    def __init__(self, physics, side):
        self.call = physics.call
        self.raceway = physics.raceway_6208(
            side, viscosity=OIL[0], pressure_viscosity=OIL[1], ring_roughness=1e-7
        )
        self.modulus = self.raceway.derived().modulus
        self.r_x, self.r_y = physics.radii(side)
        ellipse = hertz.exact(self.r_x, self.r_y)
        self.kappa, self.stiffness = ellipse.kappa, self.raceway.radial().K
        assert hertz.stiffness(ellipse, self.modulus) == pytest.approx(self.stiffness, rel=1e-13)

    def cpp(self, overlap, speed, share=1.0, starvation=1.0):
        """(whether there is no contact, its numbers)."""
        return self.call(
            "film_contact",
            p=self.raceway._handle,
            share=share,
            starvation=starvation,
            overlap=overlap,
            speed=speed,
        )

    def law(self, speed, factor=1.0):
        return film_gap.power_law(*OIL, self.modulus, self.r_x, self.kappa, speed, factor=factor)


@pytest.fixture(scope="module")
def gap(physics, side):
    return Gap(physics, side)


@pytest.fixture(scope="module")
def inner(physics):
    return Gap(physics, INNER)


def factor(physics, shear, speed, starvation=1.0):
    return physics.call(
        "film_factor",
        shear=shear,
        beta=0.047 if shear else 0.0,
        viscosity=0.04,
        conductivity=0.134 if shear else 0.0,
        starvation=starvation,
        speed=speed,
    )


# ---- factors -----------------------------------------------------------------------------------
@pytest.mark.parametrize("shear", SHEAR)
@pytest.mark.parametrize("speed", [1e-3, *SPEEDS, 90.0])
def test_inlet_shear(physics, shear, speed):
    loading = film_factors.thermal_loading(0.047, 0.04, speed, 0.134)
    found = factor(physics, shear, speed, 0.8)
    assert found == pytest.approx(0.8 * SHEAR[shear](loading), rel=ROUNDING)


def test_digits_of_inlet_shear(physics):
    speeds = (0.7248, 2.899, 14.4946)
    for shear, expected in ((1, (0.9881, 0.9368, 0.6684)), (2, (0.9957, 0.9752, 0.8335))):
        found = [factor(physics, shear, u) for u in speeds]
        assert found == pytest.approx(expected, abs=5e-5)


def test_no_factor(physics):
    assert factor(physics, 0, 14.0) == 1.0
    assert factor(physics, 1, 0.0) == 1.0  # at rest


# ---- film in the gap ---------------------------------------------------------------------------
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


OVERLAPS = (-3e-6, -2.2e-6, -1.5e-6, -0.7e-6, -1e-7, -3e-8, 0.0, 3e-8, 1e-6, 17e-6, 60e-6)


@pytest.mark.parametrize("overlap, speed", list(itertools.product(OVERLAPS, SPEEDS)))
@pytest.mark.parametrize("share, starvation", [(1.0, 1.0), (1.05, 0.7), (0.5, 1.0)])
def test_as_in_python(gap, overlap, speed, share, starvation):
    expected = film_gap.solve(overlap, gap.stiffness, gap.law(speed, starvation), share)
    open_, found = gap.cpp(overlap, speed, share, starvation)
    assert open_ == (expected.load == 0)
    if open_:
        return
    # near the edge the overlap cancels the film: its rounding is that of the film's exponents
    worst = ROUNDING * (1 + share * expected.h_c / expected.elastic)
    assert found.compression == pytest.approx(expected.elastic, rel=worst)
    assert found.load == pytest.approx(expected.load, rel=1.5 * worst)
    assert found.h_c == pytest.approx(expected.h_c, rel=ROUNDING)
    assert found.slope == pytest.approx(expected.slope, rel=3 * worst)
    assert found.stiffness == pytest.approx(found.slope, rel=1e-14)


def test_the_equation_holds_everywhere(gap):
    """delta_H = delta + zeta h_c(Q), Q = K delta_H^1.5: for any film and overlap, a rough grid."""
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
            continue  # the kink where the film is cut
        difference = (loads[1] - loads[0]) / (2 * step)
        assert found.slope == pytest.approx(difference, rel=1e-8)


def test_continuous_through_loss_of_contact(gap):
    """From a gap wider than the film to a load: no jump in load or film thickness."""
    for speed in SPEEDS:
        edge = gap.law(speed)(np.array(1.0))[0]
        opens, _ = gap.cpp(-edge * (1 + 1e-9), speed)
        begins, found = gap.cpp(-edge * (1 - 1e-9), speed)
        assert opens and not begins
        assert 0 < found.load < 1.1 * gap.stiffness * (1e-9 * edge) ** 1.5
        overlaps = np.linspace(-edge * (1 - 1e-9), 2 * edge, 2001)
        loads = np.array([gap.cpp(d, speed)[1].load for d in overlaps])
        assert np.all(np.diff(loads) > 0)
        # the largest slope is at the end: a load that jumps would be above it
        steepest = gap.cpp(2 * edge, speed)[1].slope
        assert np.diff(loads).max() <= 1.01 * steepest * (overlaps[1] - overlaps[0])


def test_at_rest_it_is_hertz(gap):
    for share in (0.0, 1.0):
        open_, found = gap.cpp(17e-6, 0.0 if share else 3.0, share)
        assert not open_
        assert found.load == pytest.approx(gap.stiffness * 17e-6**1.5, rel=ROUNDING)
    assert gap.cpp(-1e-9, 0.0)[0]


def test_a_film_beyond_the_reach_is_held_there(gap):
    """1e9 m/s: contacts begin at the reach, with no load."""
    reach = gap.cpp(0.0, 1.0)[1].reach
    assert reach == pytest.approx(0.01 * 6.3e-3, rel=1e-14)
    assert gap.cpp(-reach * (1 + 1e-12), 1e9)[0]
    open_, found = gap.cpp(-reach * (1 - 1e-9), 1e9)
    assert not open_ and found.load < 1e-6


def test_lanes_have_the_bits_of_a_double(gap):
    """Lanes with contacts of all kinds side by side: none takes another's number of passes."""
    random = np.random.default_rng(1)
    for _ in range(300):
        speed = np.exp(random.uniform(np.log(1e-3), np.log(30), 4))
        overlap = random.choice(OVERLAPS, 4) + random.normal(0, 1e-8, 4)
        assert (
            gap.call(
                "film_lanes",
                p=gap.raceway._handle,
                share=1.0,
                overlap=overlap,
                speed=speed,
            )
            == 0
        )


def test_energy_is_the_work(gap):
    """From the edge of the film to an overlap, at a constant speed."""
    for speed in SPEEDS:
        edge = gap.law(speed)(np.array(1.0))[0]
        for end in (0.5e-6, 17e-6):
            kink = gap.stiffness ** (-2 / 3) - edge  # where the load is 1 N
            cut = [d for d in (-edge * 0.9, kink, 0.0) if -edge < d < end]
            work, _ = quad(
                lambda d, speed=speed: gap.cpp(d, speed)[1].load,
                -edge,
                end,
                points=cut,
                epsrel=1e-10,
                limit=400,
            )
            assert gap.cpp(end, speed)[1].energy == pytest.approx(work, rel=1e-7)


def test_smallest_film_is_cut_at_the_same_load(gap):
    for overlap in (-1.9e-6, 17e-6):
        _, found = gap.cpp(overlap, 14.4946)
        g = film.group(*OIL, gap.modulus, gap.r_x, gap.kappa, 14.4946, max(found.load, 1.0))
        assert found.h_min == pytest.approx(film.h_min(gap.r_x, g), rel=ROUNDING)


# ---- film branch -------------------------------------------------------------------------------
@pytest.mark.parametrize("speed", [0.0, 1e-6, *SPEEDS])
@pytest.mark.parametrize("step", [1e-9, 1e-6, 1e-4, 1e-2])
@pytest.mark.parametrize("h_c", [160e-9, 3e-5])
def test_branch_as_in_python(physics, speed, step, h_c):
    k, elastic, b = 2e8, 17e-6, 150e-6
    branch = film_damping.branch(k, h_c, elastic, b, speed)
    expected = film_damping.advance(3.0, branch, 2e-4, step)
    found = physics.call(
        "film_step",
        k=k,
        h_c=h_c,
        compression=elastic,
        b=b,
        speed=speed,
        force=3.0,
        rate=2e-4,
        dt=step,
        stage=0,
    )
    assert found[0] == pytest.approx(branch.stiffness, rel=1e-14)
    assert found[1] == pytest.approx(1 / branch.time, rel=1e-14)
    assert found[2:] == pytest.approx(expected, rel=ROUNDING)


@pytest.mark.parametrize("step", [1e-6, 1e-4, 1e-2])
def test_branch_in_a_stage_is_backward_euler(physics, step):
    """Its force solves f = f_0 + dt (k_m d(overlap)/dt - f/tau), the form that an implicit method
    of second order needs of its stages."""
    found = physics.call(
        "film_step",
        k=2e8,
        h_c=160e-9,
        compression=17e-6,
        b=150e-6,
        speed=0.7,
        force=3.0,
        rate=2e-4,
        dt=step,
        stage=1,
    )
    stiffness, decay, force, slope = found
    assert force == pytest.approx(3.0 + step * (stiffness * 2e-4 - force * decay), rel=1e-12)
    assert slope == pytest.approx((force - 3.0 / (1 + step * decay)) / 2e-4, rel=1e-9)


def test_dashpot_of_the_top_ball(physics):
    """659, 331, 219, 135 N s/m (0.59 for 0.44 x 1.33, so 0.6 % more than the branch)."""
    inner = Gap(physics, INNER)
    for speed, expected in zip((0.072476, 0.724764, 2.899, 14.4946), (659, 331, 219, 135)):
        load = 2436.2
        elastic = (load / inner.stiffness) ** (2 / 3)
        g = film.group(*OIL, inner.modulus, inner.r_x, inner.kappa, speed, load)
        k_m, rate, *_ = physics.call(
            "film_step",
            k=1.5 * load / elastic,
            h_c=film.h_c(inner.r_x, g),
            compression=elastic,
            b=inner.raceway.radial().b * np.sqrt(elastic),
            speed=speed,
            force=0.0,
            rate=0.0,
            dt=1e-6,
            stage=0,
        )
        assert k_m / rate * 0.59 / (0.44 * 1.33) == pytest.approx(expected, abs=1.5)


@pytest.mark.parametrize("time", [1e-7, 3e-6, 1e-5, 1e-4, 1e-2])
@pytest.mark.parametrize("c", [0.0, 300.0])
def test_step_limit_of_the_branch(physics, time, c):
    """Stable at the limit: spectral radius of the scheme; unstable at 1.5 times it or twice it."""
    k, k_m, m = 2e8, 8e7, 8e-3

    def radius(h):
        left = np.exp(-h / time)
        slope = k_m * time * (1 - left)
        # v' = v - h/m (k x + f + c v), x' = x + h v', f' = left f + slope v'
        a = np.array([1 - h * c / m, -h * k / m, -h / m])
        return max(abs(np.linalg.eigvals(
            np.array([a, [h * a[0], 1 + h * a[1], h * a[2]], [slope * a[0], slope * a[1],
                                                             left + slope * a[2]]])
        )))  # fmt: skip

    limit = physics.call("largest_step_with_branch", k=k, c=c, m=m, k_m=k_m, rate=1 / time)
    for part in (0.1, 0.5, 0.9, 0.999):
        assert radius(part * limit) <= 1 + 1e-9
    assert radius(1.25 * limit) > 1
    assert limit > 0.8 * physics.call("largest_step", k=k, c=c, m=m)


def test_branch_is_a_spring_and_a_dashpot_in_series():
    """The exact step of the branch against the matrix exponential of its equation."""
    branch = film_damping.Branch(3e7, 2e-4)
    rate = np.array([[-1 / branch.time, branch.stiffness], [0, 0]])
    for step in (1e-6, 1e-4, 1e-2):
        expected = expm(rate * step) @ [5.0, 1e-4]
        assert film_damping.advance(5.0, branch, 1e-4, step)[0] == pytest.approx(expected[0])
