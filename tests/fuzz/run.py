# SPDX-License-Identifier: GPL-2.0-or-later
"""The fuzzer of the project, for long runs that are started by hand:

python tests/fuzz/run.py --seed 1 --cases 1000 --host lammps

A finding is reduced and written to build/fuzz; --replay runs such a file again. The fuzzer is
described in docs/extend.rst."""

import argparse
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import yaml

if __name__ == "__main__":
    sys.path[:0] = [str(Path(__file__).resolve().parents[1])]

from fuzz import files, hostile, main_deck, physics, reading
from fuzz.deck import deck
from fuzz.draw import Draw
from fuzz.lab import HOSTS, Finding, Lab, Refused
from fuzz.oracles import ORACLES
from fuzz.scene import scene
from fuzz.shrink import shrink, slim, whole
from host import ROOT

SHARES = dict.fromkeys(ORACLES, 4) | {"hostile": 16, "command": 14, "main_deck": 8}
FINDINGS = ROOT / "build" / "fuzz"


def judge(name, seed, host, drawn=None, runs=None):
    """Return (verdict, message) for a case, which is a scene with an oracle, a damaged deck, a
    command line, or a run of the main deck."""
    draw = Draw(f"{seed} {name}")
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(Path(folder), host)
        try:
            if name == "command":
                return reading.check(draw, Path(folder), runs), ""
            if name == "main_deck":
                main_deck.check(draw, Path(folder), host)
                return "passed", ""
            drawn = drawn or scene(seed)
            if name == "hostile":
                return hostile.check(draw, deck(drawn), lab), ""
            first = lab.figures(drawn)
            physics.check(drawn, first, lab.folder / "first")
            ORACLES[name](drawn, first, lab, draw)
        except Refused as error:
            return "refused", str(error)
        except Finding as error:
            return "finding", str(error)
    return "passed", ""


def oracle(seed):
    """Return the type of case that belongs to a seed."""
    return Draw(seed).choices(list(SHARES), SHARES.values())[0]


def report(name, seed, host, message):
    """Write a finding with its deck, after its scene has been reduced as far as possible."""
    FINDINGS.mkdir(parents=True, exist_ok=True)
    found = {"message": message, "oracle": name, "seed": seed, "host": host}
    if name in ORACLES:
        kind = message.split(":")[0].split(" at ")[0]

        def fails(drawn):
            verdict, text = judge(name, seed, host, drawn)
            return verdict == "finding" and text.startswith(kind)

        smallest = shrink(scene(seed), fails)
        found["scene"] = slim(smallest)
        (FINDINGS / f"in.{seed}").write_text(deck(smallest))
    elif name == "hostile":
        text = hostile.spoil(Draw(f"{seed} {name}"), deck(scene(seed)))
        (FINDINGS / f"in.{seed}").write_text(text)
    (FINDINGS / f"{seed}.yaml").write_text(
        yaml.safe_dump(found, sort_keys=False, default_flow_style=None)
    )


def series(seeds, host, only=None, runs=None, tell=lambda *words: None):
    """Return the verdicts of many cases and the messages of all findings."""
    count, found = Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        for seed in seeds:
            name = only or oracle(seed)
            if name == "command" and runs is None:
                runs = files.runs(Path(folder))
            verdict, message = judge(name, seed, host, runs=runs)
            count[verdict] += 1
            if verdict == "finding":
                found.append(f"{seed} {name}: {message}")
                tell(seed, name, message)
    return count, found


def replay(file, host=None):
    """Return (verdict, message) for a finding that has been saved to a file."""
    found = yaml.safe_load(Path(file).read_text())
    name, seed = found["oracle"], found["seed"]
    drawn = whole(found["scene"]) if "scene" in found else None
    with tempfile.TemporaryDirectory() as folder:
        runs = files.runs(Path(folder)) if name == "command" else None
        return judge(name, seed, host or found["host"], drawn, runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1, help="seed of the first case")
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--host", choices=HOSTS, default="liggghts")
    parser.add_argument("--oracle", choices=SHARES, help="run only this oracle")
    parser.add_argument("--replay", metavar="FILE", help="replay a finding from build/fuzz")
    options = parser.parse_args()
    if options.replay:
        verdict, message = replay(options.replay)
        print(verdict, message)
        return verdict == "finding"

    def tell(seed, name, message):
        print(f"{seed} {name}: {message}", flush=True)
        report(name, seed, options.host, message)

    began = time.time()
    seeds = range(options.seed, options.seed + options.cases)
    count, found = series(seeds, options.host, options.oracle, tell=tell)
    print(
        f"{options.cases} cases in {options.host}, {1 - count['refused'] / options.cases:.0%} "
        f"accepted, {len(found)} findings, {(time.time() - began) / options.cases:.2f} s per case"
    )
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
