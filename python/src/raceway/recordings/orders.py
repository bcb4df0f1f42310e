# SPDX-License-Identifier: GPL-2.0-or-later
"""Orders of the lines of a bearing in a recording, and the contact angles that they imply."""

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import xarray as xr

from raceway.recordings.recording import Recording
from raceway.recordings.shaft_speed import FINE
from raceway.runs import envelope, spectrum
from raceway.theory import kinematics
from raceway.theory.bearing import Bearing

LINES = ("FTF", "BPFO", "BPFI", "BSF")
WITHIN = 0.01  # relative half-width of the range in which a line is searched for
SAME = 5e-4  # relative difference within which harmonics belong to the same line


class Order(NamedTuple):
    """Order of a line, i.e. a multiple of the shaft speed."""

    value: float
    uncertainty: float  # one standard deviation, including the uncertainty of the shaft speed
    harmonics: int  # number of harmonics that were found


class Angle(NamedTuple):
    """Contact angle of balls that roll without slip."""

    value: float  # rad; 0 if the line is explained by slip
    low: float  # rad, two standard deviations below the value
    high: float
    slip: float  # cage slip, as a fraction of the cage speed, that explains the line at angle 0


def of_recording(
    recording: Recording, channel: str = "", band: tuple[float, float] | None = None
) -> dict[str, Order]:
    """Return the `Order` of each line found in the envelope of a `channel`.

    The `band` (Hz, Hz) of the envelope has the same meaning as in `envelope.of_run`.
    """
    return of_spectrum(recording, envelope.of_run(recording, channel, band, orders=False))


def of_spectrum(recording: Recording, found_in: xr.DataArray) -> dict[str, Order]:
    """Return the `Order` of each line of `LINES` that is found in a spectrum of the `recording`.

    `found_in` is the `spectrum.spectrum` of a signal. The order of a line is computed from all its
    harmonics except those that disagree with the strongest one.
    """
    shaft, resolution = recording.rpm / 60, found_in.attrs["resolution"]
    found: dict[str, Order] = {}
    lines = [one for one in spectrum.lines(recording, found_in, within=WITHIN) if not one.note]
    for name in LINES:
        own = [one for one in lines if one.name == name]
        if not own:
            continue
        best = max(own, key=lambda one: one.prominence)
        place = best.found / best.harmonic
        own = [one for one in own if abs(one.found / one.harmonic / place - 1) < SAME]
        values = np.array([one.found / one.harmonic for one in own]) / shaft
        weight = np.array([one.harmonic for one in own]) ** 2.0
        mean = float(np.average(values, weights=weight))
        scatter = math.sqrt(float(np.average((values - mean) ** 2, weights=weight)) / len(own))
        fine = FINE * resolution / shaft / math.sqrt(weight.sum())
        speed = mean * recording.speed_uncertainty
        found[name] = Order(mean, math.hypot(fine, scatter, speed), len(own))
    return found


def angle(bearing: Bearing, name: str, order: float, uncertainty: float = 0.0) -> Angle:
    """Return the `Angle` at which the line `name` of `LINES` has this `order` if the outer ring is
    at rest. Raise `ValueError` for any other name and for an order that no angle explains.

    >>> b = Bearing(9, 7.94e-3, 15.55e-3, 23.49e-3, 4.0891e-3, 4.1685e-3)
    >>> lines = ("BPFO", 3.5972), ("BPFI", 5.4018)
    >>> [round(math.degrees(angle(b, *line).value), 1) for line in lines]
    [9.4, 9.8]
    """
    cosines = [_cosine(bearing, name, order + k * uncertainty) for k in (0.0, -2.0, 2.0)]
    if not 0 <= cosines[0] < 2:
        raise ValueError(f"{name} = {order:g} orders matches no contact angle of this bearing")
    found = [math.acos(min(max(one, 0.0), 1.0)) for one in cosines]
    nominal = kinematics.frequencies(bearing)
    cage = float(nominal.cage)
    slip = 0.0 if name == "BSF" else 1 - _cage(bearing, name, order) / cage
    return Angle(found[0], min(found), max(found), slip)


def _cage(bearing, name, order):
    if name == "FTF":
        return order
    return order / bearing.balls if name == "BPFO" else 1 - order / bearing.balls


def _cosine(bearing, name, order):
    if name not in LINES:
        raise ValueError(f"line '{name}' is not one of {', '.join(LINES)}")
    if name == "BSF":
        gamma = bearing.ball_radius / bearing.pitch_radius
        square = 1 - 2 * gamma * order  # negative for an order above that of any angle
        return math.copysign(math.sqrt(abs(square)), square) / gamma
    return kinematics.cosine_of_cage(bearing, _cage(bearing, name, order))


def words(bearing: Bearing, found: Mapping[str, Order]) -> str:
    """Return the orders of lines and their contact angles as text, with one row for each."""
    rows = [f"  {'line':<8}{'order':>10}{'+-':>10}{'angle':>10}{'from':>8}{'to':>8}"]
    for name, one in found.items():
        at = angle(bearing, name, one.value, one.uncertainty)
        cells = "".join(f"{math.degrees(value):>8.1f}" for value in (at.low, at.high))
        row = f"  {name:<8}{one.value:>10.5f}{one.uncertainty:>10.1e}"
        rows.append(row + f"{math.degrees(at.value):>9.1f}°{cells}")
        if at.slip > 0:
            rows[-1] += f"  or slip {at.slip:.3%} at 0°"
    return "\n".join(rows)
