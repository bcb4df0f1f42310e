# SPDX-License-Identifier: GPL-2.0-or-later
"""Write VTK's XML format for points and quads, and the list of files in a time series (VTK User's
Guide, "VTK File Formats").

The format is implemented here because this takes only a few lines, whereas libraries that write it
require a mesh database or a renderer. The tests read the files with meshio.
"""

import base64
import sys
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from raceway.arrays import Floats

VERTEX, QUAD = 1, 9  # cell types
TYPES = {"f4": "Float32", "f8": "Float64", "i4": "Int32", "u1": "UInt8"}
ORDER = "LittleEndian" if sys.byteorder == "little" else "BigEndian"


def grid(points: Floats, cells: ArrayLike, data: Mapping[str, NDArray[Any]]) -> str:
    """Return the text of a .vtu file. It contains `points` (n, 3), `cells` of point indices, (m, 1)
    for vertices or (m, 4) for quads, and the point data `data` {name: array (n,) or (n, 3)}."""
    cells = np.asarray(cells)
    kind = QUAD if cells.shape[1] == 4 else VERTEX
    parts = [
        "<PointData>",
        *(_array(values, name) for name, values in data.items()),
        "</PointData>",
        "<Points>",
        _array(points, "Points"),
        "</Points>",
        "<Cells>",
        _array(cells.astype("i4").ravel(), "connectivity"),
        _array(cells.shape[1] * np.arange(1, len(cells) + 1, dtype="i4"), "offsets"),
        _array(np.full(len(cells), kind, dtype="u1"), "types"),
        "</Cells>",
    ]
    piece = f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">'
    return _file(
        "UnstructuredGrid", "\n".join([piece, *parts, "</Piece>"]), ' header_type="UInt32"'
    )


def series(entries: Iterable[tuple[float, int, str]]) -> str:
    """Return the text of a .pvd file that lists the `entries` (time, part number, file name)."""
    return _file(
        "Collection",
        "\n".join(
            f'<DataSet timestep="{time:.12g}" part="{part}" file="{name}"/>'
            for time, part, name in entries
        ),
    )


def _file(kind, inside, options=""):
    return (
        f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="0.1"'
        f' byte_order="{ORDER}"{options}>\n<{kind}>\n{inside}\n</{kind}>\n</VTKFile>\n'
    )


def _array(values, name):
    values = np.ascontiguousarray(values)
    if values.dtype.kind == "i" and values.dtype.itemsize != 4:
        values = values.astype("i4")
    raw = values.tobytes()
    text = base64.b64encode(np.uint32(len(raw)).tobytes() + raw).decode()
    width = f' NumberOfComponents="{values.shape[1]}"' if values.ndim > 1 else ""
    return (
        f'<DataArray type="{TYPES[values.dtype.str[1:]]}" Name="{name}"{width}'
        f' format="binary">{text}</DataArray>'
    )
