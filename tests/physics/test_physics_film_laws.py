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
SHEAR = {1: film_factors.murch_wilson, 2: film_factors.wilson}  # 3 is Gupta's
# forty roundings in exponents of at most 50
ROUNDING = 1e-12


@pytest.fixture(scope="module", params=[INNER, OUTER], ids=["inner", "outer"])
def side(request):
    return request.param


def scene(share=1.0, starvation=1.0, regimes=False, shear=0, sliding=0.0):
    return {
        "share": share,
        "starvation": starvation,
        "all_regimes": float(regimes),
        "shear": float(shear),
        "sliding": sliding,
    }


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

    def cpp(self, overlap, speed, share=1.0, starvation=1.0, **changes):
        """(whether there is no contact, its numbers)."""
        return self.call(
            "film_contact",
            p=self.raceway._handle,
            scene=scene(share=share, starvation=starvation, **changes),
            overlap=overlap,
            speed=speed,
        )

    def stored(self, overlap, speed, **changes):
        """Energy, J."""
        return self.call(
            "film_stored",
            p=self.raceway._handle,
            scene=scene(**changes),
            overlap=overlap,
            speed=speed,
        )

    def law(self, speed, factor=1.0):
        return film_gap.power_law(*OIL, self.modulus, self.r_x, self.kappa, speed, factor=factor)

    def regimes(self, speed, factor=1.0):
        return film_gap.all_regimes(*OIL, self.modulus, self.r_x, self.r_y, speed, factor=factor)

    def heated(self, law, speed, sliding, cut):
        """`law` with Gupta's factor."""
        loading = film_factors.thermal_loading(0.047, OIL[0], speed, 0.134)
        peak = self.raceway.radial().p * self.stiffness ** (-1 / 3) / self.modulus
        return film_gap.heated(law, loading, peak, sliding / speed, cut=cut)


@pytest.fixture(scope="module")
def gap(physics, side):
    return Gap(physics, side)


@pytest.fixture(scope="module")
def inner(physics):
    return Gap(physics, INNER)


def factor(physics, shear, speed, starvation=1.0, pressure=0.0, sliding=0.0):
    return physics.call(
        "film_factor",
        shear=shear,
        beta=0.047 if shear else 0.0,
        viscosity=0.04,
        conductivity=0.134 if shear else 0.0,
        starvation=starvation,
        speed=speed,
        pressure=pressure,
        sliding=sliding,
    )


# ---- factors -----------------------------------------------------------------------------------
@pytest.mark.parametrize("shear", SHEAR)
@pytest.mark.parametrize("speed", [1e-3, *SPEEDS, 90.0])
def test_inlet_shear(physics, shear, speed):
    loading = film_factors.thermal_loading(0.047, 0.04, speed, 0.134)
    found = factor(physics, shear, speed, 0.8)
    assert found == pytest.approx(0.8 * SHEAR[shear](loading), rel=ROUNDING)


@pytest.mark.parametrize("sliding", [0.0, 0.02, 0.3])
@pytest.mark.parametrize("speed", [1e-3, *SPEEDS])
def test_gupta(physics, speed, sliding):
    loading = film_factors.thermal_loading(0.047, 0.04, speed, 0.134)
    for pressure in (0.0, 0.004, 0.0115):
        found = factor(physics, 3, speed, 0.8, pressure, sliding)
        expected = 0.8 * film_factors.gupta(loading, pressure, sliding / speed)
        assert found == pytest.approx(expected, rel=ROUNDING)


def test_gupta_beyond_its_range(physics):
    """Python refuses; a run goes on with a tenth of what is left without pressure."""
    loading = film_factors.thermal_loading(0.047, 0.04, 90.0, 0.134)
    with pytest.raises(ValueError, match="range of Gupta"):
        film_factors.gupta(loading, 0.02)
    found = factor(physics, 3, 90.0, pressure=0.02)
    assert found == pytest.approx(0.1 / (1 + 0.213 * loading**0.64), rel=ROUNDING)


