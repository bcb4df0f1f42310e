# SPDX-License-Identifier: GPL-2.0-or-later
"""Simulate ball bearings, read and plot the results, and compare them with theory.

`simulate` runs a bearing, and `open` reads a finished run. All other public names are loaded when
they are first used.
"""

from importlib import import_module
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from raceway.runs.run import Run
    from raceway.sweeps.one_run import simulate as simulate

# `raceway.NAME` is a module in one of these folders or in the package itself, or else a class or
# function listed in CLASSES
ROOMS = ("theory", "runs", "electric", "recordings")
CLASSES = {"Run": "runs.run", "RunTables": "runs.tables", "simulate": "sweeps.one_run"}


def _names() -> dict[str, str]:
    """Return a dict that maps each public name to the module that has this name or defines it."""
    here, found = Path(__file__).parent, dict(CLASSES)
    for room in (*ROOMS, ""):
        for path in (here / room).iterdir():
            module = path.suffix == ".py" and not path.stem.startswith("_")
            if module or (path / "__init__.py").exists():
                found[path.stem] = f"{room}.{path.stem}".lstrip(".")
    return dict(sorted(found.items()))


NAMES = _names()
__all__ = ["open", *NAMES]


def open(folder: str | PathLike[str], samples: slice = slice(None)) -> "Run":
    """Return the run in `folder` as a `Run`; the slice `samples` selects some of its samples.

    Raises `raceway.errors.RunError` if the folder does not contain a run.
    """
    # imported here because loading xarray takes longer than solving a static bearing
    from raceway.runs.run import Run

    return Run(folder, samples)


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version  # takes longer to load than all other modules

        return version("raceway")
    if name not in NAMES:
        from raceway.errors import near

        raise AttributeError(f"module 'raceway' has no attribute '{name}'{near(name, __all__)}")
    module = import_module(f"raceway.{NAMES[name]}")
    return module if module.__name__.endswith(f".{name}") else getattr(module, name)


def __dir__() -> list[str]:
    return sorted({*(name for name in globals() if name.startswith("__")), *__all__})
