# SPDX-License-Identifier: GPL-2.0-or-later
"""Look up bearings and lubricants by name in the `inputs` folder, in the package or in the user's
own files. `raceway.listing` searches the bearings by other criteria."""

import difflib
import os
from pathlib import Path

from raceway import data_table
from raceway.files import FilePath
from raceway.inputs import InputError

KINDS = {"bearings": "ball bearing", "lubricants": "lubricant"}
# In a source tree this is a link to the inputs folder; a wheel contains copies of the files.
SHIPPED = Path(__file__).with_name("data")
MANY = 20  # if a message would list more names than this, it lists only similar names


def folder(given: FilePath | None = None) -> Path:
    """Return the inputs folder. This is `given` or, by default, the folder `inputs` in the working
    directory or one of its parents, or else the data folder of the package. Raises `InputError` if
    `given` is not a folder."""
    if given is not None:
        if not Path(given).is_dir():
            raise InputError(f"there is no folder {given}")
        return Path(given)
    here = Path.cwd()
    for place in (here, *here.parents):
        if all(os.path.isdir(f"{place}/inputs/{kind}") for kind in KINDS):
            return place / "inputs"
    return SHIPPED


def find(kind: str, name: str, inputs: FilePath | None = None) -> Path:
    """Return the path of the data file `name` of a kind ("bearings" or "lubricants"). A name with a
    slash is itself a path. If there is no such file, but a table in the folder has a row with that
    name, the path is returned nevertheless; `raceway.inputs` then reads the row.

    `inputs` is a folder or None (see `folder`). Raises an `InputError` that lists the available
    names.
    """
    if "/" in name:
        path = Path(name)
        try:
            there = _there(path)
        except InputError as error:  # of a table in that folder
            raise InputError(f"there is no file {name}; {error}") from None
        if not there:
            raise InputError(f"there is no file {name}")
        return path
    shelf = folder(inputs) / kind
    path = shelf / name
    if not _there(path):
        raise InputError(
            f"there is no {KINDS[kind]} '{name}' in {shelf}; there is: {_names(shelf, name)}"
        )
    return path


def _there(path):
    return path.is_file() or data_table.has(path)


def _names(shelf, name):
    """Return the names in the folder `shelf`, or only those similar to `name` if there are many."""
    names = data_table.names(shelf)
    if len(names) > MANY:
        near = sorted(difflib.get_close_matches(name, names, n=5, cutoff=0.5))
        return ", ".join([*near, f"{len(names)} in all (raceway catalogue)"])
    return ", ".join(names) or "nothing"
