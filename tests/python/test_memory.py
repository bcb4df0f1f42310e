# SPDX-License-Identifier: GPL-2.0-or-later
"""Readers with constant memory need no more memory for a long run than for a short one. Each task
reads a run, and then a run that is nine times as long.

tests/bench/large_runs.py tests this with 2 GB.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import raceway
import synthetic

SHORT, LONG = 20, 180  # repetitions of the 49 samples of the synthetic run
# bytes read at once, reduced like the runs, so that even the short run has several blocks
BLOCK = 1 << 18
TASKS = """
from raceway import electrical, losses, regimes, spectrum
raceway.open(folder).summary()
regimes.shares(raceway.open(folder))
electrical.by_raceway(raceway.open(folder))
losses.losses_around(raceway.open(folder))
losses.losses(raceway.open(folder))
run = raceway.open(folder)
spectrum.lines(run, spectrum.of_run(run))
[block["load"].max() for block in run.blocks("contacts")]
[block["x"].max() for block in run.blocks("balls")]
part = raceway.open(folder, slice(900, 920))
part.contacts, part.balls, part.cage, part.rings
u = run.universe()
[u.trajectory[i] for i in range(0, len(u.trajectory), 50)]
"""
WHOLE = "raceway.open(folder).contacts.load()"  # this task needs more memory for a longer run


@pytest.fixture(scope="module")
def folders(tmp_path_factory, lubricated):
    """Write the run with its samples repeated, and return {repetitions: folder}."""
    made = {}
    for times in (SHORT, LONG):
        rings = np.tile(np.array(lubricated["rings"], dtype=float), (times, 1))
        rings[:, 0] = 100 * np.arange(len(rings))
        rings[:, 1] = np.arange(len(rings)) * lubricated["settings"]["sample_s"]
        data = synthetic.changed({**lubricated, "rings": rings}, passes=(len(rings) - 1) / 24)
        made[times] = synthetic.write(tmp_path_factory.mktemp("long") / str(times), data)
    return made


def peak(folder, task):
    """Return the largest resident memory, in MB, of a process that runs `task`."""
    # VmHWM is used because a process inherits ru_maxrss from its parent
    code = (
        f"import sys, raceway, raceway.runs.record; raceway.runs.record.BLOCK = {BLOCK}; folder ="
        f" sys.argv[1]\n{task}\nprint(next(line.split()[1] for line in open('/proc/self/status') if"
        " line.startswith('VmHWM')))"
    )
    environment = {
        "PYTHONPATH": str(Path(raceway.__file__).parents[1]),
        "PYTHONDONTWRITEBYTECODE": "1",
        "OPENBLAS_NUM_THREADS": "1",
    }
    done = subprocess.run(
        [sys.executable, "-c", code, str(folder)],
        env=environment,
        text=True,
        timeout=300,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return float(done.stdout.splitlines()[-1]) / 1024


def growth(folders, task):
    """Return the additional memory in MB that the long run needs, divided by the additional size of
    its record in MB."""
    sizes = [(folders[times] / "record.nc").stat().st_size / 2**20 for times in (SHORT, LONG)]
    return (peak(folders[LONG], task) - peak(folders[SHORT], task)) / (sizes[1] - sizes[0])


def test_bounded(folders):
    """For totals, ring and spectrum, one row per sample is kept in memory, which is up to 1 KB of
    4.6 KB."""
    assert growth(folders, TASKS) < 0.3


def test_whole_run_is_not(folders):
    """The test detects growth for a task that reads the whole run into memory."""
    assert growth(folders, WHOLE) > 0.5
