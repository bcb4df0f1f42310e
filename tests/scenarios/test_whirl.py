# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the unbalance and the rotating force of fix bearing/ring with both integrators.

Without contact, the equations are those of a point mass under a rotating force, starting from rest:
M x'' = A cos(w t + p), M y'' = A sin(w t + p).
"""

import re

import numpy as np
import pytest
from host import refuses, succeed

DECK = "tests/scenarios/in.whirl"
MASS = 0.5  # kg
KEYS = ("x", "y", "vx", "vy", "angle", "load_x", "load_y")


def end(**variables):
    """Return the final state of the ring that the deck prints."""
    text = succeed(DECK, **variables).text
    numbers = [float(word) for word in re.search(r"^END (.*)$", text, re.M)[1].split()]
    ring = dict(zip(KEYS, numbers, strict=True))
    if energy := re.search(r"^ENERGY (.*)$", text, re.M):
        names = ("work", "dissipated", "stored", "lost")
        ring.update(zip(names, map(float, energy[1].split()), strict=True))
    return ring


def whirl(force, speed, phase, time):
    """Return displacement (m) and velocity (m/s) of a free mass under a force in N."""
    a, t = force / MASS / speed**2, time
    turned = speed * t + phase
    return {
        "x": -a * (np.cos(turned) - np.cos(phase)) - a * speed * t * np.sin(phase),
        "y": -a * (np.sin(turned) - np.sin(phase)) + a * speed * t * np.cos(phase),
        "vx": a * speed * (np.sin(turned) - np.sin(phase)),
        "vy": -a * speed * (np.cos(turned) - np.cos(phase)),
    }


def error(found, exact):
    """Return the largest error of the displacement relative to 20 um."""
    return max(abs(found[key] - exact[key]) for key in ("x", "y")) / 2e-5


@pytest.mark.parametrize(
    "words, speed", [("unbalance 1e-5 0.3", 100), ("rotating 0.05 -60 0.3", -60)]
)
def test_closed_form_verlet(words, speed):
    """The error is of second order in the time step."""
    force = 1e-5 * 100**2 if "unbalance" in words else 0.05
    exact = whirl(force, speed, 0.3, 0.1)
    coarse, fine = (
        error(end(integrator="verlet", words=words, step=step), exact) for step in (1e-5, 5e-6)
    )
    assert fine < 1e-4 and coarse / fine == pytest.approx(4.0, rel=0.02)


@pytest.mark.parametrize(
    "words, speed", [("unbalance 1e-5 0.3", 100), ("rotating 0.05 -60 0.3", -60)]
)
def test_closed_form_implicit(words, speed):
    """Internal steps are chosen according to the tolerance, so the results are accurate even with
    host steps of a quarter of a turn."""
    force = 1e-5 * 100**2 if "unbalance" in words else 0.05
    exact = whirl(force, speed, 0.3, 0.1)
    found = [
        end(words=words, step=2e-2, control=f"tolerance {tolerance} energy yes")
        for tolerance in (1e-10, 1e-12)
    ]
    errors = [error(one, exact) for one in found]
    assert errors[1] < 1e-5 and errors[1] < 0.2 * errors[0]
    # the work done by the load becomes kinetic energy of the ring only, because the balls are at
    # rest
    ring = found[1]
    kinetic = 0.5 * MASS * (exact["vx"] ** 2 + exact["vy"] ** 2)
    assert ring["stored"] == pytest.approx(kinetic, rel=1e-4)
    assert abs(ring["lost"]) < 1e-4 * kinetic and ring["dissipated"] == 0.0


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_same_as_rotating_force(integrator):
    """In a preloaded bearing, an unbalance acts like a force M E w^2 that rotates with the ring."""
    words = ("unbalance 2e-3 0.7", "rotating 20 100 0.7")
    step = {"implicit": 1e-3, "verlet": 1e-6}[integrator]
    one, other = (
        end(integrator=integrator, air=0, words=words, step=step, time=0.02) for words in words
    )
    size = np.hypot(one["x"], one["y"])
    assert size > 1e-8
    for key in ("x", "y"):
        assert one[key] == pytest.approx(other[key], abs=1e-6 * size)
    assert np.hypot(one["load_x"], one["load_y"]) == pytest.approx(20.0, rel=1e-12)
    assert np.arctan2(one["load_y"], one["load_x"]) == pytest.approx(
        np.angle(np.exp(1j * (one["angle"] + 0.7)))
    )


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_run_up(integrator):
    """If w = b t, the momentum of the ring decreases by that of the eccentric mass, which is M E w
    (-sin, cos)."""
    growth, time = 500.0, 0.1
    ring = end(integrator=integrator, spin=f"{growth}*time", words="unbalance 1e-5 0", step=1e-5)
    turned, speed = 0.5 * growth * time**2, growth * time
    a = 1e-5 / MASS
    assert ring["angle"] == pytest.approx(turned, rel=1e-3)
    assert ring["vx"] == pytest.approx(a * speed * np.sin(turned), rel=1e-3)
    assert ring["vy"] == pytest.approx(-a * speed * np.cos(turned), rel=1e-3)


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("ranks", [2, 4])
def test_same_bits_on_ranks(host, ranks):
    scene = {"air": 0, "words": "unbalance 2e-3 0.7 rotating 50 30 0.1 ramp 1e-3"}
    for case in (
        scene | {"integrator": "implicit", "step": 1e-3, "time": 0.01},
        scene | {"integrator": "verlet", "step": 1e-6, "time": 0.0015},
    ):
        assert end(host=host, ranks=ranks, **case) == end(**case)


@pytest.mark.parametrize(
    "words, says",
    [
        ("unbalance -1 0", "unbalance (kg m) is -1, must be"),
        ("unbalance 1e-3", "phase of the unbalance (rad)"),
        ("rotating 5 v_x 0", "speed of the rotating force (rad/s)"),
        ("unbalance 1e-3 0 spin free inertia 1e-4 1e-4", "unbalance needs 'spin speed W'"),
    ],
)
def test_errors(words, says):
    refuses(DECK, says, words=words)
