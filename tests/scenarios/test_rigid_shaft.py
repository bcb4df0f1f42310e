# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft: the motion of a rigid body on two 6208s agrees with closed-form solutions and
with statics, and its momentum and energy are balanced.

The shaft extends along z, with bearings at 0 and 0.2 m. The columns of a run's `data` describe the
shaft (x, rx ...) and its rings (x1, f2y ...).
"""

import numpy as np
import pytest
import yaml
from bearings import B6208
from host import refuses, succeed
from raceway import shaft, static
from raceway.theory.beam import Section, Steel
from raceway.theory.bearing import DoubleRow
from shaft_runs import (
    DECK,
    ENERGY,
    TILTING,
    WITHIN,
    frequencies_of,
    numbers_of,
    rings_follow,
    small,
    small_deck,
    swing,
)

MASS, AXIAL, ACROSS = 4.0, 2.0e-3, 2.0e-2  # kg, kg m^2
MOVERS = {"implicit": {"step": 5e-5}, "verlet": {"mover": "verlet", "step": 1e-6}}
AIR = 1.0e-3  # m, a clearance for which no ring touches its balls


# ---- equilibrium
# Without a cage and friction, the balls would leave the load zone.
CALM = "support y 1.0 2000 support rx 1.0 20"  # dampers; their springs are too soft to carry load


@pytest.fixture(scope="module")
def resting(tmp_path_factory):
    """Return the shaft under a load of 3 kN at 0.12 m, damped until it comes to rest."""
    folder = tmp_path_factory.mktemp("resting")
    words = f"mass 4 inertia 2e-3 2e-2 centre 0.1 load 0.12 0 -3000 0 ramp 5e-3 {CALM}"
    data, _ = swing(
        folder, cage=1, law="friction constant 0.1", words=words, steps=1000, every=1000
    )
    return {key: value[-1] for key, value in data.items()}


def test_lever_rule(resting):
    """The lever rule determines how the bearings share a load of 3 kN at 0.12 m along a span of 0.2
    m; the moments of the bearings have little effect on the distribution."""
    assert resting["f1y"] == pytest.approx(1200.0, rel=1e-3)
    assert resting["f2y"] == pytest.approx(1800.0, rel=1e-3)
    own = resting["m1x"] + resting["m2x"]  # N m; the lever arms are measured from 0.12 m
    assert 0.12 * resting["f1y"] - 0.08 * resting["f2y"] + own == pytest.approx(0, abs=0.02)


def test_as_statics(resting):
    """The equilibrium position of the shaft agrees with `raceway shaft` for a rigid shaft."""
    seats = [shaft.Seat(at, B6208, phase=-np.pi / 2) for at in (0.1, 0.3)]
    rest = shaft.rest(
        shaft.Shaft([Section(0.4, 0.3)], Steel(young=2.1e13)),
        seats,
        [shaft.Load(0.22, (0.0, -3000.0, 0.0))],
    )
    first, second = rest.bearings
    assert resting["y1"] == pytest.approx(first.place[1], rel=2e-3)
    assert resting["y2"] == pytest.approx(second.place[1], rel=2e-3)
    assert resting["f1y"] == pytest.approx(-first.load[1], rel=1e-3)
    assert resting["f2y"] == pytest.approx(-second.load[1], rel=1e-3)


def test_as_one_double_row_bearing(resting):
    """The shaft agrees with statics of two rows on a single ring that is loaded away from its
    middle and free to tilt."""
    loads = {"load_azimuth": -np.pi / 2, "moment": (60.0, 0.0), "held": {"z": 0.0}}
    rest = static.equilibrium(B6208.double_row(DoubleRow(0.2)), 3000.0, phase=-np.pi / 2, **loads)
    assert resting["y"] == pytest.approx(rest.shift[1], rel=2e-3)
    assert resting["rx"] == pytest.approx(rest.tilt[0], rel=2e-3)
    loads = rest.inner.load.reshape(2, -1).max(1)
    assert loads[1] / loads[0] == pytest.approx(1.5, rel=2e-3)


def test_rings_are_on_the_shaft(resting):
    assert resting["y1"] == pytest.approx(resting["y"] + 0.1 * resting["rx"], rel=0, abs=1e-13)
    assert resting["y2"] == pytest.approx(resting["y"] - 0.1 * resting["rx"], rel=0, abs=1e-13)
    assert resting["fy"] == pytest.approx(resting["f1y"] + resting["f2y"], rel=1e-14)
    levers = 0.1 * resting["f1y"] - 0.1 * resting["f2y"] + resting["m1x"] + resting["m2x"]
    assert resting["mx"] == pytest.approx(levers, rel=1e-4)  # the error is due to the tilt


# ---- without contact
def gyroscope(time, moment, spin):
    """Return the tilt rx + i ry (rad) of a free body, initially at rest, under a moment Mx + i My.
    It solves It W' - i Ip spin W = M."""
    rate = 1j * AXIAL * spin / ACROSS
    return moment / (ACROSS * rate) * ((np.exp(rate * time) - 1) / rate - time)


