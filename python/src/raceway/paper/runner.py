# SPDX-License-Identifier: GPL-2.0-or-later
"""Run cases in parallel and store their results, which depend on program, input files and
settings."""

import hashlib
import os
import shutil
import subprocess
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.paper.cases import Case

PROGRAM = Path("build/liggghts")
LIBRARY = Path("build/libraceway_liggghts.so")
LOG = "screen.txt"
TIMEOUT = 600  # s, although a case takes only about half a second


class CaseError(RacewayError):
    """Raised if a case did not finish."""


def root() -> Path:
    """Return the source tree that contains the current folder.

    Raise `RacewayError` if there is none or if it has not been built.
    """
    here = Path.cwd()
    for folder in (here, *here.parents):
        if (folder / "inputs/paper/cases.yaml").is_file():
            for part in (PROGRAM, LIBRARY):
                if not (folder / part).is_file():
                    raise RacewayError(f"{folder / part} is missing: run `make build` there")
            return folder
    raise RacewayError(
        f"no inputs/paper/cases.yaml in {here} or above: run this command in Raceway's source tree"
    )


@dataclass
class Outcome:
    """Outcome of the cases: the folders of finished runs and the messages of failed runs."""

    folders: dict[Case, Path]
    failures: dict[Case, str]


class Runner:
    """Runs the cases of one source tree.

    Results are stored in `store`, with one folder for each state of program and inputs.
    """

    def __init__(self, tree: Path, store: FilePath) -> None:
        self.tree, self.state = tree, _digest(tree)[:16]
        self.store = Path(store).resolve() / self.state

    def folder(self, case: Case) -> Path:
        """Return the folder with the results of a case, which exists once the run has finished."""
        key = hashlib.sha256(repr((case.deck, case.settings)).encode()).hexdigest()[:16]
        return self.store / f"{Path(case.deck).name[3:]}-{key}"

    def forget(self) -> None:
        """Remove the results of other states of program and inputs."""
        for old in self.store.parent.glob("[0-9a-f]" * 16):
            if old != self.store:
                shutil.rmtree(old, ignore_errors=True)

    def run(self, case: Case) -> Path:
        """Run one case unless its results exist, and return its folder.

        Raise `CaseError` if the run fails.
        """
        final = self.folder(case)
        if final.is_dir():
            return final
        part = final.with_name(f".{final.name}.{os.getpid()}.{threading.get_ident()}")
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir(parents=True)
        try:
            self._execute(case, part)
            try:
                part.rename(final)
            except OSError:  # another command has finished the same case earlier
                if not final.is_dir():
                    raise
        finally:
            shutil.rmtree(part, ignore_errors=True)
        return final

    def run_all(
        self,
        cases: Sequence[Case],
        jobs: int,
        progress: Callable[[int, Case, CaseError | None], object],
    ) -> Outcome:
        """Run `cases`, with `jobs` of them at the same time, and return an `Outcome`.

        Call `progress(done, case, error)` after each case.
        """
        outcome, lock = Outcome({}, {}), threading.Lock()

        def one(case):
            error = None
            try:
                folder = self.run(case)
            except CaseError as failure:
                error = str(failure)
            with lock:
                if error is None:
                    outcome.folders[case] = folder
                else:
                    outcome.failures[case] = error
                progress(len(outcome.folders) + len(outcome.failures), case, error)

        with ThreadPoolExecutor(jobs) as pool:
            try:
                list(pool.map(one, cases))
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
        return outcome

    def _execute(self, case, folder):
        command = [
            str(self.tree / PROGRAM),
            "-in",
            case.deck,
            "-log",
            "none",
            "-var",
            "out",
            str(folder),
            *("-var", "overwrite", "yes"),
        ]
        for name, value in case.settings:
            command += ["-var", name, value]
        environment = dict(
            os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1"
        )
        log = folder / LOG
        try:
            with log.open("w") as screen:
                code = subprocess.run(
                    command,
                    cwd=self.tree,
                    env=environment,
                    stdin=subprocess.DEVNULL,
                    stdout=screen,
                    stderr=subprocess.STDOUT,
                    timeout=TIMEOUT,
                    check=False,
                ).returncode
        except subprocess.TimeoutExpired:
            raise CaseError(f"stopped after {TIMEOUT} s") from None
        except OSError as error:
            raise CaseError(f"cannot start {command[0]}: {error.strerror or error}") from None
        if code:
            lines = log.read_text(errors="replace").splitlines()
            message = next(
                (line for line in lines if "ERROR" in line), lines[-1] if lines else "no message"
            )
            raise CaseError(f"exit code {code}: {message}")


def _digest(tree):
    """Return a digest that changes if the program, a deck or a data file changes, so that old
    results are not reused."""
    state = hashlib.sha256()
    decks = (
        path
        for path in sorted((tree / "inputs").rglob("*"))
        if path.is_file() and path.name != "cases.yaml"
    )
    for path in (tree / PROGRAM, tree / LIBRARY, *decks):
        state.update(str(path.relative_to(tree)).encode() + b"\0" + path.read_bytes())
    return state.hexdigest()
