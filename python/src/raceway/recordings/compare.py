# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare a run with a recording: levels, and lines of the envelopes in orders of the shaft
speed."""

from typing import NamedTuple

import numpy as np
import xarray as xr

from raceway.errors import RunError
from raceway.recordings.recording import Level, Recording, level
from raceway.runs import envelope, sensor, spectrum
from raceway.runs.run import Run
from raceway.runs.source import Signal, Source
from raceway.runs.turning import changes

WITHIN = 0.01  # relative half-width of the range searched for a line in the recording


class Side(NamedTuple):
    """One side of a comparison, either a run or a recording."""

    title: str
    level: Level
    units: str
    rate: float  # Hz, sampling rate of the signal that is compared
    spectrum: xr.DataArray  # spectrum of the envelope against orders of the shaft speed
    shaft: float  # Hz, shaft speed


class Pair(NamedTuple):
    """A line in the run and in the recording; values of a line that was not found are NaN."""

    name: str
    harmonic: int
    nominal: float  # order for rolling at the nominal contact angle
    run: float  # order in the run
    recording: float  # order in the recording
    run_amplitude: float  # amplitude in the spectrum of the envelope
    recording_amplitude: float


class Comparison(NamedTuple):
    """A run and a recording, and the lines of both."""

    run: Side
    recording: Side
    band: tuple[float, float]  # Hz, band of both envelopes
    lines: list[Pair]


def compare(
    run: Run,
    recording: Recording,
    name: str = "ay",
    ring: str = "outer",
    channel: str = "",
    band: tuple[float, float] | None = None,
    harmonics: int = 3,
) -> Comparison:
    """Return the `Comparison` between a column of a `ring` of `run` and a `channel` of a
    `recording` of the same bearing.

    A run with a higher sampling rate than the recording is resampled to the rate of the recording
    (`sensor.decimated`). Both envelopes use the same `band` (Hz, Hz), which is by default the most
    impulsive band of the recording within the frequency range of the run. The rings of the
    recording rotate as those of the run do. Raise `RunError` in the same cases as
    `envelope.of_run`, for a given band outside this range, and for a run whose shaft is at rest or
    changes its speed.
    """
    if not run.motion.shaft or changes(run.shaft_speed()):
        raise RunError(f"{run.where}: orders require a shaft that rotates at a constant speed")
    recording = recording.turning_as(run.motion)
    heard = recording.signal(channel)
    own = _resampled(run, run.signal(name, ring), 1 / heard.sample_s)
    found = envelope.of_run(recording, channel, band, orders=False, highest=0.5 / own.sample_s)
    chosen = found.attrs["band"]
    try:
        inside = envelope.of_values(own.values, own.sample_s, *chosen)
    except ValueError as error:
        raise RunError(f"{run.where}: {error}") from None
    simulated = spectrum.of_signal(run, own._replace(values=inside), orders=False)
    pairs = zip(
        spectrum.lines(run, simulated, harmonics),
        spectrum.lines(recording, found, harmonics, within=WITHIN),
    )
    shafts = [abs(of.motion.shaft) / (2 * np.pi) for of in (run, recording)]
    lines = [
        Pair(
            one.name,
            one.harmonic,
            other.order,
            one.found / shafts[0],
            other.found / shafts[1],
            one.amplitude,
            other.amplitude,
        )
        for one, other in pairs
    ]
    sides = (_side(run, own, simulated), _side(recording, heard, found))
    return Comparison(*sides, chosen, lines)


def _resampled(run, signal: Signal, rate: float) -> Signal:
    if rate * signal.sample_s >= 1:
        return signal
    try:
        return signal._replace(
            values=sensor.decimated(signal.values, signal.sample_s, rate), sample_s=1 / rate
        )
    except ValueError as error:
        raise RunError(f"{run.where}: {error}") from None


def _side(of: Source, signal: Signal, found: xr.DataArray) -> Side:
    shaft = abs(of.motion.shaft) / (2 * np.pi)
    orders = found.assign_coords(frequency=found["frequency"] / shaft).rename(frequency="order")
    units = signal.attrs["units"]
    return Side(of.title, level(signal), units, 1 / signal.sample_s, orders, shaft)
