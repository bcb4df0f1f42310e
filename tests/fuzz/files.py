# SPDX-License-Identifier: GPL-2.0-or-later
"""Write files that commands read (runs, shafts, sweeps, data sets), either intact or damaged on
purpose.
"""

import shutil

from fuzz.draw import grammar
from host import ROOT, succeed

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


def runs(folder):
    """Run the small decks once and return their folders."""
    for name, variables in RUNS.items():
        succeed("inputs/in.6208", out=folder / name, **SHORT, **variables)
    succeed("inputs/in.many", out=folder / "many", bearings=3, time=2e-3, sample=5e-4, record="all")
    return [folder / name for name in RUNS]


def tables(folder, draw):
    """Write copies of the tables that come with the package; half of them are damaged."""
    made = {}
    for command, sources in TABLES.items():
        for number, file in enumerate(sources):
            text = (ROOT / file).read_text()
            if draw.chance(0.5):
                text = spoil_text(draw, text)
            to = folder / f"{command}{number}{'.csv' if command == 'SWEEP' else '.yaml'}"
            to.write_text(text, errors="surrogateescape")
            made.setdefault(command, []).append(to)
    return made


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
