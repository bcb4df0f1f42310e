# SPDX-License-Identifier: GPL-2.0-or-later
"""The motion of a ring on supports in a housing with mass agrees with the closed-form solution for
two coupled oscillators."""

import re

import numpy as np
import pytest
from host import ROOT, columns, deck_file, refuses, succeed
from scipy.linalg import expm

DECK = "tests/scenarios/in.housing"
RING, HOUSING = (0.5, 2.5e-4), (2.0, 2.5e-3)  # (kg, kg m^2) of ring and housing
# {direction: (load, (stiffness, damping) of the ring's and of the housing's support)}
DIRECTIONS = {
    "x": (200.0, (1e8, 2000.0), (2e8, 4000.0)),
    "y": (1000.0, (5e7, 0.0), (1e8, 1000.0)),
    "z": (-400.0, (5e7, 3000.0), (1e8, 0.0)),
    "rx": (2.0, (4e4, 0.5), (5e4, 1.0)),
    "ry": (-1.0, (2e4, 0.0), (3e4, 0.0)),
}
MOVERS = {"implicit": {}, "verlet": {"mover": "moving nve/sphere", "show": "time"}}


def swing(t, load, inertia, held, ground):
    """Return the displacements of ring and housing at evenly spaced times t (s), the first of which
    is one step after a load is applied to the ring at rest."""
    masses = np.array(inertia)
    stiff, damp = (np.array([[a, -a], [-a, a + b]]) for a, b in zip(held, ground))
    system = np.zeros((5, 5))  # the state vector contains displacements, velocities and 1
    system[:2, 2:4] = np.eye(2)
    system[2:4, :2], system[2:4, 2:4] = -stiff / masses[:, None], -damp / masses[:, None]
    system[2, 4] = load / masses[0]
    step, state, path = expm(system * (t[1] - t[0])), np.array([0, 0, 0, 0, 1.0]), []
    for _ in t:
        state = step @ state
        path.append(state[:2])
    return np.array(path).T


