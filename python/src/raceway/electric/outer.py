# SPDX-License-Identifier: GPL-2.0-or-later
"""Circuits between the rings of a bearing (docs/electric_circuit, Outer circuit).

The outer ring is the frame, at 0 V. Every outer circuit is reduced to `Terms`, which is the only
form that the network accepts.
"""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.electric.waveforms import Constant, Waveform


class Terms(NamedTuple):
    """Parameters of an outer circuit at the n points in time of a solution."""

    # F, capacitance between the inner ring and the frame, in parallel with the films
    capacitance: float
    factor: float  # further capacitance in parallel, as a multiple of the bearing capacitance
    coupling: float  # F, capacitance between the driving voltage and the inner ring
    # S, conductance parallel to the coupling; infinite if the inner ring is at the driving voltage
    conductance: float
    driving: Floats  # (n,) V, driving voltage
    edges: Floats  # (k, 3), time in s of each kink or jump, and voltages in V before and after it
    start: float  # V, initial voltage of an inner ring that is not driven by a voltage source

    @property
    def stiff(self) -> bool:
        """True if the inner ring is held at the driving voltage."""
        return np.isinf(self.conductance)

    def beside(self, bearing: Floats) -> Floats:
        """Return the capacitance in F in parallel with the films of a bearing whose own capacitance
        is `bearing` (F)."""
        return self.capacitance + self.factor * bearing


@dataclass(frozen=True)
class Floating:
    """No outer circuit. The inner ring keeps the charge that it has at the initial `voltage` (V).
    `capacitance` (F) is in parallel with the bearing."""

    voltage: float = 0.0
    capacitance: float = 0.0
    waveform: Waveform = field(default=Constant(0.0), init=False)

    def __post_init__(self) -> None:
        _not_negative("capacitance", self.capacitance, "F")

    def terms(self, time: Floats) -> Terms:
        """Return the `Terms` at the times `time` (s)."""
        return Terms(self.capacitance, 0.0, 0.0, 0.0, *_driving(self.waveform, time), self.voltage)


@dataclass(frozen=True)
class Source:
    """A voltage source `waveform` in series with a `resistance` (ohm), which may be 0.
    `capacitance` (F) is in parallel with the bearing."""

    waveform: Waveform
    resistance: float = 0.0
    capacitance: float = 0.0

    def __post_init__(self) -> None:
        _not_negative("resistance", self.resistance, "ohm")
        _not_negative("capacitance", self.capacitance, "F")

    def terms(self, time: Floats) -> Terms:
        """Return the `Terms` at the times `time` (s)."""
        conductance = 1.0 / self.resistance if self.resistance else np.inf
        return Terms(self.capacitance, 0.0, 0.0, conductance, *_driving(self.waveform, time), 0.0)


@dataclass(frozen=True)
class Motor:
    """The capacitances of a motor. The rotor is coupled to the common-mode voltage `waveform`
    through `winding_rotor` (F), and to the frame through `rotor_frame` (F) and the other bearing.

    The capacitance of the other bearing is either `second` (F) or `second_factor` times the
    capacitance of this bearing. `capacitance` (F) is in parallel with the bearing.
    """

    waveform: Waveform
    winding_rotor: float
    rotor_frame: float
    second: float = 0.0
    second_factor: float = 0.0
    capacitance: float = 0.0

    def __post_init__(self) -> None:
        if not self.winding_rotor > 0:
            raise ValueError(f"winding_rotor = {self.winding_rotor:g} F must be positive")
        for name in ("rotor_frame", "second", "capacitance"):
            _not_negative(name, getattr(self, name), "F")
        _not_negative("second_factor", self.second_factor, "")
        if self.second and self.second_factor:
            raise ValueError(
                "give the other bearing either as a capacitance or as a factor, not both"
            )

    def terms(self, time: Floats) -> Terms:
        """Return the `Terms` at the times `time` (s)."""
        beside = self.rotor_frame + self.second + self.capacitance
        driving = _driving(self.waveform, time)
        return Terms(beside, self.second_factor, self.winding_rotor, 0.0, *driving, 0.0)


Outer = Floating | Source | Motor


def _driving(waveform, time):
    return waveform(time), waveform.edges(time)


def _not_negative(name, value, unit):
    if not 0 <= value < np.inf:
        raise ValueError(f"{name} = {value:g} {unit} must be 0 or more".replace("  ", " "))
