# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft flexible: a flexible shaft on two 6208s agrees with a beam in which all nodes
are retained.

The shaft extends along z from 0 to 0.3 m; its bearings are at 0 and 0.2 m.
"""

from typing import NamedTuple

import numpy as np
import pytest
import raceway
from bearings import B6208
from host import refuses, succeed
from raceway import beam, beam_motion, bending_file, shaft, shaft_bending, static
from raceway.theory.beam import Disc, Section, Steel
from shaft_runs import (
    BITS,
    DECK,
    ENERGY,
    TILTING,
    WITHIN,
    data_of,
    frequencies_of,
    numbers_of,
    rings_follow,
    rows_of,
    small,
    small_deck,
    swing,
)

SECTIONS = [Section(0.2, 0.02), Section(0.1, 0.016)]
DISC = Disc(0.12, 3.0, 0.01, 0.006)
PLACES = (0.0, 0.12, 0.2, 0.3)  # m, positions of bearing, disc, bearing and overhung load
KEPT = (0.0, 0.2, 0.3)
PRELOAD = -20e-6  # m, diametral clearance


def beam_of(steel=beam.STEEL):
    z, pieces = beam.divided(SECTIONS, np.linspace(0.0, 0.3, 31))
    return z, beam_motion.matrices(z, pieces, [DISC], steel)


def node(z, place):
    return int(np.argmin(np.abs(z - place)))


def reduced(steel=beam.STEEL, damping=0.0):
    z, whole = beam_of(steel)
    centre = beam_motion.rigid(z, whole).centre
    z, pieces = beam.divided(SECTIONS, [*np.linspace(0.0, 0.3, 31), centre])
    whole = beam_motion.matrices(z, pieces, [DISC], steel)
    stations = sorted(node(z, one) for one in (*PLACES, centre))
    kept = [node(z, one) for one in KEPT]
    return shaft_bending.bending(z, whole, kept, 4, stations, damping)


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """Write the file of the shaft without damping, and return its path."""
    path = tmp_path_factory.mktemp("file") / "shaft.modes"
    bending_file.write(path, reduced())
    return path


@pytest.fixture(scope="module")
def damped(tmp_path_factory):
    path = tmp_path_factory.mktemp("damped") / "shaft.modes"
    bending_file.write(path, reduced(damping=0.02))
    return path


# ---- compared with the beam
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


# ---- compared with the equations of a free shaft
class Support(NamedTuple):
    """A support at the centre of mass that acts equally in both planes."""

    stiffness: float = 0.0  # N/m
    damping: float = 0.0  # N s/m
    tilt_stiffness: float = 0.0  # N m/rad
    tilt_damping: float = 0.0  # N m s/rad

    def words(self, *names):
        """Return the keywords that define the support in a deck; `names` are the names of two
        displacements and two tilts."""
        pairs = [self[:2], self[:2], self[2:], self[2:]]
        return " ".join(f"support {name} {k} {c}" for name, (k, c) in zip(names, pairs))


def in_the_air(found, time, spin, support):
    """Return (coordinates of the shaft (2 (2 + n),), their rates) after loads have acted for `time`
    s on a shaft that was at rest. The coordinates are position, slope and modes in the plane of y,
    followed by those in the plane of z."""
    from scipy.integrate import solve_ivp

    body, n = found.body, len(found.mass) + 2
    mass = np.tile([body.mass, body.transverse, *found.mass], 2)
    stiffness = np.tile([0.0, 0.0, *found.stiffness], 2)
    damping = np.tile([0.0, 0.0, *found.damping], 2)

    def at(place):  # displacement and slope at a position, in one plane
        k = node(found.z, place)
        moved = np.array([1.0, found.z[k] - body.centre, *found.shape[:, k, 0]])
        return moved, np.array([0.0, 1.0, *found.shape[:, k, 1]])

    def force(t):
        overhang, disc, (centre, slope) = at(0.3)[0], at(0.12)[0], at(body.centre)
        turning = 4.0 * np.array([np.cos(900 * t + 0.3), np.sin(900 * t + 0.3)])
        heavy = 1e-5 * spin**2 * np.array([np.cos(spin * t + 0.7), np.sin(spin * t + 0.7)])
        one = overhang * 5 + disc * heavy[0] + centre * turning[0] + slope * 0.1
        other = overhang * 2 + disc * heavy[1] + centre * turning[1] - slope * 0.2
        return np.concatenate([one, other])

    gyroscopic = np.zeros((2 * n, 2 * n))
    gyroscopic[1:n, n + 1 :], gyroscopic[n + 1 :, 1:n] = found.gyroscopic, -found.gyroscopic

    def held(q, v):
        """Return the force of the support on each coordinate."""
        moved, tilted = at(body.centre)
        return np.concatenate(
            [
                -moved * (support.stiffness * moved @ x + support.damping * moved @ u)
                - tilted * (support.tilt_stiffness * tilted @ x + support.tilt_damping * tilted @ u)
                for x, u in zip(np.split(q, 2), np.split(v, 2))
            ]
        )

    def motion(t, state):
        q, v = np.split(state, 2)
        own = stiffness * q + damping * v + spin * gyroscopic @ v
        return np.concatenate([v, (force(t) + held(q, v) - own) / mass])

    start = np.zeros(4 * n)
    end = solve_ivp(motion, (0.0, time), start, "DOP853", rtol=1e-10, atol=1e-16).y[:, -1]
    return np.split(end, 2)


@pytest.mark.parametrize("support", [Support(), Support(4e6, 60.0, 3e4, 2.0)])
def test_in_the_air(tmp_path, damped, support):
    """Loads, a moment, a rotating force and an unbalance excite the modes of a shaft along x, with
    and without supports at its centre."""
    spin, time = 2000.0, 2e-3
    wanted = ["2", "3", "7", "8", "27"] + [str(k) for k in range(28, 34)]
    rings = [f"f_s[2][{k}]" for k in (2, 3, 7, 8, 28, 29, 30, 31)]
    rings += ["f_s[22]", "f_s[23]"]
    values = " ".join(f"$({one})" for one in (*(f"f_s[{k}]" for k in wanted), *rings))
    held = support.words("y", "z", "ry", "rz") if any(support) else ""
    text = small(
        tmp_path,
        "fix move all bearing/implicit tolerance 1e-13 largest 1e-6\n"
        f"fix s inner bearing/shaft flexible {damped} y free z free ry free rz free "
        f"spin speed {spin} load 0.3 0 5 2 moment 0 0.2 0.1 rotating 4 900 0.3 "
        f"unbalance 0.12 1e-5 0.7 {held}\n"
        f'timestep 1e-6\nrun {round(time / 1e-6)}\nprint "END {values}"\n',
    ).text
    y, z, tilt_y, tilt_z, strain, *rest = numbers_of(text)
    modes, ring, forces = np.reshape(rest[:6], (3, 2)).T, rest[6:-2], rest[-2:]
    found = reduced(damping=0.02)
    place, rate = (np.split(half, 2) for half in in_the_air(found, time, spin, support))
    one, other = place
    centre = np.array([1.0, 0.0, *found.shape[:, node(found.z, found.body.centre), 0]])
    for force, q, v in zip(forces, place, rate):
        want = -support.stiffness * centre @ q - support.damping * centre @ v
        assert force == pytest.approx(want, rel=2e-3)
    assert [y, tilt_z] == pytest.approx(one[:2], rel=1e-3)
    assert [z, tilt_y] == pytest.approx([other[0], -other[1]], rel=1e-3)
    assert modes[0] == pytest.approx(one[2:5], rel=0, abs=2e-3 * np.abs(one[2]))
    assert modes[1] == pytest.approx(other[2:5], rel=0, abs=2e-3 * np.abs(other[2]))
    want = 0.5 * found.stiffness @ (one[2:] ** 2 + other[2:] ** 2)
    assert strain == pytest.approx(want, rel=2e-3)
    # the motion of a ring is the sum of that of the rigid shaft and that due to bending
    ring_y, ring_z, ring_tilt_y, ring_tilt_z, bend_y, bend_z, bend_tilt_y, bend_tilt_z = ring
    lever = 0.2 - found.body.centre
    assert ring_y == pytest.approx(y + lever * tilt_z + bend_y, rel=1e-6)
    assert ring_z == pytest.approx(z - lever * tilt_y + bend_z, rel=1e-6)
    assert ring_tilt_y == pytest.approx(tilt_y + bend_tilt_y, rel=1e-6)
    assert ring_tilt_z == pytest.approx(tilt_z + bend_tilt_z, rel=1e-6)
    at = node(found.z, 0.2)
    assert bend_y == pytest.approx(found.shape[:, at, 0] @ one[2:], rel=2e-3)
    assert bend_tilt_y == pytest.approx(-found.shape[:, at, 1] @ other[2:], rel=2e-3)


def test_held_in_the_middle(tmp_path):
    """Stiff supports hold a thin shaft in the middle, so that each half vibrates like a
    cantilever."""
    thin, end = Section(0.2, 0.006), 0.1
    z, pieces = beam.divided([thin], np.linspace(0.0, 0.2, 21))
    kept = [0, 10, 20]
    found = shaft_bending.bending(z, beam_motion.matrices(z, pieces), kept, 2, kept)
    bending_file.write(tmp_path / "thin.modes", found)
    support = Support(stiffness=1e9, tilt_stiffness=1e6)
    step, steps = 5e-5, 120
    text = small(
        tmp_path,
        "fix move all bearing/implicit tolerance 1e-12 largest 1e-6\n"
        f"fix s inner bearing/shaft flexible {tmp_path / 'thin.modes'} y free z free ry free "
        f"rz free spin fixed load 0 0 1 0 load 0.2 0 1 0 {support.words('y', 'z', 'ry', 'rz')}\n"
        "variable y equal f_s[2][2]\n"
        f'fix say all print 1 "END ${{y}}"\ntimestep {step}\nrun {steps}\n',
    ).text
    y = np.array([float(line.split()[1]) for line in text.splitlines() if line[:4] == "END "])
    found = frequencies_of(y[None], step, 2)[-1] * 2 * np.pi
    bending = beam.STEEL.young * beam.second_moment(thin)
    line = beam.STEEL.density * beam.area(thin)
    exact = 1.875104**2 * np.sqrt(bending / line) / end**2
    assert found == pytest.approx(exact, rel=5e-3)  # in this thin shaft, shear contributes 2e-3
    phase = found * step * np.arange(len(y))
    parts = np.column_stack([np.ones_like(y), np.cos(phase), np.sin(phase)])
    rest = np.linalg.lstsq(parts, y)[0][0]  # equilibrium position
    assert rest == pytest.approx(end**3 / (3 * bending), rel=5e-3)


# ---- a rigid shaft
ACROSS = Support(2e6, 100.0, 1e4, 5.0).words("x", "y", "rx", "ry")
HELD = f"{ACROSS} support z 1e6 10"
LOADED = "load 0.12 -100 -800 0 load 0.3 20 50 30 unbalance 0.12 1e-4 0.4 ramp 1e-3"


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


# ---- balances
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


# ---- bitwise identical results
@pytest.fixture(scope="module")
def whole(tmp_path_factory, damped):
    """Return (folder, variables) of a run on a single rank."""
    folder = tmp_path_factory.mktemp("whole")
    variables = {**BITS, "every": 10, "words": f"flexible {damped} {LOADED} {HELD}"}
    succeed(DECK, out=folder, **variables, steps=60)
    return folder, variables


def test_scene_is_worth_comparing(whole):
    data = {key: value[-1] for key, value in data_of(whole[0]).items()}
    rigid = data["y"] - (0.2 - reduced().body.centre) * data["rx"]
    assert abs(data["y2"] - rigid) > 1e-7 and data["f2y"] > 100 and abs(data["z"]) > 1e-7


@pytest.mark.parametrize("host, ranks", [("liggghts", 4), ("lammps", 2)])
def test_same_bits(whole, host, ranks, tmp_path):
    folder, variables = whole
    succeed(DECK, host=host, ranks=ranks, out=tmp_path, **variables, steps=60)
    assert rows_of(tmp_path)[-6:] == rows_of(folder)[-6:]


@pytest.fixture(scope="module")
def half(whole, tmp_path_factory):
    """Return the restart file that the run writes half-way."""
    folder = tmp_path_factory.mktemp("half")
    succeed(DECK, out=folder, **whole[1], steps=30, keep=30)
    return folder / "restart.30"


def test_restart(whole, half, tmp_path):
    folder, variables = whole
    extra = {**variables, "from": half}
    succeed(DECK, ranks=2, out=tmp_path, begin="resume", **extra, steps=30)
    assert rows_of(tmp_path)[-3:] == rows_of(folder)[-3:]


def test_restart_with_other_modes(whole, half, tmp_path):
    words = f"mass 4 inertia 2e-3 2e-2 {LOADED}"
    extra = {**whole[1], "from": half, "words": words}
    says = "the restart file has 8 modes of the shaft, but the deck has 0"
    refuses(DECK, says, out=tmp_path, begin="resume", **extra, steps=1)


# ---- mistakes
FREE = "y free z free ry free rz free spin speed 100"


@pytest.mark.parametrize(
    "text, says",
    [
        ("FILE mass 4", "mass, inertia and centre of a flexible shaft come from"),
        ("FILE centre 0.1", "mass, inertia and centre of a flexible shaft come from"),
        ("FILE ry fixed", "needs both transverse displacements and both tilts 'free'"),
        ("FILE load 0.25 0 1 0", "a load is at 0.25 m, and"),
        ("FILE unbalance 0.05 1e-5 0", "an unbalance is at 0.05 m, and"),
        ("nowhere", "cannot read 'nowhere'"),
        ("FILE\nunfix m\nfix m balls nve/sphere", "a flexible shaft needs fix bearing/implicit"),
        (
            "FILE\nunfix m\nfix m all bearing/implicit solve damping",
            "a flexible shaft needs 'solve all' of fix m",
        ),
    ],
)
def test_mistakes(tmp_path, file, text, says):
    first, *lines = text.replace("FILE", str(file)).splitlines()
    deck = f"fix m all bearing/implicit\nfix s inner bearing/shaft {FREE} flexible {first}\n"
    refuses(small_deck(tmp_path, deck + "\n".join([*lines, "run 0\n"])), says)


@pytest.mark.parametrize(
    "old, new, says",
    [
        ("raceway-shaft 1", "raceway-shaft 2", "must be 'raceway-shaft 1'"),
        ("units m kg s N rad", "units mm kg s N rad", "must be 'units m kg s N rad'"),
        ("units m kg s N rad\n", "", "has no line 'units m kg s N rad'"),
        ("\nmass ", "\nweight ", "unknown word 'weight'; known: units, mass"),
        ("\nmass ", "\nmass -", "'mass' is -"),
        ("\nmodal_mass ", "\nmodal_mass -", "'modal_mass' is -"),
        ("\nmodal_stiffness ", "\nmodal_stiffness 1 ", "'modal_stiffness' has 9 numbers"),
        ("\nmodal_damping 0", "\nmodal_damping -1", "'modal_damping' is -1, must be from 0"),
        ("\nmodes 8", "\nmodes 7", "'modal_mass' has 8 numbers, must have 7"),
        ("\nmodes 8", "\nmodes 8.5", "'modes' is 8.5, must be a whole number"),
        ("\ngyroscopic ", "\n# ", "has 8 lines 'gyroscopic', must have 9"),
        ("\nstation 0 ", "\nstation 0 1 ", "'station' has 18 numbers, must have 17"),
        ("\nstation 0 ", "\nstation 1 ", "must be beyond the one before it"),
        ("\nstation 0 ", "\nstation 0.001 ", "ring atom 10 is at 0 m, and"),
        ("\nstation 0 ", "\nstation nan ", "'nan' is not a finite number"),
    ],
)
def test_bad_files(tmp_path, file, old, new, says):
    content = file.read_text()
    assert old in content
    bad = tmp_path / "bad.modes"
    bad.write_text(content.replace(old, new, 1))
    deck = f"fix m all bearing/implicit\nfix s inner bearing/shaft {FREE} flexible {bad}\nrun 0\n"
    refuses(small_deck(tmp_path, deck), says)


def test_matrix_that_is_not_symmetric(tmp_path, file):
    lines = file.read_text().splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith("gyroscopic"))
    word, one, two, *others = lines[first].split()
    lines[first] = " ".join([word, one, repr(1.001 * float(two)), *others])
    bad = tmp_path / "bad.modes"
    bad.write_text("\n".join(lines))
    deck = f"fix s inner bearing/shaft {FREE} flexible {bad}\n"
    refuses(small_deck(tmp_path, deck), "'gyroscopic' is not symmetric")
