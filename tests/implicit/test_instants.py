# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of capacitance and loads at instants within a host step (fix bearing/capacitance ... within
M)."""

import numpy as np
import pytest
from bearings import B6208
from host import BOX, deck_file, refuses, succeed
from raceway import capacitance, hertz

CASE = "tests/implicit/in.case"
PERMITTIVITY, BACKGROUND = 2.25, 5e-12
RADIAL = "x free y free spin speed 50 force 0 -5000 0 ramp 3.0e-3"
TILTED = (
    "x free y free z free rx free ry free spin speed 50 force 0 -5000 1000 moment 5 0 0 ramp 3.0e-3"
)


def sampled(folder, within, **case):
    """Return (rows of contacts, totals, values for thermo) from a run of in.case with capacitances
    at instants within steps."""
    folder.mkdir()
    more = folder / "more"
    more.write_text(
        f"fix cap balls bearing/capacitance 1 permittivity {PERMITTIVITY} background {BACKGROUND}"
        f" within {within} file {folder}/totals.txt contacts {folder}/instants.txt\nfix now all"
        " ave/time 1 1 1 f_cap[1] f_cap[2] f_cap[3] f_cap[4] f_cap[5] f_cap[6] file"
        f" {folder}/now.txt\n"
    )
    succeed(CASE, out=folder, more=more, **case)
    return [np.loadtxt(folder / name) for name in ("instants.txt", "totals.txt", "now.txt")]


def by_instant(rows, instants, column):
    """Return one column of the contacts as an array (instants, raceways, balls), which is 0 for
    open contacts."""
    table = np.zeros((instants + 1, 2, 9))
    table[
        np.rint(rows[:, 1] * instants / rows[-1, 1]).astype(int),
        rows[:, 3].astype(int),
        rows[:, 2].astype(int) - 1,
    ] = rows[:, column]
    return table


@pytest.mark.parametrize("inner", [RADIAL, TILTED], ids=["radial", "tilted"])
def test_instants_are_what_finer_steps_give(inner, tmp_path):
    """Host steps of 0.8 ms (1 degree of orbit) with 8 instants each are compared with host steps of
    0.1 ms. Both have an error of 1 nm per internal step. At 2e8 N/m this corresponds to 0.2 N or
    1e-4 of the largest load, plus the errors of a few earlier steps, which are not damped yet.
    """
    case = dict(inner=inner, control="tolerance 1e-9")
    coarse, _, _ = sampled(tmp_path / "coarse", 8, sample=8e-4, samples=20, **case)
    fine, _, _ = sampled(tmp_path / "fine", 1, sample=1e-4, samples=160, **case)
    found, truth = by_instant(coarse, 160, 4), by_instant(fine, 160, 4)
    assert np.abs(found - truth)[40:].max() < 5e-4 * truth.max()
    # film and capacitance follow from load and speed; at the edge of the load zone Q^0.7 magnifies
    # the error in the load
    found, truth = by_instant(coarse, 160, 6), by_instant(fine, 160, 6)
    assert np.abs(found - truth)[40:].max() < 1e-3 * truth.max()


def test_a_load_that_comes_on_within_steps(tmp_path):
    """During a ramp of 3 ms with host steps of 1 ms, instants are computed from every internal
    step, not only from the ends of host steps."""
    coarse, _, _ = sampled(
        tmp_path / "coarse", 10, sample=1e-3, samples=4, inner=RADIAL, control="tolerance 1e-9"
    )
    fine, _, _ = sampled(
        tmp_path / "fine", 1, sample=1e-4, samples=40, inner=RADIAL, control="tolerance 1e-9"
    )
    found, truth = by_instant(coarse, 40, 4), by_instant(fine, 40, 4)
    assert np.abs(found - truth).max() < 2e-3 * truth.max()
    ends = np.concatenate(
        [np.linspace(truth[k], truth[k + 10], 10, endpoint=False) for k in range(0, 40, 10)]
    )
    assert np.abs(ends - truth[:-1]).max() > 0.02 * truth.max()


def test_columns(tmp_path):
    """Capacitances agree with those that the Python package computes from the load and film in each
    row. Totals, largest values, numbers of active balls and the values for a step agree with the
    rows."""
    rows, totals, now = sampled(tmp_path / "run", 5, sample=4e-4, samples=8, inner=RADIAL)
    bearing = B6208
    for side in (0, 1):
        step, time, ball, _, load, h_c, found = rows[rows[:, 3] == side].T
        ellipse = hertz.exact(*bearing.effective_radii(side))
        a, b = hertz.semi_axes(ellipse, bearing.effective_modulus, load)
        pressure = hertz.pressure(ellipse, bearing.effective_modulus, load)
        # values were written with 12 digits
        np.testing.assert_allclose(
            found, capacitance.contact(PERMITTIVITY, pressure, a, b, h_c), rtol=1e-10
        )
    sums = []
    for step, time, total, largest, active in totals:
        here = rows[np.isclose(rows[:, 0], step)]
        assert np.allclose(here[:, 1], time)
        inner, outer = ({int(r[2]): r[6] for r in here if r[3] == side} for side in (0, 1))
        series = [1 / (1 / inner[k] + 1 / outer[k]) for k in inner.keys() & outer.keys()]
        assert [total, largest, active] == pytest.approx(
            [sum(series) + BACKGROUND, max(series, default=0), len(series)], rel=1e-10
        )
        sums.append(total)
    np.testing.assert_allclose(totals[:, 0], np.arange(41) / 5, atol=1e-9)
    np.testing.assert_allclose(totals[:, 1], np.arange(41) * 8e-5, atol=1e-12)
    for step, last, _, _, mean, least, most in now:
        of = sums[5 * int(step) - 4 : 5 * int(step) + 1] or sums[:1]
        assert [last, mean, least, most] == pytest.approx(
            [of[-1], np.mean(of), min(of), max(of)], rel=1e-5
        )


FILM = """include inputs/bearings/6208
pair_style bearing/ehd young 2.07e11 2.07e11 poisson 0.29 0.29 lubricant 0.04 2e-8 &
  roughness 1e-7 1e-7
pair_coeff 1 3 inner ${inner_radius} ${inner_groove}
pair_coeff 1 4 outer ${outer_radius} ${outer_groove}
create_bearing 1 none 3 4 balls 9 diameter ${ball_diameter}
group balls type 1
group rings type 3 4
fix rings rings bearing/ring
timestep 1.0e-5
"""


@pytest.mark.parametrize(
    "fixes, message",
    [
        (
            (
                "fix m all bearing/implicit\nfix c balls bearing/capacitance 1 permittivity 2.2"
                " within 0"
            ),
            "instants per step is 0",
        ),
        (
            "fix m balls nve/sphere\nfix c balls bearing/capacitance 1 permittivity 2.2 within 4",
            "'within 4' needs fix bearing/implicit",
        ),
        (
            (
                "fix m all bearing/implicit\nfix c balls bearing/capacitance 1 permittivity 2.2"
                " file no/such/folder/f"
            ),
            "cannot write 'no/such/folder/f'",
        ),
    ],
    ids=["range", "verlet", "file"],
)
def test_mistakes_are_named(fixes, message, tmp_path):
    refuses(deck_file(tmp_path, BOX + FILM + fixes + "\nrun 1\n"), message, timeout=60)
