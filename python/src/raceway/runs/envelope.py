# SPDX-License-Identifier: GPL-2.0-or-later
"""Envelope spectra, which show the rate of impacts that excite a resonance.

A flaw excites the structure once per ball pass, and each impact rings at a natural frequency of the
structure. The spectrum of the signal shows the ringing. The spectrum of its envelope in the band of
the resonance shows the impact rate, with the sidebands of any modulation.
"""

import math
from typing import NamedTuple

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike
from scipy import fft, signal

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs import spectrum
from raceway.runs.source import Signal, Source

LEVELS = 6  # the narrowest bands are 1/64 of half the sampling rate
EDGE = 0.05  # fraction of the signal at each end that is tapered and not used to choose a band
CONSTANT = 1e-14  # largest variation of a constant signal relative to its values, due to rounding
ENOUGH = 64  # minimum number of values of an envelope from which a kurtosis is computed


class Band(NamedTuple):
    """A frequency band and a measure of how impulsive the signal is in it."""

    low: float  # Hz
    high: float  # Hz
    kurtosis: float  # spectral, from the complex envelope: 0 for noise, large for rare impacts


def of_values(values: ArrayLike, sample_s: float, low: float, high: float) -> Floats:
    """Return the envelope (N,) of evenly sampled `values` (N,) in the band from `low` to `high` in
    Hz.

    The samples are `sample_s` apart; the envelope has the unit of the values. It is the magnitude
    of the analytic signal after a Butterworth filter of order 4, which is run forwards and
    backwards so that it has no delay. Raise `ValueError` for a band outside the range from 0 to
    half the sampling rate.

    >>> time = np.arange(8000) / 8000
    >>> beat = (1 + 0.5 * np.cos(2 * np.pi * 20 * time)) * np.sin(2 * np.pi * 1000 * time)
    >>> found = of_values(beat, 1 / 8000, 800, 1200)
    >>> print(f"{found[1000:-1000].max():.2f} {found[1000:-1000].min():.2f}")
    1.50 0.50
    """
    values = np.asarray(values, float)
    nyquist = 0.5 / sample_s
    if low >= high:
        raise ValueError(f"band {low:g} to {high:g} Hz: the first must be below the second")
    if not 0 < low < high <= nyquist:
        raise ValueError(f"band {low:g} to {high:g} Hz must lie between 0 and {nyquist:g} Hz")
    passes = ((low, high), "bandpass") if high < nyquist else (low, "highpass")
    sections = signal.butter(4, *passes, fs=1 / sample_s, output="sos")
    return np.abs(signal.hilbert(signal.sosfiltfilt(sections, signal.detrend(values))))


def bands(values: ArrayLike, sample_s: float, narrowest: float = 0.0) -> list[Band]:
    """Return the spectral kurtosis of `values` (N,) in frequency bands.

    The samples are `sample_s` apart. The bands are halves, quarters ... of the range from 0 to half
    the sampling rate; no band is narrower than `narrowest` in Hz. The spectral kurtosis is
    E|x|^4/(E|x|^2)^2 - 2 of the complex envelope x (Antoni, Mech. Syst. Signal Process. 21 (2007)
    108), with brick-wall bands. The lowest band of each level is omitted because it contains the
    slow motion.
    """
    values = signal.detrend(np.asarray(values, float))
    lines = fft.rfft(values * signal.get_window(("tukey", 2 * EDGE), len(values)))
    nyquist, found = 0.5 / sample_s, []
    for level in range(1, LEVELS + 1):
        width = len(lines) >> level
        if width < ENOUGH or nyquist / 2**level < narrowest:
            break
        for k in range(1, 2**level):
            power = np.abs(fft.ifft(lines[k * width : (k + 1) * width])) ** 2
            power = power[int(EDGE * width) : width - int(EDGE * width)]
            mean = power.mean()
            if mean > 0:
                step = nyquist / 2**level
                found.append(Band(k * step, (k + 1) * step, np.mean(power**2) / mean**2 - 2))
    return found


def best_band(
    values: ArrayLike, sample_s: float, narrowest: float = 0.0, highest: float = math.inf
) -> Band:
    """Return the most impulsive of `bands` that end at most at the frequency `highest` in Hz.
    Raises `ValueError` if there are too few values for a band, or if the values are constant."""
    values = np.asarray(values, float)
    if values.size and np.ptp(values) <= CONSTANT * np.abs(values).max():
        raise ValueError("the signal is constant")
    found = [band for band in bands(values, sample_s, narrowest) if band.high <= highest]
    if not found:
        below = f" and below {highest:g} Hz" if highest < 0.5 / sample_s else ""
        raise ValueError(
            f"{np.size(values)} values, {sample_s:g} s apart, are too few to find a band wider"
            f" than {narrowest:g} Hz{below}"
        )
    return max(found, key=lambda band: band.kurtosis)


def of_run(
    run: Source,
    name: str,
    band: tuple[float, float] | None = None,
    ring: str = "inner",
    orders: bool | None = None,
    highest: float = math.inf,
) -> xr.DataArray:
    """Return the spectrum of the envelope of a column of a `ring` of `run`, or of a channel of a
    recording.

    The `band` (Hz, Hz) is by default the most impulsive one that is at least three times as wide as
    BPFI and ends at most at `highest` (Hz); `attrs["band"]` is the band used. The result is like
    that of `spectrum.of_run`. Raise `RunError` in the same cases as `spectrum.of_run`, and for a
    band that extends beyond half the sampling rate.
    """
    values, sample_s, attrs = run.signal(name, ring)
    passes = spectrum.places(run, harmonics=1)["BPFI", 1][1]
    try:
        chosen = band or best_band(values, sample_s, 3 * passes, highest)[:2]
        values = of_values(values, sample_s, *chosen)
    except ValueError as error:
        raise RunError(f"{run.where}: {error}") from None
    attrs = attrs | {"long_name": f"envelope of: {attrs['long_name']}"}
    result = spectrum.of_signal(run, Signal(values, sample_s, attrs), orders)
    result.attrs["band"] = tuple(map(float, chosen))
    return result
