# SPDX-License-Identifier: GPL-2.0-or-later
"""Spectra of evenly sampled columns of a run, and the lines expected from the kinematics of the
bearing.

A perfect bearing shows BPFO and its harmonics, because its stiffness varies as the balls pass the
load. The other lines (FTF, BSF, BPFI) need an irregularity, such as an odd ball or a flaw; without
one, they are reported as not found.

An order is a multiple of the speed of the inner ring relative to the outer ring. If this speed
changes, spectra are functions of order instead of frequency (`runs.order_tracking`).
"""

import math
from typing import NamedTuple

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike
from scipy import fft, signal

from raceway.arrays import Floats
from raceway.runs import order_tracking
from raceway.runs.source import Signal, Source
from raceway.theory import kinematics
from raceway.theory.bearing import Bearing

# The side lobes of the four-term Blackman-Harris window are 92 dB below the line, so a faint line
# is visible next to a strong one. Near the peak, its logarithm is a parabola to within 1e-3 of a
# bin. The main lobe is 8 bins wide (Harris, Proc. IEEE 66 (1978) 51).
WINDOW, HALF_WIDTH = "blackmanharris", 4
PAD = 8  # minimum number of values per bin of width 1/duration
# minimum number of periods in the record that separates a line from the mean
RESOLVED = HALF_WIDTH + 1.5
STANDS_OUT = 10.0  # minimum amplitude of a line, in multiples of the median around it
FAINT = 1e-4  # minimum amplitude relative to the strongest line; side lobes are at 2.5e-5
NAMES = {"cage": "FTF", "spin": "BSF", "outer": "BPFO", "inner": "BPFI"}
SHAFT = "shaft"  # rotation of the inner ring, for instance due to unbalance
# lines added if the outer ring rotates: its rotation, and the rate at which balls pass the load
OUTER_RING, COMPLIANCE = "outer ring", "VC"


class Line(NamedTuple):
    """An expected line of a spectrum, and the line that was found."""

    name: str  # FTF, BSF, BPFO, BPFI, shaft, outer ring, VC
    harmonic: int
    order: float  # order in the run, a multiple of the inner ring's speed relative to the outer one
    expected: float  # value for rolling without slip, in `unit`
    found: float  # peak nearest to `by_cage`; NaN if there is no distinct peak
    difference: float  # found/expected - 1
    amplitude: float  # peak, or value of the spectrum at `by_cage`, in the unit of the signal
    prominence: float  # ratio of the amplitude to the median of the spectrum around it
    note: str  # reason why nothing was found, or ""
    by_cage: float = math.nan  # value for the cage and balls of the run, including their slip
    unit: str = "Hz"  # unit of expected, found and by_cage; "order" if the speed changes


def spectrum(values: ArrayLike, sample_s: float) -> xr.DataArray:
    """Return the one-sided amplitude spectrum of evenly sampled `values` (array), which are
    `sample_s` apart, as a `DataArray` (frequency) with frequencies in Hz.

    The values are detrended and a Blackman-Harris window is applied; a sine of amplitude A has a
    peak of A. Zero padding makes the frequency spacing finer than the resolution of the record
    (`attrs["resolution"]`, Hz).

    Raise `ValueError` if there are fewer than 32 values or if a value is not finite.

    >>> time = np.arange(2000) * 1e-3
    >>> one = spectrum(3.0 + 2.0 * np.sin(2 * np.pi * 123.4 * time), 1e-3)
    >>> hertz, difference, amplitude, *_ = find(one, 123.0)
    >>> print(f"{hertz:.3f} Hz, {difference:+.2%}, {amplitude:.3f}")
    123.400 Hz, +0.33%, 2.000
    """
    values = np.asarray(values, dtype=float)
    if values.ndim != 1 or len(values) < 32 or not np.isfinite(values).all():
        raise ValueError(f"a spectrum needs a row of at least 32 finite values, not {values.shape}")
    window = signal.get_window(WINDOW, len(values))
    size = fft.next_fast_len(PAD * len(values), real=True)
    amplitude = np.abs(fft.rfft(signal.detrend(values) * window, size)) * 2 / window.sum()
    frequency = fft.rfftfreq(size, sample_s)
    result = xr.DataArray(
        amplitude, {"frequency": ("frequency", frequency, {"units": "Hz"})}, name="amplitude"
    )
    result.attrs["resolution"] = 1 / (len(values) * sample_s)
    return result


def of_run(
    run: Source, name: str = "shift", ring: str = "inner", orders: bool | None = None
) -> xr.DataArray:
    """Return the `spectrum` of one column of `run` (from `raceway.open`) for the given `ring`.

    The columns of the "inner" ring are `shift`, `x`, `fy`, `mz`, `ay`, `capacitance` ...; the
    "outer" ring has only columns of motion and force. For a recording (`raceway.recording`), `name`
    is a channel.

    The dimension of the result is frequency (Hz), or order if the shaft speed changes by more than
    1 %; `orders` overrides this choice. Raise `RunError` if the run has no such column or too few
    samples, or if the shaft reverses.
    """
    return of_signal(run, run.signal(name, ring), orders)


