# SPDX-License-Identifier: GPL-2.0-or-later
"""Run `raceway` commands and Python blocks in forks of a process that has already imported numpy,
scipy, pandas, xarray and matplotlib. A new Python process needs one to two seconds for these
imports, which is longer than most examples take."""

import multiprocessing
import os
import re
import shlex
import sys
import tempfile
import traceback
import warnings
from pathlib import Path

PRELOAD = (
    *("raceway.cli", "scipy.io", "scipy.optimize", "scipy.signal", "scipy.special", "scipy.stats"),
    *("pandas", "xarray", "matplotlib.pyplot"),
)
# commands that need a shell, and those that change the shell for subsequent commands
SHELL = re.compile(r"[|&;<>$*?`()#\\]|^(cd|export) ", re.MULTILINE)
CONTEXT = multiprocessing.get_context("forkserver")
CONTEXT.set_forkserver_preload(list(PRELOAD))


def split(commands: str) -> list[str]:
    """Return a list of single commands, or of the whole text if it requires a shell."""
    if SHELL.search(commands):
        return [commands]
    return [line for line in commands.splitlines() if line.strip()]


def words(command: str) -> list[str] | None:
    """Return the words of a plain `raceway` command, or None for any other command."""
    if SHELL.search(command) or Path(command.split()[0]).name != "raceway":
        return None
    return shlex.split(command)


def run(task: str | list[str], folder: Path, environment: dict[str, str]) -> tuple[int, str]:
    """Run a Python block (given as a string) or the words of a `raceway` command (given as a list)
    in `folder`, and return (exit code, output)."""
    with tempfile.NamedTemporaryFile("r", errors="replace") as output:
        child = CONTEXT.Process(target=_child, args=(task, folder, environment, output.name))
        child.start()
        child.join()
        return child.exitcode, output.read()


def _child(task, folder, environment, output):
    to = os.open(output, os.O_WRONLY | os.O_APPEND)
    os.dup2(to, 1)
    os.dup2(to, 2)
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(environment)
    try:
        sys.exit(_command(task) if isinstance(task, list) else _block(task))
    except Exception:
        traceback.print_exc()
        sys.exit(1)
    finally:
        sys.stdout.flush()


def _command(task):
    from raceway import cli

    sys.argv = task
    return cli.main()


def _block(task):
    warnings.simplefilter("error")
    sys.argv, sys.path[0] = ["-c"], ""
    exec(compile(task, "<block>", "exec"), {"__name__": "__main__"})
    return 0
