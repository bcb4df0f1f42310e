# SPDX-License-Identifier: GPL-2.0-or-later
"""Run decks as a user would, and read the cost of a run from its output folder."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def run_deck(deck, **variables):
    """Run a deck with these `-var` settings and return its output; exit if the run fails."""
    words = [ROOT / "build" / "liggghts", "-in", deck, "-log", "none"]
    for name, value in variables.items():
        words += ["-var", name, str(value)]
    done = subprocess.run(
        [str(word) for word in words],
        cwd=ROOT,
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
    )
    if done.returncode:
        sys.exit(f"{deck} failed:\n{done.stdout[-2000:]}")
    return done.stdout


def cost(folder):
    """Return {"wall_s", "simulated_s", "evaluations", ...: number} for a finished run."""
    found = {}
    for line in (folder / "run.yaml").read_text().splitlines():
        name, _, value = line.partition(": ")
        try:
            found[name] = float(value)
        except ValueError:
            continue
    return found


def factor(folder):
    """Return the real-time factor of a run."""
    found = cost(folder)
    return found["simulated_s"] / found["wall_s"]
