# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures other than the overview show the right values for every kind of run."""

import shutil

import matplotlib.pyplot as plt
import numpy as np
import pytest
import synthetic
from commands import drawn, reply
from PIL import Image
from raceway import static
from raceway.cli import main
from raceway.errors import RunError
from raceway.pictures import animation, polar, waterfall
from raceway.pictures import bearing as still
from raceway.pictures.scene import COLOURS, nice, scene
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER


def test_polar_theory_is_the_static_solution(folder, lubricated, bearing):
    """The run consists of static solutions, so the dots lie on the curves. The centrifugal load on
    the balls, which is 0.1 N, is not included in the run."""
    dots = polar.theory(RunTables(folder))
    for side in (INNER, OUTER):
        loads = static.equilibrium(bearing, 5000.0, clearance=1e-5, phase=dots[side]["psi"][0])
        part = (loads.inner, loads.outer)[side]
        assert dots[side]["load"][0] == pytest.approx(part.load[0], abs=0.2)
        assert len(dots[side]["load"]) == len(dots[side]["h_c"]) > 10
    assert dots[INNER]["load"].max() == pytest.approx(
        max(row[6] for frame in lubricated["contacts"] for row in frame), rel=0.02
    )


def test_polar_has_no_theory_for_an_unknown_load(folder):
    run = RunTables(folder)
    run.contacts["angle"] = 0.2
    assert polar.theory(run) == {}
    run = RunTables(folder)
    run.settings["load_N"] = 0.0
    assert polar.theory(run) == {}


@pytest.mark.parametrize("kind", ["polar", "waterfall", "bearing", "motion"])
def test_kinds(folder, capsys, kind):
    assert main(["plot", str(folder), "--kind", kind]) == 0
    path = folder / f"{kind}.png"
    assert capsys.readouterr().out == f"{path}\n"
    drawn(path)
    assert path.stat().st_size < 300_000


@pytest.mark.parametrize("command", ["plot --kind polar", "plot --kind bearing", "animate"])
def test_balls_without_load(tmp_path, lubricated, capsys, command):
    frames = [[] for _ in lubricated["contacts"]]
    folder = synthetic.write(tmp_path / "run", dict(lubricated, contacts=frames))
    said = reply(capsys, [*command.split(), folder, "--out", tmp_path / "a.gif"], code=1)
    assert "no ball carries load in any sample" in said


@pytest.mark.parametrize("end, start", [(".pdf", b"%PDF"), (".SVG", b"<?xml"), ("", b"\x89PNG")])
def test_format_by_the_ending_of_the_name(folder, tmp_path, end, start):
    path = tmp_path / f"a{end}"
    assert main(["plot", str(folder), "--kind", "polar", "--out", str(path)]) == 0
    assert path.read_bytes().startswith(start)


@pytest.mark.parametrize("kind", ["polar", "bearing"])
def test_dry(dry_folder, kind):
    assert main(["plot", str(dry_folder), "--kind", kind]) == 0


def test_run_that_is_still_going(tmp_path, lubricated, capsys):
    rings = lubricated["rings"][:33]
    folder = synthetic.write(tmp_path / "run", {**lubricated, "rings": rings}, end=False)
    for command in (
        ["plot", "--kind", "polar"],
        ["plot", "--kind", "waterfall"],
        ["plot", "--kind", "bearing"],
        ["animate", "--frames", "2", "--width", "300"],
        ["export", "--format", "xyz"],
        ["export", "--format", "vtk"],
    ):
        assert main([command[0], str(folder), *command[1:]]) == 0, capsys.readouterr().err


def test_what_a_dry_run_lacks(dry_folder, capsys):
    for command in (
        ["plot", str(dry_folder), "--kind", "waterfall"],
        ["animate", str(dry_folder), "--colour", "film"],
    ):
        assert "a dry run does not have" in reply(capsys, command, code=1)


