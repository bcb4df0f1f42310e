# SPDX-License-Identifier: GPL-2.0-or-later
"""The output of `raceway export` is read back: VTK files with meshio, and extended XYZ files
according to the specification of the format."""

import re
import xml.etree.ElementTree as ElementTree

import meshio
import numpy as np
import pytest
from commands import reply
from raceway import capacitance
from raceway.cli import main
from raceway.export import groove, ovito, paraview, particles
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER


def entries(pvd):
    """Return (time, part, path) for each entry of a .pvd file."""
    return [
        (float(one.get("timestep")), int(one.get("part")), pvd.parent / one.get("file"))
        for one in ElementTree.parse(pvd).getroot().iter("DataSet")
    ]


def test_groove_lies_on_its_torus(bearing):
    """The distance of every point from the circle of groove centres is the groove radius, and every
    quad faces the balls."""
    for side, clearance in ((INNER, 0.0), (OUTER, 4e-5)):
        points, quads = groove.mesh(bearing, side, clearance)
        radius = np.hypot(points[:, 0], points[:, 1])
        apart = np.hypot(radius - bearing.groove_circle(side, clearance), points[:, 2])
        assert apart == pytest.approx(bearing.groove(side), rel=1e-12)
        assert sorted(np.unique(quads)) == list(range(len(points)))
        a, b, c, _ = (points[quads[:, k]] for k in range(4))
        middle = points[quads].mean(axis=1)
        outwards = np.einsum("ni,ni->n", np.cross(b - a, c - b)[:, :2], middle[:, :2])
        assert np.all(outwards > 0) if side == INNER else np.all(outwards < 0)


def test_paraview(folder, lubricated, tmp_path):
    pvd = paraview.write(RunTables(folder), tmp_path / "vtk", every=3)
    listed = entries(pvd)
    assert len(listed) == 3 * 17 and all(path.exists() for *_, path in listed)
    times = [time for time, part, _ in listed if part == 0]
    assert times == pytest.approx(3 * np.arange(17) * lubricated["settings"]["sample_s"])
    # sample 6
    mesh = meshio.read(next(path for time, part, path in listed if part == 0 and time == times[2]))
    rows = {row[0]: row for row in lubricated["balls"][6]}
    assert mesh.point_data["id"].tolist() == list(range(1, 19))
    assert mesh.points.tolist() == [rows[k][2:5] for k in range(1, 19)]  # bitwise identical
    assert mesh.point_data["velocity"][3].tolist() == rows[4][5:8]
    assert np.unique(mesh.point_data["radius"][:9]) == lubricated["settings"]["ball_diameter_m"] / 2
    contact = {(row[0], row[2]): row for row in lubricated["contacts"][6]}
    names = lubricated["settings"]["contact_columns"].split()
    for name in ("load", "h_min", "capacitance"):
        for side, word in ((INNER, "inner"), (OUTER, "outer")):
            found = mesh.point_data[f"{name}_{word}"]
            for k in range(1, 19):
                if (k, side) in contact:
                    assert found[k - 1] == contact[k, side][names.index(name)]
                else:
                    assert np.isnan(found[k - 1]) if name == "h_min" else found[k - 1] == 0
    both = capacitance.ball(
        mesh.point_data["capacitance_inner"], mesh.point_data["capacitance_outer"]
    )
    assert mesh.point_data["capacitance"] == pytest.approx(both) and both.max() > 0


def test_inner_raceway_moves_and_turns(folder, lubricated, tmp_path, bearing):
    listed = entries(paraview.write(RunTables(folder), tmp_path, every=10))
    at_rest, _ = groove.mesh(bearing, INNER)
    for number, (time, _, path) in enumerate(one for one in listed if one[1] == 1):
        mesh = meshio.read(path)
        ring = next(row for row in lubricated["balls"][10 * number] if row[1] == 3)
        way = np.arctan2(*(mesh.points[0, [1, 0]] - ring[2:4][::-1])) - np.arctan2(
            *at_rest[0, [1, 0]]
        )
        # the error is that of rounding 25 mm to single precision twice
        assert np.angle(np.exp(1j * (way - ring[10] * time))) == pytest.approx(0, abs=1e-4)
        assert mesh.points.astype(float).mean(axis=0)[:2] == pytest.approx(ring[2:4], abs=1e-8)
    still = meshio.read(listed[2][2])
    # half of the clearance of 10 um, with values of type float32
    assert np.hypot(*still.points[4, :2]) == pytest.approx(bearing.outer_radius + 5e-6, abs=4e-9)


