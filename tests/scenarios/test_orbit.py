# SPDX-License-Identifier: GPL-2.0-or-later
"""`settle orbit` of run_bearing finds the state in which each ball pass repeats the previous
one."""

import numpy as np
import pytest
import raceway
from host import ROOT, deck_file, succeed
from raceway import beam, beam_motion, bending_file, shaft_bending
from recorded_runs import differ

from scenarios.test_run_bearing import DECK as run_deck
from scenarios.test_run_bearing import IMPLICIT, TURNS, numbers, stop

DECK = "inputs/in.6208"
FULL = {"models": "full", "passes": 1}
PRELOAD = {**FULL, "clearance": "-20e-6", "load": 2000, "rpm": 1500}
# unloaded balls change their places in the pockets
LOAD_ZONE = {**FULL, "clearance": 0, "load": 5000, "rpm": 477.5}
# under a light thrust, gyroscopic moments turn the spin axes over more than a hundred ball passes
THRUST = {**FULL, "bearing": "7205B", "axial": 300, "load": "1e-3", "rpm": 8000}
# other bearings under thrust, whose multipliers are larger
SLOWER = {**FULL, "bearing": 7208, "axial": 500, "load": "1e-3", "rpm": 6000}
FASTER = {**FULL, "bearing": "7206B", "axial": 500, "load": "1e-3", "rpm": 8000}
FIGURES = ("friction_torque_N_m", "cage_speed_rad_s", "h_min_m", "q_max_N", "capacitance_F")


def evaluations(folder):
    """Return the total number of force evaluations, which measures the cost of a run on any
    machine."""
    cost = raceway.open(folder).settings
    return cost["settling_evaluations"] + cost["evaluations"]


@pytest.mark.parametrize(
    "scene, settle, share",
    [(PRELOAD, 30, 0.12), (LOAD_ZONE, 100, 0.1), (THRUST, 200, 0.06), (SLOWER, 400, 0.05)],
    ids=["preload", "load zone", "7205B", "7208"],
)
def test_figures_are_those_of_a_settled_run(scene, settle, share, tmp_path):
    for how in ("orbit", settle):
        succeed(DECK, out=tmp_path / str(how), settle=how, **scene)
    orbit, settled = (raceway.open(tmp_path / str(how)).summary() for how in ("orbit", settle))
    assert raceway.open(tmp_path / "orbit").settings["orbit"] == "found"
    for name in FIGURES:
        assert orbit[name] == pytest.approx(settled[name], rel=1e-3), name
    assert evaluations(tmp_path / "orbit") < share * evaluations(tmp_path / str(settle))


SHAFT = "tests/scenarios/in.shaft_orbit"
SHARED_THRUST = {"bearing": 7208, "clearance": 0, "load": 1e-3, "axial": 1000, "rpm": 6000}
FREE = "x free y free z free rx free ry free"


@pytest.fixture(scope="module")
def flexible(tmp_path_factory):
    """Write the file of a flexible shaft, and return the words that select it."""
    path = tmp_path_factory.mktemp("shaft") / "shaft.modes"
    z, pieces = beam.divided([beam.Section(0.36, 0.04)], np.linspace(0.0, 0.36, 13))
    nodes = [1, 6, 11]  # at the bearings and in the middle
    whole = beam_motion.matrices(z, pieces)
    bending_file.write(path, shaft_bending.bending(z, whole, nodes, 4, nodes, 0.01))
    return f"flexible {path}"


@pytest.mark.parametrize(
    "scene",
    [{}, {"place": 0.15}, {**SHARED_THRUST, "freedoms": FREE}, {"body": "flexible"}],
    ids=["load", "load off the middle", "thrust", "flexible"],
)
def test_figures_of_two_bearings_on_a_shaft(scene, flexible, tmp_path):
    if "body" in scene:
        scene = {"body": flexible}
    for how in ("orbit", 100):
        succeed(SHAFT, out=tmp_path / str(how), settle=how, **scene)
    runs = [raceway.open(tmp_path / str(how)) for how in ("orbit", 100)]
    assert runs[0].settings["orbit"] == "found"
    for bearing in (1, 2):
        orbit, settled = (run.select(bearing).summary() for run in runs)
        for name in FIGURES[:4]:
            assert orbit[name] == pytest.approx(settled[name], rel=1e-3), (bearing, name)
    assert evaluations(tmp_path / "orbit") < 0.1 * evaluations(tmp_path / "100")


def test_multiplier_of_bearings_that_share_a_thrust(tmp_path):
    """Two bearings on a shaft that share a thrust have the multiplier of one bearing under half of
    it."""
    succeed(SHAFT, out=tmp_path / "two", **SHARED_THRUST, freedoms=FREE)
    succeed(DECK, out=tmp_path / "one", settle="orbit", **SLOWER)
    two, one = (raceway.open(tmp_path / name).settings for name in ("two", "one"))
    assert one["orbit_multiplier"] > 0.5
    assert two["orbit_multiplier"] == pytest.approx(one["orbit_multiplier"], rel=0.02)


