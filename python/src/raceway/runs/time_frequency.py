# SPDX-License-Identifier: GPL-2.0-or-later
"""Amplitude over time and frequency, or over time and order where the shaft's speed changes.

Order tracking: the signal is resampled at even angles of the inner ring. Lines at multiples of the
shaft speed then stay at their order while the speed changes.
"""

import math

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike
from scipy import integrate, interpolate, signal

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs import envelope, spectrum
from raceway.runs.run import Run

WINDOW = "hann"
OVERLAP = 0.9  # overlap of successive windows, fraction of their length
PAD = 4  # values per bin of 1/window
ENVELOPE, SIGNAL = 12.0, 0.25  # periods of BPFO in a window: lines apart, or blows apart
STEADY = 0.01  # fraction of the mean speed: smaller changes are ignored
COLUMNS = 4  # least number of windows in a record


def spectrogram(values: ArrayLike, sample: float, window: float) -> xr.DataArray:
    """Amplitude of evenly sampled `values` (N,): `DataArray` (frequency, time) in their unit.

    `sample` is their spacing and `window` the length of a Hann window, both in the same unit: s or
    turns of the shaft. A sine of amplitude A over a whole window has amplitude A. The mean of each
    window is subtracted. Raises `ValueError` for values that are not finite, and for a window that
    is shorter than 16 samples or longer than a quarter of the record.

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
    magnitude[1:] *= 2.0  # both sides of the spectrum
    result = xr.DataArray(
        magnitude, {"frequency": frequency, "time": time}, ("frequency", "time"), "amplitude"
    )
    result.attrs["resolution"] = 1 / (size * sample)
    return result


def at_even_angles(values: ArrayLike, angle: ArrayLike) -> tuple[Floats, float]:
    """(`values` (M,) at even angles, their spacing in turns) from `values` (N,) at `angle` (N,) in
    rad, by cubic splines.

    Raises `ValueError` for an angle that is not strictly monotonic.
    """
    turns = np.asarray(angle, float) / (2 * math.pi)
    turns = np.abs(turns - turns[0])
    steps = np.diff(turns)
    if not (steps > 0).all():
        raise ValueError("the shaft must turn one way for an order axis")
    # no coarser than at the lowest speed either: what was sampled stays
    count = int(turns[-1] / steps.min()) + 1
    even = np.linspace(0.0, turns[-1], count)
    return interpolate.CubicSpline(turns, np.asarray(values, float))(even), even[1]


def of_run(
    run: Run,
    name: str = "ay",
    ring: str = "outer",
    *,
    band: tuple[float, float] | None = None,
    orders: bool | None = None,
) -> xr.DataArray:
    """`spectrogram` of a column of a `ring` of `run`, or, with a `band` (Hz, Hz), of its envelope.

    Dimensions are frequency (Hz) and time (s), or order (of the shaft) and time where the speed
    changes by more than 1 %; `orders` overrides the choice, and `attrs["orders"]` records it. A
    window has twelve periods of BPFO for an envelope, a quarter of one for the signal itself.
    Raises `RunError` as `spectrum.signal_of` does, for a record that is too short, and for a shaft
    that reverses.
    """
    values, sample_s = spectrum.signal_of(run, name, ring), run.settings["sample_s"]
    spin = run.rings["spin"].to_numpy()
    changes = np.ptp(spin) > STEADY * abs(spin.mean())
    orders = bool(changes) if orders is None else orders
    cage = spectrum.cage_order(run)
    shaft = abs(run.settings["rpm"]) / 60
    order = spectrum.expected(run.tables.geometry, shaft, harmonics=1, cage=cage)["BPFO", 1][0]
    try:
        if band is not None:
            values = envelope.of_values(values, sample_s, *band)
        window = (ENVELOPE if band else SIGNAL) / order  # turns
        if not orders:
            result = spectrogram(values, sample_s, window / shaft)
        else:
            angle = integrate.cumulative_trapezoid(spin, dx=sample_s, initial=0.0)
            even, step = at_even_angles(values, angle)
            result = spectrogram(even, step, window)
            turns = np.abs(angle) / (2 * math.pi)
            times = np.interp(result["time"], turns, np.arange(len(turns)) * sample_s)
            result = result.assign_coords(time=times).rename(frequency="order")
    except ValueError as error:
        raise RunError(f"{run.tables.record.path}: {error}") from None
    result["time"].attrs["units"] = "s"
    result[result.dims[0]].attrs["units"] = "1" if orders else "Hz"
    result.attrs.update(spectrum.of_column(name, ring), orders=orders)
    if band is not None:
        result.attrs["band"] = tuple(map(float, band))
        result.attrs["long_name"] = f"envelope of: {result.attrs['long_name']}"
    return result
