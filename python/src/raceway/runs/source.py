# SPDX-License-Identifier: GPL-2.0-or-later
"""Interface to a source of signals: a simulated run, or a recording of a real bearing.

Spectra, envelopes, pictures and spall lengths require only a `Source`, so they can be used for runs
and recordings in the same way.
"""

from typing import NamedTuple, Protocol

from raceway.arrays import Floats
from raceway.runs.turning import Motion
from raceway.theory.bearing import Bearing


class Signal(NamedTuple):
    """Evenly sampled values of a column or channel."""

    values: Floats  # (N,)
    sample_s: float  # s, time between successive values
    attrs: dict[str, str]  # units and long_name


class Source(Protocol):
    """The common interface of `Run` and `recording.Recording`."""

    @property
    def geometry(self) -> Bearing:
        """The bearing that the signals come from."""

    @property
    def motion(self) -> Motion:
        """Mean speeds; NaN for unknown speeds."""

    @property
    def nominal_angle(self) -> float:
        """Contact angle in rad of the unloaded bearing."""

    @property
    def where(self) -> str:
        """Folder or file that is named in messages."""

    @property
    def title(self) -> str:
        """One-line description of the operating point, for pictures."""

    def signal(self, name: str, ring: str = "inner") -> Signal:
        """Return the `Signal` of a column of a ring, or of a channel.

        Raise `RacewayError` if there is no such signal.
        """

    def shaft_angle(self, samples: int) -> Floats:
        """Return the angle (`samples`,) in rad of the inner ring relative to the outer ring at the
        samples of a signal."""

    def shaft_speed(self, samples: int) -> Floats:
        """Return the speed (`samples`,) in rad/s of the inner ring relative to the outer ring at
        the samples of a signal."""
