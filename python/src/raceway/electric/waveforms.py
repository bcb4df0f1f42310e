# SPDX-License-Identifier: GPL-2.0-or-later
"""Voltages, as functions of time, that drive an outer circuit (docs/electric_circuit).

A waveform is called with an array of times (s) and returns volts. `shortest` is the shortest period
(s) of the voltage, or infinity if the voltage does not limit the step. `edges` are the kinks and
jumps of the voltage within a range of times.
"""

import warnings
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from raceway import core
from raceway.arrays import Floats
from raceway.core import laws
from raceway.errors import RunError
from raceway.files import FilePath

SINE, COMMON_MODE = 1, 2  # Waveform::Kind of src-package/core/electric/waveform.h
HIGHEST = 1e6  # V
PER_CYCLE, FEWEST = 20, 8  # default and minimum number of points per period


class Waveform(Protocol):
    """Interface of a voltage that drives an outer circuit."""

    @property
    def shortest(self) -> float:
        """The shortest period in s."""

    def __call__(self, time: Floats) -> Floats:
        """Return the voltage in V at the times `time` (s), an array of any shape."""

    def edges(self, time: Floats) -> Floats:
        """Return an array (k, 3) with the time (s) of every kink and jump between the increasing
        times `time` (n,), and the voltages (V) before and after it. The array is empty unless the
        method is overridden."""
        return np.empty((0, 3))


@dataclass(frozen=True)
class Constant(Waveform):
    """A constant `voltage` (V)."""

    voltage: float
    shortest = float("inf")

    def __post_init__(self) -> None:
        _volts("voltage", self.voltage)

    def __call__(self, time: Floats) -> Floats:
        """Return the voltage in V at the times `time` (s), an array of any shape."""
        return np.full(np.shape(time), float(self.voltage))


@dataclass(frozen=True)
class Sine(Waveform):
    """The voltage `amplitude` (V) times the sine of 2 pi `frequency` (Hz) t + `phase` (rad)."""

    amplitude: float
    frequency: float
    phase: float = 0.0

    def __post_init__(self) -> None:
        _volts("amplitude", self.amplitude)
        _positive("frequency", self.frequency, "Hz")

    @property
    def shortest(self) -> float:
        """The period in s."""
        return 1.0 / self.frequency

    def __call__(self, time: Floats) -> Floats:
        """Return the voltage in V at the times `time` (s), an array of any shape."""
        return laws.waveform(time, SINE, self.amplitude, self.frequency, self.phase, 0.0, 0.0)


@dataclass(frozen=True)
class CommonMode(Waveform):
    """Common-mode voltage of a two-level three-phase inverter, i.e. the mean of its three legs.

    A leg is at plus half the DC link voltage `link` (V) while `modulation` times the sine of its
    phase is greater than or equal to a triangular wave with the frequency `carrier` (Hz), and at
    minus half otherwise. `fundamental` (Hz) is the frequency of the phases. The voltage has four
    levels, +-link/2 and +-link/6.
    """

    link: float
    carrier: float
    fundamental: float
    modulation: float

    def __post_init__(self) -> None:
        _volts("link", self.link)
        _positive("carrier", self.carrier, "Hz")
        _positive("fundamental", self.fundamental, "Hz")
        if not 0 <= self.modulation <= 1:
            raise ValueError(f"modulation = {self.modulation:g} must lie from 0 to 1")
        if not self.carrier >= 2 * self.fundamental:
            raise ValueError(
                f"carrier = {self.carrier:g} Hz must be at least twice the fundamental,"
                f" {self.fundamental:g} Hz"
            )

    @property
    def shortest(self) -> float:
        """The period of the carrier in s."""
        return 1.0 / self.carrier

    def __call__(self, time: Floats) -> Floats:
        """Return the voltage in V at the times `time` (s), an array of any shape."""
        return laws.waveform(
            time, COMMON_MODE, self.link, self.fundamental, 0.0, self.carrier, self.modulation
        )

    def edges(self, time: Floats) -> Floats:
        """Return an array (k, 3) with the time (s) of each switching of a leg, and the voltages (V)
        before and after it."""
        most = 3 * int(2 * self.carrier * (time[-1] - time[0]) + 2)
        found = np.empty((most, 3))
        count = core.library().call(
            "inverter_edges",
            points=len(time),
            time=time,
            voltage=self.link,
            frequency=self.fundamental,
            carrier=self.carrier,
            modulation=self.modulation,
            most=most,
            out=found,
        )
        return found[:count]


@dataclass(frozen=True)
class Table(Waveform):
    """Linear interpolation between `voltages` (V) at the increasing `times` (s); the voltage is
    constant outside this range."""

    times: Floats
    voltages: Floats
    shortest = float("inf")

    def __post_init__(self) -> None:
        times, voltages = np.asarray(self.times, float), np.asarray(self.voltages, float)
        if times.ndim != 1 or times.shape != voltages.shape or len(times) < 2:
            raise ValueError("a table of voltages needs two columns with at least two rows")
        if not (np.isfinite(times).all() and np.isfinite(voltages).all()):
            raise ValueError("a table of voltages must contain only finite numbers")
        if np.abs(voltages).max() > HIGHEST:
            raise ValueError(f"voltages must lie from {-HIGHEST:g} to {HIGHEST:g} V")
        if not (np.diff(times) > 0).all():
            row = int(np.argmin(np.diff(times) > 0)) + 2
            raise ValueError(f"times in a table must increase: row {row} has {times[row - 1]:g} s")

    def __call__(self, time: Floats) -> Floats:
        """Return the voltage in V at the times `time` (s), an array of any shape."""
        return np.interp(time, self.times, self.voltages)

    def edges(self, time: Floats) -> Floats:
        """Return an array (k, 3) with the time (s) of each row of the table and its voltage (V),
        which is repeated in the third column."""
        times, voltages = np.asarray(self.times, float), np.asarray(self.voltages, float)
        inside = (times > time[0]) & (times <= time[-1])
        return np.stack([times, voltages, voltages], axis=1)[inside]


def read_table(path: FilePath) -> Table:
    """Read a `Table` from the text file `path`, in which each point is a row `s V`; # starts a
    comment.

    Raises `RunError` if the file cannot be read or does not contain such a table.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # of a file without rows
            rows = np.loadtxt(path, ndmin=2)
        if not rows.size:
            raise ValueError("it has no rows")
        if rows.shape[1] != 2:
            raise ValueError(f"{rows.shape[1]} columns, not 2")
        return Table(rows[:, 0], rows[:, 1])
    except (OSError, ValueError) as error:
        raise RunError(f"{path} is not a table of seconds and volts: {error}") from None


def _positive(name, value, unit):
    if not 0 < value < np.inf:
        raise ValueError(f"{name} = {value:g} {unit} must be positive")


def _volts(name, value):
    if not abs(value) <= HIGHEST:
        raise ValueError(f"{name} = {value:g} V must lie from {-HIGHEST:g} to {HIGHEST:g}")
