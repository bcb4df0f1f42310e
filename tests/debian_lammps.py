# SPDX-License-Identifier: GPL-2.0-or-later
"""A LAMMPS of one's own for the tests: Debian's tarball of the sources, built with PLUGIN and Open
MPI as a shared library: build/own/lammps/src/lmp_mpi.

    python3 tests/debian_lammps.py

What is there already is neither fetched nor built again (first build: about 10 minutes).
"""

from debian_tree import ROOT, run, unpacked

TREE = ROOT / "build" / "own" / "lammps"
FLAGS = "-O1 -std=c++11 -w"


def main():
    src = unpacked(TREE, "lammps") / "src"
    run("make", "yes-plugin", cwd=src)
    run(
        *("make", "-j2", "mode=shared", "mpi", "CC=mpicxx.openmpi", "LINK=mpicxx.openmpi"),
        *(f"CCFLAGS={FLAGS}", "LINKFLAGS="),
        cwd=src,
    )


if __name__ == "__main__":
    main()
