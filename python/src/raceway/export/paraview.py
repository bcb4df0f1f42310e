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
from raceway.runs.record_tables import ring_place
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER


def write(tables: RunTables, out: FilePath, every: int | None = None) -> Path:
    """Write the run `tables` to the folder `out` and return the path of `bearing.pvd`, which is
    written last.

    Part 0 contains the balls as points with the `data` of `particles.frames`. Parts 1 and 2 are the
    surfaces of the inner and the outer raceway, whose points have their `azimuth` (rad) in the
    ring. They move and rotate with their rings; tilts are omitted. Part 3 contains the pocket walls
    of a one-piece cage, with the `force` (N) of the ball on each pocket. Raises `RunError` if the
    run's files are invalid or `out` cannot be written.
    """
    out, entries, clearance = files.folder(out), [], tables.settings["clearance_m"]
    azimuth = np.repeat(np.arange(groove.AROUND) * 2 * np.pi / groove.AROUND, groove.ACROSS).astype(
        "f4"
    )
    points, quads = groove.mesh(tables.geometry, OUTER, clearance)
    outer_points, outer_motion = points, _outer_ring(tables)
    if outer_motion is None:
        _text(out / "outer_raceway.vtu", vtu.grid(points.astype("f4"), quads, {"azimuth": azimuth}))
    points, quads = groove.mesh(tables.geometry, INNER)
    for number, frame in enumerate(frames(tables, every)):
        names = f"balls_{number:05d}.vtu", f"inner_raceway_{number:05d}.vtu"
        _text(
            out / names[0],
            vtu.grid(frame.position, np.arange(len(frame.position))[:, None], frame.data),
        )
        moved = _moved(points, frame.ring_turned, frame.ring)
        _text(out / names[1], vtu.grid(moved, quads, {"azimuth": azimuth}))
        if outer_motion is None:
            names = *names, "outer_raceway.vtu"
        else:
            names = *names, f"outer_raceway_{number:05d}.vtu"
            angle, place = (one[frame.sample - tables.first] for one in outer_motion)
            moved = _moved(outer_points, angle, place)
            _text(out / names[2], vtu.grid(moved, quads, {"azimuth": azimuth}))
        names = (*names, *_pockets(tables, frame, number, out))
        entries += [(frame.time, part, name) for part, name in enumerate(names)]
    kept = {name for *_, name in entries}
    for old in (
        path
        for pattern in ("balls_*.vtu", "inner_raceway_*.vtu", "outer_raceway*.vtu", "pockets_*.vtu")
        for path in out.glob(pattern)
    ):
        if old.name not in kept:  # left over from an earlier, longer export
            old.unlink()
    return _text(out / "bearing.pvd", vtu.series(entries))


def _outer_ring(tables):
    """Return the angle (N,) in rad and the position (N, 3) in m of the outer ring at the samples of
    the run, or None if it does not move."""
    record, window = tables.record, (tables.first, tables.last)
    if OUTER not in record.fixed("ring_raceway"):
        return None
    angle = tables.turning.ring(OUTER, *window)
    place = np.stack(ring_place(record, OUTER, *window)[:3], axis=-1)
    return (angle, place) if angle.any() or place.any() else None


def _moved(points, angle, place):
    """Return `points` (n, 3) after a rotation by `angle` about the axis and a displacement."""
    c, s = np.cos(angle), np.sin(angle)
    return (points @ [[c, s, 0], [-s, c, 0], [0, 0, 1]] + place).astype("f4")


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
    moved = _moved(points, found.turned[0], centre.mean(axis=0))
    data = {"force": np.repeat(force[apart.argmin(axis=1)], 2 * pocket.AROUND)}
    name = f"pockets_{number:05d}.vtu"
    _text(out / name, vtu.grid(moved, quads, data))
    yield name


def _text(path, text):
    return files.text(path, text)
