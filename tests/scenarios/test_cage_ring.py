# SPDX-License-Identifier: GPL-2.0-or-later
"""A one-piece rigid cage (fix bearing/cage/ring) in a 6208 is tested with both integrators. The
cage conserves momentum, is slowed by oil as the laws predict, and slips because of its play.
Invalid data are rejected."""

import re

import numpy as np
import pytest
from host import frames, liggghts, refused, succeed, tables

DECK = "tests/scenarios/in.cage_ring"
VERLET = dict(integrator="verlet", dt=2e-7)
BOTH = {"implicit": {}, "verlet": VERLET}
MASS, AXIAL = 0.03, 2.8e-5  # mass (kg) and axial moment of inertia (kg m^2) of the cage
PITCH, BALL = (24.0e-3 + 36.605e-3) / 2, 6.3e-3
LAND = "guide outer 33.0e-3 0.15e-3 2.0e-3 2"
FREE = "x free y free spin free"


def scene(folder, integrator="implicit", *, span=0.02, samples=20, **changes):
    """Run the deck in `folder` for `span` seconds. Return its `Outcome` and rows that contain step,
    time, x, y, spin, angle, largest and total pocket force, loss, eccentricity and torque of the
    cage."""
    dt = float(changes.pop("dt", 2e-7 if integrator == "verlet" else 2e-5))
    sample = round(span / dt / samples)
    changes |= dict(dt=dt, sample=sample, steps=sample * samples, integrator=integrator)
    outcome = succeed(DECK, out=folder, **changes)
    return outcome, np.loadtxt(folder / "cage.txt")


def momenta(folder):
    """Return the total momentum (kg m/s), the total angular momentum (kg m^2/s) about the axis
    through the origin, and the sums of their magnitudes. Each is an array (samples,) or (samples,
    2)."""
    p, size, turn, turns = [], [], [], []
    for _, rows in tables(folder / "balls.dump"):
        kind, x, v, w, m, r = rows[:, 1], rows[:, 2:5], rows[:, 5:8], rows[:, 8:11], *rows[:, 11:].T
        inertia = 0.4 * m * r**2
        for which, mass, axial in ((2, MASS, AXIAL), (3, 0.2, 1.2e-4), (4, 0.3, 3.0e-4)):
            m[kind == which], inertia[kind == which] = mass, axial
        own = m * (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]), inertia * w[:, 2]
        p.append(m @ v[:, :2])
        size.append(m @ np.linalg.norm(v, axis=1))
        turn.append(sum(part.sum() for part in own))
        turns.append(sum(np.abs(part).sum() for part in own))
    return np.array(p), max(size), np.array(turn), max(turns)


@pytest.mark.parametrize("integrator", BOTH)
@pytest.mark.parametrize("shape", ["cylinder", "sphere"])
def test_pockets_and_land_keep_momentum(tmp_path, integrator, shape):
    """The rings are free, and the cage starts at one wall of its pockets. The land of the outer
    ring drags it through oil and friction."""
    _, cage = scene(
        tmp_path,
        integrator,
        inner=FREE,
        outer=FREE,
        turns=-30,
        cage_phase=0.1 + 1.03e-4 / PITCH,
        film="friction stribeck 0.12 0.05 smoothed 0.01",
        words=f"friction 0.1 shape {shape} planar yes {LAND} oil 0.04 0.5 4.4e-3",
        control="tolerance 1e-11 cage_tolerance 1e-11 corrections 20",
    )
    assert cage[:, 7].max() > 0.1 and np.ptp(cage[:, 4]) > 0.01
    p, size, turn, turns = momenta(tmp_path)
    assert np.abs(p - p[0]).max() < 1e-9 * size
    # if there are only raceway contacts, implicit steps conserve momentum to 1e-7
    assert np.abs(turn - turn[0]).max() < (2e-7 if integrator == "implicit" else 1e-11) * turns


