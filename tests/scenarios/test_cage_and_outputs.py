# SPDX-License-Identifier: GPL-2.0-or-later
"""The cage stays on its rails, and all ways to read the data of a contact give the same values."""

import re

import numpy as np
import pytest
from host import QUICK, ROOT, succeed
from raceway.runs.tables import RunTables

SAMPLES = 40


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Run the main deck for one ball pass with additional computes."""
    folder = tmp_path_factory.mktemp("cage")
    deck = folder / "in.cage"
    text = (ROOT / "inputs" / "in.6208").read_text()
    extra = """
compute total all bearing/total
compute per balls bearing/ball inner_load outer_load azimuth orbit inner_h_min
variable orbit equal c_total[8]
variable rail equal f_cage[1]
compute sum_inner balls reduce sum c_per[1]
compute max_outer balls reduce max c_per[2]
compute mean_orbit balls reduce ave c_per[4]
variable sum_inner equal c_sum_inner
variable max_outer equal c_max_outer
variable mean_orbit equal c_mean_orbit
compute energy all pe
compute virial all pressure thermo_temp virial
variable virial equal c_virial
variable volume equal vol
fix more balls bearing/capacitance 1 background 30e-12
variable more equal f_more[1]
variable top equal f_more[2]
variable active equal f_more[3]
variable bare equal f_cap
variable pe equal c_energy
"""
    marker = (
        'fix totals all print 1 "${sum_inner} ${max_outer} ${mean_orbit} ${orbit} ${rail} ${pe}'
        ' ${virial} ${volume} ${more} ${top} ${active} ${bare}" file ${out}/totals.txt screen no\n'
    )
    deck.write_text(text.replace("run_bearing ", extra + marker + "run_bearing "))
    succeed(deck, out=folder / "run", passes=1, samples=SAMPLES, within=1, dumps="yes", **QUICK)
    result = RunTables(folder / "run")
    names = (
        "sum_inner max_outer mean_orbit orbit rail pe virial volume more top active bare".split()
    )
    rows = np.loadtxt(folder / "run" / "totals.txt")[-SAMPLES:]
    result.totals = dict(zip(names, rows.T))
    return result


def test_values_of_balls_are_those_of_the_contacts(run):
    """The values of compute bearing/ball and the local rows come from the same table; the dumps
    have 12 digits. tests/record/test_one_sum.py checks compute bearing/total."""
    rows = run.contacts[run.contacts["sample"] > 0]
    inner, outer = (rows[rows["raceway"] == side].groupby("sample")["load"] for side in (0, 1))
    np.testing.assert_allclose(run.totals["sum_inner"], inner.sum(), rtol=1e-11)
    np.testing.assert_allclose(run.totals["max_outer"], outer.max(), rtol=1e-11)
    np.testing.assert_allclose(run.totals["orbit"], run.totals["mean_orbit"], rtol=1e-12)


def test_potential_energy_is_that_of_the_springs(run):
    """The potential energy pe equals the sum of 2/5 Q overlap over all raceway contacts; cage
    contacts contribute less than a fraction of 1e-3."""
    energy = run.totals["pe"]
    rows = run.contacts[run.contacts["sample"] > 0]
    springs = (0.4 * rows["load"] * rows["overlap"]).groupby(rows["sample"]).sum().to_numpy()
    np.testing.assert_allclose(energy, springs, rtol=1e-3)


def test_background_is_added_once(run):
    """f_ID[1] is the capacitance by eq 12 plus the background, f_ID[2] the largest capacitance of a
    ball without the background, and f_ID[3] the number of balls in the sum."""
    more, top, active, bare = (run.totals[k] for k in ("more", "top", "active", "bare"))
    np.testing.assert_allclose(more - bare, 30e-12, rtol=1e-9)  # 12 digits of 300 pF
    pairs = run.pairs[run.pairs["sample"] > 0].groupby("sample")["capacitance"]
    np.testing.assert_allclose(top, pairs.max(), rtol=1e-10)
    np.testing.assert_array_equal(active, pairs.count())


def test_virial_is_that_of_the_contact_forces(run):
    """3 p V equals the sum of F.(x_ball - x_ring): in a radial scene, every raceway contact
    contributes -N (n.u) r, where the normal n.u is -1 on the inner and +1 on the outer raceway.
    Cage contacts (below 1 N) and friction are neglected.
    """
    virial, volume = run.totals["virial"], run.totals["volume"]
    for k in range(SAMPLES):
        rows = run.contacts[run.contacts["sample"] == k + 1]
        balls = run.balls[run.balls["sample"] == k + 1].set_index("id")
        expected, size = 0.0, 0.0
        for raceway, ring, ball, normal in rows[["raceway", "ring", "ball", "normal"]].itertuples(
            index=False
        ):
            r = np.hypot(*(balls.loc[int(ball), ["x", "y"]] - balls.loc[int(ring), ["x", "y"]]))
            expected += normal * r * (1 if raceway == 0 else -1)
            size += normal * r
        assert 3 * virial[k] * volume[k] == pytest.approx(expected, abs=1e-3 * size)


def test_cage_balls_stay_centred(run):
    """Cage balls stay in the middle plane and within 190 um of the pitch circle, which is the
    distance that pocket and chord allow."""
    cage = run.balls[run.balls["type"] == 2]
    radius = np.hypot(cage["x"], cage["y"])
    assert np.all(np.abs(radius - 30.3e-3) < 190e-6)
    assert np.all(np.abs(cage["z"]) < 1e-9)  # because both rails are equal


def test_rails_carry_the_centrifugal_load_at_least(run):
    """The force on the rails is the centrifugal force m_c r w^2 on nine polyamide balls, divided by
    the cosine of the seat angle (45 degrees), plus the force of balls that push cage balls
    outwards."""
    mass = 4 / 3 * np.pi * 4.19e-3**3 * 1140
    orbit = 19.8
    assert run.totals["rail"].mean() > 0.99 * 9 * mass * 30.3e-3 * orbit**2 / np.cos(np.pi / 4)


def test_step_limit_is_that_of_the_stiffest_ball(tmp_path):
    """For a dry bearing, the limit of fix bearing/timestep is 2 sqrt(m/k), where k is the stiffness
    of both raceways together. A tangential mode may have a lower limit, because the effective mass
    of the rolling sphere is 2/7 of its mass; the limit is compared with the smaller of the two
    values."""
    deck = tmp_path / "in.limit"
    main = (ROOT / "inputs" / "in.6208").read_text()
    deck.write_text(
        re.sub(r"fix (keep|record) .*\n|print .*", "", main)
        + """
