# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft flexible: a flexible shaft on two 6208s agrees with a beam in which all nodes
are retained, and a stiff one with a rigid shaft; energy is balanced, and accelerations are
derivatives of velocities."""

import numpy as np
import pytest
import raceway
from bearings import B6208
from flexible_shaft import (
    ACROSS,
    HELD,
    LOADED,
    PRELOAD,
    SECTIONS,
    beam_of,
    modes_file,
    node,
    reduced,
)
from host import succeed
from raceway import beam, beam_motion, bending_file, shaft, static
from raceway.theory.beam import Steel
from shaft_runs import ENERGY, TILTING, WITHIN, frequencies_of, rings_follow, swing


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return modes_file(tmp_path_factory.mktemp("file"))


@pytest.fixture(scope="module")
def damped(tmp_path_factory):
    return modes_file(tmp_path_factory.mktemp("damped"), damping=0.02)


def on_bearings(z, whole, stiffness):
    """Return the stiffness matrix (5 N, 5 N) of springs that represent both bearings."""
    springs = np.zeros_like(whole.stiffness)
    for place in (0.0, 0.2):
        at = 5 * node(z, place) + np.arange(5)
        springs[np.ix_(at, at)] = stiffness
    return springs


def stiffness_of(clearance):
    """Return the stiffness (5, 5) of a bearing under preload alone, for a shaft that does not slide
    in the bearing."""
    held = dict.fromkeys(static.FREEDOMS, 0.0)
    # if a ring tilts by t, the centre of its groove moves inwards by R t^2/2, against the preload
    state = static.equilibrium(B6208, held=held, clearance=clearance, finite_shift=True)
    stiffness = state.stiffness.copy()
    stiffness[2, 2] = 1e12
    return stiffness


def test_bending_pairs(tmp_path, file):
    """In free vibration on preloaded bearings, the first pair of frequencies agrees within 1e-3
    with a beam on springs that have the stiffness of the bearings, and the second pair within 5e-3.
    The spin splits both pairs."""
    spin, clearance = 2000.0, 2 * PRELOAD
    data, _ = swing(
        tmp_path,
        clearance=clearance,
        freedoms=f"{TILTING} {spin}",
        words=f"flexible {file} load 0.12 3 1 0 load 0.3 1 1 0",
        control="tolerance 1e-11 largest 1e-5",
        step=2e-4,
        steps=80,
    )
    z, whole = beam_of()
    springs = on_bearings(z, whole, stiffness_of(clearance))
    exact = beam_motion.frequencies(whole, springs, spin) / (2 * np.pi)
    signals = [data["x"] + 1j * data["y"], 0.1 * (data["ry"] - 1j * data["rx"])]
    signals += [data[f"x{ring}"] + 1j * data[f"y{ring}"] for ring in (1, 2)]
    found = frequencies_of(np.array(signals), data["time"][1] - data["time"][0], 12)
    # the disc whirls backward first, then forward
    for k, (sign, error) in enumerate([(-1, 1e-3), (1, 1e-3), (-1, 5e-3), (1, 5e-3)]):
        assert np.abs(sign * found / exact[k] - 1).min() < error
    assert exact[1] / exact[0] > 1.05 and exact[3] / exact[2] > 1.5  # they differ enough


STEADY = [shaft.Load(0.12, (0.0, -800.0, 0.0)), shaft.Load(0.3, (100.0, -200.0, 0.0))]


@pytest.fixture(scope="module")
def resting(tmp_path_factory, damped):
    """Return the shaft in equilibrium under loads at the disc and at the overhung end, found by
    backward Euler with long steps."""
    loads = " ".join(f"load {one.at} {one.force[0]} {one.force[1]} 0" for one in STEADY)
    data, _ = swing(
        tmp_path_factory.mktemp("resting"),
        clearance=PRELOAD,
        words=f"flexible {damped} {loads}",
        control="order 1 tolerance 1e-6",
        cage=1,  # without cage and friction the balls would leave the load zone
        law="friction constant 0.1",
        freedoms=f"{TILTING} 0 z free",
        step=5e-4,
        steps=200,
        every=200,
    )
    return {key: value[-1] for key, value in data.items()}


def test_steady_loads(resting):
    """The positions of the bearings and the forces on them agree with those of a beam on bearings
    that statics computes."""
    seats = [shaft.Seat(at, B6208, clearance=PRELOAD, phase=-np.pi / 2) for at in (0.0, 0.2)]
    rest = shaft.rest(shaft.Shaft(SECTIONS), seats, STEADY)
    for n, one in enumerate(rest.bearings, 1):
        size = np.hypot(*one.place[:2])
        assert resting[f"x{n}"] == pytest.approx(one.place[0], rel=0, abs=1e-3 * size)
        assert resting[f"y{n}"] == pytest.approx(one.place[1], rel=0, abs=1e-3 * size)
        assert resting[f"f{n}x"] == pytest.approx(-one.load[0], rel=1e-3)
        assert resting[f"f{n}y"] == pytest.approx(-one.load[1], rel=1e-3)


def test_deflection_is_that_of_the_beam(resting):
    """The tilts of both rings follow from their displacements, moments and loads, as for a beam."""
    z, whole = beam_of()
    force, held = np.zeros(5 * len(z)), np.zeros(5 * len(z))
    place = np.zeros_like(force)
    for one in STEADY:
        at = 5 * node(z, one.at)
        force[at : at + 2] += one.force[:2]
    for ring, at in ((1, 5 * node(z, 0.0)), (2, 5 * node(z, 0.2))):
        force[at + 3 : at + 5] += resting[f"m{ring}x"], resting[f"m{ring}y"]
        place[at : at + 2] = resting[f"x{ring}"], resting[f"y{ring}"]
        held[at : at + 2] = 1e14
    held[2] = 1e14  # the shaft is stiff in the axial direction
    found = np.linalg.solve(whole.stiffness + np.diag(held), force + held * place)
    for ring, at in ((1, 5 * node(z, 0.0)), (2, 5 * node(z, 0.2))):
        tilts = resting[f"rx{ring}"], resting[f"ry{ring}"]
        assert tilts == pytest.approx(found[at + 3 : at + 5], rel=1e-4)
    assert abs(resting["rx1"] - resting["rx2"]) > 1e-4  # the shaft bends


def stiff_and_rigid(folder):
    """Return the keywords of a flexible shaft that is 1e7 times as stiff as steel, and of the rigid
    shaft."""
    body = beam_motion.rigid(*beam_of())
    bending_file.write(folder / "stiff.modes", reduced(Steel(young=1e7 * beam.STEEL.young)))
    return {
        "flexible": f"flexible {folder / 'stiff.modes'}",
        "rigid": f"mass {body.mass!r} inertia {body.axial!r} {body.transverse!r}"
        f" centre {body.centre!r}",
    }


def test_stiff_is_rigid_with_cages(tmp_path):
    """Both shafts take the same steps, also where further iterations evaluate only the cages, and
    their loads differ by at most ten times the ratio of the stiffness of steel to theirs."""
    scene, models = "tests/scenarios/in.shaft_orbit", "paper"
    words = dict(left_at=0, right_at=0.2, place=0.12, settle=1, clearance=1e-5, models=models)
    loads, evaluations = [], []
    for kind, body in stiff_and_rigid(tmp_path).items():
        out = tmp_path / kind
        control = "tolerance 1e-8 control estimate"
        succeed(scene, out=out, body=body, control=control, **words)
        run = raceway.open(out)
        loads.append(np.nan_to_num([run.select(number).contacts.Q for number in (1, 2)]))
        evaluations.append(run.settings["evaluations"])
    assert evaluations[0] == evaluations[1]
    assert np.abs(loads[0] - loads[1]).max() < 1e-6 * loads[1].max()


def test_stiff_is_rigid(tmp_path):
    words = stiff_and_rigid(tmp_path)
    ends = [
        swing(
            tmp_path / kind,
            clearance=1e-5,
            speed=200,
            law="friction constant 0.05",
            freedoms=f"{TILTING} 200 z free",
            words=f"{text} {LOADED}",
            control="tolerance 1e-10",
            steps=60,
            every=2,
        )[0]
        for kind, text in words.items()
    ]
    for key in ("x", "y", "z", "rx", "ry", "f1y", "f2y", "m1x", "a2y", "x1", "y2"):
        one, other = ends[0][key], ends[1][key]
        assert np.abs(one - other).max() < 1e-4 * np.abs(other).max(), key


def test_energy(tmp_path, damped):
    """The work of the loads equals the dissipated heat plus the energy of motion, springs, supports
    and bending."""
    _, energy = swing(
        tmp_path,
        **ENERGY,
        freedoms=f"{TILTING} 200 z free",
        words=f"flexible {damped} {LOADED} {HELD}",
    )
    assert energy["work"] > 1e-3 and energy["dissipated"] > 0.0
    assert abs(energy["lost"]) < 1e-3 * energy["work"]


def test_within_a_step(tmp_path, damped):
    """In samples within long steps, the accelerations of the rings are the derivatives of their
    velocities."""
    swing(tmp_path, **WITHIN, words=f"flexible {damped} {LOADED} {ACROSS}", clearance=PRELOAD)
    rings_follow(tmp_path)
