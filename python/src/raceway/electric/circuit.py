# SPDX-License-Identifier: GPL-2.0-or-later
"""The circuit of a bearing over a run: voltages, currents and discharges
(docs/electric_circuit)."""

import warnings
from typing import NamedTuple

import numpy as np
import pandas as pd
import xarray as xr

from raceway.electric import films, network
from raceway.electric.breakdown import ArcCurrent, Breakdown, Failure, threshold
from raceway.electric.films import Films
from raceway.electric.leak import Leak
from raceway.electric.network import ENERGIES, Solution
from raceway.electric.outer import Motor, Outer
from raceway.electric.waveforms import FEWEST, PER_CYCLE, Table
from raceway.errors import RunWarning
from raceway.runs.run import Run
from raceway.theory.film_voltage import field

RACEWAYS = ("inner", "outer")
MOST = 100_000_000  # largest product of the numbers of films and points
LATE = 3  # ratio of field to strength above which a film fails too late
MEANINGS = {  # variables and their units
    "bearing_voltage": ("V", "voltage of the inner ring to the outer ring"),
    "driving_voltage": ("V", "voltage of the outer circuit"),
    "ball_voltage": ("V", "voltage of a ball to the outer ring"),
    "film_voltage": ("V", "voltage across a film, from the inner to the outer ring"),
    "field": ("V/m", "voltage across a film over its thickness"),
    "local_thickness": ("m", "thickness of a film minus the reduction by roughness"),
    "local_field": ("V/m", "voltage across a film over its local thickness; NaN if bridged"),
    "film_capacitance": ("F", "capacitance of a film"),
    "film_state": ("1", "0 capacitive, 1 leaking, 2 metallic"),
    "bearing_capacitance": ("F", "capacitance between the rings, balls without charge"),
    "bearing_voltage_ratio": ("1", "bearing voltage over common-mode voltage, by capacitances"),
    "threshold_voltage": (
        "V",
        "smallest bearing voltage at which a film fails, balls uncharged; 0 if one is bridged",
    ),
    "current": ("A", "mean current into the inner ring's films in the step that ends here"),
    "ball_charge": ("C", "charge of a ball"),
    "charge_error": (
        "C",
        "largest difference so far between a node's charge from currents and from voltages",
    ),
}
EVENT_UNITS = {
    "time": "s",
    "discharge": "1",
    "order": "1",
    "ball": "1",
    "raceway": "1",
    "azimuth": "rad",
    "from_load_line": "rad",
    "bearing_voltage": "V",
    "bearing_voltage_after": "V",
    "film_voltage": "V",
    "local_thickness": "m",
    "field": "V/m",
    "film_energy": "J",
    "energy": "J",
    "current": "A",
    "duration": "s",
    "current_density": "A/m2",
}


class Result(NamedTuple):
    """Result of `run`."""

    data: xr.Dataset  # (time, raceway, ball), units and meanings in `attrs`
    events: pd.DataFrame  # one row for each failed film; units in `attrs["units"]`


def run(
    of: Run | xr.Dataset | Films,
    outer: Outer,
    breakdown: Breakdown | None = None,
    leak: Leak | None = None,
    *,
    points: int | None = None,
    stray: float = 0.0,
) -> Result:
    """Solve the circuit of a bearing and of `outer` between its rings over the samples of `of`.

    `of` is a run from `raceway.open`, a dataset like the `contacts` of a run, or `Films` (which
    include leak and stray). Films fail by `breakdown` (None: never) and conduct by `leak` (None:
    not at all). `points` is the number of circuit steps per sample, with linear interpolation; None
    gives `PER_CYCLE` points per period of the voltage of `outer`. `stray` (F) is added to every
    film. If there is a discharge at a point, voltages of the dataset are values after the
    discharge. Events have the columns of `EVENT_UNITS`; `energy` includes the energy lost by other
    films. The peak `current`, the `duration` in which it falls to 1/e and the current density over
    all Hertz area are NaN without the breakdown's `arc`.

    Raises `RunError` if `of` lacks required data, `ValueError` for parameters out of range and
    for steps too long for the voltage of `outer`.
    """
    if isinstance(of, Films):
        if leak is not None or stray:
            raise ValueError("leak and stray already belong to the given films")
        coarse = of
    else:
        coarse = (films.of_run if isinstance(of, Run) else films.of_dataset)(of, leak, stray)
    _need_overlap(coarse.time, outer.waveform)
    fine = coarse.refined(_points(coarse, outer, points))
    terms = outer.terms(fine.time)
    limit = breakdown.limit(fine) if breakdown else None
    solution = network.solve(fine, terms, breakdown)
    data = _dataset(fine, outer, terms, solution, breakdown, limit)
    events = _events(fine, solution, breakdown)
    _warn_of_late(events, (fine.time[0], *terms.edges[:, 0]), breakdown)
    return Result(data, events)


def _points(coarse, outer, points):
    """Circuit points in a sample; the default follows from the shortest period of the voltage."""
    longest, shortest = np.diff(coarse.time).max(), outer.waveform.shortest
    least = int(np.ceil(min(FEWEST * longest / shortest * (1 - 1e-9), MOST)))
    if points is None:
        points = max(1, int(np.ceil(min(PER_CYCLE * longest / shortest, MOST))))
    # a step at the limit may exceed it by rounding
    elif points < least:
        raise ValueError(
            f"points = {points} must be at least {least}: a sample takes {longest:g} s, a"
            f" period of the voltage {shortest:g} s"
        )
    if points * coarse.capacitance.size > MOST:
        raise ValueError(
            f"points = {points} per sample and {coarse.capacitance.size} films are more than"
            f" {MOST:g} in all: a sample takes {longest:g} s, a period of the voltage"
            f" {shortest:g} s"
        )
    return points


