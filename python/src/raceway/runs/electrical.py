# SPDX-License-Identifier: GPL-2.0-or-later
"""Capacitances of contacts, balls and bearing over time, and pressure and permittivity of the oil
on each raceway (eqs 8-12)."""

import xarray as xr

from raceway.runs.around import BINS, around
from raceway.runs.regimes import need_film
from raceway.runs.run import Run
from raceway.theory import capacitance


def over_time(run: Run, background: float = 0.0) -> xr.Dataset:
    """Return a Dataset of capacitances in F: `contact` (time, raceway, ball), `one_ball` (time,
    ball) and `bearing` (time).

    The inner and outer contact of a ball are in series; the grooves of a ring and the balls are in
    parallel; `background` (F) is added in parallel (eq 12). `run` is from `raceway.open`, and all
    its samples must fit into memory. Raise `RunError` for a run without film.
    """
    need_film(run, "capacitance")
    contact = run.contacts["capacitance"].drop_vars(("azimuth", "from_load_line"))
    of_ring = [
        contact.isel(raceway=contact.raceway.str.startswith(side)) for side in ("inner", "outer")
    ]
    inner, outer = (one.sum("raceway", skipna=False) for one in of_ring)
    one = inner.copy(data=capacitance.ball(inner.to_numpy(), outer.to_numpy()))
    data = xr.Dataset(
        {"contact": contact, "one_ball": one, "bearing": one.sum("ball") + background}
    )
    for name, what in (
        ("contact", "of one contact"),
        ("one_ball", "of one ball, with its contacts in series"),
        ("bearing", "of the bearing"),
    ):
        data[name].attrs = {"units": "F", "long_name": f"capacitance {what}"}
    return data


def by_raceway(run: Run, bins: int = BINS) -> xr.Dataset:
    """Return a Dataset (raceway, from_load_line) of means over the contacts in each sector of the
    ring.

    Its variables are the maximum Hertz `pressure` (Pa), the relative `permittivity` of the oil at
    this pressure (eqs 10, 11), the `capacitance` of a contact (F), and `contacts`, the number of
    contacts. `run` is from `raceway.open` and is read in blocks. Raise `RunError` for a run without
    film.
    """
    need_film(run, "capacitance")
    ambient = run.settings["permittivity"]
    result = around(
        run,
        {
            "pressure": lambda table: table["pressure"],
            "permittivity": lambda table: capacitance.permittivity(
                ambient, table["pressure"].to_numpy()
            ),
            "capacitance": lambda table: table["capacitance"],
        },
        bins,
    )
    for name, unit in (("pressure", "Pa"), ("permittivity", "1"), ("capacitance", "F")):
        result[name].attrs["units"] = unit
    return result
