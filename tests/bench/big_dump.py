# SPDX-License-Identifier: GPL-2.0-or-later
"""A run larger than memory should need: simulates a 6208 until contacts.dump holds 2 GB, looks at
it in every way the package has, and writes seconds and memory to docs/performance/large_runs.rst.

    .venv/bin/python tests/bench/big_dump.py [GIGABYTES [FOLDER]]

FOLDER (default build/run/large) needs half as much again; a run that is there and large enough is
used again, and one made here is left for that. Exit code 1 when anything needs 1 GB of memory or
fails.
"""

import subprocess
import sys
import time
from datetime import date
from pathlib import Path

from machine import machine

ROOT = Path(__file__).resolve().parents[2]
LIMIT = 1000  # MB
TASKS = {  # name: what is done to `run`, in a process of its own
    "load the package only": "",
    "all figures (`raceway summary`)": "run.summary()",
    "bearing totals, every sample": "run.bearing",
    "regime shares around the ring": "from raceway.runs.regimes import shares; shares(run)",
    "pressure and permittivity around the ring": (
        "from raceway.runs.electrical import by_raceway; by_raceway(run)"
    ),
    "losses, every sample": "from raceway.runs.losses import losses; losses(run)",
    "spectrum of the ring, lines found": (
        "from raceway.runs.spectrum import lines, of_run; lines(run, of_run(run))"
    ),
    "largest load of each ball, from blocks of datasets": (
        "import functools, numpy; functools.reduce(numpy.maximum, (b['load'].max('time') for b in"
        " run.blocks('contacts')))"
    ),
    "one ball pass from the middle as datasets": (
        "raceway.open(sys.argv[1], slice(MIDDLE, MIDDLE + 200)).contacts['load'].max()"
    ),
    "MDAnalysis: 1000 frames spread over the run": (
        "u = run.universe(); [u.trajectory[i] for i in range(0, len(u.trajectory), "
        "max(1, len(u.trajectory) // 1000))]"
    ),
    "picture (`raceway plot`)": (
        "from raceway.pictures.overview import overview; overview(run.tables, sys.argv[1] +"
        " '/overview.png')"
    ),
}


def simulate(folder, size):
    """Make the run unless it is there; its length is judged from a short one."""
    dump = folder / "contacts.dump"
    if not (dump.exists() and dump.stat().st_size >= size):
        bytes_per_pass = None
        for passes in (4, None):
            passes = passes or int(1.01 * size / bytes_per_pass) + 1
            print(f"simulating {passes} ball passes", flush=True)
            done = subprocess.run(
                [
                    ROOT / "build" / "liggghts",
                    "-in",
                    "inputs/in.6208",
                    "-log",
                    "none",
                    "-var",
                    "dumps",
                    "yes",
                    "-var",
                    "record",
                    "none",
                    "-var",
                    "passes",
                    str(passes),
                    "-var",
                    "out",
                    folder,
                ],
                cwd=ROOT,
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
            )
            if done.returncode:
                sys.exit(f"the deck failed:\n{done.stdout[-2000:]}")
            bytes_per_pass = dump.stat().st_size / passes


def measure(folder, task, middle):
    """(seconds, largest resident memory in MB) of a task."""
    code = (
        "import sys, warnings; warnings.simplefilter('ignore'); import raceway; run ="
        " raceway.open(sys.argv[1])\n"
        + task.replace("MIDDLE", str(middle))
        + "\nprint(next(line.split()[1] for line in open('/proc/self/status') if"
        " line.startswith('VmHWM')))"
    )
    start = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-c", code, folder], capture_output=True, text=True, check=False
    )
    seconds = time.perf_counter() - start
    if done.returncode:
        sys.exit(f"{task} failed:\n{done.stderr[-2000:]}")
    return seconds, float(done.stdout.splitlines()[-1]) / 1024


def main():
    """Simulate, measure, print, write."""
    gigabytes = float(sys.argv[1]) if len(sys.argv) > 1 else 2.0
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else ROOT / "build" / "run" / "large").resolve()
    simulate(folder, gigabytes * 1e9)
    size = {
        name: (folder / name).stat().st_size / 1e9
        for name in ("contacts.dump", "balls.dump", "rings.dat")
    }
    passes = int(
        float(
            next(
                line.split()[1]
                for line in (folder / "run.yaml").open()
                if line.startswith("passes:")
            )
        )
    )
    rows = []
    for name, task in TASKS.items():
        rows.append((name, *measure(folder, task, passes * 100)))
        print(f"{name:<52}{rows[-1][1]:8.1f} s{rows[-1][2]:8.0f} MB", flush=True)
    lines = [
        ".. written by make bench (tests/bench/big_dump.py); do not edit",
        "",
        "Large runs",
        "==========",
        "",
        f"Measured on {date.today()}: {passes} ball passes of the main deck, {passes * 200}"
        " samples; "
        + ", ".join(f"``{name}`` {value:.2f} GB" for name, value in size.items())
        + ".",
        "",
    ]
    lines += [f"- {fact}" for fact in machine()]
    lines += [
        "",
        *"""\
Each task runs in a process of its own. Files are in the page cache or not, as it happens. Memory
is the largest resident size of the process.
""".splitlines(),
        "",
        ".. list-table::",
        "   :header-rows: 1",
        "   :widths: 60 20 20",
        "",
        "   * - task",
        "     - seconds",
        "     - memory (MB)",
    ]
    for name, seconds, memory in rows:
        lines += [
            f"   * - {name.replace('`', '``')}",
            f"     - {seconds:.1f}",
            f"     - {memory:.0f}",
        ]
    text = "\n".join([*lines, ""])
    (ROOT / "docs" / "performance" / "large_runs.rst").write_text(text)
    worst = max(memory for _, _, memory in rows)
    print(f"largest memory {worst:.0f} MB, limit {LIMIT} MB")
    return int(worst >= LIMIT)


if __name__ == "__main__":
    sys.exit(main())
