# SPDX-License-Identifier: GPL-2.0-or-later
"""Estimate the shaft speed from its harmonics in a signal and in the envelope of the signal.

The nominal speed of a motor under load is off by up to 1 %, which is ten times the slip of a cage.
Unbalance, misalignment and a flaw on the inner raceway cause lines at integer multiples of the true
speed. Mains and other machines cause lines as well, so the speed is determined from the largest
group of consistent multiples.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.runs import envelope, spectrum

HARMONICS = 6
NEAR = 0.015  # largest relative difference between the true and the nominal speed
AGREE = 0.04  # largest difference between two lines of the same shaft, in units of the resolution
FINE = 0.02  # uncertainty of the frequency of a line in noise, in units of the resolution


class Speed(NamedTuple):
    """Shaft speed found in a signal."""

    hertz: float
    uncertainty: float  # Hz, one standard deviation
    harmonics: int  # number of lines that agree


def find(values: ArrayLike, sample_s: float, nominal: float, within: float = NEAR) -> Speed | None:
    """Return the `Speed` of the shaft found in evenly sampled `values` (N,), or None.

    The samples are `sample_s` apart. The speed is searched for within a relative distance `within`
    of the `nominal` speed in Hz. The result is None if fewer than two harmonics agree. Harmonics
    with a common factor, such as the second, fourth and sixth, belong to another fundamental, often
    the mains frequency, and are not attributed to the shaft.

    >>> time = np.arange(120000) / 12000
    >>> tone = sum(np.sin(2 * np.pi * n * 29.53 * time + n) / n for n in (1, 2, 3))
    >>> mains = np.sin(2 * np.pi * 60 * time)
    >>> print(f"{find(tone + 0.1 * mains, 1 / 12000, 29.7).hertz:.3f} Hz")
    29.530 Hz
    """
    places, widths, numbers = _lines(np.asarray(values, float), sample_s, nominal, within)
    best: tuple[float, np.ndarray] = 0.0, np.zeros(0, bool)
    for place, width in zip(places, widths):
        near = np.abs(places - place) <= np.hypot(widths, width)
        weight = float((1 / widths[near] ** 2).sum())
        if near.sum() > 1 and np.gcd.reduce(numbers[near]) == 1 and weight > best[0]:
            best = weight, near
    weight, near = best
    if not near.any():
        return None
    parts = 1 / widths[near] ** 2
    mean = float((places[near] * parts).sum() / weight)
    scatter = np.sqrt((parts * (places[near] - mean) ** 2).sum() / weight)
    fine = FINE / AGREE / np.sqrt(weight)
    return Speed(mean, float(np.hypot(fine, scatter / np.sqrt(near.sum()))), int(near.sum()))


def _lines(values, sample_s, nominal, within) -> tuple[Floats, Floats, np.ndarray]:
    """Return the shaft speeds (N,) in Hz that follow from the harmonics found in the signal and its
    envelope, the widths (N,) in Hz within which two of them count as equal, and the numbers (N,) of
    the harmonics."""
    spectra = [spectrum.spectrum(values, sample_s)]
    try:
        band = envelope.best_band(values, sample_s, 8 * nominal)
        held = envelope.of_values(values, sample_s, band.low, band.high)
        spectra.append(spectrum.spectrum(held, sample_s))
    except ValueError:
        pass  # the sampling rate is too low for an envelope
    places, widths, numbers = [], [], []
    for one in spectra:
        for n in range(1, HARMONICS + 1):
            hertz, *_, note = spectrum.find(one, n * nominal, within)
            if not note:
                places.append(hertz / n)
                widths.append(AGREE * one.attrs["resolution"] / n)
                numbers.append(n)
    return np.array(places), np.array(widths), np.array(numbers, int)