@pytest.mark.parametrize("mover", MOVERS)
def test_free_body(tmp_path, mover):
    """A force that acts off the centre translates and rotates the shaft; because of the spin there
    is a gyroscopic moment."""
    step = MOVERS[mover]["step"]
    words = "mass 4 inertia 2e-3 2e-2 centre 0.08 load 0.15 30 0 0 load 0.08 0 10 0"
    data, energy = swing(
        tmp_path,
        **MOVERS[mover],
        control="tolerance 1e-12 energy yes",
        freedoms=f"{TILTING} 3000",
        words=words,
        clearance=AIR,
        steps=round(4e-3 / step),
        every=round(1e-4 / step),
    )
    time = data["time"]
    assert data["x"] == pytest.approx(30 / MASS * time**2 / 2, rel=1e-4, abs=1e-10)
    assert data["y"] == pytest.approx(10 / MASS * time**2 / 2, rel=1e-4, abs=1e-10)
    tilt = gyroscope(time, 1j * 0.07 * 30, 3000.0)
    assert np.abs(data["rx"] + 1j * data["ry"] - tilt).max() < 2e-4 * np.abs(tilt).max()
    assert data["x1"] == pytest.approx(data["x"] - 0.08 * data["ry"], abs=1e-9)
    assert data["x2"] == pytest.approx(data["x"] + 0.12 * data["ry"], abs=1e-9)
    # the motion of a ring is the sum of the motion of the centre and that due to the tilt
    growth = 0.07 * 30 / ACROSS * np.cos(AXIAL * 3000 / ACROSS * time)
    for ring, lever in (("a1x", -0.08), ("a2x", 0.12)):
        assert data[ring] == pytest.approx(30 / MASS + lever * growth, rel=0, abs=1e-3)
    if mover == "implicit":
        assert energy["work"] > 3e-3 and energy["dissipated"] == 0.0
        assert abs(energy["lost"]) < 1e-4 * energy["work"]


@pytest.mark.parametrize("mover", MOVERS)
def test_unbalance_in_two_planes(tmp_path, mover):
    """With equal and opposite unbalances at 0.05 and 0.15 m, the centre does not move and the axis
    describes a cone."""
    spin, step = 500.0, MOVERS[mover]["step"]
    words = "mass 4 inertia 2e-3 2e-2 centre 0.1 unbalance 0.05 1e-5 0 unbalance 0.15 1e-5 PI"
    data, _ = swing(
        tmp_path,
        **MOVERS[mover],
        control="tolerance 1e-12",
        freedoms=f"{TILTING} {spin}",
        words=words.replace("PI", repr(np.pi)),
        clearance=AIR,
        steps=round(1e-2 / step),
        every=round(1e-4 / step),
    )
    time = data["time"]
    couple = -1e-5 * 0.1 * spin**2  # N m, times i because a force along x causes a moment about y
    rate = 1j * AXIAL * spin / ACROSS
    own, free = 1j * spin, rate
    # W = c (e^(i spin t) - e^(rate t)), starting from rest
    c = 1j * couple / (ACROSS * (own - free))
    tilt = c * ((np.exp(own * time) - 1) / own - (np.exp(free * time) - 1) / free)
    assert np.abs(data["rx"] + 1j * data["ry"] - tilt).max() < 1e-3 * np.abs(tilt).max()
    assert np.abs([data["x"], data["y"]]).max() < 1e-12


# ---- whirl
def natural_frequencies(mass, axial, across, spin, levers, stiffness):
    """Return the natural frequencies in Hz, in ascending order, of a rigid shaft on bearings at
    distances `levers` (m) from its centre."""
    whole = np.zeros((4, 4))
    for at in levers:
        turn = np.array([[1, 0, 0, at], [0, 1, -at, 0], [0, 0, 1, 0], [0, 0, 0, 1]], float)
        whole += turn.T @ stiffness @ turn
    inertia = np.diag([mass, mass, across, across])
    gyroscopic = np.zeros((4, 4))
    gyroscopic[2, 3], gyroscopic[3, 2] = axial * spin, -axial * spin
    system = np.block(
        [
            [np.zeros((4, 4)), np.eye(4)],
            [-np.linalg.solve(inertia, whole), -np.linalg.solve(inertia, gyroscopic)],
        ]
    )
    return np.sort(np.abs(np.linalg.eigvals(system).imag))[::2] / (2 * np.pi)


