# SPDX-License-Identifier: GPL-2.0-or-later
"""Amplitude as a function of time and frequency, or time and order if the shaft speed changes."""

import math

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike
from scipy import signal

from raceway.errors import RunError
from raceway.runs import envelope, order_tracking, spectrum
from raceway.runs.source import Source

WINDOW = "hann"
OVERLAP = 0.9  # overlap of successive windows, as a fraction of their length
PAD = 4  # values per bin of width 1/window
ENVELOPE, SIGNAL = 12.0, 0.25  # BPFO periods per window, which separate lines or impacts
COLUMNS = 4  # minimum number of windows in a record


def spectrogram(values: ArrayLike, sample: float, window: float) -> xr.DataArray:
    """Return the amplitude of evenly sampled `values` (N,) as a `DataArray` (frequency, time) in
    the unit of the values.

    `sample` is the spacing of the values and `window` the length of a Hann window, both in the same
    unit (s or shaft revolutions). A sine of amplitude A that lasts a whole window has amplitude A.
    The mean of each window is subtracted. Raise `ValueError` if a value is not finite, or if the
    window is shorter than 16 samples or longer than a quarter of the record.

    >>> time = np.arange(8000) / 4000
    >>> one = spectrogram(3.0 + 2.0 * np.sin(2 * np.pi * 500 * time), 1 / 4000, 0.1)
    >>> middle = one.isel(time=one.sizes["time"] // 2)
    >>> print(float(middle.idxmax()), round(float(middle.max()), 3))
    500.0 2.0
    """
    values = np.asarray(values, float)
    size = round(window / sample)
    if values.ndim != 1 or not np.isfinite(values).all():
        raise ValueError("a spectrogram needs a row of finite values")
    if not 16 <= size <= len(values) / COLUMNS:
        raise ValueError(
            f"window {window:g} must be {16 * sample:g} to {len(values) * sample / COLUMNS:g}, a"
            " quarter of the record"
        )
    frequency, time, magnitude = signal.spectrogram(
        values,
        1 / sample,
        WINDOW,
        nperseg=size,
        noverlap=int(OVERLAP * size),
        nfft=PAD * size,
        detrend="constant",
        scaling="spectrum",
        mode="magnitude",
    )
    magnitude[1:] *= 2.0  # one-sided spectrum
    result = xr.DataArray(
        magnitude, {"frequency": frequency, "time": time}, ("frequency", "time"), "amplitude"
    )
    result.attrs["resolution"] = 1 / (size * sample)
    return result


def of_run(
    run: Source,
    name: str = "ay",
    ring: str = "outer",
    *,
    band: tuple[float, float] | None = None,
    orders: bool | None = None,
) -> xr.DataArray:
    """Return the `spectrogram` of a column of a `ring` of `run`, or of a channel of a recording.

    If a `band` (Hz, Hz) is given, it is the spectrogram of the envelope in this band. The
    dimensions are frequency (Hz) and time (s), or order of the shaft speed and time if the speed
    changes by more than 1 %; `orders` overrides this choice, which `attrs["orders"]` records. A
    window lasts twelve periods of BPFO for an envelope and a quarter of a period for the signal
    itself. Raise `RunError` in the same cases as `spectrum.signal_of`, if the record is too short,
    and if the shaft reverses or is at rest.
    """
    values, sample_s, attrs = run.signal(name, ring)
    tracked = order_tracking.changes_speed(run, len(values)) if orders is None else orders
    order, hertz = spectrum.places(run, harmonics=1)["BPFO", 1]
    if not hertz:
        raise RunError(f"{run.where}: there are no ball passages, because the shaft is at rest")
    window = ENVELOPE if band else SIGNAL  # in BPFO periods
    try:
        if band is not None:
            values = envelope.of_values(values, sample_s, *band)
        if not tracked:
            result = spectrogram(values, sample_s, window / hertz)
        else:
            angle = run.shaft_angle(len(values))
            result = spectrogram(*order_tracking.at_even_angles(values, angle), window / order)
            turns = np.abs(angle) / (2 * math.pi)
            times = np.interp(result["time"], turns, np.arange(len(turns)) * sample_s)
            result = result.assign_coords(time=times).rename(frequency="order")
    except ValueError as error:
        short = band is not None and "window" in str(error)
        shorter = "; without the envelope a shorter record is enough" if short else ""
        raise RunError(f"{run.where}: {error}{shorter}") from None
    result["time"].attrs["units"] = "s"
    result[result.dims[0]].attrs["units"] = "1" if tracked else "Hz"
    result.attrs.update(attrs, orders=tracked, samples=len(values), sample_s=sample_s)
    if band is not None:
        result.attrs["band"] = tuple(map(float, band))
        result.attrs["long_name"] = f"envelope of: {result.attrs['long_name']}"
    return result
