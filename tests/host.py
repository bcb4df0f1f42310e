# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs decks in the host that `make build` made, from the root of the repository."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# A box for one 6208 around the origin, four atom types, nothing in it.
BOX = """
units si
include inputs/modules/host.liggghts
atom_modify map array sort 0 0.0
boundary f f f
newton off
region box block -0.06 0.06 -0.06 0.06 -0.06 0.06 units box
create_box 4 box
neighbor 2.0e-3 bin
neigh_modify delay 0 every 20 check yes
"""


@dataclass
class Outcome:
    """What a run left: exit code and everything it printed."""

    code: int
    text: str

    @property
    def error(self):
        """The host's error lines, or nothing."""
        return "\n".join(line for line in self.text.splitlines() if "ERROR" in line)


def liggghts(deck, *, ranks=1, sanitized=False, program=None, extra=(), timeout=300, cwd=ROOT, **variables):
    """Run `deck` (path from the root) with `-var` for every keyword; return its `Outcome`.

    With `sanitized` the build with AddressSanitizer and UndefinedBehaviorSanitizer runs it; leaks are not looked
    for, since host and MPI keep memory until the end on purpose. `program` is another executable with the styles.
    """
    program = program or ROOT / "build" / ("sanitized/liggghts" if sanitized else "liggghts")
    assert program.exists(), f"{program.relative_to(ROOT)} is missing: run `make test`, which builds it"
    command = [str(program), "-in", str(deck), "-log", "none", *extra]
    for name, value in variables.items():
        command += ["-var", name, *(map(str, value) if isinstance(value, (list, tuple)) else [str(value)])]
    if ranks > 1:
        command = ["mpirun.openmpi", "--oversubscribe", "-np", str(ranks), *command]
    # errors="replace": one in five LIGGGHTS errors ends with a "tip of the day" read from freed memory
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_btl_base_warn_component_unused="0",
                       ASAN_OPTIONS="detect_leaks=0", UBSAN_OPTIONS="print_stacktrace=1")
    done = subprocess.run(command, cwd=cwd, env=environment, text=True, errors="replace", timeout=timeout, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return Outcome(done.returncode, done.stdout)


def succeed(deck, **kwargs):
    """`liggghts`, and it must end well."""
    outcome = liggghts(deck, **kwargs)
    assert outcome.code == 0, outcome.text[-3000:]
    return outcome


def frames(path):
    """A dump as {step: sorted rows of text}: the order of rows may depend on ranks, their bits must not."""
    lines = Path(path).read_text().splitlines()
    result, at = {}, 0
    while at < len(lines):
        step, count = int(lines[at + 1]), int(lines[at + 3])
        result[step] = sorted(lines[at + 9:at + 9 + count])
        at += 9 + count
    return result
