# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a command of `raceway` in a forked child process, which avoids starting Python for each
command and protects the fuzzer from crashes."""

import os
import pkgutil
import resource
import signal
import sys
import time
import traceback
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from fuzz.lab import Finding
from raceway import cli, data, electric, export, runs, theory

# import the modules once here, and not in every child
for package in (data, electric, export, runs, theory):
    for module in pkgutil.iter_modules(package.__path__, f"{package.__name__}."):
        import_module(module.name)

# the limit refers to processor time, which does not depend on other work on the machine; the limit
# of the wall time is much longer
SECONDS, WALL_S, BYTES = 20, 600, 6 * 2**30


@dataclass
class End:
    code: int
    out: str
    error: str


def raceway(words, folder):
    """Run `raceway WORDS` in `folder`. A traceback, a signal or a hang is a finding."""
    pid = os.fork()
    if pid == 0:
        _inside(words, folder)
    limit = time.monotonic() + WALL_S
    while (done := os.waitpid(pid, os.WNOHANG))[0] == 0:
        if time.monotonic() > limit:
            os.kill(pid, signal.SIGKILL)
            os.waitpid(pid, 0)
            raise Finding(f"hang: {_line(words)} takes more than {WALL_S} s")
        time.sleep(0.002)
    out, error = (Path(folder, name).read_text(errors="replace") for name in ("stdout", "stderr"))
    end = End(os.waitstatus_to_exitcode(done[1]), out, error)
    if "Traceback" in error or end.code not in (0, 1, 2):
        raise Finding(f"exit code {end.code}: {_line(words)}: {error.strip()[-400:]}")
    if end.code and not error.strip():
        raise Finding(f"no message: {_line(words)}")
    return end


def _line(words):
    return "raceway " + " ".join(repr(word) if " " in word or not word else word for word in words)


def _inside(words, folder):
    code = 70
    try:
        os.chdir(folder)
        resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        used = sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
        resource.setrlimit(resource.RLIMIT_CPU, (int(used) + SECONDS,) * 2)
        for number, name in ((1, "stdout"), (2, "stderr")):
            os.dup2(os.open(name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), number)
            setattr(sys, name, open(number, "w", encoding="utf-8", closefd=False))
        code = cli.main(words)
        sys.stdout.flush()
    except SystemExit as error:
        code = error.code if isinstance(error.code, int) else 1
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code or 0)
