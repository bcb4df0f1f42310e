# SPDX-License-Identifier: GPL-2.0-or-later
"""Write files that commands read (runs, shafts, sweeps, data sets, readings, recordings), either
intact or damaged on purpose.
"""

import shutil

import numpy as np
from fuzz.draw import grammar
from host import ROOT, succeed
from scipy import io
from scipy.io import wavfile

SHORT = {"passes": 1, "samples": 20, "settle": 0.1}
RUNS = {
    "usual": {},
    "dry": {"lubricant": "dry"},
    "full": {"models": "full", "surroundings": "cavitated", "axial": 500},
    "angular": {"bearing": "7205B", "axial": 800, "load": 300, "moment_x": 1},
    "four_point": {"four_point": 35, "clearance": -4e-6, "axial": 1000},
    "summary": {"record": "summary"},
    "dumps": {"record": "none", "dumps": "yes"},
}
TABLES = {
    "SHAFT": ["inputs/shafts/motor", "inputs/shafts/rotor"],
    "SWEEP": ["docs/decks/sweep.csv"],
    "DATASET": ["inputs/datasets/small.yaml", "inputs/datasets/spalls.yaml"],
}
DECK = ROOT / "inputs" / "in.6208"
READINGS = """bearing: 6205
lubricant: vg68
models: paper
known: {load: 10, axial: 30, temperature: 40}
unknown: {clearance: 0 15e-6}
readings:
  - {rpm: 1797, BPFO: 3.5972, within: 2e-4}
  - {rpm: 1797, axial_more: 200, capacitance: 25e-12, within: 1e-12}
"""
LINES = "speed_Hz,bpfo_Hz,ftf_Hz\n29.95,107.74,11.971\n30,107.9,11.98\n"
SERIES = """bearing: 6205
lubricant: vg68
models: paper
known: {load: 10, axial: 100}
unknown: {clearance: 0 15e-6, temperature: 20 90}
series: hours.csv
within: {BPFO: 1e-4, capacitance: 0.1e-12}
drift: {clearance: 2e-6, temperature: 25}
"""
HOURS = "time_s,rpm,BPFO,capacitance\n0,1797,3.60,25e-12\n600,1797,3.6,\n1200,1797,3.601,24e-12\n"


def runs(folder):
    """Run the small decks once and return their folders."""
    for name, variables in RUNS.items():
        succeed("inputs/in.6208", out=folder / name, **SHORT, **variables)
    succeed("inputs/in.many", out=folder / "many", bearings=3, time=2e-3, sample=5e-4, record="all")
    return [folder / name for name in RUNS]


def tables(folder, draw):
    """Write copies of the tables that come with the package, and readings and a recording; half of
    them are damaged."""
    texts = {
        command: [(ROOT / source).read_text() for source in sources]
        for command, sources in TABLES.items()
    }
    texts |= {"READINGS": [READINGS], "LINES": [LINES], "SERIES": [SERIES]}
    made = {"DECK": [DECK], "RECORDING": [recording(folder, draw)]}
    for command, some in texts.items():
        for number, text in enumerate(some):
            end = ".csv" if command in ("SWEEP", "LINES") else ".yaml"
            to = folder / f"{command}{number}{end}"
            _write(to, text, draw)
            made.setdefault(command, []).append(to)
    _write(folder / "hours.csv", HOURS, draw)
    return made


def _write(to, text, draw):
    to.write_text(spoil_text(draw, text) if draw.chance(0.5) else text, errors="surrogateescape")


def recording(folder, draw):
    """Write a recording of a bearing in one of the formats, and return its path. Half of the files
    are damaged."""
    time = np.arange(3000) / 12e3
    values = np.sin(2 * np.pi * 108 * time) * np.sin(2 * np.pi * 3e3 * time)
    name = draw.choice(["105.mat", "a.npz", "a.wav", "a.csv"])
    to = folder / name
    if name == "105.mat":
        columns = {"X105_DE_time": values[:, None], "X105RPM": 1797.0}
        io.savemat(to, columns, do_compression=draw.chance(0.5))
    elif name == "a.npz":
        draw.choice([np.savez, np.savez_compressed])(to, DE=values)
    elif name == "a.wav":
        wavfile.write(to, 12000, (1e4 * values).astype(np.int16))
    else:
        rows = [f"{t:.9g},{v:.6g}" for t, v in zip(time, values)]
        to.write_text("\n".join(["time_s,acceleration_g", *rows, ""]))
    if draw.chance(0.5):
        data = bytearray(to.read_bytes())
        del data[draw.randrange(len(data)) :]  # transferred only in part
        to.write_bytes(data)
    return to


def spoil_text(draw, text):
    """Change a value, drop or repeat a line, change an indentation, or swap two lines."""
    lines = text.splitlines()
    for _ in range(draw.choice([1, 1, 2, 4])):
        i = draw.randrange(len(lines))
        kind = draw.choice(
            ["value", "value", "value", "drop", "repeat", "indent", "swap", "nest", "cut"]
        )
        words = lines[i].replace(",", " , ").replace("{", "{ ").replace("}", " }").split(" ")
        if kind == "value":
            hostile = grammar("hostile")
            numbers = [k for k, word in enumerate(words) if word[:1] in "-0123456789" and word]
            k = draw.choice(numbers) if numbers else draw.randrange(len(words))
            words[k] = draw.choice(
                [
                    *hostile["numbers"],
                    *hostile["words"],
                    "[1, 2]",
                    "{a: 1}",
                    "null",
                    "~",
                    "2026-01-01",
                    "yes",
                ]
            )
            lines[i] = " ".join(words)
        elif kind == "drop":
            del lines[i]
            lines = lines or [""]
        elif kind == "repeat":
            lines.insert(draw.randrange(len(lines)), lines[i])
        elif kind == "indent":
            lines[i] = draw.choice(["  ", "\t", " - "]) + lines[i]
        elif kind == "swap":
            k = draw.randrange(len(lines))
            lines[i], lines[k] = lines[k], lines[i]
        elif kind == "nest":
            lines[i] += draw.choice(
                ["[" * 3000, "{a: " * 2000, "&a [*a]", "!!python/object:os.system", "\0", "é"]
            )
        else:
            lines[i] = lines[i][: draw.randrange(len(lines[i]) + 1)]
    return "\n".join([*lines, ""])


def damaged(draw, run, folder):
    """Write a copy of a run in which bytes of one file have been changed, cut or swapped."""
    to = folder / "damaged"
    shutil.copytree(run, to)
    files = sorted(file for file in to.iterdir() if file.is_file() and file.stat().st_size)
    file = draw.choice([*files, *(f for f in files for _ in range(2) if f.name == "record.nc")])
    data = bytearray(file.read_bytes())
    kind = draw.choice(["bits", "bits", "head", "head", "cut", "add", "zero", "text", "gone"])
    if kind == "gone":
        file.unlink()
        return to, f"{file.name} gone"
    if kind == "text" and file.suffix != ".nc":
        file.write_text(spoil_text(draw, data.decode(errors="replace")), errors="surrogateescape")
        return to, f"{file.name} text"
    end = min(len(data), 4000) if kind == "head" else len(data)
    at = draw.randrange(end)
    if kind == "cut":
        data = data[:at]
    elif kind == "add":
        data += bytes(draw.choice([1, 8, 4096]))
    elif kind == "zero":
        data[at : at + 512] = bytes(len(data[at : at + 512]))
    else:
        data[at] ^= 1 << draw.randrange(8)
    file.write_bytes(data)
    return to, f"{file.name} {kind} {at}"
