# SPDX-License-Identifier: GPL-2.0-or-later
"""Kill runs at random moments, resume them, and compare every output file with the corresponding
file of an undisturbed run.

    .venv/bin/python tests/hosts/kills.py [N] [--seed S]

N runs receive kill -TERM, and N runs receive kill -9 (default: 50). A killed run is resumed, and
sometimes killed again, until it finishes. One half of the runs always uses one rank; the other half
alternates between 1 and 2 ranks. Only the wall time in `run.yaml` may differ; the exit code is 1 if
anything else differs.
"""

import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import host  # noqa: E402
from host import frames  # noqa: E402

FILES = ("record.nc", "contacts.dump", "balls.dump", "rings.dat")
DECK = "inputs/in.6208"
KEPT = {"passes": 10, "keep": 25, "dumps": "yes"}
SCENES = (
    {"lubricant": "mineral", "integrator": "implicit", "within": 5, **KEPT},
    {"models": "full", "integrator": "implicit", "within": 5, **KEPT},
    {"lubricant": "dry", "integrator": "verlet", "rpm": 9549, **KEPT},
)


@dataclass
class Story:
    """Events of one run."""

    kills: int = 0
    resumed: int = 0  # number of restarts from a restart file
    codes: tuple = ()
    different: tuple = ()  # files that differ from those of the reference run


def start(scene, out, *, ranks=1):
    """Run `scene` in a separate session with the output folder `out`, write its screen output to
    out.log, and resume the run if there is a restart file."""
    with open(f"{out}.log", "ab") as log:
        return host.start(DECK, out=out, resume="yes", ranks=ranks, output=log, **scene)


def run(scene, out):
    """Run `scene` without disturbance, and return its wall time in s."""
    begun = time.monotonic()
    code = start(scene, out).wait()
    assert code == 0, Path(f"{out}.log").read_text(errors="replace")[-2000:]
    return time.monotonic() - begun


def settings(folder):
    """Return the lines of `run.yaml` except for the wall and processor times, which are not results
    of the model."""
    return [
        line
        for line in (folder / "run.yaml").read_text().splitlines()
        if not line.startswith(("wall_s", "processor_s"))
    ]


def same(one, other):
    """Return whether two files are identical byte for byte, except for the order of rows within a
    frame, which depends on the number of ranks."""
    if one.read_bytes() == other.read_bytes():
        return True
    return (
        one.suffix == ".dump"
        and one.stat().st_size == other.stat().st_size
        and frames(one) == frames(other)
    )


def session(leader):
    """Return the processes of a session, with the leader last."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except (OSError, UnicodeDecodeError):
            continue  # the process has ended in the meantime
        if int(fields[3]) == leader and fields[0] != "Z":
            found.append(int(stat.parent.name))
    return sorted(found, reverse=True)


def ended(process, ranks):
    """Wait until a run ends, and return its exit code. Open MPI's launcher may hang while it exits
    after a signal; in this case it is killed once no ranks are left."""
    while True:
        try:
            return process.wait(20)
        except subprocess.TimeoutExpired:
            if ranks > 1 and session(process.pid) == [process.pid]:
                process.kill()


def disturb(scene, out, which, reference, length, dice, *, ranks=(1,)):
    """Run `scene` until it finishes, send it signals of type `which` at random moments within its
    duration `length` (s), and compare its output with `reference`."""
    story, attempt = Story(), -1
    while attempt < 100:
        attempt += 1
        process = start(scene, out, ranks=ranks[attempt % len(ranks)])
        # the first process always receives a signal, each later one with a probability of one half
        if attempt == 0 or dice.random() < 0.5:
            try:
                process.wait(dice.uniform(0.0, length))
            except subprocess.TimeoutExpired:
                # kill -9 is sent to all ranks, which would otherwise continue to write until they
                # detect that mpirun is gone; mpirun forwards USR1 to them by itself
                if which == signal.SIGKILL:
                    for pid in session(process.pid):
                        os.kill(pid, which)
                else:
                    process.send_signal(
                        signal.SIGUSR1 if ranks[attempt % len(ranks)] > 1 else which
                    )
                story.kills += 1
        code = ended(process, ranks[attempt % len(ranks)])
        story.codes += (code,)
        if code == 0 and story.kills:
            break
        if code == 0:  # the signal came too late to interrupt the run
            shutil.rmtree(out)
            attempt = -1
    story.resumed = Path(f"{out}.log").read_text(errors="replace").count("Continuing from")
    story.different = tuple(name for name in FILES if not same(out / name, reference / name))
    if settings(out) != settings(reference):
        story.different += ("run.yaml",)
    if (out / "restart.part").exists():
        story.different += ("part of a restart file left behind",)
    return story


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("number", nargs="?", type=int, default=50)
    parser.add_argument("--seed", type=int, default=6208)
    arguments = parser.parse_args()
    dice, bad = random.Random(arguments.seed), 0
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        lengths = [run(scene, folder / f"reference{k}") for k, scene in enumerate(SCENES)]
        for which in (signal.SIGTERM, signal.SIGKILL):
            stories = []
            for number in range(arguments.number):
                k = number % len(SCENES)
                ranks = ((1,), (1,), (1, 2), (2, 1))[number // 2 % 4]
                story = disturb(
                    SCENES[k],
                    folder / f"{which.name}{number}",
                    which,
                    folder / f"reference{k}",
                    lengths[k],
                    dice,
                    ranks=ranks,
                )
                stories.append(story)
                if story.different or story.codes[-1] != 0:
                    print(f"{which.name} {number}: {story}", flush=True)
            bad += sum(bool(s.different) or s.codes[-1] != 0 for s in stories)
            print(
                f"{which.name}: {len(stories)} runs, {sum(s.kills for s in stories)} signals,"
                f" {sum(s.resumed for s in stories)} resumed from a restart file,"
                f" {sum(not s.different for s in stories)} equal to the undisturbed run",
                flush=True,
            )
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