@pytest.mark.parametrize("spin", [0.0, 2000.0])
def test_whirl_frequencies(tmp_path, spin):
    """On preloaded bearings without friction, the whirl frequencies agree within 1 %; this bound
    allows for the inertia of the balls and other effects."""
    mass, axial, across, centre, clearance = 40.0, 0.8, 1.0, 0.06, -20e-6
    data, _ = swing(
        tmp_path,
        mover="verlet",
        step=1e-6,
        steps=16000,
        every=20,
        clearance=clearance,
        freedoms=f"{TILTING} {spin}",
        words=f"mass {mass} inertia {axial} {across} centre {centre} load 0.15 200 50 0",
    )
    held = dict.fromkeys(static.FREEDOMS, 0.0)
    stiffness = static.equilibrium(B6208, held=held, clearance=clearance).stiffness
    across_it = stiffness[np.ix_([0, 1, 3, 4], [0, 1, 3, 4])]
    want = natural_frequencies(mass, axial, across, spin, (-centre, 0.2 - centre), across_it)
    signals = np.array([data["x"], data["y"], 0.1 * data["rx"], 0.1 * data["ry"]])
    if spin == 0.0:  # one plane shows one frequency of each of two equal pairs
        signals, want = signals[[0, 3]], want[::2]
    found = frequencies_of(signals, data["time"][1] - data["time"][0], 2 * len(want))
    found = np.sort(np.abs(found))[::2]
    assert found == pytest.approx(want, rel=5e-3)
    if spin:
        assert want[3] / want[2] > 1.05 and want[1] / want[0] > 1.5  # they differ enough


# ---- balances under load
def test_energy(tmp_path):
    """The work of the loads equals the dissipated heat plus the energy of motion and of the
    springs; the integrator loses a fraction of one thousandth."""
    words = "mass 4 inertia 2e-3 2e-2 centre 0.08 load 0.15 -300 -3000 0 unbalance 0.02 2e-4 0.4"
    _, energy = swing(tmp_path, **ENERGY, freedoms=f"{TILTING} 200", words=f"{words} ramp 1e-3")
    assert energy["work"] > 1e-2 and energy["dissipated"] > 0.0
    assert abs(energy["lost"]) < 1e-3 * energy["work"]


LOADED = "mass 4 inertia 2e-3 2e-2 load 0.15 -300 -3000 200 unbalance 0.02 2e-4 0.4 ramp 1e-3"


OIL = "lubricant 0.04 22e-9 roughness 1e-7 0"
LAWS = {
    "dry": {},
    # this law stores a state for each contact
    "film": {
        "style": "bearing/ehd",
        "law": f"{OIL} gap 0 film_damping branch friction stribeck 0.12 0.05 smoothed 0.01",
        "speed": 200,
        "cage": 1,
    },
}


@pytest.mark.parametrize("law", LAWS)
def test_integrators_agree(tmp_path, law):
    control = {
        "implicit": {"step": 5e-5, "control": "tolerance 1e-10 largest 4e-6"},
        "verlet": {"mover": "verlet", "step": 2.5e-7},
    }
    ends = [
        swing(
            tmp_path / mover,
            freedoms=f"{TILTING} 200 z free",
            words=LOADED,
            steps=round(3e-3 / extra["step"]),
            every=round(1e-4 / extra["step"]),
            **LAWS[law],
            **extra,
        )[0]
        for mover, extra in control.items()
    ]
    one, other = ends
    for key in ("x", "y", "z", "rx", "ry", "f1y", "f2y", "mx", "a2y"):
        assert np.abs(one[key] - other[key]).max() < 1e-3 * np.abs(other[key]).max(), key


def test_within_a_step(tmp_path):
    """In samples taken within long steps, the rings stay on the shaft, and their accelerations are
    the derivatives of their velocities."""
    text = succeed(DECK, out=tmp_path, **WITHIN, words=LOADED).text
    said = yaml.safe_load((tmp_path / "run.yaml").read_text())
    # both bearings form one system and have the same internal steps
    (steps,) = numbers_of(text, "STEPS")
    assert said["step_s"] == pytest.approx(said["simulated_s"] / steps, rel=1e-9)
    ring = rings_follow(tmp_path)
    apart = ring["x"][:, 1] - ring["x"][:, 0]
    assert apart == pytest.approx(0.2 * ring["tilt_2"][:, 0], rel=0, abs=1e-12)
    assert np.abs(apart).max() > 1e-6


