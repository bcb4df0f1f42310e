# SPDX-License-Identifier: GPL-2.0-or-later
"""`run.yaml`: what a run says of itself."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from raceway.errors import RunError
from raceway.runs.text import need_text

WORDS = ("bearing", "lubricant", "host", "integrator", "contact_columns", "ball_columns")
NUMBERS = (
    "load_N",
    "rpm",
    "clearance_m",
    "passes",
    "balls",
    "ball_diameter_m",
    "inner_radius_m",
    "outer_radius_m",
    "inner_groove_m",
    "outer_groove_m",
    "load_azimuth_rad",
    "sample_s",
    "samples_per_pass",
    "inner_ring",
    "outer_ring",
)
# written last: without them the run has not finished
AT_THE_END = ("step_s", "simulated_s", "wall_s")
COST = ("processor_s", "evaluations")  # beside them, in runs that say it
LUBRICANT = ("viscosity_Pa_s", "pressure_viscosity_per_Pa", "permittivity", "roughness_m")
EXTRA = ("ball_young_Pa", "ball_poisson", "cage_ball_diameter_m")  # some runs do not have them
NO_LUBRICANT = ("dry", "none")
WHOLE = ("balls", "inner_ring", "outer_ring")
POSITIVE = (  # and finite
    "rpm",
    "passes",
    "ball_diameter_m",
    "inner_radius_m",
    "outer_radius_m",
    "inner_groove_m",
    "outer_groove_m",
    "sample_s",
    "samples_per_pass",
    "step_s",
    "simulated_s",
    "wall_s",
    "viscosity_Pa_s",
    "pressure_viscosity_per_Pa",
    "roughness_m",
    "ball_young_Pa",
    "cage_ball_diameter_m",
)
RANGES = {
    "load_N": (0, np.inf),
    "permittivity": (1, 1e3),
    "ball_poisson": (0, 0.5),
} | dict.fromkeys(WHOLE, (1, 1e9))


def settings(folder: Path) -> dict[str, Any]:
    """What `run.yaml` in `folder` says: names as text, the rest as numbers in the units their names
    end with.

    Raises `RunError` when the file cannot be read, lacks a key or has a value that is no number.
    """
    path = folder / "run.yaml"
    try:
        # every scalar as text: 6208 is a name, and YAML 1.1 takes 1e-05 for a string anyway
        data = yaml.load(path.read_text(), Loader=_Loader)
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"cannot read {path}: {getattr(error, 'strerror', None) or error}") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f", line {mark.line + 1}" if mark else ""
        raise RunError(f"{path}{where}: {getattr(error, 'problem', None) or error}") from None
    except RecursionError:
        raise RunError(f"{path} is nested too deeply") from None
    if not isinstance(data, dict):
        raise RunError(f"{path} is not a list of 'name: value'")
    lubricant = LUBRICANT if data.get("lubricant") not in (*NO_LUBRICANT, None) else ()
    needed = (*WORDS, *NUMBERS, *lubricant)
    if missing := [key for key in needed if key not in data]:
        need_text(folder)
        begun = "" if all(key in data for key in AT_THE_END) else "run has not finished: "
        raise RunError(f"{begun}{path} has no {', '.join(missing)}")
    for key in (key for key in WORDS if not isinstance(data[key], str)):
        raise RunError(f"{path}: {key} must be text, not a list or a map")
    values = dict(data)
    for key in (
        *needed[len(WORDS) :],
        *(key for key in (*EXTRA, *AT_THE_END, *COST) if key in data),
    ):
        try:
            values[key] = float(data[key])
            if not np.isfinite(values[key]):
                raise ValueError
        except (TypeError, ValueError):
            raise RunError(f"{path}: {key} is not a number: '{data[key]}'") from None
    for key in (key for key in POSITIVE if isinstance(values.get(key), float)):
        if not values[key] > 0:
            raise RunError(f"{path}: {key} = {data[key]} must be positive")
    for key, (least, most) in RANGES.items():
        if isinstance(values.get(key), float) and not least <= values[key] <= most:
            raise RunError(f"{path}: {key} = {data[key]} must be from {least:g} to {most:g}")
    for key in WHOLE:
        if values[key] != int(values[key]):
            raise RunError(f"{path}: {key} = {data[key]} must be a whole number")
        values[key] = int(values[key])
    return values


class _Loader(yaml.BaseLoader):
    """Every key once: of two lines with one key, the last would win."""

    def construct_mapping(self, node, deep=False):
        seen = set()
        for key, _ in node.value:
            if str(key.value) in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f"{key.value} is there twice", key.start_mark
                )
            seen.add(str(key.value))
        return super().construct_mapping(node, deep)


def said(folder: Path) -> dict[str, Any]:
    """What `run.yaml` beside a record says, all as text; nothing where it is not there, or not
    whole because the run is writing it. Raises `RunError` when it cannot be read."""
    path = folder / "run.yaml"
    if not path.exists():
        return {}
    try:
        data = yaml.load(path.read_text(), Loader=_Loader)
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise RunError(f"cannot read {path}: {error}") from None
    return data if isinstance(data, dict) else {}


def the_end(folder: Path, said: Mapping[str, Any]) -> dict[str, float]:
    """What `run.yaml` in `folder` has `said` of the end of a run, as far as it is there. Raises
    `RunError`."""
    try:
        return {key: float(said[key]) for key in (*AT_THE_END, *COST) if key in said}
    except (TypeError, ValueError) as error:
        raise RunError(f"cannot read {folder / 'run.yaml'}: {error}") from None
