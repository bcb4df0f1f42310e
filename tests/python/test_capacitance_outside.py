# SPDX-License-Identifier: GPL-2.0-or-later
"""The gap around a contact as a capacitor: integrals are compared with each other and with
published values, and closed-form expressions are compared with the integrals."""

import sys

import numpy as np
import pytest
from host import ROOT
from raceway import capacitance, capacitance_outside, groove_width, hertz
from raceway.core import laws
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.groove_width import HalfWidths
from references import capacitance_integral

sys.path.insert(0, str(ROOT / "tests/bench"))
import capacitance_error  # noqa: E402  the module is not in a package

SEPARATIONS = np.array([30e-9, 70e-9, 300e-9, 1e-6])
DEPTH = 2.3e-3  # m, depth of the 6208's grooves assumed in the tables of values
MIDDLE = capacitance_error.bearing("7.938 mm", 0.515)
SMALL = capacitance_error.bearing("3.968 mm", 0.53)


def closed(bearing, raceway, load, separation, widths, angle=0.0):
    r_x, r_y = bearing.effective_radii(raceway, angle)
    return capacitance_outside.loaded(
        hertz.exact(r_x, r_y), bearing.effective_modulus, r_x, load, separation, widths
    )


def rigid(bearing, raceway, separation, widths, angle=0.0):
    r_x, r_y = bearing.effective_radii(raceway, angle)
    ellipse, groove = hertz.exact(r_x, r_y), bearing.groove(raceway)
    return capacitance_outside.rigid(ellipse, r_x, bearing.ball_radius, groove, separation, widths)


# integral I in mm over a parabola from -width to +width, for each entry of SEPARATIONS, as computed
# by an independent program
@pytest.mark.parametrize(
    ("name", "raceway", "width", "load", "a", "b", "printed"),
    [
        ("6208", INNER, 4.2, 8, 0.3061, 0.03265, (1914.2, 1628.5, 1247.5, 991.6)),
        ("6208", INNER, 4.2, 120, 0.7548, 0.08053, (2477.3, 1999.7, 1412.0, 1066.1)),
        ("6208", INNER, 4.2, 900, 1.4776, 0.15763, (3299.4, 2568.6, 1692.8, 1207.3)),
        ("6208", OUTER, 4.2, 120, 0.7305, 0.10078, (3013.9, 2439.9, 1730.7, 1310.6)),
        ("6208", OUTER, 4.2, 2000, 1.8661, 0.25744, (4546.6, 3505.6, 2263.1, 1581.6)),
        ("middle", OUTER, 2.8, 600, 1.2013, 0.13952, (2673.7, 2070.0, 1344.3, 939.4)),
        ("small", INNER, 1.4, 60, 0.3499, 0.04513, (588.3, 469.4, 322.9, 236.7)),
    ],
)
def test_printed_integrals(bearing, name, raceway, width, load, a, b, printed):
    one = {"6208": bearing, "middle": MIDDLE, "small": SMALL}[name]
    r_x, r_y = one.effective_radii(raceway)
    contact = capacitance_integral.contact(r_x, r_y, one.effective_modulus, load)
    assert (1e3 * contact.a, 1e3 * contact.b) == (
        pytest.approx(a, abs=6e-5),
        pytest.approx(b, abs=6e-6),
    )
    width *= 1e-3
    found = 1e3 * capacitance_integral.parabola(
        r_x, r_y, one.effective_modulus, load, SEPARATIONS, width
    )
    assert found == pytest.approx(printed, rel=5e-5, abs=0.06)
    form = 1e3 * closed(one, raceway, load, SEPARATIONS, HalfWidths(width, width))
    assert form == pytest.approx(printed, rel=0.011)


ARC = [  # integral and closed-form value of I in mm at 900 N
    (INNER, 5.850, (3434, 2703, 1825, 1338), (3410.1, 2685.3, 1814.7, 1330.3)),
    (OUTER, 5.614, (4135, 3258, 2205, 1617), (4100.2, 3234.7, 2192.2, 1609.1)),
]


