# SPDX-License-Identifier: GPL-2.0-or-later
"""Start a host as a process, follow its log, stop it, and determine why it ended."""

import os
import select
import signal
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path

from raceway.sweeps import run_server

PATIENCE = 20.0  # s, time given to a stopped run to write its restart file
GLANCE = 0.2  # s, time between two checks of a log
STOP_SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1, signal.SIGKILL, signal.SIGHUP)


def execute(
    words: Sequence[str],
    log: Path,
    *,
    stop: int | None = None,
    keep: Sequence[int] = (),
    watch: Callable[[], object] | None = None,
    served: bool = False,
) -> int | None:
    """Run the command `words`, write its output to the file `log`, and return its exit code.

    The run ends early if the file descriptor `stop` becomes readable, in which case None is
    returned, or if an exception is raised in this process (Ctrl-C). In both cases the program
    receives SIGTERM and has time to write its restart file. It inherits the descriptors `keep`;
    `watch` is called a few times per second. If the run is to be `served`, this process keeps a
    server of the program, if it has one, until it ends (`run_server`).
    """
    with open(log, "wb") as output:
        process, done = _start(words, output, keep, served)
    try:
        ends, pause = [done, *([] if stop is None else [stop])], GLANCE if watch else None
        while not (ready := select.select(ends, [], [], pause)[0]):
            watch()
        if done not in ready:
            _end(process, done)
            return None
        code = process.wait()
        if watch:
            watch()
        return code
    except BaseException:
        _end(process, done)
        raise
    finally:
        os.close(done)


def _start(words, output, keep, served):
    """Return a process and a descriptor that is readable when it has ended."""
    if served and (server := run_server.shared(words[0])):
        try:
            process = server.start(words, output, keep)
            return process, os.dup(process.done.fileno())
        except OSError:  # the server was killed
            server.close()
    # The program has its own session, because Ctrl-C would otherwise end it before it can be
    # stopped.
    process = subprocess.Popen(
        words,
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=subprocess.STDOUT,
        pass_fds=keep,
        start_new_session=True,
    )
    return process, os.pidfd_open(process.pid)


def _end(process, done):
    process.terminate()
    if not select.select([done], [], [], PATIENCE)[0]:
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def stopped(code: int | None) -> bool:
    """Return True if a run was stopped, so that it can be resumed.

    `code` is then None, as returned by `execute`, or the exit code of a stop signal.
    """
    return code is None or -code in STOP_SIGNALS or code - 128 in STOP_SIGNALS


def complaint(log: Path, code: int) -> str:
    """Return the error message of the host without the position in its source code, or the exit
    status if there is no error message."""
    lines = log.read_text(errors="replace").splitlines()
    for line in lines:
        if line.startswith("ERROR"):
            return line.partition(": ")[2].rsplit(" (", 1)[0].strip() or line
    words = (line.strip() for line in reversed(lines) if line.strip(" -=*"))  # skip separator lines
    last = next(words, "nothing printed")
    how = f"killed by signal {signal.Signals(-code).name}" if code < 0 else f"exit code {code}"
    return f"{how}; last line: {last[:200]}"
