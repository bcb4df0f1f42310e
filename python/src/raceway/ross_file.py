# SPDX-License-Identifier: GPL-2.0-or-later
"""Read a ROSS rotor from a file, which is either the output of `Rotor.save` (.toml, read with ROSS)
or contains the rotor's matrices (.npz, read without ROSS)."""

import zipfile
import zlib
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.theory import rotor_matrices

SUFFIXES = (".toml", ".npz")
NEEDED, OTHER = ("M", "K", "G", "z"), ("C",)
ROWS = 6000  # largest accepted number of rows of a matrix, enough for 1000 nodes
WRITE = "numpy.savez(FILE, M=r.M0, K=r.K0, C=r.C0, G=r.G0, z=r.nodes_pos) of a rotor r"


class Read(NamedTuple):
    """Contents of a file."""

    rotor: rotor_matrices.Rotor
    # m, positions of the rotor's own bearings, which are omitted; empty for an .npz file
    bearings: list[float]


def is_ross(path: FilePath) -> bool:
    """Return True if `path` has the suffix of a ROSS rotor, not of a YAML shaft file."""
    return Path(path).suffix in SUFFIXES


def read(path: FilePath) -> Read:
    """Read the rotor from the file at `path`. Raises `RacewayError` if the file is invalid, if it
    is a .toml file and ROSS is not installed, or if `rotor_matrices.rotor` rejects the rotor."""
    try:
        return _toml(path) if Path(path).suffix == ".toml" else _npz(path)
    except ValueError as error:
        raise RacewayError(f"{path}: {error}") from None


def of_ross(rotor: Any) -> Read:
    """Return a ROSS `rotor` without its bearings. Raises `ValueError` if `rotor_matrices.rotor`
    rejects the rotor."""
    places = np.asarray(rotor.nodes_pos, float)
    return Read(
        rotor_matrices.rotor(places, rotor.M0, rotor.K0, rotor.G0, rotor.C0),
        sorted({float(places[one.n]) for one in rotor.bearing_elements}),
    )


def _toml(path):
    try:
        import ross
    except ImportError as error:
        raise RacewayError(
            f"{path}: cannot load ROSS ({error}): pip install ross-rotordynamics 'plotly<7', or"
            f" write the matrices where ROSS is installed: {WRITE}, FILE ending in .npz"
        ) from None
    if not Path(path).is_file():
        raise RacewayError(f"cannot read {path}: there is no such file")
    try:
        loaded = ross.Rotor.load(str(path))
    except (OSError, KeyError, TypeError, ValueError, AttributeError) as error:
        raise RacewayError(f"{path}: ROSS cannot read it: {error!r}") from None
    return of_ross(loaded)


def _npz(path):
    try:
        _check_sizes(path)
        with np.load(path, allow_pickle=False) as file:
            data = {name: file[name] for name in file.files}
    except (OSError, ValueError, EOFError, RuntimeError, zipfile.BadZipFile, zlib.error) as error:
        raise RacewayError(f"cannot read {path}: {error}; {WRITE} writes it") from None
    known = (*NEEDED, *OTHER)
    if wrong := [name for name in data if name not in known]:
        raise ValueError(f"unknown '{wrong[0]}'; known: {', '.join(known)}; {WRITE} writes it")
    if lacks := [name for name in NEEDED if name not in data]:
        raise ValueError(f"has no {', '.join(lacks)}; {WRITE} writes it")
    names = dict(M="mass", K="stiffness", C="damping", G="gyroscopic", z="z")
    return Read(rotor_matrices.rotor(**{names[name]: one for name, one in data.items()}), [])


def _check_sizes(path):
    """Check the arrays by their headers before memory is allocated. Raises `ValueError`."""
    with zipfile.ZipFile(path) as archive:
        for member in archive.namelist():
            name = member.removesuffix(".npy")
            with archive.open(member) as file:
                read = {
                    (1, 0): np.lib.format.read_array_header_1_0,
                    (2, 0): np.lib.format.read_array_header_2_0,
                }.get(np.lib.format.read_magic(file))
                if read is None:
                    raise ValueError(f"'{name}' is not an array of real numbers")
                shape, _, kind = read(file)
            if kind.kind not in "fiu":
                raise ValueError(f"'{name}' has type {kind}; it must contain real numbers")
            if len(shape) > 2 or max(shape, default=0) > ROWS:
                size = " x ".join(map(str, shape))
                raise ValueError(
                    f"'{name}' is {size}; it must have at most {ROWS} rows and columns"
                )