@pytest.mark.parametrize(("raceway", "width", "integral", "form"), ARC)
def test_circular_groove(bearing, raceway, width, integral, form):
    edge = groove_width.shoulder_angle(bearing.groove(raceway), bearing.ball_radius, DEPTH)
    assert edge == pytest.approx(0.8946, abs=6e-5)
    widths = groove_width.half_widths(bearing, raceway, DEPTH)
    assert [1e3 * width for width in widths] == pytest.approx([width, width], abs=6e-4)
    found = 1e3 * capacitance_integral.arc(bearing, raceway, 900.0, SEPARATIONS, DEPTH)
    assert found == pytest.approx(integral, abs=1.0)  # one unit in the last printed digit
    assert 1e3 * closed(bearing, raceway, 900.0, SEPARATIONS, widths) == pytest.approx(
        form, abs=0.06
    )


@pytest.mark.parametrize(
    ("raceway", "printed"),
    [(INNER, (1303.6, 893.7, 654.4, 460.5)), (OUTER, (1591.0, 1085.8, 792.0, 555.4))],
)
def test_rigid_gap(bearing, raceway, printed):
    gaps = np.array([0.3e-6, 3e-6, 12e-6, 40e-6])
    found = 1e3 * capacitance_integral.rigid_arc(bearing, raceway, gaps, DEPTH)
    assert found == pytest.approx(printed, abs=0.06)
    widths = groove_width.half_widths(bearing, raceway, DEPTH)
    form = 1e3 * rigid(bearing, raceway, gaps, widths)
    assert form[:3] == pytest.approx(printed[:3], rel=3.5e-3)
    assert form[3] == pytest.approx(printed[3], rel=0.01)


def test_rigid_gap_of_concentric_circles(bearing):
    """If the circles of groove and ball are concentric, the gap is constant across the groove. The
    closed-form expression has no singularity in this case and agrees with the integral."""
    one = capacitance_error.bearing("3.968 mm", 0.505)
    gap = one.groove_gap(OUTER)
    widths = groove_width.half_widths(one, OUTER, 0.18 * one.ball_diameter)
    near = rigid(one, OUTER, gap * np.array([0.999, 1.0, 1.001]), widths)
    assert np.diff(near, 2) == pytest.approx(0, abs=2e-6 * near[1])
    exact = capacitance_integral.rigid_arc(one, OUTER, gap, 0.18 * one.ball_diameter)
    assert near[1] == pytest.approx(exact, rel=0.01)


def test_beside_is_universal():
    ratio = np.array([1e-3, 1e-2, 0.1, 1, 10, 100, 1e3])
    printed = (33.816, 14.909, 6.2766, 2.4636, 0.89114, 0.30126, 0.097902)
    assert capacitance_integral.beside(ratio) == pytest.approx(printed, rel=3e-5)
    assert laws.gap_beside(ratio) == pytest.approx(printed, rel=2e-3)
    thin, thick = 1e-12, 1e8
    assert laws.gap_beside(thin) == pytest.approx(3.5501 * thin ** (-1 / 3), rel=2e-3)
    assert laws.gap_beside(thick) == pytest.approx(np.pi / thick**0.5, rel=2e-3)


def test_gap_is_hertz_s(bearing):
    """The gap is zero at the edge of the ellipse, approaches the gap between the undeformed bodies
    far away from it, and equals the gap of a line contact in between."""
    r_x, r_y = bearing.effective_radii(INNER)
    one = capacitance_integral.contact(r_x, r_y, bearing.effective_modulus, 900.0)
    turn = np.linspace(0, np.pi / 2, 7)
    edge = capacitance_integral.gap(one, one.b * np.cos(turn), one.a * np.sin(turn))
    assert np.abs(edge).max() < 1e-9 * one.overlap
    far = 200 * one.a
    undeformed = far**2 / (2 * r_x) - one.overlap
    assert capacitance_integral.gap(one, far, 0.0) == pytest.approx(undeformed, rel=1e-6)
    # for a long ellipse with the same b: g = b^2/(2 R_x) (xi sqrt(xi^2 - 1) - arccosh xi)
    long = capacitance_integral.contact(r_x, 4e4 * r_x, bearing.effective_modulus, 1e6)
    xi = 1.7
    line = long.b**2 / (2 * r_x) * (xi * np.sqrt(xi * xi - 1) - np.arccosh(xi))
    assert capacitance_integral.gap(long, xi * long.b, 0.0) == pytest.approx(line, rel=1e-3)