# ---- another axis, gravity, invalid input
@pytest.mark.parametrize("moved", ["all bearing/implicit", "balls nve/sphere"])
def test_along_x(tmp_path, moved):
    """A load along z that acts off the centre tilts the shaft about the y axis."""
    free = "mass 4 inertia 2e-3 2e-2 x free y free z free ry free rz free spin speed 0"
    text = small(
        tmp_path,
        f"fix move {moved}\nfix s inner bearing/shaft {free} centre 0.1 load 0.15 3 0 8\n"
        "timestep 1e-6\nrun 1000\n"
        'print "END $(f_s[1]) $(f_s[2]) $(f_s[3]) $(f_s[7]) $(f_s[8]) $(f_s[2][3]) $(f_s[20])"\n',
    ).text
    x, y, z, about_y, about_z, z2, load_z = numbers_of(text)
    tilt = -8 * 0.05 / ACROSS * 0.5e-6
    assert [x, z, about_y] == pytest.approx([3 / MASS * 0.5e-6, 8 / MASS * 0.5e-6, tilt], rel=3e-3)
    assert abs(y) < 1e-15 and abs(about_z) < 1e-15 and load_z == 8.0
    assert z2 == pytest.approx(z - 0.1 * about_y, rel=1e-9)


def test_weight(tmp_path):
    """The force of fix gravity acts at the centre of mass, so it does not tilt the shaft."""
    text = small(
        tmp_path,
        "fix move all bearing/implicit\nfix g all gravity 9.81 vector 0 -1 0\n"
        "fix s inner bearing/shaft mass 4 inertia 2e-3 2e-2 x free y free z free ry free rz free "
        "spin speed 0 centre 0.02\n"
        "compute r inner bearing/ring ay\ntimestep 1e-5\nrun 300\n"
        'print "END $(f_s[2]) $(f_s[25]) $(f_s[2][25]) $(f_s[7]) $(f_s[8])"\n',
    ).text
    y, ay, ay2, *tilts = numbers_of(text)
    assert y == pytest.approx(-9.81 * 4.5e-6, rel=1e-2) and ay == pytest.approx(-9.81)
    assert ay2 == pytest.approx(-9.81) and tilts == [0.0, 0.0]


FREE = "mass 4 inertia 2e-3 2e-2 y free z free spin speed 100"


@pytest.mark.parametrize(
    "text, says, off",
    [
        (f"fix s inner bearing/shaft {FREE} load 0.1 5 0\nrun 0", "load (N)", "0"),
        (f"fix s inner bearing/shaft {FREE} unbalance 0.1 -1 0", "unbalance (kg m) is -1", "0"),
        (
            "fix s inner bearing/shaft mass 4 y free unbalance 0.1 1e-4 0",
            "unbalance needs 'spin speed W'",
            "0",
        ),
        ("fix s inner bearing/shaft y free", "fix s bearing/shaft: y free needs 'mass M'", "0"),
        ("fix s inner bearing/shaft wobble 1", "centre, load", "0"),
        ("fix s balls bearing/shaft", "of group balls is of type 1", "0"),
        (
            "fix s inner bearing/shaft\nfix r inner bearing/ring\nfix m balls nve/sphere\nrun 0",
            "fix r bearing/ring and fix s bearing/shaft both move ring atom",
            "0",
        ),
        (
            "fix s inner bearing/shaft\nfix t inner bearing/shaft\nfix m balls nve/sphere\nrun 0",
            "fix t bearing/shaft and fix s bearing/shaft both move ring atom",
            "0",
        ),
        ("fix s inner bearing/shaft\nfix m balls nve/sphere\nrun 0", "m off the axis of", "1e-6"),
        (
            "fix m balls nve/sphere\nrun 0\ngroup two id 21\ndisplace_atoms two move 0 1e-6 0\n"
            "fix s inner bearing/shaft\nrun 0",
            "m off its position on the shaft of ring atom 10",
            "0",
        ),
        (
            "group two id 21\nvelocity two set 0 1e-3 0\n"
            f"fix s inner bearing/shaft {FREE}\nfix m balls nve/sphere\nrun 0",
            "m/s faster than the shaft of ring atom 10",
            "0",
        ),
        (
            f"fix s inner bearing/shaft {FREE}\nfix m balls nve/sphere\n"
            "fix g all gravity 9.81 vector 0 -1 0\nrun 0",
            "fix g (gravity) pulls its rings",
            "0",
        ),
        (
            f"fix s inner bearing/shaft {FREE}\ngroup one id 1:11\ngroup rest subtract all one\n"
            "fix m one bearing/implicit\nfix n rest nve/sphere\nrun 0",
            "its group has some rings of fix s but not all of them",
            "0",
        ),
    ],
)
def test_mistakes(tmp_path, text, says, off):
    refuses(small_deck(tmp_path, text + "\n", off), says)