def _need_overlap(time, waveform):
    if isinstance(waveform, Table):
        first, last = waveform.times[0], waveform.times[-1]
        if last <= time[0] or first >= time[-1]:
            raise ValueError(
                f"the table's times, {first:g} to {last:g} s, must overlap the times of the films,"
                f" {time[0]:g} to {time[-1]:g} s"
            )


def _dataset(fine, outer, terms, s, breakdown, limit):
    film = np.stack([s.bearing[:, None] - s.ball, s.ball], axis=1)
    place = ("time", "raceway", "ball")
    bearing = films.series(fine.capacitance).bearing
    data = {
        "bearing_voltage": ("time", s.bearing),
        "driving_voltage": ("time", terms.driving),
        "ball_voltage": (("time", "ball"), s.ball),
        "film_voltage": (place, film),
        "field": (place, field(film, fine.thickness)),
        "film_capacitance": (place, fine.capacitance),
        "film_state": (place, _states(fine)),
        "bearing_capacitance": ("time", bearing),
        "current": ("time", np.r_[np.nan, s.current[1:]]),
        "ball_charge": (("time", "ball"), s.ball_charge),
        "charge_error": ("time", s.charge_error),
    }
    if breakdown:
        local = breakdown.local_thickness(fine)
        data["local_thickness"] = (place, local)
        data["local_field"] = (place, field(film, _unbridged(local, breakdown)))
        data["threshold_voltage"] = ("time", threshold(fine, limit, breakdown.bridged))
    if isinstance(outer, Motor):
        ratio = terms.coupling / (terms.coupling + terms.beside(bearing) + bearing)
        data["bearing_voltage_ratio"] = ("time", ratio)
    made = xr.Dataset(
        data, coords={"time": fine.time, "raceway": list(RACEWAYS), "ball": fine.balls}
    )
    for name, (unit, meaning) in MEANINGS.items():
        if name in made:
            made[name].attrs = {"units": unit, "long_name": meaning}
    if breakdown:
        made["local_thickness"].attrs["floor"] = breakdown.floor
    for name in ("azimuth", "from_load_line"):
        made.coords[name] = (("time", "ball"), getattr(fine, name), {"units": "rad"})
    made["time"].attrs = {"units": "s", "long_name": "time since the start of the measured window"}
    for name, meaning in ENERGIES.items():
        made[name] = ("time", s.energies[name], {"units": "J", "long_name": meaning})
    return made


def _states(fine):
    state = np.where(fine.leaking & (fine.capacitance > 0), 1, 0)
    if fine.metallic is not None:
        state = np.where(fine.metallic > 0, 2, state)
    return state


def _events(fine, s: Solution, breakdown):
    if not s.failures:
        table = pd.DataFrame(columns=list(EVENT_UNITS))
    else:
        f = Failure(*(np.array(one) for one in zip(*s.failures)))
        at = _Between(fine.time, f.time)
        film = (f.raceway, f.ball)
        local = np.maximum(at(fine.thickness, *film) - breakdown.less(fine), breakdown.floor)
        peak, duration, area = at_arc = np.full((3, len(local)), np.nan)
        if breakdown.arc is not None:
            at_arc[:2] = ArcCurrent.of(f, breakdown.arc)
            if fine.hertz_area is not None:
                area[:] = at(fine.hertz_area)
        own = {
            "ball": fine.balls[f.ball],
            "raceway": np.array(RACEWAYS)[f.raceway],
            "azimuth": at.angle(fine.azimuth, f.ball),
            "from_load_line": at.angle(fine.from_load_line, f.ball),
            "local_thickness": local,
            "field": field(f.film_voltage, _unbridged(local, breakdown)),
            "current": peak,
            "duration": duration,
            "current_density": peak / np.where(area > 0, area, np.nan),
        }
        table = pd.DataFrame(f._asdict() | own)[list(EVENT_UNITS)]
    table.attrs["units"] = EVENT_UNITS
    return table


def _warn_of_late(events, sudden, breakdown):
    """Warn if the steps are so long that films fail far above their strength. Failures at the
    `sudden` times and failures that follow the failure of another film are exempt."""
    gradual = ~np.isin(events.time, sudden) & (events.order == 1)
    field = events.field[gradual].abs().max()
    if breakdown and field > LATE * breakdown.strength:
        warnings.warn(
            f"films fail late, at up to {field / breakdown.strength:.3g} times their strength: the"
            " voltage rises too fast for the steps of the circuit. Give more points",
            RunWarning,
            stacklevel=3,
        )


def _unbridged(local, breakdown):
    """Local thickness; NaN for a film at the floor, which asperities bridge."""
    return np.where(local > breakdown.floor, local, np.nan)


class _Between:
    """Interpolates arrays over the points `grid` linearly to `times`."""

    def __init__(self, grid, times):
        self.first = np.searchsorted(grid, times, "right") - 1
        self.last = np.minimum(self.first + 1, len(grid) - 1)
        self.share = (times - grid[self.first]) / (grid[self.last] - grid[self.first]).clip(1e-300)

    def __call__(self, values, *place):
        first, last = values[self.first, *place], values[self.last, *place]
        return np.where(self.share > 0, first + self.share * (last - first), first)

    def angle(self, values, *place):
        first, last = values[self.first, *place], values[self.last, *place]
        turn = np.angle(np.exp(1j * (last - first)))
        between = np.angle(np.exp(1j * (first + self.share * turn)))
        return np.where(self.share > 0, between, first)
