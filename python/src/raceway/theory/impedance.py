# SPDX-License-Identifier: GPL-2.0-or-later
"""Impedance of a film or bearing, and the inverse: capacitance, resistance and film thickness from
instrument readings. Numbers or arrays of one shape, SI units; frequencies in Hz.

A film is a capacitor with its leak in parallel: Z = 1/(1/R + j omega C).
"""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import brentq

from raceway import core
from raceway.arrays import Floats, Numbers
from raceway.core import laws
from raceway.theory.capacitance import VACUUM
from raceway.theory.capacitors import BearingCapacitors

THINNEST, THICKEST = 1e-3, 1e3  # search range of `film_scale`, factors on the model's films


def leak(resistivity: Numbers, paths: Numbers) -> Numbers:
    """R in ohm of oil of `resistivity` (ohm m) between two surfaces; `paths` is pi a b/h + I over
    the oil-filled part, m. With a uniform filling, R C = rho eps_0 eps for any geometry."""
    return resistivity / paths


def impedance(
    capacitance: Numbers, frequency: Numbers, resistance: Numbers = np.inf
) -> complex | np.ndarray:
    """Z in ohm, complex, of C (F) in parallel with R (ohm; infinite by default) at a frequency.
    Raises `ValueError` for a frequency that is not positive."""
    _positive(frequency)
    found = laws.film_impedance(capacitance, 1 / np.asarray(resistance, float), frequency)
    return (found.real + 1j * found.imaginary)[()]


def of_bearing(
    found: BearingCapacitors, frequency: float | np.ndarray, resistivity: float = np.inf
) -> complex | np.ndarray:
    """Z in ohm of a bearing at a frequency (Hz; a number or an array) in oil of `resistivity` (ohm
    m): both films of a ball in series, the balls in parallel."""
    sides = (found.inner, found.outer)
    return of_films(
        [side.total for side in sides], [side.paths for side in sides], frequency, resistivity
    )


def of_films(
    capacitances: Sequence[Floats],
    paths: Sequence[Floats],
    frequency: Numbers,
    resistivity: float = np.inf,
) -> complex | np.ndarray:
    """Z in ohm of a bearing from `capacitances` (F) and `paths` (m) of the inner and of the outer
    films, arrays (..., Z); the frequency has the shape of the leading dimensions. Raises as in
    `impedance`."""
    _positive(frequency)
    return 1 / _admittance(capacitances, paths, resistivity, frequency)


def leak_of_films(paths: Sequence[Floats], resistivity: float) -> Numbers:
    """R in ohm of a bearing at direct current, `paths` (m) of its inner and outer films (..., Z).
    Infinite if nothing leaks."""
    with np.errstate(divide="ignore"):
        return 1 / _admittance(np.zeros_like(paths), paths, resistivity, 0.0).real


def capacitance_of(impedance: complex | np.ndarray, frequency: Numbers) -> Numbers:
    """C in F of a measured Z (ohm, complex): -sin(phi)/(omega |Z|), phi = arg Z."""
    return laws.capacitance_of_impedance(np.real(impedance), np.imag(impedance), frequency)[()]


def resistance_of(impedance: complex | np.ndarray) -> Numbers:
    """R in ohm in parallel with the C of `capacitance_of`: |Z|/cos(phi). Infinite without leakage.

    >>> z = impedance(2e-10, 1e4, 5e5)
    >>> print(f"{capacitance_of(z, 1e4):.3e} F, {resistance_of(z):.3e} ohm")
    2.000e-10 F, 5.000e+05 ohm
    """
    return laws.resistance_of_impedance(np.real(impedance), np.imag(impedance))[()]


def _positive(frequency):
    frequency = np.asarray(frequency, float)
    if not np.all(frequency > 0):
        raise ValueError(f"frequency = {frequency} Hz must be positive")


def _admittance(capacitances, paths, resistivity, frequency):
    """Admittance in S of the balls in parallel, from `capacitances` (F) and `paths` (m) of inner
    and outer films (..., Z), at `frequency` (Hz)."""
    capacitance, conductance, frequency = np.broadcast_arrays(
        np.stack(capacitances, axis=-2),
        np.stack(paths, axis=-2) / resistivity,
        np.asarray(frequency, float)[..., None, None],
    )
    *shape, _, balls = capacitance.shape
    real, imaginary = np.empty(shape), np.empty(shape)
    core.library().call(
        "bearing_admittances",
        points=real.size,
        balls=balls,
        frequency=frequency[..., 0, 0],
        capacitance=capacitance,
        conductance=conductance,
        real=real,
        imaginary=imaginary,
    )
    return (real + 1j * imaginary)[()]


def plates_thickness(capacitance: Numbers, area: Numbers, permittivity: Numbers) -> Numbers:
    """h in m if C belongs to the plates alone: eps_0 eps A/C, A = pi a b in m^2. Too small if C
    includes other capacitance."""
    return VACUUM * permittivity * area / capacitance


def film_scale(capacitance: float, whole: Callable[[float], float]) -> float:
    """Common factor on all films of a model that gives a measured `capacitance` (F); `whole` is the
    model's capacitance in F as a decreasing function of that factor.

    Raises `ValueError` if no factor from 1e-3 to 1e3 fits: the reading then includes another
    capacitance.

    >>> round(film_scale(2e-10, lambda scale: 1e-10 / scale), 6)
    0.5
    """
    least, most = whole(THICKEST), whole(THINNEST)
    if not least <= capacitance <= most:
        raise ValueError(
            f"capacitance = {capacitance} F: films from {THINNEST:g} to {THICKEST:g} times as thick"
            f" as in the model have {most:.4g} to {least:.4g} F"
        )
    log = brentq(
        lambda step: whole(float(np.exp(step))) - capacitance,
        np.log(THINNEST),
        np.log(THICKEST),
        xtol=1e-12,
    )
    return float(np.exp(log))


def bearing_voltage_ratio(
    winding_rotor: Numbers, stator_rotor: Numbers, *bearings: Numbers
) -> Numbers:
    """BVR = C_wr/(C_wr + C_rf + the bearings' C): shaft voltage of a motor over the common-mode
    voltage of its windings. All in F.

    >>> round(float(bearing_voltage_ratio(50e-12, 1e-9, 200e-12, 200e-12)), 5)
    0.03448
    """
    return winding_rotor / (winding_rotor + stator_rotor + sum(bearings))
