# SPDX-License-Identifier: GPL-2.0-or-later
"""Impedance of a film or bearing, and the inverse problem: capacitance, resistance and film
thickness from instrument readings. Functions accept numbers or arrays of equal shape in SI units;
frequencies are in Hz.

A film is modelled as a capacitor in parallel with its leak: Z = 1/(1/R + j omega C).
"""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import brentq

from raceway import core
from raceway.arrays import Floats, Numbers
from raceway.core import laws
from raceway.theory.capacitors import BearingCapacitors

THINNEST, THICKEST = 1e-3, 1e3  # search range of `film_scale`, relative to the model's films


def impedance(
    capacitance: Numbers, frequency: Numbers, resistance: Numbers = np.inf
) -> complex | np.ndarray:
    """Return the complex impedance Z in ohm of C (F) in parallel with R (ohm; infinite by default)
    at a frequency in Hz. Raises `ValueError` if the frequency is not positive."""
    _positive(frequency)
    found = laws.film_impedance(capacitance, 1 / np.asarray(resistance, float), frequency)
    return (found.real + 1j * found.imaginary)[()]


def of_bearing(
    found: BearingCapacitors, frequency: float | np.ndarray, resistivity: float = np.inf
) -> complex | np.ndarray:
    """Return Z in ohm of a bearing at a frequency (Hz; a number or an array) in an oil of the given
    `resistivity` (ohm m). Both films of a ball are in series, and the balls are in parallel."""
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
    """Return Z in ohm of a bearing from the `capacitances` (F) and `paths` (m) of the inner and
    outer films, which are arrays (..., Z); the frequency has the shape of the leading dimensions.
    Raises `ValueError` like `impedance`."""
    _positive(frequency)
    return 1 / _admittance(capacitances, paths, resistivity, frequency)


def leak_of_films(paths: Sequence[Floats], resistivity: float) -> Numbers:
    """Return the resistance R in ohm of a bearing to direct current, from the `paths` (m) of its
    inner and outer films (..., Z). It is infinite if nothing leaks."""
    with np.errstate(divide="ignore"):
        return 1 / _admittance(np.zeros_like(paths), paths, resistivity, 0.0).real


def capacitance_of(impedance: complex | np.ndarray, frequency: Numbers) -> Numbers:
    """Return C = -sin(phi)/(omega |Z|) in F from a measured Z (ohm, complex), with phi = arg Z."""
    return laws.capacitance_of_impedance(np.real(impedance), np.imag(impedance), frequency)[()]


def resistance_of(impedance: complex | np.ndarray) -> Numbers:
    """Return the resistance R = |Z|/cos(phi) in ohm that is in parallel with the C of
    `capacitance_of`. R is infinite without leakage.

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
    """Return the admittance in S of the balls in parallel, from the `capacitances` (F) and `paths`
    (m) of inner and outer films (..., Z), at `frequency` (Hz)."""
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


def film_scale(capacitance: float, whole: Callable[[float], float]) -> float:
    """Return the factor by which all film thicknesses of a model must be multiplied to obtain a
    measured `capacitance` (F). `whole` computes the model's capacitance in F, which decreases with
    that factor.

    Raises `ValueError` if no factor from 1e-3 to 1e3 fits. In that case the reading includes
    another capacitance.

    >>> round(film_scale(2e-10, lambda scale: 1e-10 / scale), 6)
    0.5
    """
    least, most = whole(THICKEST), whole(THINNEST)
    if not least <= capacitance <= most:
        raise ValueError(
            f"capacitance = {capacitance} F: films from {THINNEST:g} to {THICKEST:g} times as thick"
            f" as in the model give {most:.4g} to {least:.4g} F"
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
    """Return BVR = C_wr/(C_wr + C_rf + C of the bearings), the ratio of the shaft voltage of a
    motor to the common-mode voltage of its windings. All capacitances are in F.

    >>> round(float(bearing_voltage_ratio(50e-12, 1e-9, 200e-12, 200e-12)), 5)
    0.03448
    """
    return winding_rotor / (winding_rotor + stator_rotor + sum(bearings))
