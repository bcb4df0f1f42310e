# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft flexible: a shaft without contact with its bearings moves as its equations of
motion say."""

import numpy as np
import pytest
from flexible_shaft import Support, modes_file, node, reduced
from raceway import beam, beam_motion, bending_file, shaft_bending
from raceway.theory.beam import Section
from scipy.integrate import solve_ivp
from shaft_runs import frequencies_of, numbers_of, small


@pytest.fixture(scope="module")
def damped(tmp_path_factory):
    return modes_file(tmp_path_factory.mktemp("damped"), damping=0.02)


def in_the_air(found, time, spin, support):
    """Return (coordinates of the shaft (2 (2 + n),), their rates) after loads have acted for `time`
    s on a shaft that was at rest. The coordinates are position, slope and modes in the plane of y,
    followed by those in the plane of z."""
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
