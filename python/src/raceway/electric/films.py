# SPDX-License-Identifier: GPL-2.0-or-later
"""The films of a bearing as functions of time: capacitance, thickness and conductance of every
contact (docs/electric_circuit, Films)."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
import xarray as xr

from raceway.arrays import Floats, Integers
from raceway.electric.leak import Leak
from raceway.errors import RunError
from raceway.runs.run import Run

TOTAL, PLATES = "capacitance_total", "capacitance"  # columns; the first one is preferred
APART, FILM = "separation", "h_c"


@dataclass(frozen=True)
class Films:
    """Input of the network: the films of a bearing with Z balls at n points in time.

    Axis 1 is the raceway, where 0 is inner and 1 outer. A film with capacitance 0 is an open
    circuit and carries no displacement current.
    """

    time: Floats  # (n,) s, times in increasing order
    capacitance: Floats  # (n, 2, Z) F, capacitance of each film
    thickness: Floats  # (n, 2, Z) m, thickness of each film; NaN where there is no film
    conductance: Floats  # (n, 2, Z) S, conductance of each film
    azimuth: Floats  # (n, Z) rad, azimuths of the balls measured from x
    from_load_line: Floats  # (n, Z) rad, azimuths measured from the centre of the load zone
    balls: Integers  # (Z,) atom numbers of the balls
    roughness: float = 0.0  # m, composite roughness
    leaking: bool = False  # True if films conduct even without metallic contact
    metallic: Floats | None = None  # (n, 2, Z), 1 where asperities conduct
    hertz_area: Floats | None = None  # (n,) m^2, total area of all contact ellipses

    def __post_init__(self) -> None:
        if len(self.time) < 2 or not (np.diff(self.time) > 0).all():
            raise ValueError("films need at least two points in time, in increasing order")
        for name in ("capacitance", "conductance"):
            values = getattr(self, name)
            if not (np.isfinite(values).all() and (values >= 0).all()):
                raise ValueError(f"{name} of a film must be 0 or more, and finite")

    def every(self, count: int) -> "Films":
        """Return the films at every `count`-th point in time, starting with the first point."""
        kept = {name: getattr(self, name) for name in (*OVER_TIME, *ANGLES)}
        thin = {name: x if x is None else x[::count] for name, x in kept.items()}
        return replace(self, **thin)

    def refined(self, points: int) -> "Films":
        """Return the films with each step divided into `points` equal steps by linear
        interpolation.

        Raises `ValueError` unless `points` is a positive whole number.
        """
        if points < 1 or points != int(points):
            raise ValueError(f"points = {points} must be a positive whole number")
        if points == 1:
            return self
        turned = {name: np.unwrap(getattr(self, name), axis=0) for name in ANGLES}
        data = {name: getattr(self, name) for name in OVER_TIME} | turned
        fine = {
            name: None if values is None else _between(values, points)
            for name, values in data.items()
        }
        for name in ANGLES:
            fine[name] = np.mod(fine[name] + np.pi, 2 * np.pi) - np.pi
        return replace(self, **fine)


ANGLES = ("azimuth", "from_load_line")
OVER_TIME = ("time", "capacitance", "thickness", "conductance", "metallic", "hertz_area")


class Series(NamedTuple):
    """Capacitances of a bearing with uncharged balls."""

    ball: Floats  # (n, Z) F, inner and outer film of each ball connected in series
    bearing: Floats  # (n,) F, sum over the balls


def series(capacitance: Floats) -> Series:
    """Return the `Series` of films with `capacitance` (n, 2, Z) in F."""
    inner, outer = capacitance[:, 0], capacitance[:, 1]
    both = inner + outer
    ball = np.divide(inner * outer, both, out=np.zeros_like(both), where=both > 0)
    return Series(ball, ball.sum(axis=1))


def of_run(run: Run, leak: Leak | None = None, stray: float = 0.0) -> Films:
    """Return the films of `run` (from `raceway.open`). The capacitance of a film is the total
    capacitance of the contact (`capacitance_total`) if it is recorded, otherwise the capacitance of
    the contact patch.

    `leak` is the model of film conduction; `stray` (F) is added to the capacitance of every film.
    Raises `RunError` if the run lacks required data.
    """
    if run.settings["lubricant"] == "dry":
        raise RunError(f"{run.tables.folder}: a dry run has no films")
    contacts = run.contacts
    if contacts.sizes["time"] < 2:
        raise RunError(
            f"{run.tables.folder}: films over time need at least 2 samples, not"
            f" {contacts.sizes['time']}"
        )
    return of_dataset(
        contacts,
        leak,
        stray,
        permittivity=run.settings["permittivity"],
        roughness=run.settings["roughness_m"],
        balls=run.balls,
        name=str(run.tables.folder),
    )


def of_dataset(
    contacts: xr.Dataset,
    leak: Leak | None = None,
    stray: float = 0.0,
    *,
    permittivity: float | None = None,
    roughness: float = 0.0,
    balls: xr.Dataset | None = None,
    name: str = "the dataset",
) -> Films:
    """Return the films of a dataset with the dimensions time, raceway and ball, such as
    `run.contacts`. If a ring has two grooves, its two films on a ball are merged into one, because
    they are in parallel; the thinner one determines when the film fails.

    `permittivity` (1) is the relative permittivity of the lubricant at ambient pressure, and
    `roughness` (m) is the composite roughness. `balls` contains the azimuths of all balls; by
    default, the azimuths are taken from `contacts`. The Hertz area is computed from the columns a
    and b. Error messages begin with `name`. Raises `RunError` if a column is missing or a
    capacitance is not a number.
    """
    if not stray >= 0:
        raise ValueError(f"stray = {stray:g} F must be 0 or more")
    capacitance = _column(contacts, (TOTAL, PLATES), name)
    if not np.isfinite(capacitance).all():
        raise RunError(f"{name}: a capacitance is not a number")
    thickness = _column(contacts, (APART, FILM), name)
    conductance, metallic = np.zeros_like(capacitance), None
    if leak is not None:
        conductance, metallic = leak.of(capacitance, contacts, permittivity, name)
    if capacitance.shape[1] == 4:  # inner 0, inner 1, outer 0, outer 1
        thickness = np.fmin.reduce(_by_ring(np.where(capacitance > 0, thickness, np.nan)), axis=2)
        capacitance, conductance = (_by_ring(one).sum(2) for one in (capacitance, conductance))
        metallic = None if metallic is None else _by_ring(metallic).max(2)
    azimuth, line = (_angle(contacts, balls, angle) for angle in ANGLES)
    return Films(
        contacts["time"].to_numpy(),
        capacitance + stray,
        thickness,
        conductance,
        azimuth,
        line,
        contacts["ball"].to_numpy().astype(int),
        roughness,
        leak is not None and leak.resistivity is not None,
        metallic,
        _hertz_area(contacts),
    )


def _by_ring(values):
    """Reshape `values` to (n, 2, 2, Z), where axis 1 is the ring and axis 2 is the groove."""
    return values.reshape(len(values), 2, 2, -1)


def _hertz_area(contacts):
    if not {"a", "b"} <= set(contacts):
        return None
    area = np.pi * (contacts["a"] * contacts["b"]).fillna(0.0).sum(("raceway", "ball"))
    return area.to_numpy()


def _column(contacts, names, what):
    for one in names:
        if one in contacts:
            return contacts[one].transpose("time", "raceway", "ball").to_numpy().astype(float)
    raise RunError(
        f"{what} has neither the column {names[0]} nor {names[1]}; a run with a"
        " lubricant and fix bearing/capacitance has them"
    )


def _angle(contacts, balls, name):
    if balls is not None and name in balls.coords:
        return balls[name].transpose("time", "ball").to_numpy()
    if name not in contacts.coords:
        return np.full((contacts.sizes["time"], contacts.sizes["ball"]), np.nan)
    both = contacts[name].transpose("time", "raceway", "ball").to_numpy()
    found = both[:, 0]
    for other in range(1, both.shape[1]):
        found = np.where(np.isnan(found), both[:, other], found)
    return found


def _between(values, points):
    """Interpolate `values` (n, ...) linearly to (n - 1) `points` + 1 points, which include the
    original samples unchanged."""
    share = (np.arange(points) / points).reshape(1, -1, *(1,) * (values.ndim - 1))
    first, last = values[:-1, None], values[1:, None]
    fine = np.where(share == 0, first, first + share * (last - first))
    return np.concatenate([fine.reshape(-1, *values.shape[1:]), values[-1:]])
