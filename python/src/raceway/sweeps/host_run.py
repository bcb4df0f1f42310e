# SPDX-License-Identifier: GPL-2.0-or-later
"""One process of a host: start it, follow its log, stop it, and determine why it ended."""

import os
import select
import signal
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path

PATIENCE = 20.0  # s for a stopped run to write its restart file
GLANCE = 0.2  # s between two checks of a log
STOP_SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1, signal.SIGKILL, signal.SIGHUP)


def execute(
    words: Sequence[str],
    log: Path,
    *,
    stop: int | None = None,
    keep: Sequence[int] = (),
    watch: Callable[[], object] | None = None,
) -> int | None:
    """Run the program `words` with its output in the file `log`; return its exit code.

    The run ends early, with None, when the file descriptor `stop` becomes readable, or with the
    exception if one is raised here (Ctrl-C). In both cases the program gets SIGTERM and time to
    write its restart file. It inherits the descriptors `keep`; `watch` is called a few times per
    second.
    """
    with open(log, "wb") as output:
        # a session of its own, otherwise Ctrl-C would end the program before it can be stopped
        process = subprocess.Popen(
            words,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            pass_fds=keep,
            start_new_session=True,
        )
    done = os.pidfd_open(process.pid)
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


def _end(process, done):
    process.terminate()
    if not select.select([done], [], [], PATIENCE)[0]:
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def stopped(code: int | None) -> bool:
    """True if a run ended with the exit `code` of a stop signal, or with None from `execute`, so
    that it can be resumed."""
    return code is None or -code in STOP_SIGNALS or code - 128 in STOP_SIGNALS


def complaint(log: Path, code: int) -> str:
    """Error line of the host, without the position in its source; if there is none, its exit
    status."""
    lines = log.read_text(errors="replace").splitlines()
    for line in lines:
        if line.startswith("ERROR"):
            return line.partition(": ")[2].rsplit(" (", 1)[0].strip() or line
    words = (line.strip() for line in reversed(lines) if line.strip(" -=*"))  # without rulers
    last = next(words, "nothing printed")
    how = f"killed by signal {signal.Signals(-code).name}" if code < 0 else f"exit code {code}"
    return f"{how}; last line: {last[:200]}"
