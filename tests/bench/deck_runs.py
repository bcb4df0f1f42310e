# SPDX-License-Identifier: GPL-2.0-or-later
"""Run decks as a user would, and read the cost of a run from its output folder."""

import re
import subprocess
import sys

from machine import ROOT

sys.path.insert(0, str(ROOT / "tests"))  # as pytest.ini does
from host import liggghts as liggghts  # noqa: E402
from host import succeed as succeed  # noqa: E402
from host import tables as tables  # noqa: E402

MAIN = "inputs/in.6208"


def command(deck, **variables):
    """Return the words of the command that runs a deck with these `-var` settings."""
    words = [ROOT / "build" / "liggghts", "-in", deck, "-log", "none"]
    for name, value in variables.items():
        words += ["-var", name, value]
    return [str(word) for word in words]


def attempt(deck, **variables):
    """Run a deck, and return the finished process with its output."""
    return subprocess.run(
        command(deck, **variables),
        cwd=ROOT,
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
    )


def run_deck(deck, **variables):
    """Run a deck and return its output; exit if the run fails."""
    done = attempt(deck, **variables)
    if done.returncode:
        sys.exit(f"{deck} failed:\n{done.stdout[-2000:]}")
    return done.stdout


def nanoseconds(text, steps):
    """Return the time in ns per step of the last run of a deck, from its output."""
    return float(re.findall(r"Loop time of (\S+) on", text)[-1]) / steps * 1e9


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
