# SPDX-License-Identifier: GPL-2.0-or-later
"""The motion of a ring on supports under gravity agrees with the closed-form solution for damped
oscillators."""

import re

import numpy as np
import pytest
from host import ROOT, columns, deck_file, refuses, succeed

DECK = "tests/scenarios/in.support"
MASS, ACROSS = 0.5, 2.5e-4
# {column of ring.dat: (load, inertia, stiffness, damping)}
DIRECTIONS = {
    "x": (200.0, MASS, 1e8, 2000.0),
    "y": (1000.0, MASS, 2e8, 0.0),
    "z": (-400.0, MASS, 5e7, 3000.0),
    "rx": (2.0, ACROSS, 4e4, 0.5),
    "ry": (-1.0, ACROSS, 2e4, 0.0),
}
FALL = np.array([1.0, -1.0, 0.5]) / 1.5  # direction of gravity in the deck
MOVERS = {"implicit": {}, "verlet": {"mover": "moving nve/sphere", "show": "time"}}


def swing(t, load, inertia, stiffness, damping):
    """Return the displacement and its second derivative at the times t (s) after a load is applied
    to a body at rest."""
    free = np.sqrt(stiffness / inertia)
    ratio = damping / (2 * np.sqrt(stiffness * inertia))
    root = -ratio * free + 1j * free * np.sqrt(1 - ratio**2)
    part = load / stiffness * np.exp(root * t) * root.conjugate() / (root - root.conjugate())
    return load / stiffness + 2 * part.real, 2 * (part * root**2).real


@pytest.mark.parametrize("fall", [0, 9.81])
@pytest.mark.parametrize("mover", MOVERS)
def test_free_decay(tmp_path, mover, fall):
    succeed(DECK, out=tmp_path, fall=fall, **MOVERS[mover])
    data = columns(tmp_path / "ring.dat")
    t = data["step"] * 1e-6
    weight = dict(zip("xyz", MASS * fall * FALL))
    for name, (load, *law) in DIRECTIONS.items():
        want, bend = swing(t, load + weight.get(name, 0.0), *law)
        assert np.abs(data[name] - want).max() < 1e-3 * np.abs(want).max(), name
        if name in "xy":
            # in velocity Verlet the undamped phase lags by h^2 w^3 t/24, which is 5e-4 of the
            # displacement
            assert np.abs(data["a" + name] - bend).max() < 2e-3 * np.abs(bend).max(), name


@pytest.mark.parametrize("fall", [0, 9.81])
def test_energy(tmp_path, fall):
    """The work of load and gravity equals the heat generated in the dampers plus the kinetic energy
    and the energy of the springs."""
    text = succeed(DECK, out=tmp_path, fall=fall).text
    work, lost, stored, rest = map(float, re.findall(r"^ *4000 +(.*)$", text, re.M)[-1].split())
    assert work == pytest.approx(lost + stored, abs=1e-6 * work)
    # the estimated local error is 0.1 nm per step, while springs of 2e8 N/m are displaced by 10 um
    assert abs(rest) < 1e-6 * work


def test_momentum(tmp_path):
    """At every sample, the forces of supports, load and weight give the acceleration to within the
    ten digits that the host prints, i.e. 1e-6 N of 2 kN."""
    succeed(DECK, out=tmp_path, fall=9.81)
    x, y, fx, fy, ax, ay = np.loadtxt(tmp_path / "ring.dat").T[[1, 2, 6, 7, 8, 9]]
    assert MASS * ax == pytest.approx(fx + 200 + MASS * 9.81 * FALL[0], abs=1e-6)
    assert MASS * ay == pytest.approx(fy + 1000 + MASS * 9.81 * FALL[1], abs=1e-6)
    assert fy == pytest.approx(-2e8 * y, abs=1e-6)


@pytest.mark.parametrize(
    "words, says",
    [
        ("support x 1e8", "damping of the support"),
        ("support w 1e8 1", "support"),
        ("support x -1 0", "must be"),
        ("support x 0 0", "a support needs stiffness or damping"),
        ("x fixed support x 1e8 0", "'support x' needs 'x free'"),
        ("rx fixed support rx 1e4 0", "'support rx' needs 'rx free'"),
    ],
)
def test_mistakes_are_named(tmp_path, words, says):
    text = re.sub(r"x free y free.*&\n.*\n", words + "\n", (ROOT / DECK).read_text())
    refuses(deck_file(tmp_path, text), "fix outer bearing/ring", says, out=tmp_path / "out")


def test_gravity_pulls_all_or_none(tmp_path):
    text = (ROOT / DECK).read_text().replace("fix weight all", "fix weight moving")
    says = "pulls some atoms of its group, but not all"
    refuses(deck_file(tmp_path, text), says, out=tmp_path / "out", fall=9.81)
