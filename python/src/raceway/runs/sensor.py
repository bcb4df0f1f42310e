# SPDX-License-Identifier: GPL-2.0-or-later
"""Signal of an accelerometer on a ring or its housing, i.e. the record at a lower sampling rate.

A record from the integrator `vibration` has several samples for each sample of the sensor. A filter
removes the frequencies above half of the lower rate before samples are dropped. Noise is optional.
"""

import math
from collections.abc import Sequence

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike
from scipy import signal
from scipy.interpolate import CubicSpline

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.run import Run

PASSED = 0.4  # pass band relative to the new rate; its ripple is STOPPED dB below the signal
STOPPED = 80.0  # dB, attenuation above half the new rate
# values per new sample, at least, between which a cubic spline interpolates with an error of 1e-5
DENSE = 8
ENDS = 25  # values at either end that the filter affects


def decimated(values: ArrayLike, sample_s: float, rate: float) -> Floats:
    """Resample evenly sampled `values` (N,), which are `sample_s` apart, at `rate` in Hz.

    Return an array (M,) with the same unit and the same start. The two rates need not be
    commensurable: a Kaiser-windowed FIR filter without delay is evaluated at `DENSE` or more values
    per new sample, between which a spline interpolates. The filter is flat up to 0.4 times the rate
    and 80 dB down above half of the rate; its end effects extend over about 25 values at either
    end. Raise `ValueError` if the rate is above that of the values or leaves nothing but ends.

    >>> time = np.arange(19200) / 192e3
    >>> kept = decimated(np.sin(2 * np.pi * 5e3 * time), 1 / 192e3, 48e3)
    >>> wrong = kept - np.sin(2 * np.pi * 5e3 * np.arange(len(kept)) / 48e3)
    >>> print(len(kept), abs(wrong[50:-50]).max() < 2e-4)
    4800 True
    >>> gone = decimated(np.sin(2 * np.pi * 30e3 * time), 1 / 192e3, 48e3)
    >>> print(abs(gone[50:-50]).max() < 2e-4)
    True
    """
    values = np.asarray(values, float)
    share = rate * sample_s
    if not 0 < share <= 1 + 1e-9:
        raise ValueError(f"rate {rate:g} Hz must lie between 0 and {1 / sample_s:g} Hz")
    if share > 1 - 1e-9:
        return values.copy()
    count = math.ceil(len(values) * share * (1 - 1e-12))
    if count < 2 * ENDS:
        raise ValueError(
            f"rate {rate:g} Hz leaves {count} values of {len(values) * sample_s:g} s, fewer than"
            f" the {2 * ENDS} at which the filter starts and ends"
        )
    up, down = math.ceil(DENSE * share), max(1, math.floor(1 / (DENSE * share)))
    # half of the new rate divided by half of the filter's rate, which is `up` times the rate of
    # the values
    edge = share / up
    taps, beta = signal.kaiserord(STOPPED, edge * (1 - 2 * PASSED))
    window = signal.firwin(taps | 1, edge * (0.5 + PASSED), window=("kaiser", beta))
    mean = values.mean()  # subtracted to avoid a step at the ends
    dense = signal.resample_poly(values - mean, up, down, window=window)
    between = CubicSpline(np.arange(len(dense)), dense)
    return between(np.arange(count) * (up / (down * share))) + mean


def of_run(
    run: Run,
    name: str = "ay",
    ring: str = "outer",
    rate: float | None = None,
    noise: float = 0.0,
    seed: int | Sequence[int] | None = None,
) -> xr.DataArray:
    """Return the sensor signal of a column of a ring of `run` as a `DataArray` (time) in the unit
    of the column.

    `ring` is "inner" or "outer", and `rate` is in Hz (None: as recorded). `noise` is the standard
    deviation of white noise in the unit of the column, generated from `seed`; 0 adds no noise. A
    fixed outer ring has no acceleration, so the deck must have a housing.

    Raise `RunError` if the run has no such column, if the ring does not move, or if the rate is not
    valid for `decimated`.
    """
    values, sample_s, attrs = run.signal(name, ring)
    if not np.ptp(values) > 0:
        raise RunError(
            f"{run.tables.folder}: {name} of the {ring} ring does not change; a sensor needs a ring"
            " that is free, and an outer ring is free in a housing (-var housing springs)"
        )
    if rate is not None:
        try:
            values = decimated(values, sample_s, rate)
        except ValueError as error:
            raise RunError(f"{run.tables.folder}: {error}") from None
        sample_s = 1 / rate
    if noise:
        values = values + np.random.default_rng(seed).normal(0.0, noise, len(values))
    time = np.arange(len(values)) * sample_s
    attrs = dict(attrs, ring=ring, sample_s=sample_s, noise=noise)
    return xr.DataArray(values, {"time": ("time", time, {"units": "s"})}, name=name, attrs=attrs)
