# SPDX-License-Identifier: GPL-2.0-or-later
"""The circuit of a bearing that runs: voltages, currents and discharges (docs/electric_circuit)."""

from typing import NamedTuple

import numpy as np
import pandas as pd
import xarray as xr

from raceway.electric import films, network
from raceway.electric.breakdown import ArcCurrent, Breakdown, threshold
from raceway.electric.films import Films
from raceway.electric.leak import Leak
from raceway.electric.network import Solution
from raceway.electric.outer import Motor, Outer
from raceway.electric.waveforms import FEWEST, PER_CYCLE
from raceway.runs.run import Run
from raceway.theory.film_voltage import apparent_current_density, field

RACEWAYS = ("inner", "outer")
MEANINGS = {  # variables and their units
    "bearing_voltage": ("V", "voltage of the inner ring to the outer ring"),
    "driving_voltage": ("V", "voltage of the outer circuit"),
    "ball_voltage": ("V", "voltage of a ball to the outer ring"),
    "film_voltage": ("V", "voltage across a film, from the inner to the outer ring"),
    "field": ("V/m", "voltage across a film over its thickness"),
    "local_thickness": ("m", "thickness of a film less what the surfaces' roughness takes"),
    "local_field": ("V/m", "voltage across a film over its local thickness"),
    "film_capacitance": ("F", "capacitance of a film"),
    "film_state": ("1", "0 capacitive, 1 leaking, 2 metallic"),
    "bearing_capacitance": ("F", "capacitance between the rings, balls without charge"),
    "bearing_voltage_ratio": ("1", "bearing voltage over common-mode voltage, by capacitances"),
    "threshold_voltage": ("V", "smallest bearing voltage at which a film fails, balls uncharged"),
    "current": ("A", "mean current into the inner ring's films in the step that ends here"),
    "ball_charge": ("C", "charge of a ball"),
    "charge_error": ("C", "largest difference of a node's charge by currents and by voltages"),
    "stored_energy": ("J", "energy stored in films, beside them and in the coupling"),
    "source_work": ("J", "work of the driving voltage since the start"),
    "mechanical_work": ("J", "work that moving the plates of the films put in since the start"),
    "leak_heat": ("J", "heat in the conductance of films since the start"),
    "resistor_heat": ("J", "heat in the resistance of the source since the start"),
    "discharge_energy": ("J", "heat of discharges since the start"),
    "energy_error": ("J", "what the balance of energy lacks in the step and discharge ending here"),
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
    events: pd.DataFrame  # a row per film that failed; units in `attrs["units"]`


def run(
    of: Run | xr.Dataset | Films,
    outer: Outer,
    breakdown: Breakdown | None = None,
    leak: Leak | None = None,
    *,
    points: int | None = None,
    stray: float = 0.0,
) -> Result:
    """The circuit of a bearing and the circuit `outer` between its rings over the samples of `of`.

    `of` is a run from `raceway.open`, a dataset like its `contacts`, or `Films` (which have their
    own leak and stray). Films fail by `breakdown` (None: never) and conduct by `leak` (None: not at
    all). `points` is the number of circuit steps per sample, with linear interpolation; None gives
    `PER_CYCLE` points per period of the voltage of `outer`.
    `stray` (F) is added to every film. Voltages of the dataset are those after a discharge. Events
    have the columns of `EVENT_UNITS`; `energy` includes what the charges of other films lose. The
    peak `current`, the `duration` in which it falls to 1/e and the current density over all Hertz
    area are NaN without the breakdown's `arc`.

    Raises `RunError` where `of` lacks what is needed, `ValueError` for parameters out of range and
    for steps too long for the voltage of `outer`.
    """
    if isinstance(of, Films):
        if leak is not None or stray:
            raise ValueError("leak and stray belong to the films, which are given")
        coarse = of
    else:
        coarse = (films.of_run if isinstance(of, Run) else films.of_dataset)(of, leak, stray)
    fine = coarse.refined(_points(coarse, outer, points))
    terms = outer.terms(fine.time, films.series(fine.capacitance).bearing)
    limit = breakdown.limit(fine) if breakdown else None
    solution = network.solve(fine, terms, limit)
    data = _dataset(fine, outer, terms, solution, breakdown, limit)
    return Result(data, _events(fine, solution, breakdown))


def _points(coarse, outer, points):
    """A sample, with an eye on the shortest period of the voltage."""
    longest, shortest = np.diff(coarse.time).max(), outer.waveform.shortest
    if points is None:
        return max(1, int(np.ceil(PER_CYCLE * longest / shortest)))
    # a step at the limit may exceed it by rounding
    least = int(np.ceil(FEWEST * longest / shortest * (1 - 1e-9)))
    if points < least:
        raise ValueError(
            f"points = {points} must be at least {least}: a sample takes {longest:g} s, a"
            f" period of the voltage {shortest:g} s"
        )
    return points


def _dataset(fine, outer, terms, s, breakdown, limit):
    film = np.stack([s.bearing_voltage[:, None] - s.ball_voltage, s.ball_voltage], axis=1)
    place = ("time", "raceway", "ball")
    bearing = films.series(fine.capacitance).bearing
    data = {
        "bearing_voltage": ("time", s.bearing_voltage),
        "driving_voltage": ("time", terms.driving),
        "ball_voltage": (("time", "ball"), s.ball_voltage),
        "film_voltage": (place, film),
        "field": (place, field(film, fine.thickness)),
        "film_capacitance": (place, fine.capacitance),
        "film_state": (place, _states(fine)),
        "bearing_capacitance": ("time", bearing),
        "current": ("time", s.current),
        "ball_charge": (("time", "ball"), s.ball_charge),
        **{name: ("time", s.account[:, k]) for k, name in enumerate(network.ACCOUNT)},
    }
    if breakdown:
        local = breakdown.local_thickness(fine)
        data["local_thickness"] = (place, local)
        data["local_field"] = (place, field(film, local))
        data["threshold_voltage"] = ("time", threshold(fine, limit))
    if isinstance(outer, Motor):
        ratio = terms.coupling / (terms.coupling + terms.capacitance + bearing)
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
    return made


def _states(fine):
    state = np.where(fine.leaking & (fine.capacitance > 0), 1, 0)
    if fine.metallic is not None:
        state = np.where(fine.metallic > 0, 2, state)
    return state


def _events(fine, s: Solution, breakdown):
    rows = []
    if s.discharges:
        local = breakdown.local_thickness(fine)
        for number, (point, one) in enumerate(s.discharges.items(), 1):
            for order, failure in enumerate(one.failures, 1):
                place = {"discharge": number, "order": order}
                row = _row(fine, local[point], point, failure)
                rows.append(row | _arc(fine, point, failure, breakdown.arc) | place)
    table = pd.DataFrame(rows, columns=list(EVENT_UNITS))
    table.attrs["units"] = EVENT_UNITS
    return table


def _arc(fine, point, failure, arc):
    if arc is None:
        return dict.fromkeys(("current", "duration", "current_density"), np.nan)
    current = ArcCurrent.of(failure, arc)
    area = np.nan if fine.hertz_area is None else fine.hertz_area[point]
    return {
        "current": current.peak,
        "duration": current.duration,
        "current_density": apparent_current_density(current.peak, area) if area > 0 else np.nan,
    }


def _row(fine, local, point, failure):
    ball, thickness = failure.ball, local[failure.raceway, failure.ball]
    return {
        "time": fine.time[point],
        "ball": fine.balls[ball],
        "raceway": RACEWAYS[failure.raceway],
        "azimuth": fine.azimuth[point, ball],
        "from_load_line": fine.from_load_line[point, ball],
        "bearing_voltage": failure.bearing_voltage,
        "bearing_voltage_after": failure.bearing_voltage_after,
        "film_voltage": failure.film_voltage,
        "local_thickness": thickness,
        "field": field(failure.film_voltage, thickness),
        "film_energy": failure.film_energy,
        "energy": failure.energy,
    }
