# SPDX-License-Identifier: GPL-2.0-or-later
"""The fuzzer: `python tests/fuzz/run.py --seed 1 --cases 100 --host liggghts`."""

import argparse
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[k]) for k in (1,)]

from fuzz import hostile, physics  # noqa: E402
from fuzz.deck import deck  # noqa: E402
from fuzz.draw import Draw  # noqa: E402
from fuzz.lab import HOSTS, Finding, Lab, Refused  # noqa: E402
from fuzz.oracles import ORACLES  # noqa: E402
from fuzz.scene import scene  # noqa: E402
from fuzz.shrink import shrink  # noqa: E402


def judge(drawn, name, seed, host, folder):
    """(verdict, message) of a scene under an oracle."""
    draw, lab = Draw(f"{seed} {name}"), Lab(Path(folder), host)
    try:
        if name == "hostile":
            text = hostile.spoil(draw, deck(drawn))
            if not hostile.isolated(text):
                return "refused", ""
            end = lab.start(text, "first")
            hostile.check(end, lab.folder)
            return "refused" if end.code else "passed", end.error
        first = lab.figures(drawn)
        physics.check(drawn, first, lab.folder / "first")
        ORACLES[name](drawn, first, lab, draw)
    except Refused as error:
        return "refused", str(error)
    except Finding as error:
        return "finding", str(error)
    return "passed", ""


def case(seed, host, only=None):
    """(oracle, verdict, message) of a seed."""
    name = only or Draw(seed).choice([*ORACLES, *["hostile"] * 8])
    with tempfile.TemporaryDirectory() as folder:
        return name, *judge(scene(seed), name, seed, host, folder)


def small(seed, host, only=None):
    """The smallest scene with the finding of a seed, and its oracle."""
    name, verdict, message = case(seed, host, only)
    kind = message.split(":")[0].split(" at ")[0]

    def fails(drawn):
        with tempfile.TemporaryDirectory() as folder:
            verdict, text = judge(drawn, name, seed, host, folder)
        return verdict == "finding" and text.startswith(kind)

    return shrink(scene(seed), fails), name, message


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--host", choices=HOSTS, default="liggghts")
    parser.add_argument("--oracle", choices=[*ORACLES, "hostile"])
    options = parser.parse_args()
    began, count = time.time(), Counter()
    for seed in range(options.seed, options.seed + options.cases):
        name, verdict, message = case(seed, options.host, options.oracle)
        count[verdict] += 1
        if verdict == "finding":
            print(f"{seed} {name}: {message}", flush=True)
    accepted = options.cases - count["refused"]
    print(f"{options.cases} cases, {accepted / options.cases:.0%} accepted, {count['finding']} "
          f"findings, {(time.time() - began) / options.cases:.2f} s a case")
    return 1 if count["finding"] else 0


if __name__ == "__main__":
    sys.exit(main())