def test_bands_of_the_waterfall(folder, lubricated):
    run = RunTables(folder)
    samples, psi, each = waterfall.bands(run)
    assert samples.tolist() == list(range(49)) and psi.shape == each.shape == (49, 9)
    assert np.nansum(each, axis=1) == pytest.approx(run.bearing_capacitance)
    assert np.diff(psi, axis=0) == pytest.approx(2 * np.pi / 9 / 24)  # one ball pitch in 24 samples
    row = next(row for row in lubricated["balls"][7] if row[0] == 4)
    assert np.cos(psi[7, 3] - (np.arctan2(row[3], row[2]) + np.pi / 2)) == pytest.approx(1)


def test_bands_of_a_long_run_are_thinned(folder, monkeypatch):
    monkeypatch.setattr(waterfall, "ROWS", 30)
    samples, psi, each = waterfall.bands(RunTables(folder))
    assert samples.tolist() == list(range(0, 49, 2)) and len(psi) == len(each) == 25


def test_scene(folder, lubricated, bearing):
    """Touching bodies with an overlap d are drawn with an overlap of factor * d, and colours
    represent the values at the contacts."""
    run, samples, factor = RunTables(folder), np.array([3, 10, 20]), 20.0
    what = scene(run, samples, "load", factor)
    pitch = bearing.pitch_radius
    for k, sample in enumerate(samples):
        rows = {row[0]: np.array(row[2:5]) for row in lubricated["balls"][sample]}
        assert what.ring[k] == pytest.approx(factor * rows[19])
        for ball in range(9):
            place = rows[ball + 1]
            radius = np.hypot(*place[:2])
            drawn = np.hypot(*what.balls[k, ball, :2])
            outer = radius + bearing.ball_radius - bearing.outer_radius - 5e-6
            assert (
                drawn + bearing.ball_radius - bearing.outer_radius - what.half_clearance
                == pytest.approx(factor * outer, abs=1e-12)
            )
            assert drawn == pytest.approx(pitch + factor * (radius - pitch))
        loads = {}
        for row in lubricated["contacts"][sample]:
            loads[row[0]] = max(loads.get(row[0], 0), row[6])
        for ball in range(9):
            assert what.load[k, ball] == loads.get(ball + 1, 0)
            assert (
                np.isnan(what.values[k, ball])
                if ball + 1 not in loads
                else what.values[k, ball] == loads[ball + 1]
            )
    spin = 477.5 * np.pi / 30
    rolled = run.balls["omegaz"].iloc[0]
    assert what.turned[1] == pytest.approx(rolled * 10 * run.settings["sample_s"])
    assert what.ring_turned[2] == pytest.approx(spin * 20 * run.settings["sample_s"])


def test_factor_fits_the_largest_motion():
    assert [nice(0.75e-3, largest) for largest in (34.8e-6, 0.75e-3, 1.0, 0.0, 7.5e-6)] == [
        20.0,
        1.0,
        1.0,
        1.0,
        100.0,
    ]


@pytest.mark.parametrize("colour", COLOURS)
def test_colours(folder, colour):
    what = scene(RunTables(folder), np.arange(24), colour)
    largest = {"load": "load", "pressure": "pressure", "capacitance": "capacitance"}
    run = RunTables(folder)
    if colour in ("load", "pressure"):
        assert (
            np.nanmax(what.values)
            == run.contacts[run.contacts["sample"] < 24][largest[colour]].max()
        )
    elif colour == "film":
        loaded = run.contacts[
            (run.contacts["sample"] < 24)
            & (run.contacts["load"] > 0.01 * run.contacts["load"].max())
        ]
        assert np.nanmin(what.values) == loaded["h_min"].min()
    else:
        assert np.nansum(what.values, axis=1) == pytest.approx(run.bearing_capacitance[:24])


def pictures(path):
    """Return all frames of a GIF as arrays."""
    with Image.open(path) as gif:
        for k in range(gif.n_frames):
            gif.seek(k)
            yield np.asarray(gif.convert("RGB")).astype(int)


def test_gif(folder, tmp_path, capsys):
    out = tmp_path / "a.gif"
    command = ["animate", str(folder), "--passes", "1", "--frames", "6", "--width", "480", "--out"]
    assert reply(capsys, [*command, out]) == f"{out}\n"
    frames = list(pictures(out))
    assert len(frames) == 6 and abs(frames[0].shape[1] - 480) < 10
    assert all(np.any(a != b) for a, b in zip(frames, frames[1:]))
    assert main([*command, str(tmp_path / "again.gif")]) == 0
    assert (tmp_path / "again.gif").read_bytes() == out.read_bytes()
    assert not [left for left in tmp_path.iterdir() if left.name.startswith(".")]


