# SPDX-License-Identifier: GPL-2.0-or-later
"""Total capacitance during a run, and the effect of a voltage on the films.

The total capacitance includes the contact patches, the gap around them and the unloaded balls. It
is computed from loads, films and ball positions with the closed-form solutions of `capacitors`.
"""

from typing import Any

import numpy as np
import xarray as xr

from raceway.errors import RunError
from raceway.runs import separation, warming
from raceway.runs.record_tables import ring_place
from raceway.runs.regimes import need_film
from raceway.runs.run import Run
from raceway.runs.tables import RunTables
from raceway.theory import (
    asperity,
    capacitance,
    capacitance_outside,
    capacitors,
    film_voltage,
)
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.capacitance_outside import FILLS
from raceway.theory.capacitors import FLOODED, Filling
from raceway.theory.steel import STEEL
from raceway.theory.validity import Shoulders

SIDES = ("inner", "outer")
RECORDED = {  # columns of a record that contains the total capacitance
    "separation": "separation",
    "plates": "capacitance",
    "outside": "capacitance_outside",
    "total": "capacitance_total",
}
ANGLES = ("azimuth", "from_load_line")
MEANING = {
    "load": ("N", "contact load"),
    "separation": ("m", "central film thickness, or play of an unloaded ball"),
    "area": ("m2", "area of the contact ellipse"),
    "plates": ("F", "capacitance of the contact ellipse"),
    "outside": ("F", "capacitance of the gap around the contact ellipse"),
    "paths": ("m", "ratio of the oil's resistivity to the resistance of the gap"),
    "total": ("F", "total capacitance of the gap"),
    "one_ball": ("F", "capacitance of one ball, with its contacts in series"),
    "bearing": ("F", "capacitance of the bearing"),
    "play": ("m", "gap between ball and raceway, negative where they overlap"),
}


