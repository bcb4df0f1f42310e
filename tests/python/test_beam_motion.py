# SPDX-License-Identifier: GPL-2.0-or-later
"""Natural frequencies of shafts are compared with ROSS 2.3.0 and with closed-form solutions for
beams and gyroscopes."""

import numpy as np
import pytest
from raceway import beam, beam_motion, shaft, shaft_motion
from raceway.shaft_file import read
from raceway.theory.beam import Disc, Section, Steel

STEEL = Steel(211e9, 211e9 / (2 * 81.2e9) - 1, 7810.0)  # values used in ROSS
EXACT = np.array([241.635, 265.284, 267.722, 1059.740, 1078.910, 2538.41])  # Hz
SPRINGS = (2e8, 3e8, 1e7, 0.0, 0.0)  # N/m and N m/rad, springs at both ends


@pytest.fixture(scope="module")
def rotor():
    """Return a shaft of eight elements, each 50 mm long and 40 mm in diameter, with a disc of 0.2 m
    diameter in the middle."""
    z, pieces = beam.divided([Section(0.4, 0.04)], np.linspace(0.0, 0.4, 9))
    outer, inner, width = 0.2, 0.04, 0.02
    mass = STEEL.density * np.pi / 4 * (outer**2 - inner**2) * width
    axial = mass * (outer**2 + inner**2) / 8
    across = mass * (3 * (outer**2 + inner**2) / 4 + width**2) / 12
    return z, beam_motion.matrices(z, pieces, [Disc(0.2, mass, axial, across)], STEEL)


def on_springs(count, nodes):
    """Return the stiffness matrix (count, count) of springs that act on the coordinates 5 k to 5 k
    + 4 of each node k in `nodes`."""
    whole = np.zeros((count, count))
    for node in nodes:
        at = 5 * node + np.arange(5)
        whole[at, at] = SPRINGS
    return whole


def hertz(whole, nodes, spin=0.0):
    springs = on_springs(len(whole.mass), nodes)
    return beam_motion.frequencies(whole, springs, spin) / (2 * np.pi)


def test_as_ross(rotor):
    assert hertz(rotor[1], (0, 8))[:6] == pytest.approx(EXACT, rel=2e-6)


@pytest.mark.parametrize(
    "modes, first, second, third",
    [(0, 0.2, 0.6, 0.6), (4, 3e-5, 3e-3, 0.2), (12, 1e-6, 1e-5, 6e-4)],
)
@pytest.mark.parametrize("spin", [0.0, 500.0])
def test_reduced(rotor, modes, first, second, third, spin):
    """The frequencies of the reduced matrices converge from above as the number of modes grows."""
    whole = rotor[1]
    few = beam_motion.reduced(whole, [0, 8], modes)
    assert few.mass.shape == (10 + modes,) * 2 and len(few.frequencies) == modes
    want, found = hertz(whole, (0, 8), spin), hertz(few, (0, 1), spin)
    lateral = [one for one in range(6) if abs(want[one] / EXACT[0] - 1) > 0.01]
    error = found[lateral] / want[lateral] - 1
    bounds = np.array([first, first, second, second, third])[: len(lateral)]
    assert np.all(error > -1e-8) and np.all(np.abs(error) < bounds)


def test_reduced_keeps_the_rigid_body(rotor):
    z, whole = rotor
    few = beam_motion.reduced(whole, [0, 8], 6)
    exact, found = beam_motion.rigid(z, whole), np.zeros(16)
    found[[0, 5]] = 1.0  # both ends move along x, so the result is the total mass
    assert few.shapes @ found == pytest.approx(np.tile([1, 0, 0, 0, 0], 9), abs=1e-9)
    assert found @ few.mass @ found == pytest.approx(exact.mass, rel=1e-9)
    assert np.abs(few.stiffness @ found).max() < 1e-9 * few.stiffness.max()
    assert np.abs(few.shapes.reshape(9, 5, 16)[:, :3, 10:]).max((0, 1)) == pytest.approx(1.0)


