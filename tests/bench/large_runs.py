# SPDX-License-Identifier: GPL-2.0-or-later
"""Read a run whose record is larger than the memory that reading it should require. The script
simulates a 6208 until its record has 2 GB, reads the record in every way that the package offers,
and writes the times and the memory to build/bench/large_runs.rst.

    .venv/bin/python tests/bench/large_runs.py [GIGABYTES [FOLDER]]

If FOLDER (default: build/run/large) contains a large enough run, that run is used; otherwise a new
run is made there and kept. The exit code is 1 if anything fails, requires 1 GB of memory, or takes
longer than LONGEST.
"""

import subprocess
import sys
import time
from pathlib import Path

from deck_runs import MAIN, ROOT, run_deck
from machine import csv_table, publish, words_asked

LIMIT = 1000  # MB
PAGE = """\
{passes} ball passes of the main deck with {samples} samples; the size of ``record.nc`` is
{size:.2f} GB.

Each task runs in a separate process. The seconds do not include the time to load the package, which
is given in the first row. Files may or may not be in the page cache. Memory is the largest resident
size of the process.

{table}

{machine}
"""
FIGURES, LARGEST = "all figures (`raceway summary`)", "largest load of each ball"
LONGEST = {FIGURES: 3.0, LARGEST: 1.0}  # s
TASKS = {  # {name: statements with `run`, executed in a separate process}
    "load the package only": "",
    FIGURES: "run.summary()",
    "bearing totals, every sample": "run.bearing",
    "film regimes around the ring": "from raceway.runs.regimes import shares; shares(run)",
    "pressure and permittivity around the ring": (
        "from raceway.runs.electrical import by_raceway; by_raceway(run)"
    ),
    "losses, every sample": "from raceway.runs.losses import losses; losses(run)",
    "spectrum of the ring, lines found": (
        "from raceway.runs.spectrum import lines, of_run; lines(run, of_run(run))"
    ),
    LARGEST: "run.contacts.Q.max('time').values",
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


def write(folder, passes):
    """Run the main deck for a number of ball passes, with its record in `folder`."""
    print(f"simulating {passes} ball passes into {folder}", flush=True)
    run_deck(MAIN, passes=passes, out=folder, overwrite="yes")


def passes_of(folder):
    """Return the number of ball passes of a finished run, or 0 if there is none."""
    if not (folder / "run.yaml").exists():
        return 0
    said = dict(line.split(": ", 1) for line in (folder / "run.yaml").open() if ": " in line)
    return int(float(said["passes"])) if "wall_s" in said else 0


def simulate(folder, size):
    """Return the number of ball passes of the run in `folder`. If the run is missing or too small,
    make one whose length is estimated from a short run."""
    record = folder / "record.nc"
    if not (passes_of(folder) and record.stat().st_size >= size):
        write(folder, 4)
        write(folder, int(1.01 * size * 4 / record.stat().st_size) + 1)
    return passes_of(folder)


def measure(folder, task, middle):
    """Return (seconds, excluding the import of the package; largest resident memory in MB) for a
    task."""
    code = (
        "import sys, time, warnings; warnings.simplefilter('ignore'); import raceway\n"
        "raceway.open(sys.argv[1], slice(0, 1))  # loads all modules, but almost no data\n"
        "begun = time.perf_counter(); run = raceway.open(sys.argv[1])\n"
        + task.replace("MIDDLE", str(middle))
        + "\nprint(time.perf_counter() - begun, next(line.split()[1] for line in"
        " open('/proc/self/status') if line.startswith('VmHWM')))"
    )
    start = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-c", code, folder], capture_output=True, text=True, check=False
    )
    whole = time.perf_counter() - start
    if done.returncode:
        sys.exit(f"{task} failed:\n{done.stderr[-2000:]}")
    seconds, memory = map(float, done.stdout.splitlines()[-1].split())
    return seconds if task else whole, memory / 1024


def main():
    """Simulate, measure, print the results and write the page."""
    words = words_asked()
    gigabytes = float(words[0]) if words else 2.0
    folder = Path(words[1] if len(words) > 1 else ROOT / "build/run/large").resolve()
    passes = simulate(folder, gigabytes * 1e9)
    size = (folder / "record.nc").stat().st_size / 1e9
    rows = []
    for name, task in TASKS.items():
        rows.append((name, *measure(folder, task, passes * 100)))
        print("{:<52}{:8.1f} s{:8.0f} MB".format(*rows[-1]), flush=True)
    table = csv_table(
        ("task", "seconds", "memory (MB)"),
        [(name.replace("`", "``"), f"{s:.2g}", f"{memory:.0f}") for name, s, memory in rows],
    )
    publish("Large runs", PAGE, passes=passes, samples=passes * 200, size=size, table=table)
    worst = max(memory for *_, memory in rows)
    print(f"largest memory {worst:.0f} MB, limit {LIMIT} MB")
    slow = [name for name, seconds, _ in rows if seconds > LONGEST.get(name, 1e9)]
    print("above the time limit:", ", ".join(slow) or "nothing")
    return int(worst >= LIMIT or bool(slow))


if __name__ == "__main__":
    sys.exit(main())