def test_digits_of_gupta(physics):
    modulus = Gap(physics, INNER).modulus
    speeds = (0.7248, 2.899, 14.4946)
    found = [factor(physics, 3, u, pressure=2.571e9 / modulus) for u in speeds]
    assert found == pytest.approx((0.9724, 0.8917, 0.5391), abs=5e-5)


def test_digits_of_inlet_shear(physics):
    speeds = (0.7248, 2.899, 14.4946)
    for shear, expected in ((1, (0.9881, 0.9368, 0.6684)), (2, (0.9957, 0.9752, 0.8335))):
        found = [factor(physics, shear, u) for u in speeds]
        assert found == pytest.approx(expected, abs=5e-5)


def test_no_factor(physics):
    assert factor(physics, 0, 14.0) == 1.0
    assert factor(physics, 1, 0.0) == 1.0  # at rest
    assert factor(physics, 3, 0.0, pressure=0.01, sliding=0.1) == 1.0


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


# films whose root is found by Newton's method on the film itself
LAWS = {
    "power": {},
    "moes": {"regimes": True},
    "gupta": {"shear": 3, "sliding": 0.02},
    "moes, gupta": {"regimes": True, "shear": 3, "sliding": 0.02},
}
ROOTS = {name: law for name, law in LAWS.items() if law}
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


def theory(gap, law, speed, share=1.0, starvation=1.0):
    """The film of `law` in Python."""
    base, cut = (gap.regimes, 0.0) if "regimes" in law else (gap.law, film_gap.CUT)
    film_law = base(speed, starvation)
    return gap.heated(film_law, speed, law["sliding"], cut) if "shear" in law else film_law


@pytest.mark.parametrize("law", ROOTS.values(), ids=ROOTS)
@pytest.mark.parametrize("share, starvation", [(1.0, 1.0), (1.05, 0.7), (0.5, 1.0)])
@pytest.mark.parametrize("speed", SPEEDS)
def test_roots_as_in_python(gap, law, speed, share, starvation):
    checked = 0
    for overlap in OVERLAPS:
        film_law = theory(gap, law, speed, share, starvation)
        expected = film_gap.solve(overlap, gap.stiffness, film_law, share)
        open_, found = gap.cpp(overlap, speed, share, starvation, **law)
        assert open_ == (expected.load == 0)
        if open_ or share * expected.h_c > found.reach:
            continue
        worst = 1e-10 * (1 + share * expected.h_c / expected.elastic)
        assert found.compression == pytest.approx(expected.elastic, rel=worst)
        assert found.load == pytest.approx(expected.load, rel=1.5 * worst)
        assert found.h_c == pytest.approx(expected.h_c, rel=1e-10)
        assert found.slope == pytest.approx(expected.slope, rel=1e-7)
        checked += 1
    assert checked >= 5


def test_digits_of_all_regimes(inner):
    """At no overlap and 9549 rpm, with a film that needs no cut."""
    assert inner.cpp(0.0, 14.4946, regimes=True)[1].load == pytest.approx(81.56, abs=0.005)


@pytest.mark.parametrize("law", ROOTS.values(), ids=ROOTS)
def test_roots_everywhere(gap, law):
    """delta_H = delta + zeta h, h at most as thick as the reach allows; from the edge of the film
    to a heavy load, crawling to fast."""
    reach = gap.cpp(0.0, 1.0)[1].reach
    for speed, share in itertools.product(np.geomspace(1e-6, 60, 15), (1e-3, 0.3, 1.0, 2.0)):
        law_there = theory(gap, law, speed)
        edge = reach / share if "regimes" in law else law_there(np.array(1.0))[0]
        parts = (*np.linspace(-0.999, 0.999, 21), 1e-3, -1e-3, 0.0)
        for overlap in (*(part * share * edge for part in parts), 3e-6, 2e-5, 6e-5):
            open_, found = gap.cpp(overlap, speed, share, **law)
            assert not open_
            film_there = min(float(law_there(np.array(found.load))[0]), edge)
            assert found.h_c == pytest.approx(film_there, rel=1e-9)
            size = abs(overlap) + share * film_there
            assert found.compression == pytest.approx(overlap + share * film_there, abs=1e-9 * size)


