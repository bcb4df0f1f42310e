# SPDX-License-Identifier: GPL-2.0-or-later
"""Ball bearings: runs of the simulation, read and drawn, and the theory to hold them against.

`open` reads a run. The other public names are loaded when first asked for.
"""

from importlib import import_module
from os import PathLike
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from raceway.runs.run import Run

__version__ = "0.1.0"
# the public names, and the module that is or has each
NAMES = {
    # theory, without a run
    "asperity": "theory.asperity",
    "beam": "theory.beam",
    "beam_motion": "theory.beam_motion",
    "bearing": "theory.bearing",
    "capacitance": "theory.capacitance",
    "capacitance_exact": "theory.capacitance_exact",
    "capacitance_outside": "theory.capacitance_outside",
    "capacitors": "theory.capacitors",
    "cleanliness": "theory.cleanliness",
    "clearance": "theory.clearance",
    "contact_law": "theory.contact_law",
    "damping": "theory.damping",
    "distribution": "theory.distribution",
    "drag": "theory.drag",
    "electric_point": "theory.electric_point",
    "electric_table": "theory.electric_table",
    "film": "theory.film",
    "film_damping": "theory.film_damping",
    "film_factors": "theory.film_factors",
    "film_gap": "theory.film_gap",
    "film_reading": "theory.film_reading",
    "film_regimes": "theory.film_regimes",
    "film_voltage": "theory.film_voltage",
    "fits": "theory.fits",
    "four_point": "theory.four_point",
    "friction_torque": "theory.friction_torque",
    "groove_width": "theory.groove_width",
    "heat": "theory.heat",
    "hertz": "theory.hertz",
    "impedance": "theory.impedance",
    "kinematics": "theory.kinematics",
    "life": "theory.life",
    "load_rating": "theory.load_rating",
    "lubricant": "theory.lubricant",
    "lubrication": "theory.lubrication",
    "makers": "theory.makers",
    "operating_point": "theory.operating_point",
    "operating_table": "theory.operating_table",
    "ring_response": "theory.ring_response",
    "many_grooves": "theory.many_grooves",
    "rolling": "theory.rolling",
    "rotor_matrices": "theory.rotor_matrices",
    "shaft": "theory.shaft",
    "shaft_bending": "theory.shaft_bending",
    "shaft_motion": "theory.shaft_motion",
    "rough_film": "theory.rough_film",
    "sliding": "theory.sliding",
    "small_motion": "theory.small_motion",
    "spall": "theory.spall",
    "spin": "theory.spin",
    "static": "theory.static",
    "steady_heat": "theory.steady_heat",
    "traction": "theory.traction",
    # runs
    "Run": "runs.run",
    "RunTables": "runs.tables",
    "columns": "runs.columns",
    "electrical": "runs.electrical",
    "envelope": "runs.envelope",
    "film_figures": "runs.film_figures",
    "film_table": "runs.film_table",
    "losses": "runs.losses",
    "passages": "runs.passages",
    "regimes": "runs.regimes",
    "ring_fit": "runs.ring_fit",
    "sensor": "runs.sensor",
    "spectrum": "runs.spectrum",
    "summary": "runs.summary",
    "time_frequency": "runs.time_frequency",
    "whole_capacitance": "runs.whole_capacitance",
    # the electrical bearing
    "circuit": "electric.circuit",
    # data files, errors, units
    "bending_file": "bending_file",
    "catalogue": "catalogue",
    "clearance_classes": "clearance_classes",
    "errors": "errors",
    "export": "export",
    "inputs": "inputs",
    "listing": "listing",
    "ross_file": "ross_file",
    "shaft_file": "shaft_file",
    "units": "units",
}
__all__ = ["open", *NAMES]


def open(folder: str | PathLike[str], samples: slice = slice(None)) -> "Run":
    """The run in `folder` as one object; `samples`, a slice, keeps to some of its samples.

    Raises `raceway.errors.RunError` when the folder is not that of a run.
    """
    # xarray takes longer to load than a static bearing to solve
    from raceway.runs.run import Run

    return Run(folder, samples)


def __getattr__(name: str) -> Any:
    if name not in NAMES:
        raise AttributeError(f"module 'raceway' has no attribute '{name}'")
    module = import_module(f"raceway.{NAMES[name]}")
    return module if module.__name__.endswith(f".{name}") else getattr(module, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
