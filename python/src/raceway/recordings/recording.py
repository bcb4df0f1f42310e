# SPDX-License-Identifier: GPL-2.0-or-later
"""A recording of a real bearing as a source of signals.

Like a run, it can be passed to `spectrum`, `envelope`, `time_frequency` and `passages` and to
their pictures.
"""

import copy
import math
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.recordings import matlab, plain, shaft_speed
from raceway.recordings.contents import Contents
from raceway.runs.source import Signal
from raceway.runs.turning import Motion
from raceway.theory.bearing import Bearing
from raceway.units import prefixed

READERS: dict[str, Callable[[Path], Contents]] = {
    ".mat": matlab.read,
    ".npz": plain.read_npz,
    ".csv": plain.read_csv,
    ".txt": plain.read_csv,
    ".wav": plain.read_wav,
}


def contents(path: FilePath) -> Contents:
    """Return the `Contents` of the file `path`, whose type is given by the file name extension.

    Raise `RunError` if the file is missing or damaged, or if its type is unknown.
    """
    path = Path(path)
    if not path.is_file():
        raise RunError(f"there is no file {path}")
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise RunError(f"{path}: the name of a recording must end in {', '.join(READERS)}")
    return reader(path)


class Recording:
    """Signals in the file `path`, recorded at a `bearing` whose outer ring is at rest, unless
    `turning_as` states otherwise.

    The speed of the inner ring, `rpm` or `nominal` (both in rpm), and the sampling `rate` in Hz
    take precedence over the file; `nominal_angle` is the contact angle in rad of the unloaded
    bearing. The true speed is searched for near the nominal speed in the first channel
    (`shaft_speed.find`), but a given `rpm` is used unchanged. Raises `RunError` if the file cannot
    be read, or if neither the file nor the arguments give speed and rate.

    `load` is the load stated in the file (N, or NaN if it is unknown), `speed` is the
    `shaft_speed.Speed` that was found, or None, and `channels` maps names to `contents.Channel`.
    """

    def __init__(
        self,
        path: FilePath,
        bearing: Bearing,
        *,
        rpm: float | None = None,
        nominal: float | None = None,
        rate: float | None = None,
        nominal_angle: float = 0.0,
        name: str = "",
    ) -> None:
        self.where, self._name = str(path), name
        self._bearing, self._angle = bearing, nominal_angle
        # speeds of the rings as multiples of the speed of the inner relative to the outer ring
        self._turning = 1.0, 0.0
        found = contents(path)
        self.kind, self.load = found.kind, found.load
        self.channels = {
            key: one._replace(rate=one.rate if rate is None else rate)
            for key, one in found.channels.items()
        }
        first = next(iter(self.channels.values()))
        if not first.rate > 0:
            raise RunError(f"{path} does not state its sampling rate: give --rate HZ")
        self._given = rpm
        given = nominal if rpm is None else rpm
        self._measured = found.measured and given is None
        self.nominal_rpm = found.rpm if given is None else given
        if not self.nominal_rpm > 0:
            raise RunError(
                f"{path} does not state the speed of the shaft: give the true speed with --rpm R,"
                " or with --nominal R a speed near which it is searched for"
            )

    def turning_as(self, motion: Motion) -> "Recording":
        """Return the recording of a bearing whose rings have speeds at the ratio of those in
        `motion`; its `rpm` is the speed of the inner ring relative to the outer ring."""
        found = copy.copy(self)
        found._turning = motion.inner / motion.shaft, motion.outer / motion.shaft
        found.__dict__.pop("speed", None)
        return found

    @cached_property
    def speed(self) -> shaft_speed.Speed | None:
        """Speed found in the first channel; None if it is given, if there are no lines of it, or
        if both rings rotate, because their lines have other speeds."""
        if self._given is not None or all(self._turning):
            return None
        first = self.signal(next(iter(self.channels)))
        return shaft_speed.find(first.values, first.sample_s, self.nominal_rpm / 60)

    @property
    def rpm(self) -> float:
        """Speed of the shaft in rpm, as given, as found, or as stated in the file."""
        return 60 * self.speed.hertz if self.speed else self.nominal_rpm

    @property
    def speed_from(self) -> str:
        """Source of `rpm`: "given", "lines" of the shaft, or, if no lines show it, "file" for a
        measured or exact speed in the file and otherwise "nominal"."""
        if self._given is not None:
            return "given"
        return "lines" if self.speed else "file" if self._measured else "nominal"

    @property
    def speed_uncertainty(self) -> float:
        """Relative standard deviation of `rpm`: 0 if it is given or measured, and that of a uniform
        distribution around the nominal speed if the speed is only nominal."""
        if self.speed_from in ("given", "file"):
            return 0.0
        found = self.speed
        return found.uncertainty / found.hertz if found else shaft_speed.NEAR / math.sqrt(3)

    @property
    def geometry(self) -> Bearing:
        """The bearing that was recorded."""
        return self._bearing

    @property
    def nominal_angle(self) -> float:
        """Contact angle in rad of the unloaded bearing."""
        return self._angle

    @property
    def motion(self) -> Motion:
        """Mean speeds in rad/s; the speeds of cage and balls are unknown."""
        inner, outer = (share * self.rpm * math.pi / 30 for share in self._turning)
        return Motion(inner, outer, math.nan, math.nan, math.nan)

    @property
    def title(self) -> str:
        """One-line description with file, bearing, load and speed, and a note if the speed is only
        nominal."""
        known = [] if math.isnan(self.load) else [f"{prefixed(self.load, 'N', 3)} radial"]
        parts = (Path(self.where).name, f"{self._name} ball bearing".strip(), *known)
        note = " nominal" if self.speed_from == "nominal" else ""
        return "  ·  ".join((*parts, f"{self.rpm:.5g} rpm{note}"))

    def signal(self, name: str = "", ring: str = "") -> Signal:
        """Return the `Signal` of the channel `name`, which is the first channel by default.

        `ring` applies only to runs and is ignored. Raise `RunError` for an unknown channel and for
        a channel with fewer than 32 values.
        """
        name = name or next(iter(self.channels))
        if name not in self.channels:
            raise RunError(f"{self.where} has no channel {name}; it has {', '.join(self.channels)}")
        one = self.channels[name]
        if len(one.values) < 32:
            raise RunError(
                f"{self.where}: {name} has {len(one.values)} values: a spectrum needs 32"
            )
        if not one.rate > 0:
            raise RunError(f"{self.where} does not state the rate of {name}: give --rate HZ")
        return Signal(one.values, 1 / one.rate, {"units": one.units, "long_name": one.meaning})

    def shaft_angle(self, samples: int) -> Floats:
        """Return the angle (`samples`,) in rad at the samples of the first channel, assuming a
        constant speed."""
        first = next(iter(self.channels.values()))
        return self.rpm * math.pi / 30 / first.rate * np.arange(samples)

    def shaft_speed(self, samples: int) -> Floats:
        """Return the speed (`samples`,) in rad/s, which is constant."""
        return np.full(samples, self.rpm * math.pi / 30)


class Level(NamedTuple):
    """Level of a signal, and a measure of how impulsive it is."""

    rms: float  # root mean square of the signal without its mean, in the unit of the signal
    peak: float
    kurtosis: float  # 3 for noise


def level(signal: Signal) -> Level:
    """Return the `Level` of a signal; the kurtosis of a constant signal is NaN."""
    away = signal.values - signal.values.mean()
    rms = float(np.sqrt(np.mean(away**2)))
    kurtosis = float(np.mean((away / rms) ** 4)) if rms else math.nan
    return Level(rms, float(np.abs(away).max()), kurtosis)