PLAIN = {**PRELOAD, "models": "paper"}


@pytest.mark.parametrize(
    "deck, words, why",
    [
        (SHAFT, {"right": 6306}, "the rows of balls differ in number of balls or in speed"),
        (SHAFT, {"words": "unbalance 0.1 2e-5 0"}, "change or turn with the ring"),
        (SHAFT, {"place": 0.1}, "the speeds of the rows of balls differ by"),
        (DECK, {**PLAIN, "unbalance": 1e-4}, "change or turn with the ring"),
        (
            DECK,
            {**PLAIN, "flaw_outer": "notch -1.5708 1.0e-3 full 1.0e-5 2.0e-4"},
            "makes balls or positions differ",
        ),
        (DECK, {**PLAIN, "integrator": "verlet", "rpm": 5000}, "velocity Verlet"),
        (DECK, {**LOAD_ZONE, "cage": "chain"}, "repeats the previous one"),
        (DECK, {**LOAD_ZONE, "load": 1000, "rpm": 1500, "cage": "no"}, "repeats the previous one"),
    ],
    ids=str,
)
def test_scenes_without_an_orbit_settle_until_ball_passes_agree(deck, words, why, tmp_path):
    done = succeed(deck, out=tmp_path, settle="orbit", **words)
    assert "No orbit: " in done.text and why in done.text
    found = raceway.open(tmp_path).settings
    assert found["orbit"] == "none" and found["settled_passes"] >= 2
    assert found["rest_torque"] <= 1e-2


# a ball at rest on an inner ring that has no outer ring
LONELY = """create_atoms 5 single 0.0303 0 0.13 units box
create_atoms 6 single 0 0 0.13 units box
set type 5 diameter 12.6e-3 density 7800
set type 6 diameter 2e-4 density 1000
"""
LONELY_RING = "pair_coeff 5 6 inner 24.0e-3 6.552e-3 lubricant 0.04 22e-9 roughness 1e-7 0\n"


def test_a_ball_without_an_outer_ring_has_no_orbit(tmp_path):
    text = (ROOT / DECK).read_text().replace("create_box 4", "create_box 6")
    text = text.replace("-${b_box} ${b_box} units box", "-${b_box} 0.2 units box")
    text = text.replace("pair_coeff * * b\n", "pair_coeff * * b\n" + LONELY_RING)
    deck = deck_file(tmp_path, text.replace("fix flaw_inner", LONELY + "fix flaw_inner", 1))
    scene = {**PRELOAD, "models": "none", "settle": "orbit"}
    done = succeed(deck, out=tmp_path / "run", **scene)
    assert "No orbit: not all balls are between an inner and an outer ring" in done.text


# the same scene with dry contacts; two of its five ball passes begin with chosen speeds
SHORT = {**TURNS, "settle": "orbit", "more": "limit 5"}


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    out = tmp_path_factory.mktemp("orbit") / "whole"
    done = succeed(run_deck, out=out, **SHORT)
    assert done.text.count("the next are chosen") >= 1
    return out


def test_ranks(whole, tmp_path):
    succeed(run_deck, out=tmp_path, ranks=2, **SHORT)
    assert differ(whole, tmp_path) == []


@pytest.mark.parametrize("at", [2, 3, 4])
def test_stopped_on_the_way(at, whole, tmp_path):
    """The results of a run that is stopped and continued are bitwise identical, even if the chosen
    speeds are passed on through a restart file."""
    stop(tmp_path, SHORT, at)
    succeed(run_deck, out=tmp_path, resume="yes", **SHORT)
    assert differ(whole, tmp_path) == []
    assert numbers(whole) == numbers(tmp_path)


def test_stopped_among_coarse_ball_passes(tmp_path):
    """Balls that leave the load zone are followed with coarse steps."""
    # the measurement is long enough for the signal to arrive
    scene = {**IMPLICIT, "settle": "orbit", "more": "limit 14", "passes": 20}
    succeed(run_deck, out=tmp_path / "whole", **scene)
    stop(tmp_path / "parts", scene, 2)
    succeed(run_deck, out=tmp_path / "parts", resume="yes", **scene)
    assert differ(tmp_path / "whole", tmp_path / "parts") == []
    assert numbers(tmp_path / "whole") == numbers(tmp_path / "parts")


def test_the_last_ball_pass_has_the_steps_of_the_deck(tmp_path):
    done = succeed(run_deck, out=tmp_path, **IMPLICIT, settle="orbit", more="limit 3")
    before, last = (line for line in done.text.splitlines() if line.startswith("Ball pass"))
    assert "coarse" in before and "coarse" not in last