def test_no_load_is_the_rigid_gap(bearing):
    widths = groove_width.half_widths(bearing, INNER, DEPTH)
    loaded = closed(bearing, INNER, 1e-9, SEPARATIONS, widths)
    thin = SEPARATIONS / bearing.groove_gap(INNER)  # only the rigid form includes it
    assert loaded == pytest.approx(rigid(bearing, INNER, SEPARATIONS, widths), rel=thin.max())
    exact = capacitance_integral.arc(bearing, INNER, 1e-6, SEPARATIONS, DEPTH)
    still = capacitance_integral.rigid_arc(bearing, INNER, SEPARATIONS, DEPTH)
    assert exact == pytest.approx(still, rel=2e-3)


def test_it_falls_with_separation_and_grows_with_load(bearing):
    widths = groove_width.half_widths(bearing, OUTER, DEPTH)
    separation, load = np.geomspace(20e-9, 2e-6, 30), np.geomspace(0.1, 3000, 30)[:, None]
    found = closed(bearing, OUTER, load, separation, widths)
    assert np.all(np.diff(found, axis=1) < 0) and np.all(np.diff(found, axis=0) > 0)


@pytest.mark.parametrize("angle", [-0.35, 0.17, 0.35, 0.52])
def test_at_a_contact_angle(bearing, angle):
    """At angles up to 30 degrees, the mean over both sides of the groove is within 1.3 % of the
    integral up to both shoulders."""
    for raceway in (INNER, OUTER):
        for load in (10.0, 900.0):
            widths = groove_width.half_widths(bearing, raceway, DEPTH, angle)
            form = closed(bearing, raceway, load, SEPARATIONS, widths, angle)
            exact = capacitance_integral.arc(bearing, raceway, load, SEPARATIONS, DEPTH, angle)
            assert form == pytest.approx(exact, rel=0.013)
            # only the part around the ellipse, as for the capacitors
            ellipse = hertz.exact(*bearing.effective_radii(raceway, angle))
            a, _ = hertz.semi_axes(ellipse, bearing.effective_modulus, load)
            widths = groove_width.half_widths(bearing, raceway, DEPTH, angle, semi_axis=a)
            form = closed(bearing, raceway, load, SEPARATIONS, widths, angle)
            assert form == pytest.approx(exact, rel=0.015)
    assert capacitance_integral.arc(bearing, INNER, 9.0, 1e-7, DEPTH, angle) == pytest.approx(
        capacitance_integral.arc(bearing, INNER, 9.0, 1e-7, DEPTH, -angle), rel=1e-12
    )


def test_a_wide_ellipse_beside_its_shoulder():
    """Only the part of the groove outside the ellipse counts. Under 3 kN, the ellipse fills 0.93 of
    a tight groove. If the whole groove counted, the closed-form value would be 3 % too large."""
    load, separation, depth = 3000.0, 2e-6, 0.18 * 7.938e-3
    bearing = capacitance_error.bearing("7.938 mm", 0.505)
    ellipse = hertz.exact(*bearing.effective_radii(INNER))
    a, _ = hertz.semi_axes(ellipse, bearing.effective_modulus, load)
    exact = capacitance_integral.arc(bearing, INNER, load, separation, depth)
    for semi_axis, error in ((0.0, 0.031), (a, 0.0)):
        widths = groove_width.half_widths(bearing, INNER, depth, semi_axis=semi_axis)
        form = closed(bearing, INNER, load, separation, widths)
        assert form / exact - 1 == pytest.approx(error, abs=5e-4)


