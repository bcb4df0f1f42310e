# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the CPU seconds of `make TARGET` in clean clones of this commit and another commit.

    .venv/bin/python tests/bench/build_time.py REV [--targets run,build] [--rounds 3]

Every measurement uses a clean clone and no compiler cache. The two revisions alternate, so that a
drift in the speed of the machine affects both. Run `make test` first: it installs missing Debian
packages and fills pip's cache. The script also counts the objects that are rebuilt after a change
to one part of the contact law. Uncommitted changes are not included.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from against import git
from machine import ROOT, spread

PART = "core/parts/part_drag.h"


def environment():
    """Return the environment of this process without the settings of the compiler cache and the
    virtual environment."""
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("CCACHE", "MAKE", "VIRTUAL"))}
    paths = [p for p in kept["PATH"].split(os.pathsep) if "ccache" not in p and ".venv" not in p]
    return {**kept, "CCACHE_DISABLE": "1", "PATH": os.pathsep.join(paths)}


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def build(revision, target, folder):
    """Clone `revision` into `folder`, and return the CPU and wall seconds of `make target`."""
    quiet = dict(check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["git", "clone", "-q", "--no-checkout", ROOT, folder], **quiet)
    subprocess.run(["git", "checkout", "-q", "--detach", revision], cwd=folder, **quiet)
    cpu, wall = cpu_seconds(), time.monotonic()
    done = subprocess.run(
        ["make", target],
        cwd=folder,
        env=environment(),
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    if done.returncode:
        sys.exit(f"make {target} of {revision} failed:\n{done.stdout[-3000:]}")
    return cpu_seconds() - cpu, time.monotonic() - wall


def made_again(folder):
    """Return how many objects in a built clone are rebuilt after `PART` has been edited."""
    seen = (folder / "build").rglob("*.d")
    return sum(PART in path.read_text() for path in seen)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("revision", help="commit to compare with")
    parser.add_argument("--targets", default="run,build", help="run,build,test")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    head, other = (
        git("rev-parse", "--short", f"{name}^{{commit}}") for name in ("HEAD", options.revision)
    )
    for target in options.targets.split(","):
        found = {head: [], other: []}
        for turn in range(options.rounds):
            for revision in (head, other):
                with tempfile.TemporaryDirectory() as top:
                    folder = Path(top) / "raceway"
                    cpu, wall = build(revision, target, folder)
                    print(f"make {target} of {revision}: CPU {cpu:.1f} s, {wall:.0f} s", flush=True)
                    found[revision].append((cpu, wall))
                    if target == "build" and turn == 0:
                        print(f"  {made_again(folder)} objects rebuilt after {PART}")
        ratios = [a[0] / b[0] for a, b in zip(found[head], found[other])]
        walls = {name: statistics.median(w for _, w in of) for name, of in found.items()}
        print(
            f"make {target}: {head} takes {spread(ratios, '.2f')} times the CPU seconds of {other}"
            f" (median of {len(ratios)} and range);"
            f" {walls[head]:.0f} and {walls[other]:.0f} s of wall time"
        )


if __name__ == "__main__":
    main()
