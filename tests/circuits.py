# SPDX-License-Identifier: GPL-2.0-or-later
"""Provide films with given properties to the tests of the electric circuit."""

import numpy as np
from raceway.electric.breakdown import Breakdown
from raceway.electric.films import Films
from raceway.electric.outer import Floating, Motor, Source
from raceway.electric.waveforms import CommonMode, Constant, Sine, Table

PICO = 1e-12


def films(capacitance, time=None, thickness=200e-9, conductance=0.0, roughness=0.0):
    """Return `Films` with the given `capacitance` (n, 2, Z) in F, `thickness` in m and
    `conductance` in S."""
    capacitance = np.asarray(capacitance, dtype=float)
    n, _, z = capacitance.shape
    azimuth = np.linspace(0, 0.5, n)[:, None] + 2 * np.pi * np.arange(z) / z
    azimuth = np.mod(azimuth + np.pi, 2 * np.pi) - np.pi
    return Films(
        np.linspace(0, 0.01, n) if time is None else np.asarray(time, dtype=float),
        capacitance,
        np.broadcast_to(thickness, capacitance.shape).astype(float),
        np.broadcast_to(conductance, capacitance.shape).astype(float),
        azimuth,
        azimuth,
        np.arange(1, z + 1),
        roughness,
        bool(np.any(conductance)),
    )


def steady(inner, outer, n=3, **more):
    """Return films with constant capacitances (Z,) in F at `n` points in time."""
    return films(np.tile([inner, outer], (n, 1, 1)), **more)


def turning(n=201, z=7, thickness=(80e-9, 140e-9), seed=3, **more):
    """Return films of balls that pass through a load zone; their capacitances and thicknesses vary
    and differ from each other."""
    rng = np.random.default_rng(seed)
    angle = 2 * np.pi * (np.arange(z) / z + np.linspace(0, 1.3, n)[:, None])[:, None]
    least = rng.uniform(5, 15, (1, 2, z)) * PICO
    most = rng.uniform(40, 90, (1, 2, z)) * PICO
    load = 0.5 + 0.5 * np.cos(angle)
    low, high = thickness
    apart = (high - (high - low) * load) * rng.uniform(1.0, 2.5, (1, 2, z))
    return films(least + most * load**2, thickness=apart, **more)


WEAK = Breakdown(30e6)
LEAKY = dict(conductance=2e-9)
INVERTER = CommonMode(560.0, 2000.0, 50.0, 0.8)
MOTOR = Motor(Sine(300.0, 2000.0), 50 * PICO, 1000 * PICO, second=200 * PICO)
MOTOR_OF_INVERTER = Motor(INVERTER, 50 * PICO, 1e-9, second_factor=1.0)
SOURCE_OF_INVERTER = Source(CommonMode(60.0, 2000.0, 50.0, 0.8), 1e6)
SOURCE_OF_TABLE = Source(Table([1e-4, 1.1e-3, 3.3e-3, 7.77e-3], [0.0, 40.0, -35.0, 30.0]), 1e6)
CASES = {  # films, outer circuit, breakdown
    "motor": (turning(), MOTOR, WEAK),
    "inverter": (turning(), MOTOR_OF_INVERTER, WEAK),
    "leaking inverter": (turning(**LEAKY), SOURCE_OF_INVERTER, WEAK),
    "table": (turning(), SOURCE_OF_TABLE, WEAK),
    "leaking motor": (turning(**LEAKY), MOTOR, WEAK),
    "rough": (turning(roughness=10e-9), MOTOR, WEAK),
    "source": (turning(), Source(Sine(15.0, 900.0), 1e6), WEAK),
    "leaking source": (turning(**LEAKY), Source(Sine(15.0, 900.0), 1e6, 30 * PICO), WEAK),
    "stiff source": (turning(**LEAKY), Source(Sine(15.0, 900.0)), None),
    "charged ring": (turning(), Floating(5.5, 30 * PICO), WEAK),
    "open film": (
        steady([50 * PICO, 0.0, 0.0], [50 * PICO, 40 * PICO, 0.0]),
        Source(Constant(4.0), 1e7),
        WEAK,
    ),
}