def filling_of(run: Run) -> Filling:
    """Return the filling of the gaps in a `run`, as given to fix bearing/capacitance.

    The default is flooded. Raise `RunError` for an unknown kind of surroundings.
    """
    words = str(run.settings.get("capacitance_commands", "")).split(";")[0].split()
    given: dict[str, Any] = {}
    for place, word in enumerate(words):
        after = words[place + 1 :]
        if word == "surroundings" and after and after[0] != "none":
            given["kind"] = after[0]
            if after[0] == "cavitated" and len(after) > 1 and _is_number(after[1]):
                given["outlet"] = float(after[1])
        elif word == "outlet":
            given["outlet"] = float(after[0])
        elif word == "shoulders":
            given["shoulders"] = Shoulders(*map(float, after[:2]))
        elif word in ("permittivity_at", "roughness"):
            given[word] = after[0]
    if given.get("kind", "flooded") not in FILLS:
        raise RunError(f"{run.tables.folder}: surroundings {given['kind']} are unknown")
    return FLOODED._replace(**given)


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def over_time(
    run: Run, filling: Filling | None = None, density: float = STEEL.density
) -> xr.Dataset:
    """Return the capacitances of a `run` from `raceway.open` as a Dataset in SI units.

    Its variables are `load`, `separation`, `area`, `plates`, `outside`, `paths` and `total` (time,
    raceway, ball), `one_ball` (time, ball) and `bearing` (time).

    A contact has the film thickness of the run. If its load is below Q_u = m r omega_c^2 (for balls
    of `density` in kg/m^3), it has the thickness at Q_u, by the load exponent of eq 9. A ball
    without load has that of the contact with the largest load on the same raceway at that time, but
    at least the distance between ball and raceway that follows from the positions of ball and ring
    and, in a heated run, from the thermal expansion. `separation` describes films in the gap.

    `filling` is by default the filling of the run; in this case, separations and capacitances come
    from the record if it contains them (see the attribute `source`). For a ring with two grooves,
    values always come from the record and are merged: capacitances are in parallel, the thinner
    film and the larger load are used, and there is no `play`.

    All samples must fit into memory. Raise `RunError` for a run without film, balls or rings, and
    for rings with two grooves if a `filling` is given or if their capacitances were not recorded.
    """
    need_film(run, "capacitance")
    contacts = run.contacts
    recorded = filling is None and set(RECORDED.values()) <= set(contacts)
    if two := run.tables.record.two_grooves:
        if not recorded:
            raise RunError(
                f"{run.tables.folder} has rings with two grooves per ball: their total capacitance"
                " must be recorded with -var surroundings, for the filling of the run"
            )
        gaps = contacts["load"].transpose("time", "raceway", "ball")
    else:
        if not {"angle", "h_c"} <= set(contacts):
            raise RunError(f"{run.tables.folder}: the contacts need the columns angle and h_c")
        gaps = _gaps(run.tables, run.balls, run.settings["clearance_m"])
    within = separation.gap_film(run.tables)
    filling = filling_of(run) if filling is None else filling
    bearing, clearance = run.tables.geometry, run.settings["clearance_m"]
    quiet = capacitors.quiet_load(bearing, _cage_speed(run), density, cut=separation.cut(within))
    data = xr.Dataset(coords=gaps.coords)
    found, dims = [], gaps.dims
    for side, name in enumerate(() if two else SIDES):
        table = contacts.sel(raceway=name)
        gap = gaps.sel(raceway=name).to_numpy()
        apart, play = separation.of_raceway(bearing, side, table, gap, quiet, within, clearance)
        found.append(
            capacitors.of_raceway(
                bearing,
                side,
                run.settings["permittivity"],
                table["load"].to_numpy(),
                apart,
                np.nan_to_num(table["angle"].to_numpy()),
                film_thickness=table["h_c"].fillna(1.0).to_numpy(),  # unused without load
                play=play,
                filling=filling,
                roughness=run.settings["roughness_m"],
                clearance=clearance,
            )
        )
    if two:
        data["load"] = contacts["load"]
        data["area"] = np.pi * (contacts["a"] * contacts["b"]).fillna(0.0).transpose(*dims)
    else:
        for name in ("load", "separation", "area", "plates", "outside", "paths", "total"):
            data[name] = dims, np.stack([getattr(side, name) for side in found], axis=1)
        data["play"] = gaps
    if recorded:
        for name, column in RECORDED.items():
            data[name] = contacts[column].transpose(*dims).drop_vars(ANGLES, errors="ignore")
        data["paths"] = _paths(data, contacts["h_c"], run.settings["permittivity"], filling)
    if two:
        data = data.drop_vars(ANGLES, errors="ignore").transpose(*dims).map(_by_ring)
    inner, outer = (data["total"].sel(raceway=name).to_numpy() for name in SIDES)
    data["one_ball"] = ("time", "ball"), capacitance.ball(inner, outer)
    data["bearing"] = data["one_ball"].sum("ball")
    for name in data.data_vars:
        unit, meaning = MEANING[name]
        data[name].attrs = {"units": unit, "long_name": meaning}
    source = "record" if recorded else "positions, loads and films"
    data.attrs = {"quiet_load_N": quiet, "filling": filling.kind, "source": source}
    return data


def _by_ring(values):
    """Merge the grooves (inner 0, inner 1, outer 0, outer 1) into one raceway per ring."""
    join = {"load": "max", "separation": "min"}.get(values.name, "sum")
    pairs = [getattr(values.isel(raceway=slice(k, k + 2)), join)("raceway") for k in (0, 2)]
    joined = xr.concat(pairs, xr.Variable("raceway", list(SIDES)))
    return joined.transpose("time", "raceway", "ball")


def _paths(data, h_c, permittivity, filling):
    """Compute `paths` as in `capacitors`, but from the columns of a record."""
    ellipse = (data["area"] / h_c.drop_vars(ANGLES, errors="ignore")).where(data["load"] > 0, 0.0)
    fills = capacitance_outside.fill(permittivity, filling.kind, filling.outlet)
    around = data["outside"] / (capacitance.VACUUM * fills)
    wet = capacitors.WET_SHARE[filling.kind] * around
    return (ellipse + wet).transpose(*data["area"].dims)


def contacts_of(run: Run, whole: xr.Dataset) -> xr.Dataset:
    """Return the contacts of a `run` with the columns *separation*, *capacitance_outside* and
    *capacitance_total* of `whole` (from `over_time`).

    The result is the same as for a record with these columns, and serves as input for the circuit
    (`electric.films.of_dataset`).
    """
    contacts = run.contacts.sel(time=whole["time"])
    for name, column in RECORDED.items():
        contacts[column] = whole[name].drop_vars(ANGLES, errors="ignore")
    return contacts


