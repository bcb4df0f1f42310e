# SPDX-License-Identifier: GPL-2.0-or-later
"""Electrical quantities of a run as functions of time: parts of the capacitance, Hertz area,
threshold voltage of breakdown, stored energy, field, leakage and impedance."""

import math

import numpy as np
import xarray as xr

from raceway.arrays import Floats
from raceway.runs import whole_capacitance
from raceway.runs.run import Run
from raceway.theory import capacitance, film_voltage, impedance
from raceway.theory.electric_point import NOTHING, Ask

MEANING = {
    "plates": ("F", "capacitance of the contact ellipses (eq 12)"),
    "around": ("F", "capacitance around the ellipses of the loaded balls"),
    "unloaded": ("F", "capacitance of the unloaded balls"),
    "bearing": ("F", "capacitance of the bearing"),
    "hertz_area": ("m2", "area of all contact ellipses"),
    "threshold": ("V", "smallest voltage at which a film fails, with the field over the gap"),
    "threshold_peaks": ("V", "threshold with the field over the gap minus three sigma"),
    "weakest": ("1", "number of the ball whose smooth film fails first"),
    "energy": ("J", "energy stored at the threshold of smooth films"),
    "field": ("V/m", "largest field in a film, over the gap"),
    "field_peaks": ("V/m", "largest field in a film, over the gap minus three sigma"),
    "leak": ("ohm", "resistance of the films to direct current"),
    "impedance": ("ohm", "modulus of the impedance"),
    "phase": ("rad", "phase of the impedance"),
    "bearing_voltage_ratio": ("1", "bearing voltage over common-mode voltage, for two bearings"),
}


def over_time(run: Run, whole: xr.Dataset, ask: Ask = NOTHING) -> xr.Dataset:
    """Return a Dataset over time with the variables of `MEANING` in SI units.

    `whole` is the result of `whole_capacitance.over_time` for the `run`. The capacitances of
    plates, surroundings and unloaded balls add up to the capacitance of the bearing. A voltage in
    `ask` adds the fields, a resistivity the leak, a frequency the impedance, and a motor the
    voltage ratio; with a motor, the energy includes the capacitances of the motor and of a second,
    equal bearing.
    """
    total, paths, load, plates = (
        _films(whole, name) for name in ("total", "paths", "load", "plates")
    )
    one = whole["one_ball"].transpose("time", "ball").to_numpy()
    loaded = (load > 0).all(axis=0)
    of_plates = np.where(loaded, capacitance.ball(*plates), 0.0)
    found = whole_capacitance.fields(run, whole, ask.voltage or 1.0, ask.strength)
    values = {
        "plates": of_plates.sum(1),
        "around": np.where(loaded, one - of_plates, 0.0).sum(1),
        "unloaded": np.where(loaded, 0.0, one).sum(1),
        "bearing": one.sum(1),
        "hertz_area": _films(whole, "area").sum((0, 2)),
        "threshold": found["threshold"].to_numpy(),
        "threshold_peaks": found["threshold_peaks"].to_numpy(),
        "weakest": found["weakest"].to_numpy(),
    }
    values["energy"] = film_voltage.stored_energy(
        values["bearing"] + ask.parallel(values["bearing"]), values["threshold"]
    )
    if ask.voltage is not None:
        for name in ("field", "field_peaks"):
            values[name] = np.abs(_films(found, name)).max((0, 2))
    if math.isfinite(ask.resistivity):
        values["leak"] = impedance.leak_of_films(paths, ask.resistivity)
    if ask.frequency is not None:
        z = impedance.of_films(total, paths, ask.frequency, ask.resistivity)
        values |= {"impedance": np.abs(z), "phase": np.angle(z)}
    if ask.motor is not None:
        values["bearing_voltage_ratio"] = impedance.bearing_voltage_ratio(
            *ask.motor, values["bearing"], values["bearing"]
        )
    data = xr.Dataset(
        {
            name: ("time", values[name], {"units": unit, "long_name": meaning})
            for name, (unit, meaning) in MEANING.items()
            if name in values
        },
        coords={"time": whole["time"]},
    )
    data.attrs = whole.attrs
    return data


def spectrum(whole: xr.Dataset, frequency: Floats, resistivity: float) -> xr.DataArray:
    """Return the complex impedance in ohm (time, frequency) of `whole` at frequencies (n,) in Hz,
    for oil with the given `resistivity` (ohm m)."""
    total, paths = _films(whole, "total"), _films(whole, "paths")
    z = [impedance.of_films(total, paths, one, resistivity) for one in frequency]
    return xr.DataArray(
        np.stack(z, axis=1),
        dims=("time", "frequency"),
        coords={"time": whole["time"], "frequency": frequency},
        attrs={"units": "ohm", "long_name": "impedance of the bearing"},
    )


def _films(data, name):
    """Return the values (2, n, Z) of the inner and the outer films."""
    return data[name].transpose("raceway", "time", "ball").to_numpy()