def test_shaft_on_ranks(tmp_path):
    for ranks in (1, 2):
        succeed(SHAFT, out=tmp_path / str(ranks), ranks=ranks, **SHARED_THRUST, freedoms=FREE)
    assert differ(tmp_path / "1", tmp_path / "2") == []


@pytest.mark.parametrize("host", ["lammps", "wheel"])
def test_hosts(host, tmp_path):
    for folder, program in (("one", "liggghts"), ("other", host)):
        out = tmp_path / folder
        succeed(DECK, out=out, host=program, settle="orbit", samples=20, **THRUST)
    assert differ(tmp_path / "one", tmp_path / "other") == []


def test_a_fast_decay_is_not_called_unstable(tmp_path):
    """The last values of this search differ by little more than their errors."""
    succeed(DECK, out=tmp_path, settle="orbit", **{**SLOWER, "axial": 100, "rpm": 3000})
    assert raceway.open(tmp_path).settings["orbit_stability"].startswith("stable")


def speeds(balls):
    """Return the orbital speed and the radial, tangential and axial spin of each ball, relative to
    the largest orbital speed and the largest component of a spin."""
    x, y, vx, vy = (balls[name].to_numpy() for name in ("x", "y", "vx", "vy"))
    wx, wy, wz = (balls[f"omega{axis}"].to_numpy() for axis in "xyz")
    r = np.hypot(x, y)
    orbit = (x * vy - y * vx) / r**2
    spin = np.array([(x * wx + y * wy) / r, (x * wy - y * wx) / r, wz])
    return np.array([orbit / np.abs(orbit).max(), *(spin / np.abs(spin).max())])


@pytest.mark.parametrize(
    "scene", [PRELOAD, THRUST, SLOWER, FASTER], ids=["preload", "7205B", "7208", "7206B"]
)
def test_ball_passes_repeat_within_the_error_of_a_multiplier(scene, tmp_path):
    """When nothing is left of a disturbance, the speeds at the ends of ball passes repeat within
    1e-6, which the search assumes as the error of a value of its map."""
    succeed(DECK, out=tmp_path, settle="orbit", samples=20, **{**scene, "passes": 40})
    run = raceway.open(tmp_path)
    ends = speeds(run.balls)[:, ::20]
    order = np.argsort(np.arctan2(run.balls["y"][0], run.balls["x"][0]).to_numpy())
    # after each ball pass, a ball is where its neighbour was
    later = np.array([np.roll(ends[:, k][:, order], k, axis=1) for k in range(30, 41)])
    changes = np.diff(later, axis=0)
    assert np.sqrt((changes**2).sum(axis=1).mean(axis=1)).max() < 1e-6


LATER = """
variable slow_x atom 0.95*vx
variable slow_y atom 0.95*vy
velocity balls set v_slow_x v_slow_y NULL units box
variable later string ${out}/later
fix later all bearing/record 20 ${later}
run 600
"""


def decays(folder, largest):
    """Return by which factors the changes of the mean speeds of the balls decrease from one ball
    pass to the next, while the relative changes of their spins are between `largest` and 2e-5;
    later changes are affected by the tolerance of the steps."""
    orbit, radial, _, axial = speeds(raceway.open(folder).balls).mean(axis=2)
    means = {"cage": orbit, "radial spin": radial, "axial spin": axial}
    steps = {name: np.diff(mean) / np.abs(mean[-1]) for name, mean in means.items()}
    spins = np.abs([steps["radial spin"], steps["axial spin"]])
    small = (spins.max(axis=0) < largest) & (spins.min(axis=0) > 2e-5)
    return {name: (one[1:] / one[:-1])[small[1:] & small[:-1]] for name, one in steps.items()}


@pytest.mark.parametrize("scene", [THRUST, SLOWER, FASTER], ids=["7205B", "7208", "7206B"])
def test_multiplier_is_the_decay_of_a_disturbed_run(scene, tmp_path):
    """The orbital speeds of all balls are reduced by 5 % on the orbit. The cage speed and the spins
    then return to the orbit as its largest multiplier states."""
    deck = tmp_path / "in.disturbed"
    deck.write_text((ROOT / DECK).read_text() + LATER)
    done = succeed(deck, out=tmp_path / "run", settle="orbit", **scene)
    assert "stable: a ball pass leaves 0." in done.text
    found = raceway.open(tmp_path / "run").summary()
    assert found["orbit_stability"] == "stable"
    assert found["orbit_multiplier_error"] < 0.02 * found["orbit_multiplier"]
    for speed, factors in decays(tmp_path / "run" / "later", 4e-4).items():
        assert len(factors) >= 4, speed
        assert factors == pytest.approx(found["orbit_multiplier"], rel=0.02), speed