@pytest.fixture(scope="module", params=MOVERS)
def run(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("housing")
    succeed(DECK, out=folder, **MOVERS[request.param])
    return columns(folder / "ring.dat")


def test_free_decay(run):
    """In every direction, both bodies move according to the closed-form solution, within 1e-3 of
    the largest displacement."""
    t = run["step"] * 1e-6
    for name, (load, held, ground) in DIRECTIONS.items():
        which = 0 if len(name) == 1 else 1
        want = swing(t, load, (RING[which], HOUSING[which]), held, ground)
        for body, found in zip(want, (run[name], run["h" + name])):
            assert np.abs(found - body).max() < 1e-3 * np.abs(body).max(), name


def test_momentum(run):
    """The support between ring and housing exerts opposite forces on them, so the remaining force
    on the housing is that of its own support."""
    assert RING[0] * run["ax"] == pytest.approx(run["fx"] + 200, abs=1e-6)
    assert HOUSING[0] * run["hax"] == pytest.approx(run["hfx"], abs=1e-6)
    t = run["step"] * 1e-6
    speed = np.gradient(run["hx"], t, edge_order=2)
    ground = -(2e8 * run["hx"] + 4000 * speed)
    # velocities are difference quotients over 10 us
    scale = np.abs(run["fx"]).max()
    assert np.abs(run["hfx"] + run["fx"] - ground)[2:-2].max() < 0.02 * scale


def frequencies(t, x, y):
    """Return the four roots (1/s) of two coupled oscillators, from displacements at evenly spaced
    times. Both displacements are predicted linearly from the two preceding samples."""
    step = 2
    late = np.c_[x, y][2 * step :]
    early = np.c_[x, y, np.ones_like(x)]
    past = np.c_[early[step:-step], early[: -2 * step, :2]]
    law, *_ = np.linalg.lstsq(past, late, rcond=None)
    map_ = np.zeros((4, 4))
    map_[:2, :2], map_[:2, 2:], map_[2:, :2] = law[:2].T, law[3:].T, np.eye(2)
    return np.log(np.linalg.eigvals(map_).astype(complex)) / (step * (t[1] - t[0]))


@pytest.mark.parametrize("name", DIRECTIONS)
def test_frequencies_and_damping(run, name):
    """Both natural frequencies and both decay rates, determined from the motion, agree within
    1e-3."""
    _, held, ground = DIRECTIONS[name]
    which = 0 if len(name) == 1 else 1
    masses = np.array([RING[which], HOUSING[which]])
    stiff, damp = (np.array([[a, -a], [-a, a + b]]) / masses[:, None] for a, b in zip(held, ground))
    want = np.linalg.eigvals(np.block([[np.zeros((2, 2)), np.eye(2)], [-stiff, -damp]]))
    found = frequencies(run["step"] * 1e-6, run[name], run["h" + name])
    want, found = (v[v.imag > 0][np.argsort(v[v.imag > 0].imag)] for v in (want, found))
    assert np.abs(found - want).max() < 1e-3 * np.abs(want).min()


def test_a_driven_housing_carries_the_ring(tmp_path):
    """A housing that is moved by 1 um moves the ring; the energy balance includes the work of the
    drive."""
    base = "x position v_shake y fixed z fixed rx fixed ry fixed"
    deck = tmp_path / "in.driven"
    text = (ROOT / DECK).read_text().replace("force 200 1000 -400", "force 0 0 0")
    text = re.sub(r"\$\{base\} &\n.*\n", base + "\n", text).replace("moment 2 -1 0", "moment 0 0 0")
    deck.write_text("variable shake equal 1.0e-6*sin(1.0e4*1.0e-6*step)\n" + text)
    done = succeed(deck, out=tmp_path / "out").text
    data = columns(tmp_path / "out/ring.dat")
    t, free = data["step"] * 1e-6, np.sqrt(2e8)
    # bound for the undamped case, in which the transient may be as large as the response
    assert 0.5e-6 < np.abs(data["x"]).max() < 1e-6 * (1 + 1e4 / free) / (1 - 1e8 / free**2)
    assert data["hx"] == pytest.approx(1e-6 * np.sin(1e4 * t), abs=1e-15)
    work, lost, stored, rest = map(float, re.findall(r"^ *3000 +(.*)$", done, re.M)[-1].split())
    assert lost > 0 and abs(rest) < 1e-4 * lost


@pytest.mark.parametrize(
    "words, says",
    [
        ("to nowhere", "there is no group 'nowhere' to hold its ring"),
        ("to moving", "has 9 atoms, must have one ring"),
        ("to outer", "needs a fix bearing/ring of its own"),
    ],
)
def test_mistakes_are_named(tmp_path, words, says):
    deck = deck_file(tmp_path, (ROOT / DECK).read_text().replace("  to housing", "  " + words))
    refuses(deck, "fix outer bearing/ring", says, out=tmp_path / "out", steps=10)


def test_order_and_need(tmp_path):
    text = (ROOT / DECK).read_text()
    outer = re.search(r"fix outer outer.*\n.*\n.*\n", text)[0]
    housing = re.search(r"fix housing housing.*\n.*\n", text)[0]
    for name, swapped, says in (
        ("order", text.replace(outer, "").replace(housing, housing + outer), "must come before"),
        ("need", re.sub(r" support x.*&\n", " &\n", text), "'to housing' needs a support"),
    ):
        refuses(deck_file(tmp_path, swapped), says, out=tmp_path / name, steps=10)


def test_energy(tmp_path):
    """The work of the load equals the heat generated in the dampers plus the energy of motion and
    of the springs."""
    text = succeed(DECK, out=tmp_path).text
    work, lost, stored, rest = map(float, re.findall(r"^ *3000 +(.*)$", text, re.M)[-1].split())
    assert work == pytest.approx(lost + stored, abs=1e-6 * work)
    assert abs(rest) < 1e-6 * work and lost > 0.1 * work
