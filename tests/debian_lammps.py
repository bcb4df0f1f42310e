# SPDX-License-Identifier: GPL-2.0-or-later
"""Build LAMMPS for the tests from Debian's source tarball, with Open MPI:

    python3 tests/debian_lammps.py

builds build/own/lammps/src/lmp_mpi, a shared library with the package PLUGIN, and
build/own/package/src/lmp_raceway, which contains Raceway as a package. Files that already exist are
neither fetched nor rebuilt. The first build of each program takes about 10 minutes.
"""

import json
import sys

from debian_tree import ROOT, run, source_tree, unpacked

OWN = ROOT / "build" / "own"
INSTALLER = ROOT / "src-package" / "host" / "lammps_tree.py"
# these flags compile faster than those of the hosts
FLAGS = "-O1 -w -fno-math-errno -fno-trapping-math -ffp-contract=off"
COMPILER = ("CC=mpicxx.openmpi", "LINK=mpicxx.openmpi", "LINKFLAGS=")


def with_plugins():
    src = unpacked(OWN / "lammps", "lammps") / "src"
    run("make", "yes-plugin", cwd=src)
    run(
        *("make", "-j2", "mode=shared", "mpi", *COMPILER, f"CCFLAGS={FLAGS} -std=c++11"),
        cwd=src,
    )


def with_package():
    tree = unpacked(OWN / "package", "lammps")
    manifest = tree / source_tree.MANIFEST
    if manifest.exists():
        was = json.loads(manifest.read_text())["added"]
        now = {f"src/RACEWAY/{name}": text for name, text in source_tree.flat_sources().items()}
        if any(was.get(name) != source_tree.digest(text) for name, text in now.items()):
            run("make", "no-raceway", cwd=tree / "src")
            run(sys.executable, INSTALLER, "uninstall", tree)
    if not manifest.exists():
        run(sys.executable, INSTALLER, "install", tree)
    run("make", "yes-raceway", cwd=tree / "src")
    run("make", "-j2", "raceway", *COMPILER, f"CCFLAGS={FLAGS} -std=c++17", cwd=tree / "src")


if __name__ == "__main__":
    with_plugins()
    with_package()