compute contact balls bearing/contact ball stiffness damping
dump contact balls local 1 ${out}/stiffness.dump c_contact[1] c_contact[2] c_contact[3]
dump_modify contact format "%.0f %.12g %.12g"
variable limit equal f_step[1]
fix limit all print 1 "${limit}" file ${out}/limit.txt screen no
fix step all bearing/timestep 1
run 1
"""
    )
    case = dict(lubricant="dry", rpm=100, integrator="verlet")
    succeed(deck, out=tmp_path, **case, **QUICK)
    rows = np.array(
        [
            line.split()
            for line in (
                (tmp_path / "stiffness.dump")
                .read_text()
                .split("c_contact[3]")[-1]
                .strip()
                .splitlines()
            )
        ],
        float,
    )
    limit = np.loadtxt(tmp_path / "limit.txt")
    mass = 4 / 3 * np.pi * 6.3e-3**3 * 7800

    def verlet(k, c, m):
        return (np.sqrt(c**2 + 4 * k * m) - c) / k

    expected = np.inf
    for ball in set(rows[:, 0]):
        k, c = rows[rows[:, 0] == ball, 1].sum(), rows[rows[:, 0] == ball, 2].sum()
        kt = 2 * 0.7 / 1.7 * k  # by Mindlin, for two bodies of the same material
        each = 2 * 0.7 / 1.7 * rows[rows[:, 0] == ball, 1]
        ct = (2 * 0.3 * np.sqrt(2 / 7 * mass * each)).sum()
        expected = min(expected, verlet(k, c, mass), verlet(kt, ct, 2 / 7 * mass))
    assert limit == pytest.approx(expected, rel=1e-9)
