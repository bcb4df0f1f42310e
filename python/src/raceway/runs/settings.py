# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings of a run, with the keys of `run.yaml`. They are read from the record, or, if they are
written only at the end of the run, from `run.yaml` in the same folder.

If the deck did not record load, speed and length, they are measured as means over the record.
"""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from raceway import yaml_file
from raceway.errors import RunError
from raceway.runs.record import Record
from raceway.runs.same_run import need_same_run

# written at the end, so they are missing in an unfinished run
AT_THE_END = ("step_s", "simulated_s", "wall_s")
COST = ("processor_s", "evaluations")  # written in addition by runs that record their cost
LUBRICANT = ("viscosity_Pa_s", "pressure_viscosity_per_Pa", "permittivity", "roughness_m")
NO_LUBRICANT = ("dry", "none")
MEASURED = ("load_N", "load_azimuth_rad", "rpm", "samples_per_pass", "passes")
OF_ALL = ("pair_commands", "named_bearings", "bearing_names")  # for all bearings of a record
TEXT = ("bearing", "lubricant")
RAD_S = np.pi / 30  # rad/s per revolution per minute
NO_LOAD = 1e-9  # ratio of radial load to ring forces below which its direction is rounding error


class Settings(dict[str, Any]):
    """Settings that map a key to text, or to a number in the unit at the end of the key.

    A key may be missing because one bearing has to be selected first or because a measurement needs
    samples. Accessing a missing key calls the functions `needed`, which raise `RunError` with the
    reason.
    """

    def __init__(self, values: Mapping[str, Any], needed: tuple[Callable[[], None], ...]) -> None:
        super().__init__(values)
        self._needed = needed

    def __missing__(self, key: str) -> Any:
        for need in self._needed:
            need()
        raise KeyError(key)


def settings(record: Record) -> Settings:
    """Return the settings of the run that wrote `record`.

    Raise `RunError` if `run.yaml` is broken or belongs to another run.
    """
    path = record.path.with_name("run.yaml")
    beside = _said(path)
    end = _the_end(path, beside)
    need_same_run(record, beside)
    one = {} if record.bearing is None else _bearing(record)
    told = {key: value for key, value in record.attrs.items() if key not in OF_ALL}
    told |= _named(record)
    columns = {"contact_columns": " ".join(["ball", "ring", "raceway", *record.contact_columns])}
    found = {"bearing": "unnamed", "integrator": "unknown", **one, **told, **columns}
    for name in ("inner_ring", "outer_ring"):
        if record.bearing is not None and found[name] not in (None, *record.fixed("ring")):
            raise RunError(f"{record.path}: {name} is {found[name]:g}, not one of its rings")
    if record.bearing is not None and not set(MEASURED) <= set(told) and len(record):
        found = {**_measured(record, found), **found}
    return Settings({**found, **end}, (record.need_one, record.need_samples))


def deck_words(settings: Mapping[str, Any]) -> dict[str, str]:
    """Return {name: value} for the main deck's variables as recorded by the run.

    The dict is empty for other decks.
    """
    recorded = str(settings.get("deck_variables", ""))
    return dict(word.split("=", 1) for word in recorded.split(",") if "=" in word)


SIZES = ("ball_diameter", "inner_radius", "outer_radius", "inner_groove", "outer_groove")
BODY = {"balls": 1e6, "ball_young": 1e15, **dict.fromkeys(SIZES, 100.0)}  # upper limits, SI units


def _named(record):
    """Return data of the selected bearing from the deck's commands, for a record with several
    bearing names."""
    lines = str(record.attrs.get("named_bearings", "")).splitlines()
    numbers = str(record.attrs.get("bearing_names", "")).split()
    if record.bearing is None or len(numbers) != len(record.bearings):
        return {}
    line = int(numbers[record.bearings.index(record.bearing)])
    words = dict(word.split("=", 1) for word in lines[line].split()) if line < len(lines) else {}
    return {key: value if key in TEXT else float(value) for key, value in words.items()}


def _bearing(record):
    value = record.known(
        {
            name: float(record.fixed(name)[0])
            for name, dims in record.variables.items()
            if dims == ("bearing",) and name != "bearing"
        }
    )
    for name, most in BODY.items():
        if not 0 < value[name] < most:
            raise RunError(
                f"{record.path}: {name} is {value[name]:g}, must be above 0 and below {most:g}"
            )
    if value["balls"] != len(record.fixed("ball")):
        raise RunError(
            f"{record.path}: balls is {value['balls']:g}, but it has {len(record.fixed('ball'))}"
        )
    wet = np.isfinite(value["viscosity"])
    rings = dict(zip(record.fixed("ring_raceway").tolist(), record.fixed("ring").tolist()))
    found = {
        "lubricant": "oil" if wet else "dry",
        "balls": int(value["balls"]),
        "ball_diameter_m": value["ball_diameter"],
        "inner_radius_m": value["inner_radius"],
        # without the clearance, which is given separately
        "outer_radius_m": value["outer_radius"] - value["clearance"] / 2,
        "inner_groove_m": value["inner_groove"],
        "outer_groove_m": value["outer_groove"],
        "clearance_m": value["clearance"],
        "ball_young_Pa": value["ball_young"],
        "ball_poisson": value["ball_poisson"],
        "ring_young_Pa": value["ring_young"],
        "ring_poisson": value["ring_poisson"],
        "inner_ring": rings.get(0),
        "outer_ring": rings.get(1),
    }
    if value["cage_balls"]:
        found["cage_ball_diameter_m"] = value["cage_ball_diameter"]
    if wet:
        found["viscosity_Pa_s"] = value["viscosity"]
        found["pressure_viscosity_per_Pa"] = value["pressure_viscosity"]
        found["permittivity"] = value["permittivity"]
        found["roughness_m"] = float(np.hypot(value["ring_roughness"], value["ball_roughness"]))
    return found


def _measured(record, told):
    spin = record.read(["ring_spin"])["ring_spin"]
    side = record.fixed("ring_raceway")
    speed = np.abs(spin[:, side == 0].sum(axis=1) - spin[:, side == 1].sum(axis=1)).mean()
    found = record.read([f"ring_{name}" for name in ("fx", "fy", "fz", "x", "y")])
    inner = {name: values[:, side == 0] for name, values in found.items()}
    force = np.sqrt(sum(found[f"ring_f{name}"] ** 2 for name in "xyz")).mean(axis=0).max()
    # The load is opposite to the force of the balls on the inner ring.
    x, y = (-float(inner[name].mean()) for name in ("ring_fx", "ring_fy"))
    along = (x, y)
    if np.hypot(x, y) <= NO_LOAD * force:  # use the direction of the displacement instead
        along = (float(inner["ring_x"].mean()), float(inner["ring_y"].mean()))
    cage = float(np.abs(record.read(["bearing_cage_speed"])["bearing_cage_speed"]).mean())
    sample_s = told["sample_s"]
    ball_pass = 2 * np.pi / (told["balls"] * cage) if cage else np.nan
    return {
        "load_N": float(np.hypot(x, y)),
        "load_azimuth_rad": float(np.arctan2(*along[::-1])),
        "rpm": float(speed) / RAD_S,
        "samples_per_pass": ball_pass / sample_s,
        "passes": (len(record) - 1) * sample_s / ball_pass,
    }


def _said(path: Path) -> dict[str, Any]:
    """Return the contents of `run.yaml` as text, because 6208 is a name.

    The result is empty if the file is missing, or incomplete because the run is still writing it.
    """
    if not path.exists():
        return {}
    data = yaml_file.read(path, RunError)
    return data if isinstance(data, dict) and path.read_bytes().endswith(b"\n") else {}


def _the_end(path: Path, said: Mapping[str, Any]) -> dict[str, float]:
    """Return the entries of `run.yaml` (`said`) that a run writes at its end, if present."""
    found = {}
    for key in (key for key in (*AT_THE_END, *COST) if key in said):
        try:
            found[key] = float(said[key])
        except (TypeError, ValueError):
            raise RunError(f"{path}: {key} is not a number: '{said[key]}'") from None
        if not 0 <= found[key] < np.inf:
            raise RunError(f"{path}: {key} = {said[key]} must be finite and not negative")
    if found.get("wall_s") == 0:
        raise RunError(f"{path}: wall_s = {said['wall_s']} must be positive")
    return found
