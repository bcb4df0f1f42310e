# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the cost of a step in this tree with that in another revision or another tree.

    python3 tests/bench/against.py REVISION|FOLDER [--rounds 9] [--out PAGE]

REVISION is a git revision, which is built in a temporary worktree; FOLDER is the root of a tree
that has already been built. Each tree runs its own decks with its own program. The two trees take
turns at going first, and ratios are formed within each round. The cost is the user processor time
of the steps, i.e. the time of a run minus the time of a run with a tenth of the steps. If the
kernel counts instructions (`perf stat`), the ratio of the instruction counts is given, too; it does
not depend on the load of the machine.

For each scene, the page lists the median and the range of the ratios.
"""

import argparse
import contextlib
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from datetime import date
from pathlib import Path

from machine import ROOT, machine
from machine import spread as spread_of

IMPLICIT, VERLET = ("in.implicit_cost", 20_000), ("in.cost", 100_000)
SCENES = [  # name, (deck, steps), variables
    ("dry, implicit", IMPLICIT, {"lubricant": "dry"}),
    ("paper, implicit", IMPLICIT, {}),
    ("paper, implicit, five degrees of freedom", IMPLICIT, {"tilts": 1}),
    ("film, implicit", IMPLICIT, {"models": "film"}),
    ("full, implicit", IMPLICIT, {"models": "full"}),
    ("dry, Verlet", VERLET, {"lubricant": "dry"}),
    ("paper, Verlet", VERLET, {}),
    ("film, Verlet", VERLET, {"models": "film", "dt": 1e-7}),
    ("full, Verlet", VERLET, {"models": "full", "dt": 1e-7}),
]


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("other", help="a git revision, or the root of a tree that has been built")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--out", type=Path, help="also write the page to this file")
    return parser.parse_args(arguments)


@contextlib.contextmanager
def built(other):
    """Yield the root of the tree with which this tree is compared."""
    if Path(other).is_dir():
        yield Path(other).resolve()
        return
    folder = Path(tempfile.mkdtemp(prefix="against-"))
    tree = folder / "tree"
    try:
        git("worktree", "add", "--detach", "-q", str(tree), other)
        subprocess.run(["make", "-s", "-j2", "build/liggghts"], cwd=tree, check=True)
        yield tree
    finally:
        subprocess.run(["git", "-C", ROOT, "worktree", "remove", "--force", tree], check=False)
        shutil.rmtree(folder, ignore_errors=True)


def git(*words):
    done = subprocess.run(["git", "-C", ROOT, *words], check=True, capture_output=True, text=True)
    return done.stdout.strip()


def counts():
    """Return whether `perf stat` can count instructions on this machine."""
    if not shutil.which("perf"):
        return False
    done = subprocess.run(
        ["perf", "stat", "-x,", "-e", "instructions:u", "true"], capture_output=True, text=True
    )
    return done.returncode == 0 and done.stderr.split(",")[0].strip().isdigit()


def program(tree, deck, variables, instructions):
    """Run a deck in a tree; return (user seconds, instructions or None)."""
    words = [str(tree / "build/liggghts"), "-in", str(deck), "-log", "none"]
    for name, value in variables.items():
        words += ["-var", name, str(value)]
    with tempfile.NamedTemporaryFile("r") as report:
        if instructions:
            words = ["perf", "stat", "-x,", "-e", "instructions:u", "-o", report.name, *words]
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        environment = dict(os.environ, OMP_NUM_THREADS="1")
        done = subprocess.run(words, cwd=tree, env=environment, capture_output=True, text=True)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        if done.returncode:
            sys.exit(f"{' '.join(words)} in {tree}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        counted = [line for line in report.read().splitlines() if "instructions" in line]
    return seconds, int(counted[0].split(",")[0]) if counted else None


def cost(tree, scene, instructions):
    """Return (seconds, instructions or None) for the last nine tenths of the steps."""
    _, (deck, steps), variables = scene
    long, short = (
        program(tree, f"tests/bench/{deck}", {**variables, "steps": count}, instructions)
        for count in (steps, steps // 10)
    )
    return [a - b if instructions or k == 0 else None for k, (a, b) in enumerate(zip(long, short))]


def ratios(other, rounds, instructions):
    """Return a dict that maps each scene to ([ratios of seconds], [ratios of instructions])."""
    found = {scene[0]: ([], []) for scene in SCENES}
    for n in range(rounds):
        for scene in SCENES:
            trees = [ROOT, other] if n % 2 else [other, ROOT]
            by_tree = {tree: cost(tree, scene, instructions) for tree in trees}
            for k in range(2 if instructions else 1):
                found[scene[0]][k].append(by_tree[ROOT][k] / by_tree[other][k])
        print(f"round {n + 1} of {rounds}", file=sys.stderr)
    return found


def spread(values):
    return spread_of(values, ".3f") if values else "-"


def page(name, found, rounds):
    here = git("rev-parse", "--short", "HEAD")
    lines = [
        f"Cost of a step in {here} divided by that in {name}, {date.today()}; {rounds} rounds.",
        "Median (range) of the ratios within a round; if above 1, this tree is slower.",
        "",
        f"{'scene':44} {'user seconds':28} instructions",
    ]
    lines += [f"{scene:44} {spread(s):28} {spread(i)}" for scene, (s, i) in found.items()]
    return "\n".join([*lines, "", *machine()]) + "\n"


def main(arguments=None):
    options = parsed(arguments)
    if not (ROOT / "build/liggghts").exists():
        sys.exit("build/liggghts is missing: run `make run` or `make build` first")
    with built(options.other) as other:
        text = page(options.other, ratios(other, options.rounds, counts()), options.rounds)
    print(text, end="")
    if options.out:
        options.out.write_text(text)


if __name__ == "__main__":
    main()
