# SPDX-License-Identifier: GPL-2.0-or-later
"""Solve the circuit of a bearing over a run: voltages, currents and discharges
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
MOST = 100_000_000  # largest product of the number of films and the number of points
LATE = 3  # warn if the field in a gradually loaded film exceeds this multiple of the strength
MEANINGS = {  # {variable: (unit, meaning)}
    "bearing_voltage": ("V", "voltage of the inner ring relative to the outer ring"),
    "driving_voltage": ("V", "voltage of the outer circuit"),
    "ball_voltage": ("V", "voltage of a ball relative to the outer ring"),
    "film_voltage": ("V", "voltage across a film, from the inner to the outer ring"),
    "field": ("V/m", "voltage across a film divided by its thickness"),
    "local_thickness": ("m", "thickness of a film, reduced by the roughness"),
    "local_field": (
        "V/m",
        "voltage across a film divided by its local thickness; NaN if it is bridged",
    ),
    "film_capacitance": ("F", "capacitance of a film"),
    "film_state": ("1", "0 capacitive, 1 leaking, 2 metallic"),
    "bearing_capacitance": ("F", "capacitance between the rings if the balls are uncharged"),
    "bearing_voltage_ratio": (
        "1",
        "ratio of bearing voltage to common-mode voltage that follows from the capacitances",
    ),
    "threshold_voltage": (
        "V",
        "smallest bearing voltage at which a film fails if the balls are uncharged; 0 if one is"
        " bridged",
    ),
    "current": ("A", "mean current into the films of the inner ring during the step"),
    "ball_charge": ("C", "charge of a ball"),
    "charge_error": (
        "C",
        "largest difference so far between the charges of a node computed from the currents and"
        " from the voltages",
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
    """Solve the circuit that consists of a bearing and the circuit `outer` between its rings, for
    the samples of `of`.

    `of` is a run from `raceway.open`, a dataset with the same variables as the `contacts` of a run,
    or `Films` (which already include leak and stray). `breakdown` is the model of film failure
    (None: films never fail) and `leak` the model of film conduction (None: films do not conduct).
    `points` is the number of circuit steps per sample; the films are interpolated linearly between
    samples. By default there are `PER_CYCLE` points per period of the voltage of `outer`. `stray`
    (F) is added to the capacitance of every film.

    If there is a discharge at a point, the voltages in the dataset are those after the discharge.
    Events have the columns of `EVENT_UNITS`; `energy` includes the energy dissipated in other
    films. If `breakdown` does not specify an `arc`, the peak `current`, the `duration` in which it
    falls to 1/e and the current density (relative to the total Hertz area) are NaN.

    Raises `RunError` if `of` lacks required data, and `ValueError` if a parameter is out of range
    or the steps are too long for the voltage of `outer`.
    """
    if isinstance(of, Films):
        if leak is not None or stray:
            raise ValueError("leak and stray are already included in the given films")
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
    """Return the number of circuit points per sample. The default depends on the shortest period of
    the voltage."""
    longest, shortest = np.diff(coarse.time).max(), outer.waveform.shortest
    least = int(np.ceil(min(FEWEST * longest / shortest * (1 - 1e-9), MOST)))
    if points is None:
        points = max(1, int(np.ceil(min(PER_CYCLE * longest / shortest, MOST))))
    # the limit above includes a tolerance, because the step may exceed it by a rounding error
    elif points < least:
        raise ValueError(
            f"points = {points} must be at least {least}: a sample takes {longest:g} s, a"
            f" period of the voltage {shortest:g} s"
        )
    if points * coarse.capacitance.size > MOST:
        raise ValueError(
            f"points = {points} per sample for {coarse.capacitance.size} films exceed the limit of"
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
    `sudden` times are exempt, and so are failures that follow the failure of another film."""
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
    """Return the local thickness, with NaN for films at the floor, which are bridged by
    asperities."""
    return np.where(local > breakdown.floor, local, np.nan)


class _Between:
    """Linear interpolation, at `times`, of arrays that are given at the points `grid`."""

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