@pytest.mark.parametrize("integrator", BOTH)
def test_a_free_cage_slows_as_its_oil_says(tmp_path, integrator):
    """The pockets are so wide that no ball touches them. Petroff's couple at the land of the
    rotating outer ring and the churning couple act on the cage."""
    _, cage = scene(
        tmp_path,
        integrator,
        span=0.01,
        play=3e-3,
        outer="spin speed -20",
        turns=-20,
        words=f"planar yes {LAND} oil 0.04 1.0 0 churning 0.2 870 0.04 34e-3",
    )
    assert cage[:, 7].max() == 0 and np.hypot(cage[:, 2], cage[:, 3]).max() < 1e-9
    petroff = 2 * np.pi * 0.04 * 33.0e-3**3 * 4.0e-3 / 0.15e-3

    def slowing(w):
        churned = 0.5 * 0.2 * 870 * w**2 * 34e-3**5 * 3.87 / np.sqrt(870 * w * 34e-3**2 / 0.04)
        return -(petroff * (w + 20) + churned) / AXIAL

    w, times = cage[0, 4], np.linspace(cage[0, 1], cage[-1, 1], 4001)
    h = times[1] - times[0]
    for _ in times[1:]:
        w += h * slowing(w + h / 2 * slowing(w))
    lost = cage[0, 4] - cage[-1, 4]
    assert lost > 0.5
    assert cage[0, 4] - w == pytest.approx(lost, rel=1e-3)
    assert cage[0, 8] == pytest.approx(
        petroff * (cage[0, 4] + 20) ** 2
        - (slowing(cage[0, 4]) * AXIAL + petroff * (cage[0, 4] + 20)) * cage[0, 4],
        rel=1e-3,
    )


@pytest.mark.parametrize(
    "words", ["planar yes", "wall 1e6 planar yes", f"planar no {LAND} oil 0.04 0.3 4.4e-3"]
)
def test_work_is_stored_or_lost(tmp_path, words):
    outcome, cage = scene(tmp_path, span=0.03, words=f"friction 0.1 {words}")
    found = re.search(r"ENERGY work (\S+) own (\S+) dissipated (\S+) stored (\S+)", outcome.text)
    work, missing, lost, stored = map(float, found.groups())
    assert cage[:, 7].max() > 1
    assert abs(work - lost - stored - missing) < 1e-6 * abs(work)  # precision of the printed digits
    assert abs(missing) < 1e-3 * abs(work)


@pytest.mark.parametrize(
    "words, path",
    [(LAND, 2e-5), ("oil 0.04 0.3 4.4e-3", 1e-6), (f"{LAND} oil 0.04 0.3 4.4e-3", 1e-6)],
    ids=["dry", "sphere", "cylinder"],
)
def test_both_integrators_agree(tmp_path, words, path):
    """The mean speeds agree. Without squeeze films, motion in the pockets is chaotic over long
    times, so the paths (m) are compared to within a few micrometres; with films to within a
    hundredth of half the play."""
    rows = {
        name: scene(tmp_path / name, name, span=0.03, words=f"friction 0.1 planar yes {words}")[1]
        for name in BOTH
    }
    one, other = rows.values()
    assert one[:, 7].max() > (1 if path > 1e-6 else 0.01)
    assert one[-1, 5] - one[0, 5] == pytest.approx(other[-1, 5] - other[0, 5], rel=2e-4)
    for column in (2, 3, 5):
        scale = PITCH if column == 5 else 1.0
        assert np.abs(one[:, column] - other[:, column]).max() * scale < path


CENTRED = "guide outer 33.0e-3 5e-6 2.0e-3 2"


def slip(folder, words=f"friction 0.1 planar yes {CENTRED}", **changes):
    """Return (slip of the cage in %, loaded arc in m). The slip is measured over one turn of the
    cage after one turn of settling."""
    _, cage = scene(folder, span=0.21, samples=100, words=words, **changes)
    speed = np.polyfit(cage[50:, 1], cage[50:, 5], 1)[0]
    rolling = 157.07963267948966 * (1 - BALL / PITCH) / 2
    down = -np.mean([rows[rows[:, 1] == 3][0, 3] for _, rows in tables(folder / "balls.dump")[50:]])
    return 100 * (1 - speed / rolling), 2 * np.arccos(5e-6 / down) * PITCH