@pytest.mark.parametrize("law", ROOTS.values(), ids=ROOTS)
def test_roots_are_continuous_through_loss_of_contact(gap, law):
    for speed in SPEEDS:
        reach = gap.cpp(0.0, speed)[1].reach
        edge = reach if "regimes" in law else theory(gap, law, speed)(np.array(1.0))[0]
        opens, _ = gap.cpp(-edge * (1 + 1e-9), speed, **law)
        begins, found = gap.cpp(-edge * (1 - 1e-9), speed, **law)
        assert opens and not begins
        assert 0 < found.load < 1.1 * gap.stiffness * (1e-9 * edge) ** 1.5
        overlaps = np.linspace(-edge * (1 - 1e-9), 2e-6, 801)
        loads = np.array([gap.cpp(d, speed, **law)[1].load for d in overlaps])
        slopes = np.array([gap.cpp(d, speed, **law)[1].slope for d in overlaps])
        rises = np.diff(loads)
        assert np.all(rises > 0)
        # a load that jumps would rise by more than its slopes at both ends and the wall of the edge
        wall = 1.5 * gap.stiffness * np.sqrt(overlaps[1] - overlaps[0])
        steepest = np.maximum(np.maximum(slopes[1:], slopes[:-1]), 0) * 1.5
        within = rises <= np.maximum(steepest, wall) * (overlaps[1] - overlaps[0])
        assert np.all(within)


@pytest.mark.parametrize("law", ROOTS.values(), ids=ROOTS)
def test_slopes_of_roots_are_differences(gap, law):
    checked = 0
    for overlap, speed in itertools.product(OVERLAPS, SPEEDS):
        open_, found = gap.cpp(overlap, speed, **law)
        step = 1e-4 * found.compression
        if open_ or found.h_c >= gap.cpp(0.0, 1.0)[1].reach:
            continue
        loads = [gap.cpp(overlap + s * step, speed, **law)[1].load for s in (-2, -1, 1, 2)]
        if (loads[0] - 1) * (loads[3] - 1) < 0:
            continue  # the kink where a power law is cut
        difference = (loads[0] - 8 * loads[1] + 8 * loads[2] - loads[3]) / (12 * step)
        assert found.slope == pytest.approx(difference, rel=1e-6)
        checked += 1
    assert checked > 20


@pytest.mark.parametrize("law", ROOTS.values(), ids=ROOTS)
@pytest.mark.parametrize("speed", [0.0725, 14.4946])
def test_energy_of_roots_is_the_work(gap, law, speed):
    """Between two overlaps, at a constant speed."""
    reach = gap.cpp(0.0, speed)[1].reach
    first = -0.3 * reach if "regimes" in law else -1e-8
    if gap.cpp(first, speed, **law)[0]:
        first = 0.0
    for end in (0.5e-6, 17e-6):
        pieces = [first, *(p for p in (-1e-5, -3e-6, -1e-6, -3e-7, 0.0, 1e-7) if first < p), end]
        work = sum(
            quad(lambda d: gap.cpp(d, speed, **law)[1].load, a, b, epsrel=1e-9, limit=100)[0]
            for a, b in itertools.pairwise(pieces)
        )
        gained = gap.stored(end, speed, **law) - gap.stored(first, speed, **law)
        assert gained == pytest.approx(work, rel=1e-6)


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


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_lanes_have_the_bits_of_a_double(gap, law):
    """Lanes with contacts of all kinds side by side: none takes another's number of passes."""
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
            assert gap.stored(end, speed) == pytest.approx(work, rel=1e-7)


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
