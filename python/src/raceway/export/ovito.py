# SPDX-License-Identifier: GPL-2.0-or-later
"""Write a run for OVITO as a folder that contains `bearing.xyz`, an extended XYZ file with all
samples, and the raceways as `.obj` surfaces.

Columns have OVITO's standard names (species, id, pos, radius, velo) where these exist; the other
columns become custom properties. NaN is written as -1, for example where a ball has no film,
because not every reader of text files accepts NaN.
"""

from pathlib import Path

import numpy as np

from raceway import files
from raceway.export import groove
from raceway.export.particles import frames
from raceway.files import FilePath
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER

NAMES = {1: "ball", 2: "cage"}
KNOWN = {"velocity": "velo", "spin": "angular_velocity"}
FIRST = ("id", "type", "radius")


def write(tables: RunTables, out: FilePath, every: int | None = None) -> Path:
    """Write the run `tables` to the folder `out` and return the path of `bearing.xyz`.

    The comment line of each frame contains the cell, `Time` (s), `sample`, and the position
    `ring_x`, `ring_y`, `ring_z` (m) of the inner ring. The raceways do not move in the picture, and
    the outer raceway includes the clearance. Raises `RunError` if the run's files are invalid or
    `out` cannot be written.
    """
    out = files.folder(out)
    for side, name in ((INNER, "inner"), (OUTER, "outer")):
        text = _surface(*groove.mesh(tables.geometry, side, tables.settings["clearance_m"]))
        files.text(out / f"{name}_raceway.obj", text)
    half = 1.1 * (tables.geometry.outer_radius + tables.geometry.ball_radius)

    def make(part):
        with part.open("w") as file:
            for frame in frames(tables, every):
                file.write(_frame(frame, half))

    return files.whole(out / "bearing.xyz", make)


def _frame(frame, half):
    data = {name: values for name, values in frame.data.items() if name not in FIRST}
    table = np.column_stack([frame.position, frame.data["radius"], *data.values()])
    table[np.isnan(table)] = -1
    columns = "species:S:1:id:I:1:pos:R:3:radius:R:1" + "".join(
        f":{KNOWN.get(name, name)}:R:{1 if values.ndim == 1 else values.shape[1]}"
        for name, values in data.items()
    )
    cell = f"{2 * half:.6g} 0 0 0 {2 * half:.6g} 0 0 0 {2 * half:.6g}"
    ring = " ".join(f"ring_{x}={value:.12g}" for x, value in zip("xyz", frame.ring))
    head = (
        f'Lattice="{cell}" Origin="{-half:.6g} {-half:.6g} {-half:.6g}" pbc="F F F"'
        f" Properties={columns} Time={frame.time:.12g} sample={frame.sample} {ring}"
    )
    rows = (
        f"{NAMES[int(kind)]} {int(number)} " + " ".join(f"{value:.12g}" for value in row)
        for kind, number, row in zip(frame.data["type"], frame.data["id"], table)
    )
    return f"{len(table)}\n{head}\n" + "\n".join(rows) + "\n"


def _surface(points, quads):
    return "".join(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in points) + "".join(
        "f " + " ".join(str(number + 1) for number in quad) + "\n" for quad in quads
    )