def test_play_over_the_loaded_arc_makes_a_cage_slip(tmp_path):
    """Drag slows unloaded balls, which fall back through the play of their pockets. Loaded balls
    drive the cage, which is centred by its land in this test. Without drag there is no slip."""
    plays = [1e-4, 2e-4, 3e-4]
    found, arcs = zip(*(slip(tmp_path / str(j), play=j) for j in plays), strict=True)
    assert np.polyfit(plays, found, 1)[0] / 100 == pytest.approx(1 / np.mean(arcs), rel=0.15)
    none, _ = slip(
        tmp_path / "none",
        f"planar yes {CENTRED}",
        play=2e-4,
        film="friction stribeck 0.12 0.05 smoothed 0.01",
    )
    assert abs(none) < 0.1 * found[1]


def test_a_cage_on_balls_slips_more_than_one_on_its_land(tmp_path):
    """The slip is larger if the cage is guided by balls, because its centre can then move within
    the play."""
    centred, _ = slip(tmp_path / "land")
    free, _ = slip(tmp_path / "balls", "friction 0.1 planar yes")
    assert 1.2 * centred < free < 2.5 * centred


@pytest.mark.parametrize("integrator", BOTH)
@pytest.mark.parametrize("guide", ["guide balls", LAND])
def test_ranks_hosts_and_restarts_keep_bits(tmp_path, integrator, guide):
    fast = VERLET if integrator == "verlet" else {}
    span = dict(steps=3000, sample=150) if fast else dict(steps=200, sample=10)
    half = span["steps"] // 2
    words = f"friction 0.1 planar no {guide} oil 0.04 0.3 4.4e-3 churning 0.1 870 0.04 34e-3"
    common = fast | span | dict(words=words, play=2e-5)
    states = {}
    for ranks in (1, 2, 4):
        folder = tmp_path / str(ranks)
        succeed(DECK, ranks=ranks, out=folder, keep=half, **common)
        states[ranks] = frames(folder / "balls.dump"), (folder / "cage.txt").read_text()
        assert states[ranks][0] == states[1][0], f"bodies on {ranks} ranks"
        assert states[ranks][1] == states[1][1], f"cage on {ranks} ranks"
    assert np.loadtxt(folder / "cage.txt")[:, 7].max() > 0
    other = tmp_path / "lammps"
    succeed(DECK, host="lammps", out=other, **common)
    assert frames(other / "balls.dump") == states[1][0]
    again = tmp_path / "again"
    succeed(
        DECK,
        ranks=2,
        out=again,
        begin="resume",
        **{"from": tmp_path / f"1/restart.{half}"},
        **common,
    )
    late = frames(again / "balls.dump")
    assert late[span["steps"]] == states[1][0][span["steps"]]


@pytest.mark.parametrize("integrator", BOTH)
@pytest.mark.parametrize("fall", ["1 0 0", "0 -1 0", "0 0 1"])
def test_a_cage_bears_gravity(tmp_path, integrator, fall):
    """At 30 rad/s, the weight of the balls and the cage is several times their centrifugal
    force."""
    span = dict(span=0.05) | ({"dt": 4e-7} if integrator == "verlet" else {})
    _, cage = scene(
        tmp_path,
        integrator,
        speed=30,
        inner="x free y free spin speed 30 force 0 -200 0 ramp 2.0e-3",
        words="friction 0.1 shape sphere planar no",
        weight=9.81,
        fall=fall,
        **span,
    )
    assert np.hypot(cage[:, 2], cage[:, 3]).max() < 2e-4
    assert 0.02 < cage[:, 7].max() < 50


