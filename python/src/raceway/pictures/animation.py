# SPDX-License-Identifier: GPL-2.0-or-later
"""Animate a bearing as a GIF or, if ffmpeg is available, as an MP4."""

import shutil
import subprocess
import tempfile
from itertools import chain
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgba_array
from PIL import Image

from raceway import files, progress
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.pictures import style
from raceway.pictures.bearing import CAGE, IDLE, STEEL, Sheet
from raceway.pictures.scene import scene
from raceway.runs.tables import RunTables

INCHES = 9.6  # width of the figure
COLOURS, GREYS = 32, 24  # numbers of colours and greys in the palette of a GIF


def animation(
    tables: RunTables,
    path: FilePath,
    colour: str = "load",
    passes: float | None = None,
    frames: int = 80,
    rate: int = 20,
    factor: float | None = None,
    width: int = 800,
) -> Path:
    """Animate the run `tables`, write the animation to `path`, which must end in .gif or .mp4, and
    return the `Path`.

    The animation shows `passes` ball passes (None: all measured passes, but at most 4) in `frames`
    frames that are evenly spaced in time, at `rate` frames per second. It is `width` pixels wide;
    `colour` and `factor` are as in `scene.scene`. GIFs of the same run are bitwise identical.
    Raises `RunError` if the run's files are invalid or contain fewer passes, or if the animation
    cannot be written.
    """
    kind = str(path).lower().rpartition(".")[2]
    if kind not in WRITERS:
        raise RunError(f"{path}: an animation must be a .gif or an .mp4")
    if kind == "mp4" and not shutil.which("ffmpeg"):
        raise RunError(
            f"{path}: writing an MP4 needs the program ffmpeg, which is missing: apt-get install"
            " ffmpeg, or name a .gif"
        )
    tables, samples = _window(tables, passes, frames)
    with plt.rc_context(style.STYLE):
        sheet = Sheet(
            tables,
            scene(tables, samples, colour, factor),
            colour,
            dpi=2 * round(width / INCHES / 2),
        )
        try:
            return files.whole(
                path, lambda part: WRITERS[kind](part, _pictures(sheet, len(samples)), rate)
            )
        finally:
            plt.close(sheet.figure)


def _window(tables, passes, frames):
    """Return the part of the run `tables` that is needed, and the samples to draw."""
    have = len(tables.record) - tables.first
    if have < 1:
        raise RunError(f"{tables.folder} contains no sample to draw")
    way = tables.passes(tables.first + np.arange(have))
    way = way - way[0]
    # the cage slips, so there may be fewer passes than requested: accept the number in the deck
    if passes is not None and passes > max(way[-1], tables.settings["passes"]) + 0.5 / have:
        raise RunError(f"{tables.folder} has {way[-1]:.3g} ball passes, fewer than {passes:g}")
    wanted = max(int(np.searchsorted(way, 4.0 if passes is None else passes)), 1)
    wanted = min(wanted, have)
    part = tables.window(slice(tables.first, tables.first + wanted))
    return part, tables.first + np.unique(np.arange(frames) * wanted // frames)


def _pictures(sheet, count):
    """Yield each frame as an array (height, width, 3) of bytes."""
    for k in range(count):
        sheet.show(k)
        sheet.figure.canvas.draw()
        progress.line(f"frame {k + 1} of {count}", k + 1 == count)
        # copied, because the next frame is drawn into the same buffer
        yield np.array(sheet.figure.canvas.buffer_rgba())[..., :3]


def _gif(part, pictures, rate):
    palette = _palette()
    first, *rest = (
        Image.fromarray(picture).quantize(palette=palette, dither=Image.Dither.NONE)
        for picture in pictures
    )
    first.save(
        part,
        format="GIF",
        save_all=True,
        append_images=rest,
        duration=round(1000 / rate),
        loop=0,
        optimize=True,
    )


def _palette():
    """Return one palette for all frames, so that parts of the picture that do not change take no
    space. A single palette suffices because the frames have few colours."""
    scale = plt.get_cmap(style.MAP)(np.linspace(0, 1, COLOURS))[:, :3]
    grey = np.repeat(np.linspace(0, 1, GREYS)[:, None], 3, axis=1)
    flat = to_rgba_array([STEEL, CAGE, IDLE, style.INK, style.SOFT, style.FAINT])[:, :3]
    image = Image.new("P", (1, 1))
    image.putpalette(np.rint(255 * np.concatenate([scale, grey, flat])).astype(np.uint8).tobytes())
    return image


def _mp4(part, pictures, rate):
    first = next(pictures)
    # the common pixel format yuv420p requires an even width and height
    height, width = (size - size % 2 for size in first.shape[:2])
    command = [
        "ffmpeg",
        "-v",
        "error",
        "-y",
        "-f",
        "rawvideo",
        "-pix_fmt",
        "rgb24",
        "-s",
        f"{width}x{height}",
        "-r",
        f"{rate:g}",
        "-i",
        "-",
        "-pix_fmt",
        "yuv420p",
        "-f",
        "mp4",
        str(part),
    ]
    with tempfile.TemporaryFile() as said:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=said) as program:
            try:
                for picture in chain([first], pictures):
                    program.stdin.write(np.ascontiguousarray(picture[:height, :width]).tobytes())
                program.stdin.close()
            except BrokenPipeError:
                pass  # ffmpeg has stopped and has printed the reason
        if program.returncode:
            said.seek(0)
            raise RunError(
                "ffmpeg could not write the animation:"
                f" {said.read().decode(errors='replace').strip()[-300:]}"
            )


WRITERS = {"gif": _gif, "mp4": _mp4}