def test_a_shorter_export_leaves_nothing_of_a_longer(folder, tmp_path):
    paraview.write(RunTables(folder), tmp_path, every=4)
    kept = entries(paraview.write(RunTables(folder), tmp_path, every=24))
    assert {path for *_, path in kept} == set(tmp_path.glob("*.vtu"))


def read_xyz(path):
    """Return (comment, {column: values}) for every frame, following the specification of extended
    XYZ."""
    lines = iter(path.read_text().splitlines())
    for count in lines:
        head = next(lines)
        names = re.search(r"Properties=(\S+)", head).group(1).split(":")
        rows = [next(lines).split() for _ in range(int(count))]
        data, at = {}, 0
        for name, kind, width in zip(names[::3], names[1::3], map(int, names[2::3])):
            values = [row[at : at + width] for row in rows]
            data[name] = np.array(values, dtype={"S": str, "I": int, "R": float}[kind])
            at += width
        assert all(len(row) == at for row in rows)
        yield head, data


def test_ovito(folder, lubricated, tmp_path):
    run = RunTables(folder)
    frames = list(read_xyz(ovito.write(run, tmp_path / "xyz", every=1)))
    assert len(frames) == len(lubricated["balls"])
    head, data = frames[5]
    rows = {row[0]: row for row in lubricated["balls"][5]}
    assert data["species"].ravel().tolist() == 9 * ["ball"] + 9 * ["cage"]
    assert data["pos"] == pytest.approx(np.array([rows[k][2:5] for k in range(1, 19)]), rel=1e-11)
    assert data["velo"] == pytest.approx(np.array([rows[k][5:8] for k in range(1, 19)]), rel=1e-11)
    assert data["radius"].ravel()[:9] == pytest.approx(6.3e-3)
    frame = list(particles.frames(run, 1))[5]
    assert data["load"].ravel() == pytest.approx(frame.data["load"], rel=1e-11)
    assert data["h_min_inner"].ravel() == pytest.approx(
        np.nan_to_num(frame.data["h_min_inner"], nan=-1), rel=1e-11
    )
    assert float(re.search(r"Time=(\S+)", head).group(1)) == pytest.approx(
        5 * run.settings["sample_s"]
    )
    assert float(re.search(r"ring_y=(\S+)", head).group(1)) == pytest.approx(rows[19][3])
    low, span = (
        np.array(re.search(rf'{name}="([^"]*)"', head).group(1).split(), float)
        for name in ("Origin", "Lattice")
    )
    assert np.all(data["pos"] > low) and np.all(data["pos"] < low + span.reshape(3, 3).sum(axis=0))
    for name in ("inner", "outer"):
        surface = meshio.read(tmp_path / "xyz" / f"{name}_raceway.obj")
        assert (
            surface.cells[0].type == "quad"
            and surface.cells[0].data.max() == len(surface.points) - 1
        )


def test_so_many_samples_by_default(folder, monkeypatch):
    monkeypatch.setattr(particles, "FRAMES", 20)
    frames = list(particles.frames(RunTables(folder)))
    # 17 is the largest number below 20 that gives even spacing
    assert [frame.sample for frame in frames] == list(range(0, 49, 3))
    part = list(particles.frames(RunTables(folder, slice(6, 12)), 2))
    assert [frame.sample for frame in part] == [6, 8, 10] and part[0].ring_turned == 0


def test_dry_run_has_no_film_columns(dry_folder, tmp_path):
    frame = next(particles.frames(RunTables(dry_folder)))
    assert "load_inner" in frame.data and not [
        name for name in frame.data if name.startswith(("h_", "lambda", "capacitance"))
    ]


@pytest.mark.parametrize("format, name", [("vtk", "bearing.pvd"), ("xyz", "bearing.xyz")])
def test_command(folder, capsys, format, name):
    assert main(["export", str(folder), "--format", format, "--every", "20"]) == 0
    path = folder / format / name
    assert capsys.readouterr().out == f"{path}\n" and path.exists()
    assert not [left for left in path.parent.iterdir() if left.name.startswith(".")]


def test_complaints(folder, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert "cannot make the folder" in reply(
        capsys, ["export", folder, "--format", "vtk", "--out", tmp_path / "file"], code=1
    )
    (folder / "record.nc").write_text("nonsense\n")
    assert "record.nc" in reply(capsys, ["export", folder, "--format", "xyz"], code=1)
    assert not (folder / "xyz" / "bearing.xyz").exists()
