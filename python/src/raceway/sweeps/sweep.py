# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the points of a sweep on the cores of one machine."""

import os
import select
import signal
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from pathlib import Path

from tqdm import tqdm

from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.sweeps.gather import write_results
from raceway.sweeps.point_run import FAILED, FINISHED, run_point, state
from raceway.sweeps.points import Point


def sweep(
    points: Sequence[Point],
    folder: FilePath,
    command: Sequence[str],
    *,
    jobs: int = 1,
    retry: bool = False,
    finished: Callable[[Point], object] | None = None,
) -> tuple[dict[str, int], int, Path]:
    """Run `points` (from `read_points`) in `folder`, with `jobs` of them at the same time.

    Return ({status: number of points}, number of points that were finished before, path of the
    table). `command` is a list of program, options and deck. A bar shows the progress on a
    terminal. On KeyboardInterrupt or SystemExit, runs are stopped (and leave a restart file), the
    table is written, and the exception is raised again. `finished` is called in this process with
    each point as it finishes. Raise `RacewayError` if a worker is killed.
    """
    folder, counts, todo = Path(folder), Counter(), []
    for point in points:
        status, _ = state(folder / point.name, point.variables)
        if status == FINISHED or status == FAILED and not retry:
            counts[status] += 1
        else:
            todo.append(point)
    before = counts[FINISHED]
    # Only this process has the end `writing` of the pipe open, so the workers are notified if this
    # process ends for any reason.
    reading, writing = os.pipe()
    pool = ProcessPoolExecutor(
        min(jobs, len(todo)) or 1, get_context("fork"), _Worker.begin, (reading, writing)
    )
    try:
        futures = {
            pool.submit(_Worker.work, folder / point.name, point.variables, command, retry): point
            for point in todo
        }
        with tqdm(
            total=len(points),
            initial=len(points) - len(todo),
            unit="point",
            disable=None,
            smoothing=0.0,
        ) as bar:
            for future in as_completed(futures):
                status, message = future.result()
                counts[status] += 1
                if status == FINISHED and finished:
                    finished(futures[future])
                bar.update()
                if status == FAILED:
                    bar.write(f"{futures[future].name}: {message}", file=sys.stderr)
    except BrokenProcessPool:
        raise RacewayError(
            "a worker of the sweep was killed (out of memory?); start the sweep again to continue"
        ) from None
    finally:
        os.close(writing)
        pool.shutdown(cancel_futures=True)
        os.close(reading)
        if any(folder.glob("*/point.yaml")):
            write_results(folder)
    return (
        {status: number for status, number in counts.items() if number},
        before,
        folder / "results.csv",
    )


class _Worker:
    """A worker process of the pool."""

    stop = None  # descriptor that becomes readable if the sweep ends early, even if it is killed
    parent = None
    busy = threading.Lock()

    @classmethod
    def begin(cls, reading, writing):
        for number in (
            signal.SIGINT,
            signal.SIGTERM,
            signal.SIGHUP,
        ):  # signals reach the whole process group; only the sweep handles them
            signal.signal(number, lambda *_: None)  # not SIG_IGN, which the runs would inherit
        os.close(writing)
        cls.stop, cls.parent = reading, os.getppid()
        threading.Thread(target=cls.leave_with_parent, daemon=True).start()

    @classmethod
    def leave_with_parent(cls):
        """End a worker whose sweep was killed, because it would otherwise wait for work forever."""
        select.select([cls.stop], [], [])
        while os.getppid() == cls.parent:
            time.sleep(0.2)
        with cls.busy:
            os._exit(1)

    @classmethod
    def work(cls, folder, variables, command, retry):
        with cls.busy:
            return run_point(folder, variables, command, retry=retry, stop=cls.stop)