def test_static_deflection_is_exact(rotor):
    """Loads at retained nodes cause the same displacements for any number of modes."""
    whole = rotor[1]
    load = np.zeros(45)
    load[20], load[21] = 500.0, -200.0
    exact = np.linalg.solve(whole.stiffness + on_springs(45, (0, 8)), load)
    few = beam_motion.reduced(whole, [0, 4, 8], 2)
    small = np.linalg.solve(few.stiffness + on_springs(17, (0, 2)), few.shapes.T @ load)
    assert few.shapes @ small == pytest.approx(exact, rel=1e-9, abs=1e-15)


def test_cantilever():
    """The first natural frequency of a thin clamped beam is 1.8751^2 sqrt(EI/(rho A L^4)), and the
    next two follow from the known series."""
    z, pieces = beam.divided([Section(1.0, 0.01)], np.linspace(0, 1, 21))
    whole = beam_motion.matrices(z, pieces)
    springs = np.zeros_like(whole.stiffness)
    springs[np.arange(5), np.arange(5)] = 1e13
    found = beam_motion.frequencies(whole, springs)[:6:2]
    one = np.sqrt(beam.STEEL.young / beam.STEEL.density) * 0.01 / 4
    assert found == pytest.approx(np.array([1.87510, 4.69409, 7.85476]) ** 2 * one, rel=1e-3)


def test_free_spinning_disc():
    """A free rigid body nutates at its spin speed multiplied by I_a/I_t."""
    z, pieces = beam.divided([Section(0.1, 0.02)], [])
    whole = beam_motion.matrices(z, pieces, [Disc(0.0, 5.0, 0.3, 0.2)])
    body = beam_motion.rigid(z, whole)
    found = beam_motion.frequencies(whole, np.zeros_like(whole.stiffness), 50.0)
    slow = found[(found > 1.0) & (found < 1000)]
    assert slow == pytest.approx(50 * body.axial / body.transverse, rel=1e-4)
    with pytest.raises(ValueError, match="9 modes: the shaft has 5 in addition to its bearings"):
        beam_motion.reduced(whole, [0], 9)


def test_of_a_file(tmp_path):
    """The discs are read from the file. The shaft is so stiff that it moves as a rigid body."""
    file = tmp_path / "rotor"
    file.write_text(
        "rpm: 3000\nsteel: {young: 1.0e+12}\nsections: [{length: 0.2, diameter: 0.1}]\n"
        "bearings: [{name: 6208, at: 0, clearance: -10.0e-6}, {name: 6208, at: 0.2}]\n"
        "loads: [{at: 0.1, force: [800, 300, 0]}]\n"
        "discs: [{at: 0.1, mass: 200, axial: 4, transverse: 3}]\n"
    )
    case = read(file)
    rest = shaft.rest(case.shaft, case.seats, case.loads)
    body = shaft_motion.rigid(case.shaft, rest)
    assert body.mass == pytest.approx(200 + 7800 * np.pi / 4 * 0.01 * 0.2, rel=1e-9)
    springs, inertia = np.zeros((4, 4)), np.diag([body.mass] * 2 + [body.transverse] * 2)
    for one in rest.bearings:
        at = one.seat.at - body.centre
        turn = np.array([[1, 0, 0, at], [0, 1, -at, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        springs += turn.T @ one.stiffness[np.ix_([0, 1, 3, 4], [0, 1, 3, 4])] @ turn
    still = np.sort(np.sqrt(np.linalg.eigvals(np.linalg.solve(inertia, springs)).real))
    found = shaft_motion.frequencies(case.shaft, rest, 0.0)
    lateral = [min(found, key=lambda one: abs(one - want)) for want in still]
    assert lateral == pytest.approx(still, rel=0.02)
    turning = shaft_motion.frequencies(case.shaft, rest, 314.0)
    assert turning[2] != pytest.approx(found[2], rel=1e-3)
