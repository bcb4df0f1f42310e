# SPDX-License-Identifier: GPL-2.0-or-later
"""A bearing with signals: a run of the simulation, or a recording of a real bearing.

Spectra, envelopes, pictures and spall lengths require only a `Source`, so they apply to runs and
recordings in the same way.
"""

from typing import NamedTuple, Protocol

from raceway.arrays import Floats
from raceway.runs.turning import Motion
from raceway.theory.bearing import Bearing


class Signal(NamedTuple):
    """Evenly sampled values of one column or channel."""

    values: Floats  # (N,)
    sample_s: float  # s from one value to the next
    attrs: dict[str, str]  # units, long_name


class Source(Protocol):
    """The common interface of `Run` and `recording.Recording`."""

    @property
    def geometry(self) -> Bearing:
        """The bearing."""

    @property
    def motion(self) -> Motion:
        """Mean speeds; NaN for unknown speeds."""

    @property
    def nominal_angle(self) -> float:
        """Contact angle in rad without load."""

    @property
    def where(self) -> str:
        """Folder or file, for messages."""

    @property
    def title(self) -> str:
        """Operating point in one line, for pictures."""

    def signal(self, name: str, ring: str = "inner") -> Signal:
        """`Signal` of a column of a ring, or of a channel. Raises `RacewayError`."""

    def shaft_angle(self, samples: int) -> Floats:
        """Angle (`samples`,) in rad of the inner relative to the outer ring at the samples of a
        signal."""

    def shaft_speed(self, samples: int) -> Floats:
        """Speed (`samples`,) in rad/s of the inner relative to the outer ring at the samples of a
        signal."""
