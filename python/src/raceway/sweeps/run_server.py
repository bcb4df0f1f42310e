# SPDX-License-Identifier: GPL-2.0-or-later
"""Start runs of a program that is already loaded (`src-package/host/run_server.h`).

Starting the program and MPI takes longer than a short run. A server is a process of the program
that forks for each run, so every run is still a process of its own.
"""

import array
import os
import signal
import socket
import struct
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import BinaryIO

from raceway.sweeps.host_program import BUILT

ANSWER = struct.Struct("ii")  # process, exit code
PATIENCE = 10.0  # s, for a server to start


class RunServer:
    """A server of the program at the path `program`.

    It ends when this process ends. `closed` is True after `close`. Raise `OSError` if the program
    cannot be started or cannot serve.
    """

    def __init__(self, program: str) -> None:
        self.closed = False
        self._socket, other = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with other:
            self._process = subprocess.Popen(
                [program, "-serve"],
                stdin=other,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                start_new_session=True,
            )
        self._socket.settimeout(PATIENCE)
        try:
            if self._answer()[0] != self._process.pid:
                raise OSError(f"{program} cannot serve")
            self._socket.settimeout(None)
        except BaseException:
            self.close()
            raise

    def start(self, words: Sequence[str], output: BinaryIO, keep: Sequence[int]) -> "ServedRun":
        """Start a run with the command line `words`, which writes to `output` and inherits the
        descriptors `keep`."""
        descriptors = array.array("i", [output.fileno(), *keep])
        rights = [(socket.SOL_SOCKET, socket.SCM_RIGHTS, descriptors)]
        self._socket.sendmsg([b"\0".join(map(os.fsencode, words)) + b"\0"], rights)
        return ServedRun(self._answer()[0], self._socket, self._answer)

    def close(self) -> None:
        """End the server. A run that it has started continues."""
        self.closed = True
        self._socket.close()
        self._process.kill()
        self._process.wait()

    def _answer(self):
        """Return the next answer, or the process and exit code of a server that was killed."""
        said = self._socket.recv(ANSWER.size)
        return ANSWER.unpack(said) if len(said) == ANSWER.size else (-1, -signal.SIGKILL)


class ServedRun:
    """A run that was started by a server, with the methods of `subprocess.Popen` that are needed.

    `done` is readable when it has ended.
    """

    def __init__(
        self, pid: int, done: socket.socket, answer: Callable[[], tuple[int, int]]
    ) -> None:
        self.pid, self.done, self._answer = pid, done, answer

    def wait(self) -> int:
        """Return the exit code, which is negative for a signal."""
        return self._answer()[1]

    def terminate(self) -> None:
        """Send SIGTERM to the run, if it still exists."""
        try:
            os.kill(self.pid, signal.SIGTERM)
        except ProcessLookupError:
            pass


class _Kept:
    """The server of this process, or None if the program cannot serve, and what it was started
    for."""

    server: RunServer | None = None
    key: object = None


def shared(program: str) -> RunServer | None:
    """Return the server of this process for `program`, or None if that is not one of the programs
    of the source tree, or if it cannot serve, for example within a job of several ranks.

    It serves one run at a time. A run has the folder and the environment of its server, so another
    server is started if they have changed.
    """
    if Path(program).parts[-2:] not in {path.parts[-2:] for path in BUILT.values()}:
        return None
    key = (program, os.getcwd(), dict(os.environ))
    if key != _Kept.key or (_Kept.server and _Kept.server.closed):
        forget()
        try:
            _Kept.server = RunServer(program)
        except OSError:
            pass
        _Kept.key = key
    return _Kept.server


def forget() -> None:
    """End the server of this process."""
    if _Kept.server:
        _Kept.server.close()
    _Kept.server = _Kept.key = None