def of_signal(of: Source, signal: Signal, orders: bool | None = None) -> xr.DataArray:
    """Return the `spectrum` of a `signal` of a run or recording `of`; see `of_run` for details."""
    values, spacing, tracked = order_tracking.tracked(of, signal, orders)
    result = spectrum(values, spacing)
    if tracked:
        result = result.rename(frequency="order")
        result["order"].attrs["units"] = "1"
    result.attrs.update(signal.attrs)
    return result


def signal_of(of: Source, name: str, ring: str = "inner") -> Floats:
    """Return the samples (N,) of a column of the "inner" or "outer" `ring` of a run, or of a
    channel of a recording. Raise `RacewayError` in the same cases as `of_run`."""
    return of.signal(name, ring).values


def expected(
    bearing: Bearing,
    inner: float,
    outer: float = 0.0,
    *,
    angle: float = 0.0,
    harmonics: int = 3,
    sidebands: bool = False,
    cage: float | None = None,
    spin: float | None = None,
) -> dict[tuple[str, int], tuple[float, float]]:
    """Return {(name, harmonic): (order, frequency in Hz)} for rings with the speeds `inner` and
    `outer` in Hz.

    The values follow from the kinematics of rolling balls. If the speed `cage` in Hz is given, FTF,
    BPFO and BPFI follow from it; if `spin`, the speed of the balls relative to the cage in Hz, is
    given, BSF follows from it.

    `sidebands` adds the sidebands of a flaw that is modulated by the load or the cage: BPFI with
    the shaft, BPFO with a rotating outer ring, and the even harmonics of BSF, which are the impact
    rate of a ball flaw, with FTF. Orders are NaN if the rings have no relative speed.
    """
    of = kinematics.frequencies(bearing, angle, inner, outer)._asdict()
    if cage is not None:
        of.update(cage=cage, outer=bearing.balls * (cage - outer))
        of.update(inner=bearing.balls * (inner - cage))
    if spin is not None:
        of.update(spin=spin)
    rates = {short: abs(of[name]) for name, short in NAMES.items()}
    rings = {SHAFT: abs(inner), OUTER_RING: abs(outer)}
    rates.update({name: hertz for name, hertz in rings.items() if hertz})
    if outer:
        rates[COMPLIANCE] = bearing.balls * rates["FTF"]
    found = {(name, n): n * hertz for name, hertz in rates.items() for n in range(1, harmonics + 1)}
    if sidebands:
        carried = (("BPFI", SHAFT, 1), ("BPFO", OUTER_RING, 1), ("BSF", "FTF", 2))
        for name, shift, each in (one for one in carried if one[1] in rates):
            for n in range(each, harmonics + 1, each):
                for sign in (1, -1):
                    key = f"{name}{'+' if sign > 0 else '-'}{shift}", n
                    found[key] = abs(n * rates[name] + sign * rates[shift])
    unit = abs(inner - outer) or math.nan
    return {key: (float(hertz / unit), float(hertz)) for key, hertz in found.items()}


def contact_angle(of: Source) -> float:
    """Return the contact angle in rad, which is the mean over the contacts of a run.

    If there are no contacts, return the nominal angle of the bearing or, if it is 0, the angle at
    which rolling balls give the cage speed.
    """
    motion, nominal = of.motion, of.nominal_angle
    if math.isfinite(motion.angle):
        return motion.angle
    if nominal or not motion.shaft or not math.isfinite(motion.cage):
        return nominal
    order = (motion.cage - motion.outer) / motion.shaft
    return math.acos(min(max(kinematics.cosine_of_cage(of.geometry, order), 0.0), 1.0))


def places(
    run: Source,
    angle: float | None = None,
    harmonics: int = 3,
    sidebands: bool = False,
    own: bool = True,
) -> dict[tuple[str, int], tuple[float, float]]:
    """Return the lines `expected` at the measured speeds of `run`.

    They apply to the speeds of its `own` cage and balls, or else to balls that roll at a contact
    `angle` in rad, which is `contact_angle` by default.
    """
    motion = run.motion
    hertz = {name: value / (2 * math.pi) for name, value in motion._asdict().items()}
    given = {"cage": hertz["cage"]} if own and math.isfinite(motion.cage) else {}
    if own and math.isfinite(motion.spin):
        given["spin"] = hertz["spin"]
    angle = contact_angle(run) if angle is None else angle
    of = run.geometry, hertz["inner"], hertz["outer"]
    return expected(*of, angle=angle, harmonics=harmonics, sidebands=sidebands, **given)


