# SPDX-License-Identifier: GPL-2.0-or-later
"""Write a run for ParaView as a folder. The file `bearing.pvd` in it lists the files of all
frames."""

from pathlib import Path

import numpy as np

from raceway import files
from raceway.export import groove, pocket, vtu
from raceway.export.particles import frames
from raceway.files import FilePath
from raceway.runs.cage import pockets
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER


def write(tables: RunTables, out: FilePath, every: int | None = None) -> Path:
    """Write the run `tables` to the folder `out` and return the path of `bearing.pvd`, which is
    written last.

    Part 0 contains the balls as points with the `data` of `particles.frames`. Parts 1 and 2 are the
    surfaces of the inner and the outer raceway, whose points have their `azimuth` (rad) in the
    ring. The inner raceway moves and rotates; its tilt is omitted. Part 3 contains the pocket walls
    of a one-piece cage, with the `force` (N) of the ball on each pocket. Raises `RunError` if the
    run's files are invalid or `out` cannot be written.
    """
    out, entries, clearance = files.folder(out), [], tables.settings["clearance_m"]
    azimuth = np.repeat(np.arange(groove.AROUND) * 2 * np.pi / groove.AROUND, groove.ACROSS).astype(
        "f4"
    )
    points, quads = groove.mesh(tables.geometry, OUTER, clearance)
    _text(out / "outer_raceway.vtu", vtu.grid(points.astype("f4"), quads, {"azimuth": azimuth}))
    points, quads = groove.mesh(tables.geometry, INNER)
    for number, frame in enumerate(frames(tables, every)):
        names = f"balls_{number:05d}.vtu", f"inner_raceway_{number:05d}.vtu"
        _text(
            out / names[0],
            vtu.grid(frame.position, np.arange(len(frame.position))[:, None], frame.data),
        )
        c, s = np.cos(frame.ring_turned), np.sin(frame.ring_turned)
        moved = points @ [[c, s, 0], [-s, c, 0], [0, 0, 1]] + frame.ring
        _text(out / names[1], vtu.grid(moved.astype("f4"), quads, {"azimuth": azimuth}))
        names = (*names, "outer_raceway.vtu", *_pockets(tables, frame, number, out))
        entries += [(frame.time, part, name) for part, name in enumerate(names)]
    kept = {name for *_, name in entries}
    for old in (
        path
        for pattern in ("balls_*.vtu", "inner_raceway_*.vtu", "pockets_*.vtu")
        for path in out.glob(pattern)
    ):
        if old.name not in kept:  # left over from an earlier, longer export
            old.unlink()
    return _text(out / "bearing.pvd", vtu.series(entries))


def _pockets(tables, frame, number, out):
    """Write the pockets of a one-piece cage and yield the name of the file."""
    found = pockets(tables, frame.sample, frame.sample + 1)
    if found is None:
        return
    balls = ["ball_x", "ball_y", "ball_pocket_force"]
    x, y, force = (
        values[0] for values in tables.record.read(balls, frame.sample, frame.sample + 1).values()
    )
    centre = found.centre[0]
    apart = np.hypot(centre[:, None, 0] - x, centre[:, None, 1] - y)
    points, quads = pocket.mesh(tables.geometry, found.play)
    c, s = np.cos(found.turned[0]), np.sin(found.turned[0])
    moved = points @ [[c, s, 0], [-s, c, 0], [0, 0, 1]] + centre.mean(axis=0)
    data = {"force": np.repeat(force[apart.argmin(axis=1)], 2 * pocket.AROUND)}
    name = f"pockets_{number:05d}.vtu"
    _text(out / name, vtu.grid(moved.astype("f4"), quads, data))
    yield name


def _text(path, text):
    return files.text(path, text)