def test_fills():
    fill = capacitance_outside.fill
    assert fill(2.2) == 2.2 and fill(2.2, "dry") == 1.0
    assert fill(2.2, "cavitated", 1.0) == pytest.approx((fill(2.2) + fill(2.2, "dry")) / 2)
    assert fill(2.2, "cavitated", 2.2) == pytest.approx(2.2)
    with pytest.raises(ValueError, match="fill 'wet' is not one of flooded, cavitated, dry"):
        fill(2.2, "wet")
    with pytest.raises(ValueError, match="outlet = 3 must be from 1"):
        fill(2.2, "cavitated", 3)


def test_bad_values(bearing):
    widths = HalfWidths(4e-3, 4e-3)
    with pytest.raises(ValueError, match="load = 0.0 N must be positive"):
        closed(bearing, INNER, 0.0, 1e-7, widths)
    with pytest.raises(ValueError, match="separation = 0.0 m must be positive"):
        closed(bearing, INNER, 1.0, 0.0, widths)
    with pytest.raises(ValueError, match="separation = -1e-06 m must be positive"):
        rigid(bearing, INNER, -1e-6, widths)
    with pytest.raises(ValueError, match="kappa = .* must be 1 or more"):
        capacitance_outside.loaded(hertz.exact(5e-3, 4e-3), 2e11, 5e-3, 1.0, 1e-7, widths)
    with pytest.raises(ValueError, match=r"shoulder diameter = 0.048 m is 0 m from"):
        groove_width.depth(bearing, INNER, 0.048)
    with pytest.raises(ValueError, match="load = -1.0 N must be positive"):
        capacitance_integral.parabola(5e-3, 0.1, 2e11, -1.0, 1e-7, 4e-3)


def test_depth_of_the_catalogue_s_shoulders(bearing):
    assert groove_width.depth(bearing, INNER, 52.6e-3) == pytest.approx(2.3e-3)
    assert groove_width.depth(bearing, OUTER, 69.8e-3) == pytest.approx(1.7e-3)
    assert groove_width.depth(bearing, OUTER) == pytest.approx(0.18 * 12.6e-3)


def test_ellipse_that_fills_the_groove(bearing):
    """If an ellipse fills the groove, no capacitance remains beyond its ends."""
    assert laws.gap_beyond(0.1, 9.0, np.array([0.0, 0.5, 1.0])) == pytest.approx(
        [0, 0, 0], abs=0.03
    )


def test_permittivity_of_a_film():
    film = capacitance.film_permittivity
    assert (
        film(2.2, 1.5e9) == capacitance.permittivity(2.2, 1.5e9) == pytest.approx(2.654, abs=6e-4)
    )
    assert film(2.2, 1.5e9, "two_thirds") == pytest.approx(2.593, abs=6e-4)
    assert film(2.2, 1.5e9, "mean") == pytest.approx(2.578, abs=6e-4)
    r = np.sqrt((np.arange(20000) + 0.5) / 20000)  # rings of equal area
    rings = capacitance.permittivity(2.2, 1.5e9 * np.sqrt(1 - r * r)).mean()
    assert film(2.2, 1.5e9, "mean") == pytest.approx(rings, rel=1e-6)
    with pytest.raises(ValueError, match="permittivity_at 'top' is not one of maximum, mean"):
        film(2.2, 1e9, "top")
    for ambient in (0.9, 20.0):
        with pytest.raises(ValueError, match="permittivity"):
            capacitance.permittivity(ambient, 3e9)


@pytest.mark.parametrize("row", [("12.6 mm", 0.505, OUTER), ("3.968 mm", 0.54, OUTER),
                                 ("7.938 mm", 0.505, INNER)])  # fmt: skip
def test_the_closed_form_keeps_its_promise(row):
    """Even in the worst rows of tests/bench/capacitance_error.py, the error of the closed-form
    value is below the stated bound."""
    assert capacitance_error.errors(*row).inside < capacitance_error.PROMISE


def test_a_bearing_of_the_page():
    one = capacitance_error.bearing("12.6 mm", 0.52)
    assert isinstance(one, Bearing) and one.inner_radius == pytest.approx(24e-3)