def lines(
    run: Source,
    found_in: xr.DataArray,
    harmonics: int = 3,
    angle: float | None = None,
    within: float = 0.005,
    sidebands: bool = False,
) -> list[Line]:
    """Return the kinematic lines of `run` in its spectrum `found_in` as a list of `Line`.

    `run` is from `raceway.open`, or a recording. A line is found if there is a peak that is at most
    `within` (relative to the frequency; or a tenth of the resolution) away from the line of the
    run's own cage and balls, exceeds the median around it by a factor of ten, is less than 80 dB
    below the strongest peak, and is closer to this line than to any other; the harmonics of a line
    are taken at the multiples of its lowest peak. The kinematics use the speeds of the run and the
    contact `angle` in rad as in `places`, without clearance. `sidebands` has the same meaning as in
    `expected`.
    """
    which = 0 if "order" in found_in.dims else 1
    rolling = places(run, angle, harmonics, sidebands, own=False)
    own_places = places(run, angle, harmonics, sidebands)
    here = {key: both[which] for key, both in own_places.items()}
    # The peak may also be a higher harmonic of balls or raceways than those requested.
    others = here | {
        key: both[which]
        for key, both in places(run, angle, 2 * harmonics).items()
        if key[0] in ("BPFO", "BPFI", "BSF")
    }
    peaks = {key: find(found_in, own, within) for key, own in here.items()}
    _move_to_peaks(others, peaks)
    result = []
    for (name, n), own in here.items():
        order, kinematic = own_places[name, n][0], rolling[name, n][which]
        found, _, amplitude, prominence, note = peaks[name, n]
        if not note:
            other = _nearest(others, found)
            if other != (name, n):
                found, note = math.nan, f"hidden by {other[0]} x {other[1]}"
        # kinematic is 0 if nothing rotates
        difference = found / kinematic - 1 if kinematic else math.nan
        numbers = order, kinematic, found, difference, amplitude, prominence
        unit = ("order", "Hz")[which]
        result.append(Line(name, n, *map(float, numbers), note, own, unit))
    return result


def _move_to_peaks(places, peaks):
    """Move the `places` {(name, harmonic): frequency} of cage, balls and raceways to the multiples
    of their lowest peak.

    A contact angle of some degrees moves the third harmonic of BPFO onto the second one of BPFI,
    for instance. That peak belongs to the line whose fundamental is there.
    """
    moved = set()
    for name, n in sorted((key for key in peaks if not peaks[key][-1]), key=lambda key: key[1]):
        found = peaks[name, n][0]
        if name in NAMES.values() and name not in moved and _nearest(places, found) == (name, n):
            places.update({key: key[1] * found / n for key in places if key[0] == name})
            moved.add(name)


def _nearest(places, found):
    return min(places, key=lambda key: abs(places[key] - found))


def find(
    found_in: xr.DataArray, hertz: float, within: float = 0.005
) -> tuple[float, float, float, float, str]:
    """Return (frequency, difference from `hertz`, amplitude, prominence, note) for the line of a
    `spectrum` near the frequency `hertz`, which is in Hz or orders like the axis of the spectrum.
    """
    frequency, amplitude = found_in[found_in.dims[0]].to_numpy(), found_in.to_numpy()
    resolution, step = found_in.attrs["resolution"], frequency[1]
    nothing = (math.nan, math.nan)
    if not hertz + HALF_WIDTH * resolution < frequency[-1]:
        return *nothing, math.nan, math.nan, "above half the sampling rate"
    here = amplitude[int(round(hertz / step))]
    if hertz < RESOLVED * resolution:
        return *nothing, here, math.nan, f"fewer than {RESOLVED:g} periods in the record"
    # An incomplete last period moves a peak by less than this.
    reach = max(within * hertz, resolution)
    low, high = int(np.ceil((hertz - reach) / step)), int(np.floor((hertz + reach) / step))
    top = low + int(np.argmax(amplitude[low : high + 1]))
    # The noise floor is taken on both sides of the main lobe, over three times its width.
    foot = int(round(HALF_WIDTH * resolution / step))
    far = 4 * foot
    floor = np.median(
        np.concatenate(
            [
                amplitude[max(top - far, foot) : max(top - foot, foot)],
                amplitude[top + foot : top + far],
            ]
        )
    )
    prominence = amplitude[top] / floor if floor > 0 else math.inf
    if amplitude[top] == 0 or not amplitude[top - 1] <= amplitude[top] >= amplitude[top + 1]:
        return *nothing, here, prominence, "no peak"
    if (
        prominence < STANDS_OUT
        or amplitude[top] < FAINT * amplitude[int(RESOLVED * resolution / step) :].max()
    ):
        return *nothing, here, prominence, "does not stand out"
    left, middle, right = np.log(amplitude[top - 1 : top + 2])
    offset = 0.5 * (left - right) / (left - 2 * middle + right)
    found = (top + offset) * step
    if abs(found - hertz) > max(within * hertz, resolution / 10):
        return *nothing, here, prominence, f"nearest peak at {found:.4g} Hz"
    return (
        found,
        found / hertz - 1,
        math.exp(middle - 0.25 * (left - right) * offset),
        prominence,
        "",
    )