def test_balls_of_a_gif_are_where_they_are(folder, tmp_path):
    """In every frame, the ball with the largest load, drawn in yellow, is at the position stated in
    the sample."""
    run, rgb = RunTables(folder), np.rint(255 * np.array(plt.get_cmap("cividis")(1.0)[:3]))
    sheet = still.Sheet(run, scene(run, np.array([0, 12])), "load")
    for k, sample in enumerate((0, 12)):
        sheet.show(k)
        sheet.figure.canvas.draw()
        picture = np.asarray(sheet.figure.canvas.buffer_rgba())[..., :3]
        ball = int(np.argmax(sheet.scene.load[k]))
        x, y = sheet.balls[ball].get_center()
        spot = sheet.balls[ball].axes.transData.transform((x, y))
        seen = picture[round(picture.shape[0] - spot[1]), round(spot[0])]
        expected = np.rint(
            255 * np.array(sheet.map(sheet.norm(sheet.scene.values[k, ball] * sheet.factor))[:3])
        )
        assert np.abs(seen - expected).max() <= 1
        row = next(
            row
            for row in run.balls[run.balls["sample"] == sample].itertuples()
            if row.id == ball + 1
        )
        assert np.arctan2(y, x) == pytest.approx(np.arctan2(row.y, row.x))
    assert np.abs(rgb - 255 * np.array(sheet.map(1.0)[:3])).max() <= 0.5
    plt.close(sheet.figure)


def test_run_of_full_complement(tmp_path):
    data = synthetic.run(passes=1, samples_per_pass=8)
    data["balls"] = [[row for row in frame if row[1] != 2] for frame in data["balls"]]
    assert animation.animation(
        RunTables(synthetic.write(tmp_path / "run", data)), tmp_path / "a.gif", frames=2, width=300
    ).exists()


@pytest.mark.parametrize(
    "options, said",
    [
        (["--passes", "3"], "has 2 ball passes, fewer than 3"),
        (["--out", "a.avi"], "a .gif or an .mp4"),
        (["--out", "no/where.gif"], "cannot write no/where.gif: No such file"),
    ],
)
def test_complaints(folder, capsys, options, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert said in reply(
        capsys, ["animate", folder, "--frames", "2", "--width", "300", *options], code=1
    )


def test_without_ffmpeg(folder, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(
        RunError,
        match=(
            "needs the program ffmpeg, which is missing: apt-get install ffmpeg, or name a .gif"
        ),
    ):
        animation.animation(RunTables(folder), tmp_path / "a.mp4")


def test_ffmpeg_gets_every_picture(folder, tmp_path, monkeypatch):
    """A substitute for ffmpeg saves its input, which consists of raw pictures of the expected size
    that all differ from one another."""
    program = tmp_path / "ffmpeg"
    program.write_text(
        '#!/bin/sh\necho "$@" > said\ncat > fed\nfor last; do :; done\ncp fed "$last"\n'
    )
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{shutil.os.environ['PATH']}")
    monkeypatch.chdir(tmp_path)
    out = animation.animation(RunTables(folder), tmp_path / "a.mp4", frames=3, width=300)
    said = (tmp_path / "said").read_text().split()
    width, height = map(int, said[said.index("-s") + 1].split("x"))
    fed = np.frombuffer(out.read_bytes(), np.uint8).reshape(3, height, width, 3)
    assert width % 2 == height % 2 == 0 and np.any(fed[0] != fed[1]) and np.any(fed[1] != fed[2])


def test_failing_ffmpeg_leaves_nothing(folder, tmp_path, monkeypatch):
    (tmp_path / "ffmpeg").write_text("#!/bin/sh\necho no such codec >&2\nexit 1\n")
    (tmp_path / "ffmpeg").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{shutil.os.environ['PATH']}")
    with pytest.raises(RunError, match="no such codec"):
        animation.animation(RunTables(folder), tmp_path / "a.mp4", frames=2, width=300)
    assert not list(tmp_path.glob("*.mp4*"))