@pytest.mark.parametrize("fall", ["1 0 0", "0 1 0", "-1 0 0", "0 -1 0"])
@pytest.mark.parametrize("speed", [1, 100, 1000])
def test_no_ball_leaves_its_pocket_under_gravity(tmp_path, speed, fall):
    """A run stops if a ball moves beyond a wall of its pocket by a tenth of the ball radius. This
    run covers two ball passes at 1 rad/s; the test above covers a turn of the cage. The cage hangs
    on two balls that are at most one spacing apart. These balls can leave the pitch circle by the
    clearance, and the walls deform."""
    passes = 2 if speed == 1 else 9
    _, cage = scene(
        tmp_path,
        speed=speed,
        span=passes * 2 * np.pi / 9 / (0.396 * speed),
        dt=2e-3 if speed == 1 else 1.5e-2 / speed,
        inner=f"x free y free spin speed {speed} force 0 -1000 0 ramp 2.0e-3",
        words="friction 0.1 wall 1e6 planar yes",
        weight=9.81,
        fall=fall,
    )
    largest = cage[:, 6].max()
    assert 0.1 < largest < 200
    reach = (1e-4 + 5e-6 + largest / 1e6) / np.cos(np.pi / 9)
    assert np.hypot(cage[:, 2], cage[:, 3]).max() < reach
    turned = np.ptp(cage[:, 5]) / np.ptp(cage[:, 1])
    assert turned == pytest.approx(speed * (1 - BALL / PITCH) / 2, rel=2e-2)


@pytest.mark.parametrize(
    "changes",
    [
        *(
            dict(
                outer=f"x free y free support x {0.3 * w**2} {0.03 * w} "
                f"support y {0.3 * w**2} {0.03 * w}",
                inner="x free y free spin speed 157 force 0 -30 0 ramp 2.0e-3",
                weight=9.81,
                fall="0 -1 0",
            )
            for w in 2 * np.pi * np.array([20, 100, 300])
        ),
        dict(inner="x free y free spin speed 157 force 0 -20000 0 ramp 1.0e-3"),
    ],
    ids=["20 Hz", "100 Hz", "300 Hz", "shock of 20 kN"],
)
def test_no_ball_leaves_its_pocket_on_soft_housings_or_in_a_shock(tmp_path, changes):
    words = "friction 0.1 wall 1e6 planar yes"
    _, cage = scene(tmp_path, span=0.08, dt=1e-4, words=words, **changes)
    assert 0.1 < cage[:, 6].max() < 200
    turned = np.ptp(cage[:, 5]) / np.ptp(cage[:, 1])
    assert turned == pytest.approx(157 * (1 - BALL / PITCH) / 2, rel=2e-2)


@pytest.mark.parametrize(
    "changes, message",
    [
        (dict(pockets=8), "balls 5 and 6 are both in pocket 5 of cage 12"),
        (dict(play=9e-3), "has only 0.02072.* m for each of 9"),
        (
            dict(words="guide outer 29e-3 1e-4 2e-3 2"),
            "on the wrong side: 'guide outer' with radius 0.029",
        ),
        (
            dict(words="guide inner 31e-3 1e-4 2e-3 2"),
            "on the wrong side: 'guide inner' with radius 0.031",
        ),
        (dict(words="oil 0.04 0.3 4e-3", play=0), "is sheared in the play, which is 0"),
        (dict(words="wall -1"), "stiffness of the walls of a pocket .*is -1, must be > 0"),
        (dict(words="friction 2"), "friction of ball and cage is 2, must be from 0 to 1"),
        (dict(words="colour red"), "unknown .*colour.*pockets, play, across"),
        (dict(coeff="print none"), "no pair_coeff 1 2 cage before this command"),
        (dict(cage_phase=0.4), "m beyond the wall of pocket . of cage 12"),
    ],
)
def test_bad_data_are_refused(tmp_path, changes, message):
    outcome = liggghts(DECK, out=tmp_path, **changes)
    refused(outcome, message)