def fields(
    run: Run, whole: xr.Dataset, voltage: float, strength: float = film_voltage.STRENGTH
) -> xr.Dataset:
    """Return the effect of a `voltage` (V) between the rings as a Dataset.

    `whole` is from `over_time`. The variables (time, raceway, ball) are `share` (V, the voltage
    across each film), `field` and `field_peaks` (V/m with sign, for the gaps h_c and h_c - 3 sigma;
    infinite where peaks meet) and `state` (index into `film_voltage.STATES`). The variables (time)
    are `threshold` and `threshold_peaks` (V, the voltage at which the first film of `strength` in
    V/m fails), `weakest` (number of the ball with this film, for smooth films) and `energy` (J, the
    energy of the bearing at this voltage, for smooth films).
    """
    total = {name: whole["total"].sel(raceway=name, drop=True).to_numpy() for name in SIDES}
    gaps = whole["separation"].transpose("time", "raceway", "ball").to_numpy()
    sigma = run.settings["roughness_m"]
    shares = film_voltage.divided(voltage, *total.values())
    dims = ("time", "raceway", "ball")
    data = xr.Dataset(coords=whole["total"].coords)
    data["share"] = dims, np.stack(shares, axis=1)
    for name, rough in (("field", 0.0), ("field_peaks", sigma)):
        local = film_voltage.local_gap(gaps, rough)
        data[name] = dims, film_voltage.field(data["share"].to_numpy(), local)
    for name, rough in (("threshold", 0.0), ("threshold_peaks", sigma)):
        found = film_voltage.threshold(gaps.swapaxes(0, 1), total.values(), strength, rough)
        data[name] = "time", found.bearing
        if rough == 0.0:
            data["weakest"] = "time", whole["ball"].to_numpy()[found.weakest]
    data["energy"] = film_voltage.stored_energy(whole["bearing"], data["threshold"])
    data["state"] = dims, _states(run, whole)
    for name, unit in (
        ("share", "V"), ("field", "V/m"), ("field_peaks", "V/m"), ("threshold", "V"),
        ("threshold_peaks", "V"), ("energy", "J"), ("weakest", "1"), ("state", "1"),
    ):  # fmt: skip
        data[name].attrs = {"units": unit}
    return data


def _states(run, whole):
    contacts = run.contacts.sel(time=whole["time"])
    if "asperity_share" in contacts:
        share = contacts["asperity_share"]
    else:
        ratio = contacts["lambda"].fillna(np.inf)
        share = ratio.copy(data=asperity.clarke(ratio.to_numpy()))
    share = share.where(contacts["load"] > 0, 0.0).rename("load")
    if contacts.sizes["raceway"] > len(SIDES):
        share = _by_ring(share)
    return film_voltage.states(share.transpose(*whole["total"].dims).to_numpy())


def _gaps(tables: RunTables, balls, clearance):
    """Return the gaps (time, raceway, ball) in m between every ball and both grooves, computed only
    from positions and, in a heated run, temperatures."""
    bearing, place = tables.geometry, np.stack([balls[axis].to_numpy() for axis in "xyz"])
    inner, ball, outer = (one[:, None] for one in warming.strains(tables))
    out = []
    for side, ring in ((INNER, inner), (OUTER, outer)):
        *centre, first, second = ring_place(tables.record, side, tables.first, tables.last)
        d = place - np.stack(centre)[:, :, None]
        e = np.stack([np.sin(second), -np.sin(first), np.zeros_like(first)])[:, :, None]
        e[2] = np.sqrt(1 - e[0] ** 2 - e[1] ** 2)
        along = (d * e).sum(0)
        radial = np.linalg.norm(d - along * e, axis=0)
        circle = bearing.groove_circle(side, clearance) * (1 + ring)
        slack = bearing.groove(side) * (1 + ring) - bearing.ball_radius * (1 + ball)
        out.append(slack - np.hypot(radial - circle, along))
    return xr.DataArray(
        np.stack(out, axis=1),
        dims=("time", "raceway", "ball"),
        coords={"time": balls["time"], "raceway": list(SIDES), "ball": balls["ball"]},
    )


def _cage_speed(run) -> float:
    balls = run.balls
    x, y = balls["x"], balls["y"]
    return float(((x * balls["vy"] - y * balls["vx"]) / (x * x + y * y)).mean())
