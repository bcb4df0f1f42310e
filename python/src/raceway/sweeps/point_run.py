# SPDX-License-Identifier: GPL-2.0-or-later
"""Execution of one point of a sweep: its folder, lock, run and outcome.

The folder contains the output of the deck, `log.txt`, and

    point.yaml     the variables, written before the run
    summary.json   the results, written last, which means that the point is finished
    failed.json    the message of a run that stopped with an error

Each file is first written under another name and then renamed, so it is never incomplete. A loss
of power may leave it empty, as if it were missing; waiting for the disk would take a tenth of the
time of a short run.
"""

import fcntl
import json
import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any

from raceway import files, yaml_file
from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.sweeps.host_run import complaint, execute, stopped
from raceway.sweeps.points import deck_variables

FINISHED, FAILED, PENDING, BUSY, STOPPED = "finished", "failed", "pending", "busy", "stopped"
# {variable of the deck: its name in `run.yaml`}
RECORDED = {
    "load": "load_N",
    "rpm": "rpm",
    "clearance": "clearance_m",
    "passes": "passes",
    "samples": "samples_per_pass",
    "bearing": "bearing",
    "lubricant": "lubricant",
    "integrator": "integrator",
    "models": "models",
}


def state(folder: FilePath, variables: Mapping[str, str]) -> tuple[str, str]:
    """Return (status, message) of the point in `folder`.

    It is finished only if its results belong to these `variables`.
    """
    folder = Path(folder)
    if mapping(folder / "point.yaml", yaml_file.parse) != dict(variables):
        return PENDING, ""
    return outcome(folder)[:2]


def outcome(folder: Path) -> tuple[str, str, dict[str, Any]]:
    """Return (status, message, results) for the variables in the `point.yaml` of the folder."""
    if figures := mapping(folder / "summary.json", json.loads):
        return FINISHED, "", figures
    failed = mapping(folder / "failed.json", json.loads) or {}
    return (FAILED, failed["message"], {}) if "message" in failed else (PENDING, "", {})


def run_point(
    folder: FilePath,
    variables: Mapping[str, str],
    command: Sequence[str],
    *,
    retry: bool = False,
    stop: int | None = None,
) -> tuple[str, str]:
    """Run one point and return (status, message).

    A finished point is not run again, nor is a failed one without `retry`. `command` is a list of
    the program, its options and finally the deck; `stop` is a file descriptor that ends the run
    when it becomes readable. The status is `BUSY` if another process is working on the point, which
    may be a run left over from a killed sweep.
    """
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with _locked(folder) as lock:
            if lock is None:
                return BUSY, "another process is running it"
            status, message = state(folder, variables)
            if status == FINISHED or status == FAILED and not retry:
                return status, message
            known = mapping(folder / "point.yaml", yaml_file.parse)
            if known != dict(variables):
                for old in ("summary.json", "failed.json", "run.yaml", "record.nc", "restart"):
                    (folder / old).unlink(missing_ok=True)
                _write(folder / "point.yaml", yaml_file.dump(variables))
            (folder / "failed.json").unlink(missing_ok=True)
            if not _whole(folder, variables):
                code = _execute(folder, variables, command, lock, stop)
                if stopped(code):
                    return STOPPED, "stopped; it continues when the sweep is started again"
                if code:
                    return _fail(folder, complaint(folder / "log.txt", code))
            try:
                run = RunTables(folder)
                figures = _figures(run)
            except RacewayError as error:
                return _fail(folder, str(error))
            if wrong := _differs(run.settings, variables):
                return _fail(folder, f"the settings of the run differ from the request: {wrong}")
            _write(
                folder / "summary.json",
                json.dumps(figures, indent=2, ensure_ascii=False, allow_nan=False),
            )
            return FINISHED, ""
    except OSError as error:
        return FAILED, f"{error.filename or folder}: {error.strerror}"


@contextmanager
def _locked(folder):
    """Yield a descriptor that holds the lock of the folder, or None if another process holds it.

    The run inherits the descriptor, so the lock lasts as long as any process writes to the folder.
    """
    lock = os.open(folder / ".lock", os.O_RDWR | os.O_CREAT, 0o666)
    try:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            yield None
        else:
            yield lock
    finally:
        os.close(lock)


def _execute(folder, variables, command, lock, stop):
    """Execute the run and return its exit code, or None if `stop` became readable."""
    resume = {"resume": "yes"} if _resumes(command[-1], files.version(command[-1])) else {}
    given = {"out": str(folder), **resume, **variables}
    words = [*command, "-log", "none"]
    for name, value in given.items():
        words += ["-var", name, value]
    return execute(words, folder / "log.txt", stop=stop, keep=(lock,), served=True)


@lru_cache(maxsize=1)
def _resumes(deck, version):
    """Return True if the deck has the variable `resume`; other decks restart a stopped point."""
    return "resume" in deck_variables(deck)


def _figures(run):
    """Return the summary of a run.

    For a run with several bearings, the entry `bearings` is a list of their summaries.
    """
    numbers = run.record.bearings
    if len(numbers) == 1:
        return summary(run)
    return {"bearings": [summary(RunTables(run.folder, bearing=one)) for one in numbers]}


def _whole(folder, variables):
    """Return True if an earlier run with these variables finished and only its summary is
    missing."""
    try:
        run = RunTables(folder)
    except RacewayError:
        return False
    return run.finished and not _differs(run.settings, variables)


def _differs(settings, variables):
    for name, key in RECORDED.items():
        if name == "clearance" and settings.get("contact_angle_deg"):
            continue  # the clearance follows from the contact angle
        if name in variables and key in settings and not _same(variables[name], settings[key]):
            return f"{key} is {settings[key]}, but {name} was {variables[name]}"
    return ""


def _same(asked, found):
    try:
        return float(asked) == float(found)
    except ValueError:
        return asked == found


def _fail(folder, message):
    _write(folder / "failed.json", json.dumps({"message": message}, ensure_ascii=False))
    return FAILED, message


def mapping(path: Path, parse: Callable[[str], Any]) -> dict[str, Any] | None:
    """Return the dict in the file `path`, or None if the file is missing, incomplete or does not
    contain a mapping with names as keys."""
    try:
        found = parse(path.read_text())
    except (OSError, ValueError, RecursionError):
        return None
    good = isinstance(found, dict) and all(isinstance(name, str) for name in found)
    return found if good else None


def _write(path, text):
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    os.replace(part, path)
